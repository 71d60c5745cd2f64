// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkAHDMemory.h"

#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <fstream>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace
{
constexpr vtkTypeInt64 kNoLimit = VTK_TYPE_INT64_MAX;

/// Kibibytes of address space the process may still take.
vtkTypeInt64 AddressSpaceLeft()
{
#if defined(__unix__) || defined(__APPLE__)
  rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
  {
    vtkTypeInt64 pagesTaken = 0; // unknown where there is no such file: then the limit itself
    std::ifstream("/proc/self/statm") >> pagesTaken;
    const vtkTypeInt64 taken = pagesTaken * (sysconf(_SC_PAGESIZE) / 1024);
    return std::max<vtkTypeInt64>(0, static_cast<vtkTypeInt64>(limit.rlim_cur / 1024) - taken);
  }
#endif
  return kNoLimit;
}

/// Kibibytes of memory the container this process runs in may take (Linux control groups, second
/// version, then first; a limit that is not set does not read as a number or is astronomic).
vtkTypeInt64 ContainerLimit()
{
  for (const char* path :
    { "/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes" })
  {
    vtkTypeInt64 bytes = 0;
    if (std::ifstream(path) >> bytes && bytes > 0)
    {
      return bytes / 1024;
    }
  }
  return kNoLimit;
}
}

vtkTypeInt64 vtkAHDAvailableMemory()
{
  vtksys::SystemInformation machine;
  const vtkTypeInt64 total = machine.GetHostMemoryTotal();
  const vtkTypeInt64 free = total > 0 ? total - machine.GetHostMemoryUsed() : kNoLimit;
  const vtkTypeInt64 container = ContainerLimit() - machine.GetProcMemoryUsed();
  return std::max<vtkTypeInt64>(0, std::min({ free, container, AddressSpaceLeft() }));
}
