// SPDX-License-Identifier: BSD-3-Clause
#include "Output/vtkAHDVoronoi.h"

#include "Input/vtkAHDDuplicates.h"
#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDNamesakes.h"
#include "Pipeline/vtkAHDProgress.h"

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
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace
{
constexpr const char* kIdsName = "OriginalPointIds";
}

ahd::Status vtkAHDVoronoi::Compute(ahd::Triangulator& triangulator, const ahd::PointView& points,
  ahd::VoronoiClip clip, vtkAHDProgress& progress, ahd::Executor& executor)
{
  const std::size_t count = triangulator.report().triangles;
  const std::unique_ptr<vtkTypeInt32[]> corners(new vtkTypeInt32[3 * count]);
  const std::unique_ptr<std::int64_t[]> neighbors(new std::int64_t[3 * count]);
  const std::unique_ptr<std::int64_t[]> fates(new std::int64_t[points.count]);
  ahd::Status status = triangulator.writeTriangles(corners.get(), &progress, &executor);
  if (status == ahd::Status::Ok)
  {
    status = triangulator.writeNeighbors(neighbors.get(), &progress);
  }
  if (status == ahd::Status::Ok)
  {
    status = triangulator.writeFates(fates.get(), &progress, &executor);
  }
  if (status != ahd::Status::Ok)
  {
    return status;
  }
  ahd::DelaunayView delaunay;
  delaunay.points = points;
  delaunay.fates = fates.get();
  delaunay.corners = corners.get();
  delaunay.neighbors = neighbors.get();
  delaunay.triangles = count;
  return ahd::voronoiCells(delaunay, clip, this->Cells, &progress, &executor);
}

void vtkAHDVoronoi::WriteCells(vtkPolyData* output)
{
  const vtkIdType corners = static_cast<vtkIdType>(this->Cells.points.size());
  auto xyz = vtkAHDNewArray<vtkDoubleArray>(3 * corners);
  double* to = xyz->GetPointer(0);
  for (const ahd::Point& p : this->Cells.points)
  {
    *to++ = p.x;
    *to++ = p.y;
    *to++ = 0.0;
  }
  xyz->SetNumberOfComponents(3);
  vtkNew<vtkPoints> points;
  points->SetData(xyz);
  output->SetPoints(points);

  auto offsets = vtkAHDNewArray<vtkTypeInt64Array>(
    static_cast<vtkIdType>(this->Cells.offsets.size()));
  std::copy(this->Cells.offsets.begin(), this->Cells.offsets.end(), offsets->GetPointer(0));
  auto ids = vtkAHDNewArray<vtkTypeInt64Array>(static_cast<vtkIdType>(this->Cells.corners.size()));
  std::copy(this->Cells.corners.begin(), this->Cells.corners.end(), ids->GetPointer(0));
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, ids);
  output->SetPolys(polygons);
}

void vtkAHDVoronoi::Write(vtkPolyData* surface, const vtkAHDDuplicates& shown, vtkPolyData* output)
{
  this->WriteCells(output);
  const vtkIdType count = static_cast<vtkIdType>(this->Cells.sites.size());
  auto original = vtkAHDNewArray<vtkIdTypeArray>(count);
  for (vtkIdType k = 0; k < count; ++k)
  {
    const auto site = shown.Get(this->Cells.sites[static_cast<std::size_t>(k)]);
    original->SetValue(k, static_cast<vtkIdType>(site));
  }
  this->Cells = ahd::VoronoiCells();
  original->SetName(kIdsName);
  output->GetCellData()->AddArray(original);
  WriteData(surface, output);
}

bool vtkAHDVoronoi::IsWritten(vtkPolyData* output)
{
  return output->GetCellData()->HasArray(kIdsName) != 0;
}

void vtkAHDVoronoi::WriteData(vtkPolyData* surface, vtkPolyData* output)
{
  vtkNew<vtkPointData> pointData; // what there is of every point
  pointData->ShallowCopy(surface->GetPointData());
  pointData->RemoveArray(kIdsName);
  vtkAHDRemoveNamesakes(pointData);
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
  vtkNew<vtkIdList> from;
  vtkNew<vtkIdList> to;
  from->SetNumberOfIds(count);
  to->SetNumberOfIds(count);
  for (vtkIdType k = 0; k < count; ++k)
  {
    from->SetId(k, ids->GetValue(k));
    to->SetId(k, k);
  }
  data->Initialize();
  data->CopyFieldOff(vtkDataSetAttributes::GhostArrayName()); // its bits mean others for cells
  data->CopyAllocate(pointData, count);
  data->CopyData(pointData, from, to);
  data->AddArray(original);
}

namespace
{
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

std::size_t vtkAHDVoronoi::EstimateBytes(std::size_t pointCount)
{
  // Triangles, neighbours and fates; points, offsets, corners and ids of the polygons.
  return ahd::voronoiMemoryEstimate(pointCount) +
    pointCount * (2 * 3 * (sizeof(vtkTypeInt32) + sizeof(std::int64_t)) + sizeof(std::int64_t)) +
    pointCount * (2 * 3 * sizeof(double) + 8 * sizeof(std::int64_t) + 3 * sizeof(vtkIdType));
}
