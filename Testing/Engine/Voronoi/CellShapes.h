// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CellShapes_h
#define ahd_CellShapes_h

#include "Voronoi/Voronoi.h"

#include <cstddef>
#include <vector>

namespace ahd
{
namespace test
{

/// The corners of cell `k`.
inline std::vector<Point> cellOf(const VoronoiCells& cells, std::size_t k)
{
  std::vector<Point> result;
  for (std::int64_t i = cells.offsets[k]; i < cells.offsets[k + 1]; ++i)
  {
    result.push_back(
      cells.points[static_cast<std::size_t>(cells.corners[static_cast<std::size_t>(i)])]);
  }
  return result;
}

/// Rounded.
inline double areaOf(const std::vector<Point>& corners)
{
  double twice = 0.0;
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    const Point &a = corners[0], &b = corners[i - 1], &c = corners[i];
    twice += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  return twice / 2;
}

} // namespace test
} // namespace ahd

#endif
