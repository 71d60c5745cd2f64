// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FailingMemory_h
#define ahd_FailingMemory_h

#include <cstddef>

namespace ahdtest
{

/// Memory that runs out on demand: operator new and malloc, when called by the filter's own library
/// (which has the engine), directly or through the standard library, on any thread. VTK's own
/// requests succeed: after a failure within them its objects cannot be destroyed.
///
/// Counts and fails only between begin() and end().
namespace memory
{
/// The allocation of this number fails, from 1; 0: none. With `andAllLater` those after it, too.
/// `ofVtk`: those of operator new in VTK count and fail as well. For what makes none of its
/// objects.
void begin(std::size_t failAt, bool andAllLater, bool ofVtk = false);
/// The number of allocations since.
std::size_t count();
/// Returns the number of allocations.
std::size_t end();
/// Blocks of operator new that are in use, of all callers.
std::ptrdiff_t blocks();
}

} // namespace ahdtest

#endif
