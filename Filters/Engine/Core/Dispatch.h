// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Dispatch_h
#define ahd_Dispatch_h

#include <cstddef>

/// Code that is compiled several times, for processors with more or fewer instructions, and chosen
/// at run time. Each such function has a table of dispatch targets, one per instruction set; best()
/// is the last one that the processor can run. Results are the same on all, as predicates are exact
/// on all.
///
/// One function is compiled for a set by the compiler's attribute `target`. Whole source files are
/// compiled for it by one that defines AHD_TARGET, enables the instructions and only then includes
/// them: their namespace AHD_TARGET exists once for each set. It includes everything else before
/// that, so that no shared function is compiled for one set.
///
/// AHD_PORTABLE, defined when compiling, leaves all but the baseline out.
#ifndef AHD_TARGET
#define AHD_TARGET baseline
#endif

#if !defined(AHD_PORTABLE) && defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#define AHD_HAS_X86_TARGETS 1
#else
#define AHD_HAS_X86_TARGETS 0
#endif

/// Are there the instructions for two doubles at once, which every x86-64 processor has?
#if defined(__SSE2__) || defined(_M_X64)
#define AHD_HAS_X86_PAIRS 1
#else
#define AHD_HAS_X86_PAIRS 0
#endif

/// ALWAYS: for small functions of hot loops, and functions that must have the instruction set of
/// their caller. NEVER: for functions that hot loops seldom call, so that they take none of their
/// registers.
#if defined(__GNUC__) || defined(__clang__)
#define AHD_ALWAYS_INLINE inline __attribute__((always_inline))
#define AHD_NEVER_INLINE __attribute__((noinline))
#else
#define AHD_ALWAYS_INLINE inline
#define AHD_NEVER_INLINE
#endif

/// Before a function: compiled for these instructions (see InstructionSet), with vectors of full
/// width.
#if !AHD_HAS_X86_TARGETS
#define AHD_FOR_AVX2
#define AHD_FOR_AVX512
#elif defined(__clang__) // does not know the preference as an attribute
#define AHD_FOR_AVX2 __attribute__((target("avx2")))
#define AHD_FOR_AVX512 __attribute__((target("avx512f,avx512vl")))
#else
#define AHD_FOR_AVX2 __attribute__((target("avx2")))
#define AHD_FOR_AVX512 __attribute__((target("avx512f,avx512vl,prefer-vector-width=512")))
#endif

namespace ahd
{

/// Each has the instructions of those before it.
enum class InstructionSet
{
  Baseline, ///< the compiler's own target
  Avx2,     ///< AVX2 and fused multiply-adds
  Avx512    ///< AVX-512 F and VL
};

/// Can this processor run code that was compiled for the set?
inline bool processorHas(InstructionSet set)
{
#if AHD_HAS_X86_TARGETS
  static const bool kHasAvx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  static const bool kHasAvx512 = kHasAvx2 && __builtin_cpu_supports("avx512f") &&
    __builtin_cpu_supports("avx512vl");
  return set == InstructionSet::Baseline || (set == InstructionSet::Avx2 ? kHasAvx2 : kHasAvx512);
#else
  return set == InstructionSet::Baseline;
#endif
}

/// One of several functions that do the same.
template <typename Function>
struct DispatchTarget
{
  InstructionSet needs;
  Function* run;
};

/// @pre ascending instruction sets, from the baseline.
template <typename Function, std::size_t count>
Function* best(const DispatchTarget<Function> (&targets)[count])
{
  std::size_t last = count - 1;
  while (!processorHas(targets[last].needs))
  {
    --last;
  }
  return targets[last].run;
}

} // namespace ahd

#endif
