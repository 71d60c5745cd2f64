// SPDX-License-Identifier: BSD-3-Clause
#include "Flavours.h"

#include "../Instructions.h"

namespace ahd
{

InsertionEnd insertByRounds(
  const RankedPoints& points, Mesh& mesh, Ticker& ticker, InsertionWork* work, SharedWork& shared)
{
#if AHD_HAS_FMA_FLAVOUR
  if (processorHasFma())
  {
    return fma::insertByRoundsHere(points, mesh, ticker, work, shared);
  }
#endif
  return baseline::insertByRoundsHere(points, mesh, ticker, work, shared);
}

InsertionEnd insertSequence(const RankedPoints& points, const Buffer<Index>& sequence, Mesh& mesh,
  Ticker& ticker, InsertionWork* work)
{
#if AHD_HAS_FMA_FLAVOUR
  if (processorHasFma())
  {
    return fma::insertSequenceHere(points, sequence, mesh, ticker, work);
  }
#endif
  return baseline::insertSequenceHere(points, sequence, mesh, ticker, work);
}

} // namespace ahd
