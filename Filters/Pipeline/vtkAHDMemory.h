// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDMemory_h
#define vtkAHDMemory_h

#include "vtkType.h"

/// Kibibytes that this process can still get without swapping: the least of what the machine has
/// available and what the limits on this process leave (address space; on Linux the memory limit of
/// a container as well).
vtkTypeInt64 vtkAHDAvailableMemory();

#endif
