// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_test_PredicatesExtremes_h
#define ahd_test_PredicatesExtremes_h

#include "Points/Points.h"
#include "PredicatesCases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>

/// Quadruples over the whole range of double that are degenerate exactly, and then moved by one
/// unit in the last place of one coordinate, or by a few, or not at all; and those on which the
/// arithmetic of one stage ends.
namespace ahd::test
{

enum class Extreme
{
  Exponents,   ///< each coordinate of an exponent of its own, mantissas of any length
  Specials,    ///< 0, -0, the smallest, the largest, and where products of 2 and 4 leave the range
  Collinear,   ///< on a line, x and y in scales of their own
  Circle,      ///< on a circle of integer radius squared that has many integer points
  Symmetric,   ///< rectangles, trapezoids, and the eight points (+-a, +-b), (+-b, +-a)
  Lattice,     ///< a few steps of any power of two, far from the origin in units of them
  Shared,      ///< all coordinates from three numbers
  Subnormals,  ///< whole numbers of units in the last place of the smallest, of up to 54 bits
  GridLimit,   ///< spanning about as many bits as the grid stage takes
  RoundedAway, ///< every rounding of the orientation is half a unit, all in one direction
  Huge,        ///< neighbours at the largest numbers, and differences that overflow
  Count
};

constexpr std::size_t kExtremes = static_cast<std::size_t>(Extreme::Count);

// Other ways to compile the engine (CMakeLists.txt) have seeds of their own.
#ifdef AHD_PREDICATES_BUILD
constexpr std::uint64_t kFirstSeed = 1 + 1000 * AHD_PREDICATES_BUILD;
#else
constexpr std::uint64_t kFirstSeed = 1;
#endif

inline const char* nameOf(Extreme extreme)
{
  static const char* const names[] = { "Exponents", "Specials", "Collinear", "Circle", "Symmetric",
    "Lattice", "Shared", "Subnormals", "GridLimit", "RoundedAway", "Huge" };
  return names[static_cast<std::size_t>(extreme)];
}

/// The wrong part of an answer, if any.
class Verdict
{
public:
  const std::string& what() const { return what_; }

protected:
  template <typename Text>
  bool expect(bool isRight, const Text& what)
  {
    if (!isRight)
    {
      what_ = what;
    }
    return isRight;
  }

private:
  std::string what_;
};

/// The k-th double from `value`, upwards if k is positive; kept finite. -0 is the same place as 0.
inline double ulpsFrom(double value, std::int64_t k)
{
  std::int64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  const std::int64_t place = bits < 0 ? -(bits & INT64_MAX) : bits;
  constexpr std::int64_t kLargest = 0x7FEFFFFFFFFFFFFF;
  const std::int64_t kept = k > 0 ? (place < kLargest - k ? place + k : kLargest)
                                  : (place > -kLargest - k ? place + k : -kLargest);
  bits = kept < 0 ? -kept : kept;
  std::memcpy(&value, &bits, sizeof value);
  return kept < 0 ? -value : value;
}

/// Seeded; the same sequence on every platform with IEEE arithmetic.
class Extremes
{
public:
  Extremes(Extreme extreme, std::uint64_t seed)
    : extreme_(extreme)
    , random_(1000 * seed + static_cast<std::uint64_t>(extreme))
  {
  }

  Quadruple draw()
  {
    Quadruple q = degenerate();
    move(q);
    if (below(8) == 0)
    {
      std::swap(q[below(4)], q[below(4)]);
    }
    return q;
  }

  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  int whole(int low, int high) { return low + int(below(std::uint64_t(high - low + 1))); }

private:
  bool chance(unsigned oneIn) { return below(oneIn) == 0; }
  double sign() { return chance(2) ? -1.0 : 1.0; }

  /// An odd number of at most `bits` bits, or one of any parity.
  double mantissa(int bits)
  {
    return double((random_() >> (64 - bits)) | (random_() >> 63)); // bits <= 53
  }

  /// Anything finite: exponents are equally frequent, short mantissas as frequent as long ones.
  double any()
  {
    const int bits = whole(1, 53);
    const double value = std::ldexp(mantissa(bits), whole(-1074 - bits / 2, 1024 - bits));
    return sign() * value;
  }

  /// An exponent for integers of `bits` bits that loses none: any, or one at which products of two
  /// or four of them, or the engine's own limits, leave a range, or one far from all these.
  int exponentFor(int bits)
  {
    static const int critical[] = { -1074, -1022, -900, -537, -511, -269, -255, -240, 0, 255, 256,
      511, 512, 1000, 1023 };
    const int low = -1074, high = 1024 - bits;
    switch (below(3))
    {
      case 0:
        return whole(low, high);
      case 1:
        return std::min(std::max(critical[below(15)] - whole(0, bits) + whole(-4, 4), low), high);
      default:
        return whole(-200, 200) - bits;
    }
  }

  void move(Quadruple& q)
  {
    static const int steps[] = { -1, 1, -1, 1, -1, 1, -2, 3 };
    const std::uint64_t how = below(8);
    const int moves = how < 2 ? 0 : how < 7 ? 1 : 2;
    for (int i = 0; i < moves; ++i)
    {
      Point& p = q[below(4)];
      double& coordinate = chance(2) ? p.x : p.y;
      coordinate = ulpsFrom(coordinate, steps[below(8)]);
    }
  }

  static void scale(Quadruple& q, int ex, int ey)
  {
    for (Point& p : q)
    {
      p = { std::ldexp(p.x, ex), std::ldexp(p.y, ey) };
    }
  }

  double special()
  {
    static const double values[] = { 0.0, 0x1p-1074, 0x1.8p-1073, 0x1p-1022, 0x1p-538, 0x1p-537,
      0x1p-512, 0x1p-511, 0x1p-510, 0x1p-270, 0x1p-269, 0x1p-256, 0x1p-255, 0x1p-53, 1.0, 0x1p53,
      0x1p255, 0x1p256, 0x1p340, 0x1p341, 0x1p511, 0x1p512, 0x1p1000, 0x1p1022, 0x1p1023,
      std::numeric_limits<double>::max() };
    const double value = values[below(26)];
    return sign() * (chance(3) ? ulpsFrom(value, whole(-1, 1)) : value);
  }

  Quadruple onLine()
  {
    const int bits = whole(3, 50);
    const double far = double(std::int64_t(1) << bits);
    const double stepX = mantissa(whole(1, std::min(bits, 24))) * (chance(8) ? 0.0 : sign());
    const double stepY = mantissa(whole(1, std::min(bits, 24))) * (chance(8) ? 0.0 : sign());
    const Point at = { std::floor((double(random_() >> 11) * 0x1p-52 - 1.0) * far),
      std::floor((double(random_() >> 11) * 0x1p-52 - 1.0) * far) };
    const int reach = 1 << whole(1, 24);
    Quadruple q;
    for (Point& p : q)
    {
      const double k = whole(-reach, reach);
      p = { at.x + k * stepX, at.y + k * stepY }; // below 2^52: exact
    }
    const int ex = exponentFor(53);
    scale(q, ex, chance(2) ? ex : exponentFor(53));
    return q;
  }

  /// Products of a + b i or its conjugate for primes a^2 + b^2: all of one absolute value.
  Quadruple onCircle()
  {
    static const int primes[][2] = { { 2, 1 }, { 3, 2 }, { 4, 1 }, { 5, 2 }, { 6, 1 }, { 5, 4 },
      { 7, 2 }, { 6, 5 }, { 8, 3 }, { 8, 5 } };
    const int factors = whole(2, 10);
    const int room = 52 - 3 * factors;
    const double times = mantissa(std::max(1, std::min(room, whole(1, 20)))) + 1.0;
    const double offset = chance(2) ? 0.0 : std::ldexp(1.0, whole(0, 51));
    const Point centre = { sign() * offset, sign() * offset };
    Quadruple q;
    for (Point& p : q)
    {
      double x = 1.0, y = 0.0;
      for (int k = 0; k < factors; ++k)
      {
        const double a = primes[k][0], b = chance(2) ? primes[k][1] : -primes[k][1];
        const double turned = x * a - y * b;
        y = x * b + y * a;
        x = turned;
      }
      p = chance(2) ? Point{ x * sign(), y * sign() } : Point{ y * sign(), x * sign() };
      p = { centre.x + times * p.x, centre.y + times * p.y };
    }
    const int e = exponentFor(54);
    scale(q, e, e);
    return q;
  }

  Quadruple symmetric()
  {
    const double a = any(), b = any(), c = any(), d = any();
    switch (below(3))
    {
      case 0:
        return { Point{ a, b }, { c, b }, { c, d }, { a, d } };
      case 1:
        return { Point{ a, b }, { c, d }, { -c, d }, { -a, b } };
      default:
        Quadruple q;
        for (Point& p : q)
        {
          p = chance(2) ? Point{ a * sign(), b * sign() } : Point{ b * sign(), a * sign() };
        }
        return q;
    }
  }

  Quadruple onLattice()
  {
    const int reach = whole(1, 8);
    const double far = chance(4) ? 0.0 : std::ldexp(1.0, whole(0, 52));
    const double high = chance(2) ? far : std::ldexp(1.0, whole(0, 52));
    Quadruple q;
    for (Point& p : q)
    {
      p = { far + whole(0, reach), high + whole(0, reach) };
    }
    const int e = exponentFor(54);
    scale(q, e, e);
    return q;
  }

  Quadruple shared()
  {
    const double pool[3] = { any(), any(), chance(4) ? special() : any() };
    Quadruple q;
    for (Point& p : q)
    {
      p = { pool[below(3)] * sign(), pool[below(3)] * sign() };
    }
    return q;
  }

  Quadruple subnormals()
  {
    const int bits = whole(2, 53);
    Quadruple q;
    for (Point& p : q)
    {
      p = { sign() * std::ldexp(mantissa(bits), -1074),
        sign() * std::ldexp(mantissa(bits), -1074) };
    }
    if (chance(2)) // a parallelogram, or a rectangle
    {
      q[1].y = chance(2) ? q[0].y : q[1].y;
      q[3].x = chance(2) ? q[0].x : q[3].x;
      q[2] = { q[1].x + (q[3].x - q[0].x), q[1].y + (q[3].y - q[0].y) };
    }
    return q;
  }

  /// Small integers, some plus one bit far below: the vectors have 55 to 66 bits, in scales where
  /// the grid stage begins and ends too.
  Quadruple atGridLimit()
  {
    const int reach = whole(1, 4);
    Quadruple q;
    for (Point& p : q)
    {
      p = { double(whole(-reach, reach)), double(whole(-reach, reach)) };
    }
    for (int k = whole(1, 3); k > 0; --k)
    {
      Point& p = q[below(4)];
      const double bit = sign() * std::ldexp(1.0, -whole(52, 64));
      double& coordinate = chance(2) ? p.x : p.y;
      coordinate = chance(2) ? bit : coordinate + bit;
    }
    static const int middles[] = { 0, 0, -900, 1000, -450, -961, 500 };
    const int e = middles[below(7)] + whole(-6, 6);
    scale(q, e, e);
    return q;
  }

  /// With u = 2^-53, c = (-u, -u) and numbers a little above 1: a difference from c is a tie, which
  /// goes to the even neighbour. Odd and even ones are chosen so that both factors of one product
  /// grow and both of the other shrink, while the true determinant is about 0.
  Quadruple roundedAway()
  {
    const auto above1 = [&](double width)
    { return 1.0 + double(random_() >> 11) * 0x1p-53 * width; };
    const auto even = [](double v)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &v, sizeof bits);
      bits &= ~std::uint64_t(1);
      std::memcpy(&v, &bits, sizeof v);
      return v;
    };
    const double width = std::ldexp(1.0, -whole(3, 12));
    const double bx = even(above1(width));
    const double ay = even(std::max(1.0 + 0x1p-51, bx - 0.125 * (above1(width) - 1.0)));
    Quadruple q;
    q[0] = { bx + 0x1p-52, ay };
    q[1] = { bx, ay - 0x1p-52 };
    q[2] = { -0x1p-53, -0x1p-53 };
    q[3] = { above1(1.0), above1(1.0) };
    if (chance(2))
    {
      std::swap(q[0], q[1]);
    }
    const double flipX = sign(), flipY = sign();
    for (Point& p : q)
    {
      p = { p.x * flipX, p.y * flipY };
    }
    const int e = whole(-500, 500);
    scale(q, e, chance(2) ? e : whole(-500, 500));
    return q;
  }

  Quadruple huge()
  {
    constexpr double kLargest = std::numeric_limits<double>::max();
    const std::int64_t spread = std::int64_t(1) << whole(0, 52);
    const bool isSquare = chance(2);
    Quadruple q;
    for (std::size_t i = 0; i < 4; ++i)
    {
      const double sx = isSquare ? (i == 0 || i == 3 ? -1.0 : 1.0) : sign();
      const double sy = isSquare ? (i < 2 ? -1.0 : 1.0) : sign();
      const auto inwards = [&]
      { return isSquare ? 0 : -std::int64_t(below(std::uint64_t(spread))); };
      q[i] = { sx * ulpsFrom(kLargest, inwards()), sy * ulpsFrom(kLargest, inwards()) };
    }
    if (chance(4))
    {
      q[below(4)] = { any(), any() };
    }
    const int e = chance(2) ? 0 : -whole(0, 30);
    scale(q, e, e);
    return q;
  }

  Quadruple degenerate()
  {
    switch (extreme_)
    {
      case Extreme::Exponents:
        return { Point{ any(), any() }, { any(), any() }, { any(), any() }, { any(), any() } };
      case Extreme::Specials:
        return { Point{ special(), special() }, { special(), special() }, { special(), special() },
          { special(), special() } };
      case Extreme::Collinear:
        return onLine();
      case Extreme::Circle:
        return onCircle();
      case Extreme::Symmetric:
        return symmetric();
      case Extreme::Lattice:
        return onLattice();
      case Extreme::Shared:
        return shared();
      case Extreme::Subnormals:
        return subnormals();
      case Extreme::GridLimit:
        return atGridLimit();
      case Extreme::RoundedAway:
        return roundedAway();
      default:
        return huge();
    }
  }

  Extreme extreme_;
  std::mt19937_64 random_;
};

/// Moves `coordinate`, with which `isCertain()` is false, as far as it takes for that to be true,
/// and a unit in the last place farther or nearer at random: points on both sides of the border of
/// a filter. Returns false, and moves nothing, if it is nowhere true or not as required.
template <class IsCertain>
bool moveToBorder(double& coordinate, Extremes& source, IsCertain isCertain)
{
  const double from = coordinate;
  const std::int64_t way = source.below(2) == 0 ? 1 : -1;
  const auto isCertainAt = [&](std::int64_t steps)
  {
    coordinate = ulpsFrom(from, steps);
    return isCertain();
  };
  constexpr std::int64_t kFarthest = std::int64_t(1) << 61;
  std::int64_t uncertain = 0, certain = way;
  while (std::abs(certain) < kFarthest && !isCertainAt(certain))
  {
    uncertain = certain;
    certain *= 2;
  }
  if (isCertainAt(uncertain) || !isCertainAt(certain))
  {
    coordinate = from;
    return false;
  }
  while (std::abs(certain - uncertain) > 1)
  {
    const std::int64_t middle = uncertain + (certain - uncertain) / 2;
    (isCertainAt(middle) ? certain : uncertain) = middle;
  }
  coordinate = ulpsFrom(from, source.below(2) == 0 ? certain : uncertain);
  return true;
}

} // namespace ahd::test

#endif
