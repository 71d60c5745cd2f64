// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Memory_h
#define ahd_Memory_h

#include <cstddef>
#include <string>

namespace ahd
{

/// Bytes that this process can still get without swapping: the least of what the machine has
/// available and what the limits on this process leave.
///
///          machine                              limits
/// Linux    MemAvailable                         address space, container (both versions of groups)
/// Windows  free memory, memory to be committed  job: of each process, of all together
/// macOS    free, inactive and purgeable pages   address space
/// others   (not known)                          address space
///
/// Of the memory that counts against a limit only this process's share is known. The largest number
/// where nothing is known. For callers that set limits; the engine itself does not use it.
std::size_t availableMemory();

/// The same, to decide about so many bytes. For at most 16 MiB, of what was at least a gibibyte, a
/// reading up to a tenth of a second old is enough: a new one takes longer than such work.
std::size_t availableMemoryFor(std::size_t bytes);

/// The same from other files: `meminfo` in place of
/// /proc/meminfo, and the folder `groups` in place of /sys/fs/cgroup. For tests.
std::size_t availableMemoryBy(const std::string& meminfo, const std::string& groups);

} // namespace ahd

#endif
