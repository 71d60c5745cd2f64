// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDSampleInformation.h"

#include "Engine/Core/Memory.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

#include <algorithm>

using Pipeline = vtkStreamingDemandDrivenPipeline;

void vtkAHDAnnounceRaster(const vtkAHDRaster& raster, vtkInformation* info)
{
  const ahd::SampleRaster& cells = raster.Cells;
  const int extent[6] = { 0, static_cast<int>(cells.columns) - 1, 0,
    static_cast<int>(cells.rows) - 1, 0, raster.Fault == vtkAHDRasterFault::None ? 0 : -1 };
  info->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), cells.origin.x, cells.origin.y, 0.0);
  info->Set(vtkDataObject::SPACING(), cells.spacing.x, cells.spacing.y, 1.0);
}

namespace
{
void GetExtent(vtkDataObject* made, int extent[6])
{
  const int none[6] = { 0, -1, 0, -1, 0, -1 };
  std::copy(none, none + 6, extent);
  if (auto* image = vtkImageData::SafeDownCast(made))
  {
    image->GetExtent(extent);
  }
  else if (auto* grid = vtkStructuredGrid::SafeDownCast(made))
  {
    grid->GetExtent(extent);
  }
}
}

bool vtkAHDIsNotAnnounced(vtkDataObject* made, vtkInformation* info)
{
  int extent[6], announced[6] = { 0, -1, 0, -1, 0, -1 };
  GetExtent(made, extent);
  info->Get(Pipeline::WHOLE_EXTENT(), announced);
  bool isSame = std::equal(extent, extent + 6, announced);
  auto* image = vtkImageData::SafeDownCast(made);
  if (image && isSame && image->GetNumberOfPoints() > 0)
  {
    double origin[3] = { 0, 0, 0 }, spacing[3] = { 1, 1, 1 };
    info->Get(vtkDataObject::ORIGIN(), origin);
    info->Get(vtkDataObject::SPACING(), spacing);
    isSame = std::equal(origin, origin + 3, image->GetOrigin()) &&
      std::equal(spacing, spacing + 3, image->GetSpacing());
  }
  return !isSame;
}

bool vtkAHDHasAllThatIsWanted(vtkDataObject* made, vtkInformation* info)
{
  int extent[6], wanted[6] = { 0, -1, 0, -1, 0, -1 };
  GetExtent(made, extent);
  info->Get(Pipeline::UPDATE_EXTENT(), wanted);
  bool hasAll = true;
  for (int k = 0; k < 6; k += 2)
  {
    if (wanted[k] > wanted[k + 1])
    {
      return true; // nothing
    }
    hasAll = hasAll && extent[k] <= wanted[k] && wanted[k + 1] <= extent[k + 1];
  }
  return hasAll;
}

bool vtkAHDHasFiltersBehind(vtkInformation* info)
{
  return info->GetReferenceCount() > 1;
}

ahd::SampleRaster vtkAHDToldRaster(vtkInformation* info)
{
  int wanted[6] = { 0, -1, 0, -1, 0, -1 };
  double origin[3] = { 0, 0, 0 }, spacing[3] = { 1, 1, 1 };
  info->Get(Pipeline::UPDATE_EXTENT(), wanted);
  info->Get(vtkDataObject::ORIGIN(), origin);
  info->Get(vtkDataObject::SPACING(), spacing);
  ahd::SampleRaster told;
  if (wanted[0] <= wanted[1] && wanted[2] <= wanted[3] && wanted[1] >= 0 && wanted[3] >= 0)
  {
    told.origin = { origin[0], origin[1] };
    told.spacing = { spacing[0], spacing[1] };
    told.columns = static_cast<std::size_t>(wanted[1]) + 1;
    told.rows = static_cast<std::size_t>(wanted[3]) + 1;
  }
  return told;
}

bool vtkAHDCover(const ahd::SampleRaster& told, vtkAHDRaster& raster)
{
  if (raster.Fault == vtkAHDRasterFault::NoArea && told.columns > 0)
  {
    raster.Fault = vtkAHDRasterFault::None;
    raster.Cells = told;
    return true;
  }
  if (raster.Fault != vtkAHDRasterFault::None)
  {
    return false;
  }
  const bool isLarger = told.columns > raster.Cells.columns || told.rows > raster.Cells.rows;
  raster.Cells.columns = std::max(raster.Cells.columns, told.columns);
  raster.Cells.rows = std::max(raster.Cells.rows, told.rows);
  return isLarger;
}

bool vtkAHDIsLarger(const ahd::SampleRaster& cells, vtkTypeInt64 limit)
{
  constexpr double kPerCell = 9.0;
  const double most = limit > 0 ? 1024.0 * double(limit) : double(ahd::availableMemory());
  return kPerCell * double(cells.columns) * double(cells.rows) > most;
}
