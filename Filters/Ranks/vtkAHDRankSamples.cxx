// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankSamples.h"

#include "Engine/Sample/BoxNeighbors.h"
#include "Pipeline/vtkAHDArray.h"
#include "Ranks/vtkAHDRankGather.h"
#include "Ranks/vtkAHDRankMemory.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>

vtkAHDRankSamples::vtkAHDRankSamples(const vtkAHDSettings& settings, vtkAHDRanks& ranks,
  const vtkAHDContext& context, bool asksForNearest, std::string& error)
  : Settings(settings)
  , LocalSettings(settings)
  , Ranks(ranks)
  , Context(context)
  , AsksForNearest(asksForNearest)
  , Error(error)
{
}

vtkAHDRankSamples::~vtkAHDRankSamples() = default;

void vtkAHDRankSamples::Begin(const vtkAHDDataSets& data, ahd::Status before)
{
  vtkAHDCheckBefore(before, this->Ranks, this->Context, this->Error);
  vtkAHDMeet(this->Settings, data, this->Ranks, this->Context, this->Facts);
  const std::string difference = this->Facts.FindDifference(this->Settings);
  if (!difference.empty())
  {
    this->Error = difference +
      ". Points are distributed over ranks only where all have the same settings. Nothing was "
      "computed.";
    throw vtkAHDStop{ ahd::Status::Cancelled };
  }
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
  this->Chains.Gather(*this->Points, this->Ranks, this->Context);
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

/// Each rank triangulates its own points, with what all have to have.
void vtkAHDRankSamples::ShareOwn()
{
  this->CheckMemory(this->Points->EstimateBytes() +
    vtkAHDRankPart::EstimateBytes(this->Points->GetCount() + this->Chains.GetIdCount(),
      this->Chains.GetIdCount(), this->AsksForNearest));
  this->Part.reset(new vtkAHDRankPart(*this->Points, this->Context));
  std::vector<vtkAHDRankPlace> shared;
  ahd::BlockBytes own;
  std::vector<ahd::BlockBytes> all;
  this->Ranks.Together(this->Context,
    [&]
    {
      this->Part->ListShared(this->Chains, this->Chains.HaveLoops(), shared);
      ahd::BytesWriter(own).writeAll(shared);
    });
  this->Context.Check(this->Ranks.gather(own, all));
  this->Ranks.Together(this->Context,
    [&]
    {
      shared.clear();
      for (const ahd::BlockBytes& bytes : all)
      {
        ahd::BytesReader(bytes).readAll(shared);
      }
      std::sort(shared.begin(), shared.end());
      this->Part->Make(this->Settings, this->Chains, shared, this->AsksForNearest);
    });
  this->ListsAll = this->MustTakeAll();
}

/// Could others' points that a rank does not have change the order of those that it has, or which
/// constraints are left out? The same on all ranks.
bool vtkAHDRankSamples::MustTakeAll()
{
  struct Facts
  {
    std::uint64_t Crowd, Crosses;
    ahd::Bounds Bounds;
  };
  ahd::BlockBytes own;
  std::vector<ahd::BlockBytes> all;
  this->Ranks.Together(this->Context,
    [&]
    {
      const Facts facts{ this->Part->FindCrowd(), this->Part->HasCrossings(),
        this->Part->GetOwnBounds() };
      ahd::BytesWriter(own).write(facts);
    });
  this->Context.Check(this->Ranks.gather(own, all));
  bool crosses = false;
  std::uint64_t most = 0;
  const ahd::Bounds bounds = this->GetBounds();
  for (const ahd::BlockBytes& bytes : all)
  {
    const auto one = ahd::BytesReader(bytes).read<Facts>();
    std::uint64_t together = one.Crowd;
    for (const ahd::BlockBytes& otherBytes : all)
    {
      const auto other = ahd::BytesReader(otherBytes).read<Facts>();
      const bool isOther = &otherBytes != &bytes;
      together += isOther && ahd::shareBox(bounds, one.Bounds, other.Bounds) ? other.Crowd : 0;
    }
    most = std::max(most, together);
    crosses = crosses || one.Crosses != 0;
  }
  return crosses || most > ahd::crowdLimit();
}

void vtkAHDRankSamples::Take(const std::vector<ahd::Bounds>& boxes)
{
  if (this->IsWhole())
  {
    return;
  }
  std::vector<std::int64_t> ids;
  std::vector<std::size_t> owners;
  this->FindNeeded(boxes, ids, owners);
  this->Part.reset();
  this->MoveNeeded(ids, owners);
  this->Points.reset();
  this->Ranks.Together(this->Context, [&] { this->MakeSource(ids); });
  const auto first = static_cast<std::int64_t>(this->Facts.GetPoints());
  this->AddedPoints = static_cast<std::size_t>(
    ids.end() - std::lower_bound(ids.begin(), ids.end(), first));
  this->LocalSettings.AddSourcePoints = false; // they are among the others
  this->LocalSettings.heightsFromSurface = false;
  this->LocalSettings.idsAreOfInput = true;
  this->LocalSettings.closedLinesAreLoops = false;
  this->LocalSettings.split = false;
}

/// Tells all where this rank's places are, and hears which points are around them: ids, ascending.
void vtkAHDRankSamples::FindNeeded(const std::vector<ahd::Bounds>& boxes,
  std::vector<std::int64_t>& ids, std::vector<std::size_t>& owners)
{
  ahd::BlockBytes own;
  std::vector<ahd::BlockBytes> all;
  std::vector<ahd::BlockMessage> out, in;
  this->Ranks.Together(this->Context, [&] { ahd::BytesWriter(own).writeAll(boxes); });
  this->Context.Check(this->Ranks.gather(own, all));
  this->Ranks.Together(this->Context,
    [&]
    {
      for (std::size_t rank = 0; rank < all.size(); ++rank)
      {
        std::vector<ahd::Bounds> others;
        std::vector<ahd::Index> numbers;
        ahd::BytesReader(all[rank]).readAll(others);
        this->ListsAll && !others.empty() ? this->Part->ListAll(numbers)
                                          : this->Part->List(others, numbers);
        std::vector<std::int64_t> names;
        for (const ahd::Index number : numbers)
        {
          names.push_back(this->Points->GetIds()[number]);
        }
        if (!names.empty())
        {
          out.emplace_back();
          out.back().block = rank;
          ahd::BytesWriter(out.back().bytes).writeAll(names);
        }
      }
    });
  this->Context.Check(this->Ranks.exchange(out, in));
  this->Ranks.Together(this->Context,
    [&]
    {
      std::vector<std::pair<std::int64_t, std::size_t>> coming;
      for (const ahd::BlockMessage& message : in)
      {
        std::vector<std::int64_t> names;
        ahd::BytesReader(message.bytes).readAll(names);
        for (const std::int64_t name : names)
        {
          coming.emplace_back(name, message.block);
        }
      }
      std::sort(coming.begin(), coming.end());
      for (const auto& point : coming)
      {
        ids.push_back(point.first);
        owners.push_back(point.second);
      }
    });
}

/// Places and data, as far as all ranks have it.
void vtkAHDRankSamples::MoveNeeded(
  const std::vector<std::int64_t>& ids, const std::vector<std::size_t>& owners)
{
  vtkAHDRoute route(this->Ranks, this->Context);
  route.Ask(ids, owners, this->Points->GetIds());
  vtkSmartPointer<vtkDataArray> places;
  this->Ranks.Together(this->Context,
    [&]
    {
      this->Input = vtkSmartPointer<vtkPolyData>::New();
      const bool areFloats = this->Points->GetPlaces()->GetDataType() == VTK_FLOAT;
      places = vtkAHDMakePlaces(ids.size(), areFloats);
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
    vtkSmartPointer<vtkAbstractArray> owned, needed;
    this->Ranks.Together(this->Context,
      [&]
      {
        owned = facts.Make(this->Points->GetCount());
        needed = facts.Make(ids.size());
      });
    this->Points->GetRoute().Move(from, owned, 0);
    route.Move(owned, needed, 0);
    this->Ranks.Together(this->Context, [&] { facts.AddTo(this->Input->GetPointData(), needed); });
  }
}

/// The constraints of all, in numbers of the points that are here.
void vtkAHDRankSamples::MakeSource(const std::vector<std::int64_t>& ids)
{
  const ahd::ConstraintView given = this->Chains.GetView();
  vtkNew<vtkCellArray> lines, polygons;
  for (std::size_t chain = 0; chain < given.chains; ++chain)
  {
    vtkCellArray* cells = chain < given.lines ? lines : polygons;
    cells->InsertNextCell(static_cast<int>(given.offsets[chain + 1] - given.offsets[chain]));
    for (std::int64_t i = given.offsets[chain]; i < given.offsets[chain + 1]; ++i)
    {
      const auto found = std::lower_bound(ids.begin(), ids.end(), given.ids[i]);
      const bool isHere = found != ids.end() && *found == given.ids[i];
      cells->InsertCellPoint(isHere ? static_cast<vtkIdType>(found - ids.begin()) : -1);
    }
  }
  this->Source = vtkSmartPointer<vtkPolyData>::New();
  this->Source->SetPoints(this->Input->GetPoints());
  this->Source->SetLines(lines);
  this->Source->SetPolys(polygons);
}
