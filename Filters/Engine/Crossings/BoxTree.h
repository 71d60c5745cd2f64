// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BoxTree_h
#define ahd_BoxTree_h

#include "../Core/Progress.h"
#include "../Points/BoxLevels.h"
#include "Pieces.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace ahd
{

/// Units of progress of one id of the chains in splitting, step by step; rounds after the first go
/// on beyond them.
struct SplitUnits
{
  static constexpr std::size_t kListed = 1, kInTree = 1, kSearched = 3, kSplit = 2, kWritten = 1;
  static constexpr std::size_t kAll = kListed + kInTree + kSearched + kSplit + kWritten;
};

inline Box boxOf(const Segment& s)
{
  Box box;
  box.xmin = s.left.x;
  box.xmax = s.right.x;
  box.ymin = std::min(s.left.y, s.right.y);
  box.ymax = std::max(s.left.y, s.right.y);
  return box;
}

/// The boxes of a few pieces, rounded: those that meet do so here. None of a piece that is dead or
/// not there.
class LeafBoxes
{
public:
  static constexpr std::size_t kMost = 8;

  // `origin`: where rounding is finest; finite.

  /// NaN meets nothing; large numbers round to infinity.
  void clear(std::size_t k)
  {
    xmin_[k] = ymin_[k] = xmax_[k] = ymax_[k] = std::numeric_limits<float>::quiet_NaN();
  }
  void put(std::size_t k, const Box& box, const Point& origin)
  {
    const Rounded r(box, origin);
    xmin_[k] = r.xmin;
    ymin_[k] = r.ymin;
    xmax_[k] = r.xmax;
    ymax_[k] = r.ymax;
  }

  /// Bit k is set if the box meets that of piece k; it may be if not. Rounding is monotone, so <=
  /// stays true. All at once: a loop that compilers vectorise.
  unsigned meeting(const Box& box, const Point& origin) const
  {
    static constexpr int kBits[kMost] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    const Rounded r(box, origin);
    int bits = 0;
    for (std::size_t k = 0; k != kMost; ++k)
    {
      const bool meets = (int(xmin_[k] <= r.xmax) & int(r.xmin <= xmax_[k]) &
                           int(ymin_[k] <= r.ymax) & int(r.ymin <= ymax_[k])) != 0;
      bits += meets ? kBits[k] : 0;
    }
    return static_cast<unsigned>(bits);
  }

private:
  struct Rounded
  {
    float xmin, ymin, xmax, ymax;

    Rounded(const Box& box, const Point& origin)
      : xmin(static_cast<float>(box.xmin - origin.x))
      , ymin(static_cast<float>(box.ymin - origin.y))
      , xmax(static_cast<float>(box.xmax - origin.x))
      , ymax(static_cast<float>(box.ymax - origin.y))
    {
    }
  };

  float xmin_[kMost], ymin_[kMost], xmax_[kMost], ymax_[kMost];
};

/// A run of pieces along the Hilbert curve of their middles, and boxes around each few successive
/// ones, around each few successive boxes, and so on.
class BoxTree
{
public:
  static constexpr std::size_t kInLeaf = LeafBoxes::kMost; ///< pieces in a box of level 0
  static constexpr std::size_t kInNode = 4;                ///< boxes in a box of the next level

  /// Adds `more` to the pieces, sorted, and builds the tree of these. Returns false if cancelled.
  /// Throws std::bad_alloc.
  bool build(const Pieces& more, Pieces& pieces, Ticker& ticker);

  /// Makes the boxes anew, around the live pieces. Returns false if cancelled.
  bool fit(const Pieces& pieces, Ticker& ticker);

  bool empty() const { return first_ == last_; }
  std::size_t top() const { return levels_.levels() - 1; }
  const Box& box(std::size_t level, std::size_t node) const { return levels_.box(level, node); }
  /// The first child of a node, and one past the last; of level 0: pieces.
  std::size_t childrenBegin(std::size_t level, std::size_t node) const
  {
    return levels_.childrenBegin(level, node) + (level == 0 ? first_ : 0);
  }
  std::size_t childrenEnd(std::size_t level, std::size_t node) const
  {
    return levels_.childrenEnd(level, node) + (level == 0 ? first_ : 0);
  }
  /// Of the pieces of a box of level 0, those whose boxes may meet this one: bit k for the k-th.
  unsigned meeting(const Box& box, std::size_t node) const
  {
    return leaves_[node].meeting(box, origin_);
  }
  /// Where its pieces are among all.
  std::size_t begin() const { return first_; }
  std::size_t end() const { return last_; }

  /// Calls work(piece) for those whose boxes meet this one, rounded, until that returns false,
  /// until `steps`, which it takes from, are used up, or until the ticker is cancelled. Returns
  /// false if it did not visit all.
  template <typename Work>
  bool forMeeting(const Box& box, std::size_t& steps, Ticker& ticker, const Work& work) const;

private:
  bool addSorted(const Pieces& more, Pieces& pieces, Ticker& ticker);
  Box fitLeaf(const Pieces& pieces, std::size_t node);

  std::size_t first_ = 0, last_ = 0;
  Point origin_ = {};
  std::vector<LeafBoxes> leaves_;
  BoxLevels<kInLeaf, kInNode> levels_;
};

template <typename Work>
bool BoxTree::forMeeting(const Box& box, std::size_t& steps, Ticker& ticker, const Work& work) const
{
  using Way = BoxLevels<kInLeaf, kInNode>::Way;
  const auto enter = [&](const Box& node)
  {
    if (!node.meets(box))
    {
      return Way::Past;
    }
    return steps == 0 || !ticker.step() ? Way::Stop : (--steps, Way::In);
  };
  const auto look = [&](std::size_t leaf)
  {
    const std::size_t first = childrenBegin(0, leaf);
    unsigned bits = meeting(box, leaf);
    for (std::size_t k = 0; bits != 0; ++k, bits >>= 1u)
    {
      if ((bits & 1u) != 0 && !work(first + k))
      {
        return false;
      }
    }
    return true;
  };
  return levels_.visit(enter, look);
}

/// The limits at which a BoxSearch gives up.
struct BoxSearchLimits
{
  std::size_t steps;     ///< for nothing: each crossing that is found allows some more
  std::size_t crossings; ///< that it finds
};

/// Finds pairs of pieces that cross, by the trees that they lie in.
class BoxSearch
{
public:
  enum class Outcome
  {
    Done,
    GivenUp,
    Cancelled
  };

  /// Listing requests memory, if `taken` is not null.
  BoxSearch(const Pieces& pieces, const BoxSearchLimits& limits, Ticker& ticker,
    std::vector<Crossing>& crossings, TakenMemory* taken = nullptr)
    : pieces_(pieces)
    , mostSteps_(limits.steps)
    , mostCrossings_(limits.crossings)
    , ticker_(ticker)
    , crossings_(crossings)
    , taken_(taken)
  {
  }

  /// Those of two pieces of one tree. Throws std::bad_alloc.
  Outcome searchWithin(const BoxTree& tree);
  /// Those of a piece of one tree with a piece of the other; dead pieces cross nothing.
  Outcome searchBetween(const BoxTree& a, const BoxTree& b);

private:
  struct Node
  {
    const BoxTree* tree;
    std::size_t level, number;

    const Box& box() const { return tree->box(level, number); }
    std::size_t begin() const { return tree->childrenBegin(level, number); }
    std::size_t end() const { return tree->childrenEnd(level, number); }
  };

  bool within(const Node& node);
  bool between(const Node& a, const Node& b);
  bool test(std::size_t piece, const Node& leaf, unsigned among);
  bool count(std::size_t steps);
  Outcome outcomeOf(bool done) const
  {
    return done ? Outcome::Done : isCancelled_ ? Outcome::Cancelled : Outcome::GivenUp;
  }

  const Pieces& pieces_;
  std::size_t mostSteps_;
  std::size_t steps_ = 0;
  std::size_t mostCrossings_;
  Ticker& ticker_;
  std::vector<Crossing>& crossings_;
  TakenMemory* taken_;
  bool isCancelled_ = false;
};

} // namespace ahd

#endif
