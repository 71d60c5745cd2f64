// SPDX-License-Identifier: BSD-3-Clause
#include "Part.h"

#include "../Constrain/ConstrainedMesh.h"
#include "../Constrain/EdgeTable.h"
#include "../Core/Border.h"
#include "../Core/Chunks.h"

#include <algorithm>
#include <cassert>

namespace ahd
{

/// Of the mesh as it is now: constraints change its triangles, not their number. Ghosts are open
/// from the beginning: turns once around the hull to find them.
bool Part::begin(Ticker& ticker)
{
  const TriangulationAccess::State& all = state();
  slots_ = all.allTriangles == 0 ? 0 : all.mesh.end() / Mesh::kSlotSize;
  data_ = all.mesh.data();
  ghost_ = all.mesh.ghost();
  labels_.allocate(slots_);
  if (!fillAll(labels_, std::uint8_t(0), ticker) || !hasTriangles())
  {
    return !hasTriangles() && ticker.ask();
  }
  Mesh::Slot slot = 0;
  for (; !isGhost(slot); slot += Mesh::kSlotSize)
  {
    if (!ticker.step())
    {
      return false;
    }
  }
  Mesh::Halfedge start = slot;
  while (data_[start] != ghost_)
  {
    ++start;
  }
  Mesh::Halfedge h = start;
  do
  {
    ghosts_.push_back(Mesh::slotOf(h));
    labels_[h / Mesh::kSlotSize] = kOpen;
    h = Mesh::next(twin(Mesh::next(h)));
    if (!ticker.step())
    {
      return false;
    }
  } while (h != start);
  return true;
}

Status Part::makeOwn(const PointView& points, const std::int64_t* ids, std::uint32_t block,
  const Options& options, const Context& context)
{
  ids_ = ids;
  block_ = block;
  Workspace none;
  const Status status = triangulate(points, options, none, context, made_);
  return status != Status::Ok ? status
                              : unlessCancelled(
                                  [&]
                                  {
                                    Ticker ticker(context.progress, Phase::Outputs, 0);
                                    return begin(ticker);
                                  });
}

Status Part::makeOf(std::vector<PartBorder>& below, const Context& context)
{
  const Status joined = unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      std::size_t points = 0, edges = 0;
      for (const PartBorder& part : below)
      {
        points += part.points.size();
        edges += part.edges.size();
      }
      given_.reserve(points);
      edgesBelow_.reserve(edges);
      firstEdge_.push_back(0);
      for (PartBorder& part : below)
      {
        const auto first = static_cast<Index>(given_.size());
        const auto copyPoints = [&](std::size_t a, std::size_t b)
        { given_.insert(given_.end(), part.points.data() + a, part.points.data() + b); };
        const auto copyEdges = [&](std::size_t a, std::size_t b)
        {
          for (std::size_t i = a; i != b; ++i)
          {
            edgesBelow_.push_back({ part.edges[i].from + first, part.edges[i].to + first });
          }
        };
        if (!inChunks(0, part.points.size(), ticker, copyPoints) ||
          !inChunks(0, part.edges.size(), ticker, copyEdges))
        {
          return false;
        }
        firstEdge_.push_back(edgesBelow_.size());
        part = PartBorder();
      }
      return true;
    });
  if (joined != Status::Ok)
  {
    return joined;
  }
  PointView places(given_.empty() ? nullptr : &given_[0].at.x, given_.size(), 4);
  places.isFlat = true;
  Workspace none;
  return triangulate(places, Options(), none, context, made_);
}

Status Part::constrain(const ConstraintView& constraints, FillRule rule, const Context& context)
{
  return ahd::constrain(std::move(made_), constraints, rule, context, made_);
}

Corners Part::cornersOf(Mesh::Slot slot) const
{
  const Buffer<Point>& xy = state().ranked.xy;
  return { xy[data_[slot]], xy[data_[slot + 1]], xy[data_[slot + 2]] };
}

// ------------------------------------------------------------------------------ what is final

/// Where the edges from below are in the mesh; each has to be there: the triangle on its left is in
/// the triangulation of more points than these.
bool Part::findEdgesBelow(Ticker& ticker)
{
  TriangulationAccess::State& all = state();
  if (!all.hasPointMap && !all.makePointMap(ticker))
  {
    return false;
  }
  const Buffer<Index>& vertexOf = all.tables.vertexOf;
  EdgeTable<std::uint64_t> table(ticker);
  halfEdgesBelow_.assign(edgesBelow_.size(), kNoIndex);
  if (!table.begin(edgesBelow_.size()))
  {
    return false;
  }
  for (std::size_t i = 0; i != edgesBelow_.size(); ++i)
  {
    const BorderEdge& edge = edgesBelow_[i];
    if (!table.add(vertexOf[edge.from], vertexOf[edge.to], i) || !ticker.step())
    {
      return false;
    }
  }
  return eachSlot(ticker,
    [&](Mesh::Slot slot)
    {
      for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
      {
        const std::uint64_t* const edge = table.find(origin(h), destination(h));
        if (edge && vertexOf[edgesBelow_[*edge].from] == origin(h))
        {
          halfEdgesBelow_[*edge] = h;
        }
      }
    });
}

/// Floods from the left of the edges that were handed up, and never across one: their other side
/// is not final, or none.
bool Part::findBelow(Ticker& ticker)
{
  if (!begin(ticker) || !hasTriangles() || edgesBelow_.empty())
  {
    return !ticker.cancelled() && ticker.ask();
  }
  if (!findEdgesBelow(ticker))
  {
    return false;
  }
  Buffer<std::uint8_t> isWall; // bit e of each triangle: edge e was handed up
  isWall.allocate(slots_);
  if (!fillAll(isWall, std::uint8_t(0), ticker))
  {
    return false;
  }
  for (const Mesh::Halfedge h : halfEdgesBelow_)
  {
    assert(h != kNoIndex);
    isWall[h / Mesh::kSlotSize] = static_cast<std::uint8_t>(
      isWall[h / Mesh::kSlotSize] | 1u << (h & 3u));
    if (!ticker.step())
    {
      return false;
    }
  }
  const auto mayEnter = [&](Mesh::Halfedge h, Mesh::Slot next)
  {
    return (unsigned(isWall[h / Mesh::kSlotSize]) >> (h & 3u) & 1u) == 0 &&
      (label(next) & kBelow) == 0;
  };
  for (const Mesh::Halfedge h : halfEdgesBelow_)
  {
    if ((label(h) & kBelow) == 0 && !flood(Mesh::slotOf(h), kBelow, mayEnter, ticker))
    {
      return false;
    }
  }
  return true;
}

/// Is it open? Untouched: it is final.
SegmentTree::Answer Part::test(Mesh::Slot slot, const Neighborhood& near, Ticker& ticker) const
{
  const Corners corners = cornersOf(slot);
  const Circumdisc disc(corners);
  std::size_t steps = 1;
  if (!disc.isCertainlyWithin(near.freeBox) && near.around.boxes.isMet(disc, near.row, steps))
  {
    return ticker.step() ? SegmentTree::Answer::Touched : SegmentTree::Answer::Cancelled;
  }
  return ticker.step(std::min(steps, kStepsPerAsking / 2))
    ? near.around.segments.ask(corners, ticker)
    : SegmentTree::Answer::Cancelled;
}

/// Tests the triangle unless that was done, and those beside it if it is open, and so on.
bool Part::spread(Mesh::Slot from, const Neighborhood& near, Ticker& ticker)
{
  std::vector<Mesh::Slot> waiting{ from };
  while (!waiting.empty())
  {
    const Mesh::Slot slot = waiting.back();
    waiting.pop_back();
    std::uint8_t& own = labels_[slot / Mesh::kSlotSize];
    if ((own & (kTested | kOpen | kBelow)) != 0)
    {
      continue;
    }
    own |= kTested;
    const SegmentTree::Answer answer = test(slot, near, ticker);
    if (answer == SegmentTree::Answer::Cancelled)
    {
      return false;
    }
    if (answer == SegmentTree::Answer::Touched)
    {
      own |= kOpen;
      open_.push_back(slot);
      for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
      {
        waiting.push_back(Mesh::slotOf(twin(h)));
      }
    }
  }
  return true;
}

/// Where the bounds of other blocks do not overlap those of the row, only triangles are tested that
/// are at the hull or at an end of a segment, or beside an open one. The others are final.
///
/// Proof. Let q be a place in a closed disc of the triangulation, and in bounds that lie outside of
/// the hull. On the paraboloid, a hair below q, one sees the faces of the lower hull whose
/// triangles have q in their closed discs, and some ghosts; what one sees of a convex polytope is
/// connected. So from each such triangle a way across edges leads through such triangles to the
/// hull. And where a segment goes, one touched triangle follows the other, across an edge or around
/// a vertex, from an end of the segment or from the hull, as both ends are own vertices or outside
/// of it. Bounds that overlap by a little: the way from q to where they do not, straight and within
/// them, leaves the hull, and what has a place of it in closed discs changes along it to what is
/// next to it.
bool Part::findFinal(const BlockRow& row, const Surroundings& around, Ticker& ticker)
{
  const Bounds own = ids_ && hasTriangles() ? state().ranked.bounds : around.boxes.boundsOf(row);
  const Neighborhood near{ row, around, around.boxes.freeBoxOf(row, own) };
  const bool isApart = near.freeBox.xmin <= near.freeBox.xmax;
  const auto isEnd = [&](Index vertex)
  { return std::binary_search(ends_.begin(), ends_.end(), vertex); };
  const auto isSeed = [&](Mesh::Slot slot)
  {
    return !isApart || !ids_ || isEnd(data_[slot]) || isEnd(data_[slot + 1]) ||
      isEnd(data_[slot + 2]);
  };
  for (const Mesh::Slot ghost : ghosts_)
  {
    for (Mesh::Halfedge h = ghost; h != ghost + 3; ++h)
    {
      if (!spread(Mesh::slotOf(twin(h)), near, ticker))
      {
        return false;
      }
    }
  }
  const bool areMore = !isApart || !ids_ || !ends_.empty();
  for (std::size_t k = 0; areMore && k != slots_; ++k)
  {
    const Mesh::Slot slot = Mesh::slotOfTriangle(k);
    if (!ticker.step() || (isSeed(slot) && !spread(slot, near, ticker)))
    {
      return false;
    }
  }
  finalTriangles_ = slots_ - ghosts_.size() - open_.size();
  return ids_ || countFinal(ticker);
}

bool Part::finishAll(Ticker& ticker)
{
  const TriangulationAccess::State& all = state();
  isAnyDropped_ = all.report.triangles != all.allTriangles;
  const auto drop = [&](Mesh::Slot slot)
  {
    if ((all.constrained.marks(slot) & kDropped) != 0)
    {
      labels_[slot / Mesh::kSlotSize] |= kGone;
    }
  };
  return (!isAnyDropped_ || eachSlot(ticker, drop)) && countFinal(ticker);
}

bool Part::countFinal(Ticker& ticker)
{
  finalTriangles_ = 0;
  return eachSlot(
    ticker, [&](Mesh::Slot slot) { finalTriangles_ += isFinalAndKept(slot) ? 1u : 0u; });
}

} // namespace ahd
