// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_test_PredicatesFastOracle_h
#define ahd_test_PredicatesFastOracle_h

#include "Points/Points.h"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

/// The answers of PredicatesOracle.h, some ten times as fast, for very many cases: GMP's integers,
/// all of them kept from case to case, so that nothing is allocated. It shares no line with the
/// engine, and uses other forms of the determinants: the orientation with untranslated
/// coordinates, the in-circle determinant with a, not d, in the origin and developed by its lifted
/// column. PredicatesExtremes.cxx compares it with PredicatesOracle.h.
namespace ahd::test
{

/// A number that keeps its room.
class Integer
{
public:
  Integer() { mpz_init2(value_, 8192); }
  ~Integer() { mpz_clear(value_); }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  int sign() const { return mpz_sgn(value_); }
  operator mpz_ptr() { return value_; }
  operator mpz_srcptr() const { return value_; }

private:
  mpz_t value_;
};

/// A double without its exponent: value = mantissa * 2^exponent.
struct Scientific
{
  std::uint64_t mantissa;
  int exponent;
  bool negative;

  explicit Scientific(double value)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    const std::uint64_t fraction = bits & ((std::uint64_t(1) << 52) - 1);
    const int field = int(bits >> 52 & 2047);
    mantissa = field == 0 ? fraction : fraction + (std::uint64_t(1) << 52);
    exponent = std::max(field, 1) - 1075;
    negative = bits >> 63 != 0;
  }
};

/// Coordinates times a common power of two, which changes no sign here.
template <std::size_t N>
class CommonUnit
{
public:
  void take(const std::array<double, N>& values)
  {
    exponent_ = 2000;
    for (const double value : values)
    {
      const Scientific s(value);
      exponent_ = s.mantissa == 0 ? exponent_ : std::min(exponent_, s.exponent);
    }
    for (std::size_t i = 0; i < N; ++i)
    {
      const Scientific s(values[i]);
      mpz_set_ui(integers_[i], s.mantissa);
      if (s.mantissa != 0)
      {
        mpz_mul_2exp(integers_[i], integers_[i], mp_bitcnt_t(s.exponent - exponent_));
      }
      if (s.negative)
      {
        mpz_neg(integers_[i], integers_[i]);
      }
    }
  }
  mpz_srcptr operator[](std::size_t i) const { return integers_[i]; }
  /// The unit is 2^exponent(); 2000 if all values are 0.
  int exponent() const { return exponent_; }

private:
  std::array<Integer, N> integers_;
  int exponent_ = 2000;
};

class FastOracle
{
public:
  /// a.x (b.y - c.y) + b.x (c.y - a.y) + c.x (a.y - b.y)
  int orient(const Point& a, const Point& b, const Point& c)
  {
    three_.take({ a.x, a.y, b.x, b.y, c.x, c.y });
    mpz_sub(t_, three_[3], three_[5]);
    mpz_mul(sum_, three_[0], t_);
    mpz_sub(t_, three_[5], three_[1]);
    mpz_addmul(sum_, three_[2], t_);
    mpz_sub(t_, three_[1], three_[3]);
    mpz_addmul(sum_, three_[4], t_);
    return sum_.sign();
  }

  /// 5 (a - c) x (b - c) + 2 (a - c) . (b - c), the second multiplied out:
  /// 2 a.x b.x - 2 c.x (a.x + b.x - c.x), and so for y.
  int flatness(const Point& a, const Point& b, const Point& c)
  {
    orient(a, b, c);
    mpz_mul_ui(sum_, sum_, 5);
    for (std::size_t i = 0; i < 2; ++i)
    {
      mpz_add(t_, three_[i], three_[2 + i]);
      mpz_sub(t_, t_, three_[4 + i]);
      mpz_mul_2exp(t_, t_, 1);
      mpz_submul(sum_, three_[4 + i], t_);
      mpz_mul_2exp(t_, three_[i], 1);
      mpz_addmul(sum_, t_, three_[2 + i]);
    }
    return sum_.sign();
  }

  /// Positive if d lies inside the circle of a, b, c, counterclockwise.
  int inCircle(const Point& a, const Point& b, const Point& c, const Point& d)
  {
    four_.take({ a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y });
    for (std::size_t i = 0; i < 3; ++i)
    {
      mpz_sub(x_[i], four_[2 * i + 2], four_[0]);
      mpz_sub(y_[i], four_[2 * i + 3], four_[1]);
    }
    mpz_set_ui(sum_, 0);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      mpz_mul(t_, x_[j], y_[k]);
      mpz_submul(t_, x_[k], y_[j]);
      mpz_mul(lifted_, x_[i], x_[i]);
      mpz_addmul(lifted_, y_[i], y_[i]);
      mpz_addmul(sum_, lifted_, t_);
    }
    return -sum_.sign(); // moving a from first to last is an odd permutation of the rows
  }

  /// `sign` is that of inCircle(a, b, c, d). Ties as PredicatesOracle.h explains them.
  bool inConflict(const Point& a, const Point& b, const Point& c, const Point& d, int sign)
  {
    const std::array<Point, 4> points = { a, b, c, d };
    std::array<std::size_t, 4> order = { 0, 1, 2, 3 };
    std::sort(order.begin(), order.end(),
      [&](std::size_t i, std::size_t k) { return less(points[k], points[i]); });
    for (std::size_t k = 0; k < 4 && sign == 0; ++k)
    {
      sign = order[k] == 0 ? orient(b, c, d)
        : order[k] == 1    ? -orient(a, c, d)
        : order[k] == 2    ? orient(a, b, d)
                           : -orient(a, b, c);
    }
    return sign > 0;
  }

  /// The order of the doubles as integers, in which -0 is 0.
  static std::int64_t key(double value)
  {
    std::int64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits < 0 ? -(bits & INT64_MAX) : bits;
  }

  static bool less(const Point& a, const Point& b)
  {
    return key(a.x) != key(b.x) ? key(a.x) < key(b.x) : key(a.y) < key(b.y);
  }

private:
  CommonUnit<6> three_;
  CommonUnit<8> four_;
  std::array<Integer, 3> x_, y_;
  Integer t_, lifted_, sum_;
};

} // namespace ahd::test

#endif
