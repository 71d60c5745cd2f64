// SPDX-License-Identifier: BSD-3-Clause
#include "HeightSurface.h"

#include "../Core/Progress.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ahd
{
namespace
{

/// The weights of the corners of a triangle at a place in it: barycentric coordinates.
std::array<double, 3> weightsAt(const std::array<Point, 3>& corners, const Point& place)
{
  std::array<double, 3> x, y, weights;
  double largest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    x[k] = corners[k].x / 2 - place.x / 2; // halves: the difference may be too large
    y[k] = corners[k].y / 2 - place.y / 2;
    largest = std::max({ largest, std::abs(x[k]), std::abs(y[k]) });
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (std::size_t k = 0; k < 3; ++k)
  {
    x[k] = std::ldexp(x[k], -exponent);
    y[k] = std::ldexp(y[k], -exponent);
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    weights[k] = std::max(0.0, x[a] * y[b] - x[b] * y[a]);
    sum += weights[k];
  }
  for (double& weight : weights)
  {
    weight = sum > 0.0 ? weight / sum : 1.0 / 3; // 0: too flat a triangle for doubles
  }
  return weights;
}

/// The fraction of the way from `a` to `b`, along the axis on which they are farther apart.
double fractionAt(const Point& a, const Point& b, const Point& place)
{
  const double x = b.x / 2 - a.x / 2, y = b.y / 2 - a.y / 2;
  const double fraction = std::abs(x) > std::abs(y) ? (place.x / 2 - a.x / 2) / x
                                                    : (place.y / 2 - a.y / 2) / y;
  return fraction > 0.0 ? std::min(fraction, 1.0) : 0.0; // NaN: denormal numbers
}

} // namespace

double HeightSurface::heightAt(Index id, const PointView& points) const
{
  const auto mean = std::lower_bound(
    means.begin(), means.end(), id, [](const Mean& m, Index i) { return m.id < i; });
  return mean != means.end() && mean->id == id ? mean->position[2] : points.z(id);
}

SurfacePlace SurfacePlacer::operator()(const Point& place)
{
  const Location at = surface_.locate(place, hint_, ticker_);
  const HalfEdge h = at.halfEdge;
  hint_ = h == kNoHalfEdge ? hint_ : h / 3;
  switch (at.kind)
  {
    case Location::OnVertex:
      return { { { pointAt(h), 0, 0 } }, { { 1.0, 0.0, 0.0 } } };
    case Location::OnEdge:
      return onEdge(h, place);
    case Location::InTriangle:
      return inTriangle(h, place);
    default:
      return {};
  }
}

SurfacePlace SurfacePlacer::onEdge(HalfEdge h, const Point& place) const
{
  const HalfEdge next = nextInTriangle(h);
  const double t = fractionAt(originOf(h), originOf(next), place);
  return { { { pointAt(h), pointAt(next), 0 } }, { { 1.0 - t, t, 0.0 } } };
}

SurfacePlace SurfacePlacer::inTriangle(HalfEdge h, const Point& place) const
{
  const HalfEdge second = nextInTriangle(h), third = nextInTriangle(second);
  return { { { pointAt(h), pointAt(second), pointAt(third) } },
    weightsAt({ { originOf(h), originOf(second), originOf(third) } }, place) };
}

} // namespace ahd
