// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Refusal_h
#define ahd_Refusal_h

#include "../Core/SizeInWords.h"
#include "../Result.h"
#include "Words.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace ahd
{

/// Why a call of a job cannot be done. Thrown within Job/ and caught at the border of the
/// interface.
struct Refusal
{
  Reason reason;
  std::string text;
};

[[noreturn]] inline void refuse(Reason reason, std::string text)
{
  throw Refusal{ reason, std::move(text) };
}

// What is estimated for so many stays a number.
constexpr std::uint64_t kMostNumbers = std::uint64_t(1) << 48;
constexpr std::uint64_t kMostColumns = std::uint64_t(1) << 24;

/// Refuses a count that no memory has room for: a caller's -1, or what was never set. `what`: in
/// plural.
inline void checkCount(std::uint64_t count, const char* what)
{
  if (count > kMostNumbers)
  {
    refuse(Reason::BadArray, std::to_string(count) + " " + what + " are beyond all memory.");
  }
}

/// The same of what lies side by side for each point or place.
inline void checkColumns(std::uint64_t count, const char* what)
{
  if (count > kMostColumns)
  {
    refuse(Reason::BadValue,
      std::to_string(count) + " " + what + " are too many to interpolate at a time: at most " +
        std::to_string(kMostColumns) + ".");
  }
}

/// What refusals say of memory: "7.63 MB of memory, but "memory_limit" allows 7.47 MB".
inline std::string butAllowed(
  std::size_t needed, std::size_t allowed, const char* who, const char* besides = "")
{
  return sizeInWords(needed, Rounded::Up) + " of memory" + besides + ", but " + who + " " +
    sizeInWords(allowed, Rounded::Down);
}

/// The way out.
inline std::string orSetLimit(std::size_t needed)
{
  return "or set \"memory_limit\" to " + std::to_string(needed) + " or more (bytes).";
}

/// Refuses unless Ok. What has a number in its text is refused where the number is known.
inline void check(Status status)
{
  switch (status)
  {
    case Status::Ok:
      return;
    case Status::Cancelled:
      refuse(Reason::Cancelled, "Cancelled.");
    case Status::TooManyPoints:
      refuse(Reason::TooManyPoints, "Too many points.");
    case Status::TooManyBoxes:
      refuse(Reason::TooManyBoxes, "Too many boxes.");
    case Status::TooManyCrossings:
      refuse(Reason::TooManyCrossings, "Too many crossings.");
    case Status::OutOfMemory:
      refuse(Reason::OutOfMemory, "Out of memory.");
    case Status::BadCells:
      refuse(Reason::BadArray, "Offsets do not ascend within the ids.");
  }
}

} // namespace ahd

#endif
