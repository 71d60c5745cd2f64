// SPDX-License-Identifier: BSD-3-Clause
#include "Domain.h"

#include "../Core/Chunks.h"
#include "Functions.h"
#include "SortTaking.h"

#include <algorithm>
#include <utility>

namespace ahd
{

Domain::Domain(const Triangulation& made, const double* sizes, Ticker& ticker)
  : made_(made)
  , given_(sizes)
  , ticker_(ticker)
  , memory_(ticker)
  , firstSteiner_(static_cast<Vertex>(made.vertexCount()) + kFirst + kFrame)
{
}

/// Of the mesh and what is kept by vertex or slot.
std::size_t Domain::bytesFor(std::size_t vertices)
{
  return LivingMesh::bytesFor(vertices) +
    (vertices + 2) * (sizeof(Origin) + sizeof(double) + 2 * sizeof(unsigned char));
}

/// For a vertex more. Requested before it grows, and while it does both the old and the new.
void Domain::makeRoom()
{
  if (mesh_.vertexCount() < room_)
  {
    return;
  }
  const std::size_t fixed = segments_.capacity() * sizeof(Segment), before = bytesFor(room_);
  room_ = std::max<std::size_t>(room_ + room_ / 2, mesh_.vertexCount() + 64);
  memory_.atLeast(fixed + before + bytesFor(room_));
  mesh_.reserve(room_);
  inside_.reserve(2 * room_ + 2); // resize() alone may take more
  inside_.resize(2 * room_ + 2, 0);
  origins_.reserve(room_);
  if (given_)
  {
    sizes_.reserve(room_ + 1);
    sizes_.resize(room_ + 1, 0.0);
  }
  memory_.atMost(fixed + bytesFor(room_));
}

Domain::Vertex Domain::endOf(HalfEdge h, bool isTarget) const
{
  return static_cast<Vertex>(isTarget ? made_.target(h) : made_.origin(h)) + kFirst;
}

/// Four corners of a square far around: triangles outside reach them, and every edge of the input
/// has a triangle on either side.
void Domain::addFrame()
{
  Point least = made_.at(0), most = least;
  for (std::size_t v = 1; v < made_.vertexCount(); ++v)
  {
    const Point p = made_.at(static_cast<Index>(v));
    least = { std::min(least.x, p.x), std::min(least.y, p.y) };
    most = { std::max(most.x, p.x), std::max(most.y, p.y) };
  }
  width_ = std::max(most.x - least.x, most.y - least.y);
  constexpr double kFar = 8.0; // widths
  const double far = kFar * width_;
  const double left = least.x - far, right = most.x + far;
  const double low = least.y - far, high = most.y + far;
  for (const Point& p : { Point{ left, low }, { right, low }, { right, high }, { left, high } })
  {
    mesh_.insert(p, mesh_.locate(p, 0));
  }
}

bool Domain::addVertices()
{
  room_ = firstSteiner_;
  memory_.atLeast(bytesFor(room_));
  mesh_.reserve(room_);
  inside_.assign(2 * room_ + 2, 0);
  sizes_.assign(given_ ? room_ + 1 : 0, 0.0);
  return mesh_.begin(made_, [this] { return ticker_.step(); }) &&
    inSteps(0, given_ ? made_.vertexCount() : 0, ticker_,
      [&](std::size_t k) { sizes_[k + kFirst] = given_[made_.pointOf(static_cast<Index>(k))]; });
}

/// Constraint edges, and those between kept triangles and others.
bool Domain::findSegments()
{
  GrowingMemory growing(ticker_);
  const auto look = [&](std::size_t k)
  {
    const auto h = static_cast<HalfEdge>(k), twin = made_.twin(h);
    const bool isKept = made_.isKept(k / 3);
    const bool isTwinKept = twin != kNoHalfEdge && made_.isKept(twin / 3);
    if ((twin == kNoHalfEdge || k < twin) && (made_.isConstrained(h) || isKept != isTwinKept))
    {
      Segment s = { endOf(h, false), endOf(h, true), h, isKept, isTwinKept };
      if (isLess(s.b, s.a))
      {
        std::swap(s.a, s.b);
        std::swap(s.isLeftInside, s.isRightInside);
      }
      growing.add(segments_, s);
    }
  };
  const bool all = inSteps(0, 3 * made_.triangleCount(), ticker_, look) &&
    sortTaking(segments_, ticker_,
      [](const Segment& s, const Segment& t)
      { return std::make_pair(s.a, s.b) < std::make_pair(t.a, t.b); });
  memory_.atLeast(bytesFor(room_) + segments_.capacity() * sizeof(Segment));
  return all;
}

bool Domain::constrainAll()
{
  return inSteps(0, segments_.size(), ticker_,
    [&](std::size_t k) { mesh_.constrain(segments_[k].a, segments_[k].b); });
}

/// Marks what is inside: from the segments on, up to segments.
bool Domain::fill()
{
  GrowingMemory growing(ticker_);
  std::vector<Slot> open;
  const auto add = [&](Halfedge h, bool is)
  {
    unsigned char& mark = inside_[h / Mesh::kSlotSize];
    if (is && mark == 0)
    {
      mark = 1;
      growing.add(open, Mesh::slotOf(h));
    }
  };
  for (const Segment& s : segments_)
  {
    const Halfedge h = mesh_.edge(s.a, s.b);
    add(h, s.isLeftInside);
    add(mesh_.twin(h), s.isRightInside);
    while (!open.empty())
    {
      const Slot slot = open.back();
      open.pop_back();
      for (Halfedge e = slot; e < slot + 3; ++e)
      {
        add(mesh_.twin(e), !mesh_.isConstraint(e));
      }
      if (!ticker_.step())
      {
        return false;
      }
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

bool Domain::load()
{
  if (!addVertices() || !findSegments() || !constrainAll())
  {
    return false;
  }
  addFrame();
  return fill();
}

Index Domain::segmentOf(Vertex p, Vertex q) const
{
  for (const Vertex v : { p, q })
  {
    if (isSteiner(v))
    {
      return originOf(v).segment;
    }
  }
  const std::pair<Vertex, Vertex> ends = isLess(p, q) ? std::make_pair(p, q) : std::make_pair(q, p);
  const auto found = std::lower_bound(segments_.begin(), segments_.end(), ends,
    [](const Segment& s, const std::pair<Vertex, Vertex>& e)
    { return std::make_pair(s.a, s.b) < e; });
  return static_cast<Index>(found - segments_.begin());
}

double Domain::fractionOf(Vertex v, Index segment) const
{
  return v == segments_[segment].a ? 0.0 : v == segments_[segment].b ? 1.0 : originOf(v).fraction;
}

std::size_t Domain::triangleNear(Vertex v) const
{
  return isSteiner(v) ? originOf(v).triangle : made_.start(static_cast<Index>(v - kFirst)) / 3;
}

/// Barycentric coordinates, at the next place of the triangle if it lies beside it.
SteinerPoint Domain::weighted(const Point& place, std::size_t triangle) const
{
  const double scale = powerOfTwoBelow(width_);
  const auto toPlace = [&](const Point& p)
  {
    return DoubleDoubleVector{ scaled(exactDifference(p.x, place.x), scale),
      scaled(exactDifference(p.y, place.y), scale) };
  };
  SteinerPoint result{ place.x, place.y, {}, {} };
  DoubleDoubleVector ways[3];
  for (std::size_t e = 0; e < 3; ++e)
  {
    const Index v = made_.origin(static_cast<HalfEdge>(3 * triangle + e));
    result.corners[e] = made_.pointOf(v);
    ways[e] = toPlace(made_.at(v));
  }
  double sum = 0.0;
  for (std::size_t e = 0; e < 3; ++e)
  {
    result.weights[e] = std::max(cross(ways[(e + 1) % 3], ways[(e + 2) % 3]).value(), 0.0);
    sum += result.weights[e];
  }
  for (double& weight : result.weights)
  {
    weight = sum > 0.0 ? weight / sum : 1.0 / 3.0;
  }
  return result;
}

/// The sum that data have, too; between the sizes at the corners.
void Domain::setSize(Vertex v, const SteinerPoint& from)
{
  if (given_)
  {
    double size = 0.0;
    for (std::size_t k = 0; k < 3 && from.corners[k] != kNoIndex; ++k)
    {
      size += from.weights[k] * given_[from.corners[k]];
    }
    sizes_[v] = size;
  }
}

Domain::Vertex Domain::split(Halfedge h, const Point& place, double fraction)
{
  makeRoom();
  const Index k = segmentOf(mesh_.origin(h), mesh_.target(h));
  const Segment& s = segments_[k];
  const std::size_t next = mesh_.end() / Mesh::kSlotSize;
  inside_[next] = inside_[h / Mesh::kSlotSize];
  inside_[next + 1] = inside_[mesh_.twin(h) / Mesh::kSlotSize];
  const Vertex v = mesh_.split(h, place);
  origins_.push_back({ k, fraction, s.at / 3 });
  if (given_)
  {
    sizes_[v] = sizes_[s.a] * (1.0 - fraction) + sizes_[s.b] * fraction;
  }
  return v;
}

Domain::Vertex Domain::insertSeen(const Point& place, const LivingMesh::Spot& spot, Vertex near)
{
  makeRoom();
  const std::size_t next = mesh_.end() / Mesh::kSlotSize;
  inside_[next] = inside_[next + 1] = 1;
  const Vertex v = mesh_.insertSeen(place, spot);
  const std::size_t triangle = made_.locate(place, triangleNear(near)).halfEdge / 3;
  origins_.push_back({ kNoIndex, 0.0, triangle });
  if (given_)
  {
    setSize(v, weighted(place, triangle));
  }
  return v;
}

} // namespace ahd
