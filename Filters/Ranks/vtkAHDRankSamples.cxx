// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankSamples.h"

#include "Pipeline/vtkAHDArray.h"
#include "Ranks/vtkAHDRankGather.h"
#include "Ranks/vtkAHDRankMemory.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>

vtkAHDRankSamples::vtkAHDRankSamples(const vtkAHDSettings& settings, vtkAHDRanks& ranks,
  const vtkAHDContext& context, ahd::BlockNeeds::Also also, std::string& error)
  : Settings(settings)
  , LocalSettings(settings)
  , Ranks(ranks)
  , Context(context)
  , Also(also)
  , Error(error)
{
}

vtkAHDRankSamples::~vtkAHDRankSamples() = default;

void vtkAHDRankSamples::Begin(const vtkAHDDataSets& data, ahd::Status before)
{
  vtkAHDCheckBefore(before, this->Ranks, this->Context, this->Error);
  vtkAHDMeet(this->Settings, data, this->Ranks, this->Context, this->Facts);
  this->Facts.Compare(this->Settings, this->Error);
  const std::string partial = this->Facts.GetPartialArrays();
  if (!partial.empty())
  {
    this->Warning = "Point data arrays that not all ranks have, of one type and with one value for "
                    "each point, are not interpolated: " +
      partial + ".";
  }
  const char* const unfit = this->Facts.FindUnfit(this->Settings);
  this->Setting = unfit             ? unfit
    : this->Settings.fitsPlane()    ? "the plane that fits all points best"
    : this->Settings.addsBounding() ? "BoundingTriangulation"
    : this->Settings.mayTrimRim()   ? "Rim Trimmed"
                                    : nullptr;
  if (this->IsWhole())
  {
    this->TakeAll(data);
    return;
  }
  this->Points.reset(new vtkAHDRankPoints(this->Settings, this->Ranks, this->Facts, this->Context));
  this->Points->Read(data.Input, data.Source);
  this->Points->JoinChains(this->Chains);
  this->Points->MoveToOwners();
  this->ShareOwn();
}

/// Refuses on all ranks what takes more than there is on one of them.
void vtkAHDRankSamples::CheckMemory(std::size_t bytes)
{
  this->Error = vtkAHDRefuseMemory(this->Settings, this->Facts, this->Ranks, this->Context, bytes,
    { "Interpolating between", this->GetPoints() });
  if (!this->Error.empty())
  {
    throw vtkAHDStop{ ahd::Status::OutOfMemory };
  }
}

/// One rank after the other gets all.
void vtkAHDRankSamples::TakeAll(const vtkAHDDataSets& data)
{
  for (std::size_t rank = 0; rank < this->Ranks.GetCount(); ++rank)
  {
    vtkAHDRankGather gather(this->Settings, this->Ranks, this->Facts, this->Context);
    gather.Measure(data);
    if (rank == 0)
    {
      this->CheckMemory(gather.EstimateBytes() + gather.EstimateBytesOnTheWay());
    }
    gather.MoveTo(rank, data);
    if (rank == this->Ranks.GetOwn())
    {
      this->Input = gather.GetInput();
      this->Source = gather.GetSource();
    }
  }
}

/// Each rank triangulates its own points, with those that all ranks need.
void vtkAHDRankSamples::ShareOwn()
{
  using Needs = ahd::BlockNeeds;
  const std::size_t ids = this->Chains.idCount();
  // Where a limit on size ends the surface beside a constraint, that hides vertices, too.
  const bool hides = this->Also == Needs::Also::Nearest && ids > 0 && this->Settings.limitsSize();
  const Needs::Also also = hides ? Needs::Also::All : this->Also;
  this->CheckMemory(this->Points->EstimateBytes() +
    ahd::needsMemoryEstimate(this->Points->GetCount() + ids, ids, also == Needs::Also::Nearest));
  this->Ranks.Together(this->Context,
    [&]
    {
      this->Needs.reset(new ahd::BlockNeeds(
        this->Points->GetBlock(this->Chains), also, this->Ranks, this->Context));
    });
  this->Context.Check(this->Needs->begin());
}

void vtkAHDRankSamples::Take(const std::vector<ahd::Bounds>& boxes)
{
  if (this->IsWhole())
  {
    return;
  }
  std::vector<ahd::BlockPoint> needed;
  this->Context.Check(this->Needs->find(boxes, needed));
  this->Needs.reset();
  this->MoveNeeded(needed);
  this->Points.reset();
  this->Ranks.Together(this->Context, [&] { this->MakeSource(needed); });
  const ahd::BlockPoint first = { static_cast<std::int64_t>(this->Facts.GetPoints()), 0 };
  this->AddedPoints = static_cast<std::size_t>(
    needed.end() - std::lower_bound(needed.begin(), needed.end(), first));
  this->LocalSettings.sourceHeights = ahd::SourceHeights::Own;
  this->LocalSettings.idsAreOfInput = true;
  this->LocalSettings.closedLinesAreLoops = false;
  this->LocalSettings.split = false;
}

/// Places and data, as far as all ranks have it.
void vtkAHDRankSamples::MoveNeeded(const std::vector<ahd::BlockPoint>& needed)
{
  vtkAHDRoute route(this->Ranks, this->Context);
  this->Context.Check(route.ask(needed, this->Points->GetIds()));
  vtkSmartPointer<vtkDataArray> places;
  this->Ranks.Together(this->Context,
    [&]
    {
      this->Input = vtkSmartPointer<vtkPolyData>::New();
      const bool areFloats = this->Points->GetPlaces()->GetDataType() == VTK_FLOAT;
      places = vtkAHDMakePlaces(needed.size(), areFloats);
    });
  route.Move(this->Points->GetPlaces(), places, 0);
  this->Ranks.Together(this->Context,
    [&]
    {
      vtkNew<vtkPoints> points;
      points->SetData(places);
      this->Input->SetPoints(points);
    });
  for (const vtkAHDArrayFacts& facts : this->Facts.GetArrays())
  {
    vtkAbstractArray* from = this->Points->GetDataToMove()->GetAbstractArray(facts.Name.c_str());
    vtkSmartPointer<vtkAbstractArray> owned, moved;
    this->Ranks.Together(this->Context,
      [&]
      {
        owned = facts.Make(this->Points->GetCount());
        moved = facts.Make(needed.size());
      });
    this->Points->GetRoute().Move(from, owned, 0);
    route.Move(owned, moved, 0);
    this->Ranks.Together(this->Context, [&] { facts.AddTo(this->Input->GetPointData(), moved); });
  }
}

/// The constraints of all, in numbers of the points that are here.
void vtkAHDRankSamples::MakeSource(const std::vector<ahd::BlockPoint>& needed)
{
  const ahd::ConstraintView given = this->Chains.view();
  vtkNew<vtkCellArray> lines, polygons;
  for (std::size_t chain = 0; chain < given.chains; ++chain)
  {
    vtkCellArray* cells = chain < given.lines ? lines : polygons;
    cells->InsertNextCell(static_cast<int>(given.offsets[chain + 1] - given.offsets[chain]));
    for (std::int64_t i = given.offsets[chain]; i < given.offsets[chain + 1]; ++i)
    {
      const ahd::BlockPoint point = { given.ids[i], 0 };
      const auto found = std::lower_bound(needed.begin(), needed.end(), point);
      const bool isHere = found != needed.end() && *found == point;
      cells->InsertCellPoint(isHere ? static_cast<vtkIdType>(found - needed.begin()) : -1);
    }
  }
  this->Source = vtkSmartPointer<vtkPolyData>::New();
  this->Source->SetLines(lines);
  this->Source->SetPolys(polygons);
}
