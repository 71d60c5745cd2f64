// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_InsertTargets_h
#define ahd_InsertTargets_h

#include "Frame.h"
#include "Insert.h"

namespace ahd
{

// insertByRounds and insertSequence as they are compiled for each instruction set
// (Core/Dispatch.h); those for which the compiler makes none are declared only.
#define AHD_DECLARE_TARGET(name)                                                                   \
  inline namespace name                                                                            \
  {                                                                                                \
  InsertionEnd insertByRoundsHere(const Frame&, Mesh&, Ticker&, InsertionWork*, SharedWork&);      \
  InsertionEnd insertSequenceHere(                                                                 \
    const Frame&, const Buffer<Index>&, Mesh&, Ticker&, InsertionWork*);                           \
  }

AHD_DECLARE_TARGET(baseline)
AHD_DECLARE_TARGET(avx2)

#undef AHD_DECLARE_TARGET

} // namespace ahd

#endif
