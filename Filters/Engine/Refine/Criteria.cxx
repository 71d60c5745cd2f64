// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria.h"

#include "../Arithmetic/PowerOfTwo.h"
#include "../Predicates/Circles.h"
#include "Functions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{
namespace
{

constexpr double kAny = std::numeric_limits<double>::infinity();
constexpr double kResolution = 1024.0; ///< in units in the last place
/// Of a squared length, or the product of two of them: below it, products may underflow.
constexpr double kSmallest = 0x1p-500;
/// Without a wish for angles, vertices still stay out of lenses as flat as for this one.
constexpr double kLeastLens = 10.0;
/// Off-centres are a little nearer than would make the least angle, so that rounding leaves no bad
/// triangle (Ungor 2004: 0.5).
constexpr double kOffCentre = 0.475;

double square(double a)
{
  return a * a;
}

/// Two edges from a corner, for the angle between them.
struct Edges
{
  ScaledVector a, b;
  double lengths; ///< product of the squared ones

  Edges(const ScaledVector& toA, const ScaledVector& toB)
    : a(toA)
    , b(toB)
    , lengths(dot(toA, toA) * dot(toB, toB))
  {
  }
};

/// In a unit of its own.
ScaledVector unitVector(const Point& from, const Point& to)
{
  const double x = to.x - from.x, y = to.y - from.y;
  const double scale = powerOfTwoBelow(std::max(std::fabs(x), std::fabs(y)));
  return { x * scale, y * scale };
}

/// Where products of four lengths underflow in units of the mesh, each edge in its own; which does
/// not change the angle. Elsewhere powers of two change no bit.
Edges edgesFrom(const Criteria& criteria, const Point& c, const Point& a, const Point& b)
{
  const Edges edges(criteria.vector(c, a), criteria.vector(c, b));
  return edges.lengths < kSmallest ? Edges(unitVector(c, a), unitVector(c, b)) : edges;
}

} // namespace

Criteria::Criteria(const RefineRequest& request, double width)
  : scale_(powerOfTwoBelow(width))
  , sineSquared_(square(sineOfDegrees(request.minimumAngle)))
{
  const double angle = std::max(request.minimumAngle, kLeastLens);
  lens_ = square(sineOfDegrees(90.0 - 2.0 * angle));
  const double cosine = sineOfDegrees(90.0 - angle);
  offCentre_ = kOffCentre * std::sqrt((1.0 + cosine) / (1.0 - cosine));
  area_ = request.maximumArea > 0.0 ? 2.0 * request.maximumArea * scale_ * scale_ : kAny;
  length_ = request.maximumLength > 0.0 ? request.maximumLength : kAny;
}

bool Criteria::areClose(const Point& a, const Point& b) const
{
  const double most = std::max({ std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y) });
  const double least = kResolution * lastPlaceOf(most) * scale_;
  return length(a, b) < std::max(least * least, kSmallest);
}

bool Criteria::isTooLong(const Point& a, const Point& b, double size) const
{
  const double longest = (size > 0.0 ? std::min(size, length_) : length_) * scale_;
  return length(a, b) > longest * longest;
}

bool Criteria::encroaches(const Point& a, const Point& b, const Point& p) const
{
  if (acuteness(a, p, b) >= 0)
  {
    return false;
  }
  const Edges edges = edgesFrom(*this, p, a, b);
  return square(dot(edges.a, edges.b)) >= lens_ * edges.lengths;
}

Measured Criteria::measure(const Point corners[3], const double* sizes) const
{
  const Point &a = corners[0], &b = corners[1], &c = corners[2];
  const double lengths[] = { length(b, c), length(a, c), length(a, b) };
  const auto least = std::min_element(lengths, lengths + 3);
  const int apex = static_cast<int>(least - lengths);
  const double area = std::fabs(cross(vector(a, b), vector(a, c)));
  // The least angle is opposite to the shortest edge: its sine is twice the area over the product
  // of the two others.
  const double others = lengths[(apex + 1) % 3] * lengths[(apex + 2) % 3];
  bool isThin = square(area) < sineSquared_ * others;
  bool isLarge = area > area_;
  for (int k = 0; k < 3; ++k)
  {
    const int p = (k + 1) % 3, q = (k + 2) % 3;
    if (others < kSmallest) // which edge is the shortest may be lost, too
    {
      const Edges edges = edgesFrom(*this, corners[k], corners[p], corners[q]);
      isThin = isThin || square(cross(edges.a, edges.b)) < sineSquared_ * edges.lengths;
    }
    const bool isAny = !sizes && length_ == kAny;
    const double size = sizes ? (sizes[p] + sizes[q]) / 2.0 : 0.0;
    isLarge = isLarge || (!isAny && isTooLong(corners[p], corners[q], size));
  }
  return { *least, apex, isThin, isLarge };
}

Point Criteria::centre(const Point corners[3], int apex) const
{
  const Point &o = corners[apex], &p = corners[(apex + 1) % 3], &q = corners[(apex + 2) % 3];
  const ScaledVector a = vector(p, q), b = vector(p, o);
  const double turn = cross(a, b), ofA = dot(a, a), ofB = dot(b, b);
  ScaledVector centre = { (b.y * ofA - a.y * ofB) / (2.0 * turn),
    (a.x * ofB - b.x * ofA) / (2.0 * turn) };
  const ScaledVector middle = { a.x / 2.0, a.y / 2.0 };
  const double side = turn > 0.0 ? offCentre_ : -offCentre_;
  const ScaledVector away = { -side * a.y, side * a.x };
  const ScaledVector fromMiddle = { centre.x - middle.x, centre.y - middle.y };
  if (!(dot(fromMiddle, fromMiddle) <= dot(away, away)))
  {
    centre = { middle.x + away.x, middle.y + away.y };
  }
  return { p.x + centre.x / scale_ + 0.0, p.y + centre.y / scale_ + 0.0 };
}

bool Criteria::isSharp(const Point& a, const Point& c, const Point& b) const
{
  const Edges edges = edgesFrom(*this, c, a, b);
  const double along = dot(edges.a, edges.b);
  return along > 0.0 && square(along) > 0.25 * edges.lengths;
}

} // namespace ahd
