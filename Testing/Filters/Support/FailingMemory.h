// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FailingMemory_h
#define ahd_FailingMemory_h

#include <cstddef>

namespace ahdtest
{

/// Memory that runs out when told to: operator new and malloc, as the filter's own library asks for
/// it (the engine is in it), itself or through the standard library, on any thread. VTK's own
/// requests are met: after a failure within them its objects are not fit to be destroyed.
///
/// Counts and fails only between begin() and end().
namespace memory
{
/// The allocation of this number fails, from 1; 0: none. With `andAllLater` those after it, too.
void begin(std::size_t failAt, bool andAllLater);
/// How many allocations have been asked for since.
std::size_t count();
/// Returns how many allocations were asked for.
std::size_t end();
/// Blocks of operator new that are in use, whoever asked for them.
std::ptrdiff_t blocks();
}

} // namespace ahdtest

#endif
