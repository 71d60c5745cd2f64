// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_OutlineRun_h
#define ahd_OutlineRun_h

#include "../Outline/Outline.h"
#include "Messages.h"
#include "RunProgress.h"

#include <cstddef>
#include <functional>

namespace ahd
{

/// The memory of an outline, in bytes.
struct OutlineMemory
{
  std::size_t other = 0;   ///< of the caller
  std::size_t limit = 0;   ///< 0: what the process can get
  std::size_t needed = 0;  ///< with the caller's, and what was requested meanwhile
  std::size_t allowed = 0; ///< the limit it was compared with
  bool isRefused = false;  ///< more is needed than allowed

  /// Ok, or OutOfMemory: more is needed than allowed with these bytes.
  Status need(std::size_t bytes);
  /// Those of a refusal, or of running out.
  Facts facts(Status status, const OutlineRequest& request) const;
};

/// outline(), unless it takes more memory than allowed: then OutOfMemory, before or in the middle.
/// `request`: with the sizes alone; open() returns it with the arrays, and may throw.
Status outlineWithin(OutlineMemory& memory, const OutlineRequest& request,
  const std::function<OutlineRequest()>& open, RunProgress& progress, Outline& out);

/// The facts of Topic::Outline.
Facts factsOf(const Outline& made);

} // namespace ahd

#endif
