// SPDX-License-Identifier: BSD-3-Clause
#include "Memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace ahd
{

namespace
{

constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();

std::size_t less(std::size_t limit, std::size_t taken)
{
  return limit > taken ? limit - taken : 0;
}

/// Bytes of the address space and of memory that the process has taken; 0 where nobody tells.
struct Taken
{
  std::size_t space = 0;
  std::size_t resident = 0;
};

Taken takenByProcess()
{
  Taken taken;
#if defined(__linux__)
  if (std::ifstream("/proc/self/statm") >> taken.space >> taken.resident)
  {
    const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return { taken.space * page, taken.resident * page };
  }
#endif
  return Taken();
}

std::size_t addressSpaceLeft(const Taken& taken)
{
#if defined(__unix__) || defined(__APPLE__)
  rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
  {
    return less(static_cast<std::size_t>(limit.rlim_cur), taken.space);
  }
#endif
  static_cast<void>(taken);
  return kUnknown;
}

/// Linux control groups, second version, then first; a limit that is not set does not read as a
/// number or is astronomic.
std::size_t containerLeft(const std::string& groups, const Taken& taken)
{
  for (const char* file : { "/memory.max", "/memory/memory.limit_in_bytes" })
  {
    std::size_t bytes = 0;
    if (std::ifstream(groups + file) >> bytes && bytes > 0)
    {
      return less(bytes, taken.resident);
    }
  }
  return kUnknown;
}

/// What Linux takes for available: free memory, and caches that it would give up.
std::size_t machineLeft(const std::string& meminfo)
{
  std::ifstream info(meminfo);
  std::string name, unit;
  for (std::size_t kibibytes = 0; info >> name >> kibibytes; std::getline(info, unit))
  {
    if (name == "MemAvailable:")
    {
      return 1024 * kibibytes;
    }
  }
  return kUnknown;
}

} // namespace

std::size_t availableMemory()
{
  return availableMemoryBy("/proc/meminfo", "/sys/fs/cgroup");
}

std::size_t availableMemoryBy(const std::string& meminfo, const std::string& groups)
{
  const Taken taken = takenByProcess();
  return std::min({ machineLeft(meminfo), containerLeft(groups, taken), addressSpaceLeft(taken) });
}

} // namespace ahd
