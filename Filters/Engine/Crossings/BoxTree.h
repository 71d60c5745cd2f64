// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BoxTree_h
#define ahd_BoxTree_h

#include "../Core/Progress.h"
#include "Pieces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace ahd
{

/// What an id of the chains counts in the progress of splitting, step by step; all rounds but the
/// first go on beyond it.
struct SplitUnits
{
  static constexpr std::size_t kListed = 1, kInTree = 1, kSearched = 3, kSplit = 2, kWritten = 1;
  static constexpr std::size_t kAll = kListed + kInTree + kSearched + kSplit + kWritten;
};

/// An axis-parallel box; one that is empty meets none.
struct PieceBox
{
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  double xmin = kFar, ymin = kFar, xmax = -kFar, ymax = -kFar;

  static PieceBox of(const Segment& s)
  {
    PieceBox box;
    box.xmin = s.left.x;
    box.xmax = s.right.x;
    box.ymin = std::min(s.left.y, s.right.y);
    box.ymax = std::max(s.left.y, s.right.y);
    return box;
  }
  void add(const PieceBox& b)
  {
    xmin = std::min(xmin, b.xmin);
    ymin = std::min(ymin, b.ymin);
    xmax = std::max(xmax, b.xmax);
    ymax = std::max(ymax, b.ymax);
  }
  /// Without branches: whether they meet is hard to foretell.
  bool meets(const PieceBox& b) const
  {
    return (int(xmin <= b.xmax) & int(b.xmin <= xmax) & int(ymin <= b.ymax) &
             int(b.ymin <= ymax)) != 0;
  }
};

/// The boxes of a few pieces, rounded: those that meet do so here. None of a piece that is dead or
/// not there.
class LeafBoxes
{
public:
  static constexpr std::size_t kMost = 8;

  /// Where rounding is finest; a finite number.
  struct Origin
  {
    double x, y;
  };

  /// Nothing meets what is no number; infinity is what large numbers round to.
  void clear(std::size_t k)
  {
    xmin_[k] = ymin_[k] = xmax_[k] = ymax_[k] = std::numeric_limits<float>::quiet_NaN();
  }
  void put(std::size_t k, const PieceBox& box, const Origin& origin)
  {
    const Rounded r(box, origin);
    xmin_[k] = r.xmin;
    ymin_[k] = r.ymin;
    xmax_[k] = r.xmax;
    ymax_[k] = r.ymax;
  }

  /// Bit k is set if the box meets that of piece k; it may be if not. Rounding is monotone, so what
  /// is not less stays so. All at once: a loop that compilers make vectors of.
  unsigned meeting(const PieceBox& box, const Origin& origin) const
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

    Rounded(const PieceBox& box, const Origin& origin)
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

  /// Adds `more` to the pieces, sorted, and builds the tree of these. Returns false if the work is
  /// to be cancelled. Throws std::bad_alloc.
  bool build(const Pieces& more, Pieces& pieces, Ticker& ticker);

  /// Makes the boxes anew: around what is not dead. Returns false if the work is to be cancelled.
  bool fit(const Pieces& pieces, Ticker& ticker);

  bool empty() const { return first_ == last_; }
  std::size_t top() const { return levels_.size() - 1; }
  const PieceBox& box(std::size_t level, std::size_t node) const { return levels_[level][node]; }
  /// One past the last child of a node; of level 0: past its last piece.
  std::size_t childrenEnd(std::size_t level, std::size_t node) const
  {
    return level == 0 ? std::min(first_ + (node + 1) * kInLeaf, last_)
                      : std::min((node + 1) * kInNode, levels_[level - 1].size());
  }
  /// Of the pieces of a box of level 0, those whose boxes may meet this one: bit k for the k-th.
  unsigned meeting(const PieceBox& box, std::size_t node) const
  {
    return leaves_[node].meeting(box, origin_);
  }
  std::size_t childrenBegin(std::size_t level, std::size_t node) const
  {
    return level == 0 ? first_ + node * kInLeaf : node * kInNode;
  }

  /// Where its pieces are among all.
  std::size_t begin() const { return first_; }
  std::size_t end() const { return last_; }

  /// Calls work(piece) for those whose boxes meet this one, rounded, until that returns false,
  /// until `steps`, which it takes from, are used up, or until the ticker is cancelled. Returns
  /// false if it did not see all.
  template <typename Work>
  bool forMeeting(const PieceBox& box, std::size_t& steps, Ticker& ticker, const Work& work) const;

private:
  bool addSorted(const Pieces& more, Pieces& pieces, Ticker& ticker);
  PieceBox fitLeaf(const Pieces& pieces, std::size_t node);
  PieceBox boxAround(std::size_t level, std::size_t node) const;

  std::size_t first_ = 0, last_ = 0;
  LeafBoxes::Origin origin_ = {};
  std::vector<LeafBoxes> leaves_;
  std::vector<std::vector<PieceBox>> levels_; ///< from the leaves to the one box around all
};

template <typename Work>
bool BoxTree::forMeeting(
  const PieceBox& box, std::size_t& steps, Ticker& ticker, const Work& work) const
{
  struct Node
  {
    std::size_t level, number;
  };
  constexpr std::size_t kMostLevels = 18; // for 2^32 pieces
  std::array<Node, kMostLevels * kInNode> waiting;
  std::size_t count = 0;
  if (!empty() && levels_[top()][0].meets(box))
  {
    waiting[count++] = { top(), 0 };
  }
  for (; count != 0 && steps != 0 && ticker.step(); --steps)
  {
    const Node node = waiting[--count];
    const std::size_t first = childrenBegin(node.level, node.number);
    if (node.level == 0)
    {
      const unsigned bits = meeting(box, node.number);
      for (std::size_t k = 0; k != kInLeaf; ++k)
      {
        if ((bits >> k & 1u) != 0 && !work(first + k))
        {
          return false;
        }
      }
      continue;
    }
    for (std::size_t k = childrenEnd(node.level, node.number); k-- != first;)
    {
      if (levels_[node.level - 1][k].meets(box))
      {
        waiting[count++] = { node.level - 1, k };
      }
    }
  }
  return count == 0;
}

/// How much a BoxSearch may do before it gives up.
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

  /// What is listed asks for memory, if `taken` is not null.
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

    const PieceBox& box() const { return tree->box(level, number); }
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
