// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDRaster.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double kMostCells = 2147483647.0; // along an axis, as VTK counts them by int
constexpr double kPrecision = 0x1p-50;      // of coordinates that were written in decimal

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
}

vtkAHDRaster vtkAHDMakeRaster(const vtkAHDRasterWish& wish, const ahd::Bounds& area)
{
  vtkAHDRaster raster;
  if (wish.ByCellSize && !(IsSize(wish.CellSize[0]) && IsSize(wish.CellSize[1])))
  {
    raster.Fault = vtkAHDRasterFault::CellSize;
    return raster;
  }
  if (!(area.xmin <= area.xmax && area.ymin <= area.ymax))
  {
    return raster;
  }
  Axis x, y;
  if (wish.ByCellSize)
  {
    x = BySize(area.xmin, area.xmax, wish.CellSize[0], wish.Align);
    y = BySize(area.ymin, area.ymax, wish.CellSize[1], wish.Align);
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
  const vtkAHDRasterWish& wish, const std::array<double, 4>& bounds)
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
  return vtkAHDMakeRaster(wish, area);
}
