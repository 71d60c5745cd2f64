// SPDX-License-Identifier: BSD-3-Clause
#include "LineLayer.h"

#include "../Arithmetic/Length.h"
#include "../Core/SortAsking.h"

#include <algorithm>
#include <cmath>

namespace ahd
{
namespace
{

/// Bytes that an added point takes while it is found: in lists that grow by doubling, and in a hash
/// table.
constexpr std::size_t kBytesPerPoint = 440;

/// The same of an id in the chains.
constexpr std::size_t kBytesPerId = 3 * (sizeof(std::int64_t) + 1);

/// An edge by its vertices.
std::uint64_t edgeOf(Index a, Index b)
{
  return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}

/// The fraction `k` of `parts` of the way between two places, within their box.
Point placeBetween(const Point& a, const Point& b, double k, double parts)
{
  const double t = k / parts;
  const auto between = [t](double p, double q)
  { return std::clamp((1.0 - t) * p + t * q, std::min(p, q), std::max(p, q)) + 0.0; };
  return { between(a.x, b.x), between(a.y, b.y) };
}

} // namespace

Status LineLayer::run()
{
  if (lines_.surface)
  {
    placer_.emplace(lines_.surface->triangulation, ticker_);
    path_.emplace(lines_.surface->triangulation, ticker_);
  }
  const auto lay = [this](std::size_t position, std::int64_t from, std::int64_t to)
  {
    ids.push_back(lines_.chains.ids[position]);
    areOnSurface.push_back(0);
    ticker_.finished(1);
    return from < 0 || this->lay(static_cast<Index>(from), static_cast<Index>(to));
  };
  const bool isShared = findShared();
  offsets.reserve(lines_.chains.chains + 1);
  offsets.push_back(0);
  if (!isShared || !forSegments(lay))
  {
    return areTooMany_ ? Status::TooManyCrossings : Status::Cancelled;
  }
  return lines_.points.count + origins.size() > kMaximumPoints ? Status::TooManyPoints : Status::Ok;
}

/// Calls work(position, from, to) for each id of the chains, with the segment that it begins: -1 if
/// there is none. Returns false if a call does, or if cancelled.
template <typename Work>
bool LineLayer::forSegments(const Work& work)
{
  const ConstraintView& chains = lines_.chains;
  for (std::size_t chain = 0; chain < chains.chains; ++chain)
  {
    const std::int64_t begin = chains.offsets[chain], end = chains.offsets[chain + 1];
    for (std::int64_t k = begin; k < end; ++k)
    {
      const bool isLast = k + 1 == end;
      const std::int64_t from = chains.ids[k], to = chains.ids[isLast ? begin : k + 1];
      const bool isSegment = (!isLast || chain >= chains.lines) && isUsable(from) && isUsable(to);
      if (!work(static_cast<std::size_t>(k), isSegment ? from : -1, isSegment ? to : -1) ||
        !ticker_.step())
      {
        return false;
      }
    }
    if (!offsets.empty())
    {
      offsets.push_back(static_cast<std::int64_t>(ids.size()));
    }
  }
  return true;
}

/// The points that segments share with others that are part of the surface. Returns false if
/// cancelled, or if there are too many points.
bool LineLayer::findShared()
{
  if (!lines_.surface || lines_.surface->triangulation.constraints().edges == 0)
  {
    return true;
  }
  const auto find = [this](std::size_t, std::int64_t from, std::int64_t to)
  {
    const auto i = static_cast<Index>(from), k = static_cast<Index>(to);
    stops_.clear();
    return from < 0 || lines_.points[i] == lines_.points[k] || !lines_.isOnSurface(i, k) ||
      findStopsOnSurface({ lines_.points[i], lines_.points[k] }, i);
  };
  findsShared_ = true;
  const bool all = forSegments(find);
  findsShared_ = false;
  return all &&
    sortAsking(shared_, ticker_, [](const OnEdge& a, const OnEdge& b) { return a.edge < b.edge; });
}

bool LineLayer::isUsable(std::int64_t id) const
{
  const auto k = static_cast<std::size_t>(id);
  return id >= 0 && k < lines_.points.count && !lines_.points.skipped(k) &&
    isFinite(lines_.points[k]);
}

/// One segment; its first point is there already. Returns false if cancelled, or if there are too
/// many points.
bool LineLayer::lay(Index from, Index to)
{
  const Way way = { lines_.points[from], lines_.points[to] };
  if (way.from == way.to)
  {
    return true;
  }
  const bool isOnSurface = lines_.isOnSurface(from, to);
  areOnSurface.back() = isOnSurface;
  if (!findStops(way, from, isOnSurface))
  {
    return false;
  }
  const Stop end = { way.to, to };
  Stop last = { way.from, from };
  for (const Stop& stop : stops_)
  {
    if (way.isBefore(last.at, stop.at) && way.isBefore(stop.at, end.at)) // once, if found twice
    {
      if (!divide(way, last, stop, isOnSurface) || !ticker_.step())
      {
        return false;
      }
      add(stop.id, isOnSurface);
      last = stop;
    }
  }
  return divide(way, last, end, isOnSurface);
}

/// Where the segment gets points, in order. Returns false if cancelled, or if there are too many
/// points.
bool LineLayer::findStops(const Way& way, Index from, bool isOnSurface)
{
  stops_.clear();
  return (isOnSurface ? !path_ || findStopsOnSurface(way, from)
                      : shared_.empty() || findStopsOfOthers(way, from)) &&
    sortAsking(
      stops_, ticker_, [&way](const Stop& a, const Stop& b) { return way.isBefore(a.at, b.at); });
}

/// To search from.
std::size_t LineLayer::triangleNear(Index id) const
{
  const std::vector<Index>& triangles = lines_.surface->triangles;
  const std::size_t k = id - lines_.firstOfSource; // beyond them all, if it is the input's
  return k < triangles.size() ? triangles[k] : path_->triangle();
}

/// Where the segment meets the surface.
bool LineLayer::findStopsOnSurface(const Way& way, Index from)
{
  if (!path_->find(way.from, way.to, triangleNear(from)))
  {
    return false;
  }
  const Triangulation& surface = lines_.surface->triangulation;
  for (const SegmentPath::Met& met : path_->met())
  {
    if (met.isVertex)
    {
      stopAtVertex(surface.origin(met.halfEdge));
    }
    else if (!cross(way, met.halfEdge))
    {
      return false;
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

/// Where a segment that is a row of edges of the surface shares points with segments on it; then
/// also the vertices between these edges, as pieces are not exactly straight.
bool LineLayer::findStopsOfOthers(const Way& way, Index from)
{
  const Triangulation& surface = lines_.surface->triangulation;
  const Location begin = surface.locate(way.from, triangleNear(from), ticker_);
  if (!path_->find(way.from, way.to, triangleNear(from)) || begin.kind != Location::OnVertex)
  {
    return !ticker_.cancelled();
  }
  std::vector<Index> vertices = { surface.origin(begin.halfEdge) };
  for (const SegmentPath::Met& met : path_->met())
  {
    if (!met.isVertex) // it crosses others, and is no part of the surface
    {
      stops_.clear();
      return true;
    }
    vertices.push_back(surface.origin(met.halfEdge));
    stopAtVertex(vertices.back());
  }
  const Location end = surface.locate(way.to, path_->triangle(), ticker_);
  vertices.push_back(
    end.kind == Location::OnVertex ? surface.origin(end.halfEdge) : vertices.back());
  const std::size_t passed = stops_.size();
  for (std::size_t k = 0; k + 1 < vertices.size(); ++k)
  {
    const std::uint64_t edge = edgeOf(vertices[k], vertices[k + 1]);
    auto found = std::lower_bound(shared_.begin(), shared_.end(), edge,
      [](const OnEdge& on, std::uint64_t e) { return on.edge < e; });
    for (; found != shared_.end() && found->edge == edge && ticker_.step(); ++found)
    {
      stops_.push_back(found->stop);
    }
  }
  if (stops_.size() == passed)
  {
    stops_.clear();
  }
  return !ticker_.cancelled();
}

/// Unless tolerance merged its point into another, which lies elsewhere.
void LineLayer::stopAtVertex(Index vertex)
{
  const Index id = lines_.surface->triangulation.pointOf(vertex);
  if (isUsable(id))
  {
    stops_.push_back({ lines_.points[id], id });
  }
}

/// Lets the segment go through ends of the edge that it rounds to, or else where the two cross.
bool LineLayer::cross(const Way& way, HalfEdge h)
{
  const Triangulation& surface = lines_.surface->triangulation;
  const std::array<Index, 2> ends = { { surface.origin(h), surface.target(h) } };
  const Segment segment = way.leftToRight();
  const Segment edge = Way{ surface.at(ends[0]), surface.at(ends[1]) }.leftToRight();
  bool isAtEnds = false;
  for (const Index end : ends)
  {
    if (roundsTo(segment, surface.at(end)))
    {
      isAtEnds = true;
      stopAtVertex(end);
    }
  }
  if (isAtEnds || roundsTo(edge, way.from) || roundsTo(edge, way.to))
  {
    return true;
  }
  const bool isShared = surface.isConstrained(h);
  Stop stop = { crossingOf(segment, edge), kNoIndex };
  const SurfacePlace onEdge = placer_->onEdge(std::min(h, surface.twin(h)), stop.at);
  placer_->startAt(h / 3);
  if (!pointAt(stop.at, !isShared, onEdge, stop.id))
  {
    return false;
  }
  stops_.push_back(stop);
  if (isShared && findsShared_)
  {
    shared_.push_back({ edgeOf(ends[0], ends[1]), stop });
    takeMemory();
  }
  return true;
}

/// Divides a piece that is too long. Returns false if cancelled, or if there are too many points.
bool LineLayer::divide(const Way& way, const Stop& from, const Stop& to, bool isOnSurface)
{
  double length = lengthOf(to.at.x - from.at.x, to.at.y - from.at.y), most = lines_.maximumLength;
  if (!(most > 0.0 && length > most))
  {
    return true;
  }
  if (std::isinf(length))
  {
    length = lengthOf(to.at.x / 4 - from.at.x / 4, to.at.y / 4 - from.at.y / 4);
    most /= 4;
  }
  const double parts = std::ceil(length / most);
  areTooMany_ = !(parts - 1.0 <= double(kMaximumPoints));
  // In one direction whatever that of the segment is.
  const bool isForward = lexicographicallyLess(from.at, to.at);
  const Stop &first = isForward ? from : to, &second = isForward ? to : from;
  Point last = from.at;
  for (double k = 1.0; k < parts && !areTooMany_; k += 1.0)
  {
    const double part = isForward ? k : parts - k;
    const Point place = placeBetween(first.at, second.at, part, parts);
    if (way.isBefore(last, place) && way.isBefore(place, to.at)) // not if rounded to one of them
    {
      const SurfacePlace straight = { { { first.id, second.id, 0 } },
        { { 1.0 - part / parts, part / parts, 0.0 } } };
      Index id = kNoIndex;
      if (!pointAt(place, isOnSurface, straight, id))
      {
        return false;
      }
      add(id, isOnSurface);
      last = place;
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  return !areTooMany_;
}

/// The point at a place: the vertex there, one that was added before, or a new one. `otherwise`:
/// its origin where that is not the surface. Returns false if there are too many. Throws
/// std::bad_alloc.
bool LineLayer::pointAt(
  const Point& place, bool isOnSurface, const SurfacePlace& otherwise, Index& id)
{
  const auto first = static_cast<Index>(lines_.points.count);
  Index number = table_.find(place);
  if (number == kNoIndex)
  {
    SurfacePlace origin = isOnSurface && placer_ ? (*placer_)(place) : SurfacePlace();
    const Index corner = origin.corners[0];
    if (origin.weights[0] == 1.0 && isUsable(corner) && lines_.points[corner] == place)
    {
      id = corner;
      return true;
    }
    origin = origin.isInside() ? origin : otherwise;
    areTooMany_ = origins.size() >= std::min(lines_.mostPoints, kMaximumPoints);
    takeMemory();
    if (areTooMany_ || !table_.add(place, number))
    {
      return false;
    }
    const double z = heightAt(origin);
    origins.push_back(origin);
    places.push_back({ { place.x, place.y, z } });
  }
  id = first + number;
  return true;
}

/// Linear interpolation: at vertices of the surface its heights, else those of the points.
double LineLayer::heightAt(const SurfacePlace& origin) const
{
  return interpolate(origin,
    [this](Index id)
    {
      const std::size_t count = lines_.points.count;
      return id >= count ? places[id - count][2]
        : lines_.surface ? lines_.surface->heightAt(id, lines_.points)
                         : lines_.points.z(id);
    });
}

void LineLayer::add(Index id, bool isOnSurface)
{
  ids.push_back(id);
  areOnSurface.push_back(isOnSurface);
  takeMemory();
}

/// Requests memory for what is found, and for one point more. Throws std::bad_alloc if it is
/// refused.
void LineLayer::takeMemory()
{
  taken_.atLeast(kBytesPerPoint * (origins.size() + 1) + kBytesPerId * ids.size() +
    3 * sizeof(OnEdge) * shared_.size());
}

} // namespace ahd
