// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_NearestSeen_h
#define ahd_NearestSeen_h

#include "../Points/BoxLevels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{

/// The largest coordinate.
inline double sizeOf(const Point& p)
{
  return std::max(std::fabs(p.x), std::fabs(p.y));
}

template <typename Rectangle>
double sizeOf(const Rectangle& all)
{
  return std::max(sizeOf(Point{ all.xmin, all.ymin }), sizeOf(Point{ all.xmax, all.ymax }));
}

/// The nearest one so far of things in a plane, seen from a place: what is certainly farther. All
/// is scaled by a power of two, so that squares do not overflow, and what is far smaller does not
/// underflow in them.
template <bool isRounded>
class NearestSeen
{
public:
  /// `largest`: coordinate of all things. If `isRounded`, the coordinates of where one is may be
  /// wrong, each by kError of a size that is given, and on a line by what changes its squared
  /// distance by less.
  NearestSeen(const Point& place, double largest)
    : scale_(scaleOf(std::max(sizeOf(place), largest)))
    , place_(scaled(place))
  {
  }

  static constexpr double kError = 0x1p-50;

  Point scaled(const Point& p) const { return { p.x * scale_, p.y * scale_ }; }
  double squaredDistance(const Point& c) const
  {
    return (c.x - place_.x) * (c.x - place_.x) + (c.y - place_.y) * (c.y - place_.y);
  }

  /// A scaled place so far away, and how far the nearest one is.
  Point beside(double distance) const { return { place_.x + distance, place_.y }; }
  double distance() const { return std::sqrt(distance_); }

  /// Now it is this one, at its scaled place.
  void take(const Point& c, double size = 0.0)
  {
    isAny_ = true;
    size_ = size;
    nearest_ = c;
    distance_ = squaredDistance(c);
  }

  bool isCertainlyNearer(double squared) const
  {
    return !isRounded ? squared + kGuard < distance_ * (1.0 - kSame) : !isAny_;
  }

  /// Is a scaled place certainly farther? Seen from afar, squared distances are all the same up to
  /// rounding; what they differ by is not.
  ///
  /// With p the place, q the nearest and c the other, |c - p|^2 - |q - p|^2 is the sum, over x and
  /// y, of (c - q) ((c - p) + (q - p)). That has six roundings at most, each of no more than u of
  /// the sum of |c - q| (|c - p| + |q - p|). Where both coordinates of c and q may be wrong by e,
  /// squared distances are by less than 3 e (|c - p| + |q - p|) + 4 e^2, lengths summed over x, y.
  bool isFarther(const Point& c, double squared, double sizeOfC = 0.0) const
  {
    if (!isRounded && squared > distance_ * (1.0 + kSame) + kGuard)
    {
      return true;
    }
    constexpr double kRounding = 0x1p-49;
    const Point &p = place_, &q = nearest_;
    const double more = (c.x - q.x) * ((c.x - p.x) + (q.x - p.x)) +
      (c.y - q.y) * ((c.y - p.y) + (q.y - p.y));
    const double x = std::fabs(c.x - p.x) + std::fabs(q.x - p.x);
    const double y = std::fabs(c.y - p.y) + std::fabs(q.y - p.y);
    const double size = std::fabs(c.x - q.x) * x + std::fabs(c.y - q.y) * y;
    const double error = isRounded ? kError * (std::max(size_, sizeOfC) * scale_) : 0.0;
    const double wrong = isRounded ? 4.0 * error * (x + y + error) : 0.0;
    return more > kRounding * size + wrong + kGuard && isAny_;
  }

  bool isFarther(const Box& b) const
  {
    const Point c{ std::max(b.xmin * scale_, std::min(place_.x, b.xmax * scale_)),
      std::max(b.ymin * scale_, std::min(place_.y, b.ymax * scale_)) };
    return isFarther(c, squaredDistance(c));
  }

private:
  /// What two squared distances that are the same may differ by, as a part of either: each has two
  /// rounded differences, squares and a sum. Differences of distances tell more about what differs
  /// by less.
  static constexpr double kSame = 0x1p-48;
  /// ... or by less than this: it is far more than coordinates up to 2^500 that lose 2^-1074 make
  /// of it.
  static constexpr double kGuard = 0x1p-560;

  /// The power of two that makes this about 2^500.
  static double scaleOf(double largest)
  {
    constexpr double kScaled = 0x1p499;
    constexpr int kLeast = -500;
    return std::ldexp(kScaled, -std::max(std::ilogb(largest), kLeast));
  }

  double scale_;
  Point place_;       ///< scaled, as all below
  double size_ = 0.0; ///< not scaled; 0 if it is not rounded
  bool isAny_ = false;
  Point nearest_{ 0.0, 0.0 };
  double distance_ = std::numeric_limits<double>::infinity(); ///< squared
};

} // namespace ahd

#endif
