// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_test_PredicatesOracle_h
#define ahd_test_PredicatesOracle_h

#include "Predicates/Predicates.h"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

/// The correct answers of the predicates, by GMP's integers and determinants of the untranslated
/// coordinates: nothing is shared with the code under test.
namespace ahd::test
{

/// The points' coordinates as integers: multiplied by one power of two. Signs of determinants that
/// are homogeneous in the coordinates do not change by that.
template <std::size_t N>
std::array<std::array<mpz_class, 2>, N> asIntegers(const std::array<Point, N>& points)
{
  int lowest = 2000;
  for (const Point& p : points)
  {
    for (const double v : { p.x, p.y })
    {
      int exponent = 0;
      std::frexp(v, &exponent);
      lowest = v == 0.0 ? lowest : std::min(lowest, exponent - 53);
    }
  }
  std::array<std::array<mpz_class, 2>, N> result;
  for (std::size_t i = 0; i < N; ++i)
  {
    const double coordinates[2] = { points[i].x, points[i].y };
    for (std::size_t k = 0; k < 2; ++k)
    {
      int exponent = 0;
      const double fraction = std::frexp(coordinates[k], &exponent);
      if (fraction != 0.0)
      {
        mpz_class& value = result[i][k];
        value = std::ldexp(fraction, 53);
        mpz_mul_2exp(value.get_mpz_t(), value.get_mpz_t(), mp_bitcnt_t(exponent - 53 - lowest));
      }
    }
  }
  return result;
}

/// | 1 x y | for each of three points.
inline mpz_class determinant3(const std::array<mpz_class, 2>& a, const std::array<mpz_class, 2>& b,
  const std::array<mpz_class, 2>& c)
{
  return (a[0] * b[1] - a[1] * b[0]) + (b[0] * c[1] - b[1] * c[0]) + (c[0] * a[1] - c[1] * a[0]);
}

inline int oracleOrient2d(const Point& a, const Point& b, const Point& c)
{
  const auto p = asIntegers<3>({ a, b, c });
  return sgn(determinant3(p[0], p[1], p[2]));
}

/// The sign of 5 (a - c) x (b - c) + 2 (a - c) . (b - c).
inline int oracleFlatness(const Point& a, const Point& b, const Point& c)
{
  const auto p = asIntegers<3>({ a, b, c });
  const mpz_class dot = (p[0][0] - p[2][0]) * (p[1][0] - p[2][0]) +
    (p[0][1] - p[2][1]) * (p[1][1] - p[2][1]);
  return sgn(mpz_class(5 * determinant3(p[0], p[1], p[2]) + 2 * dot));
}

/// The in-circle determinant, rows (x, y, x^2 + y^2, 1), developed by its third column: entry i is
/// the coefficient of point i's lifted height.
template <std::size_t N>
std::array<mpz_class, N> heightCoefficients(const std::array<std::array<mpz_class, 2>, N>& p)
{
  static_assert(N == 4, "the in-circle determinant has four rows");
  return { determinant3(p[1], p[2], p[3]), -determinant3(p[0], p[2], p[3]),
    determinant3(p[0], p[1], p[3]), -determinant3(p[0], p[1], p[2]) };
}

inline int oracleInCircle(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const auto p = asIntegers<4>({ a, b, c, d });
  const auto coefficient = heightCoefficients(p);
  mpz_class sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    sum += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) * coefficient[i];
  }
  return sgn(sum);
}

/// The in-circle determinant when the height of the k-th point in lexicographic order is raised by
/// eps_k, where each eps_k is smaller than every power of eps_{k+1}: a polynomial in four
/// infinitesimals (here linear, as every height occurs once in each product). Its sign is that of
/// the constant term or else of the coefficient of the largest infinitesimal that occurs.
inline bool oracleInConflict(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const int sign = oracleInCircle(a, b, c, d);
  if (sign != 0)
  {
    return sign > 0;
  }
  const std::array<Point, 4> points = { a, b, c, d };
  const auto coefficient = heightCoefficients(asIntegers<4>(points));
  std::array<std::size_t, 4> order = { 0, 1, 2, 3 };
  std::sort(order.begin(), order.end(),
    [&](std::size_t i, std::size_t k) {
      return points[k].x < points[i].x || (points[k].x == points[i].x && points[k].y < points[i].y);
    });
  for (const std::size_t i : order)
  {
    if (sgn(coefficient[i]) != 0)
    {
      return sgn(coefficient[i]) > 0;
    }
  }
  return false;
}

} // namespace ahd::test

#endif
