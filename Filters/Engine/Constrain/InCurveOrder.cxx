// SPDX-License-Identifier: BSD-3-Clause
#include "InCurveOrder.h"

#include "../Core/Chunks.h"
#include "../Core/Tasks.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace ahd
{

namespace
{

/// The vertices in blocks: of so many that the triangles around them stay in the cache, and more
/// where there would be too many blocks to count by.
struct Blocks
{
  explicit Blocks(std::size_t vertices)
    : shift(std::max(10u, bitLength(vertices) - std::min(bitLength(vertices), 12u)))
    , count((vertices >> shift) + 1)
  {
  }
  std::size_t of(Index vertex) const { return vertex >> shift; }

  unsigned shift;
  std::size_t count;
};

} // namespace

/// Calls visit(place, from, to) for each segment that begins at one of these places, with its two
/// vertices or kNoIndex.
template <typename Visit>
bool InCurveOrder::eachSegment(const Share& places, Ticker& ticker, Visit visit) const
{
  const std::int64_t* const offsets = constraints_.offsets;
  const std::int64_t first = offsets[0];
  const auto place = static_cast<std::int64_t>(places.begin);
  const auto end = static_cast<std::int64_t>(places.end);
  const std::int64_t* next = std::upper_bound(
    offsets, offsets + constraints_.chains, first + place);
  for (std::int64_t i = first + place; i != first + end; ++next)
  {
    const std::int64_t begin = next[-1];
    const bool isClosed = std::size_t(next - offsets) > constraints_.lines && *next - begin > 1 &&
      constraints_.ids[begin] != constraints_.ids[*next - 1];
    Index from = i == *next ? kNoIndex : vertexOf(constraints_.ids[i]);
    for (; i != std::min(*next, first + end); ++i)
    {
      const bool isLast = i + 1 == *next;
      const Index to = isLast && !isClosed ? kNoIndex
                                           : vertexOf(constraints_.ids[isLast ? begin : i + 1]);
      visit(static_cast<std::size_t>(i - first), from, to);
      from = to;
      if (!ticker.step())
      {
        return false;
      }
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

/// Lists the segments block by block.
bool InCurveOrder::sort(std::size_t places)
{
  constexpr std::size_t kLeastTask = std::size_t(1) << 14;
  const Blocks blocks(std::size_t(mesh_.ghost()) + 1);
  const std::size_t tasks = tasksFor(threadsOf(ticker_), places, 1, kLeastTask);
  Buffer<std::uint32_t> ends;
  ends.allocate(tasks * blocks.count);
  std::fill(ends.begin(), ends.end(), 0u);
  const auto eachOf = [&](std::size_t task, Ticker& own, auto visit)
  {
    std::uint32_t* const mine = ends.data() + task * blocks.count;
    return eachSegment(Share(places, task, tasks), own,
      [&](std::size_t place, Index from, Index to)
      {
        became_[place] = kNothing;
        if (from != kNoIndex && to != kNoIndex && from != to)
        {
          visit(mine[blocks.of(from)], Segment{ from, to, static_cast<std::uint32_t>(place) });
        }
      });
  };
  const auto count = [&](std::size_t task, Ticker& own)
  { return eachOf(task, own, [](std::uint32_t& end, const Segment&) { ++end; }); };
  const auto place = [&](std::size_t task, Ticker& own)
  {
    return eachOf(
      task, own, [&](std::uint32_t& end, const Segment& segment) { segments_[end++] = segment; });
  };
  if (!inParallel(ticker_, tasks, count))
  {
    return false;
  }
  std::uint32_t sum = 0;
  for (std::size_t block = 0; block < blocks.count; ++block)
  {
    for (std::size_t task = 0; task < tasks; ++task)
    {
      std::uint32_t& begin = ends[task * blocks.count + block];
      sum += std::exchange(begin, sum);
    }
    if (!ticker_.step(tasks))
    {
      return false;
    }
  }
  segments_.allocate(sum);
  if (!inParallel(ticker_, tasks, place))
  {
    return false;
  }
  divide(ends.data() + (tasks - 1) * blocks.count, blocks.count, blocks.shift);
  return true;
}

/// Territories with about the same number of segments each. `blockEnds`: of the segments of each
/// block.
void InCurveOrder::divide(const std::uint32_t* blockEnds, std::size_t blocks, unsigned shift)
{
  constexpr std::size_t kPerThread = 4;
  const std::size_t count = tasksFor(
    threadsOf(ticker_), segments_.size(), kPerThread, kLeastInTerritory);
  territories_.resize(count + 2);
  for (std::size_t k = 1; k <= count; ++k)
  {
    const std::uint32_t wanted = static_cast<std::uint32_t>(
      Share(segments_.size(), k, count).begin);
    const std::size_t block = static_cast<std::size_t>(
      std::lower_bound(blockEnds, blockEnds + blocks, wanted) - blockEnds);
    territories_[k].begin = k == count ? segments_.size() : blockEnds[block];
    territories_[k].firstVertex = k == count
      ? mesh_.ghost()
      : static_cast<Index>(std::min<std::size_t>((block + 1) << shift, mesh_.ghost()));
  }
}

/// Prefetches for the segments soon to come, step by step, as each address depends on the one
/// before. Reads only triangles around their first vertices.
void InCurveOrder::prefetch(const Segment* segment, const Segment* end) const
{
  constexpr std::ptrdiff_t kSlot = 24, kTriangle = 16, kNeighbours = 8;
  const std::ptrdiff_t last = end - segment - 1;
  const auto from = [=](std::ptrdiff_t ahead) { return segment[std::min(ahead, last)].from; };
  prefetchForRead(mesh_.placeOfSlot(from(kSlot)));
  if (const Mesh::Slot slot = mesh_.slotOf(from(kTriangle)); slot != kNoIndex)
  {
    prefetchForRead(mesh_.data() + slot);
    prefetchForRead(mesh_.places() + from(kTriangle));
  }
  const Index near = from(kNeighbours);
  if (const Mesh::Slot slot = mesh_.slotOf(near); slot != kNoIndex)
  {
    for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
    {
      if (mesh_.apex(h) != near) // the edge opposite may be that of others
      {
        prefetchForRead(mesh_.data() + Mesh::slotOf(mesh_.twin(h)));
      }
    }
  }
}

/// Turns the walked segments into edges.
bool InCurveOrder::makeEdges(Work& work, Territory& territory)
{
  const std::vector<WalkPiece>& pieces = work.walk.pieces();
  bool isNewRow = true;
  for (const WalkPiece& piece : pieces)
  {
    Mesh::Halfedge edge = piece.edge;
    if (edge == kNoIndex)
    {
      const Mesh::Halfedge* const crossed = work.walk.crossed().data() + piece.begin;
      if (!work.cavity.fill(piece.from, piece.to, crossed, piece.end - piece.begin))
      {
        return false;
      }
      edge = work.cavity.made();
    }
    if (mesh_.isConstrained(edge))
    {
      isNewRow = true;
      continue;
    }
    mesh_.constrain(edge);
    mesh_.constrain(mesh_.twin(edge));
    ++territory.edges;
    if (piece.edge != kNoIndex && !work.isLate)
    {
      isNewRow = true;
    }
    else if (isNewRow)
    {
      grown_.add(territory.made, Made{ piece.from, piece.to });
      isNewRow = false;
    }
    else
    {
      territory.made.back().to = piece.to;
    }
  }
  return work.rows.remember(pieces.data(), pieces.data() + pieces.size());
}

InCurveOrder::Outcome InCurveOrder::insert(const Segment& segment, Work& work, Territory& territory)
{
  switch (work.walk.walk(segment.from, segment.to))
  {
    case SegmentWalk::Outcome::Beyond:
      return Outcome::Beyond;
    case SegmentWalk::Outcome::Long:
      return Outcome::Long;
    case SegmentWalk::Outcome::Blocked:
      return Outcome::Crosses;
    case SegmentWalk::Outcome::Cancelled:
      return Outcome::Cancelled;
    default:
      break;
  }
  const std::vector<WalkPiece>& pieces = work.walk.pieces();
  became_[segment.place] = pieces.size() == 1 && !work.rows.isRow(pieces[0]) ? kEdge : kRow;
  return makeEdges(work, territory) ? Outcome::Done : Outcome::Cancelled;
}

/// Segments [begin, end), but for those that leave the walk's territory, are long or cross others.
/// Returns false if cancelled.
bool InCurveOrder::insert(
  const Segment* begin, const Segment* end, Work& work, Territory& territory, Ticker& ticker)
{
  const auto mostCrossing = [begin](const Segment* now)
  { return kCrossingAtLeast + static_cast<std::size_t>(now - begin) / kMostCrossing; };
  for (const Segment* now = begin; now != end && !gaveUp_.load(std::memory_order_relaxed); ++now)
  {
    const Segment& segment = *now;
    prefetch(now, end);
    const bool isOwn = work.walk.isOwn(segment.to);
    if (!isOwn || areInMesh(segment))
    {
      switch (isOwn ? insert(segment, work, territory) : Outcome::Beyond)
      {
        case Outcome::Done:
          ticker.finished(1);
          break;
        case Outcome::Beyond:
          grown_.add(territory.left, segment);
          break;
        case Outcome::Long:
          grown_.add(territory.late, segment);
          break;
        case Outcome::Crosses:
          grown_.add(territory.crossing, segment);
          if (territory.crossing.size() > mostCrossing(now))
          {
            gaveUp_ = true; // and never false: other threads may set it meanwhile
          }
          break;
        default:
          return false;
      }
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

/// Territory by territory, then segments that leave these, then long ones.
bool InCurveOrder::insertSorted()
{
  const std::size_t count = territories_.size() - 2;
  const auto insertOwn = [&](std::size_t k, Ticker& ticker)
  {
    Work work(mesh_, ticker);
    work.walk.crossAtMost(kMostInOrder);
    if (count > 1)
    {
      work.walk.limitTo(territories_[k].firstVertex, territories_[k + 1].firstVertex);
    }
    // On a local one: no false sharing.
    Territory own;
    own.made.reserve(territories_[k + 1].begin - territories_[k].begin); // mostly
    const bool done = insert(segments_.data() + territories_[k].begin,
      segments_.data() + territories_[k + 1].begin, work, own, ticker);
    territories_[k].edges = own.edges;
    territories_[k].left = std::move(own.left);
    territories_[k].late = std::move(own.late);
    territories_[k].crossing = std::move(own.crossing);
    territories_[k].made = std::move(own.made);
    return done;
  };
  return inParallel(ticker_, count, insertOwn) && insertLeft() && insertLate();
}

bool InCurveOrder::insertLeft()
{
  std::vector<Segment> left;
  Work work(mesh_, ticker_);
  work.walk.crossAtMost(kMostInOrder);
  return gather(&Territory::left, left) &&
    insert(
      left.data(), left.data() + left.size(), work, territories_[territories_.size() - 2], ticker_);
}

bool InCurveOrder::insertLate()
{
  std::vector<Segment> late;
  Work work(mesh_, ticker_);
  work.isLate = true;
  return gather(&Territory::late, late) && inRounds(late) &&
    insert(late.data(), late.data() + late.size(), work, territories_.back(), ticker_);
}

/// The round of a segment, from the last one on: half of all are in round 0, a quarter in round 1,
/// and so on.
unsigned InCurveOrder::roundOf(const Segment& segment)
{
  std::uint64_t bits = (segment.place + std::uint64_t(1)) * 0x9E3779B97F4A7C15u;
  bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9u;
  bits ^= bits >> 27;
  unsigned round = 0;
  while (round + 1 != kRounds && (bits >> round & 1) != 0)
  {
    ++round;
  }
  return round;
}

/// The first round first, each in the order that they had.
bool InCurveOrder::inRounds(std::vector<Segment>& segments)
{
  std::size_t begins[kRounds + 1] = {};
  const auto count = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      ++begins[kRounds - roundOf(segments[i])];
    }
  };
  grown_.take(sizeof(Segment) * segments.size());
  std::vector<Segment> ordered(segments.size());
  const auto place = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      ordered[begins[kRounds - 1 - roundOf(segments[i])]++] = segments[i];
    }
  };
  if (!inChunks(0, segments.size(), ticker_, count))
  {
    return false;
  }
  std::partial_sum(begins, begins + kRounds, begins);
  if (!inChunks(0, segments.size(), ticker_, place))
  {
    return false;
  }
  segments = std::move(ordered);
  return true;
}

/// Moves all territories' segments of one kind into one list.
bool InCurveOrder::gather(std::vector<Segment> Territory::*kind, std::vector<Segment>& all)
{
  std::size_t count = 0;
  for (const Territory& territory : territories_)
  {
    count += (territory.*kind).size();
  }
  grown_.take(sizeof(Segment) * count);
  all.reserve(count);
  for (Territory& territory : territories_)
  {
    std::vector<Segment>& some = territory.*kind;
    const auto add = [&](std::size_t a, std::size_t b)
    { all.insert(all.end(), some.data() + a, some.data() + b); };
    if (!inChunks(0, some.size(), ticker_, add))
    {
      return false;
    }
    some = std::vector<Segment>(); // = {} would keep its memory
  }
  return true;
}

bool InCurveOrder::insertAll(const ConstraintView& constraints)
{
  constraints_ = constraints;
  const std::size_t places = constraints.chains == 0
    ? 0
    : static_cast<std::size_t>(constraints.offsets[constraints.chains] - constraints.offsets[0]);
  if (places == 0 || places > std::numeric_limits<std::uint32_t>::max())
  {
    return true;
  }
  became_.allocate(places);
  if (!sort(places) || !insertSorted())
  {
    return false;
  }
  for (const Territory& territory : territories_)
  {
    edges_ += territory.edges;
  }
  if (!gaveUp_ && !takeOutCrossed())
  {
    return false;
  }
  segments_.reset();
  if (gaveUp_)
  {
    became_.reset();
    return undo();
  }
  territories_.clear();
  return true;
}

} // namespace ahd
