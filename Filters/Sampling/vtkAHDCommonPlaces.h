// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDCommonPlaces_h
#define vtkAHDCommonPlaces_h

#include "Engine/Points/Points.h"
#include "Engine/Sample/Sample.h"

#include <cstddef>
#include <vector>

class vtkAHDContext;

/// Places of a piece of a raster that are in other pieces of it, too, each once. Added to `places`,
/// unless null. Returns their number. Throws vtkAHDStop on an abort.
std::size_t vtkAHDFindCommonPlaces(const ahd::SampleRaster& piece,
  const std::vector<ahd::SampleRaster>& others, const vtkAHDContext& context,
  std::vector<ahd::Point>* places);

#endif
