// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Refusal_h
#define ahd_Refusal_h

#include "../Result.h"
#include "ahd.h"

#include <string>
#include <utility>

namespace ahd
{

/// Why a call of the C interface cannot be done. Thrown within Interface/ and caught at its border.
struct Refusal
{
  ahd_status status;
  std::string text;
};

[[noreturn]] inline void refuse(ahd_status status, std::string text)
{
  throw Refusal{ status, std::move(text) };
}

/// Refuses unless Ok. What has a number in its text is refused where the number is known.
inline void check(Status status)
{
  switch (status)
  {
    case Status::Ok:
      return;
    case Status::Cancelled:
      refuse(AHD_CANCELLED, "Cancelled.");
    case Status::TooManyPoints:
      refuse(AHD_TOO_MANY_POINTS, "Too many points.");
    case Status::TooManyBoxes:
      refuse(AHD_TOO_MANY_BOXES, "Too many boxes.");
    case Status::TooManyCrossings:
      refuse(AHD_TOO_MANY_CROSSINGS, "Too many crossings.");
    case Status::OutOfMemory:
      refuse(AHD_OUT_OF_MEMORY, "Out of memory.");
    case Status::BadCells:
      refuse(AHD_BAD_ARRAY, "Offsets do not ascend within the ids.");
  }
}

} // namespace ahd

#endif
