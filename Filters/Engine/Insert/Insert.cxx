// SPDX-License-Identifier: BSD-3-Clause
#include "Insert.h"

#include "../Core/Dispatch.h"
#include "Frame.h"
#include "InsertTargets.h"

namespace ahd
{

namespace
{

/// Calls insert(frame) and puts the points back.
template <typename Insert>
InsertionEnd inFrame(RankedPoints& points, Ticker& ticker, Insert insert)
{
  Framing framing(points);
  if (!framing.begin(ticker))
  {
    return InsertionEnd::Cancelled;
  }
  const InsertionEnd end = insert(framing.frame());
  return end == InsertionEnd::Cancelled || framing.end(ticker) ? end : InsertionEnd::Cancelled;
}

} // namespace

InsertionEnd insertByRounds(
  RankedPoints& points, Mesh& mesh, Ticker& ticker, InsertionWork* work, SharedWork& shared)
{
  using Function = decltype(baseline::insertByRoundsHere);
  static constexpr DispatchTarget<Function> kTargets[] = {
    { InstructionSet::Baseline, baseline::insertByRoundsHere },
#if AHD_HAS_X86_TARGETS
    { InstructionSet::Avx2, avx2::insertByRoundsHere },
#endif
  };
  return inFrame(points, ticker,
    [&](const Frame& frame) { return best(kTargets)(frame, mesh, ticker, work, shared); });
}

InsertionEnd insertSequence(RankedPoints& points, const Buffer<Index>& sequence, Mesh& mesh,
  Ticker& ticker, InsertionWork* work)
{
  using Function = decltype(baseline::insertSequenceHere);
  static constexpr DispatchTarget<Function> kTargets[] = {
    { InstructionSet::Baseline, baseline::insertSequenceHere },
#if AHD_HAS_X86_TARGETS
    { InstructionSet::Avx2, avx2::insertSequenceHere },
#endif
  };
  return inFrame(points, ticker,
    [&](const Frame& frame) { return best(kTargets)(frame, sequence, mesh, ticker, work); });
}

} // namespace ahd
