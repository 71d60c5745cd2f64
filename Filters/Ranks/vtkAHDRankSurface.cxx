// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankSurface.h"

#include "Engine/Surface/Means.h"
#include "Engine/Surface/Selection.h"
#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDAttributes.h"
#include "Pipeline/vtkAHDOutputArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <vector>

namespace
{
template <typename Array>
vtkSmartPointer<Array> MakeArray(const char* name, std::size_t count)
{
  auto array = vtkAHDNewArray<Array>(static_cast<vtkIdType>(count));
  array->SetName(name);
  return array;
}
}

vtkAHDRankSurface::vtkAHDRankSurface(const vtkAHDSettings& settings, vtkAHDRanks& ranks,
  const vtkAHDAllFacts& facts, const vtkAHDContext& context, vtkAHDRankPoints& points,
  ahd::BlockTriangulation& triangulation)
  : Settings(settings)
  , Ranks(ranks)
  , Facts(facts)
  , Context(context)
  , Points(points)
  , Triangulation(triangulation)
  , Foreign(ranks, context)
  , Own(points.GetCount())
  , All(points.GetCount())
  , Ghosts(this->Stars, ranks, context.WithoutPhases())
{
  this->Stars.block = ranks.GetOwn();
  this->Stars.blocks = ranks.GetCount();
  this->Stars.ids = points.GetIds().data();
  this->Stars.points = this->Own;
  this->Stars.foreign = &triangulation.foreignPoints();
}

std::size_t vtkAHDRankSurface::EstimateBytes(
  std::size_t pointCount, const vtkAHDSettings& settings, const vtkAHDAllFacts& facts)
{
  const bool hasGhosts = facts.GetGhostLevels() > 0;
  constexpr std::size_t kId = sizeof(vtkIdType);
  std::size_t perPoint = 3 * sizeof(double) + kId + 1 +
    (settings.wants(ahd::WantedArray::PointStatus) ? kId : 0);
  std::size_t widest = 0; // of strings that are moved at one time, sent and received
  for (const vtkAHDArrayFacts& array : facts.GetArrays())
  {
    constexpr std::size_t kMost = 32; // a short string; no number is larger
    const std::size_t width = static_cast<std::size_t>(array.Components) *
      (array.Type == VTK_STRING ? kMost : sizeof(double));
    perPoint += width;
    widest = array.Type == VTK_STRING ? std::max(widest, width) : widest;
  }
  const std::size_t perTriangle = (3 + 1) * sizeof(vtkTypeInt32) + kId +
    (settings.wants(ahd::WantedArray::ConstraintEdges) ? 2 : 0) + (hasGhosts ? 1 : 0);
  const bool hasPlaces = settings.limitsSize() || settings.mayTrimRim();
  // a pair of numbers for each duplicate, as a vector grows, a mean, and the vertex of each point
  perPoint += settings.showsMeans
    ? 4 * sizeof(std::size_t) + 2 * sizeof(ahd::Mean) + sizeof(ahd::Index)
    : 0;
  perPoint += (hasPlaces ? sizeof(ahd::Point) + 2 : 0) + (hasGhosts ? 1 : 0) +
    (settings.mayTrimRim() ? ahd::kRimBytesPerPoint : 0);
  return pointCount * (perPoint + 2 * widest + 2 * perTriangle);
}

/// A ghost is read, or is sent, comes, is kept and sorted; it has three points at most that come
/// with it, each of them asked for.
std::size_t vtkAHDRankSurface::EstimateGhostBytes(
  std::size_t cellCount, const vtkAHDSettings& settings, const vtkAHDAllFacts& facts)
{
  constexpr std::size_t kPerPoint = 6 * sizeof(ahd::BlockPoint) + 8 * sizeof(vtkIdType);
  return cellCount * (5 * sizeof(ahd::GhostTriangle) + 3 * kPerPoint) +
    EstimateBytes(3 * cellCount, settings, facts);
}

void vtkAHDRankSurface::WritePlaces(vtkPolyData* output)
{
  vtkSmartPointer<vtkDataArray> all;
  this->Ranks.Together(this->Context,
    [&]
    {
      std::vector<ahd::Mean> means;
      if (this->Settings.showsMeans)
      {
        this->FindMeans(means);
      }
      all = this->Points.TakePlaces(this->All);
      for (const ahd::Mean& mean : means)
      {
        all->SetTuple(static_cast<vtkIdType>(mean.id), mean.position.data());
      }
    });
  this->Foreign.Move(all, all, this->Own);
  vtkNew<vtkPoints> points;
  points->SetData(all);
  output->SetPoints(points);
}

/// Where own points that stand for several at one place are shown: at their mean. All at a place
/// are on one rank. @pre the places have not been taken.
void vtkAHDRankSurface::FindMeans(std::vector<ahd::Mean>& means)
{
  const ahd::PointView own = vtkAHDViewOf(this->Points.GetPlaces(), this->Own);
  this->Context.Check(
    ahd::findMeans(this->Triangulation.ownPoints(), this->Own, own, this->Context, means));
}

void vtkAHDRankSurface::MoveData(const vtkAHDArrayFacts& facts, vtkPolyData* output)
{
  vtkSmartPointer<vtkAbstractArray> to;
  vtkAbstractArray* from = this->Points.GetDataToMove()->GetAbstractArray(facts.Name.c_str());
  this->Ranks.Together(this->Context, [&] { to = facts.Make(this->All); });
  this->Points.GetRoute().Move(from, to, 0);
  this->Foreign.Move(to, to, this->Own);
  vtkPointData* data = output->GetPointData();
  const int index = data->AddArray(to);
  // global ids are this filter's own; pedigree ids would have to name each point
  const bool areAdded = this->Facts.GetSourcePoints() > 0 || this->Points.AreBounded();
  if (facts.Attribute >= 0 && facts.Attribute != vtkDataSetAttributes::GLOBALIDS &&
    !(areAdded && facts.Attribute == vtkDataSetAttributes::PEDIGREEIDS))
  {
    data->SetActiveAttribute(index, facts.Attribute);
  }
}

void vtkAHDRankSurface::WriteData(vtkPolyData* output)
{
  for (const vtkAHDArrayFacts& facts : this->Facts.GetArrays())
  {
    this->MoveData(facts, output);
  }
}

/// Points of other ranks are marked as such.
void vtkAHDRankSurface::WriteMarks(vtkPolyData* output)
{
  vtkSmartPointer<vtkUnsignedCharArray> marks;
  vtkUnsignedCharArray* own = this->Points.GetMarks();
  this->Ranks.Together(this->Context,
    [&]
    {
      marks = MakeArray<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(), this->All);
      std::fill_n(marks->GetPointer(0), this->All, static_cast<unsigned char>(0));
      if (own)
      {
        std::copy_n(own->GetPointer(0), this->Own, marks->GetPointer(0));
      }
    });
  if (own)
  {
    this->Foreign.Move(own, marks, this->Own);
  }
  for (std::size_t i = this->Own; i < this->All; ++i)
  {
    marks->GetPointer(0)[i] |= static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATEPOINT);
  }
  vtkAHDReplaceArray(output->GetPointData(), marks);
}

void vtkAHDRankSurface::WriteIds(vtkPolyData* output)
{
  auto ids = MakeArray<vtkIdTypeArray>(vtkAHDOutputArrays::GlobalPointIds.Name, this->All);
  vtkIdType* to = std::copy(
    this->Points.GetIds().begin(), this->Points.GetIds().end(), ids->GetPointer(0));
  for (const ahd::BlockPoint& point : this->Others)
  {
    *to++ = static_cast<vtkIdType>(point.id);
  }
  vtkAHDReplaceArray(output->GetPointData(), ids);
  output->GetPointData()->SetActiveAttribute(
    vtkAHDOutputArrays::GlobalPointIds.Name, vtkDataSetAttributes::GLOBALIDS);
}

/// The points of others that are here are vertices. @pre the places have not been taken, as
/// the triangulation looks at them.
void vtkAHDRankSurface::MakeStatus()
{
  auto array = MakeArray<vtkIdTypeArray>(vtkAHDOutputArrays::Fate.Name, this->All);
  std::vector<std::int64_t> status(this->Own);
  this->Context.Check(this->Triangulation.writePointStatus(status.data(), this->Context));
  vtkIdType* to = std::copy(status.begin(), status.end(), array->GetPointer(0));
  for (const ahd::BlockPoint& point : this->Others)
  {
    *to++ = static_cast<vtkIdType>(point.id);
  }
  this->Status = array;
}

void vtkAHDRankSurface::Select()
{
  const bool isLimited = this->Settings.limits.maximumEdgeLength > 0.0;
  const bool trims = this->Settings.trimsRim(this->Points.GetPrepared().plane());
  this->Ranks.Together(this->Context,
    [&]
    {
      this->ReadTriangles();
      if (this->Facts.GetGhostLevels() > 0 || trims)
      {
        this->ReadAround();
      }
      if (isLimited || trims)
      {
        this->ListPlaces();
      }
      if (isLimited)
      {
        this->KeepShort(this->Stars.own);
        this->KeepShort(this->Stars.around);
      }
    });
  if (trims)
  {
    this->Context.Check(ahd::trimBlocks(
      this->Places, this->Ranks, this->Context.WithoutPhases(), this->Stars, this->Rim));
  }
  this->Places = std::vector<ahd::Point>();
}

bool vtkAHDRankSurface::HasPointOfInput() const
{
  const auto inputs = static_cast<std::int64_t>(this->Facts.GetPoints()); // sources' ids are larger
  const ahd::BlockTriangles& own = this->Stars.own;
  return std::any_of(own.corners, own.corners + 3 * own.count,
    [this, inputs](vtkTypeInt32 corner) { return this->Stars.point(corner).id < inputs; });
}

/// Makes room for so many.
void vtkAHDRankSurface::Open(
  std::size_t count, Triangles& triangles, ahd::BlockTriangles& view) const
{
  triangles.Corners = vtkAHDNewArray<vtkTypeInt32Array>(static_cast<vtkIdType>(3 * count));
  triangles.Edges.resize(this->Settings.wants(ahd::WantedArray::ConstraintEdges) ? count : 0);
  view.corners = triangles.Corners->GetPointer(0);
  view.edges = triangles.Edges.empty() ? nullptr : triangles.Edges.data();
  view.count = count;
}

void vtkAHDRankSurface::ReadTriangles()
{
  ahd::BlockTriangles& own = this->Stars.own;
  this->Open(this->Triangulation.triangles(), this->Cells, own);
  own.inside = this->Triangulation.insideTriangles();
  this->Context.Check(this->Triangulation.writeTriangles(own.corners, this->Context));
  if (own.edges)
  {
    this->Context.Check(this->Triangulation.writeConstraintEdges(own.edges, this->Context));
  }
}

void vtkAHDRankSurface::ReadAround()
{
  ahd::BlockTriangles& around = this->Stars.around;
  this->Open(this->Triangulation.ghostTriangles(), this->Around, around);
  this->Context.Check(this->Triangulation.writeGhostTriangles(around.corners, this->Context));
  if (around.edges)
  {
    this->Context.Check(this->Triangulation.writeGhostConstraintEdges(around.edges, this->Context));
  }
}

void vtkAHDRankSurface::ListPlaces()
{
  std::vector<ahd::Point>& places = this->Places;
  places.reserve(this->Own + this->Triangulation.foreignPoints().size());
  const ahd::PointView own = this->Points.GetView();
  for (std::size_t i = 0; i < this->Own; ++i)
  {
    places.push_back(own[i]);
  }
  for (const ahd::ForeignPoint& point : this->Triangulation.foreignPoints())
  {
    places.push_back(point.at);
  }
}

void vtkAHDRankSurface::KeepShort(ahd::BlockTriangles& triangles) const
{
  const std::vector<ahd::Point>& places = this->Places;
  const ahd::PointView view(places.empty() ? nullptr : &places[0].x, places.size(), 2);
  std::vector<unsigned char> kept;
  this->Context.Check(ahd::findShort(triangles.corners, triangles.count, view,
    this->Settings.limits.maximumEdgeLength, this->Context, kept));
  triangles.keep(kept.data());
}

/// Of the points of others only those that are corners of the output; own triangles get their
/// numbers.
void vtkAHDRankSurface::ListOthers()
{
  const std::vector<ahd::ForeignPoint>& known = this->Triangulation.foreignPoints();
  std::vector<unsigned char> isUsed(known.size(), 0);
  const ahd::BlockTriangles& own = this->Stars.own;
  vtkTypeInt32* const begin = own.corners + 3 * own.inside;
  vtkTypeInt32* const end = own.corners + 3 * own.count;
  for (const vtkTypeInt32* corner = begin; corner != end; ++corner)
  {
    if (!this->Stars.isOwn(*corner))
    {
      isUsed[static_cast<std::size_t>(*corner) - this->Own] = 1;
    }
  }
  for (std::size_t k = 0; k < known.size(); ++k)
  {
    if (isUsed[k] != 0)
    {
      this->Others.push_back({ known[k].id, known[k].block });
    }
  }
  this->Context.Check(this->Ghosts.addForeign(this->Others));
  this->All = this->Own + this->Others.size();
  for (vtkTypeInt32* corner = begin; corner != end; ++corner)
  {
    if (!this->Stars.isOwn(*corner))
    {
      *corner = this->NumberOf(this->Stars.point(*corner));
    }
  }
}

/// In the output.
vtkTypeInt32 vtkAHDRankSurface::NumberOf(const ahd::BlockPoint& corner) const
{
  const std::vector<std::int64_t>& ids = this->Points.GetIds();
  if (corner.block == this->Ranks.GetOwn())
  {
    return static_cast<vtkTypeInt32>(
      std::lower_bound(ids.begin(), ids.end(), corner.id) - ids.begin());
  }
  const auto found = std::lower_bound(this->Others.begin(), this->Others.end(), corner);
  return static_cast<vtkTypeInt32>(this->Own + std::size_t(found - this->Others.begin()));
}

/// The memory of own triangles becomes that of the output.
void vtkAHDRankSurface::WriteCorners(vtkPolyData* output)
{
  const std::vector<ahd::GhostTriangle>& ghosts = this->Ghosts.triangles();
  const std::size_t own = this->GetCellCount(), count = own + ghosts.size();
  if (count > static_cast<std::size_t>(VTK_TYPE_INT32_MAX) / 3)
  {
    throw vtkAHDStop{ ahd::Status::TooManyPoints };
  }
  auto offsets = vtkAHDNewArray<vtkTypeInt32Array>(static_cast<vtkIdType>(count + 1));
  vtkAHDResizeArray(this->Cells.Corners.Get(), static_cast<vtkIdType>(3 * count));
  vtkTypeInt32* to = this->Cells.Corners->GetPointer(0) + 3 * own;
  for (const ahd::GhostTriangle& ghost : ghosts)
  {
    for (const ahd::BlockPoint& corner : ghost.corners)
    {
      *to++ = this->NumberOf(corner);
    }
  }
  vtkTypeInt32* const offset = offsets->GetPointer(0);
  this->Context.ForRange(count + 1,
    [offset](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        offset[t] = static_cast<vtkTypeInt32>(3 * t);
      }
    });
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, this->Cells.Corners);
  this->Cells.Corners = nullptr;
  output->SetPolys(cells);
}

void vtkAHDRankSurface::WriteCells(vtkPolyData* output, std::size_t firstCell)
{
  const std::vector<ahd::GhostTriangle>& ghosts = this->Ghosts.triangles();
  const std::size_t own = this->GetCellCount(), count = own + ghosts.size();
  this->WriteCorners(output);
  vtkCellData* data = output->GetCellData();
  auto ids = MakeArray<vtkIdTypeArray>(vtkAHDOutputArrays::GlobalCellIds.Name, count);
  vtkIdType* const id = ids->GetPointer(0);
  this->Context.ForRange(own,
    [id, firstCell](std::size_t begin, std::size_t end)
    { std::iota(id + begin, id + end, static_cast<vtkIdType>(firstCell + begin)); });
  for (std::size_t k = 0; k < ghosts.size(); ++k)
  {
    ids->GetPointer(0)[own + k] = static_cast<vtkIdType>(ghosts[k].id);
  }
  if (this->Settings.wants(ahd::WantedArray::ConstraintEdges))
  {
    auto edges = MakeArray<vtkUnsignedCharArray>(vtkAHDOutputArrays::ConstraintEdges.Name, count);
    unsigned char* to = std::copy_n(this->Cells.Edges.begin(), own, edges->GetPointer(0));
    for (const ahd::GhostTriangle& ghost : ghosts)
    {
      *to++ = static_cast<unsigned char>(ghost.edges);
    }
    data->AddArray(edges);
  }
  if (this->Facts.GetGhostLevels() > 0)
  {
    auto marks = MakeArray<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(), count);
    std::fill_n(marks->GetPointer(0), own, static_cast<unsigned char>(0));
    std::fill_n(marks->GetPointer(0) + own, ghosts.size(),
      static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATECELL));
    data->AddArray(marks);
  }
  data->SetGlobalIds(ids);
}

void vtkAHDRankSurface::Write(vtkPolyData* output, std::size_t firstCell)
{
  this->Ranks.Together(this->Context,
    [&]
    {
      this->ListOthers();
      if (this->Settings.wants(ahd::WantedArray::PointStatus))
      {
        this->MakeStatus();
      }
    });
  this->Context.Check(this->Foreign.ask(this->Others, this->Points.GetIds()));
  this->WritePlaces(output);
  this->WriteData(output);
  this->WriteMarks(output);
  this->Ranks.Together(this->Context,
    [&]
    {
      this->WriteIds(output);
      if (this->Status)
      {
        vtkAHDReplaceArray(output->GetPointData(), this->Status);
      }
      this->WriteCells(output, firstCell);
    });
}
