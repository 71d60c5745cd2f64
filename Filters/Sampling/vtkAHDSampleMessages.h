// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSampleMessages_h
#define vtkAHDSampleMessages_h

#include "Engine/Points/Points.h"
#include "Engine/Sample/Sample.h"
#include "Sampling/vtkAHDRaster.h"
#include "Sampling/vtkAHDSampleColumns.h"
#include "Sampling/vtkAHDSampleSettings.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkAlgorithm;

/// The memory that an execution would take, in KiB, and its limit.
struct vtkAHDSampleMemory
{
  vtkTypeInt64 Estimate = 0;
  vtkTypeInt64 Limit = 0;
  bool IsLimited = false; ///< Limit is MemoryLimit, not available memory
  std::size_t Points = 0;
  double Places = 0.0; ///< below 0: not known yet, for a raster with a cell size
};

/// The error why there is no raster; none if no point determines its bounds.
void vtkAHDSayNoRaster(
  vtkAlgorithm* filter, const vtkAHDSampleSettings& settings, const vtkAHDRaster& raster);

/// Checks that the names of output arrays are different and not reserved by VTK. One error if
/// not.
bool vtkAHDAreNamesFit(vtkAlgorithm* filter, const vtkAHDSampleSettings& settings);

/// The error that memory was refused, or ran out.
void vtkAHDSayMemory(vtkAlgorithm* filter, const vtkAHDSampleMemory& memory, bool isRefused);

/// The error that so many triangles of a surface are invalid in the plane.
void vtkAHDSayFolded(vtkAlgorithm* filter, std::size_t triangles, std::size_t missing);

/// The result of an interpolation.
struct vtkAHDSampleResult
{
  ahd::SampleReport Counts;
  std::size_t Triangles = 0; ///< 0: not known
  ahd::Bounds Surface;       ///< of the vertices
  ahd::Bounds Wanted;        ///< of the places, if none has a value

  /// Of arrays with missing values or neighbours left out, the heights first.
  std::vector<vtkAHDMissingValues> Missing;

  /// Adds the result of other places on the same surface.
  void Add(const vtkAHDSampleResult& more);
  void AddMissing(const std::vector<vtkAHDMissingValues>& more);
};

/// Warns of arrays that are not interpolated, and of missing gradients.
void vtkAHDSayArrayWarnings(
  vtkAlgorithm* filter, const vtkAHDSampleSettings& settings, const vtkAHDSampleColumns& columns);

/// The warnings about places and values, each at most once.
void vtkAHDSayPlaceWarnings(vtkAlgorithm* filter, const vtkAHDSampleResult& result);

#endif
