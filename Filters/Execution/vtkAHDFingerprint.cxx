// SPDX-License-Identifier: BSD-3-Clause
#include "Execution/vtkAHDFingerprint.h"

#include "Pipeline/vtkAHDContext.h"

#include "vtkDataArray.h"

#include <cstddef>
#include <cstring>
#include <mutex>

namespace
{
/// Spreads every bit over all; a bijection.
std::uint64_t Spread(std::uint64_t word)
{
  word ^= word >> 32;
  word *= 0xD6E8FEB86659FD93u;
  word ^= word >> 32;
  word *= 0xC2B2AE3D27D4EB4Fu;
  return word ^ (word >> 32);
}

/// Adds up what becomes of each word at its place, in two ways: as it is, and an odd number of
/// times, which is smaller by two for the next word. As the words do not wait for each other,
/// several threads may share them.
bool HashBytes(const unsigned char* bytes, std::size_t count, const vtkAHDContext& context,
  vtkAHDFingerprint& sums)
{
  constexpr std::size_t kWord = sizeof(std::uint64_t);
  const std::size_t words = count / kWord;
  std::mutex mutex;
  const auto at = [](std::uint64_t word, std::size_t i)
  { return Spread(word + i * 0x9E3779B97F4A7C15u); };
  std::uint64_t rest = 0; // what fills no word
  for (std::size_t i = words * kWord; i < count; ++i)
  {
    rest = rest << 8 | bytes[i];
  }
  sums = { { at(rest, words), at(rest, words) } };
  return context.TryRange(words,
    [&](std::size_t begin, std::size_t end)
    {
      std::uint64_t plain = 0;
      std::uint64_t weighted = 0;
      for (std::size_t i = begin; i < end; ++i)
      {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes + i * kWord, kWord);
        plain += at(word, i);
        weighted += plain;
      }
      weighted = 2 * weighted + plain * (2 * (words - end) + 1);
      const std::lock_guard<std::mutex> lock(mutex);
      sums[0] += plain;
      sums[1] += weighted;
    });
}
}

bool vtkAHDTakeFingerprint(
  vtkDataArray* array, const vtkAHDContext& context, vtkAHDFingerprint& fingerprint)
{
  fingerprint = { { 0, 0 } };
  if (!array)
  {
    return true;
  }
  if (!array->HasStandardMemoryLayout() || array->GetDataTypeSize() == 0) // bits have no size
  {
    return false;
  }
  const auto* bytes = static_cast<const unsigned char*>(array->GetVoidPointer(0));
  const std::size_t count = static_cast<std::size_t>(
    array->GetNumberOfValues() * array->GetDataTypeSize());
  if (!HashBytes(bytes, count, context, fingerprint))
  {
    return false;
  }
  const std::uint64_t shape = Spread(count) + std::uint64_t(array->GetNumberOfComponents()) * 256 +
    std::uint64_t(array->GetDataType());
  for (std::uint64_t& half : fingerprint)
  {
    half = Spread(Spread(half) + shape) | 1; // never that of no array
  }
  return true;
}
