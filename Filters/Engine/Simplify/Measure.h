// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Measure_h
#define ahd_Measure_h

#include "../Arithmetic/DoubleDouble.h"
#include "../Arithmetic/PowerOfTwo.h"
#include "../Points/Points.h"

#include <array>

namespace ahd
{

/// A point, and its value.
struct Sample
{
  Point at;
  double value;
};

/// The linear interpolation in a triangle. It is the same for its corners in any order, and up to
/// overflow for coordinates times a power of two.
class Interpolant
{
public:
  explicit Interpolant(const std::array<Sample, 3>& corners);

  /// |value - interpolation|, rounded; infinity if it is no number.
  double error(const Sample& p) const;

  /// The error times the weight: rounded where that is certainly not above the bound, else that of
  /// wideError().
  double measure(const Sample& p, double weight, double bound) const;

  /// Is the error times the weight certainly not above the bound? `error`: that of error(p).
  ///
  /// Let u = 2^-53, and let the size of a difference of two products be the sum of their
  /// magnitudes. Edges are rounded once, so a weight of a corner is wrong by at most 4 u times its
  /// size, and so is the divisor. With M the sum over both corners of the size of its weight times
  /// the magnitude of its difference of values, and D the divisor's size over its magnitude, the
  /// interpolation is wrong by less than 16 u (M / divisor) (1 + D) as long as 4 u D < 1/8, and by
  /// 4 u times the magnitudes of the values. Twice that is taken.
  bool isSurelyWithin(const Sample& p, double error, double weight, double bound) const;

  /// The error times the weight with 100 bits, rounded; above the bound if and only if the one
  /// with 100 bits is. Infinity for triangles too thin for these.
  double wideError(const Sample& p, double weight, double bound) const;

private:
  Sample a_, b_, c_;
  double scale_;               ///< a power of two that brings the edges near to 1
  double bx_, by_, cx_, cy_;   ///< edges from a
  double divisor_, toB_, toC_; ///< of values
};

} // namespace ahd

#endif
