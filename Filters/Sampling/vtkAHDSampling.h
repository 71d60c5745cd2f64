// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSampling_h
#define vtkAHDSampling_h

#include "Engine/Sample/Sample.h"
#include "Pipeline/vtkAHDContext.h"
#include "Sampling/vtkAHDSampleColumns.h"
#include "Sampling/vtkAHDSampleSettings.h"
#include "vtkCharArray.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

namespace ahd
{
class Triangulation;
}

/**
 * Values at places on a surface: calls the engine for the columns of one execution. Borrows all.
 */
class vtkAHDSampling
{
public:
  vtkAHDSampling(const vtkAHDSampleSettings& settings, ahd::Triangulation& surface,
    const unsigned char* kept, const vtkAHDContext& context)
    : Settings(settings)
    , Surface(surface)
    , Kept(kept)
    , Context(context)
  {
  }

  /// Interpolates at all places into the arrays of `columns`. `heights`: of the points.
  /// Throws vtkAHDStop and std::bad_alloc.
  void Run(const ahd::SamplePlaces& places, const double* heights, vtkAHDSampleColumns& columns);

  const ahd::SampleReport& GetReport() const { return this->Report; }

  /// 1 for places with a value.
  vtkSmartPointer<vtkCharArray> GetMask() const { return this->Mask; }

  /// Upper estimate of the bytes that Run() takes for so many points and places, with those of
  /// vtkAHDSampleColumns::EstimateBytes(), without the tables of the surface.
  static double EstimateBytes(const vtkAHDSampleSettings& settings,
    const vtkAHDSampleColumns& columns, std::size_t points, const ahd::SamplePlaces& places);

private:
  void Interpolate(
    const ahd::SamplePlaces& places, const double* heights, vtkAHDSampleColumns& columns);
  void FindNearest(
    const ahd::SamplePlaces& places, const double* heights, vtkAHDSampleColumns& columns);
  void FillOutside(const ahd::Sampler& inside, const ahd::SamplePlaces& places,
    const std::vector<ahd::SampleArray>& arrays);

  const vtkAHDSampleSettings& Settings;
  ahd::Triangulation& Surface;
  const unsigned char* const Kept;
  const vtkAHDContext& Context;
  ahd::SampleReport Report;
  vtkSmartPointer<vtkCharArray> Mask;
};

#endif
