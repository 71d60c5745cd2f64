// SPDX-License-Identifier: BSD-3-Clause
#include "Output/vtkAHDOrderOutput.h"

#include "Engine/Surface/OrderDrawing.h"
#include "Pipeline/vtkAHDOutputArrays.h"

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

namespace
{
/// Adds the array to `data`; returns its values.
template <typename Array>
typename Array::ValueType* AddArray(const vtkAHDOutputArray<Array>& row, vtkDataSetAttributes* data,
  std::size_t tuples, const vtkAHDContext& context)
{
  const auto array = row.Make(tuples, context);
  data->AddArray(array);
  return array->GetPointer(0);
}

/// Numbers `first`, `first` + `step`, ...
template <typename IdArray>
vtkSmartPointer<IdArray> Series(
  std::size_t count, std::size_t first, std::size_t step, const vtkAHDContext& context)
{
  auto array = context.NewArray<IdArray>(static_cast<vtkIdType>(count));
  auto* values = array->GetPointer(0);
  context.ForRange(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        values[i] = static_cast<typename IdArray::ValueType>(first + step * i);
      }
    });
  return array;
}

/// The curve, and the boxes behind it; of points in the order in which they are drawn.
template <typename IdArray>
void WriteCells(const ahd::DrawnOrder& drawn, vtkPolyData* output, const vtkAHDContext& context)
{
  const auto makeCells = [&](std::size_t cells, std::size_t size, std::size_t firstPoint)
  {
    auto made = vtkSmartPointer<vtkCellArray>::New();
    const auto offsets = Series<IdArray>(cells + 1, 0, size, context);
    made->SetData(offsets, Series<IdArray>(cells * size, firstPoint, 1, context));
    return made;
  };
  output->SetLines(makeCells(drawn.curves, drawn.passed, 0));
  output->SetPolys(makeCells(drawn.boxes, ahd::kBoxCorners, drawn.passed));
}
}

void vtkAHDOrderOutput::Write(ahd::Triangulation& triangulation, bool withCurve,
  vtkPolyData* output, const vtkAHDContext& context)
{
  const ahd::DrawnOrder drawn = ahd::drawnOrder(triangulation, withCurve);
  const std::size_t count = drawn.points();
  const std::size_t cells = drawn.cells();
  auto coordinates = context.NewArray<vtkDoubleArray>(static_cast<vtkIdType>(3 * count));
  coordinates->SetNumberOfComponents(3);
  ahd::OrderDrawing<vtkIdType> drawing;
  drawing.xyz = coordinates->GetPointer(0);
  drawing.ranks = AddArray(
    vtkAHDOutputArrays::InsertionRank, output->GetPointData(), count, context);
  drawing.ids = AddArray(
    vtkAHDOutputArrays::OriginalPointIds, output->GetPointData(), count, context);
  drawing.levels = AddArray(vtkAHDOutputArrays::Level, output->GetCellData(), cells, context);
  drawing.counts = AddArray(vtkAHDOutputArrays::Count, output->GetCellData(), cells, context);
  context.Check(ahd::drawOrder(triangulation, withCurve, drawing, context));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  output->SetPoints(points);
  count <= std::size_t(VTK_TYPE_INT32_MAX) ? WriteCells<vtkTypeInt32Array>(drawn, output, context)
                                           : WriteCells<vtkTypeInt64Array>(drawn, output, context);
}
