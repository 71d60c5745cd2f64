// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Places_h
#define ahd_Places_h

#include "Random.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// A location in the plane.
struct Place
{
  double x;
  double y;
};

/// The next place drawn from [0, 1) x [0, 1).
Place inUnitSquare(Random& random);

/// The point of the unit circle about the origin after `turns` turns, in [0, 1), counterclockwise
/// from (1, 0). By series: the library's own sine and cosine differ between platforms.
Place onUnitCircle(double turns);

/// Place k of a random set of places in [0, 1) x [0, 1), named by a number. Any k, in any order.
Place placeOfSet(std::uint64_t set, std::uint64_t k);

/// Place i of a lattice of whole numbers that starts at (0, 0) and is filled row by row.
Place onLattice(std::size_t i, std::size_t side);

/// Side of the least square lattice that has n places or more.
std::size_t latticeSide(std::size_t n);

} // namespace ahd

#endif
