// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Fingerprint_h
#define ahd_Fingerprint_h

#include "Prefetch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace ahd
{

/// 128 bits that differ for different bytes; collisions are negligible.
using Fingerprint = std::array<std::uint64_t, 2>;

/// Computes the fingerprint of bytes: two sums of the words, each hashed with its position; one is
/// plain, one is weighted by descending odd factors. Words are independent, so several threads may
/// share them: one FingerprintSum each, then added up.
class FingerprintSum
{
public:
  static constexpr std::size_t kWord = sizeof(std::uint64_t);
  static constexpr std::size_t kWordsAhead = 128; ///< prefetched: some processors prefetch too few

  /// Adds the words [begin, end) of so many words at `bytes`.
  void add(const unsigned char* bytes, std::size_t begin, std::size_t end, std::size_t words)
  {
    std::uint64_t plain = 0;
    std::uint64_t weighted = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      std::uint64_t word = 0;
      prefetchForRead(bytes + (i + kWordsAhead) * kWord);
      std::memcpy(&word, bytes + i * kWord, kWord);
      plain += at(word, i);
      weighted += plain;
    }
    sums_[0] += plain;
    sums_[1] += 2 * weighted + plain * (2 * (words - end) + 1);
  }

  void add(const FingerprintSum& other)
  {
    sums_[0] += other.sums_[0];
    sums_[1] += other.sums_[1];
  }

  /// The fingerprint of all words, of the bytes after them, and of a number that distinguishes
  /// equal bytes of different kinds. Never { 0, 0 }.
  Fingerprint finish(const unsigned char* bytes, std::size_t count, std::uint64_t kind) const
  {
    const std::size_t words = count / kWord;
    std::uint64_t rest = 0; // the bytes after the last word
    for (std::size_t i = words * kWord; i < count; ++i)
    {
      rest = rest << 8 | bytes[i];
    }
    const std::uint64_t shape = spread(count) + kind;
    return { { spread(spread(sums_[0] + at(rest, words)) + shape) | 1,
      spread(spread(sums_[1] + at(rest, words)) + shape) | 1 } };
  }

private:
  /// Lets every bit affect all others; a bijection.
  static std::uint64_t spread(std::uint64_t word)
  {
    word ^= word >> 32;
    word *= 0xD6E8FEB86659FD93u;
    word ^= word >> 32;
    word *= 0xC2B2AE3D27D4EB4Fu;
    return word ^ (word >> 32);
  }
  static std::uint64_t at(std::uint64_t word, std::size_t i)
  {
    return spread(word + i * 0x9E3779B97F4A7C15u);
  }

  Fingerprint sums_ = { { 0, 0 } };
};

} // namespace ahd

#endif
