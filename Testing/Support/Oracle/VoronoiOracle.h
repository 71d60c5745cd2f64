// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_VoronoiOracle_h
#define ahd_VoronoiOracle_h

#include "Points/Points.h"
#include "Voronoi/Voronoi.h"

#include <string>

namespace ahd
{
namespace test
{

/// What is wrong with the cells, or "": each against the exact one, which is cut out of hull or box
/// by all bisectors in rational arithmetic. For few points: it takes the square of their number.
///
/// A corner has to be within rounding of one of the exact cell's, and each of these has to have
/// one: 4 units in the last place of the largest coordinates there are within the circle around it
/// through its vertices, as that is where centres are one corner by definition. The area has to be
/// the exact one but for what that moves.
std::string faultsOfCells(const PointView& points, VoronoiClip clip, const VoronoiCells& cells);

} // namespace test
} // namespace ahd

#endif
