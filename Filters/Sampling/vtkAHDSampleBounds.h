// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSampleBounds_h
#define vtkAHDSampleBounds_h

#include "Engine/Points/Points.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Sampling/vtkAHDRaster.h"
#include "Sampling/vtkAHDSampleSettings.h"

#include <cstddef>

class vtkPointSet;
class vtkPolyData;

/// The bounding box, in the plane of the triangulation, of all points that go into it: finite, not
/// skipped, those of the source and of the bounding triangulation included if they are added.
/// Merged points and those beyond InsertionLimit count too. Empty without any. `source` may be
/// null. Throws vtkAHDStop and std::bad_alloc.
ahd::Bounds vtkAHDFindBounds(const vtkAHDSettings& settings, vtkPointSet* input,
  vtkPolyData* source, const vtkAHDContext& context);

/// Upper estimate of the bytes to find these; 0 if the raster's area is set.
std::size_t vtkAHDEstimateBounds(const vtkAHDSettings& settings, const vtkAHDSampleSettings& wishes,
  vtkPointSet* input, vtkPolyData* source);

/// The requested raster. Throws vtkAHDStop and std::bad_alloc.
vtkAHDRaster vtkAHDFindRaster(const vtkAHDSettings& settings, const vtkAHDSampleSettings& wishes,
  vtkPointSet* input, vtkPolyData* source, const vtkAHDContext& context);

/// The box of the points that are finite and not skipped. Throws vtkAHDStop.
ahd::Bounds vtkAHDBoundsOf(const ahd::PointView& points, const vtkAHDContext& context);

#endif
