// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkAHDWatchedArrays.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkAHDWatchedArrays::Place::Place(vtkDataArray* array)
  : Array(array)
  , At(array->HasStandardMemoryLayout() ? array->GetVoidPointer(0) : nullptr)
  , Size(array->GetNumberOfValues())
{
}

void vtkAHDWatchedArrays::Add(vtkDataObject* data)
{
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    {
      this->Add(each->GetCurrentDataObject());
    }
    return;
  }
  if (auto* points = vtkPointSet::SafeDownCast(data))
  {
    this->Add(points->GetPoints() ? points->GetPoints()->GetData() : nullptr);
  }
  if (auto* cells = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* some : { cells->GetLines(), cells->GetPolys() })
    {
      this->Add(some->GetConnectivityArray());
      this->Add(some->GetOffsetsArray());
    }
  }
  for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    this->Add(data ? data->GetAttributesAsFieldData(type) : nullptr);
  }
}

void vtkAHDWatchedArrays::Add(vtkFieldData* arrays)
{
  for (int i = 0; arrays && i < arrays->GetNumberOfArrays(); ++i)
  {
    this->Add(arrays->GetArray(i));
  }
}

void vtkAHDWatchedArrays::Add(vtkDataArray* array)
{
  if (array)
  {
    this->Places.emplace_back(array);
  }
}

bool vtkAHDWatchedArrays::AreInPlace() const
{
  return std::all_of(this->Places.begin(), this->Places.end(),
    [](const Place& place)
    {
      const Place now(place.Array);
      return now.At == place.At && now.Size == place.Size;
    });
}
