// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDArrayFacts.h"

#include "Pipeline/vtkAHDArray.h"

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <new>

vtkSmartPointer<vtkDataArray> vtkAHDMakePlaces(std::size_t count, bool areFloats)
{
  const auto numbers = static_cast<vtkIdType>(3 * count);
  vtkSmartPointer<vtkDataArray> places;
  if (areFloats)
  {
    places = vtkAHDNewArray<vtkFloatArray>(numbers);
  }
  else
  {
    places = vtkAHDNewArray<vtkDoubleArray>(numbers);
  }
  places->SetNumberOfComponents(3);
  return places;
}

vtkSmartPointer<vtkDataArray> vtkAHDPlacesOf(vtkPoints* points, bool areFloats)
{
  if (points && points->GetDataType() == (areFloats ? VTK_FLOAT : VTK_DOUBLE))
  {
    return points->GetData();
  }
  vtkSmartPointer<vtkDataArray> places = vtkAHDMakePlaces(0, areFloats);
  if (points)
  {
    places->DeepCopy(points->GetData());
  }
  return places;
}

ahd::PointView vtkAHDViewOf(vtkDataArray* places, std::size_t count)
{
  auto* floats = vtkArrayDownCast<vtkFloatArray>(places);
  return floats ? ahd::PointView(floats->GetPointer(0), count, 3)
                : ahd::PointView(vtkArrayDownCast<vtkDoubleArray>(places)->GetPointer(0), count, 3);
}

vtkAHDArrayFacts::vtkAHDArrayFacts(vtkDataSetAttributes* data, int index)
{
  vtkAbstractArray* array = data->GetAbstractArray(index);
  this->Name = array->GetName() ? array->GetName() : "";
  this->Type = array->GetDataType();
  this->Components = array->GetNumberOfComponents();
  this->Attribute = data->IsArrayAnAttribute(index);
  for (int c = 0; c < this->Components && array->HasAComponentName(); ++c)
  {
    const char* name = array->GetComponentName(c);
    this->ComponentNames.push_back(name ? name : "");
  }
}

vtkSmartPointer<vtkAbstractArray> vtkAHDArrayFacts::Make(std::size_t count) const
{
  auto array = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(this->Type));
  array->SetName(this->Name.c_str());
  array->SetNumberOfComponents(this->Components);
  for (std::size_t c = 0; c < this->ComponentNames.size(); ++c)
  {
    if (!this->ComponentNames[c].empty())
    {
      array->SetComponentName(static_cast<vtkIdType>(c), this->ComponentNames[c].c_str());
    }
  }
  const auto tuples = static_cast<vtkIdType>(count);
  if (count > 0 && !array->Allocate(tuples * this->Components))
  {
    throw std::bad_alloc();
  }
  array->SetNumberOfTuples(tuples);
  return array;
}

void vtkAHDArrayFacts::AddTo(vtkDataSetAttributes* data, vtkAbstractArray* array) const
{
  const int index = data->AddArray(array);
  if (this->Attribute >= 0)
  {
    data->SetActiveAttribute(index, this->Attribute);
  }
}
