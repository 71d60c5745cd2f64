// SPDX-License-Identifier: BSD-3-Clause
#include "Execution/vtkAHDFingerprint.h"

#include "Pipeline/vtkAHDContext.h"

#include "vtkDataArray.h"

#include <mutex>

bool vtkAHDTakeFingerprint(
  vtkDataArray* array, const vtkAHDContext& context, ahd::Fingerprint& fingerprint)
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
  const std::size_t words = count / ahd::FingerprintSum::kWord;
  ahd::FingerprintSum sum;
  std::mutex mutex;
  const bool all = context.TryRange(words,
    [&](std::size_t begin, std::size_t end)
    {
      ahd::FingerprintSum piece;
      piece.add(bytes, begin, end, words);
      const std::lock_guard<std::mutex> lock(mutex);
      sum.add(piece);
    });
  fingerprint = sum.finish(bytes, count,
    std::uint64_t(array->GetNumberOfComponents()) * 256 + std::uint64_t(array->GetDataType()));
  return all;
}
