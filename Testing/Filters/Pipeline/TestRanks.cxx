// SPDX-License-Identifier: BSD-3-Clause
//
// On several ranks the filter warns, once, that each rank works on its own points.
#include "ContextSupport.h"
#include "FilterTestSupport.h"
#include "Pipeline/vtkAHDContext.h"
#include "Ranks/vtkAHDRoute.h"
#include "Sampling/vtkAHDSampleExecution.h"

#include "vtkAdaptiveHilbertInterpolation2D.h"
#include "vtkDummyCommunicator.h"
#include "vtkDummyController.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

using namespace ahdtest;

namespace
{
/// Claims to connect several processes; sends nothing, as the filter must not communicate.
class Pretended : public vtkDummyCommunicator
{
public:
  static Pretended* New() { return new Pretended; }
  void Be(int rank, int ranks)
  {
    this->MaximumNumberOfProcesses = ranks;
    this->SetNumberOfProcesses(ranks);
    this->LocalProcessId = rank;
  }
};

/// Records the requested piece.
class Asked : public vtkPolyDataAlgorithm
{
public:
  static Asked* New() { VTK_STANDARD_NEW_BODY(Asked); }
  vtkTypeMacro(Asked, vtkPolyDataAlgorithm);
  int Piece = -1;

protected:
  Asked() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    outputs->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    this->Piece = outputs->GetInformationObject(0)->Get(
      vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
    vtkPolyData::GetData(outputs)->ShallowCopy(makeCloud(latticePoints(100, 1000)));
    return 1;
  }
};

/// Seconds of a clock that advances whenever it is read.
double clockOfTests()
{
  static double now = 0.0;
  return now += 1.0;
}

std::vector<std::string> warningsOfTwoRuns(int rank, int ranks, bool distribute = false)
{
  vtkNew<Pretended> communicator;
  communicator->Be(rank, ranks);
  vtkNew<vtkDummyController> controller;
  controller->SetCommunicator(communicator);
  vtkMultiProcessController::SetGlobalController(controller);
  WatchedFilter filter;
  if (distribute)
  {
    filter->SetController(nullptr);
    filter->DistributePointsOn();
  }
  filter->SetInputData(makeCloud(latticePoints(100, 1000)));
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
  filter->Modified();
  filter->Update();
  vtkMultiProcessController::SetGlobalController(nullptr);
  return filter.Said->Warnings;
}
}

TEST(Ranks, OneRankIsNothingToSay)
{
  EXPECT_TRUE(warningsOfTwoRuns(0, 1).empty());
}

TEST(Ranks, SeveralRanksAreSaidOnceByTheFirst)
{
  const std::vector<std::string> first = warningsOfTwoRuns(0, 3);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_NE(first[0].find("3 ranks"), std::string::npos) << first[0];
  EXPECT_NE(first[0].find("DistributePoints triangulates"), std::string::npos) << first[0];
  EXPECT_TRUE(warningsOfTwoRuns(1, 3).empty());
}

TEST(Ranks, WithoutAControllerThereAreNoneToDistributeTo)
{
  const std::vector<std::string> said = warningsOfTwoRuns(0, 3, true);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("has no effect without a Controller"), std::string::npos) << said[0];
}

/// Where there are several, the piece of a rank is its own points.
TEST(Ranks, EachAsksForItsPiece)
{
  vtkNew<Pretended> communicator;
  communicator->Be(1, 3);
  vtkNew<vtkDummyController> controller;
  controller->SetCommunicator(communicator);
  vtkMultiProcessController::SetGlobalController(controller);
  for (const bool isSurface : { true, false })
  {
    vtkSmartPointer<vtkAlgorithm> filter = vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D>::New();
    if (!isSurface)
    {
      filter = vtkSmartPointer<vtkAdaptiveHilbertInterpolation2D>::New();
    }
    vtkNew<Asked> points;
    filter->SetInputConnection(points->GetOutputPort());
    filter->UpdatePiece(1, 3, 0);
    EXPECT_EQ(points->Piece, 1) << isSurface;
    EXPECT_GT(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
  }
  vtkMultiProcessController::SetGlobalController(nullptr);
}

/// Time in which ranks wait for each other belongs to no output.
TEST(Ranks, WhileTheyMoveWhatTheyHaveNoPhaseRuns)
{
  vtkNew<vtkDummyController> controller;
  vtkNew<vtkAlgorithm> nobody;
  vtkAHDProgress progress(nobody, clockOfTests);
  ahd::Threads threads(1);
  vtkAHDOutputMemory memory;
  const vtkAHDContext context(progress, threads, memory);
  vtkAHDRanks ranks(controller);
  vtkAHDRoute route(ranks, context);
  const std::vector<int> mine = { 3, 1, 2 };
  std::vector<int> moved(mine.size());
  const auto move = [&]
  {
    context.Check(route.toOne(mine.size(), 0));
    context.Check(route.move(mine.data(), sizeof(int), moved.data()));
  };
  EXPECT_EQ(ranks.Execute(move), ahd::Status::Ok);
  EXPECT_EQ(moved, mine);
  for (const double seconds : progress.seconds())
  {
    EXPECT_EQ(seconds, 0.0);
  }
}

TEST(Ranks, AnInterpolationWithoutATriangulationIsAnErrorThereToo)
{
  vtkNew<Pretended> communicator;
  communicator->Be(0, 3);
  vtkNew<vtkDummyController> controller;
  controller->SetCommunicator(communicator);
  vtkMultiProcessController::SetGlobalController(controller);
  vtkNew<vtkAdaptiveHilbertInterpolation2D> filter;
  vtkNew<Messages> said;
  said->Watch(filter);
  filter->SetInputData(makeCloud(latticePoints(100, 1000)));
  filter->SetTriangulation(nullptr);
  filter->Update();
  vtkMultiProcessController::SetGlobalController(nullptr);
  ASSERT_EQ(said->Errors.size(), 1u);
  EXPECT_NE(said->Errors[0].find("Triangulation is null"), std::string::npos) << said->Errors[0];
}

/// Places of a rank that those before it have, too, are found once more, to leave them out of the
/// counts: that takes as much as if they were given as points.
TEST(Ranks, CommonPlacesAreInTheEstimateOfAnInterpolation)
{
  auto points = makeCloud(latticePoints(1000, 1000));
  const auto estimateOf = [&points](vtkAHDSampleInputs inputs, vtkDataSet* output)
  {
    const Work work(1);
    vtkAHDSettings settings;
    vtkAHDSampleSettings wishes;
    wishes.Heights = "height";
    wishes.Mask = "mask";
    inputs.Points = points;
    vtkAHDSampleExecution execution(work.Filter, settings, wishes, work.Context, false);
    vtkAHDSampleMemoryKept none;
    EXPECT_TRUE(execution.Run(inputs, none, output));
    return 1024.0 * double(execution.GetMemory().Estimate);
  };
  const auto pieceOf = [](std::size_t firstColumn, std::size_t columns) {
    return ahd::SampleRaster{ { 0, 0 }, { 1, 1 }, columns, 300, firstColumn, 0 };
  };
  const auto estimateWith = [&](const std::vector<ahd::SampleRaster>& before)
  {
    const vtkAHDRaster piece{ vtkAHDRasterFault::None, pieceOf(100, 400), {} };
    vtkAHDSampleInputs inputs;
    inputs.Raster = &piece;
    inputs.PiecesBefore = &before;
    return estimateOf(inputs, vtkNew<vtkImageData>());
  };
  const auto estimateOfPlaces = [&](std::size_t count)
  {
    auto places = makeCloud(latticePoints(count, 1000));
    vtkAHDSampleInputs inputs;
    inputs.Places = places;
    return estimateOf(inputs, vtkNew<vtkPolyData>());
  };
  constexpr std::size_t kCommon = 250 * 300; // columns from 100 to 200, to 300, and from 450
  const double without = estimateWith({});
  const double with = estimateWith({ pieceOf(0, 200), pieceOf(150, 150), pieceOf(450, 50) });
  EXPECT_NEAR(
    with - without, estimateOfPlaces(1000 + kCommon) - estimateOfPlaces(1000), 3 * 1024.0);
}
