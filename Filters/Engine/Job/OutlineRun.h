// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_OutlineRun_h
#define ahd_OutlineRun_h

#include "../Outline/Outline.h"
#include "CheckedMemory.h"
#include "Messages.h"
#include "RunProgress.h"

#include <cstddef>
#include <functional>

namespace ahd
{

/// The caller's part of the memory of an outline, in bytes.
struct OutlineMemory
{
  std::size_t limit = 0;    ///< 0: what the process can get
  std::size_t other = 0;    ///< what the caller holds
  std::size_t perPoint = 0; ///< arrays that the caller writes, for each point of the outline
};

/// outline(), unless it takes more memory than allowed: then OutOfMemory, before or in the middle.
/// `checked` has what was needed. `request`: with the sizes alone; open() returns it with the
/// arrays, and may throw.
Status outlineWithin(CheckedMemory& checked, const OutlineMemory& memory,
  const OutlineRequest& request, const std::function<OutlineRequest()>& open, RunProgress& progress,
  Outline& out);

/// The facts of a refused outline, or of one that ran out of memory.
inline Facts factsOf(const CheckedMemory& checked, Status status, const OutlineRequest& request)
{
  return checked.facts(status, "outlining", { "polygons", request.cells.cells });
}
/// The facts of Topic::Outline.
Facts factsOf(const Outline& made);

} // namespace ahd

#endif
