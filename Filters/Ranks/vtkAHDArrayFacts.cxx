// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDArrayFacts.h"

#include "Pipeline/vtkAHDArray.h"

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <cstdint>
#include <new>

void vtkAHDWriteText(ahd::BytesWriter& writer, const std::string& text)
{
  writer.writeAll(std::vector<char>(text.begin(), text.end()));
}

std::string vtkAHDReadText(ahd::BytesReader& reader)
{
  std::vector<char> text;
  reader.readAll(text);
  return std::string(text.begin(), text.end());
}

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

void vtkAHDArrayFacts::Write(ahd::BytesWriter& writer) const
{
  vtkAHDWriteText(writer, this->Name);
  const int shape[] = { this->Type, this->Components, this->Attribute };
  writer.write(shape);
  writer.write(std::uint64_t(this->ComponentNames.size()));
  for (const std::string& name : this->ComponentNames)
  {
    vtkAHDWriteText(writer, name);
  }
}

void vtkAHDArrayFacts::Read(ahd::BytesReader& reader)
{
  this->Name = vtkAHDReadText(reader);
  this->Type = reader.read<int>();
  this->Components = reader.read<int>();
  this->Attribute = reader.read<int>();
  for (auto count = reader.read<std::uint64_t>(); count > 0; --count)
  {
    this->ComponentNames.push_back(vtkAHDReadText(reader));
  }
}
