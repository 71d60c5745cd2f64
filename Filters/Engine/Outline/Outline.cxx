// SPDX-License-Identifier: BSD-3-Clause
#include "Outline.h"

#include "../Core/AskedMemory.h"
#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Core/SortAsking.h"
#include "../Predicates/Predicates.h"
#include "CellEdges.h"

#include <algorithm>
#include <cmath>

namespace ahd
{
namespace
{

constexpr std::size_t kBytesPerBoundaryEdge = 32;

/// The rings of the cells' boundary, and their order.
class Rings
{
public:
  Rings(const OutlineRequest& request, const CellEdges& edges)
    : request_(request)
    , edges_(edges)
    , plane_(edges.plane())
  {
  }

  /// Returns false if cancelled; throws std::bad_alloc.
  bool make(Ticker& ticker)
  {
    return walkAll(ticker) && findTurns(ticker) && findFirstCells(ticker) && order(ticker);
  }
  bool write(Outline& out, Ticker& ticker) const;

private:
  struct Ring
  {
    Index begin, end; ///< its corners
    Index component;
    bool turnsRight; ///< known of directed cells, else false
  };

  Point place(Index point) const
  {
    const PointView& points = request_.points;
    switch (plane_)
    {
      case OutlinePlane::Yz:
        return { points[point].y, points.z(point) };
      case OutlinePlane::Zx:
        return { points.z(point), points[point].x };
      case OutlinePlane::Xy:
        break;
    }
    return points[point];
  }
  double groupOf(Index component) const
  {
    return request_.groups ? request_.groups[firstCells_[component]] : 0.0;
  }
  Index second(const Ring& ring) const { return corners_[ring.begin + 1]; }
  Index last(const Ring& ring) const { return corners_[ring.end - 1]; }
  Index follower(const Ring& ring) const
  {
    return isReversed_[ring.component] != 0 ? last(ring) : second(ring);
  }
  Point start(const Ring& ring) const { return place(corners_[ring.begin]); }
  bool turnsRightAtStart(const Ring& ring) const
  {
    return orient2d(start(ring), place(second(ring)), place(last(ring))) < 0;
  }

  bool walkAll(Ticker& ticker);
  bool walk(CellEdge from, Ticker& ticker);
  bool cutRing(std::size_t begin, Index component, Ticker& ticker);
  bool findTurns(Ticker& ticker);
  bool findFirstCells(Ticker& ticker);
  Point lowestWay(const Ring& ring) const;
  bool isFurtherOut(const Ring& a, const Ring& b) const;
  bool isBefore(Index a, Index b) const;
  bool order(Ticker& ticker);

  const OutlineRequest& request_;
  const CellEdges& edges_;
  const OutlinePlane plane_;
  Buffer<Index> stack_;            ///< the corners on the way that are in no ring yet
  Buffer<Index> positions_;        ///< of points in the stack; kNoIndex for others
  Buffer<unsigned char> isPassed_; ///< of each edge
  std::size_t size_ = 0;           ///< of the stack
  Buffer<Index> corners_;
  std::size_t cornerCount_ = 0;
  std::vector<Ring> rings_;
  std::vector<Index> order_;              ///< the numbers of the rings
  std::vector<Index> firstCells_, outer_; ///< of each component
  std::vector<unsigned char> isReversed_;
};

bool Rings::walkAll(Ticker& ticker)
{
  stack_.allocate(edges_.boundaryCount());
  corners_.allocate(edges_.boundaryCount());
  rings_.reserve(edges_.boundaryCount() / 3);
  positions_.allocate(request_.points.count);
  isPassed_.allocate(edges_.count());
  if (!fillAll(positions_, kNoIndex, ticker) ||
    !fillAll(isPassed_, static_cast<unsigned char>(0), ticker))
  {
    return false;
  }
  for (std::size_t k = 0; k < edges_.count(); ++k)
  {
    const auto h = static_cast<CellEdge>(k);
    if (!ticker.step() || (edges_.isBoundary(h) && isPassed_[h] == 0 && !walk(h, ticker)))
    {
      return false;
    }
  }
  return true;
}

/// The way along the boundary from this edge back to it. Where it comes to a vertex again, the part
/// in between is a ring of its own.
bool Rings::walk(CellEdge from, Ticker& ticker)
{
  const Index component = edges_.componentOf(edges_.cellOf(from));
  CellEdge h = from;
  do
  {
    const Index corner = edges_.origin(h);
    if (positions_[corner] != kNoIndex)
    {
      if (!cutRing(positions_[corner], component, ticker))
      {
        return false;
      }
    }
    else
    {
      positions_[corner] = static_cast<Index>(size_);
      stack_[size_++] = corner;
    }
    isPassed_[h] = 1;
    h = edges_.follow(h, ticker);
    if (h == CellEdges::kNull)
    {
      return false;
    }
  } while (h != from);
  const bool all = cutRing(0, component, ticker);
  positions_[stack_[0]] = kNoIndex;
  size_ = 0;
  return all;
}

/// Moves corners from the stack to a new ring, all but the first, which both have. Two corners are
/// no ring.
bool Rings::cutRing(std::size_t begin, Index component, Ticker& ticker)
{
  const auto isLess = [this](Index a, Index b)
  { return lexicographicallyLess(place(a), place(b)); };
  std::size_t least = begin;
  const auto look = [&](std::size_t k)
  {
    least = isLess(stack_[k], stack_[least]) ? k : least;
    positions_[stack_[k]] = k == begin ? positions_[stack_[k]] : kNoIndex;
  };
  const std::size_t count = size_ - begin;
  const auto move = [&](std::size_t k)
  { corners_[cornerCount_ + k] = stack_[least + k < size_ ? least + k : least + k - count]; };
  if (!inSteps(begin, size_, ticker, look) || !inSteps(0, count > 2 ? count : 0, ticker, move))
  {
    return false;
  }
  if (count > 2)
  {
    const auto first = static_cast<Index>(cornerCount_);
    cornerCount_ += count;
    rings_.push_back({ first, static_cast<Index>(cornerCount_), component, false });
  }
  size_ = begin + 1;
  return true;
}

/// Of directed cells: by the area, as vertices may lie where the ring begins. Where the area is not
/// more than its rounding, by the smallest vertex.
bool Rings::findTurns(Ticker& ticker)
{
  for (std::size_t r = 0; request_.isDirected && r < rings_.size(); ++r)
  {
    Ring& ring = rings_[r];
    const Point o = start(ring);
    double scale = 0.0, area = 0.0, terms = 0.0;
    const auto from = [&](std::size_t k)
    {
      const Point p = place(corners_[k]);
      return Point{ p.x - o.x, p.y - o.y };
    };
    const auto measure = [&](std::size_t k) {
      scale = std::max({ scale, std::abs(from(k).x), std::abs(from(k).y) });
    };
    const auto add = [&](std::size_t k)
    {
      const Point p = from(k - 1), q = from(k);
      const double a = p.x / scale * (q.y / scale), b = p.y / scale * (q.x / scale);
      area += a - b;
      terms += std::abs(a) + std::abs(b);
    };
    if (!inSteps(ring.begin, ring.end, ticker, measure) ||
      !inSteps(ring.begin + 1, ring.end, ticker, add))
    {
      return false;
    }
    const double rounding = double(ring.end - ring.begin) * (terms * 0x1p-50 + 0x1p-1022);
    ring.turnsRight = std::abs(area) > rounding ? area < 0.0 : turnsRightAtStart(ring);
  }
  return true;
}

bool Rings::findFirstCells(Ticker& ticker)
{
  firstCells_.resize(edges_.componentCount());
  const std::size_t cells = request_.cells.cells;
  return inSteps(0, cells, ticker,
    [&](std::size_t k)
    {
      const std::size_t cell = cells - 1 - k;
      const Index component = edges_.componentOf(cell);
      if (component != kNoIndex)
      {
        firstCells_[component] = static_cast<Index>(cell);
      }
    });
}

/// Of the ring's two ways from its start, the clockwise one: both lead to the right, or straight
/// up.
Point Rings::lowestWay(const Ring& ring) const
{
  const Point a = place(second(ring)), b = place(last(ring));
  return orient2d(start(ring), a, b) > 0 ? a : b;
}

/// Of two rings of a component: the outer one has its smallest vertex, and if others pass that,
/// lies around them. Of directed cells it is the only one that turns to the left, also where
/// rounding takes the component's width.
bool Rings::isFurtherOut(const Ring& a, const Ring& b) const
{
  if (a.turnsRight != b.turnsRight)
  {
    return b.turnsRight;
  }
  const Point p = start(a), q = start(b);
  return p == q ? orient2d(p, lowestWay(a), lowestWay(b)) > 0 : lexicographicallyLess(p, q);
}

/// @pre outer_, isReversed_
bool Rings::isBefore(Index a, Index b) const
{
  const Ring &p = rings_[a], &q = rings_[b];
  const bool isOne = p.component == q.component;
  const Ring& s = isOne ? p : rings_[outer_[p.component]];
  const Ring& t = isOne ? q : rings_[outer_[q.component]];
  const double group = groupOf(p.component), other = groupOf(q.component);
  if (group != other)
  {
    return group < other;
  }
  const bool isOuter = isOne && outer_[p.component] == a,
             isOtherOuter = isOne && outer_[p.component] == b;
  if (isOuter != isOtherOuter)
  {
    return isOuter;
  }
  const Point starts[2] = { start(s), start(t) };
  const Point followers[2] = { place(follower(s)), place(follower(t)) };
  for (const Point* pair : { starts, followers })
  {
    if (!(pair[0] == pair[1]))
    {
      return lexicographicallyLess(pair[0], pair[1]);
    }
  }
  return isOne ? a < b : p.component < q.component;
}

bool Rings::order(Ticker& ticker)
{
  outer_.assign(edges_.componentCount(), kNoIndex);
  isReversed_.assign(edges_.componentCount(), 0);
  order_.resize(rings_.size());
  const auto compare = [&](std::size_t r)
  {
    const Ring& ring = rings_[r];
    Index& outer = outer_[ring.component];
    outer = outer == kNoIndex || isFurtherOut(ring, rings_[outer]) ? static_cast<Index>(r) : outer;
    order_[r] = static_cast<Index>(r);
  };
  const auto turn = [&](std::size_t c)
  {
    if (outer_[c] != kNoIndex)
    {
      isReversed_[c] = !request_.isDirected && turnsRightAtStart(rings_[outer_[c]]) ? 1 : 0;
    }
  };
  return inSteps(0, rings_.size(), ticker, compare) && inSteps(0, outer_.size(), ticker, turn) &&
    sortAsking(order_, ticker, [this](Index a, Index b) { return isBefore(a, b); });
}

bool Rings::write(Outline& out, Ticker& ticker) const
{
  out.corners.reserve(cornerCount_);
  out.rings.reserve(order_.size() + 1);
  out.rings.push_back(0);
  for (std::size_t k = 0; k < order_.size(); ++k)
  {
    const Ring& ring = rings_[order_[k]];
    if (outer_[ring.component] == order_[k])
    {
      out.polygons.push_back(static_cast<Index>(k));
      out.cells.push_back(firstCells_[ring.component]);
    }
    out.corners.push_back(corners_[ring.begin]);
    const bool isReversed = isReversed_[ring.component] != 0;
    const auto add = [&](std::size_t i)
    { out.corners.push_back(corners_[isReversed ? ring.end - i : ring.begin + i]); };
    if (!inSteps(1, ring.end - ring.begin, ticker, add))
    {
      return false;
    }
    out.rings.push_back(static_cast<Index>(out.corners.size()));
  }
  out.polygons.push_back(static_cast<Index>(order_.size()));
  return ticker.ask();
}

} // namespace

std::size_t outlineMemoryEstimate(const OutlineRequest& request)
{
  // Points, their hashes, and again to sort them; after that: corners, cells of edges, twins, the
  // list of edges, whether they are passed; points, their heads or positions; states of cells, the
  // stack, components.
  const std::size_t toMerge = 20 * request.points.count;
  return std::max(
    toMerge, 21 * request.cells.ids + 8 * request.points.count + 17 * request.cells.cells);
}

std::size_t ringsMemoryEstimate(const Outline& made, std::size_t points, std::size_t perPoint)
{
  constexpr std::size_t kCorner = 3 * sizeof(std::int64_t); // its id, twice more to number points
  constexpr std::size_t kRing = 4 * sizeof(std::int64_t) +
    1; // offset, first once more, two numbers
  return perPoint == 0 ? 0
                       : std::min(made.corners.size(), points) * perPoint +
      made.corners.size() * kCorner + made.rings.size() * kRing;
}

Status outline(const OutlineRequest& request, const Context& context, Outline& out)
{
  out = Outline();
  constexpr std::size_t kMost = kNoIndex - 3;
  if (std::max({ request.points.count, request.cells.ids, request.cells.cells }) >= kMost)
  {
    return Status::TooManyPoints;
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 3 * request.cells.ids, context.executor);
      TakenMemory more(ticker);
      CellEdges edges(request);
      if (!ticker.ask() || !edges.make(ticker))
      {
        return false;
      }
      more.atLeast(kBytesPerBoundaryEdge * edges.boundaryCount());
      Rings rings(request, edges);
      out.plane = edges.plane();
      out.unfitCells = edges.unfitCells();
      out.unfitEdges = edges.unfitEdges();
      return rings.make(ticker) && rings.write(out, ticker);
    });
}

} // namespace ahd
