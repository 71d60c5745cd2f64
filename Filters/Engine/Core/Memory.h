// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Memory_h
#define ahd_Memory_h

#include <cstddef>

namespace ahd
{

/// Bytes that this process can still get without swapping: the least of what the machine has
/// available and what the limits on this process leave (address space; the memory limit of a
/// container). The largest number where none of them is known: only Linux tells all, other POSIX
/// systems the address space. For who sets limits; the engine itself does not ask.
std::size_t availableMemory();

} // namespace ahd

#endif
