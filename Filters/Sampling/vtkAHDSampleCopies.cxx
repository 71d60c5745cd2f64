// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDSampleCopies.h"

#include "Pipeline/vtkAHDArray.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <type_traits>

namespace
{
constexpr std::size_t kPiece = std::size_t(1) << 14;

/// Do its numbers lie in memory, one after the other?
bool LiesInMemory(vtkDataArray* array)
{
  return array->HasStandardMemoryLayout() && array->GetDataType() != VTK_BIT;
}

template <typename Number>
void ReadAs(const Number* from, std::size_t count, double* to, const vtkAHDContext& context)
{
  context.ForRange(count,
    [from, to](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        to[i] = static_cast<double>(from[i]);
      }
    });
}

/// Arrays that VTK computes or keeps otherwise: on this thread.
void ReadOneByOne(vtkDataArray* array, std::size_t count, double* to, const vtkAHDContext& context)
{
  const std::size_t width = static_cast<std::size_t>(array->GetNumberOfComponents());
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i % kPiece == 0)
    {
      context.StopIfAborted();
    }
    array->GetTuple(static_cast<vtkIdType>(i), to + i * width);
  }
}

/// A number of an array of this type that stands for none.
template <typename Number>
Number NoValueOf(double value)
{
  return std::is_floating_point<Number>::value ? static_cast<Number>(value) : Number(0);
}

double WithinFloats(double value)
{
  constexpr double kMost = std::numeric_limits<float>::max();
  return std::isfinite(value) ? std::min(std::max(value, -kMost), kMost) : value;
}

/// Tuples of `width` numbers by ids; returns how many values of points are NaN.
template <typename Number>
std::size_t GatherNumbers(const Number* from, std::size_t width, Number* to,
  const vtkAHDGathered& gathered, const vtkAHDContext& context)
{
  std::atomic<std::size_t> missing{ 0 };
  const double value = std::is_same<Number, float>::value ? WithinFloats(gathered.NoValue)
                                                          : gathered.NoValue;
  const Number none = NoValueOf<Number>(value);
  context.ForRange(gathered.Count,
    [&](std::size_t begin, std::size_t end)
    {
      std::size_t odd = 0;
      for (std::size_t i = begin; i < end; ++i)
      {
        Number* const tuple = to + i * width;
        if (std::isnan(gathered.Ids[i]))
        {
          std::fill_n(tuple, width, none);
          continue;
        }
        const Number* const values = from + static_cast<std::size_t>(gathered.Ids[i]) * width;
        for (std::size_t c = 0; c < width; ++c)
        {
          const bool isNaN = values[c] != values[c];
          tuple[c] = isNaN ? none : values[c];
          odd += isNaN ? 1 : 0;
        }
      }
      missing += odd;
    });
  return missing;
}

/// The same of bits, through VTK's own interface.
void GatherBits(vtkDataArray* from, vtkDataArray* to, const vtkAHDGathered& gathered,
  const vtkAHDContext& context)
{
  for (std::size_t i = 0; i < gathered.Count; ++i)
  {
    if (i % kPiece == 0)
    {
      context.StopIfAborted();
    }
    const vtkIdType at = static_cast<vtkIdType>(i);
    if (!std::isnan(gathered.Ids[i]))
    {
      to->SetTuple(at, static_cast<vtkIdType>(gathered.Ids[i]), from);
      continue;
    }
    for (int c = 0; c < to->GetNumberOfComponents(); ++c)
    {
      to->SetComponent(at, c, 0.0);
    }
  }
}

/// Room for so many tuples, not initialised.
void Allocate(vtkDataArray* array, std::size_t count)
{
  const std::size_t numbers = count * static_cast<std::size_t>(array->GetNumberOfComponents());
  const std::size_t bytes = array->GetDataType() == VTK_BIT
    ? (numbers + 7) / 8
    : numbers * static_cast<std::size_t>(array->GetDataTypeSize());
  void* const memory = std::malloc(bytes > 0 ? bytes : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  constexpr int kFree = vtkAbstractArray::VTK_DATA_ARRAY_FREE;
  array->SetVoidArray(memory, static_cast<vtkIdType>(numbers), 0, kFree);
}

/// An array of this type with room for so many tuples as wide as those of another.
vtkSmartPointer<vtkDataArray> MakeLike(vtkDataArray* array, std::size_t count)
{
  auto made = vtkSmartPointer<vtkDataArray>::Take(LiesInMemory(array)
      ? array->NewInstance()
      : vtkDataArray::CreateDataArray(array->GetDataType()));
  made->SetNumberOfComponents(array->GetNumberOfComponents());
  Allocate(made, count);
  return made;
}

/// Takes the numbers of an array that has each component by itself; false for others.
template <typename Number>
bool TakeApart(vtkDataArray* array, Number* to, const vtkAHDContext& context)
{
  auto* const apart = vtkSOADataArrayTemplate<Number>::FastDownCast(array);
  const auto width = static_cast<std::size_t>(array->GetNumberOfComponents());
  if (apart)
  {
    context.ForRange(static_cast<std::size_t>(array->GetNumberOfTuples()),
      [=](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          apart->GetTypedTuple(static_cast<vtkIdType>(i), to + i * width);
        }
      });
  }
  return apart != nullptr;
}

/// The same numbers, of the same type, one after the other in memory; of types that VTK computes as
/// far as they are doubles.
vtkSmartPointer<vtkDataArray> InMemory(vtkDataArray* array, const vtkAHDContext& context)
{
  const vtkIdType count = array->GetNumberOfTuples();
  const vtkSmartPointer<vtkDataArray> copy = MakeLike(array, static_cast<std::size_t>(count));
  bool isTaken = false;
  switch (array->GetDataType())
  {
    vtkTemplateMacro(
      isTaken = TakeApart(array, static_cast<VTK_TT*>(copy->GetVoidPointer(0)), context));
  }
  for (vtkIdType i = 0; i < count && !isTaken; ++i)
  {
    if (static_cast<std::size_t>(i) % kPiece == 0)
    {
      context.StopIfAborted();
    }
    copy->SetTuple(i, i, array);
  }
  return copy;
}
}

bool vtkAHDIsCopiedToGather(vtkDataArray* array)
{
  return array->GetDataType() != VTK_BIT && !LiesInMemory(array);
}

const double* vtkAHDReadNumbers(
  vtkDataArray* array, ahd::UninitialisedVector<double>& copy, const vtkAHDContext& context)
{
  if (auto* doubles = vtkArrayDownCast<vtkDoubleArray>(array))
  {
    return doubles->GetPointer(0);
  }
  const std::size_t count = static_cast<std::size_t>(array->GetNumberOfValues());
  copy.resize(count);
  if (!LiesInMemory(array))
  {
    ReadOneByOne(array, static_cast<std::size_t>(array->GetNumberOfTuples()), copy.data(), context);
    return copy.data();
  }
  switch (array->GetDataType())
  {
    vtkTemplateMacro(
      ReadAs(static_cast<const VTK_TT*>(array->GetVoidPointer(0)), count, copy.data(), context));
  }
  return copy.data();
}

void vtkAHDFillNoValue(vtkDataArray* array, double value, const vtkAHDContext& context)
{
  if (std::isnan(value))
  {
    return;
  }
  double* const numbers = vtkArrayDownCast<vtkDoubleArray>(array)->GetPointer(0);
  context.ForRange(static_cast<std::size_t>(array->GetNumberOfValues()),
    [numbers, value](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        numbers[i] = std::isnan(numbers[i]) ? value : numbers[i];
      }
    });
}

vtkSmartPointer<vtkDataArray> vtkAHDAsFloats(vtkDataArray* doubles, const vtkAHDContext& context)
{
  const double* const from = vtkArrayDownCast<vtkDoubleArray>(doubles)->GetPointer(0);
  auto floats = vtkAHDNewArray<vtkFloatArray>(doubles->GetNumberOfValues());
  floats->SetNumberOfComponents(doubles->GetNumberOfComponents());
  float* const to = floats->GetPointer(0);
  context.ForRange(static_cast<std::size_t>(doubles->GetNumberOfValues()),
    [from, to](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        to[i] = static_cast<float>(WithinFloats(from[i]));
      }
    });
  return floats;
}

vtkSmartPointer<vtkDataArray> vtkAHDGather(vtkDataArray* from, const vtkAHDGathered& gathered,
  const vtkAHDContext& context, std::size_t& missing)
{
  if (vtkAHDIsCopiedToGather(from))
  {
    return vtkAHDGather(InMemory(from, context), gathered, context, missing);
  }
  const vtkSmartPointer<vtkDataArray> to = MakeLike(from, gathered.Count);
  const std::size_t width = static_cast<std::size_t>(from->GetNumberOfComponents());
  switch (from->GetDataType())
  {
    vtkTemplateMacro(missing += GatherNumbers(static_cast<const VTK_TT*>(from->GetVoidPointer(0)),
                       width, static_cast<VTK_TT*>(to->GetVoidPointer(0)), gathered, context));
    default:
      GatherBits(from, to, gathered, context);
  }
  return to;
}

vtkSmartPointer<vtkDataArray> vtkAHDGatherHeights(const double* heights,
  const vtkAHDGathered& gathered, const vtkAHDContext& context, std::size_t& missing)
{
  auto to = vtkAHDNewArray<vtkDoubleArray>(static_cast<vtkIdType>(gathered.Count));
  missing += GatherNumbers(heights, 1, to->GetPointer(0), gathered, context);
  return to;
}

void vtkAHDNameComponents(vtkDataArray* from, vtkDataArray* to)
{
  if (from->HasAComponentName())
  {
    to->CopyComponentNames(from);
  }
}
