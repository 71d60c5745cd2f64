// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContextSupport_h
#define ContextSupport_h

#include "Engine/Core/Threads.h"
#include "Pipeline/vtkAHDContext.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"

namespace ahdtest
{

/// The context of an execution: a filter that can abort, progress, threads, memory.
struct Work
{
  explicit Work(unsigned threads = 2)
    : Threads(threads)
  {
  }

  vtkNew<vtkAlgorithm> Filter;
  vtkAHDProgress Progress{ this->Filter };
  ahd::Threads Threads;
  vtkAHDOutputMemory Memory;
  const vtkAHDContext Context{ this->Progress, this->Threads, this->Memory };
};

} // namespace ahdtest

#endif
