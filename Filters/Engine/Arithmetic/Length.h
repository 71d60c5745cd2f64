// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Length_h
#define ahd_Length_h

namespace ahd
{

/// A power of two that scales lengths up to this one to about 1; 1 where squares neither overflow
/// nor underflow unscaled.
double scaleOf(double length);

/// The square root of x * x + y * y + z * z, wrong by 0.5001 units in the last place at most (where
/// it is subnormal, by one). Neither overflows nor underflows before it has to; an infinite length
/// is infinite, one of NaN is NaN.
///
/// Uses only sums, products and square roots, which IEEE 754 defines: the same bits with every
/// system's library. std::hypot differs between them, most for three numbers.
double lengthOf(double x, double y, double z = 0.0);

} // namespace ahd

#endif
