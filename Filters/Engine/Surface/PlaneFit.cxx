// SPDX-License-Identifier: BSD-3-Clause
#include "PlaneFit.h"

#include "../Arithmetic/DoubleDouble.h"
#include "../Core/Loops.h"
#include "Eigenvectors.h"
#include "PlaneMoments.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace ahd
{
namespace
{

using WideMatrix = std::array<std::array<DoubleDouble, 3>, 3>;

/// Axes of unit length, and how far points spread along each: squared deviations.
struct Spread
{
  Matrix3 axes = { { unitAxis(0), unitAxis(1), unitAxis(2) } };
  Vector3 along = {};
  std::array<std::size_t, 3> by = { { 0, 1, 2 } }; ///< in the order of decreasing spread

  double deviation(std::size_t rank) const { return std::sqrt(std::max(0.0, along[by[rank]])); }
};

/// The number, wrong by less than 2^-100 of itself.
template <int N>
DoubleDouble rounded(const WideInteger<N>& whole)
{
  DoubleDouble sum;
  for (int i = whole.size; i-- > 0;)
  {
    const double high = static_cast<double>(whole.word[i] >> 32) * 0x1p32;
    const double low = static_cast<double>(whole.word[i] & 0xFFFFFFFFu);
    sum = sum + scaled(exactSum(high, low), std::ldexp(1.0, 64 * i));
  }
  return whole.negative ? -sum : sum;
}

DoubleDouble shifted(const DoubleDouble& a, int exponent)
{
  return { std::ldexp(a.high, exponent), std::ldexp(a.low, exponent) };
}

/// The matrix in the system of the axes, rounded. Small elements are as exact as large ones.
Matrix3 seenAlong(const Matrix3& axes, const WideMatrix& matrix)
{
  Matrix3 seen;
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t b = a; b < 3; ++b)
    {
      DoubleDouble sum;
      for (std::size_t i = 0; i < 3; ++i)
      {
        DoubleDouble row;
        for (std::size_t j = 0; j < 3; ++j)
        {
          row = row + matrix[i][j] * DoubleDouble{ axes[b][j], 0.0 };
        }
        sum = sum + row * DoubleDouble{ axes[a][i], 0.0 };
      }
      seen[a][b] = seen[b][a] = sum.value();
    }
  }
  return seen;
}

/// Turns the axes to the eigenvectors of a matrix in their system; its diagonal becomes the
/// eigenvalues.
void turn(Matrix3& axes, Matrix3& seen)
{
  const Matrix3 vectors = findEigenvectors(seen);
  Matrix3 turned;
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

/// Along the eigenvectors. Twice: in the system that the first round finds, the second sees small
/// differences beside large ones, as of a thin band.
Spread spreadOf(const WideMatrix& covariance)
{
  Spread spread;
  Matrix3 seen = seenAlong(spread.axes, covariance);
  turn(spread.axes, seen);
  seen = seenAlong(spread.axes, covariance);
  turn(spread.axes, seen);
  spread.along = { { seen[0][0], seen[1][1], seen[2][2] } };
  const Vector3& along = spread.along;
  std::sort(spread.by.begin(), spread.by.end(),
    [&along](std::size_t i, std::size_t j)
    { return along[i] > along[j] || (along[i] == along[j] && i < j); });
  return spread;
}

} // namespace

/// The state of the fit.
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
  /// Calls visit(the parts that this step sums up).
  template <typename Visit>
  void withFound(const Visit& visit)
  {
    step_ == Step::Extent      ? visit(around_)
      : step_ == Step::Moments ? visit(moments_)
                               : visit(levels_);
  }
  const PlaneFit& fit() const { return fit_; }

private:
  enum class Step
  {
    Extent,
    Moments,
    Levels, ///< only if the plane is steep
    Done
  };

  template <typename Part, typename Add>
  bool sweep(Part& total, const Add& add, Ticker& ticker) const;
  void chooseScales();
  WideMatrix covariance() const;
  Vector3 mean() const;
  void choosePlane();
  Vector3 chooseNormal(const Spread& spread) const;
  void findFootprint(WideMatrix covariance);
  bool lookAtLevels(Ticker& ticker);
  void takeCommonCoordinate();
  double magnitude(std::size_t k) const { return std::max(-around_.low[k], around_.high[k]); }
  bool isLine(const Spread& spread, std::size_t coordinates) const;

  const PointView points_;
  const double precision_; ///< of the coordinates
  Step step_ = Step::Extent;
  PlaneExtent around_;
  std::array<PlaneScale, 3> scales_;
  int unit_ = 0; ///< the points are apart by a 32nd of 2^unit_ at most
  PlaneMoments moments_;
  Footprint footprint_;                   ///< in units
  double upright_ = 1.0, flatness_ = 0.0; ///< see stanceOf()
  CellLevels levels_;
  PlaneFit fit_;
};

/// Calls add(part, place) for all points that count; the parts become the total.
template <typename Part, typename Add>
bool PlaneFitting::Work::sweep(Part& total, const Add& add, Ticker& ticker) const
{
  const PointView& points = points_;
  return gather(points.count, ticker, total,
    [&points, &add](Part& part, std::size_t begin, std::size_t end)
    {
      constexpr std::size_t kAhead = 96;
      Part own; // local: no false sharing, no aliasing
      for (std::size_t i = begin; i < end; ++i)
      {
        points.prefetch(i + kAhead);
        const Vector3 p = points.place(i);
        if (p[0] * 0 + p[1] * 0 + p[2] * 0 == 0 && !points.skipped(i))
        {
          add(own, p);
        }
      }
      part.merge(own);
    });
}

bool PlaneFitting::Work::look(Ticker& ticker)
{
  if (step_ == Step::Extent)
  {
    return sweep(
             around_, [](PlaneExtent& part, const Vector3& p) { part.add(p); }, ticker) &&
      ticker.ask();
  }
  if (step_ == Step::Levels)
  {
    return lookAtLevels(ticker);
  }
  const std::array<PlaneScale, 3> scales = scales_;
  const auto add = [&scales](PlaneMoments& part, const Vector3& p) {
    part.add({ { scales[0](p[0]), scales[1](p[1]), scales[2](p[2]) } });
  };
  return sweep(moments_, add, ticker);
}

bool PlaneFitting::Work::lookAtLevels(Ticker& ticker)
{
  const PowerOfTwo perUnit = powerOfTwo(-unit_);
  const Vector3 mean = this->mean();
  const std::array<PlaneScale, 3> scales = scales_;
  const Footprint footprint = footprint_;
  const int bitsAcross = footprint.bitsAcross();
  const auto add = [&](CellLevels& part, const Vector3& p)
  {
    Vector3 d;
    for (std::size_t k = 0; k < 3; ++k)
    {
      // The difference is exact; either alone may be too large for the factor.
      d[k] = (p[k] - scales[k].origin) * perUnit.first * perUnit.second - mean[k];
    }
    part.add(footprint.cell(d, bitsAcross), footprint.level(d));
  };
  return sweep(levels_, add, ticker);
}

void PlaneFitting::Work::goOn()
{
  if (step_ == Step::Moments)
  {
    choosePlane();
    if (upright_ < Stance::kSteep && footprint_.length > 0.0)
    {
      step_ = Step::Levels;
      return;
    }
  }
  else if (step_ == Step::Levels)
  {
    fit_.stance = stanceOf(footprint_, levels_, upright_, flatness_);
  }
  else if (around_.count != 0)
  {
    chooseScales();
    step_ = Step::Moments;
    return;
  }
  step_ = Step::Done;
}

/// p - origin is exact for all points: where the origin is not zero, all p are three times as large
/// as they are apart, so the difference has no digit above the first or below the last of p.
void PlaneFitting::Work::chooseScales()
{
  int exponent = std::numeric_limits<int>::min();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double low = around_.low[k], high = around_.high[k];
    const double centre = low / 2 + high / 2;
    double origin = low;
    if (low != high)
    {
      const double half = std::max(high / 2 - low / 2, std::numeric_limits<double>::denorm_min());
      int e = 0;
      std::frexp(half, &e); // half the extent is below 2^e
      origin = 0.0;
      if (std::fabs(centre) >= 8 * half)
      {
        const double steps = std::ldexp(centre, -e - 1);
        origin = std::ldexp(std::nearbyint(steps), e + 1);
        origin = std::isinf(origin) ? std::ldexp(std::trunc(steps), e + 1) : origin;
      }
      exponent = std::max(exponent, e + 1); // the extent is below 2^exponent
    }
    scales_[k] = PlaneScale(origin, std::max(std::fabs(low - origin), std::fabs(high - origin)));
    fit_.origin[k] = origin;
  }
  unit_ = exponent == std::numeric_limits<int>::min() ? 0 : exponent + 5;
}

/// In squares of units. The exact one of the whole numbers, n sum(x y) - sum(x) sum(y) over n n,
/// but for rounding in the end.
WideMatrix PlaneFitting::Work::covariance() const
{
  WideInteger<1> n; // by wideFrom() its word may be unset, says g++ 12 with -fsanitize
  n.push(static_cast<std::uint64_t>(around_.count));
  n.dropLeadingZeros();
  const DoubleDouble count{ around_.count, 0.0 };
  WideMatrix result;
  for (std::size_t k = 0; k < 6; ++k)
  {
    const std::size_t i = PlaneMoments::kFirst[k], j = PlaneMoments::kSecond[k];
    const auto times = n * moments_.product[k].value() -
      moments_.single[i].value() * moments_.single[j].value();
    const int exponent = scales_[i].exponent + scales_[j].exponent - 2 * unit_;
    result[i][j] = result[j][i] = shifted(rounded(times) / count / count, exponent);
  }
  return result;
}

/// From the origin, in units.
Vector3 PlaneFitting::Work::mean() const
{
  Vector3 mean;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto zeros = wideFrom<WideInteger<2>>(
      static_cast<std::uint64_t>(around_.count), PlaneScale::kBits, false);
    const double sum = rounded(moments_.single[k].value() - zeros).value();
    mean[k] = std::ldexp(sum / around_.count, scales_[k].exponent - unit_);
  }
  return mean;
}

void PlaneFitting::Work::choosePlane()
{
  const WideMatrix matrix = covariance();
  const Spread spread = spreadOf(matrix);
  fit_.normal = chooseNormal(spread);
  upright_ = std::fabs(fit_.normal[2]);
  flatness_ = isLine(spread, 3) ? 1.0 : spread.deviation(2) / spread.deviation(1);
  findFootprint(matrix);
  const PowerOfTwo unit = powerOfTwo(unit_);
  fit_.shrink = std::max({ magnitude(0), magnitude(1), magnitude(2) }) > 0x1p1000 ? 0x1p-32 : 1.0;
  fit_.height = dot(fit_.normal, mean()) * fit_.shrink * unit.first * unit.second;
  takeCommonCoordinate();
}

/// Are points with this spread in two or three coordinates on a line, but for a width that rounding
/// of the coordinates, as of the largest, can cause? Points that have a coordinate in common lie in
/// a plane anyway: these are taken for a line only within the rounding along the width.
bool PlaneFitting::Work::isLine(const Spread& spread, std::size_t coordinates) const
{
  const PowerOfTwo perUnit = powerOfTwo(-unit_);
  double largest = 0.0, along = 0.0;
  bool isFlat = false;
  for (std::size_t k = 0; k < coordinates; ++k)
  {
    const bool isCommon = around_.low[k] == around_.high[k];
    const double most = isCommon ? 0.0 : magnitude(k) * perUnit.first * perUnit.second;
    isFlat = isFlat || isCommon;
    largest = std::max(largest, most);
    along += std::fabs(spread.axes[spread.by[1]][k]) * most;
  }
  return spread.deviation(1) <= 2 * (isFlat ? along : largest) * precision_ + 0x1p-50;
}

Vector3 PlaneFitting::Work::chooseNormal(const Spread& spread) const
{
  const Vector3& line = spread.axes[spread.by[0]];
  if (spread.deviation(0) == 0.0)
  {
    return unitAxis(2);
  }
  if (isLine(spread, 3))
  {
    const bool isSteep = std::fabs(line[2]) >
      1.000001 * std::max(std::fabs(line[0]), std::fabs(line[1]));
    return perpendicular(unitAxis(isSteep ? 1 : 2), line);
  }
  return spread.axes[spread.by[2]];
}

/// Of a matrix without the height, whose axis therefore is z: it comes last, whatever its spread.
void PlaneFitting::Work::findFootprint(WideMatrix covariance)
{
  footprint_.height = std::sqrt(std::max(0.0, covariance[2][2].value()));
  for (std::size_t k = 0; k < 3; ++k)
  {
    covariance[k][2] = covariance[2][k] = DoubleDouble();
  }
  const Spread spread = spreadOf(covariance);
  footprint_.along = spread.axes[spread.by[0]];
  footprint_.across = spread.axes[spread.by[1]];
  footprint_.length = footprint_.height > 0.0 ? spread.deviation(0) : 0.0;
  footprint_.width = isLine(spread, 2) ? 0.0 : spread.deviation(1);
}

/// Where all points have a coordinate in common, the plane is exactly that of this coordinate: then
/// no place in it must be rounded.
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

// ------------------------------------------------------------------------------- of several parts

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

std::size_t planeFitMemoryEstimate(std::size_t points)
{
  return (2 + points / kLeastLoopTask) * sizeof(CellLevels) + 4096;
}

} // namespace ahd
