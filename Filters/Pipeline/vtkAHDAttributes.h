// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDAttributes_h
#define vtkAHDAttributes_h

#include "Pipeline/vtkAHDArray.h"
#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"

#include <cstring>

/// Replaces an array of the same name. The new one is no active attribute (normals, ids, ...), as
/// it may not satisfy what VTK requires of these.
inline void vtkAHDReplaceArray(vtkDataSetAttributes* data, vtkAbstractArray* array)
{
  data->RemoveArray(array->GetName());
  data->AddArray(array);
}

/// Adds a number as an array of one value. Throws std::bad_alloc.
inline void vtkAHDAddCount(const char* name, vtkIdType count, vtkFieldData* data)
{
  auto array = vtkAHDNewArray<vtkIdTypeArray>(1);
  array->SetName(name);
  array->SetValue(0, count);
  data->AddArray(array);
}

/// Of several arrays with one name (set after they were added) only the last stays, as when VTK
/// passes them on.
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
