// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDRaster.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace
{
constexpr double kMostCells = 2147483647.0; // along an axis, as VTK counts them by int
constexpr double kPrecision = 0x1p-50;      // of coordinates that were written in decimal
// Of a raster whose cells are chosen.
constexpr double kLeastCells = 65536.0;
constexpr double kMostAlong = 4096.0;

/// (high - low) / size, where only the quotient may be a number, too.
double LengthIn(double low, double high, double size)
{
  const double length = high - low;
  return std::isfinite(length) ? length / size : high / size - low / size;
}

/// A raster along one axis.
struct Axis
{
  double Origin = 0.0; // the first centre
  double Spacing = 0.0;
  double Count = 0.0;
};

/// The whole number that `quotient`, of a coordinate and the size, stands for, if `slack` is how
/// far that may be off; else the next one below, or above.
double WholeBelow(double quotient, double slack)
{
  const double nearest = std::round(quotient);
  return std::abs(quotient - nearest) <= slack ? nearest : std::floor(quotient);
}
double WholeAbove(double quotient, double slack)
{
  return -WholeBelow(-quotient, slack);
}

Axis BySize(double low, double high, double size, bool align)
{
  const double slack = kPrecision * std::max(std::abs(low), std::abs(high)) / size;
  Axis axis;
  axis.Spacing = size;
  if (align)
  {
    const double first = WholeBelow(low / size, slack);
    axis.Count = std::max(1.0, WholeAbove(high / size, slack) - first);
    axis.Origin = (first + 0.5) * size;
    return axis;
  }
  axis.Count = std::max(1.0, WholeAbove(LengthIn(low, high, size), slack));
  axis.Origin = low < high ? low + 0.5 * size : low; // one row through a side without length
  return axis;
}

/// `spacing` is 0 where the side is of length 0.
Axis ByCount(double low, double high, int count)
{
  Axis axis;
  axis.Spacing = LengthIn(low, high, count);
  axis.Count = count;
  axis.Origin = low + 0.5 * axis.Spacing;
  return axis;
}

/// One row of cells, of this width, through a coordinate.
void MakeOneRow(Axis& axis, double at, double width)
{
  axis.Origin = at;
  axis.Spacing = width > 0.0 ? width : 1.0;
  axis.Count = 1.0;
}

/// Where VTK has the last centre.
double LastOf(const Axis& axis)
{
  return axis.Origin + (axis.Count - 1.0) * axis.Spacing;
}

/// Do its terms, or the last centre, exceed the largest number?
bool IsTooWide(const Axis& axis)
{
  return !(std::isfinite(axis.Spacing) && std::isfinite(LastOf(axis)));
}

/// Are the centres of neighbours different numbers?
bool AreApart(const Axis& axis)
{
  const double last = LastOf(axis);
  return axis.Spacing > 0.0 &&
    (axis.Count == 1.0 || (axis.Origin + axis.Spacing > axis.Origin && last - axis.Spacing < last));
}

bool IsSize(double size)
{
  return size > 0.0 && std::isfinite(size);
}

/// Of 1, 2 and 5 times a power of ten the next one by ratio. Read as text, they are the same
/// numbers on all machines.
double Rounded(double size)
{
  int exponent = 0; // of 2: the power of ten is `least` or the next one
  std::frexp(size, &exponent);
  const int least = static_cast<int>(std::floor((exponent - 1) * 0.30103));
  double nearest = 0.0;
  for (int k = least - 1; k <= least + 2; ++k)
  {
    for (const char* digit : { "1e", "2e", "5e" })
    {
      const double step = std::strtod((digit + std::to_string(k)).c_str(), nullptr);
      nearest = nearest == 0.0 || step / size < size / nearest ? step : nearest;
    }
  }
  return nearest;
}

/// The size of square cells for so many points in an area.
double ChosenSize(const ahd::Bounds& area, std::size_t points)
{
  // Half of each, as the whole may be no number.
  const double width = area.xmax / 2.0 - area.xmin / 2.0;
  const double height = area.ymax / 2.0 - area.ymin / 2.0;
  const double cells = std::max(double(points), kLeastCells);
  const double longer = std::max(width, height);
  const double size = 2.0 *
    std::max(std::sqrt(width) * std::sqrt(height) / std::sqrt(cells), longer / kMostAlong);
  return size > 0.0 ? Rounded(size) : longer > 0.0 ? longer : 1.0;
}
}

vtkAHDRaster vtkAHDMakeRaster(
  const vtkAHDRasterWish& wish, const ahd::Bounds& area, std::size_t points)
{
  vtkAHDRaster raster;
  const bool isChosen = wish.IsChosen();
  if (wish.ByCellSize && !isChosen && !(IsSize(wish.CellSize[0]) && IsSize(wish.CellSize[1])))
  {
    raster.Fault = vtkAHDRasterFault::CellSize;
    return raster;
  }
  if (!(area.xmin <= area.xmax && area.ymin <= area.ymax))
  {
    return {}; // no area
  }
  Axis x, y;
  if (wish.ByCellSize || isChosen)
  {
    const double size = isChosen ? ChosenSize(area, points) : 0.0;
    const bool aligns = wish.ByCellSize && wish.Align;
    x = BySize(area.xmin, area.xmax, isChosen ? size : wish.CellSize[0], aligns);
    y = BySize(area.ymin, area.ymax, isChosen ? size : wish.CellSize[1], aligns);
  }
  else
  {
    x = ByCount(area.xmin, area.xmax, wish.Dimensions[0]);
    y = ByCount(area.ymin, area.ymax, wish.Dimensions[1]);
    const double width = x.Spacing, height = y.Spacing;
    if (width <= 0.0)
    {
      MakeOneRow(x, area.xmin, height);
    }
    if (height <= 0.0)
    {
      MakeOneRow(y, area.ymin, width);
    }
  }
  raster.Wished = { { x.Count, y.Count } };
  if (!(x.Count <= kMostCells && y.Count <= kMostCells))
  {
    raster.Fault = vtkAHDRasterFault::TooMany;
    return raster;
  }
  if (IsTooWide(x) || IsTooWide(y))
  {
    raster.Fault = vtkAHDRasterFault::TooWide;
    return raster;
  }
  if (!AreApart(x) || !AreApart(y))
  {
    raster.Fault = vtkAHDRasterFault::OutOfNumbers;
    return raster;
  }
  raster.Fault = vtkAHDRasterFault::None;
  raster.Cells.origin = { x.Origin, y.Origin };
  raster.Cells.spacing = { x.Spacing, y.Spacing };
  raster.Cells.columns = static_cast<std::size_t>(x.Count);
  raster.Cells.rows = static_cast<std::size_t>(y.Count);
  return raster;
}

vtkAHDRaster vtkAHDMakeRasterWithin(
  const vtkAHDRasterWish& wish, const std::array<double, 4>& bounds, std::size_t points)
{
  const bool areFinite = std::all_of(
    bounds.begin(), bounds.end(), [](double bound) { return std::isfinite(bound); });
  if (!areFinite || !(bounds[0] < bounds[1]) || !(bounds[2] < bounds[3]))
  {
    vtkAHDRaster none;
    none.Fault = vtkAHDRasterFault::Bounds;
    return none;
  }
  ahd::Bounds area;
  area.xmin = bounds[0];
  area.xmax = bounds[1];
  area.ymin = bounds[2];
  area.ymax = bounds[3];
  return vtkAHDMakeRaster(wish, area, points);
}
