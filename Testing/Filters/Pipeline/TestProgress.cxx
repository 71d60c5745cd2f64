// SPDX-License-Identifier: BSD-3-Clause
//
// Progress is reported and never goes back; an abort at any time leaves no output and breaks
// nothing.
#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDLentTriangulation.h"
#include "FilterTestSupport.h"
#include "Pipeline/vtkAHDProgress.h"
#include "ProgressWatch.h"

#include "vtkCallbackCommand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <map>

using namespace ahdtest;

namespace
{
constexpr std::size_t kCount = 100000;

/// Seconds of a clock that the tests turn on.
double now = 0.0;
double clockOfTests()
{
  return now;
}

/// Counts the polls after an abort.
class AskedFilter : public vtkAdaptiveHilbertDelaunay2D
{
public:
  static AskedFilter* New() { VTK_STANDARD_NEW_BODY(AskedFilter); }
  vtkTypeMacro(AskedFilter, vtkAdaptiveHilbertDelaunay2D);

  int GetAbortExecute() override
  {
    const int abort = this->Superclass::GetAbortExecute();
    this->AskedAfterwards += abort != 0 ? 1 : 0;
    return abort;
  }

  int AskedAfterwards = 0;
};

/// Aborts at this poll, from 1.
class Aborting : public vtkAlgorithm
{
public:
  static Aborting* New() { VTK_STANDARD_NEW_BODY(Aborting); }
  vtkTypeMacro(Aborting, vtkAlgorithm);

  int GetAbortExecute() override { return ++this->Asked >= this->AbortAt ? 1 : 0; }

  int Asked = 0;
  int AbortAt = VTK_INT_MAX;
};

/// An execution without a pipeline, which would empty the outputs itself. Returns the polls.
int pollsOfExecution(vtkPolyData* cloud, int abortAt)
{
  vtkNew<Aborting> filter;
  filter->AbortAt = abortAt;
  vtkAHDProgress progress(filter);
  ahd::Threads threads(1);
  vtkAHDOutputMemory memory;
  const vtkAHDContext context(progress, threads, memory);
  vtkAHDSettings settings;
  settings.ReuseLimit = VTK_INT_MAX;
  settings.voronoi = true;
  vtkAHDInput input(settings, cloud, nullptr);
  ahd::Workspace workspace;
  vtkNew<vtkPolyData> surface, order, diagram;
  vtkAHDExecution::LentPointer lent;
  const auto report =
    vtkAHDExecution(settings, input, workspace, context, 0).Run({ surface, order, diagram }, &lent);
  const bool isWhole = filter->Asked < abortAt;
  EXPECT_EQ(report.status, isWhole ? ahd::Status::Ok : ahd::Status::Cancelled);
  EXPECT_EQ(surface->GetNumberOfPoints() > 0, isWhole);
  EXPECT_EQ(diagram->GetNumberOfPoints() > 0, isWhole);
  EXPECT_EQ(lent != nullptr, isWhole);
  EXPECT_EQ(workspace.bytes(), 0u);
  return filter->Asked;
}

/// Counts the polls at each place of the bar.
class WorkingFilter : public vtkAdaptiveHilbertDelaunay2D
{
public:
  static WorkingFilter* New() { VTK_STANDARD_NEW_BODY(WorkingFilter); }
  vtkTypeMacro(WorkingFilter, vtkAdaptiveHilbertDelaunay2D);

  int GetAbortExecute() override
  {
    ++this->All;
    ++this->At[this->GetProgress()];
    return this->Superclass::GetAbortExecute();
  }

  /// The part of all polls at which the bar stood still.
  double GetStandstill() const
  {
    int most = 0;
    for (const auto& place : this->At)
    {
      most = std::max(most, place.second);
    }
    return double(most) / this->All;
  }

  std::map<double, int> At;
  int All = 0;
};
}

TEST(Progress, TheBarMovesWhileTheDiagramIsMade)
{
  vtkNew<WorkingFilter> filter;
  filter->SetInputData(makeCloud(latticePoints(kCount, 1000000)));
  filter->SetNumberOfThreads(1);
  filter->GenerateVoronoiOn();
  filter->Update();
  EXPECT_LT(filter->GetStandstill(), 0.25);
}

/// A lattice of so many columns and rows, a line in each row, and two that cross in every seventh
/// of its squares.
vtkSmartPointer<vtkPolyData> crossedLattice(int size, double spacing)
{
  std::vector<Xyz> points;
  vtkNew<vtkCellArray> lines;
  for (int i = 0; i < size * size; ++i)
  {
    points.push_back({ spacing * (i % size), spacing * (i / size), 0.0 });
    if (i % size + 1 < size)
    {
      lines->InsertNextCell({ vtkIdType(i), vtkIdType(i + 1) });
    }
    if (i % 7 == 0 && i % size + 1 < size && i / size + 1 < size)
    {
      lines->InsertNextCell({ vtkIdType(i), vtkIdType(i + size + 1) });
      lines->InsertNextCell({ vtkIdType(i + 1), vtkIdType(i + size) });
    }
  }
  auto source = vtkSmartPointer<vtkPolyData>::New();
  source->ShallowCopy(makeCloud(points));
  source->SetLines(lines);
  return source;
}

TEST(Progress, TheBarMovesWhileLinesAreSplit)
{
  vtkNew<WorkingFilter> filter;
  auto lattice = crossedLattice(300, 1.0);
  filter->SetInputData(lattice);
  filter->SetSourceData(lattice);
  filter->SetCrossingModeToSplit();
  filter->SetNumberOfThreads(1);
  filter->Update();
  EXPECT_GT(filter->GetNumberOfCrossings(), 100);
  EXPECT_LT(filter->GetStandstill(), 0.25);
}

TEST(Progress, TheBarMovesWhileTheSurfaceForHeightsIsMade)
{
  vtkNew<WorkingFilter> filter;
  filter->SetInputData(makeCloud(latticePoints(kCount, 1000000)));
  filter->SetSourceData(crossedLattice(20, 40000.5));
  filter->SetSourceModeToCoordinates();
  filter->SetSourceHeights(vtkAdaptiveHilbertDelaunay2D::FROM_SURFACE);
  filter->SetNumberOfThreads(1);
  filter->Update();
  EXPECT_LT(filter->GetStandstill(), 0.25);
}

/// Places one by one on the surface: walks through triangles, which poll on their way.
TEST(Progress, AbortsAreHeardWhileHeightsAreLookedUp)
{
  const auto points = latticePoints(100000, 1000000);
  const auto askings = [&points](int heights)
  {
    vtkNew<WorkingFilter> filter;
    filter->SetInputData(makeCloud(latticePoints(kCount, 1000000)));
    vtkNew<vtkPolyData> source;
    source->ShallowCopy(makeCloud(points));
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({ vtkIdType(0), vtkIdType(1) });
    source->SetLines(lines);
    filter->SetSourceData(source);
    filter->SetSourceModeToCoordinates();
    filter->SetSourceHeights(heights);
    filter->SetNumberOfThreads(1);
    filter->Update();
    return filter->All;
  };
  const int without = askings(vtkAdaptiveHilbertDelaunay2D::OWN);
  EXPECT_GT(askings(vtkAdaptiveHilbertDelaunay2D::FROM_SURFACE), 2 * without + 50);
}

TEST(Progress, RisesFromZeroToOne)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(makeCloud(latticePoints(kCount, 1000000)));
  vtkNew<ProgressWatch> watch;
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  ASSERT_GT(watch->Seen.size(), 10u);
  EXPECT_LE(watch->Seen.size(), 110u) << "observers may be slow";
  EXPECT_EQ(watch->Seen.front(), 0.0);
  EXPECT_EQ(watch->Seen.back(), 1.0);
  for (std::size_t i = 1; i < watch->Seen.size(); ++i)
  {
    EXPECT_GE(watch->Seen[i], watch->Seen[i - 1]) << "at report " << i;
  }
}

TEST(Progress, AbortAnywhereLeavesAnEmptyOutputAndAReusableFilter)
{
  auto cloud = makeCloud(latticePoints(kCount, 1000000));
  vtkNew<vtkAdaptiveHilbertDelaunay2D> reference;
  reference->SetInputData(cloud);
  reference->Update();
  const std::vector<Triangle> expected = trianglesOf(reference->GetOutput());

  for (double at : { 0.01, 0.1, 0.3, 0.6, 0.85, 0.95, 1.0 })
  {
    WatchedFilter filter;
    filter->SetInputData(cloud);
    vtkNew<ProgressWatch> watch;
    watch->AbortAt = at;
    filter->AddObserver(vtkCommand::ProgressEvent, watch);
    filter->Update();
    ASSERT_TRUE(watch->Aborted) << "no progress of " << at << " was ever reported";
    // The pipeline may report once, with 1, that the filter is done.
    EXPECT_LE(watch->SeenAfterAbort, 1) << "work went on after the abort at " << at;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << "aborted at " << at;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0) << "aborted at " << at;
    EXPECT_EQ(filter->GetNumberOfTriangles(), 0) << "aborted at " << at;
    EXPECT_TRUE(filter.Said->Errors.empty()) << filter.Said->Errors[0];
    EXPECT_TRUE(filter.Said->Warnings.empty()) << filter.Said->Warnings[0];

    watch->AbortAt = 2.0;
    filter->SetAbortExecute(0); // VTK 9.1 does this by itself, later VTK leaves it to the user
    filter->Modified();
    filter->Update();
    EXPECT_TRUE(trianglesOf(filter->GetOutput()) == expected) << "after an abort at " << at;
  }
}

TEST(Progress, ObserversHearTenTimesASecondWithoutProgress)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  vtkNew<ProgressWatch> watch;
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  vtkAHDProgress progress(filter, clockOfTests);
  progress.beginPhase(ahd::Phase::Split);
  for (int i = 0; i < 1000; ++i)
  {
    now += 0.005;
    EXPECT_TRUE(i % 2 == 0 ? progress.advance(ahd::Phase::Split, 0.0) : progress.goesOn());
  }
  EXPECT_GE(watch->Seen.size(), 50u) << "in five seconds";
  EXPECT_LE(watch->Seen.size(), 100u) << "observers may be slow";
  EXPECT_EQ(watch->Seen.back(), watch->Seen.front()) << "there was no progress";
}

TEST(Progress, ObserversHearOfEachHundredthOnce)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  vtkNew<ProgressWatch> watch;
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  vtkAHDProgress progress(filter, clockOfTests);
  progress.beginPhase(ahd::Phase::Insert);
  for (int i = 1; i <= 100000; ++i)
  {
    EXPECT_TRUE(progress.advance(ahd::Phase::Insert, i / 100000.0));
  }
  EXPECT_GE(watch->Seen.size(), 98u);
  EXPECT_LE(watch->Seen.size(), 101u) << "observers may be slow";
  const std::size_t before = watch->Seen.size();
  EXPECT_TRUE(progress.advance(ahd::Phase::Insert, 0.5));
  EXPECT_EQ(watch->Seen.size(), before) << "the bar went back";
}

TEST(Progress, TheRoundingThatAnObserverSetsEndsWithIt)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  bool told = false;
  const auto roundUp = [](vtkObject*, unsigned long, void* data, void*)
  {
    *static_cast<bool*>(data) = true;
    std::fesetround(FE_UPWARD);
  };
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(roundUp);
  observer->SetClientData(&told);
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  vtkAHDProgress progress(filter, clockOfTests);
  progress.beginPhase(ahd::Phase::Insert);
  EXPECT_TRUE(progress.advance(ahd::Phase::Insert, 0.5));
  EXPECT_TRUE(told);
  volatile double tiny = 1e-30;
  const double sum = 1.0 + tiny;
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(sum, 1.0);
}

TEST(Progress, TheTimeOfAPhaseIsFromItsBeginningToTheNext)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  vtkAHDProgress progress(filter, clockOfTests);
  now += 1.0; // before the first
  progress.beginPhase(ahd::Phase::Read);
  now += 2.0;
  progress.beginPhase(ahd::Phase::Outputs);
  now += 4.0;
  progress.finishPhase();
  now += 8.0; // of no phase
  progress.beginPhase(ahd::Phase::Outputs);
  now += 16.0;
  progress.finishPhase();
  progress.finishPhase();
  EXPECT_DOUBLE_EQ(progress.seconds(ahd::Phase::Read), 2.0);
  EXPECT_DOUBLE_EQ(progress.seconds(ahd::Phase::Outputs), 20.0);
  EXPECT_EQ(progress.seconds(ahd::Phase::Insert), 0.0);
}

TEST(Progress, ItIsKnownWhenEachStageBegan)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  vtkAHDProgress progress(filter, clockOfTests);
  for (const std::size_t stages : { 3, 2 })
  {
    progress.setStages(std::vector<double>(stages, 1.0));
    EXPECT_TRUE(progress.stagesBegun().empty());
    std::vector<double> expected;
    for (std::size_t stage = 0; stage < stages + 2; ++stage) // all is done before the last ones
    {
      now += 1.0;
      progress.nextStage();
      expected.push_back(now);
    }
    expected.resize(stages);
    EXPECT_EQ(progress.stagesBegun(), expected);
  }
}

TEST(Progress, MovesInEveryStageAndPhase)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  vtkNew<ProgressWatch> watch;
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  vtkAHDProgress progress(filter, clockOfTests);
  progress.setStages({ 1.0, 0.0, 3.0 });
  double before = -1.0;
  for (int stage = 0; stage < 3; ++stage)
  {
    progress.nextStage();
    for (int phase = 0; phase < 2 && stage != 1; ++phase)
    {
      progress.beginPhase(ahd::Phase::Outputs);
      EXPECT_TRUE(progress.advance(ahd::Phase::Outputs, 1.0));
      EXPECT_GT(watch->Seen.back(), before + 0.05) << "stage " << stage << ", phase " << phase;
      before = watch->Seen.back();
    }
  }
  progress.nextStage();
  EXPECT_EQ(watch->Seen.back(), 1.0);
}

TEST(Progress, AnAbortEndsThePhaseItIsAskedForIn)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  vtkAHDProgress progress(filter, clockOfTests);
  EXPECT_TRUE(progress.advance(ahd::Phase::Insert, 0.5));
  filter->SetAbortExecute(1);
  EXPECT_FALSE(progress.advance(ahd::Phase::Insert, 0.6));
  EXPECT_FALSE(progress.goesOn());
}

/// Nothing is put out, kept or lent, up to the last poll, which is of the triangulation to lend.
TEST(Progress, AnAbortAtAnyPollLeavesNothing)
{
  auto cloud = makeCloud(latticePoints(3000, 1000000));
  const int all = pollsOfExecution(cloud, VTK_INT_MAX);
  ASSERT_GT(all, 20);
  for (int at = 1; at <= all; ++at)
  {
    SCOPED_TRACE(std::to_string(at) + " of " + std::to_string(all));
    pollsOfExecution(cloud, at);
  }
}

/// If the engine continued after an abort, it would continue to poll.
TEST(Progress, AfterAnAbortNobodyAsksAgain)
{
  for (double at : { 0.02, 0.3, 0.5, 0.7, 0.9 })
  {
    vtkNew<AskedFilter> filter;
    filter->SetInputData(makeCloud(latticePoints(kCount, 1000000)));
    filter->SetNumberOfThreads(1);
    filter->SetGenerateVoronoi(true);
    filter->SetGenerateNeighbors(true);
    vtkNew<ProgressWatch> watch;
    watch->AbortAt = at;
    filter->AddObserver(vtkCommand::ProgressEvent, watch);
    filter->Update();
    ASSERT_TRUE(watch->Aborted) << at;
    EXPECT_GE(filter->AskedAfterwards, 1) << at;
    EXPECT_LE(filter->AskedAfterwards, 4) << "work went on after the abort at " << at;
  }
}
