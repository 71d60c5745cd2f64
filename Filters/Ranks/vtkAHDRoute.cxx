// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRoute.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <string>
#include <vector>

namespace
{
/// The array, tuple after tuple in memory, converted if it must be; bits become bytes.
vtkSmartPointer<vtkDataArray> InMemory(vtkAbstractArray* array)
{
  vtkSmartPointer<vtkDataArray> data = vtkArrayDownCast<vtkDataArray>(array);
  const bool areBits = data->GetDataType() == VTK_BIT;
  if (data->HasStandardMemoryLayout() && !areBits)
  {
    return data;
  }
  vtkSmartPointer<vtkDataArray> copy;
  copy.TakeReference(
    vtkDataArray::CreateDataArray(areBits ? VTK_UNSIGNED_CHAR : data->GetDataType()));
  copy->DeepCopy(data);
  return copy;
}

std::size_t WidthOf(vtkDataArray* array)
{
  return static_cast<std::size_t>(array->GetNumberOfComponents()) *
    static_cast<std::size_t>(array->GetDataTypeSize());
}

unsigned char* BytesOf(vtkDataArray* array, std::size_t tuple)
{
  return static_cast<unsigned char*>(array->GetVoidPointer(0)) + tuple * WidthOf(array);
}
}

bool vtkAHDRoute::CanMove(vtkAbstractArray* array)
{
  return vtkArrayDownCast<vtkDataArray>(array) || vtkArrayDownCast<vtkStringArray>(array);
}

void vtkAHDRoute::Move(vtkAbstractArray* from, vtkAbstractArray* to, std::size_t first)
{
  if (vtkArrayDownCast<vtkStringArray>(to))
  {
    this->MoveStrings(from, to, first);
    return;
  }
  vtkSmartPointer<vtkDataArray> source, target;
  this->Ranks.Together(this->Context,
    [&]
    {
      source = InMemory(from);
      target = InMemory(to);
    });
  this->Context.Check(this->move(BytesOf(source, 0), WidthOf(source), BytesOf(target, first)));
  if (target != to) // bits
  {
    auto* bits = vtkArrayDownCast<vtkDataArray>(to);
    const auto end = static_cast<vtkIdType>(first + this->count());
    for (auto i = static_cast<vtkIdType>(first); i < end; ++i)
    {
      for (int c = 0; c < to->GetNumberOfComponents(); ++c)
      {
        bits->SetComponent(i, c, target->GetComponent(i, c));
      }
    }
  }
}

void vtkAHDRoute::MoveStrings(vtkAbstractArray* from, vtkAbstractArray* to, std::size_t first)
{
  auto* strings = vtkArrayDownCast<vtkStringArray>(from);
  auto* moved = vtkArrayDownCast<vtkStringArray>(to);
  const int width = to->GetNumberOfComponents();
  const auto read = [&](std::size_t tuple)
  {
    std::vector<std::string> texts;
    for (int c = 0; c < width; ++c)
    {
      texts.push_back(strings->GetValue(static_cast<vtkIdType>(tuple) * width + c));
    }
    return texts;
  };
  const auto put = [&](std::size_t place, const std::vector<std::string>& texts)
  {
    for (int c = 0; c < width; ++c)
    {
      moved->SetValue(
        static_cast<vtkIdType>(first + place) * width + c, texts[static_cast<std::size_t>(c)]);
    }
  };
  this->Context.Check(this->moveItems<std::vector<std::string>>(read, put));
}
