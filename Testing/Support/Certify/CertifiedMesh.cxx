// SPDX-License-Identifier: BSD-3-Clause
#include "CertifiedMesh.h"

#include "ExactSigns.h"
#include "Result.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ahd
{
namespace test
{

bool CertifiedMesh::check()
{
  checkPointStatus();
  checkTriangles();
  if (!faults_.empty())
  {
    return false; // the code below relies on ids that are vertices
  }
  if (triples_.empty())
  {
    checkFlat();
    return true;
  }
  collectEdges();
  linkTriangles();
  checkHull();
  checkUse();
  checkConnected();
  return true;
}

std::int64_t CertifiedMesh::rightStatus(PlaceTable& places, std::size_t i) const
{
  const Point p = points_[i];
  return points_.skipped(i)                      ? std::int64_t(kStatusNotInserted)
    : !std::isfinite(p.x) || !std::isfinite(p.y) ? std::int64_t(kStatusNotFinite)
                                                 : std::int64_t(places.firstAt(i));
}

void CertifiedMesh::checkPointStatus()
{
  if (pointStatus_.size() != points_.count)
  {
    faults_.add("pointStatus",
      [&]
      {
        return std::to_string(pointStatus_.size()) + " for " + std::to_string(points_.count) +
          " points";
      });
    return;
  }
  PlaceTable places(points_);
  for (std::size_t i = 0; i < points_.count; ++i)
  {
    const std::int64_t right = rightStatus(places, i);
    vertexCount_ += right == std::int64_t(i) ? 1 : 0;
    if (pointStatus_[i] != right)
    {
      faults_.add("point status",
        [&]
        {
          return name(std::int32_t(i)) + " has " + std::to_string(pointStatus_[i]) +
            " instead of " + std::to_string(right);
        });
    }
  }
}

void CertifiedMesh::checkTriangles()
{
  if (triples_.size() % 3 != 0)
  {
    faults_.add("triangles", [&] { return std::to_string(triples_.size()) + " corners"; });
  }
  for (const std::int32_t id : triples_)
  {
    const bool inRange = id >= 0 && std::size_t(id) < pointStatus_.size();
    if (!inRange || !isVertex(id))
    {
      faults_.add("corner", [&] { return std::to_string(id) + " is not the id of a vertex"; });
    }
  }
  for (std::size_t t = 0; faults_.empty() && t < triangleCount(); ++t)
  {
    const std::int32_t* v = &triples_[3 * t];
    const int sign = orientSign(at(v[0]), at(v[1]), at(v[2]));
    if (sign <= 0)
    {
      faults_.add(sign < 0 ? "clockwise" : "no area", [&] { return triangleName(t); });
    }
  }
}

void CertifiedMesh::checkFlat()
{
  std::int32_t first = kNone;
  std::int32_t second = kNone;
  for (std::int32_t id = 0; std::size_t(id) < points_.count; ++id)
  {
    if (!isVertex(id))
    {
      continue;
    }
    if (first == kNone || second == kNone)
    {
      (first == kNone ? first : second) = id;
    }
    else if (orientSign(at(first), at(second), at(id)) != 0)
    {
      faults_.add("no triangles",
        [&] { return name(first, second) + ", " + name(id) + " are not collinear"; });
    }
  }
}

void CertifiedMesh::collectEdges()
{
  firstEdge_.assign(points_.count + 1, 0);
  for (const std::int32_t id : triples_)
  {
    ++firstEdge_[std::size_t(id) + 1];
  }
  for (std::size_t v = 0; v < points_.count; ++v)
  {
    firstEdge_[v + 1] += firstEdge_[v];
  }
  edges_.resize(triples_.size());
  std::vector<std::int32_t> next(firstEdge_.begin(), firstEdge_.end() - 1);
  for (std::int32_t h = 0; std::size_t(h) < triples_.size(); ++h)
  {
    const auto place = std::size_t(next[std::size_t(origin(h))]++);
    edges_[place] = { target(h), h };
  }
  for (std::size_t v = 0; v < points_.count; ++v)
  {
    std::sort(edges_.begin() + firstEdge_[v], edges_.begin() + firstEdge_[v + 1],
      [](const Edge& a, const Edge& b) { return a.target < b.target; });
  }
}

std::int32_t CertifiedMesh::findHalfEdge(std::int32_t from, std::int32_t to) const
{
  const auto begin = edges_.begin() + firstEdge_[std::size_t(from)];
  const auto end = edges_.begin() + firstEdge_[std::size_t(from) + 1];
  const auto found = std::lower_bound(
    begin, end, to, [](const Edge& edge, std::int32_t id) { return edge.target < id; });
  return found != end && found->target == to ? found->halfEdge : kNone;
}

void CertifiedMesh::linkTriangles()
{
  twin_.assign(triples_.size(), kNone);
  for (std::size_t i = 0; i < edges_.size(); ++i)
  {
    const std::int32_t h = edges_[i].halfEdge;
    const std::int32_t from = origin(h);
    const bool again = i + 1 < edges_.size() && origin(edges_[i + 1].halfEdge) == from &&
      edges_[i + 1].target == edges_[i].target;
    if (again)
    {
      faults_.add("edge used twice", [&] { return name(from, edges_[i].target); });
    }
    if (from < edges_[i].target)
    {
      const std::int32_t twin = findHalfEdge(edges_[i].target, from);
      twin_[std::size_t(h)] = twin;
      if (twin != kNone)
      {
        twin_[std::size_t(twin)] = h;
      }
    }
  }
}

void CertifiedMesh::checkHullCorner(std::int32_t before, std::int32_t at, std::int32_t after)
{
  const Point p = this->at(before);
  const Point q = this->at(at);
  const Point r = this->at(after);
  const int sign = orientSign(p, q, r);
  // On a straight line the middle one of three points is the middle one in lexicographic order.
  const bool goesOn = lexicographicallyLess(p, q) == lexicographicallyLess(q, r);
  if (sign < 0 || (sign == 0 && !goesOn))
  {
    faults_.add(
      "hull not convex", [&] { return "at " + name(at) + " between " + name(before, after); });
  }
}

std::vector<std::int32_t> CertifiedMesh::hullSuccessors()
{
  std::vector<std::int32_t> after(points_.count, kNone);
  for (std::int32_t h = 0; std::size_t(h) < triples_.size(); ++h)
  {
    if (twin_[std::size_t(h)] == kNone)
    {
      ++hullSize_;
      hullStart_ = origin(h);
      if (after[std::size_t(origin(h))] != kNone)
      {
        faults_.add("hull passes twice", [&] { return "through " + name(origin(h)); });
      }
      after[std::size_t(origin(h))] = target(h);
    }
  }
  return after;
}

void CertifiedMesh::checkHull()
{
  const std::vector<std::int32_t> after = hullSuccessors();
  const auto follow = [&](std::int32_t v) { return v == kNone ? v : after[std::size_t(v)]; };
  std::size_t steps = 0;
  std::size_t rounds = 0; // a convex loop that goes round k times has k lexicographic minima
  std::int32_t v = hullStart_;
  for (bool closed = false; !closed && steps < hullSize_; ++steps)
  {
    const std::int32_t next = follow(v);
    const std::int32_t afterNext = follow(next);
    if (afterNext == kNone)
    {
      faults_.add("hull ends", [&] { return "after " + name(v); });
      return;
    }
    checkHullCorner(v, next, afterNext);
    const bool isMinimum = lexicographicallyLess(at(next), at(v)) &&
      lexicographicallyLess(at(next), at(afterNext));
    rounds += isMinimum ? 1 : 0;
    v = next;
    closed = v == hullStart_;
  }
  if (v != hullStart_ || steps != hullSize_ || rounds != 1)
  {
    faults_.add("hull is not one simple loop",
      [&]
      {
        return std::to_string(hullSize_) + " edges used one way, " + std::to_string(steps) +
          " on the loop, which goes round " + std::to_string(rounds) + " times" +
          (hullStart_ == kNone ? "" : ", from " + name(hullStart_));
      });
  }
}

void CertifiedMesh::checkUse()
{
  for (std::size_t v = 0; v < points_.count; ++v)
  {
    if (isVertex(std::int32_t(v)) && firstEdge_[v] == firstEdge_[v + 1])
    {
      faults_.add("vertex in no triangle", [&] { return name(std::int32_t(v)); });
    }
  }
  if (triangleCount() + 2 + hullSize_ != 2 * vertexCount_)
  {
    faults_.add("Euler",
      [&]
      {
        return std::to_string(triangleCount()) + " triangles, not 2 * " +
          std::to_string(vertexCount_) + " vertices - 2 - " + std::to_string(hullSize_) +
          " on the hull";
      });
  }
}

void CertifiedMesh::checkConnected()
{
  std::vector<char> reached(triangleCount(), 0);
  std::vector<std::int32_t> open(1, 0);
  reached[0] = 1;
  std::size_t count = 0;
  while (!open.empty())
  {
    const std::int32_t t = open.back();
    open.pop_back();
    ++count;
    for (std::int32_t h = 3 * t; h < 3 * t + 3; ++h)
    {
      const std::int32_t twin = twin_[std::size_t(h)];
      if (twin != kNone && !reached[std::size_t(twin / 3)])
      {
        reached[std::size_t(twin / 3)] = 1;
        open.push_back(twin / 3);
      }
    }
  }
  if (count != triangleCount())
  {
    const auto lost = std::size_t(std::find(reached.begin(), reached.end(), 0) - reached.begin());
    faults_.add("not connected",
      [&]
      {
        return std::to_string(count) + " of " + std::to_string(triangleCount()) +
          " triangles can be reached from the first; one that cannot: " + triangleName(lost);
      });
  }
}

void CertifiedMesh::checkDelaunay(const std::vector<char>& fixed)
{
  for (std::int32_t h = 0; std::size_t(h) < triples_.size(); ++h)
  {
    const std::int32_t twin = twin_[std::size_t(h)];
    if (twin < h || (!fixed.empty() && fixed[std::size_t(h)]))
    {
      continue; // on the hull (none), seen from the other side, or exempt from the circle test
    }
    const Point a = at(origin(h));
    const Point b = at(target(h));
    const Point c = at(apex(h));
    const Point d = at(apex(twin));
    if (apex(h) == apex(twin) || perturbedInCircleSign(a, b, c, d) > 0)
    {
      const bool tie = apex(h) != apex(twin) && inCircleSign(a, b, c, d) == 0;
      faults_.add(tie ? "tie broken the wrong way" : "not Delaunay",
        [&]
        { return "edge " + name(origin(h), target(h)) + " between " + name(apex(h), apex(twin)); });
    }
  }
}

std::string CertifiedMesh::name(std::int32_t id) const
{
  return "point " + std::to_string(id) + " " + hexText(at(id));
}

std::string CertifiedMesh::name(std::int32_t a, std::int32_t b) const
{
  return name(a) + ", " + name(b);
}

std::string CertifiedMesh::triangleName(std::size_t t) const
{
  return "triangle " + std::to_string(t) + " of " + name(triples_[3 * t], triples_[3 * t + 1]) +
    ", " + name(triples_[3 * t + 2]);
}

} // namespace test
} // namespace ahd
