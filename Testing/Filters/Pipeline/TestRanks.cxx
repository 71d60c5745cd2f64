// SPDX-License-Identifier: BSD-3-Clause
//
// On several ranks the filter says, once, that each rank works on its own points.
#include "FilterTestSupport.h"

#include "vtkDummyCommunicator.h"
#include "vtkDummyController.h"
#include "vtkObjectFactory.h"

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
