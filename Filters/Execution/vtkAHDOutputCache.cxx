// SPDX-License-Identifier: BSD-3-Clause
#include "Execution/vtkAHDOutputCache.h"

#include "Engine/Points/Points.h"
#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDFingerprint.h"
#include "Output/vtkAHDVoronoi.h"
#include "Pipeline/vtkAHDAttributes.h"
#include "Pipeline/vtkAHDOutputArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace
{
constexpr const char* kCrossings = vtkAHDOutputArrays::Crossings.Name;

/// Gives `to` all that `from` has but field data. @pre `to` is empty.
void ShareAll(vtkPolyData* from, vtkPolyData* to)
{
  to->SetPoints(from->GetPoints());
  // those there are: where there are none, VTK hands out an empty array that all share
  if (from->GetNumberOfVerts() > 0)
  {
    to->SetVerts(from->GetVerts());
  }
  if (from->GetNumberOfLines() > 0)
  {
    to->SetLines(from->GetLines());
  }
  if (from->GetNumberOfPolys() > 0)
  {
    to->SetPolys(from->GetPolys());
  }
  to->GetPointData()->ShallowCopy(from->GetPointData());
  to->GetCellData()->ShallowCopy(from->GetCellData());
}

/// Gives `to` the arrays of `from`, without a value, and no points or cells.
void MakeEmpty(vtkPolyData* from, vtkPolyData* to)
{
  to->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataType(from->GetPoints() ? from->GetPoints()->GetDataType() : VTK_FLOAT);
  to->SetPoints(points);
  to->GetPointData()->CopyAllOn(); // VTK leaves global ids out
  to->GetPointData()->CopyAllocate(from->GetPointData(), 1);
  to->GetCellData()->CopyAllocate(from->GetCellData(), 1);
}

/// All arrays of a data set; null where it has none.
std::vector<vtkAbstractArray*> ArraysOf(vtkPolyData* set)
{
  std::vector<vtkAbstractArray*> arrays = { set->GetPoints() ? set->GetPoints()->GetData()
                                                             : nullptr };
  for (vtkCellArray* cells : { set->GetVerts(), set->GetLines(), set->GetPolys() })
  {
    arrays.push_back(cells ? cells->GetConnectivityArray() : nullptr);
    arrays.push_back(cells ? cells->GetOffsetsArray() : nullptr);
  }
  const std::initializer_list<vtkFieldData*> all = { set->GetPointData(), set->GetCellData(),
    set->GetFieldData() };
  for (vtkFieldData* data : all)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      arrays.push_back(data->GetAbstractArray(i));
    }
  }
  return arrays;
}

bool IsAmong(vtkAbstractArray* array, vtkFieldData* data)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (data->GetAbstractArray(i) == array)
    {
      return true;
    }
  }
  return false;
}
}

vtkAHDOutputCache::vtkAHDOutputCache() = default;
vtkAHDOutputCache::~vtkAHDOutputCache() = default;

bool vtkAHDOutputCache::TakeFingerprints(const vtkAHDDataSets& data, const vtkAHDContext& context)
{
  std::vector<vtkDataArray*> arrays;
  const auto addPoints = [&arrays](vtkPointSet* set)
  { arrays.push_back(set->GetPoints() ? set->GetPoints()->GetData() : nullptr); };
  addPoints(data.Input);
  arrays.push_back(data.Input->GetPointGhostArray());
  if (std::size_t(data.Input->GetNumberOfPoints()) > ahd::kMaximumPoints)
  {
    return false; // there will be no triangles
  }
  if (vtkPolyData* source = data.Source)
  {
    addPoints(source);
    for (vtkCellArray* cells : { source->GetLines(), source->GetPolys() })
    {
      arrays.push_back(cells ? cells->GetConnectivityArray() : nullptr);
      arrays.push_back(cells ? cells->GetOffsetsArray() : nullptr);
    }
    // cells are numbered behind the vertices
    this->Now.push_back({ { std::uint64_t(source->GetNumberOfVerts()) } });
  }
  for (vtkDataArray* array : arrays)
  {
    ahd::Fingerprint fingerprint;
    if (!vtkAHDTakeFingerprint(array, context, fingerprint))
    {
      this->Now.clear();
      return false;
    }
    this->Now.push_back(fingerprint);
  }
  return true;
}

/// False if the filter is to abort, or an array cannot be known again: because of its kind, or what
/// its owner gave it.
bool vtkAHDOutputCache::TakeOutputs(const vtkAHDContext& context, std::vector<Known>& found) const
{
  for (const auto& kept : this->Data)
  {
    for (vtkAbstractArray* array : ArraysOf(kept))
    {
      Known known = { array && array->GetName() ? array->GetName() : "", {} };
      auto* const numbers = vtkArrayDownCast<vtkDataArray>(array);
      const bool isOther = numbers && (numbers->GetLookupTable() || numbers->HasAComponentName());
      if ((array && !numbers) || isOther || !vtkAHDTakeFingerprint(numbers, context, known.Print))
      {
        return false;
      }
      found.push_back(known);
    }
  }
  return true;
}

/// Do they exist, unchanged?
bool vtkAHDOutputCache::HasOutputs(const vtkAHDContext& context) const
{
  std::vector<Known> now;
  return this->IsKept && this->TakeOutputs(context, now) && now == this->Outputs;
}

bool vtkAHDOutputCache::Fits(
  const vtkAHDDataSets& data, vtkMTimeType settings, const vtkAHDContext& context)
{
  const vtkIdType count = data.Input->GetNumberOfPoints();
  const bool mayFit = this->Settings == settings && this->Count == count;
  this->Settings = settings;
  this->Count = count;
  this->Now.clear();
  const bool fits = mayFit && this->TakeFingerprints(data, context) &&
    this->Now == this->AtTheTime && this->HasOutputs(context);
  if (!fits)
  {
    this->LetGo(); // before anything else takes memory
  }
  return fits;
}

void vtkAHDOutputCache::Keep(const vtkAHDDataSets& data, const vtkAHDContext& context)
{
  if (this->Now.empty() || data.Outputs[0]->GetNumberOfPoints() != data.Input->GetNumberOfPoints())
  {
    return;
  }
  this->Share(data);
  this->AtTheTime = this->Now;
  this->IsKept = this->TakeOutputs(context, this->Outputs);
  if (!this->IsKept)
  {
    this->LetGo();
  }
}

/// Makes Data of the outputs, without the input's data.
void vtkAHDOutputCache::Share(const vtkAHDDataSets& data)
{
  vtkPointSet* input = data.Input;
  const vtkAHDOutputs& outputs = data.Outputs;
  for (std::size_t k = 0; k < outputs.size(); ++k)
  {
    ShareAll(outputs[k], this->Data[k]);
  }
  if (vtkAHDVoronoi::IsWritten(this->Data[2]))
  {
    vtkAHDVoronoi::DropData(this->Data[2]);
  }
  vtkFieldData* fieldData = outputs[0]->GetFieldData();
  std::vector<vtkAbstractArray*> made;
  for (int i = 0; i < fieldData->GetNumberOfArrays(); ++i)
  {
    // arrays of all outputs were passed by the pipeline
    vtkAbstractArray* array = fieldData->GetAbstractArray(i);
    if (!IsAmong(array, outputs[1]->GetFieldData()))
    {
      made.push_back(array);
    }
  }
  // As they were made, whatever of the input's stood in their place.
  std::sort(made.begin(), made.end(),
    [](vtkAbstractArray* a, vtkAbstractArray* b) { return a->GetMTime() < b->GetMTime(); });
  for (vtkAbstractArray* array : made)
  {
    this->Data[0]->GetFieldData()->AddArray(array);
  }
  vtkPointData* own = this->Data[0]->GetPointData();
  for (int i = own->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (IsAmong(own->GetAbstractArray(i), input->GetPointData()))
    {
      own->RemoveArray(i);
    }
  }
  this->HasOwnPoints = outputs[0]->GetPoints() != input->GetPoints();
  if (!this->HasOwnPoints)
  {
    this->Data[0]->SetPoints(nullptr);
  }
}

void vtkAHDOutputCache::PassOn(const vtkAHDDataSets& data) const
{
  vtkPointSet* input = data.Input;
  const vtkAHDOutputs& outputs = data.Outputs;
  for (std::size_t k = 0; k < outputs.size(); ++k)
  {
    ShareAll(this->Data[k], outputs[k]);
  }
  if (!this->HasOwnPoints)
  {
    outputs[0]->SetPoints(input->GetPoints());
  }
  vtkPointData* pointData = outputs[0]->GetPointData();
  pointData->Initialize();
  pointData->PassData(input->GetPointData());
  vtkPointData* own = this->Data[0]->GetPointData();
  for (int i = 0; i < own->GetNumberOfArrays(); ++i)
  {
    vtkAHDReplaceArray(pointData, own->GetAbstractArray(i));
  }
  vtkFieldData* ownFieldData = this->Data[0]->GetFieldData();
  if (!ownFieldData->HasArray(kCrossings))
  {
    outputs[0]->GetFieldData()->RemoveArray(kCrossings); // the input's; else it keeps its place
  }
  for (int i = 0; i < ownFieldData->GetNumberOfArrays(); ++i)
  {
    outputs[0]->GetFieldData()->AddArray(ownFieldData->GetAbstractArray(i));
  }
  if (vtkAHDVoronoi::IsWritten(outputs[2]))
  {
    vtkAHDVoronoi::WriteData(outputs[0], outputs[2]);
  }
}

void vtkAHDOutputCache::Forget()
{
  this->Now.clear();
  this->LetGo();
}

void vtkAHDOutputCache::LetGo()
{
  this->IsKept = false;
  this->AtTheTime.clear();
  this->Outputs.clear();
  for (auto& kept : this->Data)
  {
    kept->Initialize();
  }
}

void vtkAHDOutputCache::KeepEmpty(const vtkAHDDataSets& data, vtkMTimeType settings)
{
  this->EmptyOf = 0;
  for (std::size_t port = 0; port < data.Outputs.size(); ++port)
  {
    if (data.Outputs[port])
    {
      MakeEmpty(data.Outputs[port], this->Empty[port]);
    }
  }
  this->EmptyOf = settings;
}

void vtkAHDOutputCache::GiveEmpty(std::size_t port, vtkPolyData* output) const
{
  MakeEmpty(this->Empty[port], output);
}
