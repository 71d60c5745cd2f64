// SPDX-License-Identifier: BSD-3-Clause
#include "Part.h"

#include "../Constrain/ConstrainedMesh.h"
#include "../Constrain/EdgeTable.h"
#include "../Core/Border.h"
#include "../Core/Loops.h"

#include <algorithm>
#include <cassert>

namespace ahd
{

/// Of the mesh as it is now: constraints change its triangles, not their number.
bool Part::begin(Ticker& ticker)
{
  const TriangulationAccess::State& all = state();
  slots_ = all.allTriangles == 0 ? 0 : all.mesh.end() / Mesh::kSlotSize;
  data_ = all.mesh.data();
  ghost_ = all.mesh.ghost();
  labels_.allocate(slots_);
  return fillAll(labels_, std::uint8_t(0), ticker);
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
  EdgeTable table(ticker);
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
        const EdgeTable::Edge* const edge = table.find(origin(h), destination(h));
        if (edge && vertexOf[edgesBelow_[edge->segment].from] == origin(h))
        {
          halfEdgesBelow_[edge->segment] = h;
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

bool Part::finalInShare(
  const BlockRow& row, const Surroundings& around, std::size_t begin, std::size_t end, Ticker& own)
{
  const Bounds freeBox = around.boxes.freeBoxOf(row);
  for (std::size_t k = begin; k != end; ++k)
  {
    const Mesh::Slot slot = Mesh::slotOfTriangle(k);
    std::size_t steps = 1;
    if ((labels_[k] & kBelow) == 0 && !isGhost(slot))
    {
      const Corners corners = cornersOf(slot);
      const Circumdisc disc(corners);
      if (disc.isCertainlyWithin(freeBox) || !around.boxes.isMet(disc, row, steps))
      {
        const SegmentTree::Answer answer = around.segments.ask(corners, own);
        if (answer == SegmentTree::Answer::Cancelled)
        {
          return false;
        }
        labels_[k] |= answer == SegmentTree::Answer::Untouched ? kFinal : 0;
      }
    }
    if (!own.step(std::min(steps, kStepsPerAsking / 2)))
    {
      return false;
    }
  }
  return true;
}

bool Part::findFinal(const BlockRow& row, const Surroundings& around, Ticker& ticker)
{
  const std::size_t tasks = tasksForLoop(ticker, slots_);
  return ticker.ask() &&
    inParallel(ticker, tasks,
      [&](std::size_t task, Ticker& own)
      {
        const Share share(slots_, task, tasks);
        return finalInShare(row, around, share.begin, share.end, own);
      }) &&
    countFinal(ticker);
}

bool Part::finishAll(Ticker& ticker)
{
  const TriangulationAccess::State& all = state();
  isAnyDropped_ = all.report.triangles != all.allTriangles;
  const auto finish = [&](Mesh::Slot slot)
  {
    std::uint8_t& own = labels_[slot / Mesh::kSlotSize];
    const bool isGone = isAnyDropped_ && (all.constrained.marks(slot) & kDropped) != 0;
    own = static_cast<std::uint8_t>(
      own | ((own & kBelow) == 0 ? kFinal : 0) | (isGone ? kGone : 0));
  };
  return eachSlot(ticker, finish) && countFinal(ticker);
}

bool Part::countFinal(Ticker& ticker)
{
  finalTriangles_ = 0;
  return eachSlot(ticker,
    [&](Mesh::Slot slot)
    { finalTriangles_ += (label(slot) & (kFinal | kGone)) == kFinal ? 1u : 0u; });
}

} // namespace ahd
