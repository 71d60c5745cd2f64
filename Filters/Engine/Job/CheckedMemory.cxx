// SPDX-License-Identifier: BSD-3-Clause
#include "CheckedMemory.h"

#include "../Core/Memory.h"

#include <algorithm>

namespace ahd
{

CheckedMemory::CheckedMemory(std::size_t itsLimit, std::size_t itsHeld)
  : limit(itsLimit)
  , allowed(itsLimit > 0 ? itsLimit : availableMemory())
{
  allowed += limit > 0 ? 0 : std::min(itsHeld, ~allowed); // no overflow
  need(itsHeld);
}

Status CheckedMemory::need(std::size_t bytes)
{
  needed += bytes;
  isRefused = needed > allowed;
  return isRefused ? Status::OutOfMemory : Status::Ok;
}

Facts CheckedMemory::facts(Status status, const char* doing, const Fact& of) const
{
  return { { "reason", reasonOf(status, isRefused) }, { "doing", doing }, of,
    { "memory_limit", limit }, { "memory_estimate", needed }, { "memory_allowed", allowed } };
}

} // namespace ahd
