// SPDX-License-Identifier: BSD-3-Clause
#include "Execution/vtkAHDOutputCache.h"

#include "Engine/Points/Points.h"
#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDFingerprint.h"
#include "Output/vtkAHDVoronoi.h"
#include "Pipeline/vtkAHDAttributes.h"

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
#include <vector>

namespace
{
constexpr const char* kCrossings = "Crossings";

/// Gives `to` all that `from` has but field data. REQUIRES: `to` is empty.
void Share(vtkPolyData* from, vtkPolyData* to)
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
    this->Now.push_back({ { std::uint64_t(source->GetNumberOfVerts()), 1 } });
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

bool vtkAHDOutputCache::Fits(
  const vtkAHDDataSets& data, vtkMTimeType settings, const vtkAHDContext& context)
{
  const vtkIdType count = data.Input->GetNumberOfPoints();
  const bool mayFit = this->Settings == settings && this->Count == count;
  this->Settings = settings;
  this->Count = count;
  this->Now.clear();
  const bool fits = mayFit && this->TakeFingerprints(data, context) && this->IsKept &&
    this->Now == this->AtTheTime;
  if (!fits)
  {
    this->LetGo(); // before anything else takes memory
  }
  return fits;
}

void vtkAHDOutputCache::Keep(const vtkAHDDataSets& data)
{
  vtkPointSet* input = data.Input;
  const vtkAHDOutputs& outputs = data.Outputs;
  if (this->Now.empty() || outputs[0]->GetNumberOfPoints() != input->GetNumberOfPoints())
  {
    return;
  }
  for (std::size_t k = 0; k < outputs.size(); ++k)
  {
    Share(outputs[k], this->Data[k]);
  }
  vtkFieldData* fieldData = outputs[0]->GetFieldData();
  std::vector<vtkAbstractArray*> made;
  for (int i = 0; i < fieldData->GetNumberOfArrays(); ++i)
  {
    // what all outputs have was passed by the pipeline
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
  this->AtTheTime = this->Now;
  this->IsKept = true;
}

void vtkAHDOutputCache::PassOn(const vtkAHDDataSets& data) const
{
  vtkPointSet* input = data.Input;
  const vtkAHDOutputs& outputs = data.Outputs;
  for (std::size_t k = 0; k < outputs.size(); ++k)
  {
    Share(this->Data[k], outputs[k]);
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
  for (auto& kept : this->Data)
  {
    kept->Initialize();
  }
}
