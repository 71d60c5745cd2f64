// SPDX-License-Identifier: BSD-3-Clause
#include "Insert.h"

#include "../Core/Dispatch.h"
#include "InsertTargets.h"

namespace ahd
{

InsertionEnd insertByRounds(
  const RankedPoints& points, Mesh& mesh, Ticker& ticker, InsertionWork* work, SharedWork& shared)
{
  using Function = decltype(baseline::insertByRoundsHere);
  static constexpr DispatchTarget<Function> kTargets[] = {
    { InstructionSet::Baseline, baseline::insertByRoundsHere },
#if AHD_HAS_X86_TARGETS
    { InstructionSet::Avx2, avx2::insertByRoundsHere },
#endif
  };
  return best(kTargets)(points, mesh, ticker, work, shared);
}

InsertionEnd insertSequence(const RankedPoints& points, const Buffer<Index>& sequence, Mesh& mesh,
  Ticker& ticker, InsertionWork* work)
{
  using Function = decltype(baseline::insertSequenceHere);
  static constexpr DispatchTarget<Function> kTargets[] = {
    { InstructionSet::Baseline, baseline::insertSequenceHere },
#if AHD_HAS_X86_TARGETS
    { InstructionSet::Avx2, avx2::insertSequenceHere },
#endif
  };
  return best(kTargets)(points, sequence, mesh, ticker, work);
}

} // namespace ahd
