// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkAHDProgress.h"

#include "Engine/Core/FloatingPoint.h"

#include "vtkAlgorithm.h"

vtkAHDProgress::vtkAHDProgress(vtkAlgorithm* filter, ahd::Clock clock)
  : RunProgress(clock)
  , Filter(filter)
{
}

bool vtkAHDProgress::isCancelled() const
{
#if AHD_VTK_HAS_CHECK_ABORT
  return this->Filter->CheckAbort();
#else
  return this->Filter->GetAbortExecute() != 0;
#endif
}

void vtkAHDProgress::tell(double done, ahd::Phase)
{
  const ahd::ScopedFloatingPoint whateverObserversSet;
  this->Filter->UpdateProgress(done);
}
