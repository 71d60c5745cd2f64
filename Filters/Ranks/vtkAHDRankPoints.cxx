// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankPoints.h"

#include "Engine/Distribute/BlockCuts.h"
#include "Engine/Surface/PlaneFit.h"
#include "Output/vtkAHDPointOutput.h"
#include "Pipeline/vtkAHDArray.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace
{
constexpr std::size_t kAsk = std::size_t(1) << 14; // points between two askings
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Around places; empty (Low > High) around none.
struct Box
{
  ahd::Vector3 Low = { { kInfinity, kInfinity, kInfinity } };
  ahd::Vector3 High = { { -kInfinity, -kInfinity, -kInfinity } };

  auto fields() { return std::tie(this->Low, this->High); }
  /// NaN and infinite coordinates, and empty bounds, do not count.
  void Add(const ahd::Vector3& low, const ahd::Vector3& high)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (std::isfinite(low[k]) && std::isfinite(high[k]))
      {
        this->Low[k] = std::min(this->Low[k], low[k]);
        this->High[k] = std::max(this->High[k], high[k]);
      }
    }
  }
};

/// Samples of all ranks: with 512 for each of many, the cuts are near enough to where they would
/// be; few ranks, of which one that has more than its share is waited for, can have more.
double CountSamples(std::size_t ranks)
{
  return std::max(512.0 * static_cast<double>(ranks), 16384.0);
}

}

vtkAHDRankPoints::vtkAHDRankPoints(const vtkAHDSettings& settings, vtkAHDRanks& ranks,
  const vtkAHDAllFacts& facts, const vtkAHDContext& context)
  : Settings(settings)
  , Ranks(ranks)
  , Facts(facts)
  , Context(context)
  , Route(ranks, context)
{
  std::uint64_t before = 0, sourcesBefore = 0;
  for (std::size_t rank = 0; rank < ranks.GetOwn(); ++rank)
  {
    before += facts.Of[rank].Points;
    sourcesBefore += facts.CountsSource(rank) ? facts.Of[rank].SourcePoints : 0;
  }
  this->OwnIds.first = static_cast<std::int64_t>(before);
  this->OwnIds.firstAdded = static_cast<std::int64_t>(facts.GetPoints() + sourcesBefore);
}

vtkAHDRankPoints::~vtkAHDRankPoints() = default;

void vtkAHDRankPoints::Read(vtkPointSet* input, vtkPolyData* source)
{
  this->Ranks.Together(this->Context,
    [&]
    {
      this->Local = this->Facts.SelectArrays(input);
      vtkPolyData* counted = this->Facts.CountsSource(this->Ranks.GetOwn()) ? source : nullptr;
      vtkPointSet* given = input ? input : this->Local.Get();
      this->Input.reset(new vtkAHDInput(this->Settings, given, counted));
      this->Input->Open(this->Context);
    });
  if (this->Settings.fitsPlane())
  {
    this->FitPlane();
  }
  if (this->Settings.addsBounding())
  {
    this->FindBounds();
  }
  this->Ranks.Together(this->Context, [this] { this->Prepare(); });
}

/// Of the points of all ranks.
void vtkAHDRankPoints::FindBounds()
{
  const auto findOwn = [&]
  {
    Box box;
    for (const ahd::PointView* points :
      { &this->Input->GetRequest().points, &this->Input->GetRequest().sourcePoints })
    {
      for (std::size_t i = 0; i < points->count; ++i)
      {
        if (i % kAsk == 0)
        {
          this->Context.StopIfAborted();
        }
        if (ahd::isFinite((*points)[i]) && !points->skipped(i))
        {
          const ahd::Vector3 p = points->place(i);
          box.Add(p, p);
        }
      }
    }
    return box;
  };
  Box whole;
  for (const Box& box : this->Ranks.Share(this->Context, findOwn))
  {
    whole.Add(box.Low, box.High);
  }
  this->Bounds = { { whole.Low, whole.High } };
}

/// To the inputs of all ranks.
void vtkAHDRankPoints::FitPlane()
{
  const ahd::Context context = this->Context;
  ahd::PlaneFitting fitting(this->Input->GetRequest().points, !this->Facts.AreFloats());
  while (!fitting.isDone())
  {
    fitting.hear(this->Ranks.Share(this->Context,
      [&]
      {
        ahd::Ticker ticker(context.progress, ahd::Phase::Merge, 0, context.executor);
        ahd::BlockBytes own;
        if (!fitting.look(ticker))
        {
          throw vtkAHDStop{ ahd::Status::Cancelled };
        }
        fitting.tell(own);
        return own;
      }));
  }
  this->Plane.take(fitting.fit());
}

void vtkAHDRankPoints::Prepare()
{
  ahd::InputRequest request = this->Input->GetRequest();
  request.plane = &this->Plane;
  request.bounds = &this->Bounds;
  request.isSourceElsewhere = this->Facts.GetSourcePoints() > 0;
  request.closedLinesAreLoops = false; // those of all ranks are joined first: JoinChains()
  request.bounding = request.bounding && this->Ranks.GetOwn() + 1 == this->Ranks.GetCount();
  this->Context.Check(ahd::prepare(request, this->Context, this->Prepared));
  this->OwnIds.given = this->Prepared.inputCount();
  if (this->Prepared.addedCount() > 0)
  {
    this->Combined = vtkSmartPointer<vtkPolyData>::New();
    const vtkAHDPointOutput output(*this->Input, this->Prepared, this->Local);
    output.WritePlaces(nullptr, this->Combined, this->Context);
    output.WriteData(this->Combined->GetPointData(), this->Context);
  }
}

std::size_t vtkAHDRankPoints::EstimateBytes() const
{
  const std::size_t count = this->Prepared.points().count;
  return this->Input->EstimateBytes() + ahd::preparationMemoryEstimate(this->Input->GetRequest()) +
    (this->Combined ? vtkAHDPointOutput::EstimateBytes(this->Local, count) : 0) +
    vtkAHDRoute::memoryEstimate(count);
}

vtkPointData* vtkAHDRankPoints::GetDataToMove() const
{
  return (this->Combined ? this->Combined : this->Local)->GetPointData();
}

/// Some of this rank's points, as many as it has of all.
std::vector<ahd::Point> vtkAHDRankPoints::FindSamples() const
{
  const double all = static_cast<double>(this->Facts.GetPoints() + this->Facts.GetSourcePoints());
  const double mine = static_cast<double>(this->Prepared.points().count);
  const double most = CountSamples(this->Ranks.GetCount());
  std::vector<ahd::Point> samples;
  this->Context.Check(ahd::samplePoints(this->Prepared.points(),
    static_cast<std::size_t>(all > 0.0 ? most * mine / all + 1.0 : 0.0), samples));
  return samples;
}

void vtkAHDRankPoints::FindOwners()
{
  ahd::BlockCuts cuts;
  const auto all = this->Ranks.Share(this->Context, [&] { return this->FindSamples(); });
  this->Ranks.Together(this->Context,
    [&]
    {
      std::vector<ahd::Point> samples;
      for (const std::vector<ahd::Point>& some : all)
      {
        samples.insert(samples.end(), some.begin(), some.end());
      }
      this->Context.Check(ahd::cutIntoBlocks(samples, this->Ranks.GetCount(), this->Context, cuts));
    });
  this->Context.Check(this->Route.toOwners(this->Prepared.points(), cuts));
}

/// Ids come ascending from each rank, those of its source behind those of its input; sources' ids
/// are larger than all others. So either kind is in order.
void vtkAHDRankPoints::SortIds(const std::vector<std::int64_t>& arrived)
{
  const auto firstOfSources = static_cast<std::int64_t>(this->Facts.GetPoints());
  std::vector<ahd::Index> places(arrived.size());
  this->Ids.resize(arrived.size());
  std::size_t next = 0;
  for (const bool isOfSource : { false, true })
  {
    for (std::size_t k = 0; k < arrived.size(); ++k)
    {
      if (k % kAsk == 0)
      {
        this->Context.StopIfAborted();
      }
      if ((arrived[k] >= firstOfSources) == isOfSource)
      {
        places[k] = static_cast<ahd::Index>(next);
        this->Ids[next++] = arrived[k];
      }
    }
  }
  this->Route.setPlaces(std::move(places));
}

/// Where points are added, places are doubles.
bool vtkAHDRankPoints::AreFloats() const
{
  return this->Facts.AreFloats() && !this->AreBounded();
}

void vtkAHDRankPoints::MovePlaces()
{
  vtkSmartPointer<vtkDataArray> mine;
  const bool areFloats = this->AreFloats();
  this->Ranks.Together(this->Context,
    [&]
    {
      this->Places = vtkAHDMakePlaces(this->GetCount(), areFloats);
      vtkPolyData* from = this->Combined ? this->Combined : this->Local;
      mine = vtkAHDPlacesOf(from->GetPoints(), areFloats);
      if (this->Prepared.isProjected())
      {
        this->InPlane.resize(3 * this->GetCount());
      }
    });
  this->Route.Move(mine, this->Places, 0);
  if (this->Settings.isProjected())
  {
    this->Context.Check(
      this->Route.move(this->Prepared.points().doubles, 3 * sizeof(double), this->InPlane.data()));
  }
}

void vtkAHDRankPoints::MoveMarks()
{
  std::vector<unsigned char> mine;
  this->Ranks.Together(this->Context,
    [&]
    {
      mine.assign(this->Prepared.points().count, 0);
      if (const unsigned char* given = this->Input->GetRequest().points.skip)
      {
        std::copy(given, given + this->Prepared.inputCount(), mine.begin());
      }
      this->Marks = vtkAHDNewArray<vtkUnsignedCharArray>(static_cast<vtkIdType>(this->GetCount()));
    });
  this->Context.Check(this->Route.move(mine.data(), 1, this->Marks->GetPointer(0)));
}

void vtkAHDRankPoints::JoinChains(ahd::BlockChains& chains)
{
  this->Context.Check(chains.join(this->Input->GetRequest(), this->Prepared, this->OwnIds,
    this->Facts.GetContent().Vertices, this->Ranks, this->Context.WithoutPhases()));
}

ahd::SourceBounds vtkAHDRankPoints::JoinSourceBounds() const
{
  ahd::SourceBounds joined;
  for (const ahd::SourceBounds& own :
    this->Ranks.Share(this->Context, [this] { return this->Prepared.sourceBounds(); }))
  {
    joined.merge(own);
  }
  return joined;
}

ahd::BlockInput vtkAHDRankPoints::GetBlock(const ahd::BlockChains& chains) const
{
  ahd::BlockInput input;
  input.block = this->Ranks.GetOwn();
  input.blocks = this->Ranks.GetCount();
  input.points = this->GetView();
  input.ids = this->Ids.data();
  input.constraints = chains.view();
  input.rule = this->Settings.fillRule;
  input.options = this->Settings.options;
  return input;
}

void vtkAHDRankPoints::MoveToOwners()
{
  this->FindOwners();
  std::vector<std::int64_t> arrived;
  this->Ranks.Together(this->Context, [&] { arrived.resize(this->Route.count()); });
  this->Context.Check(this->Route.moveValues([this](ahd::Index i)
    { return this->OwnIds.of(static_cast<std::int64_t>(i)); },
    arrived.data()));
  this->Ranks.Together(this->Context,
    [&]
    {
      if (this->Facts.GetSourcePoints() > 0)
      {
        this->SortIds(arrived);
      }
      else
      {
        this->Ids = std::move(arrived);
      }
    });
  this->MovePlaces();
  if (this->Facts.HaveMarks())
  {
    this->MoveMarks();
  }
}

vtkSmartPointer<vtkDataArray> vtkAHDRankPoints::TakePlaces(std::size_t count)
{
  const auto numbers = static_cast<vtkIdType>(3 * count);
  if (auto* floats = vtkArrayDownCast<vtkFloatArray>(this->Places))
  {
    vtkAHDResizeArray(floats, numbers);
  }
  else
  {
    vtkAHDResizeArray(vtkArrayDownCast<vtkDoubleArray>(this->Places), numbers);
  }
  return std::move(this->Places);
}

ahd::PointView vtkAHDRankPoints::GetView() const
{
  ahd::PointView view = this->InPlane.empty()
    ? vtkAHDViewOf(this->Places, this->GetCount())
    : ahd::PointView(this->InPlane.data(), this->GetCount(), 3);
  if (this->Marks)
  {
    view.skip = this->Marks->GetPointer(0);
    view.skipMask = vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  }
  return view;
}
