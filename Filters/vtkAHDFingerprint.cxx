// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAHDFingerprint.h"

#include "vtkAHDLoop.h"

#include "vtkDataArray.h"

#include <algorithm>
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

/// Adds up what becomes of each word at its place, in two ways. As the words do not wait for each
/// other, several threads may share them.
bool HashBytes(const unsigned char* bytes, std::size_t count, ahd::Executor& executor,
  vtkAHDProgress& progress, vtkAHDFingerprint& sums)
{
  constexpr std::size_t kWord = sizeof(std::uint64_t);
  std::mutex mutex;
  return vtkAHDLoop((count + kWord - 1) / kWord, executor, progress,
    [&](std::size_t begin, std::size_t end)
    {
      std::uint64_t plain = 0;
      std::uint64_t weighted = 0;
      for (std::size_t i = begin; i < end; ++i)
      {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes + i * kWord, std::min(kWord, count - i * kWord));
        word = Spread(word + i * 0x9E3779B97F4A7C15u);
        plain += word;
        weighted += word * (2 * i + 1);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      sums[0] += plain;
      sums[1] += weighted;
    });
}
}

bool vtkAHDTakeFingerprint(vtkDataArray* array, ahd::Executor& executor, vtkAHDProgress& progress,
  vtkAHDFingerprint& fingerprint)
{
  fingerprint = { { 0, 0 } };
  if (!array)
  {
    return true;
  }
  if (!array->HasStandardMemoryLayout())
  {
    return false;
  }
  const auto* bytes = static_cast<const unsigned char*>(array->GetVoidPointer(0));
  const std::size_t count = static_cast<std::size_t>(
    array->GetNumberOfValues() * array->GetDataTypeSize());
  if (!HashBytes(bytes, count, executor, progress, fingerprint))
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
