// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Distributions_h
#define ahd_Distributions_h

#include "PlanarPoints.h"
#include "Points/Points.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{
namespace test
{

using ahd::Random; // for shuffles and choices

/// Kinds of point sets that tests and benchmarks share.
enum class Distribution
{
  // The six of the paper (Figure 10), as vtkPlanarPointSource makes them: see PlanarPoints.h.
  Uniform,
  Line,
  Cross,
  Circle,
  Spiral,
  Mixed,

  // Strongly clustered.
  KuzminDisc,     ///< density (1 + r^2)^(-3/2) about a centre: a crowd in a very large box
  NestedClusters, ///< clusters within clusters, six deep, each 1/64 as wide as its parent
  CrowdedBox,     ///< 9 of 10 points in one box of 31623 x 31623 (10^9) boxes, the rest uniform

  // Degenerate or nearly so.
  Lattice,         ///< integer lattice: see PlanarPoints.h
  DecimalLattice,  ///< the same in steps of 0.1 (nearly, not exactly, cocircular)
  OnCircle,        ///< on the unit circle up to rounding
  OnIntegerCircle, ///< exactly cocircular: x^2 + y^2 = 1105^2 * 29^2, repeats beyond its 324 points
  OnParabola,      ///< y = x^2, x in (-1, 1), rounded
  Collinear,       ///< exactly on y = 2 x
  NearlyCollinear, ///< on y = x / 3 up to rounding
  AllEqual,        ///< one place
  RepeatedDraws,   ///< drawn from 1000 places
  Utm,             ///< easting and northing in metres rounded to 0.01, a 2 km square
  UtmRaster,       ///< a raster of such points with a pitch of 0.25, row by row
  Slivers,         ///< within 1e-12 of a diagonal

  // At the ends of the exponent range.
  Tiny,        ///< magnitudes about 1e-300, both signs
  Huge,        ///< magnitudes about 1e300, both signs: spans overflow
  TinyAndHuge, ///< each coordinate one of the two
  AnyFinite    ///< random bits: every finite double, subnormals included
};

/// n points. The same on every platform: own generator, and of the mathematical functions only
/// those that IEEE 754 rounds correctly. @pre compiled with -ffp-contract=off.
std::vector<ahd::Point> makePoints(Distribution d, std::size_t n, std::uint64_t seed);

const char* nameOf(Distribution d);

const std::vector<Distribution>& allDistributions();
const std::vector<Distribution>& paperDistributions();

} // namespace test
} // namespace ahd

#endif
