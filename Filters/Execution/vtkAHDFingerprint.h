// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDFingerprint_h
#define vtkAHDFingerprint_h

#include "Engine/Core/Fingerprint.h"

class vtkAHDContext;
class vtkDataArray;

/// The fingerprint of an array's numbers, type and shape; null is a value of its own. Returns false
/// if the numbers are not contiguous in memory, or on an abort.
bool vtkAHDTakeFingerprint(
  vtkDataArray* array, const vtkAHDContext& context, ahd::Fingerprint& fingerprint);

#endif
