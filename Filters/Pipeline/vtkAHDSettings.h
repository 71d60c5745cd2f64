// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSettings_h
#define vtkAHDSettings_h

#include "Engine/Job/RunSettings.h"
#include "Pipeline/vtkAHDSettingsOfRanks.h"
#include "vtkAbstractTransform.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>

/// The settings of a filter when the execution began. A copy owns what it refers to, except the
/// plane.
struct vtkAHDSettings : ahd::RunSettings
{
  bool AddSourcePoints = false;
  const ahd::Plane* Plane = nullptr; ///< with fitsPlane(): null, or this one, fitted before
  vtkSmartPointer<vtkAbstractTransform> Transform;            ///< null: none is used
  bool TransformIsMissing = false;                            ///< though the settings require one
  std::string ValueArrayName, WeightArrayName, KeepArrayName; ///< if RunSettings has them
  bool CopiesKept = false;      ///< the output has only the points of a simplified surface
  int GhostLevels = 0;          ///< requested layers of ghost cells; only on ranks
  vtkTypeInt64 MemoryLimit = 0; ///< KiB; 0: available memory
  vtkTypeInt64 ReuseLimit = 0;  ///< KiB
  vtkAHDSettingsOfRanks OfRanks;
};

#endif
