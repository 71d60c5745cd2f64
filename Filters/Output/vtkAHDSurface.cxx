// SPDX-License-Identifier: BSD-3-Clause
#include "Output/vtkAHDSurface.h"

#include "Engine/Job/WantedArrays.h"
#include "Output/vtkAHDPointOutput.h"
#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDAttributes.h"
#include "Pipeline/vtkAHDOutputArrays.h"
#include "Pipeline/vtkAHDPointsView.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <type_traits>
#include <vector>

namespace
{
// n points have fewer than 2n triangles, so the engine's limit on points keeps ids and offsets
// below 2^31: 32-bit storage always fits. Who raises the limit has to write 64-bit ids here.
static_assert(ahd::kMaximumPoints * 2 * 3 <= std::size_t(VTK_TYPE_INT32_MAX),
  "offsets of the triangles must fit into 32 bits");
using IdArray = vtkTypeInt32Array;

/// Cells of `size` points each.
vtkSmartPointer<vtkCellArray> MakeCells(IdArray* ids, vtkIdType size, const vtkAHDContext& context)
{
  const vtkIdType count = ids->GetNumberOfValues() / size;
  auto offsets = context.NewArray<IdArray>(count + 1);
  auto* offset = offsets->GetPointer(0);
  context.ForRange(static_cast<std::size_t>(count + 1),
    [offset, size](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        offset[i] = static_cast<vtkTypeInt32>(static_cast<std::size_t>(size) * i);
      }
    });
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, ids);
  return cells;
}

vtkSmartPointer<vtkCellArray> MakeCells(
  const std::vector<std::int32_t>& ids, vtkIdType size, const vtkAHDContext& context)
{
  auto array = context.NewArray<IdArray>(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), array->GetPointer(0));
  return MakeCells(array, size, context);
}

template <typename Number>
constexpr std::int32_t TypeOf()
{
  return std::is_floating_point<Number>::value ? ahd::kFloat64
    : sizeof(Number) == 1                      ? ahd::kUint8
    : sizeof(Number) == 4                      ? ahd::kInt32
                                               : ahd::kInt64;
}

/// An array as the engine writes it.
template <typename Array>
vtkSmartPointer<vtkDataArray> Write(const vtkAHDOutputArray<Array>& kind, ahd::WantedArray wanted,
  ahd::RunResult& made, const vtkAHDContext& context)
{
  auto array = kind.Make(ahd::rowsOf(wanted, made), context);
  context.Check(ahd::writeArray(
    wanted, made, { TypeOf<typename Array::ValueType>(), array->GetPointer(0), context }));
  return array;
}
}

void vtkAHDSurface::WritePoints(const vtkAHDInput& input, ahd::RunResult& made) const
{
  const vtkAHDPointOutput output(input, made.points);
  output.WritePlaces(this->Settings.showsMeans ? &made : nullptr, this->Output, this->Context);
  output.WriteData(this->Output->GetPointData(), this->Context);
}

void vtkAHDSurface::WriteCells(ahd::RunResult& made)
{
  if (this->Settings.limitsSize() && made.points.points().count > 0)
  {
    vtkAHDPointsView shown(this->Output->GetPoints());
    this->Context.Check(made.select(this->Settings, shown.Open(this->Context), this->Context));
  }
  auto corners = this->Context.NewArray<IdArray>(3 * static_cast<vtkIdType>(made.triangleCount()));
  std::int32_t* const to = corners->GetPointer(0);
  this->Context.Check(this->Settings.wants(ahd::WantedArray::Neighbors)
      ? this->WriteWithNeighbors(made, to)
      : made.writeTriangles(to, this->Context));
  this->Output->SetPolys(MakeCells(corners, 3, this->Context));
  if (!made.selection.vertices.empty())
  {
    this->Output->SetVerts(MakeCells(made.selection.vertices, 1, this->Context));
  }
  if (!made.selection.lines.empty())
  {
    this->Output->SetLines(MakeCells(made.selection.lines, 2, this->Context));
  }
}

/// Neighbours are written with the triangles, and added to the output with the other cell arrays.
ahd::Status vtkAHDSurface::WriteWithNeighbors(ahd::RunResult& made, std::int32_t* corners)
{
  const std::size_t count = ahd::cellCount(made.triangulation, made.selection);
  this->Neighbors = vtkAHDOutputArrays::Neighbors.Make(count, this->Context);
  const ahd::CellsWithNeighbors<vtkIdType> to = { corners, this->Neighbors->GetPointer(0) };
  return ahd::writeWithNeighbors(made.triangulation, made.selection, to, this->Context);
}

void vtkAHDSurface::AddArrays(ahd::RunResult& made) const
{
  vtkAHDOutputArrays::VisitWanted(
    [&](const auto& kind, ahd::WantedArray wanted)
    {
      if (!this->Settings.wants(wanted))
      {
        return;
      }
      vtkSmartPointer<vtkDataArray> array = this->Neighbors;
      if (wanted != ahd::WantedArray::Neighbors)
      {
        array = Write(kind, wanted, made, this->Context);
      }
      const bool isOfCells = ahd::kWantedRows[std::size_t(wanted)].isOfCells;
      vtkAHDReplaceArray(
        this->Output->GetAttributes(isOfCells ? vtkDataObject::CELL : vtkDataObject::POINT), array);
    });
}

namespace
{
/// The corners of all cells, which are this execution's own.
std::vector<IdArray*> CornersOf(vtkPolyData* output)
{
  std::vector<IdArray*> corners;
  for (vtkCellArray* cells : { output->GetVerts(), output->GetLines(), output->GetPolys() })
  {
    if (cells->GetNumberOfCells() > 0)
    {
      corners.push_back(IdArray::SafeDownCast(cells->GetConnectivityArray()));
    }
  }
  return corners;
}

/// These points, with their data.
void TakePoints(vtkPolyData* output, vtkIdList* ids)
{
  const vtkSmartPointer<vtkDataArray> all = output->GetPoints()->GetData(); // it is replaced
  const auto places = vtkSmartPointer<vtkDataArray>::Take(all->NewInstance());
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(ids->GetNumberOfIds());
  all->GetTuples(ids, places);
  vtkNew<vtkPoints> points;
  points->SetData(places);
  output->SetPoints(points);
  vtkNew<vtkPointData> given;
  given->ShallowCopy(output->GetPointData());
  vtkAHDRemoveArraysOfOneName(given);
  for (int i = given->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (given->GetAbstractArray(i)->GetNumberOfTuples() < all->GetNumberOfTuples())
    {
      given->RemoveArray(i);
    }
  }
  vtkPointData* const data = output->GetPointData();
  data->Initialize();
  data->CopyAllOn(); // which of them are scalars, ids, normals ...
  data->CopyAllocate(given, ids->GetNumberOfIds());
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    data->GetAbstractArray(i)->SetNumberOfTuples(ids->GetNumberOfIds());
    given->GetAbstractArray(i)->GetTuples(ids, data->GetAbstractArray(i));
  }
}
}

void vtkAHDSurface::KeepPointsOfCells() const
{
  const auto count = static_cast<std::size_t>(this->Output->GetNumberOfPoints());
  const std::vector<IdArray*> corners = CornersOf(this->Output);
  std::vector<std::int32_t> numbers(count, corners.empty() ? 1 : 0);
  for (IdArray* const ids : corners)
  {
    this->Context.StopIfAborted();
    const std::int32_t* const all = ids->GetPointer(0);
    std::for_each(all, all + ids->GetNumberOfValues(),
      [&](std::int32_t id) { numbers[static_cast<std::size_t>(id)] = 1; });
  }
  const auto left = std::accumulate(numbers.begin(), numbers.end(), vtkIdType(0));
  auto kept = this->Context.NewArray<vtkIdTypeArray>(left);
  kept->SetName(vtkAHDOutputArrays::OriginalPointIds.Name);
  vtkIdType next = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (numbers[i] != 0)
    {
      kept->SetValue(next, static_cast<vtkIdType>(i));
      numbers[i] = static_cast<std::int32_t>(next++);
    }
  }
  if (left < static_cast<vtkIdType>(count))
  {
    for (IdArray* const ids : corners)
    {
      std::int32_t* const all = ids->GetPointer(0);
      std::transform(all, all + ids->GetNumberOfValues(), all,
        [&](std::int32_t id) { return numbers[static_cast<std::size_t>(id)]; });
    }
    vtkNew<vtkIdList> ids;
    ids->SetNumberOfIds(left);
    std::copy_n(kept->GetPointer(0), left, ids->GetPointer(0));
    this->Context.StopIfAborted();
    TakePoints(this->Output, ids);
  }
  vtkAHDReplaceArray(this->Output->GetPointData(), kept);
}

void vtkAHDSurface::AddCrossings(const ahd::RunResult& made) const
{
  std::vector<std::array<std::int64_t, 2>> cells(made.crossingRows());
  for (std::size_t row = 0; row < cells.size(); ++row)
  {
    cells[row] = made.crossingRow(row);
  }
  WriteCrossings(cells, this->Output);
}

void vtkAHDSurface::WriteCrossings(
  const std::vector<std::array<std::int64_t, 2>>& cells, vtkPolyData* output)
{
  if (cells.empty())
  {
    output->GetFieldData()->RemoveArray(vtkAHDOutputArrays::Crossings.Name); // the input's
    return;
  }
  const std::size_t count = std::min(cells.size(), ahd::kMostCrossingRows);
  auto rows = vtkAHDNewArray<vtkIdTypeArray>(2 * static_cast<vtkIdType>(count));
  rows->SetNumberOfComponents(vtkAHDOutputArrays::Crossings.Components);
  rows->SetName(vtkAHDOutputArrays::Crossings.Name);
  for (std::size_t i = 0; i < count; ++i)
  {
    rows->SetValue(static_cast<vtkIdType>(2 * i), static_cast<vtkIdType>(cells[i][0]));
    rows->SetValue(static_cast<vtkIdType>(2 * i + 1), static_cast<vtkIdType>(cells[i][1]));
  }
  output->GetFieldData()->AddArray(rows);
}
