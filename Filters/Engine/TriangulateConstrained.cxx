// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulate.h"

#include "Constrain/Constrainer.h"
#include "Constrain/InCurveOrder.h"
#include "Constrain/Regions.h"
#include "Constrain/Rim.h"
#include "Core/Border.h"
#include "Triangulation/State.h"

#include <algorithm>
#include <utility>

namespace ahd
{

namespace
{

using State = TriangulationAccess::State;

bool insertConstraints(State& state, const ConstraintView& given, FillRule rule, Ticker& ticker)
{
  state.tables.corners.reset();
  state.tables.twins.reset();
  state.tables.starts.reset();
  state.hasNumbers = state.hasCorners = state.hasTwins = state.hasNeighbors = false;
  if (!state.restorePlaces(ticker) || !(state.hasPointMap || state.makePointMap(ticker)) ||
    !state.constrained.begin(state.mesh, state.ranked.xy.data(), ticker) ||
    !state.constrained.findVertices(ticker))
  {
    return false;
  }
  state.hasMarks = true;
  Constrainer constrainer(state.constrained, state.tables.vertexOf, ticker);
  if (!constrainer.insertAll(given, state.report.inserted, rule))
  {
    return false;
  }
  std::size_t dropped = 0;
  if (constrainer.anyLoop() &&
    !dropOutside(state.constrained, constrainer.edges(), rule, ticker, dropped))
  {
    return false;
  }
  state.report.triangles -= dropped;
  state.constraints = constrainer.takeReport();
  return ticker.ask();
}

/// Without triangles no segment can become an edge.
bool countMissing(State& state, const ConstraintView& given, Ticker& ticker)
{
  for (std::size_t chain = 0; chain < given.chains; ++chain)
  {
    const std::size_t segments = segmentsOf(given, chain);
    state.constraints.segments += segments;
    state.constraints.withoutVertex += segments;
    state.constraints.unfilledLoops += chain >= given.lines && segments > 0 ? 1 : 0;
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

bool constrainState(
  State& state, const ConstraintView& given, FillRule rule, const Context& context)
{
  const std::size_t ids = given.chains == 0
    ? 0
    : static_cast<std::size_t>(given.offsets[given.chains] - given.offsets[0]);
  Ticker ticker(context.progress, Phase::Constrain, ids, state.worthItsWhile(context.executor));
  return state.report.triangles == 0 ? countMissing(state, given, ticker)
                                     : insertConstraints(state, given, rule, ticker);
}

bool trimState(State& state, const Context& context)
{
  if (state.report.triangles == 0)
  {
    return true;
  }
  Ticker ticker(context.progress, Phase::Outputs, 0);
  TrimmedRim trimmed;
  if (!state.restorePlaces(ticker) ||
    !(state.hasMarks || state.constrained.begin(state.mesh, state.ranked.xy.data(), ticker)) ||
    !trimRim(state.constrained, ticker, trimmed))
  {
    return false;
  }
  state.hasMarks = state.hasMarks || trimmed.triangles > 0;
  state.report.triangles -= trimmed.triangles;
  state.report.trimmed += trimmed.triangles;
  state.report.bareVertices += trimmed.bareVertices;
  state.report.trimmedArea += trimmed.area;
  return (!state.hasCorners || state.makeFlags(ticker)) && ticker.ask();
}

/// Is one of the first `count` points at the place of a corner of a kept triangle?
bool findKept(const State& state, std::size_t count, Ticker& ticker, bool& found)
{
  std::vector<bool> isKept(state.points.count, false); // of vertices: a corner of a kept triangle
  for (std::size_t k = 0; k < state.constrained.triangles(); ++k)
  {
    const Mesh::Slot slot = Mesh::slotOfTriangle(k);
    if (!ticker.step())
    {
      return false;
    }
    if (state.constrained.isGhost(slot) || (state.marksOf(k) & kDropped) != 0)
    {
      continue;
    }
    for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
    {
      const Index vertex = state.constrained.apex(h);
      isKept[vertex] = true;
      found = found || state.ranked.id[vertex] < count;
    }
    if (found)
    {
      return true;
    }
  }
  // others may stand for them
  for (std::size_t i = 0; i < count && !found; ++i)
  {
    const Index vertex = state.tables.vertexOf[i];
    found = vertex != kNoIndex && isKept[vertex];
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

/// Makes one triangulation from another, which is consumed; `change` returns false if cancelled.
template <typename Change>
Status makeOf(Triangulation&& from, Triangulation& out, Change change)
{
  TriangulationAccess::StatePointer state = std::move(TriangulationAccess::stateOf(from));
  out = Triangulation();
  const Status status = unlessCancelled(
    [&]
    {
      state.reset(state ? state.release() : new State);
      return change(*state);
    });
  if (status == Status::Ok)
  {
    TriangulationAccess::stateOf(out) = std::move(state);
  }
  return status;
}

} // namespace

Status constrain(Triangulation&& delaunay, const ConstraintView& constraints, FillRule rule,
  const Context& context, Triangulation& out)
{
  return makeOf(std::move(delaunay), out,
    [&](State& state) { return constrainState(state, constraints, rule, context); });
}

Status keepsAnyOf(const Triangulation& made, std::size_t count, const Context& context, bool& found)
{
  found = false;
  const State* const state = TriangulationAccess::stateOf(made);
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      return !state || state->report.triangles == 0 || findKept(*state, count, ticker, found);
    });
}

Status trim(Triangulation&& whole, const Context& context, Triangulation& out)
{
  return makeOf(std::move(whole), out, [&](State& state) { return trimState(state, context); });
}

std::size_t constraintMemoryEstimate(std::size_t pointCount, std::size_t segmentCount)
{
  // An array that grows by doubling may hold three times what it needs while it is copied.
  constexpr std::size_t kGrown = 3;
  // Per point: a vertex for each id, a triangle for each vertex, two marks, and a queue of two
  // triangles.
  constexpr std::size_t kPerPoint = 4 + 4 + 2 + 8;
  // Per edge: four places in the table of loops' edges, which has room for them from the beginning,
  // and six in that of edges that cross, which holds the smaller one while it grows.
  constexpr std::size_t kPerEdge = (4 + 6) * sizeof(LoopEdges::Edge);
  // Per segment: a row of the report, an edge of a loop, the beginning of a chain, flags for ids
  // that begin edges.
  constexpr std::size_t kPerSegment = kGrown * (sizeof(LeftOut) + 8) + 8 + 2;
  const std::size_t inOrder = std::min(segmentCount, 3 * pointCount) * kPerEdge +
    segmentCount * kPerSegment;
  const std::size_t alongCurve = segmentCount * InCurveOrder::bytesPerSegment() +
    InCurveOrder::bytesAtLeast();
  return pointCount * kPerPoint + (segmentCount == 0 ? 0 : std::max(inOrder, alongCurve));
}

std::size_t knownConstraintMemory(std::size_t pointCount, std::size_t segmentCount)
{
  // Per point as above; per segment the beginning of a chain. For each thread, small amounts: short
  // lists, and a count for each block of vertices.
  constexpr std::size_t kPerPoint = 4 + 4 + 2 + 8, kSmall = std::size_t(1) << 16;
  return pointCount * kPerPoint +
    (segmentCount == 0 ? 0 : segmentCount * (InCurveOrder::knownBytesPerSegment() + 8) + kSmall);
}

std::size_t trimMemoryEstimate(std::size_t pointCount)
{
  // Per point: a triangle, two marks, a byte, and a list of two triangles as it grows.
  return pointCount * (4 + 2 + 1 + 3 * 2 * 4) + 4096;
}

std::size_t tableMemoryEstimate(std::size_t pointCount)
{
  // Per point, with two triangles each: numbers, corners, flags and neighbours of these, a
  // half-edge, a vertex. While triangles are numbered, a key for each in new memory, and again
  // where thousands have their lowest corners near to each other; while regions are, the place of
  // each among the cells, a set, and at most as many sets, with three numbers each.
  constexpr std::size_t kKept = 8 + 24 + 2 + 24 + 4 + 4;
  constexpr std::size_t kNumbering = 16 + 16, kRegions = 8 + 8 + 2 * 12;
  constexpr std::size_t kPerPoint = kKept + std::max(kNumbering, kRegions);
  return pointCount * kPerPoint + 4096;
}

} // namespace ahd
