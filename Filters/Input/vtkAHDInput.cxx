// SPDX-License-Identifier: BSD-3-Clause
#include "Input/vtkAHDInput.h"

#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace
{
/// The points of the source, if they are triangulated.
vtkPoints* PointsToAdd(const vtkAHDSettings& settings, vtkPolyData* source)
{
  return settings.AddSourcePoints && source ? source->GetPoints() : nullptr;
}

/// The array of this name with one number for each point; null if there is none.
vtkDataArray* NumbersOf(vtkPointSet* points, const std::string& name)
{
  vtkDataArray* const array = points->GetPointData()->GetArray(name.c_str());
  const bool fits = array && array->GetNumberOfComponents() == 1 &&
    array->GetNumberOfTuples() == points->GetNumberOfPoints();
  return fits ? array : nullptr;
}

/// Appends convert(number) of each; nothing of null.
template <typename To, typename Convert>
void AppendNumbers(
  vtkDataArray* array, const vtkAHDContext& context, std::vector<To>& to, const Convert& convert)
{
  constexpr vtkIdType kPiece = vtkIdType(1) << 14;
  const vtkIdType count = array ? array->GetNumberOfTuples() : 0;
  to.reserve(to.size() + static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (i % kPiece == 0)
    {
      context.StopIfAborted();
    }
    to.push_back(convert(array->GetComponent(i, 0)));
  }
}
}

vtkAHDInput::vtkAHDInput(const vtkAHDSettings& settings, vtkPointSet* input, vtkPolyData* source)
  : Input(input)
  , Source(source)
  , InputPoints(input->GetPoints())
  , SourcePoints(PointsToAdd(settings, source))
  , Lines(source ? source->GetLines() : nullptr, "lines of the source")
  , Polygons(source ? source->GetPolys() : nullptr, "polygons of the source")
  , Projection(settings.Transform)
{
  this->Request.points.count = this->InputPoints.GetCount();
  this->Request.sourcePoints.count = this->SourcePoints.GetCount();
  settings.ask(this->Request);
  this->Request.plane = settings.Plane;
  this->Request.projection = settings.Transform ? &this->Projection : nullptr;
  this->ReadMarks();
  this->Values = this->FindNumbers(settings.hasValues, settings.ValueArrayName);
  this->Weights = this->FindNumbers(settings.hasWeights, settings.WeightArrayName);
  this->Keep = this->FindNumbers(settings.hasMarks, settings.KeepArrayName);
  this->SourceValues = this->Values && this->Request.sourcePoints.count > 0
    ? NumbersOf(source, settings.ValueArrayName)
    : nullptr;
  if (source)
  {
    this->ReadCells(source);
  }
}

void vtkAHDInput::ReadCells(vtkPolyData* source)
{
  this->Request.firstCell = source->GetNumberOfVerts(); // verts come before lines
  this->Request.lines = this->Lines.GetCounts();
  this->Request.polygons = this->Polygons.GetCounts();
  this->Found.Points = source->GetNumberOfPoints();
  this->Found.Vertices = source->GetNumberOfVerts();
  this->Found.Strips = source->GetNumberOfStrips();
  this->Request.pointsAreLine = this->Request.pointsAreLine && this->Found.Strips == 0;
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
    this->Marks = marks;
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
  this->Request.lines = this->Lines.Open(context);
  this->Request.polygons = this->Polygons.Open(context);
  this->Projection.SetContext(context);
  this->OpenNumbers(context);
}

vtkSmartPointer<vtkDataArray> vtkAHDInput::FindNumbers(bool areNamed, const std::string& name)
{
  vtkDataArray* const found = areNamed ? NumbersOf(this->Input, name) : nullptr;
  if (areNamed && !found && this->Request.points.count > 0)
  {
    this->UnfitNumbers.push_back(name);
  }
  return found;
}

/// Copies, since observers may write to the arrays, and these may be of any type.
void vtkAHDInput::OpenNumbers(const vtkAHDContext& context)
{
  const auto asItIs = [](double number) { return number; };
  AppendNumbers(this->Values, context, this->ValueCopies, asItIs);
  AppendNumbers(this->SourceValues, context, this->ValueCopies, asItIs);
  AppendNumbers(this->Weights, context, this->WeightCopies, asItIs);
  AppendNumbers(this->Keep, context, this->KeepCopies,
    [](double number) { return static_cast<unsigned char>(number != 0.0); });
  this->Numbers.values.doubles = this->Values ? this->ValueCopies.data() : nullptr;
  this->Numbers.valued = this->ValueCopies.size();
  this->Numbers.weights.doubles = this->Weights ? this->WeightCopies.data() : nullptr;
  this->Numbers.keep = this->Keep ? this->KeepCopies.data() : nullptr;
}

std::size_t vtkAHDInput::EstimateBytes() const
{
  const std::size_t own = this->Request.points.count, added = this->Request.sourcePoints.count;
  return this->InputPoints.EstimateBytes() + this->SourcePoints.EstimateBytes() +
    this->Lines.EstimateBytes() + this->Polygons.EstimateBytes() +
    (this->Values ? sizeof(double) * (own + (this->SourceValues ? added : 0)) : 0) +
    (this->Weights ? sizeof(double) * own : 0) + (this->Keep ? own : 0);
}

std::array<vtkDataArray*, 2> vtkAHDInput::FindBorrowed(const ahd::PointView& points) const
{
  const ahd::PointView& opened = this->Request.points;
  const bool arePlaces = !this->MustConvertPoints() && points.doubles == opened.doubles &&
    points.floats == opened.floats;
  const bool areMarks = points.skip && points.skip == opened.skip;
  vtkDataArray* const marks = this->Marks;
  return { { arePlaces ? this->InputPoints.GetData() : nullptr, areMarks ? marks : nullptr } };
}

bool vtkAHDInput::AreInPlace(const ahd::PointView& points) const
{
  const auto arrays = this->FindBorrowed(points);
  const void* const floats = points.floats;
  const void* const places = points.doubles ? points.doubles : floats;
  return (!arrays[0] || arrays[0]->GetVoidPointer(0) == places) &&
    (!arrays[1] || arrays[1]->GetVoidPointer(0) == points.skip);
}

vtkPolyData* vtkAHDInput::GetSourceOfPoints() const
{
  return this->Request.sourcePoints.count > 0 ? this->Source : nullptr;
}
