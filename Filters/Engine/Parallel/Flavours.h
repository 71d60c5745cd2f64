// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Flavours_h
#define ahd_Flavours_h

#include "ByRounds.h"

namespace ahd
{

// insertByRounds and insertSequence as they are compiled for each kind of processor
// (Instructions.h); those for which the compiler makes none are declared only.
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

#undef AHD_DECLARE_FLAVOUR

} // namespace ahd

#endif
