// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDAttributes_h
#define vtkAHDAttributes_h

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"

#include <cstring>

/// Adds the array in place of one that has its name, which ceases to be normals, ids or whatever
/// else it was: what VTK expects of these may not be true of the new one.
inline void vtkAHDReplaceArray(vtkDataSetAttributes* data, vtkAbstractArray* array)
{
  data->RemoveArray(array->GetName());
  data->AddArray(array);
}

/// Of several arrays of one name (each got it after it was added) only the last stays, as it does
/// where VTK passes them on.
inline void vtkAHDRemoveArraysOfOneName(vtkDataSetAttributes* data)
{
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    const char* name = data->GetArrayName(i);
    for (int k = i - 1; k >= 0 && name; --k)
    {
      const char* other = data->GetArrayName(k);
      if (other && std::strcmp(name, other) == 0)
      {
        data->RemoveArray(k);
        --i;
      }
    }
  }
}

#endif
