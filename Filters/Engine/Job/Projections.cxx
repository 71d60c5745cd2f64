// SPDX-License-Identifier: BSD-3-Clause
#include "Projections.h"

#include "../Core/Loops.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace ahd
{
namespace
{

using Xyz = std::array<double, 3>;

bool isFinite(const Xyz& p)
{
  return p[0] * 0 + p[1] * 0 + p[2] * 0 == 0;
}

/// A point with a coordinate that is not finite has no place, even if the projection is finite.
void write(bool hasPlace, const Xyz& place, double* to)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    to[k] = hasPlace ? place[k] : std::numeric_limits<double>::quiet_NaN();
  }
}

} // namespace

bool MatrixProjection::project(const PointView& points, double* to, const Context& context) const
{
  const double* m = matrix_.data();
  const bool isAffine = m[12] == 0 && m[13] == 0 && m[14] == 0 && m[15] == 1;
  const auto row = [m](std::size_t k, const Xyz& p)
  { return m[4 * k] * p[0] + m[4 * k + 1] * p[1] + m[4 * k + 2] * p[2] + m[4 * k + 3]; };
  Ticker ticker(context.progress, Phase::Merge, 0, context.executor);
  return inChunksOf(points.count, ticker,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Xyz p = points.place(i);
        const double scale = isAffine ? 1.0 : 1.0 / row(3, p);
        write(
          isFinite(p), { { scale * row(0, p), scale * row(1, p), scale * row(2, p) } }, to + 3 * i);
      }
    });
}

/// Returns false if it is cancelled.
bool CallbackProjection::call(double* xyz, std::size_t count) const
{
  try
  {
    return callback_(user_, xyz, count) == 0;
  }
  catch (...) // it should not throw, but it may
  {
    return false;
  }
}

bool CallbackProjection::project(const PointView& points, double* to, const Context& context) const
{
  constexpr std::size_t kPiece = std::size_t(1) << 14;
  std::vector<double> moved(3 * std::min(points.count, kPiece));
  Ticker ticker(context.progress, Phase::Merge, 0);
  for (std::size_t begin = 0; begin < points.count; begin += kPiece)
  {
    const std::size_t count = std::min(points.count - begin, kPiece);
    for (std::size_t i = 0; i < count; ++i)
    {
      const Xyz p = points.place(begin + i);
      std::copy(p.begin(), p.end(), moved.data() + 3 * i);
    }
    if (!call(moved.data(), count))
    {
      return false;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      const double* p = moved.data() + 3 * i;
      write(isFinite(points.place(begin + i)), { { p[0], p[1], p[2] } }, to + 3 * (begin + i));
    }
    if (!ticker.ask())
    {
      return false;
    }
  }
  return true;
}

} // namespace ahd
