// SPDX-License-Identifier: BSD-3-Clause
//
// What is summed up over points, for PlaneFit.cxx.
#include "../Core/Loops.h"
#include "PlaneFitWork.h"

#include <limits>

namespace ahd
{
namespace
{

constexpr std::size_t kLanesAhead = 4 * kSumLanes; ///< fetched: some processors fetch too few

/// How far along an axis the points are.
SumTerms alongAxis(const Vector3& axis, const PlaneBlock& block)
{
  SumTerms along;
  for (std::size_t lane = 0; lane < kSumLanes; ++lane)
  {
    along[lane] = axis[0] * block[0][lane] + axis[1] * block[1][lane] + axis[2] * block[2][lane];
  }
  return along;
}

SumTerms productsOf(const SumTerms& a, const SumTerms& b)
{
  SumTerms products;
  for (std::size_t lane = 0; lane < kSumLanes; ++lane)
  {
    products[lane] = a[lane] * b[lane];
  }
  return products;
}

/// The coordinates of as many points as sums take at once will be read.
void prefetchRows(const double* rows)
{
  for (std::size_t i = 0; i < 3 * kSumLanes; i += 64 / sizeof(double))
  {
    prefetchForRead(rows + i);
  }
}

} // namespace

/// Calls visit(part, block) for all points, and merges the parts into the total.
template <typename Part, typename Visit>
bool PlaneFitting::Work::visitBlocks(Part& total, Ticker& ticker, const Visit& visit) const
{
  return gather(points_.count, ticker, total,
    [&](Part& part, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; i += kSumLanes)
      {
        visit(part, read(i, std::min(end, i + kSumLanes)));
      }
    });
}

/// The coordinates of points; NaN behind the last one.
PlaneBlock PlaneFitting::Work::readPlaces(std::size_t begin, std::size_t end) const
{
  PlaneBlock block;
  if (points_.doubles && !points_.isFlat && end - begin == kSumLanes)
  {
    const double* const rows = points_.doubles + 3 * begin;
    prefetchRows(rows + 3 * kLanesAhead);
    for (std::size_t lane = 0; lane < kSumLanes; ++lane)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        block[k][lane] = rows[3 * lane + k];
      }
    }
    return block;
  }
  for (std::size_t lane = 0; lane < kSumLanes; ++lane)
  {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    const Vector3 p = begin + lane < end ? points_.place(begin + lane)
                                         : Vector3{ { kNaN, kNaN, kNaN } };
    for (std::size_t k = 0; k < 3; ++k)
    {
      block[k][lane] = p[k];
    }
  }
  return block;
}

/// Where points lie from the mean, scaled; 0 for those that do not count, and behind the last one.
PlaneBlock PlaneFitting::Work::read(std::size_t begin, std::size_t end) const
{
  PlaneBlock block = readPlaces(begin, end);
  SumTerms odd; // 0 for points that count
  for (std::size_t lane = 0; lane < kSumLanes; ++lane)
  {
    odd[lane] = block[0][lane] * 0 + block[1][lane] * 0 + block[2][lane] * 0;
  }
  for (std::size_t i = begin; points_.skip && i < end; ++i)
  {
    odd[i - begin] = points_.skipped(i) ? 1.0 : odd[i - begin];
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (std::size_t lane = 0; lane < kSumLanes; ++lane)
    {
      const double d = fromMean(block[k][lane], k);
      block[k][lane] = odd[lane] == 0 ? d : 0.0;
    }
  }
  return block;
}

bool PlaneFitting::Work::findExtent(Ticker& ticker)
{
  return gather(points_.count, ticker, around_,
    [this](PlaneExtent& part, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        points_.prefetch(i + kLanesAhead);
        const Vector3 p = points_.place(i);
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

/// Where a point lies from the mean along axis k, scaled.
double PlaneFitting::Work::fromMean(double coordinate, std::size_t k) const
{
  // scaled by half before and by half behind, so that huge numbers stay finite
  return (coordinate * factors_[0] - origin_[k] * factors_[0]) * factors_[1] - mean_[k];
}

bool PlaneFitting::Work::sumUp(Ticker& ticker)
{
  return visitBlocks(sums_, ticker,
    [](ExactSums<3>& part, const PlaneBlock& block) // from the origin: there is no mean yet
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        part[k].add(block[k]);
      }
    });
}

/// How far they reach from it along each axis.
bool PlaneFitting::Work::findReach(Ticker& ticker)
{
  return visitBlocks(reaches_, ticker,
    [this](PlaneReach& part, const PlaneBlock& block)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const SumTerms along = alongAxis(axes_[k], block);
        for (std::size_t lane = 0; lane < kSumLanes; ++lane)
        {
          part.lanes[k][lane] = std::max(part.lanes[k][lane], std::fabs(along[lane]));
        }
      }
    });
}

/// What the axes are scaled by, for products that do not get lost.
Vector3 PlaneFitting::Work::factorsOf(const Vector3& reach)
{
  Vector3 factor;
  for (std::size_t k = 0; k < 3; ++k)
  {
    int e = 0;
    std::frexp(reach[k], &e);
    factor[k] = clampedPowerOfTwo(std::min(-e, 1000));
  }
  return factor;
}

bool PlaneFitting::Work::sumUpProducts(Ticker& ticker)
{
  const Vector3 factor = factorsOf(reach_);
  return visitBlocks(products_, ticker,
    [&](ExactSums<9>& part, const PlaneBlock& block)
    {
      PlaneBlock x;
      for (std::size_t k = 0; k < 3; ++k)
      {
        x[k] = alongAxis(axes_[k], block);
        for (double& term : x[k])
        {
          term *= factor[k];
        }
        part[6 + k].add(x[k]);
      }
      std::size_t pair = 0;
      for (std::size_t i = 0; i < 3; ++i)
      {
        for (std::size_t j = i; j < 3; ++j)
        {
          part[pair++].add(productsOf(x[i], x[j]));
        }
      }
    });
}

} // namespace ahd
