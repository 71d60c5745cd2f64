// SPDX-License-Identifier: BSD-3-Clause
#include "FilterArrays.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace ahd
{
namespace fuzz
{
namespace
{

vtkSmartPointer<vtkAbstractArray> readArray(ByteReader& bytes, vtkIdType points)
{
  const int types[] = { VTK_DOUBLE, VTK_FLOAT, VTK_UNSIGNED_CHAR, VTK_INT, VTK_LONG_LONG,
    VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_STRING, VTK_VARIANT, VTK_BIT, VTK_SIGNED_CHAR };
  const char* names[] = { "a", "b", "vtkGhostType", "Fate", "InsertionRank", "OriginalPointIds",
    "NumberOfTriangles", "Crossings", "Neighbors", nullptr };
  const std::uint8_t kind = bytes.byte();
  auto array = vtkSmartPointer<vtkAbstractArray>::Take(
    vtkAbstractArray::CreateArray(types[kind % std::size(types)]));
  array->SetName(names[bytes.byte() % std::size(names)]);
  const std::uint8_t shape = bytes.byte();
  const vtkIdType lengths[] = { points, points, points, points, points + 1, points - 1, 0, 1 };
  array->SetNumberOfComponents((shape >> 3) % 4 == 0 ? 1 : (shape >> 3) % 4);
  array->SetNumberOfTuples(std::max<vtkIdType>(0, lengths[shape % 8]));
  const unsigned factor = bytes.byte();
  const double first = bytes.coordinate();
  auto* numbers = vtkArrayDownCast<vtkDataArray>(array);
  auto* texts = vtkArrayDownCast<vtkStringArray>(array);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const vtkIdType value = i * array->GetNumberOfComponents() + c;
      const double given = first + double(factor * unsigned(value) >> 3 & 31u);
      if (numbers)
      {
        numbers->SetComponent(i, c, given);
      }
      else if (texts)
      {
        texts->SetValue(value, std::string(factor % 40u, 'x') + std::to_string(i));
      }
      else
      {
        array->SetVariantValue(value, factor % 2 == 0 ? vtkVariant(given) : vtkVariant("text"));
      }
    }
  }
  return array;
}

std::string textOf(vtkAbstractArray* array)
{
  std::string text = std::string(array->GetName() ? array->GetName() : "(none)") + " type " +
    std::to_string(array->GetDataType()) + " of " + std::to_string(array->GetNumberOfComponents()) +
    ":";
  auto* numbers = vtkArrayDownCast<vtkDataArray>(array);
  char word[40];
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const double value = numbers ? numbers->GetComponent(i, c) : 0.0;
      std::snprintf(word, sizeof word, std::isnan(value) ? " nan" : " %a", value);
      text += numbers
        ? std::string(word)
        : " '" + array->GetVariantValue(i * array->GetNumberOfComponents() + c).ToString() + "'";
    }
  }
  return text + "\n";
}
}

void addArrays(ByteReader& bytes, std::size_t count, vtkPointSet* set)
{
  vtkPointData* data = set->GetPointData();
  for (std::size_t k = 0; k < count; ++k)
  {
    const auto array = readArray(bytes, set->GetNumberOfPoints());
    const std::uint8_t role = bytes.byte();
    if (role == 255)
    {
      set->GetFieldData()->AddArray(array);
      continue;
    }
    const std::string name = array->GetName() ? array->GetName() : "";
    if (role >= 128 && !name.empty()) // added with another name: so a name may occur twice
    {
      array->SetName(("other" + std::to_string(k)).c_str());
    }
    const int index = data->AddArray(array);
    if (role % 4 == 1 && index >= 0)
    {
      data->SetActiveAttribute(index, role / 4 % vtkDataSetAttributes::NUM_ATTRIBUTES);
    }
    if (role >= 128 && !name.empty())
    {
      array->SetName(name.c_str());
    }
  }
}

void changeArrays(unsigned what, vtkPointSet* set)
{
  vtkPointData* data = set->GetPointData();
  if (data->GetNumberOfArrays() == 0)
  {
    return;
  }
  const int which = static_cast<int>(what / 4) % data->GetNumberOfArrays();
  vtkAbstractArray* array = data->GetAbstractArray(which);
  auto* numbers = vtkArrayDownCast<vtkDataArray>(array);
  if (what % 4 == 0)
  {
    data->RemoveArray(which);
  }
  else if (numbers && numbers->GetNumberOfTuples() > 0)
  {
    numbers->SetComponent(what % numbers->GetNumberOfTuples(), 0, double(what % 3));
    numbers->Modified();
  }
  data->Modified();
}

std::string textOf(vtkFieldData* data)
{
  std::string text;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    text += textOf(data->GetAbstractArray(i));
  }
  auto* attributes = vtkDataSetAttributes::SafeDownCast(data);
  for (int k = 0; attributes && k < vtkDataSetAttributes::NUM_ATTRIBUTES; ++k)
  {
    vtkAbstractArray* active = attributes->GetAbstractAttribute(k);
    text += active ? std::to_string(k) + (active->GetName() ? active->GetName() : "?") + " " : "";
  }
  return text + "\n";
}

} // namespace fuzz
} // namespace ahd
