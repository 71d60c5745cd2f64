// SPDX-License-Identifier: BSD-3-Clause
#include "SampleOracle.h"

#include "ExactSigns.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

namespace ahd
{
namespace test
{

namespace
{

using Number = mpq_class;

struct Vector
{
  Number x, y;
};

Vector between(const Point& from, const Point& to)
{
  return { Number(to.x) - Number(from.x), Number(to.y) - Number(from.y) };
}

Number cross(const Vector& a, const Vector& b)
{
  return a.x * b.y - a.y * b.x;
}

Number dot(const Vector& a, const Vector& b)
{
  return a.x * b.x + a.y * b.y;
}

/// Weights that sum to 1, from numbers with any sum.
PointWeights normalised(const std::map<std::int64_t, Number>& parts)
{
  Number sum;
  for (const auto& part : parts)
  {
    sum += part.second;
  }
  PointWeights result;
  for (const auto& part : parts)
  {
    if (part.second != 0)
    {
      result[part.first] = Number(part.second / sum).get_d();
    }
  }
  return result;
}

/// A convex polygon, counterclockwise, seen from a place.
class Polygon
{
public:
  /// A square that no cell among these vectors reaches the border of: coordinates are multiples of
  /// 2^-n and less than 2^m, so corners of cells, |a| |b| |a - b| over twice an area, are nearer
  /// than 2^(3 m + 2 n + 3).
  explicit Polygon(const std::vector<Vector>& around)
  {
    std::size_t m = 0, n = 0;
    for (const Vector& v : around)
    {
      for (const Number* c : { &v.x, &v.y })
      {
        const mpz_class whole = abs(c->get_num()) / c->get_den() + 1;
        m = std::max(m, mpz_sizeinbase(whole.get_mpz_t(), 2));
        n = std::max(n, mpz_sizeinbase(c->get_den().get_mpz_t(), 2));
      }
    }
    const Number far(mpz_class(1) << (3 * m + 2 * n + 3));
    corners_ = { { -far, -far }, { far, -far }, { far, far }, { -far, far } };
  }

  /// Keeps the part nearer to a than to b.
  void keepNearer(const Vector& a, const Vector& b)
  {
    const Vector normal{ b.x - a.x, b.y - a.y };
    const Number limit = (dot(b, b) - dot(a, a)) / 2;
    std::vector<Number> beyond;
    bool isCut = false;
    for (const Vector& q : corners_)
    {
      beyond.push_back(dot(normal, q) - limit);
      isCut = isCut || beyond.back() > 0;
    }
    if (!isCut)
    {
      return;
    }
    std::vector<Vector> left;
    for (std::size_t i = 0; i < corners_.size(); ++i)
    {
      const std::size_t j = (i + 1) % corners_.size();
      if (beyond[i] <= 0)
      {
        left.push_back(corners_[i]);
      }
      if ((beyond[i] < 0 && beyond[j] > 0) || (beyond[i] > 0 && beyond[j] < 0))
      {
        const Number t = beyond[i] / (beyond[i] - beyond[j]);
        const Vector &p = corners_[i], &q = corners_[j];
        left.push_back({ p.x + t * (q.x - p.x), p.y + t * (q.y - p.y) });
      }
    }
    corners_.swap(left);
  }

  Number area() const
  {
    Number sum;
    for (std::size_t i = 0; i < corners_.size(); ++i)
    {
      sum += cross(corners_[i], corners_[(i + 1) % corners_.size()]);
    }
    return sum;
  }

  /// The length, over that of v, of the side all points of which are as far from v as from 0. Each
  /// is a multiple of v, turned by 90 degrees.
  Number sideTowards(const Vector& v) const
  {
    const Number limit = dot(v, v) / 2;
    Number length;
    for (std::size_t i = 0; i < corners_.size(); ++i)
    {
      const Vector &p = corners_[i], &q = corners_[(i + 1) % corners_.size()];
      if (dot(v, p) == limit && dot(v, q) == limit)
      {
        length += cross(v, { q.x - p.x, q.y - p.y }) / dot(v, v);
      }
    }
    return length;
  }

private:
  std::vector<Vector> corners_;
};

} // namespace

namespace
{

/// The place of an edge that is nearest to a place.
struct Foot
{
  Foot(const Point& a, const Point& b, const Point& place)
  {
    const Vector way = between(a, b), to = between(a, place);
    part = dot(to, way) / dot(way, way);
    part = part < 0 ? Number(0) : part > 1 ? Number(1) : part;
    const Vector left{ to.x - part * way.x, to.y - part * way.y };
    squared = dot(left, left);
  }
  Number part;    ///< of the way from a to b
  Number squared; ///< distance
};

bool isWithinRounding(const Point& a, const Point& b, const Point& place)
{
  double largest = 0.0;
  for (const double c : { a.x, a.y, b.x, b.y, place.x, place.y })
  {
    largest = std::max(largest, std::fabs(c));
  }
  const double next = std::nextafter(largest, HUGE_VAL);
  const Number unit = std::isfinite(next) ? Number(next) - Number(largest)
                                          : Number(largest) - Number(std::nextafter(largest, 0.0));
  return Foot(a, b, place).squared <= 256 * unit * unit;
}

std::vector<Vector> seenFrom(const Point& place, const std::vector<Point>& points)
{
  std::vector<Vector> result;
  for (const Point& p : points)
  {
    result.push_back(between(place, p));
  }
  return result;
}

} // namespace

/// The points seen from a place, and its cell among them.
struct SampleOracle::Cells
{
  Cells(const std::vector<Point>& points, const Point& place)
    : around(seenFrom(place, points))
    , own(around)
  {
    for (const Vector& v : around)
    {
      own.keepNearer({ 0, 0 }, v);
    }
  }

  std::vector<Vector> around;
  Polygon own;
};

PointWeights SampleOracle::linear(const Point& place) const
{
  for (std::size_t t = 0; t < triples_.size(); t += 3)
  {
    const std::int32_t* const id = &triples_[t];
    Vector to[3];
    for (int k = 0; k < 3; ++k)
    {
      to[k] = between(place, points_[std::size_t(id[k])]);
    }
    std::map<std::int64_t, Number> parts;
    for (int k = 0; k < 3; ++k)
    {
      parts[id[k]] = cross(to[(k + 1) % 3], to[(k + 2) % 3]);
    }
    if (std::all_of(parts.begin(), parts.end(), [](const auto& part) { return part.second >= 0; }))
    {
      return normalised(parts);
    }
  }
  const auto edges = rim();
  return std::any_of(edges.begin(), edges.end(),
           [&](const auto& edge)
           { return isWithinRounding(points_[edge.first], points_[edge.second], place); })
    ? atRim(place)
    : PointWeights();
}

/// Edges, counterclockwise, of one triangle alone.
std::vector<std::pair<std::size_t, std::size_t>> SampleOracle::rim() const
{
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t h = 0; h < triples_.size(); ++h)
  {
    edges.emplace(std::size_t(triples_[h]), std::size_t(triples_[h % 3 == 2 ? h - 2 : h + 1]));
  }
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (const auto& edge : edges)
  {
    if (edges.count({ edge.second, edge.first }) == 0)
    {
      result.push_back(edge);
    }
  }
  return result;
}

PointWeights SampleOracle::atRim(const Point& place) const
{
  const auto isFirst = [](const Point& a, const Point& b, const Point& c, const Point& d)
  { return a == c ? lexicographicallyLess(b, d) : lexicographicallyLess(a, c); };
  PointWeights result;
  Number least(-1);
  Point best[2] = {};
  for (auto edge : rim())
  {
    if (lexicographicallyLess(points_[edge.second], points_[edge.first]))
    {
      std::swap(edge.first, edge.second);
    }
    const Point &a = points_[edge.first], &b = points_[edge.second];
    const Foot foot(a, b, place);
    if (least < 0 || foot.squared < least ||
      (foot.squared == least && isFirst(a, b, best[0], best[1])))
    {
      least = foot.squared;
      best[0] = a;
      best[1] = b;
      result = normalised({ { std::int64_t(edge.first), Number(1 - foot.part) },
        { std::int64_t(edge.second), foot.part } });
    }
  }
  return result;
}

/// Is there no cell around the place: outside, on a point or on the hull? Then `weights` are those
/// of the ends of the edge that it lies on, if any.
bool SampleOracle::isOnHull(const Point& place, PointWeights& weights) const
{
  weights = linear(place);
  if (weights.size() < 2)
  {
    return true;
  }
  std::set<std::pair<std::int32_t, std::int32_t>> edges;
  for (std::size_t h = 0; h < triples_.size(); ++h)
  {
    edges.insert({ triples_[h], triples_[h % 3 == 2 ? h - 2 : h + 1] });
  }
  const auto a = std::int32_t(weights.begin()->first), b = std::int32_t(weights.rbegin()->first);
  return weights.size() == 2 && (edges.count({ a, b }) == 0 || edges.count({ b, a }) == 0);
}

PointWeights SampleOracle::sibson(const Point& place) const
{
  PointWeights weights;
  if (isOnHull(place, weights))
  {
    return weights;
  }
  const Cells cells(points_, place);
  std::map<std::int64_t, Number> parts;
  for (std::size_t v = 0; v < points_.size(); ++v)
  {
    if (cells.own.sideTowards(cells.around[v]) == 0)
    {
      continue; // it is no neighbour
    }
    Polygon taken = cells.own;
    for (std::size_t w = 0; w < points_.size(); ++w)
    {
      if (w != v)
      {
        taken.keepNearer(cells.around[v], cells.around[w]);
      }
    }
    parts[std::int64_t(v)] = taken.area();
  }
  return normalised(parts);
}

PointWeights SampleOracle::laplace(const Point& place) const
{
  PointWeights weights;
  if (isOnHull(place, weights))
  {
    return weights;
  }
  const Cells cells(points_, place);
  std::map<std::int64_t, Number> parts;
  for (std::size_t v = 0; v < points_.size(); ++v)
  {
    parts[std::int64_t(v)] = cells.own.sideTowards(cells.around[v]);
  }
  return normalised(parts);
}

PointWeights SampleOracle::nearest(const Point& place) const
{
  std::size_t best = 0;
  Number least;
  for (std::size_t v = 0; v < points_.size(); ++v)
  {
    const Vector to = between(place, points_[v]);
    const Number d = dot(to, to);
    if (v == 0 || d < least || (d == least && lexicographicallyLess(points_[v], points_[best])))
    {
      best = v;
      least = d;
    }
  }
  return points_.empty() ? PointWeights() : PointWeights{ { std::int64_t(best), 1.0 } };
}

PointWeights SampleOracle::nearestInFront(const Point& place) const
{
  const auto edges = rim();
  PointWeights best;
  for (const std::int32_t id : std::set<std::int32_t>(triples_.begin(), triples_.end()))
  {
    const Point& v = points_[std::size_t(id)];
    const bool isBehind = std::any_of(edges.begin(), edges.end(),
      [&](const auto& edge)
      {
        const Point &a = points_[edge.first], &b = points_[edge.second];
        return orientSign(a, b, place) >= 0 && orientSign(a, b, v) < 0 &&
          orientSign(place, v, a) * orientSign(place, v, b) < 0;
      });
    if (isBehind)
    {
      continue;
    }
    const Point& w = best.empty() ? v : points_[std::size_t(best.begin()->first)];
    const Vector toV = between(place, v), toW = between(place, w);
    const Number less = dot(toW, toW) - dot(toV, toV);
    if (best.empty() || less > 0 || (less == 0 && lexicographicallyLess(v, w)))
    {
      best = { { id, 1.0 } };
    }
  }
  return best;
}

} // namespace test
} // namespace ahd
