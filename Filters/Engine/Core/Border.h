// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Border_h
#define ahd_Border_h

#include "../Result.h"
#include "FloatingPoint.h"

#include <new>
#include <stdexcept>

namespace ahd
{

/// The engine's border: exceptions of the standard library for lack of memory become a status, and
/// floating-point arithmetic is set as the engine assumes it. `work` returns a Status.
template <typename Work>
Status withoutThrowing(Work work)
{
  const ScopedFloatingPoint asAssumed;
  try
  {
    return work();
  }
  catch (const std::bad_alloc&)
  {
    return Status::OutOfMemory;
  }
  catch (const std::length_error&)
  {
    return Status::OutOfMemory;
  }
}

/// The same for work that returns false where it was cancelled.
template <typename Work>
Status unlessCancelled(Work work)
{
  return withoutThrowing([&] { return work() ? Status::Ok : Status::Cancelled; });
}

} // namespace ahd

#endif
