// SPDX-License-Identifier: BSD-3-Clause
#include "Output/vtkAHDVoronoi.h"

#include "Pipeline/vtkAHDAttributes.h"
#include "Pipeline/vtkAHDOutputArrays.h"

#include "vtkAbstractTransform.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkHomogeneousTransform.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace
{
constexpr const char* kIdsName = vtkAHDOutputArrays::OriginalPointIds.Name;

// Corners of cells are fewer than 2^31, as their numbers are (Engine/Voronoi/Voronoi.h).
using IdArray = vtkTypeInt32Array;

/// The buffer, which has so many values an element, as a VTK array in the memory it is in.
template <typename Array, typename Element>
vtkSmartPointer<Array> TakeArray(
  ahd::Buffer<Element>& from, const vtkAHDContext& context, int width = 1)
{
  const vtkIdType count = width * static_cast<vtkIdType>(from.size());
  const auto array = from.empty() ? context.NewArray<Array>(0)
                                  : context.GetOutputMemory().MakeArray<Array>(from, count);
  array->SetNumberOfComponents(width);
  return array;
}

vtkSmartPointer<vtkIdTypeArray> MakeIds(
  ahd::Buffer<std::int32_t>& sites, const vtkAHDContext& context)
{
  auto ids = context.NewArray<vtkIdTypeArray>(static_cast<vtkIdType>(sites.size()));
  vtkIdType* to = ids->GetPointer(0);
  context.ForRange(sites.size(),
    [&sites, to](std::size_t begin, std::size_t end)
    { std::copy(sites.data() + begin, sites.data() + end, to + begin); });
  sites.reset();
  ids->SetName(kIdsName);
  return ids;
}

/// Whatever it is, a transform that cannot be undone does not bring a point back.
bool BringsBack(vtkAbstractTransform* toPlane, vtkAbstractTransform* back, vtkPoints* inPlane)
{
  if (auto* linear = vtkHomogeneousTransform::SafeDownCast(toPlane))
  {
    const double determinant = linear->GetMatrix()->Determinant();
    return std::isfinite(determinant) && determinant != 0.0;
  }
  double size = 0.0;
  double error = 0.0;
  for (vtkIdType i = 0; i < std::min<vtkIdType>(inPlane->GetNumberOfPoints(), 100); ++i)
  {
    double start[3], inSpace[3], end[3];
    inPlane->GetPoint(i, start);
    back->TransformPoint(start, inSpace);
    toPlane->TransformPoint(inSpace, end);
    for (int k = 0; k < 3; ++k)
    {
      size = std::max(size, std::fabs(start[k]));
      error = std::isfinite(end[k]) ? std::max(error, std::fabs(end[k] - start[k]))
                                    : VTK_DOUBLE_MAX;
    }
  }
  return error <= 1e-6 * size;
}
}

void vtkAHDVoronoi::Write(ahd::VoronoiCells&& cells, vtkPolyData* surface, vtkPolyData* output,
  const vtkAHDContext& context)
{
  ahd::VoronoiCells used = std::move(cells);
  ahd::leaveOutEmpty(used);
  vtkNew<vtkPoints> points;
  static_assert(sizeof(ahd::VoronoiCorner) == 3 * sizeof(double), "corners are VTK's points");
  points->SetData(TakeArray<vtkDoubleArray>(used.points, context, 3));
  output->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  const auto offsets = TakeArray<IdArray>(used.offsets, context);
  polygons->SetData(offsets, TakeArray<IdArray>(used.corners, context));
  output->SetPolys(polygons);
  output->GetCellData()->AddArray(MakeIds(used.sites, context));
  WriteData(surface, output);
}

bool vtkAHDVoronoi::IsWritten(vtkPolyData* output)
{
  return output->GetCellData()->HasArray(kIdsName) != 0;
}

void vtkAHDVoronoi::DropData(vtkPolyData* output)
{
  vtkCellData* data = output->GetCellData();
  const vtkSmartPointer<vtkAbstractArray> original = data->GetAbstractArray(kIdsName);
  data->Initialize();
  data->AddArray(original);
}

void vtkAHDVoronoi::WriteData(vtkPolyData* surface, vtkPolyData* output)
{
  vtkNew<vtkPointData> pointData; // arrays with a value for every point
  pointData->ShallowCopy(surface->GetPointData());
  pointData->RemoveArray(kIdsName);
  vtkAHDRemoveArraysOfOneName(pointData);
  for (int i = pointData->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (pointData->GetAbstractArray(i)->GetNumberOfTuples() < surface->GetNumberOfPoints())
    {
      pointData->RemoveArray(i);
    }
  }
  vtkCellData* data = output->GetCellData();
  const vtkSmartPointer<vtkAbstractArray> original = data->GetAbstractArray(kIdsName);
  auto* ids = vtkIdTypeArray::SafeDownCast(original);
  const vtkIdType count = ids->GetNumberOfValues();
  if (pointData->GetNumberOfArrays() == 0)
  {
    DropData(output);
    return;
  }
  data->Initialize();
  data->CopyFieldOff(vtkDataSetAttributes::GhostArrayName()); // its bits mean others for cells
  data->CopyAllocate(pointData, count);
  constexpr vtkIdType kBlock = 1 << 16; // lists of all would take 16 bytes a cell
  vtkNew<vtkIdList> from;
  vtkNew<vtkIdList> to;
  for (vtkIdType begin = 0; begin < count; begin += kBlock)
  {
    const vtkIdType some = std::min(kBlock, count - begin);
    from->SetNumberOfIds(some);
    to->SetNumberOfIds(some);
    for (vtkIdType k = 0; k < some; ++k)
    {
      from->SetId(k, ids->GetValue(begin + k));
      to->SetId(k, begin + k);
    }
    data->CopyData(pointData, from, to);
  }
  data->AddArray(original);
}

bool vtkAHDVoronoi::MoveBack(vtkAbstractTransform* toPlane, vtkPolyData* output)
{
  toPlane->Update();
  vtkAbstractTransform* back = toPlane->GetInverse();
  if (!BringsBack(toPlane, back, output->GetPoints()))
  {
    return false;
  }
  vtkNew<vtkPoints> moved;
  moved->SetDataTypeToDouble();
  back->TransformPoints(output->GetPoints(), moved);
  output->SetPoints(moved);
  return true;
}
