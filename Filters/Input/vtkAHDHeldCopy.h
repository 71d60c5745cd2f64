// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDHeldCopy_h
#define vtkAHDHeldCopy_h

#include "vtkSmartPointer.h"

class vtkPointSet;
class vtkPolyData;

/// The same points, point data and, of a vtkPolyData, cells and field data, in objects of its own
/// that share the arrays: it keeps all its arrays even if the other's objects are changed. The
/// memory of arrays is not held: replacing it affects all objects that share the array
/// (vtkBuffer). Null for null.
vtkSmartPointer<vtkPolyData> vtkAHDHeldCopy(vtkPointSet* data);

/// Gives a shallow copy, if there is one, a vtkPoints of its own, which shares the array.
void vtkAHDOwnPoints(vtkPointSet* copy);

#endif
