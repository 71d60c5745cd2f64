// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Refusal_h
#define ahd_Refusal_h

#include "../Result.h"
#include "Messages.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace ahd
{

/// The reason why a call of a job fails. Thrown within Job/ and caught at the border of the
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

// Estimates for so many do not overflow.
constexpr std::uint64_t kMostNumbers = std::uint64_t(1) << 48;
constexpr std::uint64_t kMostColumns = std::uint64_t(1) << 24;

/// Refuses an impossible count: a caller's -1, or an uninitialised one. `what`: in
/// plural.
inline void checkCount(std::uint64_t count, const char* what)
{
  if (count > kMostNumbers)
  {
    refuse(Reason::BadArray, std::to_string(count) + " " + what + " do not fit in any memory.");
  }
}

/// The same for columns of each point or place.
inline void checkColumns(std::uint64_t count, const char* what)
{
  if (count > kMostColumns)
  {
    refuse(Reason::BadValue,
      std::to_string(count) + " " + what + " are too many to interpolate at a time: at most " +
        std::to_string(kMostColumns) + ".");
  }
}

/// Refuses with the text of Messages.cxx.
[[noreturn]] inline void refuse(Reason reason, Facts facts)
{
  facts.add({ "reason", reason });
  refuse(reason, messages(Topic::Refusal, Wording::Job, facts).at(0).text);
}

/// Refuses unless Ok. Texts with numbers are made where the numbers are known.
inline void check(Status status)
{
  // In the order of Status.
  const char* const texts[] = { "", "Cancelled.", "Too many points.", "Too many boxes.",
    "Too many crossings.", "Out of memory.", "Offsets do not ascend within the ids.",
    "No convex polygon.", "Settings exclude each other." };
  if (status != Status::Ok)
  {
    refuse(reasonOf(status, false), texts[std::size_t(status)]);
  }
}

} // namespace ahd

#endif
