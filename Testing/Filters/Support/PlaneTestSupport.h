// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PlaneTestSupport_h
#define ahd_PlaneTestSupport_h

#include "Input/vtkAHDPlane.h"
#include "Pipeline/vtkAHDExecutor.h"
#include "Pipeline/vtkAHDProgress.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

/// What the tests of the best fitting plane share.
namespace planetest
{
using Xyz = vtkAHDVector;

inline vtkAHDPlane fit(const std::vector<Xyz>& points, unsigned threads = 1)
{
  vtkNew<vtkAlgorithm> filter;
  vtkAHDProgress progress(filter);
  vtkAHDExecutor executor(threads);
  vtkAHDPlane plane;
  const double* numbers = points.empty() ? nullptr : points[0].data();
  EXPECT_TRUE(plane.Fit(ahd::PointView(numbers, points.size(), 3), executor, progress));
  return plane;
}

inline double length(const Xyz& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

/// The component that the rule of the sign looks at.
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

/// Unit vectors, right handed, turned as the rules say.
inline void expectFrame(const vtkAHDPlane& plane)
{
  const Xyz& x = plane.GetFirstAxis();
  const Xyz& y = plane.GetSecondAxis();
  const Xyz& n = plane.GetNormal();
  for (const Xyz& axis : { x, y, n })
  {
    EXPECT_NEAR(length(axis), 1.0, 1e-15);
  }
  EXPECT_NEAR(vtkAHDDot(x, y), 0.0, 1e-15);
  EXPECT_NEAR(vtkAHDDot(x, n), 0.0, 1e-15);
  EXPECT_NEAR(vtkAHDDot(vtkAHDCross(x, y), n), 1.0, 1e-15);
  const std::size_t k = mainOf(n);
  EXPECT_GT(n[k], 0.0);
  EXPECT_GT(x[(k + 1) % 3], 0.7) << "the first axis is not the one after the normal's";
}

inline void expectSame(const vtkAHDPlane& a, const vtkAHDPlane& b)
{
  EXPECT_EQ(a.GetNormal(), b.GetNormal());
  EXPECT_EQ(a.GetFirstAxis(), b.GetFirstAxis());
  EXPECT_EQ(a.GetSecondAxis(), b.GetSecondAxis());
  EXPECT_EQ(a.Project({ { 0, 0, 0 } }), b.Project({ { 0, 0, 0 } }));
}

/// Random whole numbers and planes of them.
class Maker
{
public:
  explicit Maker(unsigned seed)
    : Random(seed) // its sequence is fixed by the standard
  {
  }

  int Whole(int most) { return int(this->Random() % unsigned(2 * most + 1)) - most; }

  double Fraction() { return double(this->Random() >> 11) * 0x1p-53; }

  Xyz Vector(int most)
  {
    const double x = this->Whole(most);
    const double y = this->Whole(most);
    return { { x, y, double(this->Whole(most)) } };
  }

  /// Points of a plane with this normal (not one long), which goes through `at`.
  std::vector<Xyz> Plane(const Xyz& at, Xyz& normal)
  {
    Xyz u, v;
    do
    {
      u = this->Vector(9);
      v = this->Vector(9);
      normal = vtkAHDCross(u, v);
    } while (length(normal) == 0);
    std::vector<Xyz> points = { at, Add(at, 1, u, 0, v), Add(at, 0, u, 1, v) };
    for (int more = int(this->Random() % 40); more > 0; --more)
    {
      const int i = this->Whole(50);
      points.push_back(Add(at, i, u, this->Whole(50), v));
    }
    return points;
  }

  void Shuffle(std::vector<Xyz>& points)
  {
    for (std::size_t i = points.size(); i > 1; --i)
    {
      std::swap(points[i - 1], points[this->Random() % i]);
    }
  }

private:
  static Xyz Add(const Xyz& at, double i, const Xyz& u, double j, const Xyz& v)
  {
    return { { at[0] + i * u[0] + j * v[0], at[1] + i * u[1] + j * v[1],
      at[2] + i * u[2] + j * v[2] } };
  }

  std::mt19937_64 Random;
};

inline double sineBetween(const Xyz& a, const Xyz& b)
{
  return length(vtkAHDCross(a, b)) / (length(a) * length(b));
}

} // namespace planetest

#endif
