// SPDX-License-Identifier: BSD-3-Clause
#include "ExactSum.h"

#if defined(__GNUC__) || defined(__clang__)
#define AHD_ALWAYS_INLINE inline __attribute__((always_inline))
#else
#define AHD_ALWAYS_INLINE inline
#endif

namespace ahd
{

namespace
{

AHD_ALWAYS_INLINE void addAll(const SumTerms& terms, SumParts& parts)
{
  // Adding and subtracting a large number leaves the term rounded to that number's last place.
  constexpr double kLarge[3] = { 0x1.8p28, 0x1.8p3, 0x1.8p-22 };
  SumTerms rest = terms; // a copy: no pointer to it, so the loops are free of doubts
  for (std::size_t k = 0; k < 3; ++k)
  {
    double* const sums = parts[k].data();
    const double large = kLarge[k];
    for (std::size_t lane = 0; lane < kSumLanes; ++lane)
    {
      const double part = (rest[lane] + large) - large;
      sums[lane] += part;
      rest[lane] -= part;
    }
  }
}

void addBaseline(const SumTerms& terms, SumParts& parts)
{
  addAll(terms, parts);
}

#if AHD_HAS_X86_TARGETS
#if defined(__clang__) // does not know the preference as an attribute
#define AHD_AVX512 "avx512f,avx512vl"
#else
#define AHD_AVX512 "avx512f,avx512vl,prefer-vector-width=512"
#endif

__attribute__((target("avx2"))) void addAvx2(const SumTerms& terms, SumParts& parts)
{
  addAll(terms, parts);
}

__attribute__((target(AHD_AVX512))) void addAvx512(const SumTerms& terms, SumParts& parts)
{
  addAll(terms, parts);
}
#else
const auto addAvx2 = addBaseline;
const auto addAvx512 = addBaseline;
#endif

} // namespace

const DispatchTarget<AddTerms> kAddTermsTargets[3] = {
  { InstructionSet::Baseline, addBaseline },
  { InstructionSet::Avx2, addAvx2 },
  { InstructionSet::Avx512, addAvx512 },
};

void addTerms(const SumTerms& terms, SumParts& parts)
{
  static AddTerms* const kBest = best(kAddTermsTargets);
  kBest(terms, parts);
}

} // namespace ahd
