// SPDX-License-Identifier: BSD-3-Clause
#include "Plane.h"

#include "../Core/Border.h"
#include "PlaneFit.h"

#include <algorithm>
#include <cmath>

namespace ahd
{

Status Plane::fit(const PointView& points, const Context& context)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Merge, 0, context.executor);
      PlaneFit fit;
      if (!fitPlane(points, ticker, fit))
      {
        return false;
      }
      take(fit);
      return true;
    });
}

void Plane::take(const PlaneFit& fit)
{
  origin_ = fit.origin;
  height_ = fit.height;
  shrink_ = fit.shrink;
  isOfCoordinates_ = fit.isOfCoordinates;
  stance_ = fit.stance;
  orient(fit.normal);
}

void Plane::orient(Vector3 normal)
{
  const double length = std::sqrt(dot(normal, normal));
  double most = 0.0;
  for (double& component : normal)
  {
    component /= length;
    most = std::max(most, std::fabs(component));
  }
  std::size_t main = 2;
  while (main > 0 && std::fabs(normal[main]) < most * (1 - 1e-6))
  {
    --main;
  }
  if (normal[main] < 0)
  {
    height_ = -height_;
    for (double& component : normal)
    {
      component = 0.0 - component; // no -0.0
    }
  }
  axes_[2] = normal;
  axes_[0] = perpendicular(unitAxis(main + 1), normal);
  axes_[1] = cross(normal, axes_[0]);
}

} // namespace ahd
