// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDWatchedArrays_h
#define vtkAHDWatchedArrays_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataObject;
class vtkFieldData;

/// Arrays that an execution reads, and where their numbers lie: that memory cannot be held, only
/// looked for. Holds the arrays.
class vtkAHDWatchedArrays
{
public:
  /// Points, cells of lines and polygons, and attributes of a data set, or of the blocks of a
  /// composite one. Null has none. Throws std::bad_alloc.
  void Add(vtkDataObject* data);

  /// Have all the memory and the size that they had?
  bool AreInPlace() const;

private:
  struct Place
  {
    explicit Place(vtkDataArray* array);

    vtkSmartPointer<vtkDataArray> Array;
    const void* At; // null: it is asked for each number
    vtkIdType Size;
  };

  void Add(vtkFieldData* arrays);
  void Add(vtkDataArray* array);

  std::vector<Place> Places;
};

#endif
