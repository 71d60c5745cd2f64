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
