// SPDX-License-Identifier: BSD-3-Clause
#include "Processors.h"

#include <algorithm>
#include <thread>

#if defined(__linux__)
#include <sched.h>
#elif defined(_WIN32)
#include "Windows.h"

#include <bitset>
#endif

namespace ahd
{
namespace
{

/// 0: unknown.
unsigned allowedProcessors()
{
#if defined(__linux__)
  cpu_set_t allowed; // of 1024 processors: where there are more, the call fails
  if (sched_getaffinity(0, sizeof(allowed), &allowed) == 0)
  {
    return static_cast<unsigned>(CPU_COUNT(&allowed));
  }
#elif defined(_WIN32)
  DWORD_PTR allowed = 0, group = 0; // both are 0 for threads in several groups
  if (GetProcessAffinityMask(GetCurrentProcess(), &allowed, &group) && allowed != group)
  {
    return static_cast<unsigned>(std::bitset<64>(allowed).count());
  }
  USHORT groups[64];
  USHORT count = 64;
  unsigned processors = 0;
  if (GetProcessGroupAffinity(GetCurrentProcess(), &count, groups))
  {
    for (USHORT i = 0; i < count; ++i)
    {
      processors += GetActiveProcessorCount(groups[i]);
    }
  }
  return processors;
#endif
  return 0;
}

} // namespace

unsigned availableProcessors()
{
  const unsigned allowed = allowedProcessors();
  return allowed > 0 ? allowed : std::max(1u, std::thread::hardware_concurrency());
}

} // namespace ahd
