// SPDX-License-Identifier: BSD-3-Clause
#include "BoxTree.h"

#include "../Core/Chunks.h"
#include "../Order/CurveKeys.h"
#include "../Predicates/Predicates.h"

namespace ahd
{
namespace
{

/// The number of the lowest bit that is set. @pre bits is not 0.
inline unsigned lowestBit(unsigned bits)
{
#if defined(__GNUC__) || defined(__clang__)
  return static_cast<unsigned>(__builtin_ctz(bits));
#else
  return bitLength(bits & (~bits + 1)) - 1;
#endif
}

/// Without branches: the outcome is hard to predict.
bool haveCommonEnd(const Segment& s, const Segment& t)
{
  const auto same = [](const Point& p, const Point& q)
  { return int(p.x == q.x) & int(p.y == q.y); };
  return (same(s.left, t.left) | same(s.left, t.right) | same(s.right, t.left) |
           same(s.right, t.right)) != 0;
}

} // namespace

bool cross(const Segment& s, const Segment& t)
{
  if (haveCommonEnd(s, t))
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

/// Along the curve of their middles, up to rounding: the order does not affect the result.
/// @pre there are more.
bool BoxTree::addSorted(const Pieces& more, Pieces& pieces, Ticker& ticker)
{
  const std::size_t n = more.size();
  Box all;
  Buffer<std::uint64_t> keys;
  if (!sortAlongCurve(
        n, [&](std::size_t k) { return boxOf(more[k].segment); }, keys, all, ticker))
  {
    return false;
  }
  origin_ = all.middle();
  const auto add = [&](std::size_t a, std::size_t b)
  {
    constexpr std::size_t kAhead = 16;
    for (std::size_t k = a; k != b; ++k)
    {
      prefetchForRead(&more[static_cast<Index>(keys[std::min(k + kAhead, n - 1)])]);
      pieces.push_back(more[static_cast<Index>(keys[k])]);
    }
    ticker.finished(SplitUnits::kInTree * (b - a));
  };
  pieces.reserve(pieces.size() + n);
  return inChunks(0, n, ticker, add);
}

bool BoxTree::build(const Pieces& more, Pieces& pieces, Ticker& ticker)
{
  first_ = pieces.size();
  last_ = first_ + more.size();
  levels_.allocate(0);
  if (empty())
  {
    return true;
  }
  if (!addSorted(more, pieces, ticker))
  {
    return false;
  }
  levels_.allocate(more.size()); // behind what sorting takes
  leaves_.resize(levels_.count(0));
  return fit(pieces, ticker);
}

Box BoxTree::fitLeaf(const Pieces& pieces, std::size_t node)
{
  Box all;
  const std::size_t begin = childrenBegin(0, node), end = childrenEnd(0, node);
  for (std::size_t k = 0; k != kInLeaf; ++k)
  {
    if (begin + k >= end || pieces[begin + k].isDead)
    {
      leaves_[node].clear(k);
      continue;
    }
    const Box box = boxOf(pieces[begin + k].segment);
    leaves_[node].put(k, box, origin_);
    all.add(box);
  }
  return all;
}

bool BoxTree::fit(const Pieces& pieces, Ticker& ticker)
{
  return levels_.fit([&](std::size_t leaf) { return fitLeaf(pieces, leaf); }, ticker);
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
  isCancelled_ = !ticker_.step(steps / 4 + 1); // each counts as a fraction of a step
  return !isCancelled_;
}

bool BoxSearch::within(const Node& node)
{
  const std::size_t begin = node.begin(), end = node.end();
  for (std::size_t k = begin; k != end; ++k)
  {
    if (node.level == 0)
    {
      const unsigned behind = ~1u << (k - begin);
      if (!pieces_[k].isDead && !test(k, node, behind))
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
  if (node.level == 0)
  {
    ticker_.finished(SplitUnits::kSearched * (end - begin));
  }
  return count(end - begin);
}

/// @pre their boxes meet.
bool BoxSearch::between(const Node& a, const Node& b)
{
  const bool descendsA = a.level >= b.level;
  const Node& from = descendsA ? a : b;
  const Node& to = descendsA ? b : a;
  const Box& box = to.box();
  if (from.level == 0)
  {
    const std::size_t begin = from.begin();
    for (unsigned bits = from.tree->meeting(box, from.number); bits != 0; bits &= bits - 1)
    {
      if (!test(begin + lowestBit(bits), to, ~0u))
      {
        return false;
      }
    }
    return count(BoxTree::kInLeaf);
  }
  const std::size_t end = from.end();
  for (std::size_t k = from.begin(); k != end; ++k)
  {
    const Node child{ from.tree, from.level - 1, k };
    if (child.box().meets(box) && !between(child, to))
    {
      return false;
    }
  }
  return count(BoxTree::kInLeaf);
}

/// The piece against those of a leaf whose bits are set.
bool BoxSearch::test(std::size_t piece, const Node& leaf, unsigned among)
{
  constexpr std::size_t kExactTest = 8;
  const Segment& own = pieces_[piece].segment;
  const Box box = boxOf(own);
  const std::size_t begin = leaf.begin();
  std::size_t steps = BoxTree::kInLeaf;
  for (unsigned bits = leaf.tree->meeting(box, leaf.number) & among; bits != 0; bits &= bits - 1)
  {
    const std::size_t other = begin + lowestBit(bits);
    const Segment& segment = pieces_[other].segment;
    if (!box.meets(boxOf(segment)))
    {
      continue; // but for rounding
    }
    if (!cross(own, segment))
    {
      steps += kExactTest;
    }
    else
    {
      addCrossing(crossings_, { static_cast<Index>(piece), static_cast<Index>(other) }, taken_);
    }
  }
  return count(steps);
}

} // namespace ahd
