// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Points_h
#define ahd_Points_h

#include "../Core/Prefetch.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ahd
{

/// Number of a point, vertex or triangle inside the engine.
using Index = std::uint32_t;
constexpr Index kNoIndex = 0xFFFFFFFFu;

/// Most points in one run: a half-edge is numbered by 8 * triangle + edge in 32 bits,
/// and n points have 2n - 2 triangles, those at infinity included. Tests of the limit are
/// compiled with fewer.
#ifndef AHD_MAXIMUM_POINTS
#define AHD_MAXIMUM_POINTS ((std::size_t(1) << 28) - 2)
#endif
constexpr std::size_t kMaximumPoints = AHD_MAXIMUM_POINTS;

/// A location in the plane.
struct Point
{
  double x;
  double y;
};

inline bool operator==(const Point& a, const Point& b)
{
  return a.x == b.x && a.y == b.y;
}

/// Order by x, then y: the order in which ties between cocircular points are broken.
/// -0.0 and +0.0 are the same coordinate.
inline bool lexicographicallyLess(const Point& a, const Point& b)
{
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

inline bool isFinite(const Point& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y);
}

/// The caller's points, read in place: x, y of point i are the first two numbers at data + i *
/// stride, z is the third unless the points are flat. Widening float to double is exact.
struct PointView
{
  PointView() = default;
  PointView(const double* data, std::size_t pointCount, std::size_t numbersPerPoint)
    : doubles(data)
    , count(pointCount)
    , stride(numbersPerPoint)
    , isFlat(numbersPerPoint < 3)
  {
  }
  PointView(const float* data, std::size_t pointCount, std::size_t numbersPerPoint)
    : floats(data)
    , count(pointCount)
    , stride(numbersPerPoint)
    , isFlat(numbersPerPoint < 3)
  {
  }

  Point operator[](std::size_t i) const
  {
    return doubles ? Point{ doubles[i * stride], doubles[i * stride + 1] }
                   : Point{ floats[i * stride], floats[i * stride + 1] };
  }

  /// x, y and z of point i.
  std::array<double, 3> place(std::size_t i) const
  {
    const Point p = (*this)[i];
    return { { p.x, p.y, z(i) } };
  }
  double z(std::size_t i) const
  {
    const std::size_t at = i * stride + 2;
    return isFlat ? 0.0 : doubles ? doubles[at] : double(floats[at]);
  }

  /// Fetches point i, which will be read soon and need not exist.
  void prefetch(std::size_t i) const
  {
    const std::size_t first = i * stride, last = first + stride - 1; // mostly in the same line
    doubles ? prefetchForRead(doubles + first) : prefetchForRead(floats + first);
    doubles ? prefetchForRead(doubles + last) : prefetchForRead(floats + last);
  }

  /// Is point i left out at the caller's request?
  bool skipped(std::size_t i) const { return skip && (skip[i] & skipMask) != 0; }

  const double* doubles = nullptr;
  const float* floats = nullptr;
  std::size_t count = 0;
  std::size_t stride = 2;
  bool isFlat = true; ///< z is 0, whatever lies behind x and y

  /// One byte per point or null; a point with a bit of skipMask set is left out.
  const unsigned char* skip = nullptr;
  unsigned char skipMask = 0xFF;
};

/// Smallest axis-parallel box around points; empty (min > max) around none.
struct Bounds
{
  double xmin = 1.0, xmax = -1.0;
  double ymin = 1.0, ymax = -1.0;
};

} // namespace ahd

#endif
