// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_test_PredicatesCases_h
#define ahd_test_PredicatesCases_h

#include "Points/Points.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

/// Quadruples of points that are hard on predicates, in families.
namespace ahd::test
{

using Quadruple = std::array<Point, 4>;

enum class Family
{
  AnyExponents,    ///< every coordinate of an exponent of its own, over all of double
  AnyBits,         ///< random bits
  Extremes,        ///< 0, -0, the smallest, the largest, 1 and their neighbours
  TinyAndHuge,     ///< about 1e-300, 1 or 1e300
  Subnormals,      ///< a few units in the last place of the smallest numbers
  WideExponents,   ///< exponents over 80 binary places
  Uniform,         ///< in the unit square
  UlpsApart,       ///< a few units in the last place around one place
  Lattice,         ///< integers from 0 to 6
  ScaledLattice,   ///< the same times any power of two, rounded where that is subnormal
  ShiftedLattice,  ///< the same added to 2^52
  DecimalLattice,  ///< steps of 0.1
  MapLattice,      ///< map coordinates, pitch 0.25, rounded to 0.01
  SinglePrecision, ///< float on a circle
  NearlyCollinear, ///< rounded from a line, then moved by a few units in the last place
  NearlyCircular,  ///< the same from a circle
  FarCircular      ///< the same from a short arc of a large circle far away
};

inline const char* nameOf(Family family)
{
  static const char* const names[] = { "AnyExponents", "AnyBits", "Extremes", "TinyAndHuge",
    "Subnormals", "WideExponents", "Uniform", "UlpsApart", "Lattice", "ScaledLattice",
    "ShiftedLattice", "DecimalLattice", "MapLattice", "SinglePrecision", "NearlyCollinear",
    "NearlyCircular", "FarCircular" };
  return names[static_cast<int>(family)];
}

/// Draws from a family: the same sequence on every platform with IEEE arithmetic, up to the last
/// bits of sin and cos.
class Cases
{
public:
  explicit Cases(Family family)
    : family_(family)
    , random_(20260 + static_cast<std::uint64_t>(family))
  {
  }

  Quadruple draw()
  {
    Quadruple points;
    startGroup();
    for (Point& p : points)
    {
      p = place();
    }
    return points;
  }

  std::uint64_t below(std::uint64_t n) { return random_() % n; }

private:
  /// In [0, 1).
  double unit() { return double(random_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  int whole(int low, int high)
  {
    return low + static_cast<int>(below(static_cast<std::uint64_t>(high - low + 1)));
  }
  double step(int count) { return double(below(static_cast<std::uint64_t>(count))); }

  /// Parameters shared by the four points of a case.
  void startGroup()
  {
    exponent_ = whole(-1074, 1020);
    center_ = { between(-1.0, 1.0), between(-1.0, 1.0) };
    direction_ = { between(-1.0, 1.0), between(-1.0, 1.0) };
    radius_ = std::ldexp(
      1.0 + unit(), family_ == Family::FarCircular ? whole(0, 20) : -whole(0, 9));
    corner_ = { step(1000), step(1000) };
  }

  double anyExponent(int low, int high) { return std::ldexp(between(-1.0, 1.0), whole(low, high)); }

  double anyBits()
  {
    for (;;)
    {
      const double value = std::ldexp(double(random_() >> 11), whole(-1127, 971));
      if (std::isfinite(value))
      {
        return below(2) == 0 ? value : -value;
      }
    }
  }

  double extreme()
  {
    using Limits = std::numeric_limits<double>;
    const double magnitudes[] = { 0.0, Limits::denorm_min(), 2 * Limits::denorm_min(),
      Limits::min(), std::nextafter(Limits::min(), 0.0), Limits::max() / 2, Limits::max(),
      std::nextafter(Limits::max(), 0.0), 1.0, std::nextafter(1.0, 2.0) };
    const double value = magnitudes[below(10)];
    return below(2) == 0 ? value : -value;
  }

  double tinyOrHuge()
  {
    const double scales[] = { 1e-300, 1.0, 1e300 };
    return scales[below(3)] * double(whole(-3, 3));
  }

  double moved(double value)
  {
    const double goal = below(2) == 0 ? -1e308 : 1e308;
    for (std::uint64_t steps = below(4); steps > 0; --steps)
    {
      value = std::nextafter(value, goal);
    }
    return value;
  }

  Point onLine()
  {
    const double t = between(-1.0, 1.0);
    return { moved(center_.x + t * direction_.x), moved(center_.y + t * direction_.y) };
  }

  Point onCircle(double angle)
  {
    return { moved(center_.x + radius_ * std::cos(angle)),
      moved(center_.y + radius_ * std::sin(angle)) };
  }

  Point onLattice(double pitch)
  {
    return { (corner_.x + step(4)) * pitch, (corner_.y + step(4)) * pitch };
  }

  Point onMap()
  {
    const Point p = onLattice(0.25);
    return { std::round((500000.0 + p.x + 0.003 * step(3)) * 100.0) / 100.0,
      std::round((4500000.0 + p.y) * 100.0) / 100.0 };
  }

  Point place()
  {
    switch (family_)
    {
      case Family::AnyExponents:
        return { anyExponent(-1073, 1023), anyExponent(-1073, 1023) };
      case Family::AnyBits:
        return { anyBits(), anyBits() };
      case Family::Extremes:
        return { extreme(), extreme() };
      case Family::TinyAndHuge:
        return { tinyOrHuge(), tinyOrHuge() };
      case Family::Subnormals:
        return { std::ldexp(double(whole(-9, 9)), -1074), std::ldexp(double(whole(-9, 9)), -1074) };
      case Family::WideExponents:
        return { anyExponent(-80, 0), anyExponent(-80, 0) };
      case Family::Uniform:
        return { unit(), unit() };
      case Family::UlpsApart:
        return { 0.5 + step(8) * 0x1p-53, 0.5 + step(8) * 0x1p-53 };
      case Family::Lattice:
        return { step(7), step(7) };
      case Family::ScaledLattice:
        return { std::ldexp(step(7), exponent_), std::ldexp(step(7), exponent_) };
      case Family::ShiftedLattice:
        return { 0x1p52 + step(7), 0x1p52 + step(7) };
      default:
        return placeNearDegeneracy();
    }
  }

  Point placeNearDegeneracy()
  {
    switch (family_)
    {
      case Family::DecimalLattice:
        return onLattice(0.1);
      case Family::MapLattice:
        return onMap();
      case Family::SinglePrecision:
      {
        const Point p = onCircle(between(0.0, 6.25));
        return { float(p.x), float(p.y) };
      }
      case Family::NearlyCollinear:
        return onLine();
      case Family::NearlyCircular:
        return onCircle(between(0.0, 6.25));
      default:
        return onCircle(between(0.0, 1e-3));
    }
  }

  Family family_;
  std::mt19937_64 random_;
  int exponent_ = 0;
  Point center_ = { 0, 0 };
  Point direction_ = { 0, 0 };
  Point corner_ = { 0, 0 };
  double radius_ = 1.0;
};

} // namespace ahd::test

#endif
