// SPDX-License-Identifier: BSD-3-Clause
#include "Output/vtkAHDOrderOutput.h"

#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDContext.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace
{
constexpr std::size_t kCorners = 4; // of a box

/// An array `name` of one vtkIdType per tuple, added to `data`; returns its values.
vtkIdType* AddIds(vtkDataSetAttributes* data, const char* name, std::size_t tuples)
{
  auto array = vtkAHDNewArray<vtkIdTypeArray>(static_cast<vtkIdType>(tuples));
  array->SetName(name);
  data->AddArray(array);
  return array->GetPointer(0);
}
}

vtkAHDOrderOutput::vtkAHDOrderOutput(
  const ahd::PreparedInput& points, ahd::Triangulation& triangulation, const vtkAHDContext& context)
  : Points(points)
  , Triangulation(triangulation)
  , Context(context)
  , Inserted(triangulation.report().inserted)
  , Boxes(triangulation.boxes().size())
{
}

std::size_t vtkAHDOrderOutput::EstimateBytes(std::size_t pointCount)
{
  const std::size_t perPoint = sizeof(std::int64_t) // the engine's order
    + 3 * sizeof(double) + 2 * sizeof(vtkIdType)    // point and point data
    + sizeof(vtkTypeInt64);                         // its place in the curve
  return pointCount * perPoint + 1024;              // and the ends
}

std::size_t vtkAHDOrderOutput::EstimateBoxBytes(std::size_t boxCount)
{
  const std::size_t perCorner = 3 * sizeof(double) + 2 * sizeof(vtkIdType) + sizeof(vtkTypeInt64);
  const std::size_t perCell = sizeof(vtkTypeInt64) + sizeof(int) + sizeof(vtkIdType);
  return boxCount * (2 * sizeof(ahd::GridBox) + kCorners * perCorner + perCell);
}

void vtkAHDOrderOutput::Write(bool withCurve, vtkPolyData* output)
{
  this->WritePoints(output);
  const bool curve = withCurve && this->Inserted >= 2;
  const bool narrow = this->Inserted + kCorners * this->Boxes <= std::size_t(VTK_TYPE_INT32_MAX);
  narrow ? this->WriteCells<vtkTypeInt32Array>(curve, output)
         : this->WriteCells<vtkTypeInt64Array>(curve, output);
  this->WriteCellData(curve, output);
}

void vtkAHDOrderOutput::WritePoints(vtkPolyData* output)
{
  const std::size_t count = this->Inserted + kCorners * this->Boxes;
  auto coordinates = vtkAHDNewArray<vtkDoubleArray>(static_cast<vtkIdType>(3 * count));
  coordinates->SetNumberOfComponents(3);
  double* xyz = coordinates->GetPointer(0);
  vtkIdType* ranks = AddIds(output->GetPointData(), "InsertionRank", count);
  vtkIdType* ids = AddIds(output->GetPointData(), "OriginalPointIds", count);
  this->Context.Check(this->Triangulation.writeOrder(ids, this->Context));
  this->WriteInserted(xyz, ranks, ids);
  this->WriteCorners(xyz + 3 * this->Inserted, ranks + this->Inserted, ids + this->Inserted);
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  output->SetPoints(points);
}

void vtkAHDOrderOutput::WriteInserted(double* xyz, vtkIdType* ranks, const vtkIdType* ids)
{
  this->Context.ForRange(this->Inserted,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::array<double, 3> p = this->Points.place(static_cast<std::size_t>(ids[i]));
        std::copy(p.begin(), p.end(), xyz + 3 * i);
        ranks[i] = static_cast<vtkIdType>(i);
      }
    });
}

void vtkAHDOrderOutput::WriteCorners(double* xyz, vtkIdType* ranks, vtkIdType* ids)
{
  const double z = this->Boxes > 0 ? this->FindLowestZ() : 0.0;
  const std::vector<ahd::GridBox>& boxes = this->Triangulation.boxes();
  this->Context.ForRange(this->Boxes,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const ahd::GridBox& b = boxes[i];
        const double corners[] = { b.xmin, b.ymin, z, b.xmax, b.ymin, z, //
          b.xmax, b.ymax, z, b.xmin, b.ymax, z };
        std::copy(std::begin(corners), std::end(corners), xyz + 3 * kCorners * i);
        std::fill_n(ranks + kCorners * i, kCorners, vtkIdType(-1));
        std::fill_n(ids + kCorners * i, kCorners, vtkIdType(-1));
      }
    });
}

/// Of all points that have a place in x and y, those beyond the limit and duplicates too: then the
/// boxes stay where they are while the limit changes.
double vtkAHDOrderOutput::FindLowestZ() const
{
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::atomic<double> found{ kNone };
  this->Context.ForRange(this->Points.points().count,
    [&](std::size_t begin, std::size_t end)
    {
      double least = kNone;
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::array<double, 3> p = this->Points.place(i);
        const bool counts = !this->Points.points().skipped(i) && std::isfinite(p[0]) &&
          std::isfinite(p[1]) && std::isfinite(p[2]);
        least = counts && p[2] < least ? p[2] : least;
      }
      double before = found;
      while (least < before && !found.compare_exchange_weak(before, least))
      {
      }
    });
  return found == kNone ? 0.0 : found.load();
}

template <typename IdArray>
void vtkAHDOrderOutput::WriteCells(bool withCurve, vtkPolyData* output)
{
  using Id = typename IdArray::ValueType;
  // Numbers `first`, `first` + `step`, ...
  const auto series = [this](std::size_t count, std::size_t first, std::size_t step)
  {
    auto array = vtkAHDNewArray<IdArray>(static_cast<vtkIdType>(count));
    Id* values = array->GetPointer(0);
    this->Context.ForRange(count,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          values[i] = static_cast<Id>(first + step * i);
        }
      });
    return array;
  };
  const auto makeCells = [&](std::size_t cells, std::size_t corners, std::size_t firstPoint)
  {
    auto made = vtkSmartPointer<vtkCellArray>::New();
    made->SetData(series(cells + 1, 0, corners), series(cells * corners, firstPoint, 1));
    return made;
  };
  output->SetLines(makeCells(withCurve ? 1 : 0, this->Inserted, 0));
  output->SetPolys(makeCells(this->Boxes, kCorners, this->Inserted));
}

void vtkAHDOrderOutput::WriteCellData(bool withCurve, vtkPolyData* output)
{
  const std::size_t curves = withCurve ? 1 : 0;
  auto levels = vtkAHDNewArray<vtkIntArray>(static_cast<vtkIdType>(curves + this->Boxes));
  levels->SetName("Level");
  output->GetCellData()->AddArray(levels);
  int* level = levels->GetPointer(0);
  vtkIdType* count = AddIds(output->GetCellData(), "Count", curves + this->Boxes);
  if (withCurve)
  {
    *level++ = -1;
    *count++ = static_cast<vtkIdType>(this->Inserted);
  }
  const std::vector<ahd::GridBox>& boxes = this->Triangulation.boxes();
  this->Context.ForRange(this->Boxes,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        level[i] = boxes[i].level;
        count[i] = static_cast<vtkIdType>(boxes[i].count);
      }
    });
}
