// SPDX-License-Identifier: BSD-3-Clause
#include "BoxTree.h"

#include "../Core/Chunks.h"
#include "../Order/HilbertCurve.h"
#include "../Order/Quantise.h"
#include "../Order/RadixSort.h"
#include "../Predicates/Predicates.h"

namespace ahd
{

bool cross(const Segment& s, const Segment& t)
{
  if (s.left == t.left || s.left == t.right || s.right == t.left || s.right == t.right)
  {
    return false;
  }
  const int left = orient2d(s.left, s.right, t.left);
  if (left == 0 || orient2d(s.left, s.right, t.right) != -left)
  {
    return false;
  }
  const int other = orient2d(t.left, t.right, s.left);
  return other != 0 && orient2d(t.left, t.right, s.right) == -other;
}

// ----------------------------------------------------------------------------------- the tree

/// Along the curve of their middles, up to rounding: the order has no say in what is found.
/// REQUIRES: there are more.
bool BoxTree::addSorted(const Pieces& more, Pieces& pieces, Ticker& ticker)
{
  const std::size_t n = more.size();
  PieceBox all;
  Buffer<std::uint64_t> keys;
  keys.allocate(n);
  const auto bound = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      all.add(PieceBox::of(more[k].segment));
    }
  };
  if (!inChunks(0, n, ticker, bound))
  {
    return false;
  }
  const Grid grid(Bounds{ all.xmin, all.xmax, all.ymin, all.ymax });
  const auto makeKeys = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      const Segment& s = more[k].segment;
      const std::uint64_t place = hilbertKey(
        grid.column(0.5 * s.left.x + 0.5 * s.right.x), grid.row(0.5 * s.left.y + 0.5 * s.right.y));
      keys[k] = packed(static_cast<std::uint32_t>(place >> 32), static_cast<std::uint32_t>(k));
    }
  };
  const auto add = [&](std::size_t a, std::size_t b)
  {
    constexpr std::size_t kAhead = 16;
    for (std::size_t k = a; k != b; ++k)
    {
      prefetchForRead(&more[static_cast<Index>(keys[std::min(k + kAhead, n - 1)])]);
      pieces.push_back(more[static_cast<Index>(keys[k])]);
    }
  };
  pieces.reserve(pieces.size() + n);
  return inChunks(0, n, ticker, makeKeys) && sortPacked(keys, n, ticker) &&
    inChunks(0, n, ticker, add);
}

bool BoxTree::build(const Pieces& more, Pieces& pieces, Ticker& ticker)
{
  first_ = pieces.size();
  last_ = first_ + more.size();
  levels_.clear();
  if (empty())
  {
    return true;
  }
  if (!addSorted(more, pieces, ticker))
  {
    return false;
  }
  std::size_t count = last_ - first_, group = kInLeaf;
  do
  {
    count = (count + group - 1) / group;
    group = kInNode;
    levels_.emplace_back(count);
  } while (count > 1);
  return fit(pieces, ticker);
}

bool BoxTree::fit(const Pieces& pieces, Ticker& ticker)
{
  const auto around = [&](std::size_t level, std::size_t node)
  {
    PieceBox box;
    const std::size_t end = childrenEnd(level, node);
    for (std::size_t k = childrenBegin(level, node); k != end; ++k)
    {
      if (level != 0)
      {
        box.add(levels_[level - 1][k]);
      }
      else if (!pieces[k].isDead)
      {
        box.add(PieceBox::of(pieces[k].segment));
      }
    }
    return box;
  };
  for (std::size_t level = 0; level != levels_.size(); ++level)
  {
    const auto fitNodes = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t node = a; node != b; ++node)
      {
        levels_[level][node] = around(level, node);
      }
    };
    if (!inChunks(0, levels_[level].size(), ticker, fitNodes))
    {
      return false;
    }
  }
  return true;
}

// ------------------------------------------------------------------------------------- the search

BoxSearch::Outcome BoxSearch::searchWithin(const BoxTree& tree)
{
  return outcomeOf(tree.empty() || within({ &tree, tree.top(), 0 }));
}

BoxSearch::Outcome BoxSearch::searchBetween(const BoxTree& a, const BoxTree& b)
{
  return outcomeOf(a.empty() || b.empty() || between({ &a, a.top(), 0 }, { &b, b.top(), 0 }));
}

bool BoxSearch::count(std::size_t steps)
{
  constexpr std::size_t kPerCrossing = 32;
  steps_ += steps;
  if (steps_ > mostSteps_ + kPerCrossing * crossings_.size() || crossings_.size() > mostCrossings_)
  {
    return false;
  }
  isCancelled_ = !ticker_.step(steps / 4 + 1); // each is a fraction of a step elsewhere
  return !isCancelled_;
}

bool BoxSearch::within(const Node& node)
{
  const std::size_t begin = node.begin(), end = node.end();
  for (std::size_t k = begin; k != end; ++k)
  {
    if (node.level == 0)
    {
      const Piece& piece = pieces_[k];
      if (!test(piece, PieceBox::of(piece.segment), k + 1, end))
      {
        return false;
      }
      continue;
    }
    const Node child{ node.tree, node.level - 1, k };
    if (!within(child))
    {
      return false;
    }
    for (std::size_t l = k + 1; l != end; ++l)
    {
      const Node other{ node.tree, node.level - 1, l };
      if (child.box().meets(other.box()) && !between(child, other))
      {
        return false;
      }
    }
  }
  return count(end - begin);
}

/// REQUIRES: their boxes meet.
bool BoxSearch::between(const Node& a, const Node& b)
{
  const bool descendsA = a.level >= b.level;
  const Node& from = descendsA ? a : b;
  const Node& to = descendsA ? b : a;
  const PieceBox& box = to.box();
  const std::size_t end = from.end();
  for (std::size_t k = from.begin(); k != end; ++k)
  {
    if (from.level == 0)
    {
      const Piece& piece = pieces_[k];
      const PieceBox own = PieceBox::of(piece.segment);
      if (own.meets(box) && !piece.isDead && !test(piece, own, to.begin(), to.end()))
      {
        return false;
      }
      continue;
    }
    const Node child{ from.tree, from.level - 1, k };
    if (child.box().meets(box) && !between(child, to))
    {
      return false;
    }
  }
  return count(BoxTree::kInLeaf);
}

/// The piece against those [begin, end).
bool BoxSearch::test(const Piece& a, const PieceBox& box, std::size_t begin, std::size_t end)
{
  constexpr std::size_t kExactTest = 8;
  std::size_t steps = end - begin;
  for (std::size_t k = begin; k != end; ++k)
  {
    const Piece& b = pieces_[k];
    if (!box.meets(PieceBox::of(b.segment)) || b.isDead)
    {
      continue;
    }
    if (!cross(a.segment, b.segment))
    {
      steps += kExactTest;
    }
    else
    {
      crossings_.push_back(
        { static_cast<Index>(&a - pieces_.data()), static_cast<Index>(&b - pieces_.data()) });
    }
  }
  return count(steps);
}

} // namespace ahd
