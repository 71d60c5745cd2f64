// SPDX-License-Identifier: BSD-3-Clause
#include "Output/vtkAHDRings.h"

#include "Engine/Outline/Outline.h"
#include "Pipeline/vtkAHDArray.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace
{
/// The ids of the points that rings pass, ascending.
std::vector<ahd::Index> PassedPoints(const ahd::Outline& made)
{
  std::vector<ahd::Index> passed = made.corners;
  std::sort(passed.begin(), passed.end());
  passed.erase(std::unique(passed.begin(), passed.end()), passed.end());
  return passed;
}

template <typename Array>
vtkSmartPointer<vtkPoints> CopyPoints(vtkPoints* from, const std::vector<ahd::Index>& passed)
{
  const auto count = static_cast<vtkIdType>(passed.size());
  auto xyz = vtkAHDNewArray<Array>(3 * count);
  xyz->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    xyz->SetTuple(i, from->GetPoint(passed[static_cast<std::size_t>(i)]));
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(xyz);
  return points;
}

/// Arrays of the points that have a value for each, but for marks.
void CopyPointData(vtkPolyData* from, const std::vector<ahd::Index>& passed, vtkPointData* to)
{
  vtkNew<vtkPointData> fit;
  fit->ShallowCopy(from->GetPointData());
  for (int k = fit->GetNumberOfArrays() - 1; k >= 0; --k)
  {
    if (fit->GetAbstractArray(k)->GetNumberOfTuples() != from->GetNumberOfPoints())
    {
      fit->RemoveArray(k);
    }
  }
  fit->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  to->CopyAllocate(fit, static_cast<vtkIdType>(passed.size()));
  for (std::size_t i = 0; i < passed.size(); ++i)
  {
    to->CopyData(fit, passed[i], static_cast<vtkIdType>(i));
  }
}

/// A closed polyline for each ring.
vtkSmartPointer<vtkCellArray> MakeLines(
  const ahd::Outline& made, const std::vector<ahd::Index>& passed)
{
  const std::size_t rings = made.rings.size() - 1;
  auto offsets = vtkAHDNewArray<vtkIdTypeArray>(static_cast<vtkIdType>(rings + 1));
  auto ids = vtkAHDNewArray<vtkIdTypeArray>(static_cast<vtkIdType>(made.corners.size() + rings));
  vtkIdType* next = ids->GetPointer(0);
  offsets->SetValue(0, 0);
  for (std::size_t r = 0; r < rings; ++r)
  {
    const vtkIdType* const first = next;
    for (ahd::Index k = made.rings[r]; k < made.rings[r + 1]; ++k)
    {
      const auto found = std::lower_bound(passed.begin(), passed.end(), made.corners[k]);
      *next++ = static_cast<vtkIdType>(found - passed.begin());
    }
    *next++ = *first;
    offsets->SetValue(static_cast<vtkIdType>(r + 1), next - ids->GetPointer(0));
  }
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  lines->SetData(offsets, ids);
  return lines;
}

void AddCellData(const ahd::Outline& made, vtkCellData* to)
{
  const auto rings = static_cast<vtkIdType>(made.rings.size() - 1);
  auto polygons = vtkAHDNewArray<vtkIdTypeArray>(rings);
  auto holes = vtkAHDNewArray<vtkUnsignedCharArray>(rings);
  for (std::size_t k = 0; k + 1 < made.polygons.size(); ++k)
  {
    for (vtkIdType r = made.polygons[k]; r < vtkIdType(made.polygons[k + 1]); ++r)
    {
      polygons->SetValue(r, static_cast<vtkIdType>(k));
      holes->SetValue(r, r > vtkIdType(made.polygons[k]) ? 1 : 0);
    }
  }
  polygons->SetName("PolygonId");
  holes->SetName("IsHole");
  to->AddArray(polygons);
  to->AddArray(holes);
}
}

std::size_t vtkAHDRingPointBytes(vtkPolyData* from)
{
  std::size_t point = 3 * sizeof(double);
  for (int k = 0; k < from->GetPointData()->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* const array = from->GetPointData()->GetAbstractArray(k);
    point += static_cast<std::size_t>(array->GetNumberOfComponents() * array->GetDataTypeSize());
  }
  return point;
}

void vtkAHDWriteRings(const ahd::Outline& made, vtkPolyData* from, vtkPolyData* to)
{
  const std::vector<ahd::Index> passed = PassedPoints(made);
  if (vtkPoints* const points = from->GetPoints())
  {
    to->SetPoints(points->GetDataType() == VTK_FLOAT ? CopyPoints<vtkFloatArray>(points, passed)
                                                     : CopyPoints<vtkDoubleArray>(points, passed));
    CopyPointData(from, passed, to->GetPointData());
  }
  to->SetLines(MakeLines(made, passed));
  AddCellData(made, to->GetCellData());
}
