// SPDX-License-Identifier: BSD-3-Clause
#include "HilbertKeys.h"

#include "../Core/Dispatch.h"

namespace ahd
{

namespace
{

using Word = std::uint32_t; ///< a bit per level, the coarsest in the highest

/// A gene (HilbertCurve.h) is two bits, t (transposed) and f (turned). The quarter (x, y) of a box
/// with this gene has, with a = x ^ y and "not y" written y',
///
///     digit:       2 u + a,  u = x ^ t a ^ f
///     gene below:  t1 = a' t ^ f ^ y',   f1 = a t ^ a' f ^ a y'
///
/// as geneOfQuarter changes t where u ^ a = 0, and f too where u = 1 besides. That is an affine map
/// of (t, f) over the field of two elements, so the genes of all 32 levels are a prefix product of
/// maps, and five doubling steps on whole words give it.
struct Maps
{
  Word tt, tf, ft, ff; ///< t1 = tt t ^ tf f ^ t, f1 = ft t ^ ff f ^ f
  Word t, f;
};

AHD_ALWAYS_INLINE Maps mapsOf(Word x, Word y)
{
  const Word a = x ^ y;
  return { ~a, ~Word(0), a, ~a, ~y, a & ~y };
}

/// Each level's map after that of `kLevels` levels above; beyond the top is the identity.
template <unsigned kLevels>
AHD_ALWAYS_INLINE Maps afterThoseAbove(const Maps& m)
{
  constexpr Word kTop = ~(~Word(0) >> kLevels);
  const Word tt = m.tt >> kLevels | kTop, ff = m.ff >> kLevels | kTop;
  const Word tf = m.tf >> kLevels, ft = m.ft >> kLevels;
  const Word t = m.t >> kLevels, f = m.f >> kLevels;
  return { (m.tt & tt) ^ (m.tf & ft), (m.tt & tf) ^ (m.tf & ff), (m.ft & tt) ^ (m.ff & ft),
    (m.ft & tf) ^ (m.ff & ff), m.t ^ (m.tt & t) ^ (m.tf & f), m.f ^ (m.ft & t) ^ (m.ff & f) };
}

/// The high bits of all 32 digits; the low ones are x ^ y.
AHD_ALWAYS_INLINE Word highBits(Word x, Word y)
{
  const Maps all = afterThoseAbove<16>(
    afterThoseAbove<8>(afterThoseAbove<4>(afterThoseAbove<2>(afterThoseAbove<1>(mapsOf(x, y))))));
  // The curve starts with gene 0, so the gene of a level is what the maps above it add.
  const Word t = all.t >> 1, f = all.f >> 1;
  return x ^ (t & (x ^ y)) ^ f;
}

/// The bits of a word at the even places of a number twice as long.
AHD_ALWAYS_INLINE std::uint64_t spread(std::uint64_t w)
{
  w = (w | w << 16) & 0x0000FFFF0000FFFFu;
  w = (w | w << 8) & 0x00FF00FF00FF00FFu;
  w = (w | w << 4) & 0x0F0F0F0F0F0F0F0Fu;
  w = (w | w << 2) & 0x3333333333333333u;
  return (w | w << 1) & 0x5555555555555555u;
}

AHD_ALWAYS_INLINE void keysOf(
  const Word* columns, const Word* rows, std::uint64_t* keys, std::size_t count)
{
  Word high[kKeyBlock];
  for (std::size_t i = 0; i < count; ++i)
  {
    high[i] = highBits(columns[i], rows[i]);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    keys[i] = spread(high[i]) << 1 | spread(columns[i] ^ rows[i]);
  }
}

void keysBaseline(const Word* columns, const Word* rows, std::uint64_t* keys, std::size_t count)
{
  keysOf(columns, rows, keys, count);
}

AHD_FOR_AVX2 void keysAvx2(
  const Word* columns, const Word* rows, std::uint64_t* keys, std::size_t count)
{
  keysOf(columns, rows, keys, count);
}

AHD_FOR_AVX512 void keysAvx512(
  const Word* columns, const Word* rows, std::uint64_t* keys, std::size_t count)
{
  keysOf(columns, rows, keys, count);
}

} // namespace

const DispatchTarget<HilbertKeys> kHilbertKeysTargets[3] = {
  { InstructionSet::Baseline, keysBaseline },
  { InstructionSet::Avx2, keysAvx2 },
  { InstructionSet::Avx512, keysAvx512 },
};

void hilbertKeys(
  const std::uint32_t* columns, const std::uint32_t* rows, std::uint64_t* keys, std::size_t count)
{
  static HilbertKeys* const kBest = best(kHilbertKeysTargets);
  kBest(columns, rows, keys, count);
}

} // namespace ahd
