// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankExecution.h"

#include "Engine/Prepare/Stacks.h"
#include "Output/vtkAHDSurface.h"
#include "Ranks/vtkAHDGatheredExecution.h"
#include "Ranks/vtkAHDRankMemory.h"
#include "Ranks/vtkAHDRankSurface.h"

#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <tuple>
#include <utility>

vtkAHDRankExecution::vtkAHDRankExecution(const vtkAHDSettings& settings, vtkAHDRanks& ranks,
  const vtkAHDContext& context, vtkAHDRankResult& result)
  : Settings(settings)
  , Ranks(ranks)
  , Context(context)
  , Made(result)
  , Report(result.Report)
{
  this->Report.status = ahd::Status::Ok;
}

void vtkAHDRankExecution::Run(
  const vtkAHDDataSets& data, ahd::Status before, ahd::Workspace& workspace)
{
  vtkAHDCheckBefore(before, this->Ranks, this->Context, this->Made.Error);
  this->Context.SetStages({ 0.3, 1.0, 0.05, 0.3 }); // points move, own ones, what is shared, output
  this->Context.NextStage();
  this->Meet(data);
  this->Facts.Compare(this->Settings, this->Made.Error);
  const char* setting = this->Facts.FindUnfit(this->Settings);
  setting ? this->TriangulateOnOne(data, setting, workspace) : this->Triangulate(data);
  this->WarnOfArrays();
  vtkAHDSurface::WriteCrossings(this->Report.CrossingCells, data.Outputs[0]);
}

/// @pre to be called by all ranks alike.
void vtkAHDRankExecution::StopAll(ahd::Status reason, const std::string& error)
{
  this->Made.Error = error;
  throw vtkAHDStop{ reason };
}

void vtkAHDRankExecution::Meet(const vtkAHDDataSets& data)
{
  vtkAHDMeet(this->Settings, data, this->Ranks, this->Context, this->Facts);
  this->Report.inputPoints = this->Facts.GetPoints();
  this->Report.addedPoints = this->Facts.GetSourcePoints();
  this->Report.points = this->Report.inputPoints + this->Report.addedPoints;
}

void vtkAHDRankExecution::TriangulateOnOne(
  const vtkAHDDataSets& data, const char* setting, ahd::Workspace& workspace)
{
  if (this->Report.points > ahd::kMaximumPoints)
  {
    throw vtkAHDStop{ ahd::Status::TooManyPoints };
  }
  vtkAHDGatheredExecution execution(
    this->Settings, this->Ranks, this->Facts, this->Context, setting);
  const std::string refusal = execution.FindHost(data, workspace, this->Report);
  if (!refusal.empty())
  {
    this->StopAll(ahd::Status::OutOfMemory, refusal);
  }
  execution.Run(data, workspace, this->Report);
  this->Made.OneRank = execution.GetWarning();
}

void vtkAHDRankExecution::Triangulate(const vtkAHDDataSets& data)
{
  vtkAHDRankPoints points(this->Settings, this->Ranks, this->Facts, this->Context);
  points.Read(data.Input, data.Source);
  constexpr std::size_t kBounding = 8;
  this->Report.addedPoints += points.AreBounded() ? kBounding : 0;
  this->Report.points += points.AreBounded() ? kBounding : 0;
  ahd::BlockChains chains;
  points.JoinChains(chains);
  points.MoveToOwners();
  this->CheckPoints(points, chains);
  ahd::BlockTriangulation block;
  this->Context.NextStage();
  this->MakeBlock(points, chains, block);
  this->BlockEstimate = this->Estimate;
  this->Context.NextStage();
  vtkAHDRankSurface surface(this->Settings, this->Ranks, this->Facts, this->Context, points, block);
  this->CheckGhosts(block.ghostTriangles());
  surface.Select();
  const std::size_t firstCell = this->ShareOdds(points, block.report(), surface.GetCellCount());
  this->TakeGhosts(surface, firstCell);
  this->LookForInput(chains, surface);
  surface.Write(data.Outputs[0], firstCell);
  this->ReportOn(block.report(), chains);
  this->Report.sourceBounds = points.JoinSourceBounds();
  this->ReportOn(surface.GetRim());
}

/// Refuses on all ranks what takes more than there is on one of them.
void vtkAHDRankExecution::CheckMemory(std::size_t bytes, const char* what)
{
  this->Estimate = std::max(this->Estimate, bytes);
  const std::string error = vtkAHDRefuseMemory(this->Settings, this->Facts, this->Ranks,
    this->Context, bytes, { "Triangulating", this->Report.points, what });
  this->Report.estimate = bytes;
  if (!error.empty())
  {
    this->StopAll(ahd::Status::OutOfMemory, error);
  }
}

void vtkAHDRankExecution::CheckPoints(
  const vtkAHDRankPoints& points, const ahd::BlockChains& chains)
{
  const std::size_t count = points.GetCount();
  const std::size_t block = ahd::blockMemoryEstimate(
    count, chains.idCount(), this->Settings.options);
  if (block == std::size_t(-1))
  {
    throw vtkAHDStop{ ahd::Status::TooManyPoints };
  }
  constexpr std::size_t kPerId = 4 * sizeof(std::int64_t); // with offsets and cells
  // an id, a mark and a place in the plane; that in space becomes the output's
  const std::size_t perPoint = sizeof(std::int64_t) + 1 +
    (this->Settings.isProjected() ? 3 * sizeof(double) : 0);
  this->CheckMemory(points.EstimateBytes() + count * perPoint + block + kPerId * chains.idCount() +
      vtkAHDRankSurface::EstimateBytes(count, this->Settings, this->Facts),
    "");
}

/// Once it is known how much ranks have to hand to one. Where that is most of all, they do so at
/// once rather than in several steps.
void vtkAHDRankExecution::CheckBorder(
  ahd::BlockTriangulation& blocks, const ahd::BlockChains& chains)
{
  constexpr std::size_t kHost = 0;
  std::size_t points = 0;
  for (const ahd::BorderCount& border : blocks.borders())
  {
    points += border.points;
  }
  const bool gathers = points > this->Report.points / 4;
  std::vector<std::size_t> joined(this->Ranks.GetCount(), 0), held(joined), edges(joined);
  for (const ahd::BorderCount& border : blocks.borders())
  {
    const std::size_t host = gathers ? kHost : border.to;
    joined[host] += border.points;
    for (const std::size_t rank : { border.host, host }) // it comes back as triangles
    {
      held[rank] += border.points;
      edges[rank] += border.edges;
    }
  }
  if (*std::max_element(joined.begin(), joined.end()) > ahd::kMaximumPoints)
  {
    throw vtkAHDStop{ ahd::Status::TooManyPoints };
  }
  if (gathers)
  {
    blocks.gatherTo(kHost);
  }
  const std::size_t own = this->Ranks.GetOwn();
  const std::size_t more = held[own] == 0
    ? 0
    : ahd::borderMemoryEstimate(
        std::min(held[own], ahd::kMaximumPoints), edges[own], chains.idCount());
  std::ostringstream what;
  what << ", which is to join " << (gathers ? "" : "some of ") << "the " << points
       << " points that ranks do not triangulate alone";
  this->CheckMemory(this->Estimate + more, what.str().c_str());
}

/// Refuses layers of ghosts that take more than there is.
void vtkAHDRankExecution::CheckGhosts(std::size_t cells)
{
  if (this->Facts.GetGhostLevels() > 0 || this->Settings.mayTrimRim())
  {
    this->CheckMemory(this->BlockEstimate +
        vtkAHDRankSurface::EstimateGhostBytes(cells, this->Settings, this->Facts),
      ", ghost cells included");
  }
}

/// Layer after layer.
void vtkAHDRankExecution::TakeGhosts(vtkAHDRankSurface& surface, std::size_t firstCell)
{
  if (this->Facts.GetGhostLevels() > 0)
  {
    this->Context.Check(surface.GetGhosts().begin(firstCell));
  }
  for (int level = 0; level < this->Facts.GetGhostLevels(); ++level)
  {
    this->Context.Check(surface.GetGhosts().ask());
    this->CheckGhosts(surface.GetGhosts().countAll());
    this->Context.Check(surface.GetGhosts().take());
  }
}

void vtkAHDRankExecution::MakeBlock(
  const vtkAHDRankPoints& points, const ahd::BlockChains& chains, ahd::BlockTriangulation& block)
{
  this->Context.Check(this->Ranks.agree(block.begin(points.GetBlock(chains), this->Context)));
  this->Context.NextStage();
  while (block.waiting() != ahd::BlockTriangulation::Waiting::ForNothing)
  {
    if (!block.borders().empty())
    {
      this->CheckBorder(block, chains);
    }
    this->Context.Check(ahd::takeStep(block, this->Ranks, this->Context));
  }
}

/// Looks whether x and y tell the points apart, where the triangles give cause for it. Points at
/// one place are on one rank; that those of several ranks are on one line is not found out.
void vtkAHDRankExecution::FindStacks(const vtkAHDRankPoints& points,
  const ahd::BlocksReport& counts, bool& areStacked, bool& areOnLine)
{
  if (this->Settings.isProjected())
  {
    return;
  }
  const ahd::Report& sums = counts.counts;
  if (sums.triangles == 0)
  {
    this->Context.Check(ahd::findIfOnOneLine(points.GetView(), this->Context, areOnLine));
  }
  else if (sums.duplicates > sums.inserted / 2 && !this->Settings.showsMeans &&
    this->Settings.options.representative == ahd::Representative::FirstId)
  {
    this->Context.Check(ahd::findIfStacked(points.GetView(), this->Context, areStacked));
  }
}

/// Tells all what each rank found odd in its points, and how many triangles it has. Returns how
/// many those before this one have.
std::size_t vtkAHDRankExecution::ShareOdds(
  const vtkAHDRankPoints& points, const ahd::BlocksReport& counts, std::size_t triangles)
{
  constexpr std::int64_t kNone = -1;
  struct Odds
  {
    ahd::OddPoints Points;
    std::int64_t First = kNone; // of Points, by its number among those of all
    std::size_t Triangles = 0;
    bool AreStacked = false, AreOnLine = true;

    auto fields()
    {
      return std::tie(
        this->Points, this->First, this->Triangles, this->AreStacked, this->AreOnLine);
    }
  };
  const ahd::PointView& mine = points.GetPrepared().points();
  const auto all = this->Ranks.Share(this->Context,
    [&]
    {
      Odds own;
      this->FindStacks(points, counts, own.AreStacked, own.AreOnLine);
      this->Context.Check(ahd::findOddPoints(mine, this->Context, own.Points));
      const std::size_t first = own.Points.firstNotFinite; // 0 also stands for none
      const bool isOdd = first > 0 ||
        (mine.count > 0 && !ahd::isFinite(mine[0]) && !mine.skipped(0));
      own.First = isOdd ? points.GetOwnIds().of(static_cast<std::int64_t>(first)) : kNone;
      own.Triangles = triangles;
      return own;
    });
  std::int64_t firstOdd = kNone;
  std::size_t before = 0, cells = 0;
  for (std::size_t rank = 0; rank < all.size(); ++rank)
  {
    const Odds& of = all[rank];
    firstOdd = firstOdd == kNone || (of.First != kNone && of.First < firstOdd) ? of.First
                                                                               : firstOdd;
    ahd::addCounts(of.Points, this->Report.oddPoints);
    before = rank == this->Ranks.GetOwn() ? cells : before;
    cells += of.Triangles;
    this->Report.areStacked = of.AreStacked || this->Report.areStacked;
    this->Report.areOnOneLine = of.AreOnLine && this->Report.areOnOneLine;
  }
  this->Report.isSteep = points.GetPrepared().plane().stance().isSteep;
  this->Report.triangles = cells;
  this->Report.oddPoints.firstNotFinite = static_cast<std::size_t>(
    std::max<std::int64_t>(firstOdd, 0));
  return before;
}

/// Do loops of sources with points of their own keep any of the inputs? Where source points may
/// stand for others, or triangles are too large, that is not known.
void vtkAHDRankExecution::LookForInput(
  const ahd::BlockChains& chains, const vtkAHDRankSurface& surface)
{
  if (this->Facts.GetSourcePoints() > 0 && chains.haveLoops() && !this->Settings.limitsSize() &&
    this->Settings.options.representative == ahd::Representative::FirstId)
  {
    this->Report.loopsMissInput = this->Report.triangles > 0 &&
      !this->Ranks.IsAny(surface.HasPointOfInput());
  }
}

void vtkAHDRankExecution::ReportOn(const ahd::BlockRim& rim)
{
  ahd::Report& counts = this->Report.counts;
  counts.triangles -= rim.triangles;
  counts.trimmed = rim.triangles;
  counts.bareVertices = rim.bareVertices;
  counts.trimmedArea = rim.area;
}

void vtkAHDRankExecution::ReportOn(const ahd::BlocksReport& counts, const ahd::BlockChains& chains)
{
  vtkAHDReport& report = this->Report;
  report.counts = counts.counts;
  report.constraints = counts.constraints;
  report.delaunayTriangles = counts.counts.triangles;
  report.MayBeEmptiedByLoops = counts.counts.triangles == 0 && chains.haveLoops();
  report.unfitIds = chains.unfitIds();
  report.areLinesUnclosed = chains.areLinesUnclosed();
  report.Source = this->Facts.GetContent();
  for (const vtkAHDRankFacts& facts : this->Facts.Of)
  {
    report.MarksAreUnfit = report.MarksAreUnfit || facts.MarksAreUnfit;
  }
  report.seconds = this->Context.GetProgress().seconds();
  report.threadsUsed = this->Context.GetThreadsUsed();
  report.estimate = this->Estimate;
  for (const ahd::LeftOut& out : counts.constraints.leftOut)
  {
    report.CrossingCells.push_back({ { chains.cellOf(out.chain), chains.cellOf(out.otherChain) } });
  }
  if (!report.CrossingCells.empty())
  {
    report.firstCrossing = report.CrossingCells.front();
  }
}

void vtkAHDRankExecution::WarnOfArrays()
{
  const std::string partial = this->Facts.GetPartialArrays();
  if (!partial.empty())
  {
    this->Made.Warnings.push_back("Point data arrays that not all ranks have, of one type and with "
                                  "one value for each point, are not passed on: " +
      partial + ".");
  }
}
