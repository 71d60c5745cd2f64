// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PlaneMaker_h
#define ahd_PlaneMaker_h

// Shared by the tests of the best-fitting plane.
#include "Surface/Plane.h"

#include "Executors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace ahd
{
namespace test
{

using Xyz = Vector3;

inline PointView viewOf(const std::vector<Xyz>& points)
{
  return PointView(points.empty() ? nullptr : points[0].data(), points.size(), 3);
}

inline Plane fit(const std::vector<Xyz>& points, unsigned threads = 1)
{
  ThreadExecutor executor(threads);
  Context context;
  context.executor = &executor;
  Plane plane;
  EXPECT_EQ(plane.fit(viewOf(points), context), Status::Ok);
  return plane;
}

inline double length(const Xyz& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

/// The component that decides the sign.
inline std::size_t mainOf(const Xyz& normal)
{
  const double most = std::max(
    { std::fabs(normal[0]), std::fabs(normal[1]), std::fabs(normal[2]) });
  std::size_t k = 2;
  while (std::fabs(normal[k]) < most * (1 - 1e-6))
  {
    --k;
  }
  return k;
}

/// Unit vectors, right handed, directed by the rules.
inline void expectFrame(const Plane& plane)
{
  const Xyz& x = plane.firstAxis();
  const Xyz& y = plane.secondAxis();
  const Xyz& n = plane.normal();
  for (const Xyz& axis : { x, y, n })
  {
    EXPECT_NEAR(length(axis), 1.0, 1e-15);
  }
  EXPECT_NEAR(dot(x, y), 0.0, 1e-15);
  EXPECT_NEAR(dot(x, n), 0.0, 1e-15);
  EXPECT_NEAR(dot(cross(x, y), n), 1.0, 1e-15);
  const std::size_t k = mainOf(n);
  EXPECT_GT(n[k], 0.0);
  EXPECT_GT(x[(k + 1) % 3], 0.7) << "the first axis is not the one after the normal's";
}

inline void expectSame(const Plane& a, const Plane& b)
{
  EXPECT_EQ(a.normal(), b.normal());
  EXPECT_EQ(a.firstAxis(), b.firstAxis());
  EXPECT_EQ(a.secondAxis(), b.secondAxis());
  EXPECT_EQ(a.project({ { 0, 0, 0 } }), b.project({ { 0, 0, 0 } }));
  EXPECT_EQ(a.stance().isWall, b.stance().isWall);
  EXPECT_EQ(a.stance().isSteep, b.stance().isSteep);
}

/// Random whole numbers and planes of them.
class Maker
{
public:
  explicit Maker(unsigned seed)
    : random_(seed) // its sequence is fixed by the standard
  {
  }

  int whole(int most) { return int(random_() % unsigned(2 * most + 1)) - most; }

  double fraction() { return double(random_() >> 11) * 0x1p-53; }

  Xyz vector(int most)
  {
    const double x = whole(most);
    const double y = whole(most);
    return { { x, y, double(whole(most)) } };
  }

  /// Points of a plane with this normal (not one long), which goes through `at`.
  std::vector<Xyz> plane(const Xyz& at, Xyz& normal)
  {
    Xyz u, v;
    do
    {
      u = vector(9);
      v = vector(9);
      normal = cross(u, v);
    } while (length(normal) == 0);
    std::vector<Xyz> points = { at, add(at, 1, u, 0, v), add(at, 0, u, 1, v) };
    for (int more = int(random_() % 40); more > 0; --more)
    {
      const int i = whole(50);
      points.push_back(add(at, i, u, whole(50), v));
    }
    return points;
  }

  void shuffle(std::vector<Xyz>& points)
  {
    for (std::size_t i = points.size(); i > 1; --i)
    {
      std::swap(points[i - 1], points[random_() % i]);
    }
  }

private:
  static Xyz add(const Xyz& at, double i, const Xyz& u, double j, const Xyz& v)
  {
    return { { at[0] + i * u[0] + j * v[0], at[1] + i * u[1] + j * v[1],
      at[2] + i * u[2] + j * v[2] } };
  }

  std::mt19937_64 random_;
};

inline double sineBetween(const Xyz& a, const Xyz& b)
{
  return length(cross(a, b)) / (length(a) * length(b));
}

} // namespace test
} // namespace ahd

#endif
