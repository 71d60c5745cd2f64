// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_OutlineCase_h
#define ahd_OutlineCase_h

// Inputs of outline(), and outlines as places.
#include "Outline/Outline.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace ahd
{
namespace test
{

struct OutlineCase
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::int64_t> ids;
  std::vector<std::int64_t> offsets = { 0 };
  std::vector<double> groups;

  std::size_t cellCount() const { return offsets.size() - 1; }
  double group(std::size_t cell) const { return groups.empty() ? 0.0 : groups[cell]; }
  std::vector<std::int64_t> cell(std::size_t k) const
  {
    return { ids.begin() + offsets[k], ids.begin() + offsets[k + 1] };
  }
  void addCell(const std::vector<std::int64_t>& corners)
  {
    ids.insert(ids.end(), corners.begin(), corners.end());
    offsets.push_back(std::int64_t(ids.size()));
  }
  std::int64_t pointAt(double x, double y)
  {
    const std::array<double, 3> p = { x, y, 0.0 };
    const auto found = std::find(points.begin(), points.end(), p);
    const auto id = std::int64_t(found - points.begin());
    found == points.end() ? points.push_back(p) : void();
    return id;
  }
  /// Two triangles.
  void addSquare(double x, double y)
  {
    const std::int64_t a = pointAt(x, y), b = pointAt(x + 1, y), c = pointAt(x + 1, y + 1),
                       d = pointAt(x, y + 1);
    addCell({ a, b, c });
    addCell({ a, c, d });
  }

  OutlineRequest request() const
  {
    OutlineRequest request;
    request.points = PointView(points.empty() ? nullptr : points[0].data(), points.size(), 3);
    request.cells.offsets64 = offsets.data();
    request.cells.ids64 = ids.data();
    request.cells.cells = cellCount();
    request.cells.ids = ids.size();
    request.groups = groups.empty() ? nullptr : groups.data();
    return request;
  }
  Outline outline(bool isDirected = false) const
  {
    Outline made;
    OutlineRequest request = this->request();
    request.isDirected = isDirected;
    EXPECT_EQ(ahd::outline(request, Context(), made), Status::Ok);
    return made;
  }

  /// Keeps about one cell in `of`, or all but these.
  void dropSome(std::size_t of, Random& random)
  {
    const OutlineCase all = *this;
    const bool keepsMost = random.below(2) == 0;
    ids.clear();
    offsets = { 0 };
    for (std::size_t k = 0; k < all.cellCount(); ++k)
    {
      if ((random.below(of + 1) == 0) != keepsMost)
      {
        addCell(all.cell(k));
      }
    }
  }
  void groupThem(std::size_t kinds, Random& random)
  {
    groups.clear();
    for (std::size_t k = 0; kinds > 0 && k < cellCount(); ++k)
    {
      groups.push_back(0.5 * double(random.below(kinds + 1)));
    }
  }
  /// The same surface in another order, turned and with corners of its own for each cell.
  void shuffle(Random& random)
  {
    const OutlineCase all = *this;
    std::vector<std::size_t> order(all.cellCount());
    std::iota(order.begin(), order.end(), std::size_t(0));
    for (std::size_t k = order.size(); k > 1; --k)
    {
      std::swap(order[k - 1], order[random.below(k)]);
    }
    *this = OutlineCase();
    for (const std::size_t k : order)
    {
      std::vector<std::int64_t> corners = all.cell(k);
      const auto first = corners.begin() + std::ptrdiff_t(random.below(corners.size()));
      std::rotate(corners.begin(), first, corners.end());
      if (random.below(2) == 0)
      {
        std::reverse(corners.begin(), corners.end());
      }
      for (std::int64_t& corner : corners)
      {
        points.push_back(all.points[std::size_t(corner)]);
        corner = std::int64_t(points.size()) - 1;
      }
      addCell(corners);
      groups.push_back(all.group(k));
    }
  }
};

/// Triangles and quadrilaterals on whole coordinates.
inline OutlineCase gridOf(std::size_t columns, std::size_t rows, Random& random)
{
  OutlineCase grid;
  for (std::size_t i = 0; i < (columns + 1) * (rows + 1); ++i)
  {
    grid.points.push_back({ double(i % (columns + 1)), double(i / (columns + 1)), 0.0 });
  }
  const auto wide = std::int64_t(columns) + 1;
  for (std::int64_t a = 0; a < wide * std::int64_t(rows); ++a)
  {
    if ((a + 1) % wide == 0)
    {
      continue;
    }
    const std::int64_t b = a + 1, c = b + wide, d = a + wide;
    switch (random.below(4))
    {
      case 0:
        grid.addCell({ a, b, c, d });
        break;
      case 1:
        grid.addCell({ a, b, d });
        grid.addCell({ b, c, d });
        break;
      default:
        grid.addCell({ a, b, c });
        grid.addCell({ a, c, d });
    }
  }
  return grid;
}

/// Of each polygon its rings, as places.
using Polygons = std::vector<std::vector<std::vector<std::array<double, 3>>>>;

inline Polygons polygonsOf(const OutlineCase& given, const Outline& made)
{
  Polygons polygons;
  for (std::size_t k = 0; k + 1 < made.polygons.size(); ++k)
  {
    polygons.emplace_back();
    for (Index r = made.polygons[k]; r < made.polygons[k + 1]; ++r)
    {
      polygons.back().emplace_back();
      for (Index i = made.rings[r]; i < made.rings[r + 1]; ++i)
      {
        polygons.back().back().push_back(given.points[made.corners[i]]);
      }
    }
  }
  return polygons;
}

/// Twice the area in x, y; exact for small whole coordinates.
inline double areaOf(const std::vector<std::array<double, 3>>& ring)
{
  double area = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k)
  {
    const auto &p = ring[k], &q = ring[(k + 1) % ring.size()];
    area += p[0] * q[1] - p[1] * q[0];
  }
  return area;
}

} // namespace test
} // namespace ahd

#endif
