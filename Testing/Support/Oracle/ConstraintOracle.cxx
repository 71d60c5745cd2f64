// SPDX-License-Identifier: BSD-3-Clause
#include "ConstraintOracle.h"

#include "ConstraintDefinition.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace ahd
{
namespace test
{
// --- 1: segments
// -----------------------------------------------------------------------------------

/// Are all vertices collinear? Then there is no triangle.
bool Definition::isFlat() const
{
  return std::all_of(vertices_.begin(), vertices_.end(),
    [&](std::int32_t v)
    {
      const auto isBeside = [&](std::int32_t w) { return this->orient(vertices_[0], v, w) != 0; };
      return std::none_of(vertices_.begin(), vertices_.end(), isBeside);
    });
}

/// Without triangles no segment can become an edge.
void Definition::refuse()
{
  std::set<std::size_t> loops;
  for (const GivenSegment& given : segmentsOf(constraints_))
  {
    ++result_.report.segments;
    ++result_.report.withoutVertex;
    if (given.ofLoop)
    {
      loops.insert(given.chain);
    }
  }
  result_.report.unfilledLoops = loops.size();
}

/// Do a-b and c-d cross in a point that is no vertex?
bool Definition::cross(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) const
{
  if (orient(a, b, c) * orient(a, b, d) >= 0 || orient(c, d, a) * orient(c, d, b) >= 0)
  {
    return false;
  }
  return std::none_of(vertices_.begin(), vertices_.end(),
    [&](std::int32_t v) { return orient(a, b, v) == 0 && orient(c, d, v) == 0; });
}

const Accepted* Definition::firstCrossed(std::int32_t from, std::int32_t to) const
{
  const Accepted* first = nullptr;
  mpq_class nearest;
  const Vector way = between(at(from), at(to));
  for (const Accepted& other : accepted_)
  {
    if (!cross(from, to, other.from, other.to))
    {
      continue;
    }
    const Vector along = between(at(other.from), at(other.to));
    const mpq_class where = ahd::test::cross(between(at(from), at(other.from)), along) /
      ahd::test::cross(way, along);
    if (!first || where < nearest)
    {
      first = &other;
      nearest = where;
    }
  }
  return first;
}

void Definition::accept()
{
  ConstraintReport& report = result_.report;
  for (const GivenSegment& given : segmentsOf(constraints_, vertexOf_))
  {
    ++report.segments;
    const std::int32_t from = test::vertexOf(vertexOf_, given.from);
    const std::int32_t to = test::vertexOf(vertexOf_, given.to);
    const bool isNone = from < 0 || to < 0;
    const Accepted* crossed = isNone || from == to ? nullptr : firstCrossed(from, to);
    if (isNone || crossed)
    {
      ++(isNone ? report.withoutVertex : report.crossing);
      if (given.ofLoop)
      {
        brokenLoops_.insert(given.chain);
      }
    }
    if (crossed)
    {
      report.leftOut.push_back({ given.chain, given.segment, crossed->chain, crossed->segment });
    }
    else if (!isNone && from == to)
    {
      ++report.points;
    }
    else if (!isNone)
    {
      accepted_.push_back({ from, to, given.chain, given.segment, given.ofLoop });
    }
  }
  report.unfilledLoops = brokenLoops_.size();
}

// --- 2: triangles
// ----------------------------------------------------------------------------------

void Definition::triangulate()
{
  const std::size_t n = vertices_.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = i + 1; j < n; ++j)
    {
      for (std::size_t k = j + 1; k < n; ++k)
      {
        Corners t = { vertices_[i], vertices_[j], vertices_[k] };
        if (orient(t[0], t[1], t[2]) < 0)
        {
          std::swap(t[1], t[2]);
        }
        if (isTriangle(t))
        {
          result_.all.insert(smallestFirst(t));
        }
      }
    }
  }
}

bool Definition::isTriangle(const Corners& t)
{
  if (orient(t[0], t[1], t[2]) <= 0)
  {
    return false;
  }
  std::vector<std::int32_t> inCircle;
  for (const std::int32_t v : vertices_)
  {
    if (std::find(t.begin(), t.end(), v) != t.end())
    {
      continue;
    }
    if (orient(t[0], t[1], v) >= 0 && orient(t[1], t[2], v) >= 0 && orient(t[2], t[0], v) >= 0)
    {
      return false; // in the triangle or on its border
    }
    if (perturbedInCircleSign(at(t[0]), at(t[1]), at(t[2]), at(v)) > 0)
    {
      inCircle.push_back(v);
    }
  }
  return !isPassedThrough(t) &&
    std::none_of(
      inCircle.begin(), inCircle.end(), [&](std::int32_t v) { return this->canSee(v, t); });
}

/// Is there an accepted segment with points in the open triangle? The part of it on the inner side
/// of all three edges is cut out, in fractions of its length.
bool Definition::isPassedThrough(const Corners& t) const
{
  return std::any_of(accepted_.begin(), accepted_.end(),
    [&](const Accepted& s)
    {
      mpq_class low = 0;
      mpq_class high = 1;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const Point a = at(t[i]);
        const Vector edge = between(a, at(t[(i + 1) % 3]));
        const mpq_class begin = ahd::test::cross(edge, between(a, at(s.from)));
        const mpq_class end = ahd::test::cross(edge, between(a, at(s.to)));
        if (begin <= 0 && end <= 0)
        {
          return false;
        }
        if (begin < 0)
        {
          low = std::max<mpq_class>(low, begin / (begin - end));
        }
        else if (end < 0)
        {
          high = std::min<mpq_class>(high, begin / (begin - end));
        }
      }
      return low < high;
    });
}

/// One direction between each two neighbouring directions from v to other vertices: whatever v sees
/// with an inside, it sees along one of these.
const std::vector<Vector>& Definition::directions(std::int32_t v)
{
  const auto known = directions_.find(v);
  if (known != directions_.end())
  {
    return known->second;
  }
  std::vector<Vector> to;
  for (const std::int32_t w : vertices_)
  {
    if (w != v)
    {
      to.push_back(between(at(v), at(w)));
    }
  }
  const auto isUpper = [](const Vector& d) { return d.y > 0 || (d.y == 0 && d.x > 0); };
  std::sort(to.begin(), to.end(),
    [&](const Vector& a, const Vector& b)
    { return isUpper(a) != isUpper(b) ? isUpper(a) : ahd::test::cross(a, b) > 0; });
  std::vector<Vector>& result = directions_[v];
  for (std::size_t i = 0; i < to.size(); ++i)
  {
    const Vector& a = to[i];
    const Vector& b = to[(i + 1) % to.size()];
    if (ahd::test::cross(a, b) > 0) // else there is nothing between them, or the outside
    {
      result.push_back({ a.x + b.x, a.y + b.y });
    }
  }
  return result;
}

bool Definition::seesAlong(std::int32_t v, const Vector& d, const Corners& t) const
{
  const mpq_class met[3] = { meeting(at(v), d, at(t[0]), at(t[1])),
    meeting(at(v), d, at(t[1]), at(t[2])), meeting(at(v), d, at(t[2]), at(t[0])) };
  mpq_class entry = -1;
  for (const mpq_class& where : met)
  {
    entry = where >= 0 && (entry < 0 || where < entry) ? where : entry;
  }
  return entry >= 0 &&
    std::none_of(accepted_.begin(), accepted_.end(),
      [&](const Accepted& s)
      {
        const mpq_class where = meeting(at(v), d, at(s.from), at(s.to));
        return where > 0 && where <= entry;
      });
}

bool Definition::canSee(std::int32_t v, const Corners& t)
{
  const std::vector<Vector>& all = directions(v);
  return std::any_of(
    all.begin(), all.end(), [&](const Vector& d) { return this->seesAlong(v, d, t); });
}

ConstrainedByDefinition constrainedByDefinition(
  const PointView& points, const ConstraintView& constraints, FillRule rule)
{
  return Definition(points, constraints).make(rule);
}

} // namespace test
} // namespace ahd
