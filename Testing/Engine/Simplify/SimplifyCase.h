// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SimplifyCase_h
#define ahd_SimplifyCase_h

// Surfaces to simplify, for the tests of Simplify/.
#include "ConstraintSets.h"
#include "Distributions.h"
#include "Engine.h"
#include "EngineRun.h"

#include "Simplify/Simplify.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace ahd
{
namespace test
{

/// Points with heights, and constraints.
struct SimplifyCase
{
  std::vector<double> numbers; ///< x, y, z of each point
  ConstraintSet constraints;
  SimplifyRequest settings; ///< but for the views

  std::size_t count() const { return numbers.size() / 3; }
  PointView view() const { return PointView(numbers.data(), count(), 3); }
  Point at(std::size_t i) const { return { numbers[3 * i], numbers[3 * i + 1] }; }
  double height(std::size_t i) const { return numbers[3 * i + 2]; }
  void add(const Point& p, double z) { numbers.insert(numbers.end(), { p.x, p.y, z }); }

  SimplifyRequest request() const
  {
    SimplifyRequest result = settings;
    result.points = view();
    result.constraints = constraints.view();
    return result;
  }

  SimplifyResult simplified(const Context& context = Context()) const
  {
    SimplifyResult result;
    EXPECT_EQ(simplify(request(), context, result), Status::Ok);
    return result;
  }
};

/// Smooth hills, made by what IEEE 754 rounds correctly.
inline double hillsAt(const Point& p)
{
  const auto bump = [&](double x, double y, double width, double height)
  {
    const double dx = (p.x - x) / width, dy = (p.y - y) / width;
    return height / (1.0 + dx * dx + dy * dy);
  };
  return bump(0.3, 0.4, 0.1, 10.0) + bump(0.7, 0.6, 0.2, -6.0) + bump(0.5, 0.1, 0.05, 3.0) +
    bump(0.9, 0.9, 0.3, 7.0);
}

inline SimplifyCase hills(std::size_t n, std::uint64_t seed, double noise = 0.0)
{
  SimplifyCase given;
  Random random(seed);
  for (const Point& p : makePoints(Distribution::Uniform, n, seed))
  {
    given.add(p, hillsAt(p) + noise * (random.unit() - 0.5));
  }
  return given;
}

inline std::vector<std::size_t> keptIds(const SimplifyResult& result)
{
  std::vector<std::size_t> ids;
  for (std::size_t i = 0; i < result.lots.size(); ++i)
  {
    if (result.lots[i] == PointLot::Kept)
    {
      ids.push_back(i);
    }
  }
  return ids;
}

} // namespace test
} // namespace ahd

#endif
