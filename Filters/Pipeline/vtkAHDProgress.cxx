// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkAHDProgress.h"

#include "Engine/Core/FloatingPoint.h"
#include "Pipeline/vtkAHDSay.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"

vtkAHDProgress::vtkAHDProgress(vtkAlgorithm* filter, ahd::Clock clock)
  : RunProgress(clock)
  , Filter(filter)
{
}

bool vtkAHDProgress::isCancelled() const
{
#if AHD_VTK_HAS_CHECK_ABORT
  return this->InputIsChanged || this->Filter->CheckAbort();
#else
  return this->InputIsChanged || this->Filter->GetAbortExecute() != 0;
#endif
}

void vtkAHDProgress::tell(double done, ahd::Phase)
{
  if (this->Silences > 0)
  {
    return;
  }
  const ahd::ScopedFloatingPoint whateverObserversSet;
  this->Filter->UpdateProgress(done);
  this->LookAtInput();
}

bool vtkAHDProgress::IsObserved() const
{
  return this->Filter->HasObserver(vtkCommand::ProgressEvent) ||
    this->Filter->GetProgressObserver();
}

void vtkAHDProgress::LookAtInput()
{
  if (!this->InputIsChanged && !this->Watched.AreInPlace())
  {
    this->InputIsChanged = true;
    vtkAHDSay(this->Filter, ahd::Topic::Refusal, { { "input_is_changed", true } });
  }
}
