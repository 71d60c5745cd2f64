// SPDX-License-Identifier: BSD-3-Clause
//
// What is summed up over points, for PlaneFit.cxx.
#include "../Core/Loops.h"
#include "PlaneFitWork.h"

#include <limits>

namespace ahd
{
/// The coordinates of points; NaN behind the last one.
PlaneBlock PlanePlaces::readSome(std::size_t begin, std::size_t end) const
{
  PlaneBlock block;
  for (std::size_t lane = 0; lane < kSumLanes; ++lane)
  {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    const Vector3 p = begin + lane < end ? points.place(begin + lane)
                                         : Vector3{ { kNaN, kNaN, kNaN } };
    for (std::size_t k = 0; k < 3; ++k)
    {
      block[k][lane] = p[k];
    }
  }
  return block;
}

bool PlaneFitting::Work::findExtent(Ticker& ticker)
{
  const PointView& points = places_.points;
  return gather(points.count, ticker, around_,
    [&](PlaneExtent& part, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        points.prefetch(i + 4 * kSumLanes);
        const Vector3 p = points.place(i);
        if (doesCount(p, i))
        {
          for (std::size_t k = 0; k < 3; ++k)
          {
            part.low[k] = std::min(part.low[k], p[k]);
            part.high[k] = std::max(part.high[k], p[k]);
          }
          part.count += 1.0;
        }
      }
    });
}

/// Over all points; the parts that are found are merged into the total.
template <typename Pass>
bool PlaneFitting::Work::sweep(const Pass& pass, typename Pass::Part& total, Ticker& ticker) const
{
  static RunPass<Pass>* const kBest = best(kPassTargets<Pass>);
  return gather(places_.points.count, ticker, total,
    [&](typename Pass::Part& part, std::size_t begin, std::size_t end)
    { kBest(places_, pass, begin, end, part); });
}

template bool PlaneFitting::Work::sweep(const PlaneSums&, ExactSums<3>&, Ticker&) const;
template bool PlaneFitting::Work::sweep(const PlaneReaches&, PlaneReach&, Ticker&) const;
template bool PlaneFitting::Work::sweep(const PlaneProducts&, ExactSums<9>&, Ticker&) const;

} // namespace ahd
