// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDSampleInformation.h"

#include "Engine/Core/Memory.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortVectorKey.h"
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

bool vtkAHDIsNotAnnounced(vtkDataObject* made, vtkInformation* info)
{
  int extent[6] = { 0, -1, 0, -1, 0, -1 }, announced[6] = { 0, -1, 0, -1, 0, -1 };
  info->Get(Pipeline::WHOLE_EXTENT(), announced);
  bool isSame = true;
  if (auto* image = vtkImageData::SafeDownCast(made))
  {
    double origin[3] = { 0, 0, 0 }, spacing[3] = { 1, 1, 1 };
    info->Get(vtkDataObject::ORIGIN(), origin);
    info->Get(vtkDataObject::SPACING(), spacing);
    image->GetExtent(extent);
    isSame = std::equal(origin, origin + 3, image->GetOrigin()) &&
      std::equal(spacing, spacing + 3, image->GetSpacing());
  }
  else if (auto* grid = vtkStructuredGrid::SafeDownCast(made))
  {
    grid->GetExtent(extent);
  }
  return !isSame || !std::equal(extent, extent + 6, announced);
}

bool vtkAHDFeedsImageFilters(vtkInformation* info)
{
  vtkExecutive** const consumers = vtkExecutive::CONSUMERS()->GetExecutives(info);
  const int count = consumers ? vtkExecutive::CONSUMERS()->Length(info) : 0;
  for (int k = 0; k < count; ++k)
  {
    vtkAlgorithm* const filter = consumers[k]->GetAlgorithm();
    if (filter && filter->IsA("vtkImageAlgorithm"))
    {
      return true;
    }
    for (int port = 0; port < consumers[k]->GetNumberOfOutputPorts(); ++port)
    {
      if (vtkAHDFeedsImageFilters(consumers[k]->GetOutputInformation(port)))
      {
        return true;
      }
    }
  }
  return false;
}

bool vtkAHDIsLarger(const ahd::SampleRaster& cells, vtkTypeInt64 limit)
{
  constexpr double kPerCell = 9.0;
  const double most = limit > 0 ? 1024.0 * double(limit) : double(ahd::availableMemory());
  return kPerCell * double(cells.columns) * double(cells.rows) > most;
}
