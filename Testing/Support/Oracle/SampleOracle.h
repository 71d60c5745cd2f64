// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SampleOracle_h
#define ahd_SampleOracle_h

#include "Points/Points.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace ahd
{
namespace test
{

/// The weights of some points, by id; those that are 0 are missing. Empty: there is no value.
using PointWeights = std::map<std::int64_t, double>;

/// Weights by their definitions, in rational arithmetic, each rounded once; by brute force, for few
/// points. Shares no line with the engine.
class SampleOracle
{
public:
  /// `triples`: of ids, three per triangle of the surface, counterclockwise. Borrows both.
  SampleOracle(const std::vector<Point>& points, const std::vector<std::int32_t>& triples)
    : points_(points)
    , triples_(triples)
  {
  }

  /// Areas within the triangle that has the place in it or on its border.
  PointWeights linear(const Point& place) const;

  /// Sibson's: the area that the cell of the place takes from the Voronoi cells. Laplace's: the
  /// length of the border of cells over the distance. @pre the triangles are all of a Delaunay
  /// triangulation; points are distinct.
  PointWeights sibson(const Point& place) const;
  PointWeights laplace(const Point& place) const;

  /// Of several the lexicographically smallest; of several at one place the smallest id.
  PointWeights nearest(const Point& place) const;

private:
  struct Cells;
  bool isOnHull(const Point& place, PointWeights& weights) const;

  const std::vector<Point>& points_;
  const std::vector<std::int32_t>& triples_;
};

} // namespace test
} // namespace ahd

#endif
