// SPDX-License-Identifier: BSD-3-Clause
#include "Measure.h"

#include "../Predicates/Predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ahd
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 32.0 * 0x1p-53;
constexpr double kThin = 0x1p-800; ///< below, products underflow

double orInfinity(double error)
{
  return error <= kInfinity ? error : kInfinity;
}

/// (p - a) * scale, exactly.
DoubleDouble wideEdge(double p, double a, double scale)
{
  return scaled(exactDifference(p, a), scale);
}

} // namespace

Interpolant::Interpolant(const std::array<Sample, 3>& corners)
{
  const Sample *a = &corners[0], *b = &corners[1], *c = &corners[2];
  const auto order = [](const Sample*& p, const Sample*& q)
  {
    if (lexicographicallyLess(q->at, p->at))
    {
      std::swap(p, q);
    }
  };
  order(a, b);
  order(b, c);
  order(a, b);
  a_ = *a;
  b_ = *b;
  c_ = *c;
  bx_ = b_.at.x - a_.at.x;
  by_ = b_.at.y - a_.at.y;
  cx_ = c_.at.x - a_.at.x;
  cy_ = c_.at.y - a_.at.y;
  scale_ = powerOfTwoBelow(
    std::max({ std::fabs(bx_), std::fabs(by_), std::fabs(cx_), std::fabs(cy_) }));
  bx_ *= scale_;
  by_ *= scale_;
  cx_ *= scale_;
  cy_ *= scale_;
  divisor_ = bx_ * cy_ - by_ * cx_;
  toB_ = b_.value - a_.value;
  toC_ = c_.value - a_.value;
}

double Interpolant::error(const Sample& p) const
{
  const double px = (p.at.x - a_.at.x) * scale_, py = (p.at.y - a_.at.y) * scale_;
  const double ofB = px * cy_ - py * cx_, ofC = bx_ * py - by_ * px;
  return orInfinity(std::fabs(a_.value + (ofB * toB_ + ofC * toC_) / divisor_ - p.value));
}

double Interpolant::measure(const Sample& p, double weight, double bound) const
{
  const double error = this->error(p);
  return isSurelyWithin(p, error, weight, bound) ? weight * error : wideError(p, weight, bound);
}

bool Interpolant::isSurelyWithin(const Sample& p, double error, double weight, double bound) const
{
  const auto size = [](double x, double y) { return std::fabs(x) + std::fabs(y); };
  const double px = (p.at.x - a_.at.x) * scale_, py = (p.at.y - a_.at.y) * scale_;
  const double most = size(px * cy_, py * cx_) * std::fabs(toB_) +
    size(bx_ * py, by_ * px) * std::fabs(toC_);
  const double ofDivisor = size(bx_ * cy_, by_ * cx_) / std::fabs(divisor_);
  const double wrong = kRounding * (most / std::fabs(divisor_) * (1.0 + ofDivisor)) +
    kRounding * (size(a_.value, p.value) + size(b_.value, c_.value));
  return kRounding * ofDivisor < 0.25 && std::fabs(divisor_) > kThin &&
    (error + wrong) * weight * (1.0 + kRounding) <= bound;
}

double Interpolant::wideError(const Sample& p, double weight, double bound) const
{
  const auto edge = [&](const Point& q, const Point& from) -> DoubleDoubleVector {
    return { wideEdge(q.x, from.x, scale_), wideEdge(q.y, from.y, scale_) };
  };
  // of a corner, the area opposite to it: where that is 0 its value may be of any size
  const auto part = [&](const Sample& corner, const Sample& q, const Sample& r)
  {
    return orient2d(q.at, r.at, p.at) == 0
      ? DoubleDouble()
      : cross(edge(q.at, p.at), edge(r.at, p.at)) * exactDifference(corner.value, p.value);
  };
  const DoubleDouble up = part(a_, b_, c_) + part(b_, c_, a_) + part(c_, a_, b_);
  const DoubleDouble difference = up / cross(edge(b_.at, a_.at), edge(c_.at, a_.at));
  const DoubleDouble size = difference.high < 0.0 ? -difference : difference;
  const DoubleDouble error = size * DoubleDouble{ weight, 0.0 };
  const double rounded = std::fabs(divisor_) > kThin ? orInfinity(error.value()) : kInfinity;
  const bool isAbove = !(signOf(error - DoubleDouble{ bound, 0.0 }) <= 0) || rounded == kInfinity;
  return isAbove ? std::max(rounded, std::nextafter(bound, kInfinity)) : std::min(rounded, bound);
}

} // namespace ahd
