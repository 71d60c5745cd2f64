// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDMemoryLimit_h
#define vtkAHDMemoryLimit_h

#include "vtkType.h"

#include <algorithm>
#include <cstddef>

/// The bytes of a MemoryLimit, in KiB: all of the last one, as messages have whole KiB of what is
/// needed. 0: no limit.
inline std::size_t vtkAHDBytesOfLimit(vtkTypeInt64 kibibytes)
{
  constexpr vtkTypeInt64 kPlenty = vtkTypeInt64(1) << 50;
  const auto limit = static_cast<std::size_t>(std::min(kibibytes, kPlenty));
  return limit > 0 ? 1024 * limit + 1023 : 0;
}

#endif
