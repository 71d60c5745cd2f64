// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SampleOracle_h
#define ahd_SampleOracle_h

#include "Points/Points.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
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

  /// Areas within the triangle that has the place in it or on its border; atRim() of one that is
  /// outside by no more than 16 units in the last place of the largest coordinate of an edge and
  /// it.
  PointWeights linear(const Point& place) const;

  /// Of the ends of the edge with a triangle on one side alone that is nearest to the place, where
  /// it is nearest; of several edges the one whose ends come first.
  PointWeights atRim(const Point& place) const;

  /// Sibson's: the area that the cell of the place takes from the Voronoi cells. Laplace's: the
  /// length of the border of cells over the distance. @pre the triangles are all of a Delaunay
  /// triangulation; points are distinct.
  PointWeights sibson(const Point& place) const;
  PointWeights laplace(const Point& place) const;

  /// Of several the lexicographically smallest; of several at one place the smallest id.
  PointWeights nearest(const Point& place) const;

  /// The same among corners of the triangles that the straight way to does not leave these
  /// through an edge with a triangle on one side alone.
  PointWeights nearestInFront(const Point& place) const;

private:
  struct Cells;
  std::vector<std::pair<std::size_t, std::size_t>> rim() const;
  bool isOnHull(const Point& place, PointWeights& weights) const;

  const std::vector<Point>& points_;
  const std::vector<std::int32_t>& triples_;
};

} // namespace test
} // namespace ahd

#endif
