// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PlaneFitWork_h
#define ahd_PlaneFitWork_h

#include "PlaneFit.h"
#include "PlanePasses.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>

namespace ahd
{

/// Around points, and how many these are.
struct PlaneExtent
{
  Vector3 low = { { DBL_MAX, DBL_MAX, DBL_MAX } };
  Vector3 high = { { -DBL_MAX, -DBL_MAX, -DBL_MAX } };
  double count = 0.0;

  void merge(const PlaneExtent& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
    count += other.count;
  }
};

/// 2^e or, where that is no double, the closest power of two that is.
inline double clampedPowerOfTwo(int e)
{
  return std::ldexp(1.0, std::max(-1022, std::min(e, 1023)));
}

/// The state of the fit.
class PlaneFitting::Work
{
public:
  Work(const PointView& points, bool areDoubles)
    : places_{ points }
    , precision_(areDoubles ? DBL_EPSILON : double(FLT_EPSILON))
  {
  }

  bool isDone() const { return step_ == Step::Done; }
  bool look(Ticker& ticker);
  void goOn();
  template <typename Visit>
  void withFound(const Visit& visit);
  const PlaneFit& fit() const { return fit_; }

private:
  enum class Step
  {
    Extent,
    Mean,
    Spread,     ///< along the coordinates' axes
    Reach,      ///< along those of its eigenvectors
    LastSpread, ///< along these
    Done
  };

  bool doesCount(const Vector3& p, std::size_t i) const
  {
    return p[0] * 0 + p[1] * 0 + p[2] * 0 == 0 && !places_.points.skipped(i);
  }
  template <typename Pass>
  bool sweep(const Pass& pass, typename Pass::Part& total, Ticker& ticker) const;
  bool findExtent(Ticker& ticker);
  void chooseOrigin();
  static Vector3 factorsOf(const Vector3& reach);
  Matrix3 spreadOfProducts() const;
  void turnAxes(Matrix3& spread);
  Vector3 reachOfExtent() const;
  Vector3 chooseNormal(const Matrix3& spread) const;
  void takeCommonCoordinate();
  double magnitude(std::size_t k) const { return std::max(-around_.low[k], around_.high[k]); }
  double largestMagnitude() const;
  double roundingAlong(const Vector3& axis) const;

  PlanePlaces places_;
  const double precision_; ///< of the coordinates
  Step step_ = Step::Extent;
  PlaneExtent around_;
  ExactSums<3> sums_;
  PlaneReach reaches_;
  ExactSums<9> products_;
  Matrix3 axes_ = { { unitAxis(0), unitAxis(1), unitAxis(2) } };
  Vector3 reach_ = { { 0, 0, 0 } }; ///< along these
  PlaneFit fit_;
};

} // namespace ahd

#endif
