// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Distributions_h
#define ahd_Distributions_h

#include "Points/Points.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{
namespace test
{

/// Kinds of point sets that tests and benchmarks share. "In the square" means in [0, 1) x [0, 1).
enum class Distribution
{
  // The six of the paper (Figure 10; widths are ours, the paper gives none).
  Uniform, ///< in the square
  Line,    ///< a band of width 0.01 (deviation) about the diagonal of the square
  Cross,   ///< such bands about both diagonals
  Circle,  ///< such a band about a circle of radius 0.4
  Spiral,  ///< such a band about a spiral of three turns
  Mixed,   ///< half uniform, half in 20 round clusters

  // Strongly clustered.
  KuzminDisc,     ///< density (1 + r^2)^(-3/2) about a centre: a crowd in a very large box
  NestedClusters, ///< clusters within clusters, six deep, each 1/64 as wide as its parent
  CrowdedBox,     ///< 9 of 10 points in one box of 31623 x 31623 (10^9) boxes, the rest uniform

  // Degenerate or nearly so.
  Lattice,         ///< integer lattice, row by row, side = ceil(sqrt(n)); no point twice
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
/// those that IEEE 754 rounds correctly. REQUIRES: compiled with -ffp-contract=off.
std::vector<ahd::Point> makePoints(Distribution d, std::size_t n, std::uint64_t seed);

const char* nameOf(Distribution d);

const std::vector<Distribution>& allDistributions();
const std::vector<Distribution>& paperDistributions();

/// Small generator (splitmix64), for shuffles and choices in tests.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : state_(seed)
  {
  }
  std::uint64_t bits();
  double unit();                    ///< in [0, 1), multiples of 2^-53
  std::size_t below(std::size_t n); ///< in [0, n), n > 0
  double bell();                    ///< mean 0, deviation 1, within 6 (sum of 12 units)

private:
  std::uint64_t state_;
};

} // namespace test
} // namespace ahd

#endif
