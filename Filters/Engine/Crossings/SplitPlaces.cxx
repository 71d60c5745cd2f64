// SPDX-License-Identifier: BSD-3-Clause
//
// Splitting: the points at the places that segments pass through.
#include "../Core/Chunks.h"
#include "../Order/RadixSort.h"
#include "Splitter.h"

#include <algorithm>
#include <utility>

namespace ahd
{

/// A segment, and its ends in its direction.
struct Splitter::Named
{
  Index position;
  SegmentName name;
  Way way;
};

/// Two segments cross at the place: they may be the first ones.
void Splitter::nameSegments(PlaceTable::Place& place, Index a, Index b) const
{
  const bool isOnly = place.first == kNoIndex;
  const std::pair<Index, Index> pair = std::minmax({ a, b });
  if (pair < std::make_pair(place.first, place.second))
  {
    place.first = pair.first;
    place.second = pair.second;
  }
  if (isOnly || comesBeforeByPlaces({ a, b }, { place.lower, place.upper }))
  {
    place.lower = a;
    place.upper = b;
  }
}

/// Does a pair of segments come before another one, by the places of their ends alone?
bool Splitter::comesBeforeByPlaces(std::array<Index, 2> pair, std::array<Index, 2> other) const
{
  const auto endsOf = [&](const std::array<Index, 2>& positions)
  {
    std::array<Segment, 2> ends = { { wayOf(nameOf(positions[0])).leftToRight(),
      wayOf(nameOf(positions[1])).leftToRight() } };
    if (comesBefore(ends[1], ends[0]))
    {
      std::swap(ends[0], ends[1]);
    }
    return ends;
  };
  const auto ends = endsOf(pair), others = endsOf(other);
  return comesBefore(ends[0], others[0]) ||
    (!comesBefore(others[0], ends[0]) && comesBefore(ends[1], others[1]));
}

/// The ids of points that are at the places that are new.
bool Splitter::findIds()
{
  if (named_ == places_.size())
  {
    return true;
  }
  const auto choose = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      PlaceTable::Place& place = places_[static_cast<Index>(k)];
      place.id = place.endId != kNoIndex ? place.endId : place.pointId;
    }
  };
  return findEnds() && findPoints() && inChunks(named_, places_.size(), ticker_, choose);
}

/// Ends are those of the segments given: all others are in the table, as pieces are led through
/// them.
bool Splitter::findEnds()
{
  const auto look = [&](const Point& p, Index id)
  {
    const Index number = places_.find(p);
    if (number != kNoIndex && number >= named_)
    {
      places_[number].endId = std::min(places_[number].endId, id);
    }
  };
  return inChunks(0, segments_, ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        look(pieces_[k].segment.left, pieces_[k].leftId);
        look(pieces_[k].segment.right, pieces_[k].rightId);
      }
    });
}

bool Splitter::findPoints()
{
  return inChunks(0, points_.count, ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t id = a; id != b; ++id)
      {
        const Index number = places_.find(points_[id]);
        if (number != kNoIndex && number >= named_ && isUsable(std::int64_t(id)))
        {
          places_[number].pointId = std::min(places_[number].pointId, static_cast<Index>(id));
        }
      }
    });
}

/// Adds a point for each place of along_ without one that has this segment as its first: so they
/// come in the order of the first segments, then along them. A place that is an end of a piece, and
/// so not along it, has a point.
void Splitter::addPointsOn(Index position)
{
  const Named first = named(position);
  for (const PlaceAlong& item : along_)
  {
    PlaceTable::Place& place = places_[item.place];
    if (place.id == kNoIndex && place.first == position)
    {
      place.id = static_cast<Index>(points_.count + out_.points.size());
      out_.points.push_back(described(place, first));
    }
  }
}

Splitter::Named Splitter::named(Index position) const
{
  const SegmentName name = nameOf(position);
  return { position, name, wayOf(name) };
}

CrossingPoint Splitter::described(const PlaceTable::Place& place, const Named& a) const
{
  const Named b = named(place.second);
  const auto again = [&](Index position) {
    return position == a.position ? a : position == b.position ? b : named(position);
  };
  const Named lower = again(place.lower), upper = again(place.upper);
  const auto along = [&](const Point& from, const Point& to)
  { return fractionOfWay(from, to, place.at); };
  const auto side = [&](const Named& n)
  {
    const Segment s = n.way.leftToRight();
    return CrossingPoint::Side{ n.name.chain, n.name.segment, along(s.left, s.right) };
  };
  const bool inOrder = !comesBefore(upper.way.leftToRight(), lower.way.leftToRight());
  return { place.at, a.name.chain, a.name.segment, along(a.way.from, a.way.to), b.name.chain,
    b.name.segment, along(b.way.from, b.way.to), side(inOrder ? lower : upper),
    side(inOrder ? upper : lower) };
}

// ------------------------------------------------------------------------------- points at places

bool Splitter::isUsable(std::int64_t id) const
{
  const auto k = static_cast<std::size_t>(id);
  return id >= 0 && k < points_.count && !points_.skipped(k) && isFinite(points_[k]);
}

Point Splitter::at(std::int64_t id) const
{
  return points_[static_cast<std::size_t>(id)];
}

SegmentName Splitter::nameOf(Index position) const
{
  const auto place = static_cast<std::int64_t>(first_ + position);
  const std::int64_t* const offsets = chains_.offsets;
  std::size_t chain = std::size_t(position) * chains_.chains / ids_; // if all are of one length
  if (!(offsets[chain] <= place && place < offsets[chain + 1]))
  {
    const std::int64_t* const end = offsets + chains_.chains + 1;
    chain = std::size_t(std::upper_bound(offsets, end, place) - offsets) - 1;
  }
  return { chain, first_ + position - std::size_t(chains_.offsets[chain]) };
}

/// @pre a segment of a piece.
Way Splitter::wayOf(const SegmentName& name) const
{
  const auto begin = std::size_t(chains_.offsets[name.chain]);
  const std::size_t k = begin + name.segment;
  const bool closes = k + 1 == std::size_t(chains_.offsets[name.chain + 1]);
  return { at(chains_.ids[k]), at(chains_.ids[closes ? begin : k + 1]) };
}

} // namespace ahd
