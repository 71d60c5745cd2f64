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

/// Memory that an execution would take, in KiB, and what it may.
struct vtkAHDSampleMemory
{
  vtkTypeInt64 Estimate = 0;
  vtkTypeInt64 Limit = 0;
  bool IsLimited = false; ///< Limit is MemoryLimit, and not what there is
  std::size_t Points = 0;
  double Places = 0.0; ///< below 0: not known yet, for it is a raster of cells by their size
};

/// Says in one error why there is no raster; nothing where no point says where it is to be.
void vtkAHDSayNoRaster(
  vtkAlgorithm* filter, const vtkAHDSampleSettings& settings, const vtkAHDRaster& raster);

/// Are the names of arrays that are made different, and none that VTK has a use for? Says in one
/// error if not.
bool vtkAHDAreNamesFit(vtkAlgorithm* filter, const vtkAHDSampleSettings& settings);

/// Says that memory was refused, or ran out although it was not.
void vtkAHDSayMemory(vtkAlgorithm* filter, const vtkAHDSampleMemory& memory, bool isRefused);

/// Says that so many triangles of a surface are none in the plane.
void vtkAHDSayFolded(vtkAlgorithm* filter, std::size_t triangles, std::size_t missing);

/// What an interpolation came to.
struct vtkAHDSampleResult
{
  ahd::SampleReport Counts;
  std::size_t Places = 0;
  std::size_t Triangles = 0; ///< 0: not known
  ahd::Bounds Surface;       ///< of the vertices
  ahd::Bounds Wanted;        ///< of the places, where none has a value

  /// Of all arrays, the heights first, where values are none or neighbours were left out.
  std::vector<vtkAHDMissingValues> Missing;

  /// Adds what other places on the same surface came to.
  void Add(const vtkAHDSampleResult& more);
  void AddMissing(const std::vector<vtkAHDMissingValues>& more);
};

/// Warns of arrays that are passed over, and of gradients that there are none of.
void vtkAHDSayArrayWarnings(
  vtkAlgorithm* filter, const vtkAHDSampleSettings& settings, const vtkAHDSampleColumns& columns);

/// Warns of places and values, each at most once.
void vtkAHDSayPlaceWarnings(vtkAlgorithm* filter, const vtkAHDSampleResult& result);

#endif
