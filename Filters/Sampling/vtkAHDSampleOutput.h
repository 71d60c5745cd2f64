// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSampleOutput_h
#define vtkAHDSampleOutput_h

#include "Engine/Sample/Sample.h"
#include "Pipeline/vtkAHDContext.h"

class vtkDataArray;
class vtkImageData;
class vtkStructuredGrid;

/// Makes the image of a raster, without arrays: its points are the centres of the cells.
void vtkAHDMakeImage(const ahd::SampleRaster& raster, vtkImageData* image);

/// Makes the surface of a raster: its points are the centres of the cells at these heights. Points
/// without a height are hidden, and lie at the lowest of all, so that the bounds are those of the
/// visible part. Throws vtkAHDStop and std::bad_alloc.
void vtkAHDMakeSurface(const ahd::SampleRaster& raster, vtkDataArray* heights, const char* mask,
  const vtkAHDContext& context, vtkStructuredGrid* surface);

#endif
