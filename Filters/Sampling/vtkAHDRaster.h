// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRaster_h
#define vtkAHDRaster_h

#include "Engine/Points/Points.h"
#include "Engine/Sample/Sample.h"

#include <array>
#include <cstddef>

/// The requested raster. Sizes, or dimensions, of 0: square cells, chosen from the points.
struct vtkAHDRasterWish
{
  /// Is the size of the cells chosen from the points?
  bool IsChosen() const
  {
    return this->ByCellSize ? this->CellSize[0] == 0.0 && this->CellSize[1] == 0.0
                            : this->Dimensions[0] <= 0 || this->Dimensions[1] <= 0;
  }

  bool ByCellSize = false;
  std::array<int, 2> Dimensions = { { 256, 256 } };
  std::array<double, 2> CellSize = { { 1.0, 1.0 } };
  bool Align = false; ///< borders are multiples of CellSize
};

/// The reason why there is no raster.
enum class vtkAHDRasterFault
{
  None,
  NoArea,      ///< no point determines its bounds
  CellSize,    ///< not positive and finite
  Bounds,      ///< not finite, or the lower is not below the upper
  TooMany,     ///< more than 2^31 - 1 cells along x or y
  TooWide,     ///< wider or higher than the largest double
  OutOfNumbers ///< double precision cannot tell the cells apart
};

/// A raster: its places are the centres of its cells.
struct vtkAHDRaster
{
  vtkAHDRasterFault Fault = vtkAHDRasterFault::NoArea;
  ahd::SampleRaster Cells;                     ///< no columns and rows unless there is no fault
  std::array<double, 2> Wished = { { 0, 0 } }; ///< columns and rows, also if these are too many
};

/// The raster of this area, empty if there is none. `points`: how many the input has.
///
/// If the size of the cells is chosen, they are squares, as many as there are points, but at least
/// 65536, and at most 4096 along a side. Then the size is rounded to the next 1, 2 or 5 times a
/// power of ten, by ratio, which makes up to 1.6 times more or fewer along a side.
///
/// By dimensions, the cells fill the area; a side of length 0 makes one row through it, as wide as
/// the other side's cells, or 1.
///
/// By cell size, the first cell begins at the lower bound, or with Align at the multiple of the
/// size that is not above it; there are as many as cover the area, at least one. Without Align a
/// side of length 0 makes one row through it, here too: places beside it are on no surface. A bound
/// that differs from a border between cells by no more than 2^-50 of the largest coordinate, the
/// possible error of a decimal number, counts as this border: else 0 to 1.1 would take 12
/// cells of 0.1, as the double 1.1 is above 11 times the double 0.1.
vtkAHDRaster vtkAHDMakeRaster(
  const vtkAHDRasterWish& wish, const ahd::Bounds& area, std::size_t points);

/// The same for a requested area: Fault is Bounds if it is invalid.
vtkAHDRaster vtkAHDMakeRasterWithin(
  const vtkAHDRasterWish& wish, const std::array<double, 4>& bounds, std::size_t points);

#endif
