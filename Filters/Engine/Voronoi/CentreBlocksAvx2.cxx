// SPDX-License-Identifier: BSD-3-Clause
//
// Circumcentres once more, for processors with AVX2 and fused multiply-adds (Core/Dispatch.h), and
// the choice.
#include "../Arithmetic/DoubleDouble.h"
#include "CentreBlocks.h"
#include "Circumcentre.h"

#include <algorithm>
#include <cmath>

#if AHD_HAS_X86_TARGETS
#undef AHD_TARGET
#define AHD_TARGET avx2
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif
#define AHD_FUSED_MULTIPLY_ADD 1

#include "CentreBlocks.cxx"

#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

namespace ahd
{

CentresOf* circumcentres()
{
  static const DispatchTarget<CentresOf> kTargets[] = {
    { InstructionSet::Baseline, baseline::circumcentresHere },
#if AHD_HAS_X86_TARGETS
    { InstructionSet::Avx2, avx2::circumcentresHere },
#endif
  };
  static CentresOf* const kBest = best(kTargets);
  return kBest;
}

} // namespace ahd
