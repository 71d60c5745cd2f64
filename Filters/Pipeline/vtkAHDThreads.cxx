// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkAHDThreads.h"

#include "Engine/Core/Processors.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace
{
constexpr int kMostThreads = 1024;

/// The most threads that vtkSMPTools was told to take, with its own precedence. What it was told is
/// looked up where it is kept: the Sequential backend answers 1 whatever it was told, the TBB
/// backend of VTK 9.6 the first number it was told, and nothing public says more.
int GetLimit()
{
  const int told =
    vtk::detail::smp::vtkSMPToolsAPI::GetInstance().GetInternalDesiredNumberOfThread();
  if (told > 0)
  {
    return told;
  }
  if (std::strcmp(vtkSMPTools::GetBackend(), "Sequential") != 0)
  {
    return std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
  }
  const char* environment = std::getenv("VTK_SMP_MAX_THREADS");
  const int limit = environment ? std::atoi(environment) : 0;
  return limit > 0 ? limit : kMostThreads;
}
}

unsigned vtkAHDThreadsToUse(int wished)
{
  if (wished > 0)
  {
    return static_cast<unsigned>(std::min(wished, kMostThreads));
  }
  if (vtkSMPTools::IsParallelScope() && !vtkSMPTools::GetNestedParallelism())
  {
    return 1;
  }
  const int processors = static_cast<int>(ahd::availableProcessors());
  return static_cast<unsigned>(std::min({ processors, GetLimit(), kMostThreads }));
}
