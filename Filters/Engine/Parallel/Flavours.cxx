// SPDX-License-Identifier: BSD-3-Clause
#include "../Instructions.h"
#include "ByRounds.h"

namespace ahd
{

#define AHD_DECLARE_FLAVOUR(name)                                                                  \
  namespace name                                                                                   \
  {                                                                                                \
  InsertionEnd insertByRoundsHere(                                                                 \
    const RankedPoints&, Mesh&, Ticker&, InsertionWork*, SharedWork&);                             \
  InsertionEnd insertSequenceHere(                                                                 \
    const RankedPoints&, const Buffer<Index>&, Mesh&, Ticker&, InsertionWork*);                    \
  }

AHD_DECLARE_FLAVOUR(baseline)
AHD_DECLARE_FLAVOUR(fma)

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
