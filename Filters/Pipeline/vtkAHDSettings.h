// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSettings_h
#define vtkAHDSettings_h

#include "Engine/Job/RunSettings.h"
#include "Pipeline/vtkAHDSettingsOfRanks.h"
#include "vtkAbstractTransform.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

/// What a filter is asked for, as it was when the execution began. Whoever has a copy holds what it
/// names, but for the plane.
struct vtkAHDSettings : ahd::RunSettings
{
  bool AddSourcePoints = false;
  const ahd::Plane* Plane = nullptr; ///< with fitsPlane(): null, or this one, fitted before
  vtkSmartPointer<vtkAbstractTransform> Transform; ///< null: none is used
  bool TransformIsMissing = false;                 ///< although it is asked for
  int GhostLevels = 0;          ///< layers of ghost cells that are asked for; only on ranks
  vtkTypeInt64 MemoryLimit = 0; ///< KiB; 0: what there is
  vtkTypeInt64 ReuseLimit = 0;  ///< KiB
  vtkAHDSettingsOfRanks OfRanks;
};

#endif
