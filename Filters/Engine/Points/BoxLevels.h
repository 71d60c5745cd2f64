// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BoxLevels_h
#define ahd_BoxLevels_h

#include "../Core/Buffer.h"
#include "../Core/Loops.h"
#include "Points.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace ahd
{

/// An axis-parallel box; one that is empty meets none.
struct Box
{
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  double xmin = kFar, xmax = -kFar;
  double ymin = kFar, ymax = -kFar;

  static Box around(const Point& p, const Point& q)
  {
    Box box;
    box.xmin = std::min(p.x, q.x);
    box.xmax = std::max(p.x, q.x);
    box.ymin = std::min(p.y, q.y);
    box.ymax = std::max(p.y, q.y);
    return box;
  }
  void add(const Box& b)
  {
    xmin = std::min(xmin, b.xmin);
    xmax = std::max(xmax, b.xmax);
    ymin = std::min(ymin, b.ymin);
    ymax = std::max(ymax, b.ymax);
  }
  Point middle() const { return { 0.5 * xmin + 0.5 * xmax, 0.5 * ymin + 0.5 * ymax }; }
  /// Without branches: the outcome is hard to predict.
  bool meets(const Box& b) const
  {
    return (int(xmin <= b.xmax) & int(b.xmin <= xmax) & int(ymin <= b.ymax) &
             int(b.ymin <= ymax)) != 0;
  }
};

/// Boxes around each `inLeaf` successive items (a leaf, level 0), around each `inNode` successive
/// boxes, and so on, up to the one box around all.
template <std::size_t inLeaf, std::size_t inNode>
class BoxLevels
{
public:
  /// What visit() does with a box.
  enum class Way
  {
    In,
    Past,
    Stop
  };

  /// Allocates memory for the boxes of so many items; throws std::bad_alloc.
  void allocate(std::size_t items)
  {
    items_ = items;
    begins_.assign(1, 0);
    std::size_t size = items, in = inLeaf;
    while (size > 1 || (size == 1 && levels() == 0))
    {
      size = (size + in - 1) / in;
      in = inNode;
      begins_.push_back(begins_.back() + size);
    }
    boxes_.allocate(begins_.back());
  }

  /// Makes the boxes; leafBox(leaf) is that of a leaf. Returns false if cancelled.
  template <typename LeafBox>
  bool fit(const LeafBox& leafBox, Ticker& ticker)
  {
    for (std::size_t level = 0; level != levels(); ++level)
    {
      const auto make = [&](std::size_t a, std::size_t b)
      {
        for (std::size_t node = a; node != b; ++node)
        {
          boxes_[begins_[level] + node] = level == 0 ? leafBox(node) : around(level, node);
        }
      };
      const std::size_t n = count(level);
      // few boxes need no poll
      if (!(n < kChunk ? inChunks(0, n, ticker, make) : inChunksOf(n, ticker, make)))
      {
        return false;
      }
    }
    return true;
  }

  /// The same, around items: boxOf(k) is that of an item.
  template <typename BoxOf>
  bool fitItems(const BoxOf& boxOf, Ticker& ticker)
  {
    const auto leafBox = [&](std::size_t leaf)
    {
      Box all;
      for (std::size_t k = childrenBegin(0, leaf); k != childrenEnd(0, leaf); ++k)
      {
        all.add(boxOf(k));
      }
      return all;
    };
    return fit(leafBox, ticker);
  }

  /// None where there are no items.
  std::size_t levels() const { return begins_.size() - 1; }
  /// Of boxes.
  std::size_t count(std::size_t level) const { return begins_[level + 1] - begins_[level]; }
  const Box& box(std::size_t level, std::size_t node) const
  {
    return boxes_[begins_[level] + node];
  }
  /// The first child of a box: an item or a box of the level below.
  static std::size_t childrenBegin(std::size_t level, std::size_t node)
  {
    return node * (level == 0 ? inLeaf : inNode);
  }
  /// One past the last.
  std::size_t childrenEnd(std::size_t level, std::size_t node) const
  {
    return std::min(childrenBegin(level, node + 1), level == 0 ? items_ : count(level - 1));
  }

  /// Visits depth first, from the first items to the last: enter(box) returns the Way to go, and
  /// look(leaf) is called for each leaf reached, until one returns Stop or false. Returns false
  /// then.
  template <typename Enter, typename Look>
  bool visit(const Enter& enter, const Look& look) const;

private:
  Box around(std::size_t level, std::size_t node) const
  {
    Box all;
    const std::size_t end = childrenEnd(level, node);
    for (std::size_t k = childrenBegin(level, node); k != end; ++k)
    {
      all.add(box(level - 1, k));
    }
    return all;
  }

  std::size_t items_ = 0;
  Buffer<Box> boxes_;                    ///< level after level
  std::vector<std::size_t> begins_{ 0 }; ///< of the levels, and the end of the last
};

template <std::size_t inLeaf, std::size_t inNode>
template <typename Enter, typename Look>
bool BoxLevels<inLeaf, inNode>::visit(const Enter& enter, const Look& look) const
{
  constexpr std::size_t kMostLevels = 32; // of 2^32 items
  std::size_t next[kMostLevels], end[kMostLevels];
  const std::size_t above = levels();
  std::size_t level = above;
  if (level != 0)
  {
    next[--level] = 0;
    end[level] = 1;
  }
  while (level != above)
  {
    if (next[level] == end[level])
    {
      ++level;
      continue;
    }
    const std::size_t node = next[level]++;
    const Way way = enter(box(level, node));
    if (way == Way::Stop || (way == Way::In && level == 0 && !look(node)))
    {
      return false;
    }
    if (way == Way::In && level != 0)
    {
      next[level - 1] = childrenBegin(level, node);
      end[level - 1] = childrenEnd(level, node);
      --level;
    }
  }
  return true;
}

} // namespace ahd

#endif
