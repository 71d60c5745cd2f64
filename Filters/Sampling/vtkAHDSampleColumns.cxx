// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDSampleColumns.h"

#include "Engine/Triangulation/Triangulation.h"
#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDAttributes.h"
#include "Sampling/vtkAHDSampleCopies.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>

namespace
{
/// An array of doubles, not initialised; throws std::bad_alloc.
vtkSmartPointer<vtkDoubleArray> MakeDoubles(std::size_t count, std::size_t components)
{
  auto array = vtkAHDNewArray<vtkDoubleArray>(static_cast<vtkIdType>(count * components));
  array->SetNumberOfComponents(static_cast<int>(components));
  return array;
}

bool IsNamed(vtkAbstractArray* array, const char* name)
{
  return array && array->GetName() && std::strcmp(array->GetName(), name) == 0;
}

/// Has it a name, and numbers for so many points?
bool Fits(vtkAbstractArray* array, std::size_t points)
{
  const char* const name = array->GetName();
  return vtkArrayDownCast<vtkDataArray>(array) && name && *name != '\0' &&
    array->GetNumberOfComponents() > 0 &&
    array->GetNumberOfTuples() >= static_cast<vtkIdType>(points);
}

/// Is one of a point's numbers NaN?
bool HasNaN(vtkDataArray* array, std::size_t point)
{
  bool isNaN = false;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    isNaN = isNaN || std::isnan(array->GetComponent(static_cast<vtkIdType>(point), c));
  }
  return isNaN;
}

/// Does the array of this name name the points?
bool AreIds(vtkPointData* data, const char* name)
{
  return IsNamed(data->GetGlobalIds(), name) || IsNamed(data->GetPedigreeIds(), name);
}
}

vtkAHDSampleColumns::vtkAHDSampleColumns(
  const vtkAHDSampleSettings& settings, vtkPointData* given, vtkPointData* data, std::size_t count)
  : Settings(settings)
  , Data(data)
{
  vtkAHDSampleColumn heights;
  heights.Name = settings.Heights;
  this->Columns.push_back(heights);
  vtkNew<vtkPointData> arrays;
  arrays->ShallowCopy(data);
  vtkAHDRemoveArraysOfOneName(arrays);
  const Choice choice = { arrays, given, count };
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    this->Choose(arrays->GetAbstractArray(i), choice);
  }
}

/// Is it the name of an array that is made? In whatever order the arrays are.
bool vtkAHDSampleColumns::IsTaken(const std::string& name, const Choice& choice) const
{
  if (name == this->Settings.Heights || name == this->Settings.Mask)
  {
    return true;
  }
  const std::size_t end = std::strlen(kGradient);
  return this->Settings.MakesGradients() && name.size() > end &&
    name.compare(name.size() - end, end, kGradient) == 0 &&
    this->MakesGradientOf(name.substr(0, name.size() - end), choice);
}

/// Is there an array of this name, of one component, that is interpolated?
bool vtkAHDSampleColumns::MakesGradientOf(const std::string& name, const Choice& choice) const
{
  if (name == this->Settings.Heights)
  {
    return true;
  }
  vtkAbstractArray* const array = choice.Arrays->GetAbstractArray(name.c_str());
  return array && !IsNamed(array, vtkDataSetAttributes::GhostArrayName()) &&
    Fits(array, choice.Points) && array->GetNumberOfComponents() == 1 &&
    !AreIds(choice.Given, name.c_str()) && !this->IsTaken(name, choice);
}

void vtkAHDSampleColumns::Choose(vtkAbstractArray* array, const Choice& choice)
{
  const char* const name = array->GetName();
  if (IsNamed(array, vtkDataSetAttributes::GhostArrayName()))
  {
    return;
  }
  if (name && this->IsTaken(name, choice))
  {
    this->Replaced.emplace_back(name);
    return;
  }
  if (!Fits(array, choice.Points))
  {
    this->Unfit.emplace_back(name && *name != '\0' ? name : "one without a name");
    return;
  }
  if (AreIds(choice.Given, name) && !this->Settings.IsNearest())
  {
    return;
  }
  vtkAHDSampleColumn column;
  column.From = vtkArrayDownCast<vtkDataArray>(array);
  column.Name = name;
  column.Components = static_cast<std::size_t>(array->GetNumberOfComponents());
  column.IsFloat = array->GetDataType() == VTK_FLOAT;
  this->Columns.push_back(column);
}

std::size_t vtkAHDSampleColumns::GetNumberOfComponents() const
{
  std::size_t sum = 0;
  for (const vtkAHDSampleColumn& column : this->Columns)
  {
    sum += column.Components;
  }
  return sum;
}

vtkAHDSampleColumns::Kind vtkAHDSampleColumns::GetKindOfScalars() const
{
  Kind kind;
  for (const vtkAHDSampleColumn& column : this->Columns)
  {
    if (column.From && IsNamed(this->Data->GetScalars(), column.Name.c_str()))
    {
      const int interpolated = column.IsFloat ? VTK_FLOAT : VTK_DOUBLE;
      kind.Type = this->Settings.IsNearest() ? column.From->GetDataType() : interpolated;
      kind.Components = static_cast<int>(column.Components);
    }
  }
  return kind;
}

double vtkAHDSampleColumns::EstimateBytes(std::size_t points, double places) const
{
  double perPoint = sizeof(double); // heights
  double perPlace = this->OutputPerPlace();
  double copied = 0.0; // one at a time
  if (this->Settings.IsNearest())
  {
    perPoint += sizeof(double); // ids
    perPlace += sizeof(double);
  }
  for (const vtkAHDSampleColumn& column : this->Columns)
  {
    if (this->Settings.IsNearest())
    {
      const bool isCopied = column.From && vtkAHDIsCopiedToGather(column.From);
      copied = isCopied ? std::max(copied, this->BytesPerPlace(column)) : copied;
      continue;
    }
    const bool isRead = column.From && !vtkArrayDownCast<vtkDoubleArray>(column.From);
    perPoint += isRead ? double(column.Components * sizeof(double)) : 0.0;
    perPlace += column.IsFloat ? double(this->NumbersPerPlace(column) * sizeof(double)) : 0.0;
  }
  return (perPoint + copied) * double(points) + perPlace * places;
}

double vtkAHDSampleColumns::EstimateOutputBytes(double places) const
{
  return this->OutputPerPlace() * places;
}

/// Bytes of all columns and the mask.
double vtkAHDSampleColumns::OutputPerPlace() const
{
  double bytes = 1.0; // mask
  for (const vtkAHDSampleColumn& column : this->Columns)
  {
    bytes += this->BytesPerPlace(column);
  }
  return bytes;
}

/// Values and slopes, where those are made.
std::size_t vtkAHDSampleColumns::NumbersPerPlace(const vtkAHDSampleColumn& column) const
{
  const bool hasGradient = this->Settings.MakesGradients() && column.Components == 1;
  return column.Components + (hasGradient ? 2 : 0);
}

/// The output array of a column; that of heights if it has no array.
double vtkAHDSampleColumns::BytesPerPlace(const vtkAHDSampleColumn& column) const
{
  const std::size_t ofType = column.From
    ? static_cast<std::size_t>(std::max(1, column.From->GetDataTypeSize()))
    : sizeof(double);
  const std::size_t interpolated = column.IsFloat ? sizeof(float) : sizeof(double);
  const std::size_t perNumber = this->Settings.IsNearest() ? ofType : interpolated;
  return double(perNumber * this->NumbersPerPlace(column));
}

void vtkAHDSampleColumns::Open(
  const double* heights, std::size_t places, const vtkAHDContext& context)
{
  for (vtkAHDSampleColumn& column : this->Columns)
  {
    column.Values = column.From ? vtkAHDReadNumbers(column.From, column.Read, context) : heights;
    auto out = MakeDoubles(places, column.Components);
    column.Results = out->GetPointer(0);
    column.Out = out;
    if (this->Settings.MakesGradients() && column.Components == 1 && !column.Name.empty())
    {
      auto slopes = MakeDoubles(places, 2);
      column.Gradients = slopes->GetPointer(0);
      column.OutGradient = slopes;
    }
    this->Arrays.push_back({ column.Values, column.Components, column.Results, column.Gradients });
  }
}

void vtkAHDSampleColumns::CountMissing(const char* mask, const vtkAHDContext& context)
{
  for (vtkAHDSampleColumn& column : this->Columns)
  {
    std::atomic<std::size_t> missing{ 0 };
    const std::size_t width = column.Components;
    const double* const numbers = column.Results;
    context.ForRange(static_cast<std::size_t>(column.Out->GetNumberOfTuples()),
      [&](std::size_t begin, std::size_t end)
      {
        missing += static_cast<std::size_t>(
          std::count_if(numbers + begin * width, numbers + end * width,
            [&](const double& number)
            { return std::isnan(number) && mask[std::size_t(&number - numbers) / width] != 0; }));
      });
    column.Missing = missing;
  }
}

std::size_t vtkAHDSampleColumns::CountMissingOf(const std::string& name) const
{
  const auto found = std::find_if(this->Columns.begin(), this->Columns.end(),
    [&name](const vtkAHDSampleColumn& column)
    { return column.From ? column.Name == name : name.empty(); });
  return found == this->Columns.end() ? 0 : found->Missing;
}

std::vector<vtkAHDMissingValues> vtkAHDSampleColumns::FindMissing(const double* heights,
  const ahd::Triangulation& surface, const vtkAHDAddedPoints& added,
  const vtkAHDContext& context) const
{
  constexpr std::size_t kPiece = std::size_t(1) << 14;
  std::vector<vtkAHDMissingValues> all;
  for (const vtkAHDSampleColumn& column : this->Columns)
  {
    vtkAHDMissingValues missing;
    missing.Name = column.From ? column.Name : std::string();
    missing.Places = column.Missing;
    const int type = column.From ? column.From->GetDataType() : VTK_DOUBLE;
    const bool mayBeNaN = type == VTK_FLOAT || type == VTK_DOUBLE;
    const std::size_t vertices = mayBeNaN ? surface.vertexCount() : 0;
    for (std::size_t vertex = 0; vertex < vertices && !missing.OfAdded; ++vertex)
    {
      vertex % kPiece == 0 ? context.StopIfAborted() : void();
      const std::size_t point = surface.pointOf(static_cast<ahd::Index>(vertex));
      const bool isAdded = point >= added.First && point < added.End;
      if ((!missing.OfPoints || isAdded) &&
        (column.From ? HasNaN(column.From, point) : std::isnan(heights[point])))
      {
        missing.OfPoints = true;
        missing.OfAdded = isAdded;
      }
    }
    all.push_back(missing);
  }
  return all;
}

void vtkAHDSampleColumns::Finish(const vtkAHDContext& context)
{
  for (vtkAHDSampleColumn& column : this->Columns)
  {
    column.Read = ahd::UninitialisedVector<double>();
    for (vtkSmartPointer<vtkDataArray>* array : { &column.Out, &column.OutGradient })
    {
      if (*array)
      {
        vtkAHDFillNoValue(*array, this->Settings.NoValue, context);
        if (column.IsFloat)
        {
          *array = vtkAHDAsFloats(*array, context);
        }
      }
    }
  }
}

std::size_t vtkAHDSampleColumns::Gather(
  const double* heights, const double* ids, std::size_t places, const vtkAHDContext& context)
{
  std::size_t missing = 0;
  for (vtkAHDSampleColumn& column : this->Columns)
  {
    const vtkAHDGathered gathered{ ids, places, this->Settings.NoValue };
    column.Missing = 0;
    column.Out = column.From ? vtkAHDGather(column.From, gathered, context, column.Missing)
                             : vtkAHDGatherHeights(heights, gathered, context, column.Missing);
    missing += column.Missing;
  }
  return missing;
}

/// Has the place a number in one of the arrays that is not NaN?
bool vtkAHDSampleColumns::HasValueAt(vtkIdType place) const
{
  for (const vtkAHDSampleColumn& column : this->Columns)
  {
    for (int c = 0; c < column.Out->GetNumberOfComponents(); ++c)
    {
      if (!std::isnan(column.Out->GetComponent(place, c)))
      {
        return true;
      }
    }
  }
  return false;
}

vtkSmartPointer<vtkUnsignedCharArray> vtkAHDSampleColumns::MarkWithoutValue(
  const char* mask, const vtkAHDContext& context) const
{
  auto* const heights = vtkArrayDownCast<vtkDoubleArray>(this->GetHeights());
  const vtkIdType count = heights->GetNumberOfTuples();
  const double* const height = heights->GetPointer(0);
  auto marks = vtkAHDNewArray<vtkUnsignedCharArray>(count);
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  unsigned char* const mark = marks->GetPointer(0);
  std::atomic<bool> hides{ false };
  context.ForRange(static_cast<std::size_t>(count),
    [&](std::size_t begin, std::size_t end)
    {
      unsigned char any = 0;
      for (std::size_t k = begin; k < end; ++k)
      {
        const bool mayHave = mask[k] != 0 || this->Settings.FillsOutside();
        const bool isShown = mayHave &&
          (!std::isnan(height[k]) || this->HasValueAt(static_cast<vtkIdType>(k)));
        mark[k] = isShown ? 0 : vtkDataSetAttributes::HIDDENPOINT;
        any |= mark[k];
      }
      hides = hides || any != 0;
    });
  return hides ? marks : nullptr;
}

void vtkAHDSampleColumns::AddTo(vtkDataSetAttributes* places) const
{
  const auto add = [places](vtkDataArray* array, const std::string& name)
  {
    if (array && !name.empty())
    {
      array->SetName(name.c_str());
      vtkAHDReplaceArray(places, array);
    }
  };
  bool hasScalars = false;
  for (const vtkAHDSampleColumn& column : this->Columns)
  {
    if (column.From)
    {
      vtkAHDNameComponents(column.From, column.Out);
    }
    add(column.Out, column.Name);
    add(column.OutGradient, column.Name + kGradient);
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES && column.From; ++type)
    {
      const bool isId = type == vtkDataSetAttributes::GLOBALIDS ||
        type == vtkDataSetAttributes::PEDIGREEIDS;
      if (!isId && IsNamed(this->Data->GetAbstractAttribute(type), column.Name.c_str()))
      {
        places->SetActiveAttribute(column.Name.c_str(), type);
        hasScalars = hasScalars || type == vtkDataSetAttributes::SCALARS;
      }
    }
  }
  if (!hasScalars && !this->Settings.Heights.empty())
  {
    places->SetActiveAttribute(this->Settings.Heights.c_str(), vtkDataSetAttributes::SCALARS);
  }
}
