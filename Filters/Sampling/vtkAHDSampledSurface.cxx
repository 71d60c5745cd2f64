// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDSampledSurface.h"

#include "Engine/Job/SpacePoints.h"
#include "Execution/vtkAHDFingerprint.h"
#include "Output/vtkAHDPointOutput.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDOutputArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <utility>

namespace
{
/// The same points and point data, in an object of its own.
vtkSmartPointer<vtkPointSet> PointsOf(vtkPointSet* input)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->SetPoints(input->GetPoints());
  copy->GetPointData()->ShallowCopy(input->GetPointData());
  return copy;
}

vtkSmartPointer<vtkPolyData> CopyOf(vtkPolyData* source)
{
  if (!source)
  {
    return nullptr;
  }
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(source);
  return copy;
}
}

vtkAHDSampledSurface::vtkAHDSampledSurface(const vtkAHDSettings& settings, vtkPointSet* input,
  vtkPolyData* source, vtkPolyData* surface, const vtkAHDContext& context)
  : Input(PointsOf(input))
  , Source(CopyOf(source))
  , Surface(CopyOf(surface))
  , GivenMarks(this->Input->GetPointGhostArray())
{
  ahd::GivenTriangles triangles;
  if (surface)
  {
    this->Corners = PointsOf(input);
    this->Given = std::make_unique<vtkAHDGivenSurface>(this->Surface);
    triangles = this->Given->Open(context);
    this->Marks = vtkAHDMarkOthers(triangles, input->GetNumberOfPoints(), context);
    this->Corners->GetPointData()->AddArray(this->Marks);
  }
  this->View = std::make_unique<vtkAHDInput>(
    settings, surface ? this->Corners : this->Input, this->Source);
  this->View->GiveTriangles(triangles);
}

vtkAHDSampledSurface::vtkAHDSampledSurface(const vtkAHDSettings& settings, vtkPolyData* surface,
  vtkAHDLentTriangulation::ContentPointer lent, vtkSmartPointer<vtkAHDLentTriangulation> lender)
  : Input(PointsOf(surface))
  , View(std::make_unique<vtkAHDInput>(settings, this->Input, nullptr))
  , Lent(std::move(lent))
  , Lender(lender)
{
}

vtkAHDSampledSurface::~vtkAHDSampledSurface()
{
  if (this->Lent)
  {
    this->Lender->GiveBack(std::move(this->Lent));
  }
}

vtkAHDReport vtkAHDSampledSurface::Make(
  vtkAHDExecution& execution, std::size_t bytesBehind, const std::vector<double>& stagesBehind)
{
  return execution.Triangulate(this->Made, bytesBehind, stagesBehind);
}

void vtkAHDSampledSurface::Select(
  const vtkAHDSettings& settings, const vtkAHDContext& context, vtkAHDReport& report)
{
  if (this->Surface)
  {
    report.triangles = static_cast<std::size_t>(this->Surface->GetNumberOfPolys());
    this->View->GiveTriangles({});
    this->Given.reset();
    return;
  }
  if (!settings.limitsSize() || this->Made.points.points().count == 0)
  {
    return;
  }
  ahd::SpacePoints space;
  const ahd::InputRequest& opened = this->View->GetRequest();
  context.Check(space.make(opened.points, opened.sourcePoints, this->Made.points, context));
  if (settings.showsMeans)
  {
    context.Check(space.showMeans(this->Made, context));
  }
  context.Check(this->Made.select(settings, space.view(), context));
  report.triangles = this->Made.triangleCount();
}

std::vector<vtkDataArray*> vtkAHDSampledSurface::ArraysOf(
  vtkPointSet* input, vtkPolyData* source, vtkPolyData* surface)
{
  const auto pointsOf = [](vtkPointSet* set)
  { return set->GetPoints() ? set->GetPoints()->GetData() : nullptr; };
  std::vector<vtkDataArray*> arrays = { pointsOf(input), input->GetPointGhostArray() };
  if (source)
  {
    arrays.push_back(pointsOf(source));
    for (vtkCellArray* cells : { source->GetLines(), source->GetPolys() })
    {
      arrays.push_back(cells ? cells->GetConnectivityArray() : nullptr);
      arrays.push_back(cells ? cells->GetOffsetsArray() : nullptr);
    }
  }
  if (surface)
  {
    arrays.push_back(surface->GetPolys()->GetConnectivityArray());
    arrays.push_back(surface->GetCellData()->GetArray(vtkAHDOutputArrays::ConstraintEdges.Name));
  }
  return arrays;
}

bool vtkAHDSampledSurface::Identify(vtkPointSet* input, vtkPolyData* source, vtkPolyData* surface,
  const vtkAHDContext& context, Identity& found)
{
  if (source) // cells are numbered behind the vertices
  {
    found.Prints.push_back({ { std::uint64_t(source->GetNumberOfVerts()) } });
  }
  if (surface)
  {
    found.Prints.push_back({ { std::uint64_t(surface->GetNumberOfPolys()) } });
    found.Prints.push_back({ { std::uint64_t(vtkAHDCountAddedPoints(surface)) } });
  }
  for (vtkDataArray* array : ArraysOf(input, source, surface))
  {
    ahd::Fingerprint print;
    if (!vtkAHDTakeFingerprint(array, context, print))
    {
      return false;
    }
    found.Prints.push_back(print);
    found.Places.push_back(array ? array->GetVoidPointer(0) : nullptr);
  }
  return true;
}

void vtkAHDSampledSurface::Remember(
  const vtkAHDSettingsTimes& settings, const vtkAHDContext& context)
{
  this->Settings = settings;
  this->Known = Identity();
  this->IsKnown = this->View->AreInPlace(this->Made.points.points()) &&
    !this->View->NamesNumbers() &&
    Identify(this->Input, this->Source, this->Surface, context, this->Known);
}

bool vtkAHDSampledSurface::IsOf(const vtkAHDSettingsTimes& settings, vtkPointSet* input,
  vtkPolyData* source, vtkPolyData* surface, const vtkAHDContext& context) const
{
  Identity now;
  if (!this->IsKnown || this->Settings != settings ||
    !Identify(input, source, surface, context, now) || now.Prints != this->Known.Prints)
  {
    return false;
  }
  if (ArraysOf(input, source, surface) == ArraysOf(this->Input, this->Source, this->Surface))
  {
    return now.Places == this->Known.Places;
  }
  // Others of the same content: those that are held, which are read, must still be what they were,
  // where they were.
  Identity held;
  return Identify(this->Input, this->Source, this->Surface, context, held) &&
    held.Prints == this->Known.Prints && held.Places == this->Known.Places;
}

void vtkAHDSampledSurface::TakeData(vtkPointSet* input, vtkPolyData* source)
{
  this->Input->GetPointData()->ShallowCopy(input->GetPointData());
  if (this->Corners)
  {
    this->Corners->GetPointData()->ShallowCopy(input->GetPointData());
  }
  if (source)
  {
    this->Source->GetPointData()->ShallowCopy(source->GetPointData());
  }
}

void vtkAHDSampledSurface::DropData()
{
  const auto drop = [](vtkPointSet* set, vtkUnsignedCharArray* marks)
  {
    set->GetPointData()->Initialize();
    if (marks)
    {
      set->GetPointData()->AddArray(marks);
    }
  };
  drop(this->Input, this->GivenMarks);
  if (this->Corners)
  {
    drop(this->Corners, this->Marks);
  }
  if (this->Source)
  {
    this->Source->GetPointData()->Initialize();
    this->Source->GetCellData()->Initialize();
  }
  if (this->Surface)
  {
    this->Surface->GetPointData()->Initialize();
    const vtkSmartPointer<vtkDataArray> edges = this->Surface->GetCellData()->GetArray(
      vtkAHDOutputArrays::ConstraintEdges.Name);
    this->Surface->GetCellData()->Initialize();
    this->Surface->GetCellData()->AddArray(edges);
  }
}

std::size_t vtkAHDSampledSurface::CountInputBytes() const
{
  unsigned long kibibytes = this->GivenMarks ? this->GivenMarks->GetActualMemorySize() : 0;
  kibibytes += this->Input->GetPoints() ? this->Input->GetPoints()->GetActualMemorySize() : 0;
  kibibytes += this->Source ? this->Source->GetActualMemorySize() : 0;
  return 1024 * static_cast<std::size_t>(kibibytes);
}

vtkSmartPointer<vtkPointData> vtkAHDSampledSurface::MakePointData(
  const vtkAHDContext& context) const
{
  if (this->Lent) // the surface has all points
  {
    return this->Input->GetPointData();
  }
  auto all = vtkSmartPointer<vtkPointData>::New();
  vtkAHDPointOutput(*this->View, this->Made.points).WriteData(all, context);
  return all;
}

ahd::UninitialisedVector<double> vtkAHDSampledSurface::MakeHeights(
  const vtkAHDSettings& settings, const vtkAHDContext& context)
{
  const vtkAHDProgress::Silence whileTheyAreRead(context.GetProgress());
  context.StopIfAborted();
  const bool showsMeans = this->Lent ? this->Lent->ShowMeans : settings.showsMeans;
  ahd::UninitialisedVector<double> heights;
  heights.resize(this->GetPoints().points().count);
  context.Check(ahd::findHeights(
    this->GetPoints(), this->GetTriangulation(), showsMeans, context, heights.data()));
  // reads places that were given up
  context.Check(this->GetTriangulation().makeNumbersAndCorners(context));
  return heights;
}

void vtkAHDSampledSurface::GiveBack(ahd::Workspace& workspace)
{
  workspace.reclaim(std::move(this->Made.triangulation));
}
