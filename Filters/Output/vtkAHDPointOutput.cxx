// SPDX-License-Identifier: BSD-3-Clause
#include "Output/vtkAHDPointOutput.h"

#include "Engine/Job/SpacePoints.h"
#include "Input/vtkAHDInput.h"
#include "Pipeline/vtkAHDAttributes.h"
#include "Pipeline/vtkAHDContext.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace
{
/// Tuples written between two looks at whether the filter is to abort.
constexpr vtkIdType kPiece = vtkIdType(1) << 14;

/// Calls work(begin, end) for pieces of [0, count), one after the other, as VTK's arrays want it.
template <typename Work>
void InPieces(vtkIdType count, const vtkAHDContext& context, const Work& work)
{
  for (vtkIdType i = 0; i < count; i += kPiece)
  {
    context.StopIfAborted();
    work(i, std::min(count, i + kPiece));
  }
}

/// Copies the tuples [0, count) of `from` to `first` and following. One by one where both arrays
/// may lie component after component: of such, VTK 9.1 and 9.2 put ranges to where they come from.
void CopyTuples(vtkAbstractArray* array, vtkIdType first, vtkIdType count, vtkAbstractArray* from,
  const vtkAHDContext& context)
{
  InPieces(count, context,
    [&](vtkIdType begin, vtkIdType end)
    {
      if (first == 0 || array->HasStandardMemoryLayout())
      {
        array->InsertTuples(first + begin, end - begin, begin, from);
        return;
      }
      for (vtkIdType i = begin; i < end; ++i)
      {
        array->InsertTuple(first + i, i, from);
      }
    });
}

/// Is it one of whole numbers?
bool IsWhole(vtkDataArray* array)
{
  return array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
}

/// What points have that were added, and for which there is no other value.
double ValueOfAdded(vtkDataArray* array, bool areIds)
{
  if (areIds)
  {
    return array->GetDataTypeMin() < 0.0 ? -1.0 : 0.0;
  }
  return IsWhole(array) ? 0.0 : std::numeric_limits<double>::quiet_NaN();
}

/// Sets the tuples [first, end) to that.
void Clear(vtkAbstractArray* array, vtkIdType first, vtkIdType end, bool areIds,
  const vtkAHDContext& context)
{
  auto* numbers = vtkArrayDownCast<vtkDataArray>(array);
  if (!numbers) // strings and the like: they are empty from the beginning
  {
    return;
  }
  const double value = ValueOfAdded(numbers, areIds);
  InPieces(end - first, context,
    [&](vtkIdType a, vtkIdType b)
    {
      for (vtkIdType i = first + a; i < first + b; ++i)
      {
        for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
        {
          numbers->SetComponent(i, c, value);
        }
      }
    });
}

/// The closest value that an array of whole numbers can have; 0 for NaN.
double ToWhole(double value, vtkDataArray* array)
{
  const double least = array->GetDataTypeMin();
  const double most = array->GetDataTypeMax();
  // as a double, the largest number of 64 bits is one too large
  const double largest = most > 0x1p60 ? std::nextafter(most, 0.0) : most;
  return std::isnan(value) ? 0.0 : std::min(std::max(std::round(value), least), largest);
}

/// Like CopyTuples, into an array of whole numbers.
void CopyRounded(vtkDataArray* array, vtkIdType first, vtkIdType count, vtkDataArray* from,
  const vtkAHDContext& context)
{
  InPieces(count, context,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
        {
          array->SetComponent(first + i, c, ToWhole(from->GetComponent(i, c), array));
        }
      }
    });
}

bool IsInside(const ahd::SurfacePlace& place)
{
  return place.isInside();
}
bool IsInside(const ahd::CrossingOrigin&)
{
  return true;
}
bool IsInside(const ahd::SteinerPoint&)
{
  return true;
}

/// What linear interpolation gives at points that lie between others, from `first` on. Of one that
/// lies between such points the value is that of theirs before rounding.
template <typename Origin>
void InterpolateAt(vtkDataArray* array, const std::vector<Origin>& origins, vtkIdType first,
  const vtkAHDContext& context)
{
  const bool whole = IsWhole(array);
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  std::vector<double> exact(origins.size() * components);
  InPieces(static_cast<vtkIdType>(origins.size()), context,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        const Origin& origin = origins[static_cast<std::size_t>(k)];
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
        {
          const auto rowOf = [&](vtkIdType id)
          { return &exact[static_cast<std::size_t>(id - first) * components + std::size_t(c)]; };
          const auto valueAt = [&](vtkIdType id)
          { return id < first || id >= first + k ? array->GetComponent(id, c) : *rowOf(id); };
          double& value = *rowOf(first + k);
          value = array->GetComponent(first + k, c);
          if (IsInside(origin))
          {
            value = ahd::interpolate(origin, [&](ahd::Index id) { return valueAt(vtkIdType(id)); });
            array->SetComponent(first + k, c, whole ? ToWhole(value, array) : value);
          }
        }
      }
    });
}

/// Could a value of `from` be none that `array` can have?
bool MustBeRounded(vtkDataArray* array, vtkDataArray* from)
{
  const bool areLong = array->GetDataTypeSize() == 8 && IsWhole(from); // as doubles they are not
  return IsWhole(array) && array->GetDataType() != from->GetDataType() && !areLong;
}

/// Can values of `from` be put into `array`?
bool Fit(vtkAbstractArray* array, vtkAbstractArray* from)
{
  const bool numbers = vtkArrayDownCast<vtkDataArray>(array) &&
    vtkArrayDownCast<vtkDataArray>(from);
  return from && (numbers || array->GetDataType() == from->GetDataType()) &&
    array->GetNumberOfComponents() == from->GetNumberOfComponents();
}

/// Are they names of the points, global or pedigree ids?
bool AreIds(vtkPointData* data, vtkAbstractArray* array)
{
  return array == data->GetGlobalIds() || array == data->GetPedigreeIds();
}

bool IsGhostArray(vtkAbstractArray* array)
{
  const char* name = array->GetName();
  return name && std::strcmp(name, vtkDataSetAttributes::GhostArrayName()) == 0;
}

/// Point data with the arrays of others, but of so many points: write(array, from) fills in each.
template <typename Write>
void WriteLonger(vtkPointData* given, vtkIdType count, vtkPointData* output, const Write& write)
{
  vtkNew<vtkPointData> input;
  input->ShallowCopy(given);
  vtkAHDRemoveArraysOfOneName(input);
  vtkNew<vtkPointData> data;
  data->CopyAllOn(); // which of them are scalars, ids, normals ...
  data->CopyAllocate(input, count);
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    array->SetNumberOfTuples(count);
    write(array, input->GetAbstractArray(i));
  }
  // As such they would have to name each point.
  data->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  data->SetActiveAttribute(-1, vtkDataSetAttributes::PEDIGREEIDS);
  output->ShallowCopy(data);
}
}

vtkAHDPointOutput::vtkAHDPointOutput(
  const vtkAHDInput& input, const ahd::PreparedInput& points, vtkPointSet* data)
  : Opened(input.GetRequest())
  , Input(data ? data : input.GetInput())
  , Source(input.GetSourceOfPoints())
  , Points(points)
  , InputCount(static_cast<vtkIdType>(points.inputCount()))
  , SourceCount(this->Source ? this->Source->GetNumberOfPoints() : 0)
  , Count(static_cast<vtkIdType>(points.points().count))
{
}

std::size_t vtkAHDPointOutput::EstimateBytesPerPoint(vtkPointSet* input)
{
  std::size_t perPoint = 0;
  vtkPointData* data = input->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const int components = std::max(1, array->GetNumberOfComponents());
    const int bytes = array->IsNumeric() ? array->GetDataTypeSize() : 32; // an empty string
    perPoint += static_cast<std::size_t>(components) * static_cast<std::size_t>(std::max(1, bytes));
  }
  return perPoint;
}

std::size_t vtkAHDPointOutput::EstimateBytes(vtkPointSet* input, std::size_t pointCount)
{
  return pointCount * (3 * sizeof(double) + EstimateBytesPerPoint(input));
}

void vtkAHDPointOutput::WritePlaces(
  ahd::RunResult* means, vtkPolyData* output, const vtkAHDContext& context) const
{
  vtkSmartPointer<vtkDataArray> copy;
  const auto take = [&](auto&& array)
  {
    array->SetNumberOfComponents(3);
    copy = array;
    return array->GetPointer(0);
  };
  const auto sizeOf = [](std::size_t numbers) { return static_cast<vtkIdType>(numbers); };
  ahd::SpacePoints space([&](std::size_t numbers)
    { return take(context.NewArray<vtkDoubleArray>(sizeOf(numbers))); },
    [&](std::size_t numbers) { return take(context.NewArray<vtkFloatArray>(sizeOf(numbers))); });
  context.Check(space.make(this->Opened.points, this->Opened.sourcePoints, this->Points, context));
  if (means)
  {
    context.Check(space.showMeans(*means, context));
  }
  if (!copy)
  {
    output->SetPoints(this->Input->GetPoints());
    return;
  }
  vtkNew<vtkPoints> points;
  // floats that do not lie point after point were looked at as doubles
  if (this->Points.addedCount() == 0 && this->Input->GetPoints()->GetDataType() == VTK_FLOAT &&
    copy->GetDataType() != VTK_FLOAT)
  {
    vtkNew<vtkFloatArray> floats;
    floats->DeepCopy(copy);
    copy = floats;
  }
  points->SetData(copy);
  output->SetPoints(points);
}

void vtkAHDPointOutput::WriteData(vtkPointData* output, const vtkAHDContext& context) const
{
  if (this->Points.addedCount() == 0)
  {
    output->PassData(this->Input->GetPointData());
    return;
  }
  WriteLonger(this->Input->GetPointData(), this->Count, output,
    [&](vtkAbstractArray* array, vtkAbstractArray* from)
    { this->WriteArray(array, from, context); });
}

void vtkAHDPointOutput::AddRefined(vtkPointData* given, vtkIdType count,
  const std::vector<ahd::SteinerPoint>& added, vtkPointData* output, const vtkAHDContext& context)
{
  if (added.empty())
  {
    output->PassData(given);
    return;
  }
  const vtkIdType all = count + static_cast<vtkIdType>(added.size());
  WriteLonger(given, all, output,
    [&](vtkAbstractArray* array, vtkAbstractArray* from)
    {
      const vtkIdType known = std::min(count, from->GetNumberOfTuples());
      const bool areIds = AreIds(given, from);
      CopyTuples(array, 0, known, from, context);
      Clear(array, known, all, areIds, context);
      auto* numbers = vtkArrayDownCast<vtkDataArray>(array);
      if (numbers && !areIds && !IsGhostArray(array))
      {
        InterpolateAt(numbers, added, count, context);
      }
    });
}

void vtkAHDPointOutput::WriteArray(
  vtkAbstractArray* array, vtkAbstractArray* from, const vtkAHDContext& context) const
{
  const vtkIdType given = std::min(this->InputCount, from->GetNumberOfTuples());
  const bool areIds = AreIds(this->Input->GetPointData(), from);
  CopyTuples(array, 0, given, from, context);
  Clear(array, given, this->Count, areIds, context);
  if (areIds || IsGhostArray(array))
  {
    return;
  }
  vtkAbstractArray* more = this->Source && array->GetName()
    ? this->Source->GetPointData()->GetAbstractArray(array->GetName())
    : nullptr;
  auto* numbers = vtkArrayDownCast<vtkDataArray>(array);
  if (Fit(array, more))
  {
    const vtkIdType many = std::min(this->SourceCount, more->GetNumberOfTuples());
    auto* others = vtkArrayDownCast<vtkDataArray>(more);
    numbers&& MustBeRounded(numbers, others)
      ? CopyRounded(numbers, this->InputCount, many, others, context)
      : CopyTuples(array, this->InputCount, many, more, context);
  }
  if (numbers)
  {
    InterpolateAt(numbers, this->Points.surfacePlaces(), this->InputCount, context);
    InterpolateAt(numbers, this->Points.crossings(),
      static_cast<vtkIdType>(this->Points.firstCrossing()), context);
  }
}
