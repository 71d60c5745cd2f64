// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDMemoryWords_h
#define vtkAHDMemoryWords_h

#include "Engine/Core/SizeInWords.h"
#include "vtkType.h"

#include <algorithm>
#include <cstdint>
#include <string>

/// What messages say of memory, given in KiB: "7.63 MB".
inline std::string vtkAHDInWords(vtkTypeInt64 kibibytes, ahd::Rounded rounded)
{
  constexpr vtkTypeInt64 kMost = vtkTypeInt64(1) << 53; // as bytes they can be counted
  return ahd::sizeInWords(1024 * static_cast<std::uint64_t>(std::min(kibibytes, kMost)), rounded);
}
inline std::string vtkAHDNeeded(vtkTypeInt64 needed)
{
  return vtkAHDInWords(needed, ahd::Rounded::Up);
}

/// "MemoryLimit allows 7.47 MB", or "there are 7.47 MB". `of`: whose MemoryLimit.
inline std::string vtkAHDButAllowed(
  vtkTypeInt64 allowed, bool isLimited, const std::string& of = std::string())
{
  return (isLimited ? "MemoryLimit " + of + "allows " : "there are ") +
    vtkAHDInWords(allowed, ahd::Rounded::Down);
}

/// The way out: "or set MemoryLimit to 7445 or more (KiB)."
inline std::string vtkAHDOrSetLimit(vtkTypeInt64 needed, bool isOfEachRank = false)
{
  return "or set MemoryLimit to " + std::to_string(needed) +
    (isOfEachRank ? " or more (KiB, of each rank)." : " or more (KiB).");
}

#endif
