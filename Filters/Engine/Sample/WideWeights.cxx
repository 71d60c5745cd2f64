// SPDX-License-Identifier: BSD-3-Clause
#include "WideWeights.h"

#include "../Core/Chunks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{

namespace
{

/// 192 bits, where 100 were not enough.
constexpr int kFewestDigits = 4;

/// What a step around the cavity counts: a centre, whose products take the square of the digits.
std::size_t stepsOf(int digits)
{
  return std::min(kStepsPerAsking / 2, std::size_t(2 * digits) * std::size_t(digits));
}

/// Rounded up.
int halfOf(int bits)
{
  return bits > 0 ? (bits + 1) / 2 : -(-bits / 2);
}

} // namespace

bool WideWeights::compute(const SampledSurface& surface, const Cavity& cavity, const Point& place,
  bool isLaplace, Ticker& ticker, std::vector<double>& weights)
{
  surface_ = &surface;
  place_ = place;
  isLaplace_ = isLaplace;
  weights.resize(cavity.vertices().size());
  exponents_.resize(weights.size());
  if (work_.empty())
  {
    work_.resize(1);
  }
  for (digits_ = kFewestDigits;;)
  {
    if (!goAround(cavity, ticker, weights) || !divide(weights, ticker))
    {
      return false;
    }
    const int missing = missingDigits(cavity.steps().size());
    if (missing <= 0 || digits_ == kMostDigits)
    {
      return true;
    }
    digits_ = std::min(kMostDigits, digits_ + missing);
  }
}

/// Returns false if the work is cancelled.
bool WideWeights::goAround(const Cavity& cavity, Ticker& ticker, std::vector<double>& weights)
{
  Work& w = work_[0];
  w.with.setDigits(digits_);
  isFlat_ = false;
  flatness_ = size_ = std::numeric_limits<int>::min() / 4;
  nearest_ = std::numeric_limits<int>::max() / 4;
  count_ = 0;
  way_.clear();
  triangle_ = cavity.triangle();
  WideArithmetic::setZero(w.area);
  WideArithmetic::setZero(w.side);
  if (!isLaplace_)
  {
    centreOf(triangle_, w.centre);
  }
  for (const Cavity::Step& step : cavity.steps())
  {
    go(cavity, step, weights);
    if (!ticker.step(stepsOf(digits_)))
    {
      return false;
    }
  }
  w.rim = w.first;
  w.with.sum(w.ofFirst, w.area, w.area);
  finish(0, cavity.vertices().front(), weights);
  return true;
}

/// As NaturalWeights goes: a side between the centres P and Q is P x Q for the part to its left,
/// and as much less for the one to its right.
void WideWeights::go(const Cavity& cavity, const Cavity::Step& step, std::vector<double>& weights)
{
  if (step.kind == Cavity::Step::Border)
  {
    passBorder(cavity, step.halfEdge, weights);
  }
  else if (!isLaplace_)
  {
    step.kind == Cavity::Step::Enter ? enter(surface_->tables->twins[step.halfEdge] / 3) : leave();
  }
}

void WideWeights::passBorder(const Cavity& cavity, HalfEdge h, std::vector<double>& weights)
{
  Work& w = work_[0];
  see(surface_->tables->origin(h), w.corner[0]);
  see(surface_->tables->target(h), w.corner[1]);
  WideArithmetic::setZero(w.corner[2].x);
  WideArithmetic::setZero(w.corner[2].y);
  centreOfCorners(true, w.rim);
  if (!isLaplace_)
  {
    cross(w.centre, w.rim, w.side);
    w.with.difference(w.area, w.side, w.area);
  }
  if (count_ == 0)
  {
    w.first = w.rim;
    w.ofFirst = w.area;
  }
  else
  {
    finish(count_, cavity.vertices()[count_], weights);
  }
  ++count_;
  w.before = w.rim;
  w.area = w.side;
}

void WideWeights::enter(std::size_t triangle)
{
  Work& w = work_[0];
  way_.push_back(static_cast<Index>(triangle_));
  triangle_ = triangle;
  centreOf(triangle_, w.other);
  cross(w.centre, w.other, w.side);
  w.with.difference(w.area, w.side, w.area);
  w.centre = w.other;
}

void WideWeights::leave()
{
  Work& w = work_[0];
  triangle_ = way_.back();
  way_.pop_back();
  centreOf(triangle_, w.other);
  cross(w.other, w.centre, w.side);
  w.with.sum(w.area, w.side, w.area);
  w.centre = w.other;
}

/// The weight of a vertex, between the centres `before` and `rim`, with an exponent of its own.
void WideWeights::finish(std::size_t k, Index vertex, std::vector<double>& weights)
{
  Work& w = work_[0];
  if (isLaplace_)
  {
    w.with.difference(w.rim.x, w.before.x, w.corner[0].x);
    w.with.difference(w.rim.y, w.before.y, w.corner[0].y);
    square(w.corner[0], w.area);
    see(vertex, w.corner[0]);
    square(w.corner[0], w.square);
    w.with.inverse(w.square, w.divisor);
    w.with.product(w.area, w.divisor, w.area);
  }
  else
  {
    cross(w.before, w.rim, w.divisor);
    w.with.sum(w.area, w.divisor, w.area);
  }
  const bool isPositive = w.area.sign() > 0;
  const double part = isPositive ? w.area.leading() : 0.0;
  const int exponent = isPositive ? 64 * w.area.leadingExponent() : 0;
  weights[k] = isLaplace_ ? std::sqrt(part) : part;
  exponents_[k] = isLaplace_ ? exponent / 2 : exponent;
}

/// By their sum. Returns false if the work is cancelled.
bool WideWeights::divide(std::vector<double>& weights, Ticker& ticker)
{
  int most = std::numeric_limits<int>::min();
  double sum = 0.0;
  const auto findMost = [&](std::size_t first, std::size_t last)
  {
    for (std::size_t k = first; k != last; ++k)
    {
      most = weights[k] > 0.0 ? std::max(most, exponents_[k]) : most;
    }
  };
  const auto addUp = [&](std::size_t first, std::size_t last)
  {
    for (std::size_t k = first; k != last; ++k)
    {
      weights[k] = weights[k] > 0.0 ? std::ldexp(weights[k], exponents_[k] - most) : 0.0;
      sum += weights[k];
    }
  };
  const auto divideAll = [&](std::size_t first, std::size_t last)
  {
    for (std::size_t k = first; k != last; ++k)
    {
      weights[k] /= sum;
    }
  };
  const std::size_t n = weights.size();
  if (!inChunks(0, n, ticker, findMost) || !inChunks(0, n, ticker, addUp) ||
    !inChunks(0, n, ticker, divideAll))
  {
    return false;
  }
  isFlat_ = isFlat_ || !(sum > 0.0);
  sum_ = isFlat_ ? 0 : std::ilogb(sum) + 1 + most;
  return true;
}

void WideWeights::see(Index vertex, Vector& seen)
{
  const Point v = surface_->at(vertex);
  work_[0].with.difference(v.x, place_.x, seen.x);
  work_[0].with.difference(v.y, place_.y, seen.y);
}

void WideWeights::cross(const Vector& a, const Vector& b, WideFloat& result)
{
  Work& w = work_[0];
  w.with.product(a.x, b.y, w.left);
  w.with.product(a.y, b.x, w.right);
  w.with.difference(w.left, w.right, result);
}

void WideWeights::square(const Vector& a, WideFloat& result)
{
  Work& w = work_[0];
  w.with.product(a.x, a.x, w.left);
  w.with.product(a.y, a.y, w.right);
  w.with.sum(w.left, w.right, result);
}

/// Of a triangle of the cavity.
void WideWeights::centreOf(std::size_t triangle, Vector& centre)
{
  const Index* const v = surface_->tables->corners.data() + 3 * triangle;
  for (std::size_t k = 0; k != 3; ++k)
  {
    see(v[k], work_[0].corner[k]);
  }
  centreOfCorners(false, centre);
}

/// The place may be the last corner, which is then 0.
void WideWeights::centreOfCorners(bool hasPlace, Vector& centre)
{
  Work& w = work_[0];
  WideArithmetic& with = w.with;
  WideFloat& divisor = w.divisor;
  WideArithmetic::setZero(centre.x);
  WideArithmetic::setZero(centre.y);
  WideArithmetic::setZero(divisor);
  for (std::size_t k = 0; k != 3; ++k)
  {
    const Vector &next = w.corner[(k + 1) % 3], &last = w.corner[(k + 2) % 3];
    square(w.corner[k], w.square);
    w.lengths[k] = hasPlace && k == 2 ? w.lengths[0] : w.square.bits();
    with.difference(next.y, last.y, w.left);
    with.product(w.square, w.left, w.left);
    with.sum(centre.x, w.left, centre.x);
    with.difference(last.x, next.x, w.left);
    with.product(w.square, w.left, w.left);
    with.sum(centre.y, w.left, centre.y);
    cross(w.corner[k], next, w.left);
    with.sum(divisor, w.left, divisor);
  }
  with.sum(divisor, divisor, divisor);
  if (divisor.sign() <= 0)
  {
    isFlat_ = true;
    return;
  }
  const int bits = divisor.bits();
  with.inverse(divisor, divisor);
  with.product(centre.x, divisor, centre.x);
  with.product(centre.y, divisor, centre.y);
  note(hasPlace, centre, bits);
}

/// What is to be known of a centre to bound the errors. `divisor`: its bits.
void WideWeights::note(bool hasPlace, const Vector& centre, int divisor)
{
  const int a = work_[0].lengths[0], b = work_[0].lengths[1];
  const int largest = std::max({ a, b, work_[0].lengths[2] });
  nearest_ = hasPlace ? std::min(nearest_, a) : nearest_;
  flatness_ = std::max(flatness_, (hasPlace ? a + b : 2 * largest) - 2 * (divisor - 1));
  size_ = std::max(size_, largest);
  for (const WideFloat* c : { &centre.x, &centre.y })
  {
    size_ = c->sign() == 0 ? size_ : std::max(size_, 2 * c->bits() + 1);
  }
}

/// How many digits more the bound of NaturalWeights::areGood() asks for; 0 or less if the weights
/// are good. It is taken twice, since an inverse is wrong by more units here, and as often as there
/// are steps, as a part may have that many sides; lengths by the power of two above or below them.
///
/// Proof that kMostDigits are enough. Coordinates are whole numbers of 2^-1074, less than 2^2098 of
/// them, so the distance a of a vertex is at least 1 and less than 2^2100, and a divisor, twice a
/// whole number, at least 2. Hence f is less than 2^4199, a centre nearer than 2 f a, s less than
/// 2^12600, f s less than 2^16799, while the cell has the disc of half the distance of the nearest
/// vertex in it: its area, twice, is more than 1. With 2^-40, the 400, 2^32 steps and 4 bits for
/// the lengths that is 2^16885, and 265 digits make it 2^-11. Laplace's weights ask for less: 104 f
/// over the least distance times the root of s is less than 2^10507, and their sum, of a polygon's
/// sides over no more than 2^2100, more than 2^-2099.
int WideWeights::missingDigits(std::size_t steps) const
{
  if (isFlat_)
  {
    return digits_;
  }
  constexpr int kBitsOfFactor = 9, kMostErrorBits = -40;
  const int size = isLaplace_ ? halfOf(size_ - nearest_ + 1) : size_;
  const int error = work_[0].with.unit() + halfOf(flatness_) + size + kBitsOfFactor +
    static_cast<int>(bitLength(steps));
  const int missing = error - (kMostErrorBits + sum_ - 1);
  return missing > 0 ? (missing + 63) / 64 : 0;
}

} // namespace ahd
