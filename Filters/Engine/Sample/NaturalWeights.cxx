// SPDX-License-Identifier: BSD-3-Clause
#include "NaturalWeights.h"

#include "../Core/Chunks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{

namespace
{

double valueOf(double a)
{
  return a;
}
double valueOf(const DoubleDouble& a)
{
  return a.value();
}

void subtract(double a, double b, double& difference)
{
  difference = a - b;
}
void subtract(double a, double b, DoubleDouble& difference)
{
  difference = exactDifference(a, b);
}

/// The unit of rounding.
template <typename Number>
constexpr double kUnit = 0x1p-53;
template <>
constexpr double kUnit<DoubleDouble> = 0x1p-100;

/// Most that weights may be wrong by.
constexpr double kMostError = 0x1p-40;

/// Divisors that are less may have lost bits: see areGood().
constexpr double kLeastDivisor = 0x1p-500;

template <typename Vector>
auto crossOf(const Vector& a, const Vector& b)
{
  return a.x * b.y - a.y * b.x;
}

template <typename Vector>
auto squareOf(const Vector& a)
{
  return a.x * a.x + a.y * a.y;
}

} // namespace

template <typename Number>
bool NaturalWeights<Number>::compute(const SampledSurface& surface, const Cavity& cavity,
  const Point& place, double scale, bool isLaplace, Ticker& ticker, std::vector<double>& weights)
{
  surface_ = &surface;
  place_ = place;
  scale_ = scale;
  isLaplace_ = isLaplace;
  flatness_ = size_ = 0.0;
  nearest_ = std::numeric_limits<double>::infinity();
  weights.resize(cavity.vertices().size());
  return goAround(cavity, ticker) && finish(weights, ticker);
}

template <typename Number>
typename NaturalWeights<Number>::Vector NaturalWeights<Number>::seen(Index vertex) const
{
  const Point v = surface_->at(vertex);
  Vector result;
  subtract(v.x * scale_, place_.x * scale_, result.x);
  subtract(v.y * scale_, place_.y * scale_, result.y);
  return result;
}

/// A centre, and what is to be known of it to bound the errors.
template <typename Number>
typename NaturalWeights<Number>::Vector NaturalWeights<Number>::noted(
  const Vector& numerators, const Number& divisor, double size, double sides)
{
  const Number inverse = Number{ 1.0 } / divisor;
  const Vector centre{ numerators.x * inverse, numerators.y * inverse };
  // Where something is NaN, or the divisor negative, which is a matter of rounding, too.
  const double area = valueOf(divisor), flatness = sides / (area * area);
  const bool isFlat = !((area > kLeastDivisor) & (flatness > 0.0));
  flatness_ = isFlat ? std::numeric_limits<double>::infinity() : std::max(flatness_, flatness);
  const double x = valueOf(centre.x), y = valueOf(centre.y);
  size_ = std::max(size_, std::max(size, x * x + y * y));
  return centre;
}

/// Of a triangle of the cavity.
template <typename Number>
typename NaturalWeights<Number>::Vector NaturalWeights<Number>::centreOf(std::size_t triangle)
{
  const Index* const v = surface_->tables->corners.data() + 3 * triangle;
  const Vector a = seen(v[0]), b = seen(v[1]), c = seen(v[2]);
  const Number A = squareOf(a), B = squareOf(b), C = squareOf(c);
  const Number area = crossOf(a, b) + crossOf(b, c) + crossOf(c, a);
  const double size = std::max({ valueOf(A), valueOf(B), valueOf(C) });
  return noted({ A * (b.y - c.y) + B * (c.y - a.y) + C * (a.y - b.y),
                 A * (c.x - b.x) + B * (a.x - c.x) + C * (b.x - a.x) },
    area + area, size, size * size);
}

/// Of a triangle that has the place as a corner.
template <typename Number>
typename NaturalWeights<Number>::Vector NaturalWeights<Number>::centreOf(
  const Vector& a, const Vector& b)
{
  const Number A = squareOf(a), B = squareOf(b), area = crossOf(a, b);
  nearest_ = std::min(nearest_, valueOf(A));
  return noted({ A * b.y - B * a.y, B * a.x - A * b.x }, area + area,
    std::max(valueOf(A), valueOf(B)), valueOf(A) * valueOf(B));
}

/// Adds what each side of the parts gives to twice their areas: a side between the centres P and Q
/// is P x Q for the part to its left, and as much less for the one to its right.
template <typename Number>
inline void NaturalWeights<Number>::go(const Cavity::Step& step)
{
  const Tables& tables = *surface_->tables;
  if (step.kind == Cavity::Step::Border)
  {
    const Vector a = seen(tables.origin(step.halfEdge)), b = seen(tables.target(step.halfEdge));
    rim_.push_back(centreOf(a, b));
    lengths_.push_back(valueOf(squareOf(a)));
    const Number side = crossOf(centres_.back(), rim_.back());
    areas_.back() = areas_.back() - side;
    areas_.push_back(side);
  }
  else if (isLaplace_)
  {
    return;
  }
  else if (step.kind == Cavity::Step::Enter)
  {
    const Vector centre = centreOf(tables.twins[step.halfEdge] / 3);
    crossed_.push_back(crossOf(centres_.back(), centre));
    areas_.back() = areas_.back() - crossed_.back();
    centres_.push_back(centre);
  }
  else
  {
    centres_.pop_back();
    areas_.back() = areas_.back() + crossed_.back();
    crossed_.pop_back();
  }
}

/// Returns false if the work is cancelled.
template <typename Number>
bool NaturalWeights<Number>::goAround(const Cavity& cavity, Ticker& ticker)
{
  areas_.assign(1, Number{ 0.0 });
  rim_.clear();
  crossed_.clear();
  lengths_.clear();
  centres_.assign(1, isLaplace_ ? Vector() : centreOf(cavity.triangle()));
  const std::vector<Cavity::Step>& steps = cavity.steps();
  return inChunks(0, steps.size(), ticker,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t k = first; k != last; ++k)
      {
        go(steps[k]);
      }
    });
}

/// The length of the side of the place's cell towards a vertex, over its distance.
template <typename Number>
double NaturalWeights<Number>::length(std::size_t k) const
{
  const Vector &before = rim_[k == 0 ? rim_.size() - 1 : k - 1], &after = rim_[k];
  const double x = valueOf(after.x - before.x), y = valueOf(after.y - before.y);
  return std::sqrt((x * x + y * y) / lengths_[k]);
}

/// Returns false if the work is cancelled.
template <typename Number>
bool NaturalWeights<Number>::finish(std::vector<double>& weights, Ticker& ticker)
{
  double sum = 0.0;
  const auto measure = [&](std::size_t first, std::size_t last)
  {
    for (std::size_t k = first; k != last; ++k)
    {
      const Vector& before = rim_[k == 0 ? rim_.size() - 1 : k - 1];
      const Number own = k == 0 ? areas_[0] + areas_.back() : areas_[k];
      const double part = isLaplace_ ? length(k) : valueOf(own + crossOf(before, rim_[k]));
      weights[k] = part > 0.0 ? part : 0.0;
      sum += weights[k];
    }
  };
  const auto divide = [&](std::size_t first, std::size_t last)
  {
    for (std::size_t k = first; k != last; ++k)
    {
      weights[k] /= sum;
    }
  };
  const bool done = inChunks(0, weights.size(), ticker, measure) &&
    inChunks(0, weights.size(), ticker, divide);
  sum_ = sum;
  return done;
}

/// Let z be the largest squared length, r a centre's, s the larger one, u the unit of rounding.
/// Differences are wrong by u of themselves, so are squared lengths by 4 u.
///
/// Of p with an edge from a to b: let f be |a| |b| over the divisor, at least 1/2. The numerators
/// are wrong by 7 u |a| |b| (|a| + |b|), the divisor, twice a product, by 8 u |a| |b|, the division
/// by 2 u; so the centre is by f u (14 sqrt(z) + 8 sqrt(r) + 4 sqrt(r)), 26 f u sqrt(s). Laplace's
/// sides, between two of them, are wrong by 52 f u sqrt(s).
///
/// Of a triangle of the cavity: let f be z over the divisor, at least 1/6. Its sides sum to less
/// than 5.2 sqrt(z), and each makes a numerator wrong by 8 u z for each unit of its length, each
/// corner by 2 u z sqrt(z): 48 u z sqrt(z). The divisor, twice the sum of three products, is by
/// 34 u z, the division by 2 u; so the centre is by 94 f u sqrt(s).
///
/// With the largest f, a product of two centres is wrong by 188 f u s and 2 u s, less than
/// 200 f u s. A weight has a few such sides; all are divided by the sum.
///
/// Products that are less than 2^-900 lose up to 2^-1074. As divisors are more than 2^-500, |a| |b|
/// is more than half of that: numerators are wrong by more than u 2^-750 anyway. Of Laplace's
/// weights the squared distance of the nearest vertex a loses most. Its side reaches to about half
/// of |b|, so where the sum is finite |b| is less than some 2^512 |a|, and |a|^2 more than 2^-1014,
/// which is wrong by 2^-60 of itself.
template <typename Number>
bool NaturalWeights<Number>::areGood() const
{
  const bool isInRange = size_ > 0x1p-400 && size_ < 0x1p400;
  const double error = kUnit<Number> * std::sqrt(flatness_) *
    (isLaplace_ ? 52.0 * std::sqrt(size_ / nearest_) : 200.0 * size_);
  return isInRange && error < kMostError * sum_ && std::isfinite(sum_);
}

template class NaturalWeights<double>;
template class NaturalWeights<DoubleDouble>;

/// The power of two that makes the farthest vertex of the cavity about 1 away. Returns false if the
/// work is cancelled.
bool NaturalMethod::findScale(const Point& place, Ticker& ticker, double& scale) const
{
  double far = 0.0;
  const std::vector<Index>& vertices = cavity_.vertices();
  const auto measure = [&](std::size_t first, std::size_t last)
  {
    for (std::size_t k = first; k != last; ++k)
    {
      const Point v = surface_.at(vertices[k]);
      far = std::max(
        { far, std::fabs(0.25 * v.x - 0.25 * place.x), std::fabs(0.25 * v.y - 0.25 * place.y) });
    }
  };
  const bool done = inChunks(0, vertices.size(), ticker, measure);
  int exponent = 0;
  std::frexp(std::max(far, 0x1p-1000), &exponent);
  scale = std::ldexp(1.0, -std::max(exponent + 2, -1000));
  return done;
}

bool NaturalMethod::weightsInside(
  const Spot& spot, const Point& place, Ticker& ticker, Weights& found)
{
  if (!cavity_.find(surface_, spot.halfEdge / 3, place, ticker) ||
    !quick_.compute(surface_, cavity_, place, 1.0, isLaplace_, ticker, weights_))
  {
    return false;
  }
  if (!quick_.areGood() && !weightsWithCare(place, ticker))
  {
    return false;
  }
  found = { cavity_.vertices().data(), weights_.data(), weights_.size(), spot.halfEdge };
  return true;
}

/// By doubles of 106 bits, or of as many bits as it takes. Returns false if the work is to be
/// cancelled.
bool NaturalMethod::weightsWithCare(const Point& place, Ticker& ticker)
{
  double scale = 1.0;
  return findScale(place, ticker, scale) &&
    careful_.compute(surface_, cavity_, place, scale, isLaplace_, ticker, weights_) &&
    (careful_.areGood() || wide_.compute(surface_, cavity_, place, isLaplace_, ticker, weights_));
}

bool NaturalMethod::weightsAt(const Point& place, Ticker& ticker, Weights& found)
{
  Spot spot;
  if (!finder_.find(place, ticker, spot))
  {
    return false;
  }
  if (spot.kind == Spot::InTriangle ||
    (spot.kind == Spot::OnEdge && Cavity::isCrossable(surface_, spot.halfEdge)))
  {
    return weightsInside(spot, place, ticker, found);
  }
  return rim_.at(spot, place, *rimTree_, ticker, found);
}

} // namespace ahd
