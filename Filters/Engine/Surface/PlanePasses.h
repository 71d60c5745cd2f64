// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PlanePasses_h
#define ahd_PlanePasses_h

#include "../Core/Dispatch.h"
#include "../Points/Points.h"
#include "ExactSum.h"
#include "Vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ahd
{

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

/// Points, and where they are measured from.
struct PlanePlaces
{
  PointView points;
  Vector3 origin = { { 0, 0, 0 } };
  Vector3 mean = { { 0, 0, 0 } }; ///< from the origin, scaled
  double factors[2] = { 1, 1 };   ///< their product scales the points to 1/32 of a unit at most

  /// Where a point lies from the mean along axis k, scaled.
  AHD_ALWAYS_INLINE double fromMean(double coordinate, std::size_t k) const
  {
    // scaled by half before and by half behind, so that huge numbers stay finite
    return (coordinate * factors[0] - origin[k] * factors[0]) * factors[1] - mean[k];
  }

  AHD_ALWAYS_INLINE PlaneBlock read(std::size_t begin, std::size_t end) const;

private:
  AHD_ALWAYS_INLINE PlaneBlock readAll(const double* rows) const;
  PlaneBlock readSome(std::size_t begin, std::size_t end) const;
};

/// The coordinates of as many points as a block has.
PlaneBlock PlanePlaces::readAll(const double* rows) const
{
  constexpr std::size_t kAhead = 4 * kSumLanes; // some processors fetch too few by themselves
  for (std::size_t i = 0; i < 3 * kSumLanes; i += 64 / sizeof(double))
  {
    prefetchForRead(rows + 3 * kAhead + i);
  }
  PlaneBlock block;
  for (std::size_t lane = 0; lane < kSumLanes; ++lane)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      block[k][lane] = rows[3 * lane + k];
    }
  }
  return block;
}

/// Where points lie from the mean, scaled; 0 for those that do not count, and behind the last one.
PlaneBlock PlanePlaces::read(std::size_t begin, std::size_t end) const
{
  const bool areRows = points.doubles && points.stride == 3 && !points.isFlat;
  const bool isWhole = areRows && end - begin == kSumLanes;
  PlaneBlock block = isWhole ? readAll(points.doubles + 3 * begin) : readSome(begin, end);
  SumTerms odd; // 0 for points that count
  for (std::size_t lane = 0; lane < kSumLanes; ++lane)
  {
    odd[lane] = block[0][lane] * 0 + block[1][lane] * 0 + block[2][lane] * 0;
  }
  for (std::size_t i = begin; points.skip && i < end; ++i)
  {
    odd[i - begin] = points.skipped(i) ? 1.0 : odd[i - begin];
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

/// How far along an axis the points are.
AHD_ALWAYS_INLINE SumTerms alongAxis(const Vector3& axis, const PlaneBlock& block)
{
  SumTerms along;
  for (std::size_t lane = 0; lane < kSumLanes; ++lane)
  {
    along[lane] = axis[0] * block[0][lane] + axis[1] * block[1][lane] + axis[2] * block[2][lane];
  }
  return along;
}

// Results for a block. Each is a pass over points, see runPass().

/// Sums, for the mean.
struct PlaneSums
{
  using Part = ExactSums<3>;

  AHD_ALWAYS_INLINE void add(const PlaneBlock& block, Part& part) const
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      part[k].add(block[k]);
    }
  }
};

/// How far they reach from the mean along each axis.
struct PlaneReaches
{
  using Part = PlaneReach;

  AHD_ALWAYS_INLINE void add(const PlaneBlock& block, Part& part) const
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const SumTerms along = alongAxis(axes[k], block);
      for (std::size_t lane = 0; lane < kSumLanes; ++lane)
      {
        part.lanes[k][lane] = std::max(part.lanes[k][lane], std::fabs(along[lane]));
      }
    }
  }

  const Matrix3& axes;
};

/// Sums of products along the axes: of the pairs 00, 01, 02, 11, 12, 22; then those of the three
/// themselves.
struct PlaneProducts
{
  using Part = ExactSums<9>;

  AHD_ALWAYS_INLINE void add(const PlaneBlock& block, Part& part) const
  {
    PlaneBlock x;
    for (std::size_t k = 0; k < 3; ++k)
    {
      x[k] = alongAxis(axes[k], block);
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
        SumTerms products;
        for (std::size_t lane = 0; lane < kSumLanes; ++lane)
        {
          products[lane] = x[i][lane] * x[j][lane];
        }
        part[pair++].add(products);
      }
    }
  }

  const Matrix3& axes;
  const Vector3 factor; ///< what the axes are scaled by, for products that do not get lost
};

template <typename Pass>
AHD_ALWAYS_INLINE void passOver(const PlanePlaces& places, const Pass& pass, std::size_t begin,
  std::size_t end, typename Pass::Part& part)
{
  for (std::size_t i = begin; i < end; i += kSumLanes)
  {
    pass.add(places.read(i, std::min(end, i + kSumLanes)), part);
  }
}

template <typename Pass>
void passBaseline(const PlanePlaces& places, const Pass& pass, std::size_t begin, std::size_t end,
  typename Pass::Part& part)
{
  passOver(places, pass, begin, end, part);
}

template <typename Pass>
AHD_FOR_AVX2 void passAvx2(const PlanePlaces& places, const Pass& pass, std::size_t begin,
  std::size_t end, typename Pass::Part& part)
{
  passOver(places, pass, begin, end, part);
}

template <typename Pass>
AHD_FOR_AVX512 void passAvx512(const PlanePlaces& places, const Pass& pass, std::size_t begin,
  std::size_t end, typename Pass::Part& part)
{
  passOver(places, pass, begin, end, part);
}

template <typename Pass>
using RunPass = void(const PlanePlaces& places, const Pass& pass, std::size_t begin,
  std::size_t end, typename Pass::Part& part);

/// Adds what the points of [begin, end) have to the part, with the same results on all processors.
template <typename Pass>
constexpr DispatchTarget<RunPass<Pass>> kPassTargets[3] = {
  { InstructionSet::Baseline, passBaseline<Pass> },
  { InstructionSet::Avx2, passAvx2<Pass> },
  { InstructionSet::Avx512, passAvx512<Pass> },
};

} // namespace ahd

#endif
