// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SelectionCase_h
#define ahd_SelectionCase_h

// Shared by the tests of selectBySize(): surfaces of all kinds.
#include "Merge/Merge.h"
#include "Surface/Selection.h"
#include "Surface/Vectors.h"
#include "Triangulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace ahd
{
namespace test
{

using Xyz = Vector3;

/// Points, in the plane and in space, and their triangulation.
struct Surface
{
  std::vector<Xyz> points;
  std::vector<Xyz> inSpace;
  MergedPoints merged;
  Options options;
  std::vector<std::int64_t> loop; ///< triangles outside of it are dropped

  PointView view() const
  {
    PointView result(points[0].data(), points.size(), 3);
    return merged.skip.empty() ? result : merged.without(result);
  }

  PointsToMeasure measured() const
  {
    PointsToMeasure result;
    result.inSpace = PointView(inSpace[0].data(), inSpace.size(), 3);
    result.merged = &merged.pairs;
    return result;
  }

  void triangulateInto(Triangulation& out) const
  {
    Workspace workspace;
    ASSERT_EQ(triangulate(view(), options, workspace, Context(), out), Status::Ok);
    if (!loop.empty())
    {
      const std::vector<std::int64_t> offsets = { 0, std::int64_t(loop.size()) };
      ConstraintView constraints;
      constraints.ids = loop.data();
      constraints.offsets = offsets.data();
      constraints.chains = 1;
      ASSERT_EQ(
        constrain(std::move(out), constraints, FillRule::EvenOdd, Context(), out), Status::Ok);
    }
  }
};

/// A surface over the unit square, in space somewhere else. Odd seeds have points at one place, and
/// z that are NaN; others have points merged, representatives that are not the first, a loop.
inline Surface makeSurface(std::size_t count, unsigned seed)
{
  std::mt19937_64 random(seed); // its sequence is fixed by the standard
  const auto fraction = [&random] { return double(random() >> 11) * 0x1p-53; };
  Surface surface;
  for (std::size_t i = 0; i < count; ++i)
  {
    double x = fraction(), y = fraction();
    if (seed % 2 == 1)
    {
      x = std::floor(x * 16) / 16;
      y = std::floor(y * 16) / 16;
    }
    const double z = seed % 2 == 1 && i % 20 == 7 ? std::numeric_limits<double>::quiet_NaN()
                                                  : 0.1 * fraction();
    surface.points.push_back({ { x, y, z } });
    surface.inSpace.push_back({ { 1.5 * y, z + 0.01 * double(i % 3), x } });
  }
  surface.options.representative = static_cast<Representative>(seed % 3);
  if (seed % 4 == 0)
  {
    EXPECT_EQ(mergeWithin(surface.view(), 0.05, nullptr, surface.merged), Status::Ok);
  }
  if (seed % 5 == 0)
  {
    const std::size_t first = surface.points.size();
    for (const double angle : { 0.1, 1.7, 3.3, 4.9 })
    {
      const double x = 0.5 + 0.4 * std::cos(angle), y = 0.5 + 0.4 * std::sin(angle);
      surface.loop.push_back(std::int64_t(surface.points.size()));
      surface.points.push_back({ { x, y, 0 } });
      surface.inSpace.push_back({ { 1.5 * y, 0, x } });
    }
    if (!surface.merged.skip.empty())
    {
      surface.merged.skip.resize(first + 4, 0);
    }
  }
  if (seed % 7 == 0)
  {
    surface.options.insertionLimit = count / 2;
  }
  return surface;
}

} // namespace test
} // namespace ahd

#endif
