// SPDX-License-Identifier: BSD-3-Clause
#include "PlaneFit.h"

#include "../Core/Loops.h"
#include "ExactSum.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

namespace ahd
{
namespace
{

using Xyz = Vector3;
using Matrix = Matrix3;

/// Around points, and how many these are.
struct Extent
{
  Xyz low = { { DBL_MAX, DBL_MAX, DBL_MAX } };
  Xyz high = { { -DBL_MAX, -DBL_MAX, -DBL_MAX } };
  double count = 0.0;

  void merge(const Extent& other)
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
using Block = std::array<SumTerms, 3>;

/// How far points reach along three axes: the farthest of each lane.
struct Reach
{
  Block lanes = {};

  void merge(const Reach& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      for (std::size_t lane = 0; lane < kSumLanes; ++lane)
      {
        lanes[k][lane] = std::max(lanes[k][lane], other.lanes[k][lane]);
      }
    }
  }

  Xyz farthest() const
  {
    Xyz most;
    for (std::size_t k = 0; k < 3; ++k)
    {
      most[k] = *std::max_element(lanes[k].begin(), lanes[k].end());
    }
    return most;
  }
};

/// 2^e or, where that is no double, the closest power of two that is.
double powerOfTwo(int e)
{
  return std::ldexp(1.0, std::max(-1022, std::min(e, 1023)));
}

/// Turns columns p and q of `vectors` so that element p, q of `a` becomes zero: one step of
/// Jacobi's method. REQUIRES: the element is not zero.
void rotate(Matrix& a, Matrix& vectors, std::size_t p, std::size_t q)
{
  const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
  const double t = (theta < 0 ? -1.0 : 1.0) / (std::fabs(theta) + std::sqrt(theta * theta + 1.0));
  const double c = 1.0 / std::sqrt(t * t + 1.0);
  const double s = t * c;
  const std::size_t r = 3 - p - q;
  a[p][p] -= t * a[p][q];
  a[q][q] += t * a[p][q];
  a[p][q] = a[q][p] = 0.0;
  const double rp = a[r][p];
  const double rq = a[r][q];
  a[r][p] = a[p][r] = c * rp - s * rq;
  a[r][q] = a[q][r] = s * rp + c * rq;
  for (Xyz& row : vectors)
  {
    const double vp = row[p];
    const double vq = row[q];
    row[p] = c * vp - s * vq;
    row[q] = s * vp + c * vq;
  }
}

/// The eigenvectors, as columns, of a symmetric matrix with no negative eigenvalue; its diagonal
/// becomes the eigenvalues. Small eigenvalues are as exact as large ones where the elements allow
/// it, as an element counts as zero only in comparison with its own two diagonal elements.
Matrix findEigenvectors(Matrix& a)
{
  Matrix vectors = { { unitAxis(0), unitAxis(1), unitAxis(2) } };
  constexpr int kMostSweeps = 50; // 5 to 8 do
  for (int sweep = 0; sweep < kMostSweeps; ++sweep)
  {
    bool turned = false;
    for (std::size_t r = 0; r < 3; ++r)
    {
      const std::size_t p = r == 0 ? 1 : 0;
      const std::size_t q = r == 2 ? 1 : 2;
      const double both = std::sqrt(std::fabs(a[p][p])) * std::sqrt(std::fabs(a[q][q]));
      if (std::fabs(a[p][q]) > 0x1p-54 * both)
      {
        rotate(a, vectors, p, q);
        turned = true;
      }
    }
    if (!turned)
    {
      break;
    }
  }
  return vectors;
}

/// How far along an axis the points are.
SumTerms alongAxis(const Xyz& axis, const Block& block)
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

/// One call of fitPlane(). What returns a bool returns false if the work is to be cancelled.
class Fitting
{
public:
  Fitting(const PointView& points, Ticker& ticker)
    : points_(points)
    , ticker_(ticker)
  {
  }

  bool run(PlaneFit& fit);

private:
  bool doesCount(const Xyz& p, std::size_t i) const
  {
    return p[0] * 0 + p[1] * 0 + p[2] * 0 == 0 && !points_.skipped(i);
  }
  template <typename Part, typename Visit>
  bool visitBlocks(Part& total, const Visit& visit);
  Block readPlaces(std::size_t begin, std::size_t end) const;
  Block read(std::size_t begin, std::size_t end) const;
  bool findExtent();
  void chooseOrigin();
  bool findMean();
  bool findSpread(const Matrix& axes, const Xyz& reach, Matrix& spread);
  bool findReach(const Matrix& axes, Xyz& reach);
  Xyz reachOfExtent() const;
  Xyz chooseNormal(const Matrix& axes, const Matrix& spread) const;
  double fromMean(double coordinate, std::size_t k) const;
  double largestMagnitude() const;

  const PointView& points_;
  Ticker& ticker_;
  Extent around_;
  Xyz origin_ = { { 0, 0, 0 } };
  Xyz mean_ = { { 0, 0, 0 } };   ///< from the origin, scaled
  double factors_[2] = { 1, 1 }; ///< their product scales the points to 1/32 of a unit at most
};

/// Calls visit(part, block) for all points, and merges the parts into the total.
template <typename Part, typename Visit>
bool Fitting::visitBlocks(Part& total, const Visit& visit)
{
  return gather(points_.count, ticker_, total,
    [&](Part& part, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; i += kSumLanes)
      {
        visit(part, read(i, std::min(end, i + kSumLanes)));
      }
    });
}

/// The coordinates of points; NaN behind the last one.
Block Fitting::readPlaces(std::size_t begin, std::size_t end) const
{
  Block block;
  if (points_.doubles && !points_.isFlat && end - begin == kSumLanes)
  {
    const double* const rows = points_.doubles + 3 * begin;
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
    const Xyz p = begin + lane < end ? points_.place(begin + lane) : Xyz{ { kNaN, kNaN, kNaN } };
    for (std::size_t k = 0; k < 3; ++k)
    {
      block[k][lane] = p[k];
    }
  }
  return block;
}

/// Where points lie from the mean, scaled; 0 for those that do not count, and behind the last one.
Block Fitting::read(std::size_t begin, std::size_t end) const
{
  Block block = readPlaces(begin, end);
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

bool Fitting::findExtent()
{
  return gather(points_.count, ticker_, around_,
    [this](Extent& part, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Xyz p = points_.place(i);
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

/// The largest magnitude of a coordinate.
double Fitting::largestMagnitude() const
{
  double largest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    largest = std::max({ largest, -around_.low[k], around_.high[k] });
  }
  return largest;
}

/// p - origin is exact for all points: where the origin is not zero, all p are three times as large
/// as they are apart, so the difference has no digit before the first or behind the last of p.
void Fitting::chooseOrigin()
{
  int exponent = std::numeric_limits<int>::min();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double low = around_.low[k] / 2;
    const double high = around_.high[k] / 2;
    const double centre = low + high;
    int e = 0;
    std::frexp(high - low, &e); // half the extent is below 2^e
    if (high == low)
    {
      origin_[k] = around_.low[k];
      continue;
    }
    if (std::fabs(centre) >= 8 * (high - low))
    {
      origin_[k] = std::ldexp(std::nearbyint(std::ldexp(centre, -e - 1)), e + 1);
    }
    exponent = std::max(exponent, e + 1); // the extent is below 2^exponent
  }
  exponent = exponent == std::numeric_limits<int>::min() ? 0 : exponent + 5;
  factors_[0] = powerOfTwo(-exponent / 2);
  factors_[1] = powerOfTwo(-exponent - -exponent / 2);
}

/// Where a point lies from the mean along axis k, scaled.
double Fitting::fromMean(double coordinate, std::size_t k) const
{
  // scaled by half before and by half behind, so that huge numbers stay finite
  return (coordinate * factors_[0] - origin_[k] * factors_[0]) * factors_[1] - mean_[k];
}

bool Fitting::findMean()
{
  ExactSums<3> sums;
  const bool all = visitBlocks(sums,
    [](ExactSums<3>& part, const Block& block) // from the origin: there is no mean yet
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        part[k].add(block[k]);
      }
    });
  for (std::size_t k = 0; k < 3; ++k)
  {
    mean_[k] = sums[k].value() / around_.count;
  }
  return all;
}

/// How far the points reach from the mean along each coordinate: fromMean() is monotone.
Xyz Fitting::reachOfExtent() const
{
  Xyz reach;
  for (std::size_t k = 0; k < 3; ++k)
  {
    reach[k] = std::max(
      std::fabs(fromMean(around_.low[k], k)), std::fabs(fromMean(around_.high[k], k)));
  }
  return reach;
}

/// How far they reach from it along each axis.
bool Fitting::findReach(const Matrix& axes, Xyz& reach)
{
  Reach found;
  const bool all = visitBlocks(found,
    [&axes](Reach& part, const Block& block)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const SumTerms along = alongAxis(axes[k], block);
        for (std::size_t lane = 0; lane < kSumLanes; ++lane)
        {
          part.lanes[k][lane] = std::max(part.lanes[k][lane], std::fabs(along[lane]));
        }
      }
    });
  reach = found.farthest();
  return all;
}

/// The covariance of the points in the system of these axes. Its small elements are as exact as its
/// large ones, as far as the coordinates are.
bool Fitting::findSpread(const Matrix& axes, const Xyz& reach, Matrix& spread)
{
  Xyz factor;
  for (std::size_t k = 0; k < 3; ++k)
  {
    int e = 0;
    std::frexp(reach[k], &e);
    factor[k] = powerOfTwo(std::min(-e, 1000));
  }
  ExactSums<9> sums; // products of the pairs 00, 01, 02, 11, 12, 22, then the three themselves
  const bool all = visitBlocks(sums,
    [&](ExactSums<9>& part, const Block& block)
    {
      Block x;
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
          part[pair++].add(productsOf(x[i], x[j]));
        }
      }
    });
  const double n = around_.count;
  std::size_t pair = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = i; j < 3; ++j)
    {
      const double mean = sums[pair++].value() / n -
        (sums[6 + i].value() / n) * (sums[6 + j].value() / n);
      spread[i][j] = spread[j][i] = mean / factor[i] / factor[j];
    }
  }
  return all;
}

Xyz Fitting::chooseNormal(const Matrix& axes, const Matrix& spread) const
{
  std::array<std::size_t, 3> by = { { 0, 1, 2 } }; // decreasing spread
  std::sort(by.begin(), by.end(),
    [&](std::size_t i, std::size_t j)
    { return spread[i][i] > spread[j][j] || (spread[i][i] == spread[j][j] && i < j); });
  if (spread[by[0]][by[0]] <= 0)
  {
    return unitAxis(2);
  }
  // A width that the rounding of the coordinates alone would make is none.
  const double precision = points_.doubles ? DBL_EPSILON : double(FLT_EPSILON);
  const double rounding = 2 * (largestMagnitude() * factors_[0]) * factors_[1] * precision;
  if (std::sqrt(std::max(0.0, spread[by[1]][by[1]])) <= rounding + 0x1p-50)
  {
    const Xyz& line = axes[by[0]];
    const bool isSteep = std::fabs(line[2]) >
      1.000001 * std::max(std::fabs(line[0]), std::fabs(line[1]));
    return perpendicular(unitAxis(isSteep ? 1 : 2), line);
  }
  return axes[by[2]];
}

bool Fitting::run(PlaneFit& fit)
{
  if (!findExtent() || around_.count == 0)
  {
    return ticker_.ask();
  }
  chooseOrigin();
  if (!findMean())
  {
    return false;
  }
  // Twice: in the system that the first round finds, the second sees small differences beside large
  // ones, as of a thin band.
  Matrix spread;
  Matrix axes = { { unitAxis(0), unitAxis(1), unitAxis(2) } };
  Xyz reach = reachOfExtent();
  for (int round = 0; round < 2; ++round)
  {
    if ((round > 0 && !findReach(axes, reach)) || !findSpread(axes, reach, spread))
    {
      return false;
    }
    const Matrix vectors = findEigenvectors(spread);
    Matrix turned;
    for (std::size_t k = 0; k < 3; ++k)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        turned[k][i] = vectors[0][k] * axes[0][i] + vectors[1][k] * axes[1][i] +
          vectors[2][k] * axes[2][i];
      }
    }
    axes = turned;
  }
  fit.normal = chooseNormal(axes, spread);
  fit.origin = origin_;
  fit.height = dot(fit.normal, mean_) / factors_[0] / factors_[1];
  fit.shrink = largestMagnitude() > 0x1p1000 ? 0x1p-32 : 1.0;
  return true;
}

} // namespace

bool fitPlane(const PointView& points, Ticker& ticker, PlaneFit& fit)
{
  return Fitting(points, ticker).run(fit);
}

} // namespace ahd
