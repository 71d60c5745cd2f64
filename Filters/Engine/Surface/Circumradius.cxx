// SPDX-License-Identifier: BSD-3-Clause
#include "Circumradius.h"

#include "../Arithmetic/Length.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{
namespace
{

/// VTK's largest double, and so the largest alpha.
constexpr double kLargestRadius = 1e299;

Vector3 times(const Vector3& v, double factor)
{
  return { { v[0] * factor, v[1] * factor, v[2] * factor } };
}

/// Of the parallelogram.
double areaOf(const Vector3& u, const Vector3& v)
{
  return lengthOf(cross(u, v));
}

} // namespace

double lengthOf(const Vector3& v)
{
  // The function of three numbers takes many times as long.
  const double square = dot(v, v);
  return isOrdinarySquare(square) ? std::sqrt(square) : lengthOf(v[0], v[1], v[2]);
}

double circumradius(const Vector3& a, const Vector3& b, const Vector3& c)
{
  Vector3 sides[3] = { minus(b, a), minus(c, b), minus(a, c) };
  double lengths[3] = { lengthOf(sides[0]), lengthOf(sides[1]), lengthOf(sides[2]) };
  const double longest = std::max(lengths[0], std::max(lengths[1], lengths[2]));
  const double scale = scaleOf(longest);
  for (int i = 0; i < 3; ++i)
  {
    sides[i] = times(sides[i], scale);
    lengths[i] *= scale;
  }
  // The angle at the longest side's opposite corner is the one whose sine loses fewest digits.
  const int k = lengths[0] >= longest * scale ? 0 : lengths[1] >= longest * scale ? 1 : 2;
  const double area = areaOf(sides[(k + 1) % 3], sides[(k + 2) % 3]);
  const double radius = area == 0.0 ? kLargestRadius
                                    : lengths[0] * lengths[1] * lengths[2] / (2.0 * area) / scale;
  return radius > kLargestRadius ? kLargestRadius : radius;
}

RadiusLimit::RadiusLimit(double limit)
  : limit_(limit)
  , square_(4.0 * limit * limit)
  , isModerate_(limit > 1e-40 && limit < 1e40)
{
}

LengthLimit::LengthLimit(double limit)
  : limit_(limit)
  , largest_(limit * limit)
  , isModerate_(limit > 1e-140 && limit < 1e140)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  while (isModerate_ && std::sqrt(largest_) > limit)
  {
    largest_ = std::nextafter(largest_, 0.0);
  }
  while (isModerate_ && std::sqrt(std::nextafter(largest_, kInfinity)) <= limit)
  {
    largest_ = std::nextafter(largest_, kInfinity);
  }
}

} // namespace ahd
