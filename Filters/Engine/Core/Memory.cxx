// SPDX-License-Identifier: BSD-3-Clause
#include "Memory.h"

#include "Clock.h"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <limits>
#include <string>

#if defined(_WIN32)
#define PSAPI_VERSION 2 // of kernel32
#include "Windows.h"

#include <psapi.h>
#else
#include <sys/resource.h>
#include <unistd.h>
#if defined(__APPLE__)
#include <mach/mach.h>
#endif
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

/// Bytes of the address space and of memory that the process has taken; 0 where unknown.
struct Taken
{
  std::size_t space = 0;
  std::size_t resident = 0;
};

Taken takenByProcess()
{
#if defined(__linux__)
  Taken taken;
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
#if !defined(_WIN32)
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

/// Memory that Linux counts as available: free memory, and caches that it would give up.
std::size_t linuxLeft(const std::string& meminfo)
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

#if defined(_WIN32)
/// The memory that the job of the process, if any, still lets it commit. The share of the job's
/// other processes is not known.
std::size_t jobLeft()
{
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION job = {};
  PROCESS_MEMORY_COUNTERS taken = {};
  taken.cb = sizeof(taken);
  if (!QueryInformationJobObject(
        nullptr, JobObjectExtendedLimitInformation, &job, sizeof(job), nullptr) ||
    !GetProcessMemoryInfo(GetCurrentProcess(), &taken, sizeof(taken)))
  {
    return kUnknown;
  }
  const DWORD set = job.BasicLimitInformation.LimitFlags;
  return less(std::min((set & JOB_OBJECT_LIMIT_PROCESS_MEMORY) ? job.ProcessMemoryLimit : kUnknown,
                (set & JOB_OBJECT_LIMIT_JOB_MEMORY) ? job.JobMemoryLimit : kUnknown),
    taken.PagefileUsage);
}

/// Memory that is free, but no more than can be committed: beyond that allocations fail.
std::size_t windowsLeft()
{
  MEMORYSTATUSEX machine = {};
  machine.dwLength = sizeof(machine);
  if (!GlobalMemoryStatusEx(&machine))
  {
    return kUnknown;
  }
  return static_cast<std::size_t>(
    std::min({ machine.ullAvailPhys, machine.ullAvailPageFile, machine.ullAvailVirtual }));
}
#elif defined(__APPLE__)
/// Pages that are free, and those that Mach would give up.
std::size_t machLeft()
{
  vm_statistics64_data_t pages = {};
  mach_msg_type_number_t count = HOST_VM_INFO64_COUNT;
  const mach_port_t host = mach_host_self();
  const bool told = host_statistics64(host, HOST_VM_INFO64, reinterpret_cast<host_info64_t>(&pages),
                      &count) == KERN_SUCCESS;
  mach_port_deallocate(mach_task_self(), host);
  return told
    ? vm_page_size * (std::size_t(pages.free_count) + pages.inactive_count + pages.purgeable_count)
    : kUnknown;
}
#endif

} // namespace

std::size_t availableMemory()
{
#if defined(_WIN32)
  return std::min(windowsLeft(), jobLeft());
#elif defined(__APPLE__)
  return std::min(machLeft(), addressSpaceLeft(takenByProcess()));
#else
  return availableMemoryBy("/proc/meminfo", "/sys/fs/cgroup");
#endif
}

std::size_t availableMemoryFor(std::size_t bytes)
{
  constexpr std::size_t kFew = std::size_t(1) << 24;
  constexpr double kSeconds = 0.1;
  // Each is good on its own: of two threads that read at once, either has just been there.
  static std::atomic<std::size_t> read{ 0 };
  static std::atomic<double> readAt{ 0.0 };
  const double now = steadySeconds();
  if (bytes > kFew || read < 64 * kFew || !(now - readAt < kSeconds))
  {
    read = availableMemory();
    readAt = now;
  }
  return read;
}

std::size_t availableMemoryBy(const std::string& meminfo, const std::string& groups)
{
  const Taken taken = takenByProcess();
  return std::min({ linuxLeft(meminfo), containerLeft(groups, taken), addressSpaceLeft(taken) });
}

} // namespace ahd
