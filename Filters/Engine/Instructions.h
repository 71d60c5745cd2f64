// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Instructions_h
#define ahd_Instructions_h

/// Code that is compiled several times, for processors that know more or fewer instructions.
///
/// What stands in the namespace AHD_INSTRUCTIONS exists once for each: `baseline`, and where the
/// compiler can (GCC and Clang for x86-64) `fma`, for AVX2 and fused multiply-adds. A source file
/// of a flavour other than the baseline defines AHD_INSTRUCTIONS, asks the compiler for the
/// instructions and only then includes such code; everything else it includes before, so that no
/// function shared by all is compiled for some. What is run is decided at run time, once per call
/// of the engine. Results are the same on all, as predicates are exact on all.
///
/// AHD_PORTABLE, defined when compiling, leaves all but the baseline out.
#ifndef AHD_INSTRUCTIONS
#define AHD_INSTRUCTIONS baseline
#endif

#if !defined(AHD_PORTABLE) && defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#define AHD_HAS_FMA_FLAVOUR 1
#else
#define AHD_HAS_FMA_FLAVOUR 0
#endif

namespace ahd
{

/// Does this processor know what the flavour `fma` needs?
inline bool processorHasFma()
{
#if AHD_HAS_FMA_FLAVOUR
  static const bool kHas = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return kHas;
#else
  return false;
#endif
}

} // namespace ahd

#endif
