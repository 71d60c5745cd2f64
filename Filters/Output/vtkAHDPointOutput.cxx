// SPDX-License-Identifier: BSD-3-Clause
#include "Output/vtkAHDPointOutput.h"

#include "Input/vtkAHDWorkingPoints.h"
#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDLoop.h"
#include "Pipeline/vtkAHDNamesakes.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{
/// Tuples copied between two looks at whether the filter is to abort.
constexpr vtkIdType kPiece = vtkIdType(1) << 14;

/// Copies the tuples [0, count) of `from` to `first` and following. Returns false if the filter is
/// to abort.
bool CopyTuples(vtkAbstractArray* array, vtkIdType first, vtkIdType count, vtkAbstractArray* from,
  vtkAHDProgress& progress)
{
  for (vtkIdType i = 0; i < count; i += kPiece)
  {
    if (progress.MustAbort())
    {
      return false;
    }
    array->InsertTuples(first + i, std::min(kPiece, count - i), i, from);
  }
  return true;
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
bool Clear(
  vtkAbstractArray* array, vtkIdType first, vtkIdType end, bool areIds, vtkAHDProgress& progress)
{
  auto* numbers = vtkArrayDownCast<vtkDataArray>(array);
  if (!numbers) // strings and the like: they are empty from the beginning
  {
    return true;
  }
  const double value = ValueOfAdded(numbers, areIds);
  for (vtkIdType i = first; i < end; ++i)
  {
    if ((i - first) % kPiece == 0 && progress.MustAbort())
    {
      return false;
    }
    for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
    {
      numbers->SetComponent(i, c, value);
    }
  }
  return true;
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
bool CopyRounded(vtkDataArray* array, vtkIdType first, vtkIdType count, vtkDataArray* from,
  vtkAHDProgress& progress)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (i % kPiece == 0 && progress.MustAbort())
    {
      return false;
    }
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      array->SetComponent(first + i, c, ToWhole(from->GetComponent(i, c), array));
    }
  }
  return true;
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
}

vtkAHDPointOutput::vtkAHDPointOutput(vtkPointSet* input, vtkPointSet* source,
  const vtkAHDWorkingPoints& points, bool projected, const std::vector<vtkAHDCrossing>& crossings)
  : Input(input)
  , Source(source)
  , Points(points)
  , Projected(projected)
  , Crossings(crossings)
  , SourceCount(source ? source->GetNumberOfPoints() : 0)
  , FirstCrossing(points.GetCount() - static_cast<vtkIdType>(crossings.size()))
{
}

std::size_t vtkAHDPointOutput::EstimateBytes(vtkPointSet* input, std::size_t pointCount)
{
  std::size_t perPoint = 3 * sizeof(double);
  vtkPointData* data = input->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const int components = std::max(1, array->GetNumberOfComponents());
    const int bytes = array->IsNumeric() ? array->GetDataTypeSize() : 32; // an empty string
    perPoint += static_cast<std::size_t>(components) * static_cast<std::size_t>(std::max(1, bytes));
  }
  return pointCount * perPoint;
}

ahd::Status vtkAHDPointOutput::Write(
  vtkPolyData* output, ahd::Executor& executor, vtkAHDProgress& progress) const
{
  const bool all = this->WritePoints(output, executor, progress) &&
    this->WriteData(output->GetPointData(), progress);
  return all ? ahd::Status::Ok : ahd::Status::Cancelled;
}

bool vtkAHDPointOutput::WritePoints(
  vtkPolyData* output, ahd::Executor& executor, vtkAHDProgress& progress) const
{
  const vtkIdType inputCount = this->Points.GetInputCount();
  const vtkIdType count = this->Points.GetCount();
  auto coordinates = vtkAHDNewArray<vtkDoubleArray>(3 * count);
  coordinates->SetNumberOfComponents(3);
  double* xyz = coordinates->GetPointer(0);
  const bool moved = this->Projected;
  const bool all = vtkAHDLoop(static_cast<std::size_t>(this->FirstCrossing), executor, progress,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        const vtkIdType i = static_cast<vtkIdType>(k);
        if (moved && i < inputCount)
        {
          this->Input->GetPoints()->GetPoint(i, xyz + 3 * i);
        }
        else if (moved && i - inputCount < this->SourceCount)
        {
          this->Source->GetPoints()->GetPoint(i - inputCount, xyz + 3 * i);
        }
        else
        {
          const std::array<double, 3> p = this->Points.GetPoint(k);
          std::copy(p.begin(), p.end(), xyz + 3 * i);
        }
      }
    });
  // Crossings last, as they may need all others.
  for (std::size_t k = 0; k < this->Crossings.size(); ++k)
  {
    const vtkIdType i = this->FirstCrossing + static_cast<vtkIdType>(k);
    const std::array<double, 3> place = this->Points.GetPoint(static_cast<std::size_t>(i));
    for (vtkIdType c = 0; c < 3; ++c)
    {
      const auto value = [xyz, c](vtkIdType id) { return xyz[3 * id + c]; };
      xyz[3 * i + c] = moved ? vtkAHDInterpolate(this->Crossings[k], value)
                             : place[static_cast<std::size_t>(c)];
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  output->SetPoints(points);
  return all;
}

bool vtkAHDPointOutput::WriteData(vtkPointData* output, vtkAHDProgress& progress) const
{
  vtkNew<vtkPointData> input;
  input->ShallowCopy(this->Input->GetPointData());
  vtkAHDRemoveNamesakes(input);
  vtkNew<vtkPointData> data;
  data->CopyAllOn(); // which of them are scalars, ids, normals ...
  data->CopyAllocate(input, this->Points.GetCount());
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    array->SetNumberOfTuples(this->Points.GetCount());
    if (!this->WriteArray(array, input->GetAbstractArray(i), progress))
    {
      return false;
    }
  }
  // As such they would have to name each point.
  data->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  data->SetActiveAttribute(-1, vtkDataSetAttributes::PEDIGREEIDS);
  output->ShallowCopy(data);
  return true;
}

bool vtkAHDPointOutput::WriteArray(
  vtkAbstractArray* array, vtkAbstractArray* from, vtkAHDProgress& progress) const
{
  const vtkIdType count = this->Points.GetCount();
  const vtkIdType inputCount = this->Points.GetInputCount();
  const vtkIdType given = std::min(inputCount, from->GetNumberOfTuples());
  const bool areIds = AreIds(this->Input->GetPointData(), from);
  if (!CopyTuples(array, 0, given, from, progress) || !Clear(array, given, count, areIds, progress))
  {
    return false;
  }
  if (areIds || IsGhostArray(array))
  {
    return true;
  }
  vtkAbstractArray* more = this->Source && array->GetName()
    ? this->Source->GetPointData()->GetAbstractArray(array->GetName())
    : nullptr;
  auto* numbers = vtkArrayDownCast<vtkDataArray>(array);
  if (Fit(array, more))
  {
    const vtkIdType many = std::min(this->SourceCount, more->GetNumberOfTuples());
    auto* others = vtkArrayDownCast<vtkDataArray>(more);
    const bool all = numbers && MustBeRounded(numbers, others)
      ? CopyRounded(numbers, inputCount, many, others, progress)
      : CopyTuples(array, inputCount, many, more, progress);
    if (!all)
    {
      return false;
    }
  }
  return !numbers || this->Interpolate(numbers, progress);
}

bool vtkAHDPointOutput::Interpolate(vtkDataArray* array, vtkAHDProgress& progress) const
{
  const bool whole = IsWhole(array);
  for (std::size_t k = 0; k < this->Crossings.size(); ++k)
  {
    if (k % kPiece == 0 && progress.MustAbort())
    {
      return false;
    }
    const vtkIdType i = this->FirstCrossing + static_cast<vtkIdType>(k);
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const double value = vtkAHDInterpolate(
        this->Crossings[k], [array, c](vtkIdType id) { return array->GetComponent(id, c); });
      array->SetComponent(i, c, whole ? ToWhole(value, array) : value);
    }
  }
  return true;
}
