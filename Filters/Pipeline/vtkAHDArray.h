// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDArray_h
#define vtkAHDArray_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <cstdlib>
#include <new>

/// A VTK array of `count` numbers, one component, not initialised; throws std::bad_alloc. Allocates
/// by itself, because VTK's arrays, depending on how they were built, end the program if there is
/// no memory.
template <typename Array>
vtkSmartPointer<Array> vtkAHDNewArray(vtkIdType count)
{
  using Value = typename Array::ValueType;
  const std::size_t bytes = static_cast<std::size_t>(count) * sizeof(Value);
  auto* values = static_cast<Value*>(std::malloc(bytes > 0 ? bytes : 1));
  if (!values)
  {
    throw std::bad_alloc();
  }
  auto array = vtkSmartPointer<Array>::New();
  array->SetArray(values, count, 0, Array::VTK_DATA_ARRAY_FREE);
  return array;
}

/// Resizes an array of vtkAHDNewArray() to `count` numbers and keeps its first ones. Large arrays
/// are not copied if the system can move their pages. Throws
/// std::bad_alloc, and leaves it as it was.
template <typename Array>
void vtkAHDResizeArray(Array* array, vtkIdType count)
{
  using Value = typename Array::ValueType;
  constexpr int kFree = Array::VTK_DATA_ARRAY_FREE;
  Value* values = array->GetPointer(0);
  const vtkIdType before = array->GetNumberOfValues();
  const std::size_t bytes = static_cast<std::size_t>(count) * sizeof(Value);
  array->SetArray(values, before, 1); // it is not to free what realloc() has freed
  void* resized = std::realloc(values, bytes > 0 ? bytes : 1);
  array->SetArray(
    static_cast<Value*>(resized ? resized : values), resized ? count : before, 0, kFree);
  if (!resized)
  {
    throw std::bad_alloc();
  }
}

#endif
