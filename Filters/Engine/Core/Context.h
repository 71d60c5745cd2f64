// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Context_h
#define ahd_Context_h

namespace ahd
{

class Executor;
class Progress;

/// Who a call of the engine reports to and who lends it threads. Either may be null: then nobody is
/// told of progress and nobody can cancel, and the calling thread does all the work.
struct Context
{
  Progress* progress = nullptr;
  Executor* executor = nullptr;
};

} // namespace ahd

#endif
