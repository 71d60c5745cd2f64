// SPDX-License-Identifier: BSD-3-Clause
#include "Input/vtkAHDInput.h"

#include "vtkCellArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

namespace
{
static_assert(sizeof(vtkTypeInt64) == sizeof(std::int64_t), "the same numbers here and there");

ahd::CellsView View(vtkCellArray* cells)
{
  ahd::CellsView view;
  view.cells = static_cast<std::size_t>(cells->GetNumberOfCells());
  view.ids = static_cast<std::size_t>(cells->GetNumberOfConnectivityIds());
  if (view.ids == 0)
  {
    view.cells = 0;
  }
  else if (cells->IsStorage64Bit())
  {
    // long and long long are one type in two names
    view.offsets64 = reinterpret_cast<const std::int64_t*>(
      cells->GetOffsetsArray64()->GetPointer(0));
    view.ids64 = reinterpret_cast<const std::int64_t*>(
      cells->GetConnectivityArray64()->GetPointer(0));
  }
  else
  {
    view.offsets32 = cells->GetOffsetsArray32()->GetPointer(0);
    view.ids32 = cells->GetConnectivityArray32()->GetPointer(0);
  }
  return view;
}

/// The points of the source, if they are to be triangulated.
vtkPoints* PointsToAdd(const vtkAHDSettings& settings, vtkPolyData* source)
{
  return settings.AddSourcePoints && source ? source->GetPoints() : nullptr;
}
}

vtkAHDInput::vtkAHDInput(const vtkAHDSettings& settings, vtkPointSet* input, vtkPolyData* source)
  : Input(input)
  , Source(source)
  , InputPoints(input->GetPoints())
  , SourcePoints(PointsToAdd(settings, source))
  , Projection(settings.Transform)
{
  this->Request.points.count = this->InputPoints.GetCount();
  this->Request.sourcePoints.count = this->SourcePoints.GetCount();
  this->Request.fitPlane = settings.FitPlane;
  this->Request.projection = settings.Transform ? &this->Projection : nullptr;
  this->Request.tolerance = settings.Tolerance;
  this->Request.bounding = settings.AddsBounding();
  this->Request.offset = settings.Offset;
  this->Request.split = settings.Split;
  this->Request.idsAreOfInput = settings.SourceIdsAreOfInput;
  this->Request.closedLinesAreLoops = settings.ClosedLinesAreLoops;
  this->Request.heightsFromSurface = settings.HeightsFromSurface;
  this->Request.representative = settings.Insertion.representative;
  this->Request.meanHeights = settings.ShowMeans;
  this->ReadMarks();
  if (source)
  {
    this->ReadCells(source);
  }
}

void vtkAHDInput::ReadCells(vtkPolyData* source)
{
  this->Request.firstCell = source->GetNumberOfVerts(); // verts come before lines
  this->Request.lines = View(source->GetLines());
  this->Request.polygons = View(source->GetPolys());
  this->Found.Points = source->GetNumberOfPoints();
  this->Found.Vertices = source->GetNumberOfVerts();
  this->Found.Strips = source->GetNumberOfStrips();
}

void vtkAHDInput::ReadMarks()
{
  vtkUnsignedCharArray* marks = this->Input->GetPointGhostArray();
  const bool fit = marks && marks->GetNumberOfComponents() == 1 &&
    marks->GetNumberOfTuples() == static_cast<vtkIdType>(this->Request.points.count);
  this->MarksAreUnfit = !fit && this->Request.points.count > 0 &&
    this->Input->GetPointData()->HasArray(vtkDataSetAttributes::GhostArrayName()) != 0;
  if (fit && this->Request.points.count > 0)
  {
    this->Request.points.skip = marks->GetPointer(0);
    this->Request.points.skipMask = vtkDataSetAttributes::DUPLICATEPOINT |
      vtkDataSetAttributes::HIDDENPOINT;
  }
}

void vtkAHDInput::Open(const vtkAHDContext& context)
{
  ahd::PointView points = this->InputPoints.Open(context);
  points.skip = this->Request.points.skip;
  points.skipMask = this->Request.points.skipMask;
  this->Request.points = points;
  this->Request.sourcePoints = this->SourcePoints.Open(context);
  this->Projection.SetContext(context);
}

vtkPolyData* vtkAHDInput::GetSourceOfPoints() const
{
  return this->Request.sourcePoints.count > 0 ? this->Source : nullptr;
}
