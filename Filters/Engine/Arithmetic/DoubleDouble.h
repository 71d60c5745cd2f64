// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_DoubleDouble_h
#define ahd_DoubleDouble_h

namespace ahd
{

/// A number as the unevaluated sum of two doubles: about 106 bits. T. J. Dekker, A floating-point
/// technique for extending the available precision, Numerische Mathematik 18 (1971) 224-242.
///
/// Sums and products have a relative error of some 2^-100 (sums: relative to the larger operand)
/// as long as nothing overflows or underflows: callers scale first. For coordinates, never for
/// decisions that the triangulation rests on.
/// @pre rounding to nearest, no contraction.
struct DoubleDouble
{
  double high = 0.0;
  double low = 0.0;

  double value() const { return high + low; }
};

/// @pre |a| >= |b|, or one of them is 0.
inline DoubleDouble fastSum(double a, double b)
{
  const double sum = a + b;
  return { sum, b - (sum - a) };
}

/// a + b, exactly.
inline DoubleDouble exactSum(double a, double b)
{
  const double sum = a + b;
  const double ofB = sum - a;
  const double ofA = sum - ofB;
  return { sum, (a - ofA) + (b - ofB) };
}

/// a - b, exactly.
inline DoubleDouble exactDifference(double a, double b)
{
  return exactSum(a, -b);
}

/// a * b, exactly. @pre both are below 2^500 in magnitude, and the product is no less than
/// 2^-900 or 0.
inline DoubleDouble exactProduct(double a, double b)
{
  constexpr double kSplitter = 134217729.0; // 2^27 + 1
  const double bigA = kSplitter * a;
  const double bigB = kSplitter * b;
  const double highA = bigA - (bigA - a);
  const double highB = bigB - (bigB - b);
  const double lowA = a - highA;
  const double lowB = b - highB;
  const double product = a * b;
  return { product, ((highA * highB - product) + highA * lowB + lowA * highB) + lowA * lowB };
}

inline DoubleDouble operator-(const DoubleDouble& a)
{
  return { -a.high, -a.low };
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b)
{
  const DoubleDouble high = exactSum(a.high, b.high);
  const DoubleDouble low = exactSum(a.low, b.low);
  const DoubleDouble most = fastSum(high.high, high.low + low.high);
  return fastSum(most.high, most.low + low.low);
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b)
{
  return a + -b;
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b)
{
  const DoubleDouble high = exactProduct(a.high, b.high);
  return fastSum(high.high, high.low + (a.high * b.low + a.low * b.high));
}

/// Times a power of two.
inline DoubleDouble scaled(const DoubleDouble& a, double power)
{
  return { a.high * power, a.low * power };
}

/// a / b, with a relative error of some 2^-100.
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b)
{
  const double first = a.high / b.high;
  const DoubleDouble rest = a - b * DoubleDouble{ first, 0.0 };
  return fastSum(first, rest.value() / b.high);
}

/// A vector of the plane.
struct DoubleDoubleVector
{
  DoubleDouble x;
  DoubleDouble y;
};

inline DoubleDouble dot(const DoubleDoubleVector& a, const DoubleDoubleVector& b)
{
  return a.x * b.x + a.y * b.y;
}

inline DoubleDouble cross(const DoubleDoubleVector& a, const DoubleDoubleVector& b)
{
  return a.x * b.y - a.y * b.x;
}

inline int signOf(const DoubleDouble& a)
{
  return a.high > 0.0 ? 1 : a.high < 0.0 ? -1 : 0;
}

} // namespace ahd

#endif
