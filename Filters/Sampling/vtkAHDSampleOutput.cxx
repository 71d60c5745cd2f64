// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDSampleOutput.h"

#include "Pipeline/vtkAHDArray.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

namespace
{
std::array<int, 6> ExtentOf(const ahd::SampleRaster& raster)
{
  const auto column = static_cast<int>(raster.firstColumn), row = static_cast<int>(raster.firstRow);
  return { { column, column + static_cast<int>(raster.columns) - 1, row,
    row + static_cast<int>(raster.rows) - 1, 0, 0 } };
}

/// The lowest finite height of the places that have one; 0 without any.
double FindLowest(
  const double* heights, const char* mask, std::size_t count, const vtkAHDContext& context)
{
  double lowest = std::numeric_limits<double>::infinity();
  std::mutex mutex;
  context.ForRange(count,
    [&](std::size_t begin, std::size_t end)
    {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = begin; k < end; ++k)
      {
        least = mask[k] != 0 && std::isfinite(heights[k]) ? std::min(least, heights[k]) : least;
      }
      const std::lock_guard<std::mutex> lock(mutex);
      lowest = std::min(lowest, least);
    });
  return std::isfinite(lowest) ? lowest + 0.0 : 0.0; // of zeros of both signs the positive one
}
}

void vtkAHDMakeImage(const ahd::SampleRaster& raster, vtkImageData* image)
{
  image->SetExtent(ExtentOf(raster).data());
  image->SetOrigin(raster.origin.x, raster.origin.y, 0.0);
  image->SetSpacing(raster.spacing.x, raster.spacing.y, 1.0);
}

void vtkAHDMakeSurface(const ahd::SampleRaster& raster, vtkDataArray* heights, const char* mask,
  const vtkAHDContext& context, vtkStructuredGrid* surface)
{
  const std::size_t count = raster.columns * raster.rows;
  const double* const from = vtkArrayDownCast<vtkDoubleArray>(heights)->GetPointer(0);
  const double lowest = FindLowest(from, mask, count, context);
  auto coordinates = vtkAHDNewArray<vtkDoubleArray>(3 * static_cast<vtkIdType>(count));
  coordinates->SetNumberOfComponents(3);
  auto marks = vtkAHDNewArray<vtkUnsignedCharArray>(static_cast<vtkIdType>(count));
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  double* const xyz = coordinates->GetPointer(0);
  unsigned char* const mark = marks->GetPointer(0);
  context.ForRange(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        const ahd::Point p = raster.at(k % raster.columns, k / raster.columns);
        const bool isShown = mask[k] != 0 && std::isfinite(from[k]);
        xyz[3 * k] = p.x;
        xyz[3 * k + 1] = p.y;
        xyz[3 * k + 2] = isShown ? from[k] : lowest;
        mark[k] = isShown ? 0 : vtkDataSetAttributes::HIDDENPOINT;
      }
    });
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  surface->SetExtent(ExtentOf(raster).data());
  surface->SetPoints(points);
  surface->GetPointData()->AddArray(marks);
}
