// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PlanarPoints_h
#define ahd_PlanarPoints_h

/// Seeded point sets in the plane. The source vtkPlanarPointSource, the tests and the benchmarks
/// share this one copy. C++17, the standard library only.
///
/// The same bits on every platform: a generator of its own, and of the mathematical functions only
/// those that IEEE 754 rounds correctly. @pre what lies in this folder is compiled with
/// -ffp-contract=off (see Sources.cmake).
#include "Places.h"
#include "Random.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// The numbers are those of vtkPlanarPointSource, whose documentation has the formulas.
enum class PlanarDistribution
{
  // The six of the paper (Figure 10; widths are ours, the paper gives none).
  Uniform = 0, ///< in the square [0, 1) x [0, 1)
  Line = 1,    ///< a band of width 0.01 (deviation) about the diagonal of the square
  Cross = 2,   ///< such bands about both diagonals
  Circle = 3,  ///< such a band about a circle of radius 0.4
  Spiral = 4,  ///< such a band about a spiral of three turns
  Mixed = 5,   ///< half uniform, half in 20 round clusters

  Lattice = 6 ///< integer lattice, row by row, side = ceil(sqrt(n)); no point twice
};

/// Makes the points of one set, one after the other.
///
/// Of the same distribution and seed, the first n points are the same however many are meant to
/// follow; only the lattice depends on `count`, and it alone does not depend on `seed`.
class PlanarPoints
{
public:
  PlanarPoints(PlanarDistribution distribution, std::size_t count, std::uint64_t seed);

  /// The next point. @pre called at most `count` times.
  Place next();

  /// The height of hills over a point of the set, from 0 to its width w (1; of the lattice its
  /// side): w (1/2 + 3/10 sin(1.6 pi u) cos(1.3 pi v) + 1/5 cos(2.6 pi u - 1.8 pi v)), with u = x/w
  /// and v = y/w.
  double hillAt(const Place& p) const;

private:
  PlanarDistribution distribution_;
  std::uint64_t seed_;
  std::size_t side_;
  std::size_t made_ = 0;
  Random random_;
};

} // namespace ahd

#endif
