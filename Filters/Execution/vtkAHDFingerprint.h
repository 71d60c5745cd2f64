// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDFingerprint_h
#define vtkAHDFingerprint_h

#include "Engine/Core/Fingerprint.h"

class vtkAHDContext;
class vtkDataArray;

/// That of an array's numbers, type and shape; of no array, if null. Returns false if the numbers
/// do not lie in memory one after the other, or if the filter is to abort.
bool vtkAHDTakeFingerprint(
  vtkDataArray* array, const vtkAHDContext& context, ahd::Fingerprint& fingerprint);

#endif
