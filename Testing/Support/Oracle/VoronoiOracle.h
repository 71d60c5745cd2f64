// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_VoronoiOracle_h
#define ahd_VoronoiOracle_h

#include "Points/Points.h"
#include "Voronoi/Voronoi.h"

#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// The faults of the cells, or "": each against the exact one, which is cut out of hull or box by
/// all bisectors in rational arithmetic. For few points: it takes the square of their number.
///
/// A corner must be within rounding of one of the exact cell's, and each of these must have one: 4
/// units in the last place of the largest coordinates within the circle around it through its
/// vertices, as centres within that distance are one corner by definition. The area must be the
/// exact one up to these errors.
std::string faultsOfCells(const PointView& points, VoronoiClip clip, const VoronoiCells& cells);
/// The same in a convex polygon, whose corners are given counterclockwise: cells without an area
/// there must be empty, and the exact ones fill it.
std::string faultsOfCells(
  const PointView& points, const std::vector<Point>& polygon, const VoronoiCells& cells);

} // namespace test
} // namespace ahd

#endif
