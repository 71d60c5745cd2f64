// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDFingerprint_h
#define vtkAHDFingerprint_h

#include <array>
#include <cstdint>

class vtkAHDContext;
class vtkDataArray;

/// 128 bits that differ for different bytes, with a probability that need not be counted with.
using vtkAHDFingerprint = std::array<std::uint64_t, 2>;

/// That of an array's numbers, type and shape; of no array, if null. Returns false if the numbers
/// do not lie in memory one after the other, or if the filter is to abort.
bool vtkAHDTakeFingerprint(
  vtkDataArray* array, const vtkAHDContext& context, vtkAHDFingerprint& fingerprint);

#endif
