// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Context_h
#define ahd_Context_h

namespace ahd
{

class Executor;
class Progress;

/// Where a call of the engine reports progress, and the threads lent to it. Either may be null:
/// without `progress` nothing is reported and the call cannot be cancelled, without `executor` the
/// calling thread does all the work.
struct Context
{
  Progress* progress = nullptr;
  Executor* executor = nullptr;
};

} // namespace ahd

#endif
