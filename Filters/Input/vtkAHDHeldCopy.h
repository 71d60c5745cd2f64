// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDHeldCopy_h
#define vtkAHDHeldCopy_h

#include "vtkSmartPointer.h"

class vtkPointSet;
class vtkPolyData;

/// The same points, point data and, of a vtkPolyData, cells and field data, in objects of its own
/// that share the arrays: whatever is done to the other's objects meanwhile, this has all arrays
/// that it had. Their memory is not held: who gives an array other memory takes it from all that
/// share it (vtkBuffer). Null for null.
vtkSmartPointer<vtkPolyData> vtkAHDHeldCopy(vtkPointSet* data);

/// Gives a shallow copy, if there is one, a vtkPoints of its own, which shares the array.
void vtkAHDOwnPoints(vtkPointSet* copy);

#endif
