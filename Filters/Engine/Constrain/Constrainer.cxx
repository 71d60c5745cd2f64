// SPDX-License-Identifier: BSD-3-Clause
#include "Constrainer.h"

#include "../Core/Chunks.h"
#include "../Core/SortAsking.h"
#include "InCurveOrder.h"

#include <algorithm>
#include <functional>

namespace ahd
{

Constrainer::Constrainer(ConstrainedMesh& mesh, const Buffer<Index>& rankOf, Ticker& ticker)
  : mesh_(mesh)
  , rankOf_(rankOf.data())
  , points_(rankOf.size())
  , ticker_(ticker)
  , grown_(ticker)
  , walk_(mesh, ticker)
  , cavity_(mesh, ticker)
  , rows_(mesh, ticker)
  , users_(ticker)
  , loopEdges_(ticker)
{
}

bool Constrainer::insertAll(const ConstraintView& constraints, std::size_t vertices, FillRule rule)
{
  constraints_ = constraints;
  rule_ = rule;
  InCurveOrder curve(mesh_, rankOf_, points_, ticker_);
  if (!curve.insertAll(constraints) || !begin(vertices))
  {
    return false;
  }
  edges_ = curve.edges();
  for (std::size_t chain = 0; chain < constraints.chains; ++chain)
  {
    firstSegment_.push_back(segment_);
    if (!ticker_.step() || !insertChain(chain, curve))
    {
      return false;
    }
  }
  report_.segments = segment_;
  report_.crossing = report_.leftOut.size();
  report_.edges = edges_;
  return true;
}

/// Room for all segments, or loops.
bool Constrainer::begin(std::size_t vertices)
{
  firstSegment_.reserve(constraints_.chains);
  const std::int64_t* const offsets = constraints_.offsets;
  const std::size_t chains = constraints_.chains;
  const std::size_t ofLoops = chains <= constraints_.lines
    ? 0
    : static_cast<std::size_t>(offsets[chains] - offsets[constraints_.lines]);
  return users_.begin(0) && loopEdges_.begin(std::min(ofLoops, 3 * vertices));
}

bool Constrainer::insertChain(std::size_t chain, const InCurveOrder& curve)
{
  const std::int64_t* const ids = constraints_.ids + constraints_.offsets[chain];
  const std::size_t count = static_cast<std::size_t>(
    constraints_.offsets[chain + 1] - constraints_.offsets[chain]);
  const auto place = static_cast<std::size_t>(
    constraints_.offsets[chain] - constraints_.offsets[0]);
  isLoop_ = chain >= constraints_.lines && haveThreeVertices(ids, count);
  loop_.clear();
  bool isWhole = true;
  const std::size_t segments = segmentsOf(constraints_, chain);
  for (std::size_t i = 0; i < segments; ++i, ++segment_)
  {
    const std::int64_t* const to = i + 1 == count ? ids : ids + i + 1;
    const bool isMade = curve.isEdge(place + i) || (!isLoop_ && curve.isRow(place + i));
    const Outcome outcome = isMade ? useEdge(ids[i], *to) : insertSegment(ids + i, *to);
    if (outcome == Outcome::Cancelled || !ticker_.step())
    {
      return false;
    }
    isWhole = isWhole && outcome != Outcome::Missing;
    ticker_.finished(1);
  }
  bool isNew = false;
  if (isLoop_ && isWhole && !(isNewLoop(isNew) && (!isNew || useLoop())))
  {
    return false;
  }
  report_.unfilledLoops += isLoop_ && !isWhole ? 1 : 0;
  return true;
}

/// Do these ids name at least three different vertices, counting ids without one as one? A loop
/// with fewer bounds nothing.
bool Constrainer::haveThreeVertices(const std::int64_t* ids, std::size_t count) const
{
  if (count == 0)
  {
    return false;
  }
  const Index first = vertexOf(ids[0]);
  Index second = first;
  for (std::size_t i = 1; i < count; ++i)
  {
    const Index next = vertexOf(ids[i]);
    if (next != first && second != first && next != second)
    {
      return true;
    }
    second = second == first ? next : second;
  }
  return false;
}

/// Prefetches for the segments soon to come, step by step, as each address depends on the one
/// before: the vertex of an id, a triangle of the vertex, that triangle, its neighbours, and
/// theirs. Segments in random order then cost less than half. `ids` begins with an id of the
/// current segment.
void Constrainer::prefetch(const std::int64_t* ids) const
{
  constexpr std::ptrdiff_t kVertex = 40, kSlot = 32, kTriangle = 24, kNeighbours = 16, kRing = 8;
  const std::ptrdiff_t rest = constraints_.ids + constraints_.offsets[constraints_.chains] - ids;
  if (rest > kVertex && std::uint64_t(ids[kVertex]) < points_)
  {
    prefetchForRead(rankOf_ + ids[kVertex]);
  }
  const auto vertexAt = [&](std::ptrdiff_t ahead)
  { return rest > ahead ? vertexOf(ids[ahead]) : kNoIndex; };
  const auto slotAt = [&](std::ptrdiff_t ahead)
  {
    const Index vertex = vertexAt(ahead);
    return vertex == kNoIndex ? kNoIndex : mesh_.slotOf(vertex);
  };
  if (const Index vertex = vertexAt(kSlot); vertex != kNoIndex)
  {
    prefetchForRead(mesh_.placeOfSlot(vertex));
    prefetchForRead(mesh_.places() + vertex);
  }
  if (const Mesh::Slot slot = slotAt(kTriangle); slot != kNoIndex)
  {
    prefetchForRead(mesh_.data() + slot);
  }
  if (const Mesh::Slot slot = slotAt(kNeighbours); slot != kNoIndex)
  {
    for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
    {
      prefetchForRead(mesh_.data() + Mesh::slotOf(mesh_.twin(h)));
      prefetchForRead(mesh_.places() + mesh_.apex(h));
    }
  }
  if (const Index vertex = vertexAt(kRing); vertex != kNoIndex && mesh_.isInMesh(vertex))
  {
    const Mesh::Halfedge left = mesh_.nextAround(mesh_.outgoing(vertex));
    const Mesh::Halfedge right = mesh_.previousAround(mesh_.outgoing(vertex));
    prefetchForRead(mesh_.data() + Mesh::slotOf(mesh_.nextAround(left)));
    prefetchForRead(mesh_.data() + Mesh::slotOf(mesh_.previousAround(right)));
    prefetchForRead(mesh_.places() + mesh_.apex(left));
    prefetchForRead(mesh_.places() + mesh_.destination(right));
  }
}

Index Constrainer::vertexOf(std::int64_t id) const
{
  return std::uint64_t(id) < points_ ? rankOf_[id] : kNoIndex;
}

/// The segment is an edge already, or no loop's and a row of edges.
Constrainer::Outcome Constrainer::useEdge(std::int64_t fromId, std::int64_t toId)
{
  if (isLoop_)
  {
    grown_.add(loop_, std::make_pair(vertexOf(fromId), vertexOf(toId)));
  }
  return Outcome::IsEdge;
}

Constrainer::Outcome Constrainer::insertSegment(const std::int64_t* fromId, std::int64_t toId)
{
  prefetch(fromId + 1);
  const Index from = vertexOf(*fromId);
  const Index to = vertexOf(toId);
  if (from == kNoIndex || to == kNoIndex || !mesh_.isInMesh(from) || !mesh_.isInMesh(to))
  {
    ++report_.withoutVertex;
    return Outcome::Missing;
  }
  if (from == to)
  {
    ++report_.points;
    return Outcome::IsPoint;
  }
  walk_.passRows(isLoop_ ? nullptr : &rows_); // each edge of a loop counts
  switch (walk_.walk(from, to))
  {
    case SegmentWalk::Outcome::Blocked:
      return leaveOut(walk_.blockedBy());
    case SegmentWalk::Outcome::Cancelled:
      return Outcome::Cancelled;
    default:
      return makeEdges(walk_.start() == from) ? Outcome::IsEdge : Outcome::Cancelled;
  }
}

Constrainer::Outcome Constrainer::leaveOut(Mesh::Halfedge crossed)
{
  const auto left = find(segment_);
  const auto other = find(*users_.find(mesh_.origin(crossed), mesh_.destination(crossed)));
  grown_.add(report_.leftOut, LeftOut{ left.first, left.second, other.first, other.second });
  return Outcome::Missing;
}

/// Chain and number of a segment.
std::pair<std::size_t, std::size_t> Constrainer::find(std::uint64_t segment) const
{
  // The last chain that begins there or before: chains without segments begin where the next does.
  const auto after = std::upper_bound(firstSegment_.begin(), firstSegment_.end(), segment);
  const std::size_t chain = static_cast<std::size_t>(after - firstSegment_.begin()) - 1;
  return { chain, static_cast<std::size_t>(segment - firstSegment_[chain]) };
}

/// The pieces of the walk become edges: cavities do not overlap, and no triangle of an edge on the
/// segment is in one.
bool Constrainer::makeEdges(bool isForward)
{
  for (const WalkPiece& piece : walk_.pieces())
  {
    Mesh::Halfedge edge = piece.edge;
    if (edge == kNoIndex)
    {
      const Mesh::Halfedge* const crossed = walk_.crossed().data() + piece.begin;
      if (!cavity_.fill(piece.from, piece.to, crossed, piece.end - piece.begin))
      {
        return false;
      }
      edge = cavity_.made();
    }
    if (!markEdge(edge, isForward))
    {
      return false;
    }
  }
  const std::vector<WalkPiece>& pieces = walk_.pieces();
  return rows_.remember(pieces.data(), pieces.data() + pieces.size());
}

bool Constrainer::markEdge(Mesh::Halfedge h, bool isForward)
{
  const Index from = mesh_.origin(h), to = mesh_.destination(h);
  if (!mesh_.isConstrained(h))
  {
    mesh_.constrain(h);
    mesh_.constrain(mesh_.twin(h));
    ++edges_;
    if (users_.add(from, to, segment_) == nullptr)
    {
      return false;
    }
  }
  if (isLoop_)
  {
    grown_.add(loop_, isForward ? std::make_pair(from, to) : std::make_pair(to, from));
  }
  return ticker_.step();
}

/// Loops with the same edges count once where the number of loops decides.
bool Constrainer::isNewLoop(bool& isNew)
{
  isNew = true;
  if (rule_ != FillRule::EvenOdd || constraints_.chains - constraints_.lines < 2)
  {
    return true;
  }
  constexpr std::size_t kFew = 256, kPerLoop = 80; // bytes of a node with its vector
  if (std::max(loop_.size(), loops_.size()) >= kFew)
  {
    grown_.take(kPerLoop + 2 * sizeof(std::uint64_t) * loop_.size());
  }
  std::vector<std::uint64_t> edges;
  edges.reserve(loop_.size());
  for (const auto& step : loop_)
  {
    edges.push_back(LoopEdges::keyOf(step.first, step.second));
  }
  if (!sortAsking(edges, ticker_, std::less<std::uint64_t>()))
  {
    return false;
  }
  isNew = loops_.insert(std::move(edges)).second;
  return true;
}

bool Constrainer::useLoop()
{
  for (const auto& step : loop_)
  {
    std::int64_t* const balance = loopEdges_.add(step.first, step.second, 0);
    if (balance == nullptr || !ticker_.step())
    {
      return false;
    }
    *balance += step.first < step.second ? 1 : -1;
    anyLoop_ = true;
  }
  return true;
}

} // namespace ahd
