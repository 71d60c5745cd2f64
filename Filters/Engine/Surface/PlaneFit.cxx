// SPDX-License-Identifier: BSD-3-Clause
#include "PlaneFit.h"

#include "Eigenvectors.h"
#include "PlaneFitWork.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace ahd
{

double PlaneFitting::Work::largestMagnitude() const
{
  return std::max({ magnitude(0), magnitude(1), magnitude(2) });
}

/// How wide points on a line may be along this axis because their coordinates are rounded: as the
/// largest is. Points that have a coordinate in common lie in a plane as it is, so of these no more
/// is taken for a line than the rounding along the axis can make.
double PlaneFitting::Work::roundingAlong(const Vector3& axis) const
{
  double largest = 0.0, along = 0.0;
  bool isFlat = false;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const bool isCommon = around_.low[k] == around_.high[k];
    const double most = isCommon ? 0.0 : (magnitude(k) * places_.factors[0]) * places_.factors[1];
    isFlat = isFlat || isCommon;
    largest = std::max(largest, most);
    along += std::fabs(axis[k]) * most;
  }
  return 2 * (isFlat ? along : largest) * precision_;
}

/// p - origin is exact for all points: where the origin is not zero, all p are three times as large
/// as they are apart, so the difference has no digit before the first or behind the last of p.
void PlaneFitting::Work::chooseOrigin()
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
      places_.origin[k] = around_.low[k];
      continue;
    }
    if (std::fabs(centre) >= 8 * (high - low))
    {
      places_.origin[k] = std::ldexp(std::nearbyint(std::ldexp(centre, -e - 1)), e + 1);
    }
    exponent = std::max(exponent, e + 1); // the extent is below 2^exponent
  }
  exponent = exponent == std::numeric_limits<int>::min() ? 0 : exponent + 5;
  places_.factors[0] = clampedPowerOfTwo(-exponent / 2);
  places_.factors[1] = clampedPowerOfTwo(-exponent - -exponent / 2);
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

/// How far the points reach from the mean along each coordinate: fromMean() is monotone.
Vector3 PlaneFitting::Work::reachOfExtent() const
{
  Vector3 reach;
  for (std::size_t k = 0; k < 3; ++k)
  {
    reach[k] = std::max(std::fabs(places_.fromMean(around_.low[k], k)),
      std::fabs(places_.fromMean(around_.high[k], k)));
  }
  return reach;
}

/// The covariance of the points in the system of the axes. Its small elements are as exact as its
/// large ones, as far as the coordinates are.
Matrix3 PlaneFitting::Work::spreadOfProducts() const
{
  const Vector3 factor = factorsOf(reach_);
  const double n = around_.count;
  Matrix3 spread;
  std::size_t pair = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = i; j < 3; ++j)
    {
      const double mean = products_[pair++].value() / n -
        (products_[6 + i].value() / n) * (products_[6 + j].value() / n);
      spread[i][j] = spread[j][i] = mean / factor[i] / factor[j];
    }
  }
  return spread;
}

Vector3 PlaneFitting::Work::chooseNormal(const Matrix3& spread) const
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
  const double rounding = roundingAlong(axes_[by[1]]);
  if (std::sqrt(std::max(0.0, spread[by[1]][by[1]])) <= rounding + 0x1p-50)
  {
    const Vector3& line = axes_[by[0]];
    const bool isSteep = std::fabs(line[2]) >
      1.000001 * std::max(std::fabs(line[0]), std::fabs(line[1]));
    return perpendicular(unitAxis(isSteep ? 1 : 2), line);
  }
  return axes_[by[2]];
}

/// Where the plane is that of a coordinate which all points have in common, it is so exactly: then
/// no place in it has to be rounded.
void PlaneFitting::Work::takeCommonCoordinate()
{
  fit_.isOfCoordinates = false;
  for (std::size_t k = 0; k < 3; ++k)
  {
    // else the points are on a line, and this is another of its planes
    if (around_.low[k] == around_.high[k] && std::fabs(fit_.normal[k]) > 0.5)
    {
      fit_ = PlaneFit();
      fit_.normal = unitAxis(k);
      fit_.height = around_.low[k];
      return;
    }
  }
}

/// Into the system of the spread's eigenvectors.
void PlaneFitting::Work::turnAxes(Matrix3& spread)
{
  const Matrix3 vectors = findEigenvectors(spread);
  Matrix3 turned;
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      turned[k][i] = vectors[0][k] * axes_[0][i] + vectors[1][k] * axes_[1][i] +
        vectors[2][k] * axes_[2][i];
    }
  }
  axes_ = turned;
}

bool PlaneFitting::Work::look(Ticker& ticker)
{
  switch (step_)
  {
    case Step::Extent:
      return findExtent(ticker) && ticker.ask();
    case Step::Mean:
      return sweep(PlaneSums{}, sums_, ticker); // from the origin: there is no mean yet
    case Step::Reach:
      return sweep(PlaneReaches{ axes_ }, reaches_, ticker);
    default:
      products_ = ExactSums<9>();
      return sweep(PlaneProducts{ axes_, factorsOf(reach_) }, products_, ticker);
  }
}

void PlaneFitting::Work::goOn()
{
  switch (step_)
  {
    case Step::Extent:
      step_ = around_.count == 0 ? Step::Done : Step::Mean;
      if (step_ == Step::Mean)
      {
        chooseOrigin();
      }
      return;
    case Step::Mean:
      for (std::size_t k = 0; k < 3; ++k)
      {
        places_.mean[k] = sums_[k].value() / around_.count;
      }
      reach_ = reachOfExtent();
      step_ = Step::Spread;
      return;
    case Step::Reach:
      reach_ = reaches_.farthest();
      step_ = Step::LastSpread;
      return;
    default:
      break;
  }
  // Twice: in the system that the first round finds, the second sees small differences beside large
  // ones, as of a thin band.
  Matrix3 spread = spreadOfProducts();
  turnAxes(spread);
  if (step_ == Step::Spread)
  {
    step_ = Step::Reach;
    return;
  }
  fit_.normal = chooseNormal(spread);
  fit_.origin = places_.origin;
  fit_.height = dot(fit_.normal, places_.mean) / places_.factors[0] / places_.factors[1];
  fit_.shrink = largestMagnitude() > 0x1p1000 ? 0x1p-32 : 1.0;
  takeCommonCoordinate();
  step_ = Step::Done;
}

// ------------------------------------------------------------------------------- of several parts

/// Calls visit(what this step finds).
template <typename Visit>
void PlaneFitting::Work::withFound(const Visit& visit)
{
  switch (step_)
  {
    case Step::Extent:
      return visit(around_);
    case Step::Mean:
      return visit(sums_);
    case Step::Reach:
      return visit(reaches_);
    default:
      return visit(products_);
  }
}

PlaneFitting::PlaneFitting(const PointView& points, bool areDoubles)
  : work_(new Work(points, areDoubles))
{
}

PlaneFitting::~PlaneFitting() = default;

bool PlaneFitting::isDone() const
{
  return work_->isDone();
}

bool PlaneFitting::look(Ticker& ticker)
{
  return work_->look(ticker);
}

const PlaneFit& PlaneFitting::fit() const
{
  return work_->fit();
}

void PlaneFitting::tell(std::vector<unsigned char>& bytes) const
{
  work_->withFound(
    [&bytes](const auto& part)
    {
      static_assert(
        std::is_trivially_copyable<std::decay_t<decltype(part)>>::value, "told as bytes");
      bytes.resize(sizeof(part));
      std::memcpy(bytes.data(), &part, sizeof(part));
    });
}

void PlaneFitting::goOn()
{
  work_->goOn();
}

void PlaneFitting::hear(const std::vector<std::vector<unsigned char>>& all)
{
  work_->withFound(
    [&all](auto& part)
    {
      part = std::decay_t<decltype(part)>();
      for (const std::vector<unsigned char>& bytes : all)
      {
        std::decay_t<decltype(part)> other;
        std::memcpy(&other, bytes.data(), sizeof(other));
        part.merge(other);
      }
    });
  work_->goOn();
}

bool fitPlane(const PointView& points, Ticker& ticker, PlaneFit& fit)
{
  PlaneFitting fitting(points, points.doubles != nullptr);
  while (!fitting.isDone())
  {
    if (!fitting.look(ticker))
    {
      return false;
    }
    fitting.goOn();
  }
  fit = fitting.fit();
  return true;
}

} // namespace ahd
