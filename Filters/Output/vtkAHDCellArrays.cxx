// SPDX-License-Identifier: BSD-3-Clause
#include "Output/vtkAHDCellArrays.h"

#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDProgress.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace
{

/// Cells of `size` points each. 32 bits are enough for what the engine triangulates.
vtkSmartPointer<vtkCellArray> MakeCells(vtkTypeInt32Array* points, vtkIdType size)
{
  const vtkIdType count = points->GetNumberOfValues() / size;
  auto offsets = vtkAHDNewArray<vtkTypeInt32Array>(count + 1);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offsets->SetValue(i, static_cast<vtkTypeInt32>(size * i));
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, points);
  return cells;
}

vtkSmartPointer<vtkCellArray> MakeCells(const std::vector<vtkTypeInt32>& ids, vtkIdType size)
{
  auto points = vtkAHDNewArray<vtkTypeInt32Array>(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), points->GetPointer(0));
  return MakeCells(points, size);
}

}

void vtkAHDCellArrays::Replace(const vtkAHDAlpha& alpha, vtkPolyData* surface)
{
  this->Kept = alpha.GetKept();
  this->KeptCount = alpha.GetKeptCount();
  const vtkTypeInt32* from = surface->GetPolys()->GetConnectivityArray32()->GetPointer(0);
  auto kept = vtkAHDNewArray<vtkTypeInt32Array>(3 * static_cast<vtkIdType>(this->KeptCount));
  vtkTypeInt32* to = kept->GetPointer(0);
  for (std::size_t t = 0; t < this->Triangles; ++t)
  {
    if (this->Kept[t])
    {
      to = std::copy(from + 3 * t, from + 3 * t + 3, to);
    }
  }
  surface->SetPolys(MakeCells(kept, 3));
  if (!alpha.GetVerts().empty())
  {
    surface->SetVerts(MakeCells(alpha.GetVerts(), 1));
  }
  if (!alpha.GetLines().empty())
  {
    surface->SetLines(MakeCells(alpha.GetLines(), 2));
  }
  this->Before = alpha.GetVerts().size() + alpha.GetLines().size() / 2;
}

/// Adds the rows of the triangles that were kept, behind one of `without` for each vert and line.
template <int width, typename Array, typename Value>
void vtkAHDCellArrays::Add(
  const char* name, const std::vector<Value>& rows, Value without, vtkPolyData* surface) const
{
  const std::size_t count = width * (this->Before + this->KeptCount);
  auto array = vtkAHDNewArray<Array>(static_cast<vtkIdType>(count));
  using Written = typename Array::ValueType;
  Written* to = array->GetPointer(0);
  to = std::fill_n(to, width * this->Before, static_cast<Written>(without));
  for (std::size_t t = 0; t < this->Triangles; ++t)
  {
    for (std::size_t i = 0; i < width && this->IsKept(t); ++i)
    {
      *to++ = static_cast<Written>(rows[width * t + i]);
    }
  }
  array->SetNumberOfComponents(width);
  array->SetName(name);
  surface->GetCellData()->AddArray(array);
}

ahd::Status vtkAHDCellArrays::AddNeighbors(
  ahd::Triangulator& triangulator, vtkPolyData* surface, vtkAHDProgress& progress) const
{
  std::vector<std::int64_t> neighbors(3 * this->Triangles);
  const ahd::Status status = triangulator.writeNeighbors(neighbors.data(), &progress);
  if (status != ahd::Status::Ok)
  {
    return status;
  }
  if (this->Before > 0 || this->KeptCount < this->Triangles)
  {
    std::vector<std::int64_t> cells(this->Triangles, -1);
    std::int64_t cell = static_cast<std::int64_t>(this->Before);
    for (std::size_t t = 0; t < this->Triangles; ++t)
    {
      cells[t] = this->IsKept(t) ? cell++ : -1;
    }
    for (std::int64_t& neighbor : neighbors)
    {
      neighbor = neighbor < 0 ? -1 : cells[static_cast<std::size_t>(neighbor)];
    }
  }
  this->Add<3, vtkIdTypeArray, std::int64_t>("Neighbors", neighbors, -1, surface);
  return status;
}

ahd::Status vtkAHDCellArrays::AddConstraintEdges(
  ahd::Triangulator& triangulator, vtkPolyData* surface, vtkAHDProgress& progress) const
{
  std::vector<std::uint8_t> edges(this->Triangles);
  const ahd::Status status = triangulator.writeConstraintEdges(edges.data(), &progress);
  if (status == ahd::Status::Ok)
  {
    this->Add<1, vtkUnsignedCharArray, std::uint8_t>("ConstraintEdges", edges, 0, surface);
  }
  return status;
}

ahd::Status vtkAHDCellArrays::AddRegionIds(
  ahd::Triangulator& triangulator, vtkPolyData* surface, vtkAHDProgress& progress) const
{
  std::vector<std::int64_t> regions(this->Triangles);
  const ahd::Status status = triangulator.writeRegions(regions.data(), &progress);
  if (status == ahd::Status::Ok)
  {
    // Regions that were dropped whole have no number.
    std::vector<std::int64_t> numbers(this->Triangles, -1);
    std::int64_t next = 0;
    for (std::size_t t = 0; t < this->Triangles; ++t)
    {
      std::int64_t& number = numbers[static_cast<std::size_t>(regions[t])];
      if (number < 0 && this->IsKept(t))
      {
        number = next++;
      }
      regions[t] = number;
    }
    this->Add<1, vtkIdTypeArray, std::int64_t>("RegionId", regions, -1, surface);
  }
  return status;
}
