// SPDX-License-Identifier: BSD-3-Clause
//
// The filters where products underflow: rounded to a subnormal number or to zero, a product is
// wrong by more than its own bits show. The guards against that must catch all such cases.
#include "Predicates/Filters.h"
#include "Predicates/Stages.h"

#include "ExactSigns.h"
#include "PredicatesOracle.h"

#include <gtest/gtest.h>

#include <random>

namespace ahd::test
{
namespace
{

#ifdef AHD_REDUCED_TESTS
constexpr int kCases = 4000;
#else
constexpr int kCases = 20000;
#endif

/// Numbers with all their bits, of random sign, from `least` up to twice that.
class Numbers
{
public:
  double around(double least)
  {
    const std::uint64_t bits = random_();
    const double magnitude = least * (1.0 + std::ldexp(double(bits >> 12), -52));
    return (bits & 1) != 0 ? -magnitude : magnitude;
  }
  unsigned below(unsigned end) { return static_cast<unsigned>(random_() % end); }

private:
  std::mt19937_64 random_{ 1 };
};

/// The b for which (a - c)(b - d) is nearest to `product`.
double otherFactor(double a, double c, double d, double product)
{
  return d + product / (a - c);
}

/// Both products of the orientation lie as near as can be to the same middle between two subnormal
/// numbers: as the differences are rounded before, each may end up on its wrong side.
TEST(PredicatesGuards, OrientationsWhoseProductsAreSubnormal)
{
  constexpr double kScale = 0x1p-537;
  Numbers numbers;
  int misleading = 0;
  for (int i = 0; i < kCases; ++i)
  {
    const Point c{ numbers.around(kScale / 2), numbers.around(kScale / 2) };
    Point a{ numbers.around(kScale), numbers.around(kScale) }, b;
    // The products are so small that they can only be written in another unit.
    const double middle = 0.5 + numbers.below(4);
    b.y = otherFactor(a.x / kScale, c.x / kScale, c.y / kScale, middle) * kScale;
    b.x = otherFactor(a.y / kScale, c.y / kScale, c.x / kScale, middle) * kScale;
    const int exact = oracleOrient2d(a, b, c);
    const Lifted A = liftedFrom(c, a), B = liftedFrom(c, b);
    const double det = cross(A, B);
    misleading += signOf(det) == -exact && det != 0.0;
    if (orientIsCertain(det, A.z, B.z))
    {
      ASSERT_EQ(signOf(det), exact) << hexText(a) << hexText(b) << hexText(c);
    }
    if (const std::optional<int> sign = stages::orient2dByFilter(a, b, c))
    {
      ASSERT_EQ(*sign, exact) << hexText(a) << hexText(b) << hexText(c);
    }
  }
  EXPECT_GT(misleading, kCases / 1000) << "the cases are too easy";
}

/// So small that the terms of the determinant are a few times the smallest number, each rounded.
TEST(PredicatesGuards, CirclesWhoseTermsAreSubnormal)
{
  Numbers numbers;
  int misleading = 0;
  for (int i = 0; i < kCases; ++i)
  {
    const double scale = std::ldexp(1.0, -270 + static_cast<int>(numbers.below(5)));
    Point p[4];
    for (Point& q : p)
    {
      q = { numbers.around(scale), numbers.around(scale) };
    }
    const int exact = oracleInCircle(p[0], p[1], p[2], p[3]);
    const Lifted a = liftedFrom(p[3], p[0]), b = liftedFrom(p[3], p[1]), c = liftedFrom(p[3], p[2]);
    const double det = inCircleDeterminant(a, b, c, cross(a, b));
    misleading += signOf(det) == -exact && det != 0.0;
    if (inCircleIsCertain(det, a.z, b.z, c.z, inCircleGuard(a.z + b.z + c.z)))
    {
      ASSERT_EQ(signOf(det), exact)
        << hexText(p[0]) << hexText(p[1]) << hexText(p[2]) << hexText(p[3]);
    }
  }
  EXPECT_GT(misleading, kCases / 1000) << "the cases are too easy";
}

} // namespace
} // namespace ahd::test
