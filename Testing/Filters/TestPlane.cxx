// SPDX-License-Identifier: BSD-3-Clause
//
// The best fitting plane: what it is, that nothing but the points decides it, and where it lays
// them. Random planes are spanned by vectors of whole numbers, so the points lie in them exactly.
#include "vtkAHDExecutor.h"
#include "vtkAHDPlane.h"
#include "vtkAHDProgress.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
using Xyz = vtkAHDVector;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

vtkAHDPlane fit(const std::vector<Xyz>& points, unsigned threads = 1)
{
  vtkNew<vtkAlgorithm> filter;
  vtkAHDProgress progress(filter);
  vtkAHDExecutor executor(threads);
  vtkAHDPlane plane;
  const double* numbers = points.empty() ? nullptr : points[0].data();
  EXPECT_TRUE(plane.Fit(ahd::PointView(numbers, points.size(), 3), executor, progress));
  return plane;
}

double length(const Xyz& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

/// The component that the rule of the sign looks at.
std::size_t mainOf(const Xyz& normal)
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
void expectFrame(const vtkAHDPlane& plane)
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

void expectSame(const vtkAHDPlane& a, const vtkAHDPlane& b)
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

double sineBetween(const Xyz& a, const Xyz& b)
{
  return length(vtkAHDCross(a, b)) / (length(a) * length(b));
}
}

TEST(Plane, RandomPlanesAreFound)
{
  Maker maker(1);
  for (int i = 0; i < 5000; ++i)
  {
    const bool far = i % 2 == 1;
    const Xyz at = far ? Xyz{ { 500000.25, 6000000.5, -120.125 } } : maker.Vector(100);
    Xyz normal;
    const std::vector<Xyz> points = maker.Plane(at, normal);
    const vtkAHDPlane plane = fit(points);
    EXPECT_LT(sineBetween(plane.GetNormal(), normal), 1e-13);
    expectFrame(plane);
    for (const Xyz& p : points)
    {
      EXPECT_NEAR(plane.Project(p)[2], 0.0, 1e-11);
    }
    if (HasFailure())
    {
      FAIL() << "plane " << i << " of normal " << normal[0] << ", " << normal[1] << ", "
             << normal[2];
    }
  }
}

TEST(Plane, DistancesInThePlaneAreKept)
{
  Maker maker(2);
  for (int i = 0; i < 1000; ++i)
  {
    Xyz normal;
    const std::vector<Xyz> points = maker.Plane({ { 500000, 6000000, 0 } }, normal);
    const vtkAHDPlane plane = fit(points);
    const Xyz first = plane.Project(points[0]);
    for (const Xyz& p : points)
    {
      const Xyz q = plane.Project(p);
      const double is = std::hypot(q[0] - first[0], q[1] - first[1]);
      const double was = length(
        { { p[0] - points[0][0], p[1] - points[0][1], p[2] - points[0][2] } });
      ASSERT_NEAR(is, was, 1e-11) << "plane " << i;
    }
  }
}

TEST(Plane, OnlyThePointsDecide)
{
  Maker maker(3);
  for (int i = 0; i < 500; ++i)
  {
    std::vector<Xyz> points(3 + std::size_t(i));
    for (Xyz& p : points)
    {
      const double x = maker.Fraction();
      const double y = maker.Fraction() * 1e5;
      p = { { x, y, maker.Fraction() * 10 + 6e6 } };
    }
    const vtkAHDPlane before = fit(points);
    maker.Shuffle(points);
    expectSame(fit(points), before);
    ASSERT_FALSE(HasFailure()) << i << " more than 3 points";
  }
}

TEST(Plane, ThreadsDoNotDecide)
{
  Maker maker(4);
  std::vector<Xyz> points(std::size_t(1) << 19); // enough to be shared
  for (Xyz& p : points)
  {
    const double x = maker.Fraction();
    const double y = maker.Fraction();
    p = { { x, y, x / 3 + y / 7 + maker.Fraction() / 100 } };
  }
  const vtkAHDPlane before = fit(points);
  expectSame(fit(points, 4), before);
  maker.Shuffle(points);
  expectSame(fit(points, 3), before);
}

TEST(Plane, ScaleChangesNothing)
{
  Maker maker(5);
  for (int i = 0; i < 300; ++i)
  {
    Xyz normal;
    const std::vector<Xyz> points = maker.Plane(maker.Vector(1000), normal);
    const vtkAHDPlane before = fit(points);
    for (int exponent : { -1060, -1000, -300, -1, 40, 300, 1000, 1009 })
    {
      std::vector<Xyz> scaled = points;
      for (Xyz& p : scaled)
      {
        for (double& x : p)
        {
          x = std::ldexp(x, exponent);
        }
      }
      const vtkAHDPlane plane = fit(scaled);
      EXPECT_EQ(plane.GetNormal(), before.GetNormal());
      EXPECT_EQ(plane.GetFirstAxis(), before.GetFirstAxis());
      const Xyz laid = before.Project(points[1]);
      const Xyz laidScaled = plane.Project(scaled[1]);
      for (std::size_t k = 0; k < 2; ++k)
      {
        const double expected = std::ldexp(laid[k], exponent);
        EXPECT_NEAR(laidScaled[k], expected, std::fabs(expected) * 1e-12 + 0x1p-1070);
      }
      ASSERT_FALSE(HasFailure()) << "plane " << i << " times 2^" << exponent;
    }
  }
}

TEST(Plane, TheLargestNumbersStayFinite)
{
  constexpr double most = std::numeric_limits<double>::max();
  const vtkAHDPlane plane = fit(
    { { { -most, 0, most } }, { { most, 0, most } }, { { 0, most / 2, most } } });
  EXPECT_EQ(plane.GetNormal(), (Xyz{ { 0, 0, 1 } }));
  EXPECT_EQ(plane.Project({ { -most, 0, most } })[0], -most);
  const vtkAHDPlane tilted = fit({ { { most, 0, most } }, { { -most, 0, -most } },
    { { most / 2, most, most / 2 } }, { { 0, -most, 0 } } });
  EXPECT_LT(sineBetween(tilted.GetNormal(), { { -1, 0, 1 } }), 1e-15);
  EXPECT_TRUE(std::isfinite(tilted.Project({ { most / 2, most, most / 2 } })[1]));
}

TEST(Plane, NoOtherPlaneIsCloser)
{
  Maker maker(6);
  for (int i = 0; i < 300; ++i)
  {
    const Xyz stretch = { { 1 + 9 * maker.Fraction(), 1 + 9 * maker.Fraction(), 1.0 } };
    std::vector<Xyz> points(60);
    Xyz mean = { { 0, 0, 0 } };
    for (Xyz& p : points)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        p[k] = (maker.Fraction() - 0.5) * stretch[(k + std::size_t(i)) % 3] + 1000.0;
        mean[k] += p[k] / 60;
      }
    }
    const auto squares = [&](const Xyz& n)
    {
      double sum = 0.0;
      for (const Xyz& p : points)
      {
        const double d = vtkAHDDot(n, { { p[0] - mean[0], p[1] - mean[1], p[2] - mean[2] } }) /
          length(n);
        sum += d * d;
      }
      return sum;
    };
    const vtkAHDPlane plane = fit(points);
    const double least = squares(plane.GetNormal());
    double heights = 0.0;
    for (const Xyz& p : points)
    {
      heights += plane.Project(p)[2];
    }
    EXPECT_NEAR(heights, 0.0, 1e-9);
    for (double turn : { 1e-4, 0.01, 0.3, 1.0, 10.0 })
    {
      Xyz other = plane.GetNormal();
      const Xyz by = maker.Vector(10);
      for (std::size_t k = 0; k < 3; ++k)
      {
        other[k] += turn * by[k] / 10;
      }
      EXPECT_GE(squares(other), least * (1 - 1e-9)) << "cloud " << i << " turned by " << turn;
    }
  }
}

TEST(Plane, PlanesAlongTwoAxesKeepEveryDigit)
{
  Maker maker(7);
  for (std::size_t across : { 0u, 1u, 2u })
  {
    for (const Xyz& at : { Xyz{ { 0, 0, 0 } }, Xyz{ { 500000.1, 6000000.1, 99.9 } } })
    {
      std::vector<Xyz> points(500);
      for (Xyz& p : points)
      {
        p = { { at[0] + 0.1 * maker.Whole(300), at[1] + 0.1 * maker.Whole(300),
          at[2] + 0.1 * maker.Whole(300) } };
        p[across] = at[across];
      }
      const vtkAHDPlane plane = fit(points);
      EXPECT_EQ(plane.GetNormal(), vtkAHDUnitAxis(across));
      EXPECT_EQ(plane.GetFirstAxis(), vtkAHDUnitAxis(across + 1));
      EXPECT_EQ(plane.GetSecondAxis(), vtkAHDUnitAxis(across + 2));
      const Xyz origin = plane.Project({ { 0, 0, 0 } });
      for (const Xyz& p : points)
      {
        const Xyz q = plane.Project(p);
        // adding the origin back gives the coordinate: nothing was rounded away
        EXPECT_EQ(q[0] - origin[0], p[(across + 1) % 3]);
        EXPECT_EQ(q[1] - origin[1], p[(across + 2) % 3]);
        EXPECT_EQ(q[2], 0.0);
      }
    }
  }
}

TEST(Plane, TheSideOfTiesIsDecided)
{
  // three points of x + y + z = 1, of y = x, of z = x, of z = -y: the last of the large components
  const double third = std::sqrt(1.0 / 3), half = std::sqrt(0.5);
  const auto expectNormal = [](const std::vector<Xyz>& points, const Xyz& expected)
  {
    const Xyz normal = fit(points).GetNormal();
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(normal[k], expected[k], 1e-15) << "component " << k;
    }
  };
  expectNormal({ { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } }, { { third, third, third } });
  expectNormal(
    { { { 1, 0, 0 } }, { { 0, -1, 0 } }, { { 0, 0, -1 } } }, { { -third, third, third } });
  expectNormal({ { { 0, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 0, 1 } } }, { { -half, half, 0 } });
  expectNormal({ { { 0, 0, 0 } }, { { 1, 0, 1 } }, { { 0, 1, 0 } } }, { { -half, 0, half } });
  expectNormal({ { { 0, 0, 0 } }, { { 0, 1, -1 } }, { { 1, 0, 0 } } }, { { 0, half, half } });
}

TEST(Plane, PointsWithoutAPlaneHaveOne)
{
  EXPECT_EQ(fit({}).GetNormal(), (Xyz{ { 0, 0, 1 } }));
  EXPECT_EQ(fit({ { { 1, 2, 3 } } }).GetNormal(), (Xyz{ { 0, 0, 1 } }));
  EXPECT_EQ(fit(std::vector<Xyz>(9, { { 0.1, 0.2, 0.3 } })).GetNormal(), (Xyz{ { 0, 0, 1 } }));
  EXPECT_EQ(fit(std::vector<Xyz>(9, { { 0.1, 0.2, 0.3 } })).Project({ { 0.1, 0.2, 0.3 } }),
    (Xyz{ { 0, 0, 0 } }));
}

TEST(Plane, PointsOnALineHaveThePlaneClosestToZ)
{
  Maker maker(8);
  for (int i = 0; i < 1000; ++i)
  {
    const Xyz at = i % 2 ? Xyz{ { 500000.1, 6000000.7, 12.3 } } : Xyz{ { 0, 0, 0 } };
    Xyz along;
    do
    {
      along = maker.Vector(3);
    } while (length(along) == 0);
    std::vector<Xyz> points;
    for (int j = -20; j < 20; ++j)
    {
      const double t = j / 7.0; // rounded, so the points are next to the line, not on it
      points.push_back({ { at[0] + t * along[0], at[1] + t * along[1], at[2] + t * along[2] } });
    }
    const bool isSteep = std::fabs(along[2]) > std::max(std::fabs(along[0]), std::fabs(along[1]));
    const double norm = length(along);
    const Xyz unit = { { along[0] / norm, along[1] / norm, along[2] / norm } };
    const Xyz expected = vtkAHDPerpendicular(vtkAHDUnitAxis(isSteep ? 1 : 2), unit);
    const vtkAHDPlane plane = fit(points);
    expectFrame(plane);
    EXPECT_LT(sineBetween(plane.GetNormal(), expected), 1e-8);
    ASSERT_FALSE(HasFailure()) << "line " << i;
  }
}

TEST(Plane, ThinBandsHaveTheirOwnPlane)
{
  // A band a millionth as wide as long and a thousandth of that thick, at 45 degrees; the numbers
  // are multiples of powers of two, so they are what they seem.
  Maker maker(9);
  std::vector<Xyz> points;
  for (int i = 0; i < 2000; ++i)
  {
    const double along = maker.Whole(1 << 20) * 0x1p-20;
    const double wide = maker.Whole(1 << 10) * 0x1p-30;
    const double thick = maker.Whole(1) * 0x1p-40;
    // the band's own system is (1, 1, 0), (1, -1, 0) / sqrt(2), z
    points.push_back({ { along + wide, along - wide, thick } });
  }
  EXPECT_LT(sineBetween(fit(points).GetNormal(), { { 0, 0, 1 } }), 1e-4);
  for (Xyz& p : points)
  {
    p = { { p[0], p[2], p[1] } };
  }
  EXPECT_LT(sineBetween(fit(points).GetNormal(), { { 0, 1, 0 } }), 1e-4);
  for (Xyz& p : points)
  {
    // turned about the band's length: width and thickness share the sums' small digits
    p = { { p[0] + p[1], p[0] - p[1], p[2] * 2 } };
  }
  EXPECT_LT(fit(points).Project(points[0])[2], 0x1p-20);
}

TEST(Plane, PointsThatAreLeftOutDoNotCount)
{
  const std::vector<Xyz> square = { { { 0, 0, 0 } }, { { 1, 0, 1 } }, { { 0, 1, 0 } },
    { { 1, 1, 1 } } };
  const vtkAHDPlane expected = fit(square);
  std::vector<Xyz> more = square;
  more.push_back({ { kNaN, 7, 5 } });
  more.push_back({ { 8, 7, kInfinity } });
  more.push_back({ { 8, -kInfinity, 3 } });
  expectSame(fit(more), expected);

  more = square;
  more.push_back({ { 4, 3, 100 } });
  const std::vector<unsigned char> marks = { 0, 0, 0, 0, 3 };
  ahd::PointView view(more[0].data(), more.size(), 3);
  view.skip = marks.data();
  view.skipMask = 2;
  vtkNew<vtkAlgorithm> filter;
  vtkAHDProgress progress(filter);
  vtkAHDExecutor executor(1);
  vtkAHDPlane plane;
  ASSERT_TRUE(plane.Fit(view, executor, progress));
  expectSame(plane, expected);
}

TEST(Plane, FloatsAreFittedAsTheyAre)
{
  Maker maker(10);
  std::vector<Xyz> points(200);
  std::vector<float> floats;
  for (Xyz& p : points)
  {
    for (double& x : p)
    {
      floats.push_back(float(maker.Fraction()));
      x = floats.back();
    }
  }
  vtkNew<vtkAlgorithm> filter;
  vtkAHDProgress progress(filter);
  vtkAHDExecutor executor(1);
  vtkAHDPlane plane;
  ASSERT_TRUE(plane.Fit(ahd::PointView(floats.data(), 200, 3), executor, progress));
  expectSame(plane, fit(points));
}

TEST(Plane, AnAbortIsHeard)
{
  vtkNew<vtkAlgorithm> filter;
  filter->SetAbortExecute(1);
  vtkAHDProgress progress(filter);
  vtkAHDExecutor executor(1);
  const std::vector<Xyz> points(10, { { 1, 2, 3 } });
  vtkAHDPlane plane;
  EXPECT_FALSE(plane.Fit(ahd::PointView(points[0].data(), 10, 3), executor, progress));
}

TEST(Plane, TheTransformIsThePlane)
{
  Maker maker(11);
  for (int i = 0; i < 300; ++i)
  {
    Xyz normal;
    const std::vector<Xyz> points = maker.Plane({ { 5000, -6000, 7 } }, normal);
    const vtkAHDPlane plane = fit(points);
    const vtkSmartPointer<vtkTransform> transform = plane.MakeTransform();
    for (const Xyz& p : points)
    {
      Xyz q;
      transform->TransformPoint(p.data(), q.data());
      const Xyz expected = plane.Project(p);
      for (std::size_t k = 0; k < 3; ++k)
      {
        ASSERT_NEAR(q[k], expected[k], 1e-10) << "plane " << i;
      }
    }
  }
}
