// SPDX-License-Identifier: BSD-3-Clause
#include "Oracle.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ahd
{
namespace test
{
namespace
{

/// A point lifted to the paraboloid. Its height is z plus the infinitesimal of its rank.
struct LiftedPoint
{
  mpq_class x, y, z;
  std::int32_t id;
  std::size_t rank; ///< place in lexicographic order; the larger, the larger the infinitesimal
};

/// Sum of q and of coefficients times infinitesimals, one per rank.
struct SymbolicSum
{
  mpq_class finite;
  std::vector<mpq_class> infinitesimal; ///< coefficient by rank

  int sign() const
  {
    int result = sgn(finite);
    for (std::size_t k = infinitesimal.size(); result == 0 && k-- > 0;)
    {
      result = sgn(infinitesimal[k]);
    }
    return result;
  }
};

/// Twice the signed area of a, b, c.
mpq_class area(const LiftedPoint& a, const LiftedPoint& b, const LiftedPoint& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Does d lie below the plane through the lifted a, b, c, that is, inside their circle?
/// The height of that plane at d, times the area of a, b, c, is the sum of the corners' heights,
/// each times the area d makes with the other two.
bool isInside(const std::array<const LiftedPoint*, 3>& corners, const LiftedPoint& d,
  const mpq_class& wholeArea, std::size_t count)
{
  SymbolicSum planeAboveD;
  planeAboveD.infinitesimal.resize(count);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const LiftedPoint& corner = *corners[i];
    const mpq_class share = area(*corners[(i + 1) % 3], *corners[(i + 2) % 3], d);
    planeAboveD.finite += share * corner.z;
    planeAboveD.infinitesimal[corner.rank] += share;
  }
  planeAboveD.finite -= wholeArea * d.z;
  planeAboveD.infinitesimal[d.rank] -= wholeArea;
  return planeAboveD.sign() > 0;
}

/// The distinct finite points in lexicographic order, each with its smallest id.
std::vector<LiftedPoint> liftedPoints(const std::vector<Point>& points)
{
  std::vector<std::int32_t> ids;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (std::isfinite(points[i].x) && std::isfinite(points[i].y))
    {
      ids.push_back(std::int32_t(i));
    }
  }
  const auto at = [&](std::int32_t id) -> const Point& { return points[std::size_t(id)]; };
  std::stable_sort(ids.begin(), ids.end(),
    [&](std::int32_t i, std::int32_t j) { return lexicographicallyLess(at(i), at(j)); });
  ids.erase(std::unique(ids.begin(), ids.end(),
              [&](std::int32_t i, std::int32_t j) { return at(i) == at(j); }),
    ids.end());
  std::vector<LiftedPoint> lifted;
  for (const std::int32_t id : ids)
  {
    const mpq_class x = at(id).x;
    const mpq_class y = at(id).y;
    lifted.push_back({ x, y, x * x + y * y, id, lifted.size() });
  }
  return lifted;
}

/// The corners counterclockwise if no point is inside their circle; else (or if they are collinear)
/// false.
bool isDelaunay(const std::vector<LiftedPoint>& all, std::array<const LiftedPoint*, 3>& corners)
{
  mpq_class wholeArea = area(*corners[0], *corners[1], *corners[2]);
  if (sgn(wholeArea) < 0)
  {
    std::swap(corners[1], corners[2]);
    wholeArea = -wholeArea;
  }
  return sgn(wholeArea) != 0 &&
    std::none_of(all.begin(), all.end(),
      [&](const LiftedPoint& d)
      {
        const bool isCorner = std::find(corners.begin(), corners.end(), &d) != corners.end();
        return !isCorner && isInside(corners, d, wholeArea, all.size());
      });
}

} // namespace

Triple smallestFirst(const Triple& triple)
{
  Triple turned = triple;
  std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
  return turned;
}

std::set<Triple> asSet(const std::vector<std::int32_t>& triples)
{
  std::set<Triple> result;
  for (std::size_t i = 0; i + 2 < triples.size(); i += 3)
  {
    result.insert(smallestFirst({ triples[i], triples[i + 1], triples[i + 2] }));
  }
  return result;
}

std::set<Triple> delaunayByDefinition(const std::vector<Point>& points)
{
  const std::vector<LiftedPoint> all = liftedPoints(points);
  std::set<Triple> result;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    for (std::size_t j = i + 1; j < all.size(); ++j)
    {
      for (std::size_t k = j + 1; k < all.size(); ++k)
      {
        std::array<const LiftedPoint*, 3> corners = { &all[i], &all[j], &all[k] };
        if (isDelaunay(all, corners))
        {
          result.insert(smallestFirst({ corners[0]->id, corners[1]->id, corners[2]->id }));
        }
      }
    }
  }
  return result;
}

} // namespace test
} // namespace ahd
