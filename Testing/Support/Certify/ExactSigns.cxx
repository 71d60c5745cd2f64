// SPDX-License-Identifier: BSD-3-Clause
#include "ExactSigns.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kRoundoff = 1.1102230246251565e-16; // 2^-53
constexpr int kUndecided = 2;

template <typename Number>
int signOf(const Number& value)
{
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Are all numbers zero or of a size between `low` and `high`?
template <int Count>
bool within(const double (&numbers)[Count], double low, double high)
{
  bool all = true;
  for (const double number : numbers)
  {
    const double size = std::fabs(number);
    all = all && (size == 0.0 || (size > low && size < high));
  }
  return all;
}

/// The sign of `determinant`, if it is larger than `factor` roundoffs of `magnitude`, the sum of
/// the absolute values of its terms. @pre nothing overflowed, no product of nonzeros
/// underflowed.
int filtered(double determinant, double magnitude, double factor)
{
  const bool certain = std::fabs(determinant) > factor * kRoundoff * magnitude;
  return certain ? signOf(determinant) : kUndecided;
}

/// x - y, and whether the difference is exact.
double difference(double x, double y, bool& exact)
{
  const double d = x - y;
  const double back = x - d;
  exact = exact && (x - (d + back)) + (back - y) == 0.0;
  return d;
}

/// Brings exact differences to integers of at most 30 bits by one common power of two. Returns
/// false if that cannot be done.
bool toIntegers(const double* differences, std::int64_t* integers, int count)
{
  double largest = 0.0;
  for (int i = 0; i < count; ++i)
  {
    largest = std::max(largest, std::fabs(differences[i]));
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  if (exponent < -900 || exponent > 900)
  {
    return false;
  }
  const double scale = std::ldexp(1.0, 30 - exponent);
  for (int i = 0; i < count; ++i)
  {
    const double scaled = differences[i] * scale;
    integers[i] = static_cast<std::int64_t>(scaled);
    const bool lost = scaled == 0.0 && differences[i] != 0.0; // underflow
    if (lost || static_cast<double>(integers[i]) != scaled)
    {
      return false;
    }
  }
  return true;
}

/// Coordinates as GMP integers in units of the smallest exponent among them.
template <int Count>
class CommonIntegers
{
public:
  const mpz_class* convert(const double (&values)[Count])
  {
    int exponents[Count];
    std::int64_t mantissas[Count];
    int smallest = 2000;
    for (int i = 0; i < Count; ++i)
    {
      const double fraction = std::frexp(values[i], &exponents[i]);
      mantissas[i] = static_cast<std::int64_t>(std::ldexp(fraction, 53));
      smallest = mantissas[i] == 0 ? smallest : std::min(smallest, exponents[i]);
    }
    for (int i = 0; i < Count; ++i)
    {
      integers_[i] = static_cast<long>(mantissas[i]);
      if (mantissas[i] != 0)
      {
        integers_[i] <<= static_cast<unsigned>(exponents[i] - smallest);
      }
    }
    return integers_;
  }

private:
  mpz_class integers_[Count];
};

int orientByGmp(const Point& a, const Point& b, const Point& c)
{
  static thread_local CommonIntegers<6> integers;
  static thread_local mpz_class acx, acy, bcx, bcy, left, right;
  const mpz_class* v = integers.convert({ a.x, a.y, b.x, b.y, c.x, c.y });
  acx = v[0] - v[4];
  acy = v[1] - v[5];
  bcx = v[2] - v[4];
  bcy = v[3] - v[5];
  left = acx * bcy;
  right = acy * bcx;
  return signOf(cmp(left, right));
}

/// The three rows (x, y, x^2 + y^2) of the in-circle determinant, and its value.
int inCircleByGmp(const Point& a, const Point& b, const Point& c, const Point& d)
{
  static thread_local CommonIntegers<8> integers;
  static thread_local mpz_class x[3], y[3], lifted[3], minor, determinant;
  const mpz_class* v = integers.convert({ a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y });
  for (int i = 0; i < 3; ++i)
  {
    x[i] = v[2 * i] - v[6];
    y[i] = v[2 * i + 1] - v[7];
    lifted[i] = x[i] * x[i];
    lifted[i] += y[i] * y[i];
  }
  determinant = 0;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    minor = x[j] * y[k];
    minor -= y[j] * x[k];
    determinant += lifted[i] * minor;
  }
  return sgn(determinant);
}

int inCircleByIntegers(const double (&differences)[6])
{
  std::int64_t v[6];
  if (!toIntegers(differences, v, 6))
  {
    return kUndecided;
  }
  __extension__ using Wide = __int128;
  Wide determinant = 0;
  for (int i = 0; i < 3; ++i)
  {
    const std::int64_t* p = v + 2 * i;
    const std::int64_t* q = v + 2 * ((i + 1) % 3);
    const std::int64_t* r = v + 2 * ((i + 2) % 3);
    determinant += static_cast<Wide>(p[0] * p[0] + p[1] * p[1]) * (q[0] * r[1] - q[1] * r[0]);
  }
  return signOf(determinant);
}

} // namespace

int orientSign(const Point& a, const Point& b, const Point& c)
{
  bool exact = true;
  const double d[4] = { difference(a.x, c.x, exact), difference(a.y, c.y, exact),
    difference(b.x, c.x, exact), difference(b.y, c.y, exact) };
  const double left = d[0] * d[3];
  const double right = d[1] * d[2];
  // A term passes two differences, a product and the last subtraction: 4 roundings; 8 is generous.
  const int sign = filtered(left - right, std::fabs(left) + std::fabs(right), 8.0);
  if (sign != kUndecided && within(d, 1e-140, 1e140))
  {
    return sign;
  }
  std::int64_t v[4];
  if (exact && toIntegers(d, v, 4))
  {
    return signOf(v[0] * v[3] - v[1] * v[2]);
  }
  return orientByGmp(a, b, c);
}

int inCircleSign(const Point& a, const Point& b, const Point& c, const Point& d)
{
  bool exact = true;
  const double v[6] = { difference(a.x, d.x, exact), difference(a.y, d.y, exact),
    difference(b.x, d.x, exact), difference(b.y, d.y, exact), difference(c.x, d.x, exact),
    difference(c.y, d.y, exact) };
  double determinant = 0.0;
  double magnitude = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double* p = v + 2 * i;
    const double* q = v + 2 * ((i + 1) % 3);
    const double* r = v + 2 * ((i + 2) % 3);
    const double lifted = p[0] * p[0] + p[1] * p[1];
    determinant += lifted * (q[0] * r[1] - q[1] * r[0]);
    magnitude += lifted * (std::fabs(q[0] * r[1]) + std::fabs(q[1] * r[0]));
  }
  // A term passes at most 4 roundings for `lifted`, 4 for the minor, 1 product and 3 sums: 16 is
  // generous.
  const int sign = filtered(determinant, magnitude, 16.0);
  if (sign != kUndecided && within(v, 1e-70, 1e70))
  {
    return sign;
  }
  const int byIntegers = exact ? inCircleByIntegers(v) : kUndecided;
  return byIntegers != kUndecided ? byIntegers : inCircleByGmp(a, b, c, d);
}

int perturbedInCircleSign(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const int sign = inCircleSign(a, b, c, d);
  if (sign != 0)
  {
    return sign;
  }
  // The determinant is linear in the four heights. The coefficient of each, in the same scale as
  // the determinant, is the area of the other three; d's own comes with a minus.
  const Point* points[4] = { &a, &b, &c, &d };
  const auto coefficient = [&](const Point* p)
  {
    return p == &a ? orientSign(b, c, d)
      : p == &b    ? orientSign(c, a, d)
      : p == &c    ? orientSign(a, b, d)
                   : -orientSign(a, b, c);
  };
  std::sort(points, points + 4,
    [](const Point* p, const Point* q) { return lexicographicallyLess(*q, *p); });
  for (const Point* p : points)
  {
    const int s = coefficient(p);
    if (s != 0)
    {
      return s;
    }
  }
  std::abort(); // four collinear points are not a triangle and a point on its circle
}

std::string hexText(const Point& p)
{
  char text[80];
  std::snprintf(text, sizeof text, "(%a, %a)", p.x, p.y);
  return text;
}

} // namespace test
} // namespace ahd
