// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSampleSettings_h
#define vtkAHDSampleSettings_h

#include "Engine/Sample/Sample.h"
#include "Pipeline/vtkAHDSettingsOfRanks.h"
#include "Sampling/vtkAHDRaster.h"

#include <array>
#include <limits>
#include <string>

/// The settings of the interpolation when the execution began.
struct vtkAHDSampleSettings
{
  ahd::SampleMethod Method = ahd::SampleMethod::Linear;
  vtkAHDRasterWish Raster;
  bool UseBounds = false;
  std::array<double, 4> Bounds = { { 0.0, 1.0, 0.0, 1.0 } };
  bool AsSurface = false; ///< the raster, as points at their heights
  ahd::OutsideValues Outside = ahd::OutsideValues::None;
  double NoValue = std::numeric_limits<double>::quiet_NaN();
  bool Gradients = false;
  std::string Heights; ///< the name of their array; empty: no array
  std::string Mask;    ///< the same
  vtkAHDSettingsOfRanks OfRanks;

  bool IsNearest() const { return this->Method == ahd::SampleMethod::Nearest; }
  /// Do places outside get values? Nearest has them anyway.
  bool FillsOutside() const
  {
    return this->Outside != ahd::OutsideValues::None && !this->IsNearest();
  }
  bool MakesGradients() const
  {
    return this->Gradients && this->Method == ahd::SampleMethod::Linear;
  }
};

#endif
