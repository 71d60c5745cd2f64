// SPDX-License-Identifier: BSD-3-Clause
//
// The insertion once more, for processors with AVX2 and fused multiply-adds (Core/Dispatch.h).
// Measured: 4 to 8 % of the time of the insertion.
#include "../Core/Chunks.h"
#include "../Core/Dispatch.h"
#include "../Core/Tasks.h"
#include "../Mesh/Mesh.h"
#include "../Order/RankedPoints.h"
#include "../Order/Rounds.h"
#include "../Predicates/Predicates.h"
#include "FirstTriangle.h"
#include "InsertTargets.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#if AHD_HAS_X86_TARGETS
#include <immintrin.h>

#undef AHD_TARGET
#define AHD_TARGET avx2
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif
#define AHD_FUSED_MULTIPLY_ADD 1

#include "ByRounds.cxx"
#include "InSequence.cxx"
#include "Kernel.cxx"
#include "Parts.cxx"

#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
