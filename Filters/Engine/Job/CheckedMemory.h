// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CheckedMemory_h
#define ahd_CheckedMemory_h

#include "../Core/AskedMemory.h"
#include "../Result.h"
#include "Messages.h"

#include <cstddef>
#include <limits>

namespace ahd
{

/// The memory of one piece of work, in bytes, compared with what is allowed: before it begins, and
/// while it requests more.
struct CheckedMemory
{
  std::size_t limit = 0;   ///< 0: what the process can get
  std::size_t needed = 0;  ///< what is held, and what was needed and requested so far
  std::size_t allowed = 0; ///< what it is compared with
  bool isRefused = false;  ///< more is needed than allowed

  CheckedMemory() = default;
  /// `itsHeld`: bytes that the work needs and that are there already. They count in the limit, and
  /// are not part of what the process can get.
  explicit CheckedMemory(std::size_t itsLimit, std::size_t itsHeld = 0);

  /// Ok, or OutOfMemory: more is needed than allowed with these bytes.
  Status need(std::size_t bytes);
  /// Returns work(), which may request what is left; the limit ends with it. @pre nothing was
  /// refused
  template <typename Work>
  Status request(AskedMemory& asked, const Work& work)
  {
    asked.limitTo(allowed - needed);
    const Status status = work();
    needed += asked.most();
    isRefused = status == Status::OutOfMemory && asked.wasRefused();
    asked.limitTo(std::numeric_limits<std::size_t>::max());
    return status;
  }
  /// Those of a refusal, or of running out. `doing`: a word of Catalogue.h; `of`: how many things.
  Facts facts(Status status, const char* doing, const Fact& of) const;
};

} // namespace ahd

#endif
