// SPDX-License-Identifier: BSD-3-Clause
//
// Memory runs out on one of several ranks: all end alike, with one error on each and no output, or
// with the same output as without; none waits for one that has left.
//   mpiexec -n RANKS FaultsRanks
// The allocation that fails is the first after a collective step, on one rank after the other: in
// the quick suite after some 40 of the steps of each execution.
#include "FailingMemory.h"
#include "FeatureTestSupport.h"

#include "vtkAdaptiveHilbertInterpolation2D.h"
#include "vtkMPICommunicator.h"
#include "vtkMPIController.h"
#include "vtkObjectFactory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <new>
#include <string>
#include <vector>

using namespace ahdtest;

namespace
{

/// Records the number of allocations before each collective step.
class Watching : public vtkMPICommunicator
{
public:
  static Watching* New() { VTK_STANDARD_NEW_BODY(Watching); }
  vtkTypeMacro(Watching, vtkMPICommunicator);

  using vtkMPICommunicator::AllReduceVoidArray;
  int AllReduceVoidArray(
    const void* from, void* to, vtkIdType length, int type, int operation) override
  {
    if (this->Steps.size() < this->Steps.capacity()) // nothing is allocated here
    {
      this->Steps.push_back(memory::count());
    }
    return this->Superclass::AllReduceVoidArray(from, to, length, type, operation);
  }

  std::vector<std::size_t> Steps;

private:
  Watching() { this->Steps.reserve(100000); }
};

vtkMPIController* controller = nullptr;
Watching* communicator = nullptr;

/// The features requested of the filter, where memory may run out.
enum Phase
{
  Information,
  Data
};

template <typename Algorithm>
class Faulty : public Algorithm
{
public:
  static Faulty* New() { VTK_STANDARD_NEW_BODY(Faulty); }

  Phase Where = Data;
  std::size_t FailAt = 0;         ///< the number of the allocation that fails; 0: none
  std::vector<std::size_t> Steps; ///< the allocations before each collective step
  bool Threw = false;

protected:
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override
  {
    return this->Run(
      Information, [&] { return this->Algorithm::RequestInformation(request, in, out); });
  }
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override
  {
    return this->Run(Data, [&] { return this->Algorithm::RequestData(request, in, out); });
  }

private:
  int Run(Phase phase, const std::function<int()>& work)
  {
    if (phase != this->Where)
    {
      return work();
    }
    int result = 1;
    communicator->Steps.clear();
    memory::begin(this->FailAt, false);
    try
    {
      result = work();
    }
    catch (const std::bad_alloc&)
    {
      this->Threw = true;
    }
    memory::end();
    this->Steps.assign(communicator->Steps.begin(), communicator->Steps.end());
    return result;
  }
};
using FaultyFilter = Faulty<vtkAdaptiveHilbertDelaunay2D>;
using FaultyInterpolation = Faulty<vtkAdaptiveHilbertInterpolation2D>;

std::string bytesOf(vtkDataObject* output)
{
  std::string bytes;
  if (auto* set = vtkDataSet::SafeDownCast(output))
  {
    bytes += std::to_string(set->GetNumberOfPoints()) + "," +
      std::to_string(set->GetNumberOfCells());
    addBytes(set->GetPointData(), bytes);
    addBytes(set->GetCellData(), bytes);
  }
  else if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output))
  {
    for (unsigned k = 0; k < blocks->GetNumberOfBlocks(); ++k)
    {
      bytes += bytesOf(blocks->GetBlock(k));
    }
  }
  return bytes;
}

/// A bit for each block, or for the whole output, that has no point.
int emptyOnesOf(vtkDataObject* output)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output))
  {
    int bits = blocks->GetNumberOfBlocks() == 0 ? 1 : 0;
    for (unsigned k = 0; k < blocks->GetNumberOfBlocks(); ++k)
    {
      bits |= emptyOnesOf(blocks->GetBlock(k)) << k;
    }
    return bits;
  }
  auto* set = vtkDataSet::SafeDownCast(output);
  return !set || set->GetNumberOfPoints() == 0 ? 1 : 0;
}

/// The actions on the filters of all ranks, and the outcome.
template <typename Filter>
class Case
{
public:
  Case(Phase where, const std::function<void(Filter*)>& setUp)
  {
    this->Said->Watch(this->Made);
    setUp(this->Made);
    this->Made->Where = where;
    this->Execute(0, 0);
    this->Execute(0, 0);
    this->Whole = bytesOf(this->Made->GetOutputDataObject(0));
  }

  /// Memory runs out at each of the steps, or at every allocation.
  void ExpectTogether(bool isAtEach)
  {
    const int ranks = controller->GetNumberOfProcesses();
    int most = static_cast<int>(
                 *std::max_element(this->Made->Steps.begin(), this->Made->Steps.end())) +
      1;
    int all = most;
    controller->AllReduce(&most, &all, 1, vtkCommunicator::MAX_OP);
    std::vector<int> isStep(std::size_t(all) + 1, isAtEach ? 1 : 0), isAny(isStep);
    for (const std::size_t before : this->Made->Steps)
    {
      isStep[before + 1] = 1;
    }
    controller->AllReduce(isStep.data(), isAny.data(), all + 1, vtkCommunicator::MAX_OP);
    std::vector<std::size_t> chosen;
    for (std::size_t k = 1; k < isAny.size(); ++k)
    {
      if (isAny[k] != 0)
      {
        chosen.push_back(k);
      }
    }
    const std::size_t stride = isAtEach ? 1 : 1 + chosen.size() / 40;
    int turn = 0;
    for (std::size_t i = 0; i < chosen.size(); i += stride)
    {
      SCOPED_TRACE("allocation " + std::to_string(chosen[i]));
      this->ExpectTogetherAt(chosen[i], turn++ % ranks);
    }
    this->Execute(0, 0);
    EXPECT_TRUE(this->Said->Errors.empty());
    EXPECT_EQ(bytesOf(this->Made->GetOutputDataObject(0)), this->Whole);
    EXPECT_TRUE(this->Made->Where == Information || this->Failures > 5);
  }

private:
  void Execute(std::size_t failAt, int rank)
  {
    const int own = controller->GetLocalProcessId();
    this->Said->Errors.clear();
    this->Made->Threw = false;
    this->Made->FailAt = own == rank ? failAt : 0;
    this->Made->Modified();
    this->Made->UpdatePiece(own, controller->GetNumberOfProcesses(), 1);
  }

  void ExpectTogetherAt(std::size_t failAt, int rank)
  {
    this->Execute(failAt, rank);
    EXPECT_FALSE(this->Made->Threw);
    vtkDataObject* const output = this->Made->GetOutputDataObject(0);
    // Where the raster is not known in advance, ranks get other pieces of it.
    const bool isWhole = this->Said->Errors.empty() &&
      (this->Made->Where == Information || bytesOf(output) == this->Whole);
    const int empty = emptyOnesOf(output);
    const int own[] = { isWhole ? 1 : 0, empty, -empty };
    int least[3];
    controller->AllReduce(own, least, 3, vtkCommunicator::MIN_OP);
    // of several blocks those not yet made at the failure are empty, on all ranks
    EXPECT_TRUE(least[0] != 0 || (least[1] != 0 && least[1] == -least[2])) << "of rank " << rank;
    if (least[0] == 0)
    {
      ++this->Failures;
      // a rank without memory for the message has written it to the standard error; one that cannot
      // merge its blocks reports that, too
      const std::vector<std::string>& errors = this->Said->Errors;
      const bool isOwn = rank == controller->GetLocalProcessId();
      const bool cannotMerge = isOwn && !errors.empty() &&
        errors[0].find("Merging blocks of") != std::string::npos;
      EXPECT_LE(errors.size(), cannotMerge ? 2u : 1u);
      EXPECT_TRUE(errors.size() == 1 || isOwn);
    }
  }

  vtkNew<Filter> Made;
  vtkNew<Messages> Said;
  std::string Whole;
  int Failures = 0;
};

/// One rank's points of all, and with data.
vtkSmartPointer<vtkPolyData> pointsOfRank(std::size_t count, int type = VTK_DOUBLE)
{
  auto cloud = cloudWithAll(count, type);
  const double shift = 313.7 * controller->GetLocalProcessId();
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    double p[3];
    cloud->GetPoint(i, p);
    cloud->GetPoints()->SetPoint(i, p[0] + shift, p[1] + (i % 3 == 0 ? 7.3 : 0.0) * shift, p[2]);
  }
  return cloud;
}

using Filter = vtkAdaptiveHilbertDelaunay2D;

/// Rims, fitted planes, loops, means, blocks, and work that one rank does for all.
void expectTrianglesTogether(bool isAtEach)
{
  const std::vector<std::pair<const char*, std::function<void(FaultyFilter*)>>> ways = {
    { "constraints",
      [](Filter* f)
      {
        f->SetSourceData(makeSource({ { 0, 5, 11 }, { 7, 12 } }, { { 20, 21, 22 } }));
        f->GenerateConstraintEdgesOn();
        f->GenerateFateOn();
        f->SetMaximumEdgeLength(600.0);
        f->SetDuplicatePolicy(Filter::MEAN_Z);
      } },
    { "coordinates",
      [](Filter* f)
      {
        f->SetSourceData(sourceWithAll());
        f->SetSourceMode(Filter::SOURCE_COORDINATES);
        f->BoundingTriangulationOn();
      } },
    { "a fitted plane", [](Filter* f) { f->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE); } },
    { "on one rank",
      [](Filter* f)
      {
        f->SetSourceData(sourceWithAll());
        f->SetSourceMode(Filter::SOURCE_COORDINATES);
        f->GenerateVoronoiOn();
      } },
    { "merged blocks",
      [](Filter* f)
      {
        f->MergeBlocksOn();
        f->SetInputDataObject(tilesWithAll(60));
      } },
    { "blocks", [](Filter* f) { f->SetInputDataObject(tilesWithAll(60)); } },
  };
  for (const auto& way : ways)
  {
    SCOPED_TRACE(way.first);
    Case<FaultyFilter>(Data,
      [&](FaultyFilter* filter)
      {
        filter->SetController(controller);
        filter->DistributePointsOn();
        filter->SetInputData(pointsOfRank(60));
        filter->SetNumberOfThreads(1);
        way.second(filter);
      })
      .ExpectTogether(isAtEach);
  }
}

void expectValuesTogether(Phase where, bool isAtEach)
{
  using Interpolation = vtkAdaptiveHilbertInterpolation2D;
  const std::vector<std::pair<const char*, std::function<void(Interpolation*)>>> ways = {
    { "raster",
      [](Interpolation* f)
      {
        f->SetSourceData(makeSource({ { 0, 5, 11 }, { 7, 12 } }, {}));
        f->GenerateGradientsOn();
        f->SetOutsideToNearestVertex();
      } },
    { "all on each",
      [](Interpolation* f)
      {
        f->GetTriangulation()->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
        f->SetOutputTypeToSurface();
      } },
    { "places",
      [](Interpolation* f)
      {
        f->SetPlacesData(pointsOfRank(20));
        f->SetMethod(Interpolation::NATURAL_NEIGHBOR);
      } },
  };
  for (std::size_t k = 0; k < ways.size() - (where == Information ? 1 : 0); ++k)
  {
    SCOPED_TRACE(ways[k].first);
    Case<FaultyInterpolation>(where,
      [&](FaultyInterpolation* filter)
      {
        filter->GetTriangulation()->SetController(controller);
        filter->GetTriangulation()->DistributePointsOn();
        filter->GetTriangulation()->SetNumberOfThreads(1);
        filter->SetInputData(pointsOfRank(60));
        filter->SetDimensions(9, 8);
        ways[k].second(filter);
      })
      .ExpectTogether(isAtEach);
  }
}

}

TEST(FaultsRanks, TrianglesEndTogether)
{
  expectTrianglesTogether(false);
}

TEST(FaultsRanks, ValuesEndTogether)
{
  expectValuesTogether(Data, false);
}

TEST(FaultsRanks, WhatIsSaidOfARasterBeforeItIsMadeEndsTogether)
{
  expectValuesTogether(Information, false);
}

TEST(LongFaultsRanks, AtEveryAllocation)
{
  expectTrianglesTogether(true);
  expectValuesTogether(Data, true);
  expectValuesTogether(Information, true);
}

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  vtkNew<vtkMPIController> ranks;
  ranks->Initialize(&argc, &argv);
  int status = 1;
  {
    vtkNew<Watching> watching;
    watching->CopyFrom(vtkMPICommunicator::GetWorldCommunicator());
    vtkNew<vtkMPIController> watched;
    watched->SetCommunicator(watching);
    controller = watched;
    communicator = watching;
    status = controller->GetNumberOfProcesses() > 1 ? RUN_ALL_TESTS() : 2;
  }
  ranks->Finalize();
  return status;
}
