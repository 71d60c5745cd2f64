// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PlaneFitWork_h
#define ahd_PlaneFitWork_h

#include "ExactSum.h"
#include "PlaneFit.h"

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

/// As many points as sums take at once, by coordinate.
using PlaneBlock = std::array<SumTerms, 3>;

/// How far points reach along three axes: the farthest of each lane.
struct PlaneReach
{
  PlaneBlock lanes = {};

  void merge(const PlaneReach& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      for (std::size_t lane = 0; lane < kSumLanes; ++lane)
      {
        lanes[k][lane] = std::max(lanes[k][lane], other.lanes[k][lane]);
      }
    }
  }

  Vector3 farthest() const
  {
    Vector3 most;
    for (std::size_t k = 0; k < 3; ++k)
    {
      most[k] = *std::max_element(lanes[k].begin(), lanes[k].end());
    }
    return most;
  }
};

/// 2^e or, where that is no double, the closest power of two that is.
inline double clampedPowerOfTwo(int e)
{
  return std::ldexp(1.0, std::max(-1022, std::min(e, 1023)));
}

/// What it is doing, and what it has found.
class PlaneFitting::Work
{
public:
  Work(const PointView& points, bool areDoubles)
    : points_(points)
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
    return p[0] * 0 + p[1] * 0 + p[2] * 0 == 0 && !points_.skipped(i);
  }
  template <typename Part, typename Visit>
  bool visitBlocks(Part& total, Ticker& ticker, const Visit& visit) const;
  PlaneBlock readPlaces(std::size_t begin, std::size_t end) const;
  PlaneBlock read(std::size_t begin, std::size_t end) const;
  bool findExtent(Ticker& ticker);
  void chooseOrigin();
  bool sumUp(Ticker& ticker);
  bool findReach(Ticker& ticker);
  bool sumUpProducts(Ticker& ticker);
  static Vector3 factorsOf(const Vector3& reach);
  Matrix3 spreadOfProducts() const;
  void turnAxes(Matrix3& spread);
  Vector3 reachOfExtent() const;
  Vector3 chooseNormal(const Matrix3& spread) const;
  double fromMean(double coordinate, std::size_t k) const;
  double largestMagnitude() const;

  const PointView points_;
  const double precision_; ///< of the coordinates
  Step step_ = Step::Extent;
  PlaneExtent around_;
  ExactSums<3> sums_;
  PlaneReach reaches_;
  ExactSums<9> products_; ///< of the pairs 00, 01, 02, 11, 12, 22, then the three themselves
  Matrix3 axes_ = { { unitAxis(0), unitAxis(1), unitAxis(2) } };
  Vector3 reach_ = { { 0, 0, 0 } }; ///< along these
  Vector3 origin_ = { { 0, 0, 0 } };
  Vector3 mean_ = { { 0, 0, 0 } }; ///< from the origin, scaled
  double factors_[2] = { 1, 1 };   ///< their product scales the points to 1/32 of a unit at most
  PlaneFit fit_;
};

} // namespace ahd

#endif
