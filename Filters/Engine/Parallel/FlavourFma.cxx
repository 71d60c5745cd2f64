// SPDX-License-Identifier: BSD-3-Clause
//
// The insertion once more, for processors with AVX2 and fused multiply-adds (Instructions.h).
// Measured: 4 to 8 % of the time of the insertion.
#include "../Chunks.h"
#include "../Insert/FirstTriangle.h"
#include "../Insert/Inserter.h"
#include "../Instructions.h"
#include "../Mesh/Mesh.h"
#include "../Order/RankedPoints.h"
#include "../Order/Rounds.h"
#include "../Predicates/Predicates.h"
#include "../Tasks.h"
#include "ByRounds.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#if AHD_HAS_FMA_FLAVOUR
#undef AHD_INSTRUCTIONS
#define AHD_INSTRUCTIONS fma
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif
#define AHD_FUSED_MULTIPLY_ADD 1

#include "../Insert/Inserter.cxx"
#include "../Insert/Kernel.cxx"
#include "ByRounds.cxx"
#include "Parts.cxx"

#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
