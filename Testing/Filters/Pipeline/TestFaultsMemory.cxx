// SPDX-License-Identifier: BSD-3-Clause
//
// Memory runs out anywhere in the filter: one error, empty outputs, nothing thrown, nothing leaked,
// and the next execution is unaffected. A program of its own, whose operator new and malloc fail on
// demand.
#include "FailingMemory.h"
#include "FeatureTestSupport.h"

#include "vtkAdaptiveHilbertInterpolation2D.h"
#include "vtkAdaptiveHilbertQualityMesh2D.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPlanarPointSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <new>
#include <random>

using namespace ahdtest;

namespace
{

/// A filter or source whose memory runs out while it executes.
template <typename Algorithm>
class Faulty : public Algorithm
{
public:
  static Faulty* New() { VTK_STANDARD_NEW_BODY(Faulty); }

  std::size_t FailAt = 0; ///< the number of the allocation that fails; 0: none
  bool AndAllLater = false;
  std::size_t Asked = 0; ///< allocations of the last execution
  bool Threw = false;

protected:
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override
  {
    int result = 1;
    this->Threw = false;
    memory::begin(this->FailAt, this->AndAllLater);
    try
    {
      result = this->Algorithm::RequestData(request, in, out);
    }
    catch (const std::bad_alloc&)
    {
      this->Threw = true;
    }
    this->Asked = memory::end();
    return result;
  }
};
using FaultyFilter = Faulty<vtkAdaptiveHilbertDelaunay2D>;
using FaultySource = Faulty<vtkPlanarPointSource>;

/// The actions on a filter, and the outcome.
struct Case
{
  Case(const Feature& feature, std::size_t count, int threads)
  {
    this->Said->Watch(this->Filter);
    feature.SetUp(this->Filter, count);
    this->Filter->SetNumberOfThreads(threads);
    // Twice: then permanent memory of the standard library and VTK exists.
    this->Execute(0);
    this->Execute(0);
    this->Whole = outputOf(this->Filter);
  }

  void Execute(std::size_t failAt, bool andAllLater = false)
  {
    this->Said->Errors.clear();
    this->Filter->FailAt = failAt;
    this->Filter->AndAllLater = andAllLater;
    this->Filter->GetInputDataObject(0, 0)->Modified();
    this->Filter->Update();
  }

  /// Fails at `failAt` of an execution, and executes once more without.
  void ExpectSurvived(std::size_t failAt, bool andAllLater)
  {
    this->Execute(failAt, andAllLater);
    EXPECT_FALSE(this->Filter->Threw);
    if (this->Said->Errors.empty() && sizeOfOutput(this->Filter) > 0)
    {
      // It was not needed, or the text of a warning did not fit.
      EXPECT_TRUE(outputOf(this->Filter) == this->Whole);
      return;
    }
    ++this->Failures;
    EXPECT_EQ(sizeOfOutput(this->Filter), 0);
    EXPECT_EQ(this->Filter->GetNumberOfTriangles(), 0);
    // Without any memory left, the error may appear only on the standard error.
    EXPECT_LE(this->Said->Errors.size(), 1u);
    EXPECT_TRUE(andAllLater || this->Said->Errors.size() == 1);
    for (const std::string& error : this->Said->Errors)
    {
      EXPECT_NE(error.find("emory"), std::string::npos) << error;
    }
    this->Execute(0);
    EXPECT_TRUE(this->Said->Errors.empty());
    EXPECT_TRUE(outputOf(this->Filter) == this->Whole);
  }

  vtkNew<FaultyFilter> Filter;
  vtkNew<Messages> Said;
  std::string Whole; ///< the output of an execution without a failure
  std::size_t Failures = 0;
};

/// Fails at every allocation, or at so many of them, evenly spread, of an execution that is the
/// first of its kind, the second (which takes fingerprints) or the third (which passes on).
void expectSurvivedAnywhere(const Feature& feature, std::size_t count, std::size_t most)
{
  Case given(feature, count, 1);
  for (int past = 0; past < 3; ++past)
  {
    const auto execute = [&](std::size_t failAt)
    {
      given.Filter->Modified();
      for (int i = 0; i < past; ++i)
      {
        given.Execute(0);
      }
      given.ExpectSurvived(failAt, past == 1);
    };
    execute(0);
    const std::size_t all = given.Filter->Asked;
    EXPECT_GT(all, 0u) << "the filter no longer allocates through operator new";
    const std::size_t step = std::max<std::size_t>(1, all / most);
    for (std::size_t k = 1 + std::size_t(past) % step; k <= all + step; k += step)
    {
      SCOPED_TRACE("allocation " + std::to_string(k) + " after " + std::to_string(past));
      execute(k);
    }
  }
  EXPECT_GT(given.Failures, 20u);
}

void expectNoLeakAnywhere(const Feature& feature, std::size_t count, std::size_t most)
{
  SCOPED_TRACE(feature.Name);
  std::ptrdiff_t before = memory::blocks();
  expectSurvivedAnywhere(feature, count, most);
  if (memory::blocks() != before) // permanent memory was new the first time
  {
    before = memory::blocks();
    expectSurvivedAnywhere(feature, count, most);
    EXPECT_EQ(memory::blocks(), before) << "something leaked";
  }
}

}

TEST(FaultsMemory, RunningOutAtAnyAllocationIsOneErrorAndNoMore)
{
  for (const Feature& feature : allFeatures())
  {
    expectNoLeakAnywhere(feature, 90, 12);
  }
}

/// Which comes first: no allocation of these is left out.
TEST(FaultsMemory, RunningOutWhileBlocksAreMergedIsOneErrorToo)
{
  for (const Feature& feature : allFeatures())
  {
    if (feature.Name != std::string("blocks"))
    {
      continue;
    }
    Case given(feature, 30, 1);
    for (std::size_t k = 1; k <= 30; ++k)
    {
      SCOPED_TRACE(k);
      given.Filter->Modified();
      given.ExpectSurvived(k, false);
    }
  }
}

TEST(LongFaultsMemory, RunningOutAtEveryAllocation)
{
  for (const Feature& feature : allFeatures())
  {
    expectNoLeakAnywhere(feature, 150, std::size_t(-1));
  }
}

TEST(LongFaultsMemory, RunningOutAtAThousandOfALargeInputWithThreads)
{
  std::mt19937 random(1);
  const std::vector<Feature> features = allFeatures();
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    SCOPED_TRACE(features[i].Name);
    Case given(features[i], 20000, 3);
    const std::size_t all = given.Filter->Asked;
    for (int k = 0; k < 1000 / int(features.size()) + 1; ++k)
    {
      const std::size_t failAt = 1 + random() % all;
      SCOPED_TRACE(failAt);
      given.Filter->Modified(); // or outputs are passed on
      given.ExpectSurvived(failAt, k % 2 == 1);
    }
    EXPECT_GT(given.Failures, 50u);
  }
}

/// Without any memory left, the error may appear only on the standard error.
void expectSourceSurvives(bool andAllLater)
{
  vtkNew<FaultySource> source;
  source->AndAllLater = andAllLater;
  vtkNew<Messages> said;
  said->Watch(source);
  source->SetNumberOfPoints(100);
  source->Update();
  const std::size_t all = source->Asked;
  EXPECT_GT(all, 2u);
  std::size_t refused = 0;
  for (std::size_t k = 1; k <= all; ++k)
  {
    SCOPED_TRACE(k);
    said->Errors.clear();
    source->FailAt = k;
    source->Modified();
    source->Update();
    EXPECT_FALSE(source->Threw);
    const bool didWithout = source->GetOutput()->GetNumberOfPoints() > 0; // as a stream does
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), didWithout ? 100 : 0);
    EXPECT_EQ(source->GetOutput()->GetNumberOfCells(), didWithout ? 1 : 0);
    EXPECT_LE(said->Errors.size(), didWithout ? 0u : 1u);
    EXPECT_TRUE(didWithout || andAllLater || said->Errors.size() == 1);
    refused += didWithout ? 0 : 1;
  }
  EXPECT_GT(refused, 2u);
  source->FailAt = 0;
  source->Modified();
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 100);
}

TEST(FaultsMemory, TheSourceOfPointsSaysSoToo)
{
  expectSourceSurvives(false);
  expectSourceSurvives(true);
}

using FaultyInterpolation = Faulty<vtkAdaptiveHilbertInterpolation2D>;

std::string bytesOf(vtkDataSet* output)
{
  std::string bytes;
  addBytes(output->GetPointData(), bytes);
  addBytes(output->GetFieldData(), bytes);
  return bytes;
}

/// The first execution of the points or the second, on the kept triangulation.
void expectInterpolationSurvives(
  FaultyInterpolation* filter, const Messages* said, bool isFirst, bool andAllLater)
{
  filter->AndAllLater = andAllLater;
  filter->Update();
  const std::string whole = bytesOf(filter->GetOutput());
  std::size_t failures = 0, all = 0;
  for (std::size_t k = 0; k <= all + 1; ++k)
  {
    SCOPED_TRACE(k);
    const std::size_t before = said->Errors.size();
    filter->FailAt = 0;
    filter->GetTriangulation()->SetNmax(50 + (isFirst ? int(k % 2) : 0));
    filter->Modified();
    if (!isFirst)
    {
      filter->Update();
      filter->Modified();
    }
    filter->FailAt = k;
    filter->Update();
    all = k == 0 ? filter->Asked : all;
    EXPECT_FALSE(filter->Threw);
    const bool isWhole = bytesOf(filter->GetOutput()) == whole;
    const std::size_t errors = said->Errors.size() - before;
    EXPECT_LE(errors, isWhole ? 0u : 1u);
    EXPECT_TRUE(isWhole || andAllLater || errors == 1);
    EXPECT_TRUE(isWhole || filter->GetOutput()->GetNumberOfPoints() == 0);
    EXPECT_TRUE(errors == 0 || said->Errors.back().find("emory") != std::string::npos);
    failures += isWhole ? 0 : 1;
  }
  EXPECT_GT(failures, 20u);
}

TEST(FaultsMemory, TheInterpolationSurvivesToo)
{
  for (const int method : { 0, 1, 3 })
  {
    for (const int variant : { 0, 1, 2, 3 })
    {
      SCOPED_TRACE(method);
      vtkNew<FaultyInterpolation> filter;
      vtkNew<Messages> said;
      said->Watch(filter);
      auto cloud = cloudWithAll(100);
      cloud->GetPointData()->RemoveArray("Name"); // no warning, which may need memory
      filter->SetInputData(cloud);
      filter->SetDimensions(20, 10);
      filter->SetMethod(method);
      filter->SetOutsideToNearestVertex();
      filter->SetOutputTypeToSurface();
      expectInterpolationSurvives(filter, said, variant % 2 == 0, variant / 2 == 1);
    }
  }
}

/// With triangles that are made constraints, and points that are hidden.
TEST(FaultsMemory, TheInterpolationOnASurfaceSurvivesToo)
{
  auto cloud = cloudWithAll(100);
  cloud->GetPointData()->RemoveArray("Name");
  vtkNew<vtkAdaptiveHilbertDelaunay2D> delaunay;
  delaunay->SetInputData(cloud);
  delaunay->GenerateConstraintEdgesOn();
  delaunay->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
  vtkNew<FaultyInterpolation> filter;
  vtkNew<Messages> said;
  said->Watch(filter);
  filter->SetInputConnection(delaunay->GetOutputPort());
  filter->GetTriangulation()->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
  filter->SetDimensions(20, 10);
  expectInterpolationSurvives(filter, said, true, false);
}

/// Of an execution that is the first or not; the memory of points, pieces, triangles and outputs.
TEST(FaultsMemory, TheQualityMeshSurvivesToo)
{
  vtkNew<Faulty<vtkAdaptiveHilbertQualityMesh2D>> filter;
  vtkNew<Messages> said;
  said->Watch(filter);
  auto cloud = cloudWithAll(40);
  cloud->GetPointData()->RemoveArray("Name"); // no warning, which may need memory
  filter->SetInputData(cloud);
  filter->SetMinimumAngle(25);
  filter->SetMaximumNumberOfAddedPoints(40);
  const auto bytes = [&] { return bytesOf(filter->GetOutput(0)) + bytesOf(filter->GetOutput(1)); };
  filter->Update();
  const std::string whole = bytes();
  ASSERT_GT(filter->GetNumberOfAddedPoints(), 10);
  std::size_t failures = 0;
  for (std::size_t k = 0, all = 0; k <= 2 * all + 1; ++k)
  {
    SCOPED_TRACE(k);
    said->Errors.clear();
    filter->AndAllLater = k > all;
    filter->FailAt = k > all ? k - all : k;
    filter->Modified();
    filter->Update();
    all = k == 0 ? filter->Asked : all;
    EXPECT_FALSE(filter->Threw);
    const bool isWhole = bytes() == whole;
    EXPECT_LE(said->Errors.size(), isWhole ? 0u : 1u);
    EXPECT_TRUE(isWhole || filter->AndAllLater || said->Errors.size() == 1);
    EXPECT_TRUE(isWhole ||
      (filter->GetOutput(0)->GetNumberOfPoints() == 0 && filter->GetNumberOfTriangles() == 0));
    EXPECT_TRUE(said->Errors.empty() || said->Errors.back().find("emory") != std::string::npos);
    failures += isWhole ? 0 : 1;
  }
  EXPECT_GT(failures, 100u);
}

namespace
{
/// A filter whose memory runs out in any request of an update; before the data also VTK's.
template <typename Algorithm>
class FaultyRequests : public Algorithm
{
public:
  static FaultyRequests* New() { VTK_STANDARD_NEW_BODY(FaultyRequests); }

  std::size_t FailAt = 0; ///< the number of the allocation that fails, of all requests; 0: none
  bool AndAllLater = false;
  std::size_t Asked = 0; ///< allocations of all requests
  bool Threw = false;
  bool Refused = false; ///< did a request fail before the data?

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    const bool isBefore = request->Has(Pipeline::REQUEST_INFORMATION()) ||
      request->Has(Pipeline::REQUEST_UPDATE_EXTENT());
    const bool isDue = this->FailAt > this->Asked;
    const bool isPast = this->FailAt > 0 && this->AndAllLater && !isDue;
    memory::begin(
      isDue ? this->FailAt - this->Asked : std::size_t(isPast), this->AndAllLater, isBefore);
    int result = 0;
    try
    {
      result = this->Algorithm::ProcessRequest(request, in, out);
    }
    catch (const std::bad_alloc&)
    {
      this->Threw = true;
    }
    this->Asked += memory::end();
    this->Refused = this->Refused || (isBefore && !result);
    return result;
  }
};

/// Fails at each allocation of the first update of a filter, as later ones find what VTK keeps of
/// the requests.
template <typename Algorithm, typename SetUp>
void expectFirstUpdateSurvives(const SetUp& setUp, bool andAllLater)
{
  std::size_t refused = 0, all = 0;
  vtkIdType whole = 0;
  for (std::size_t k = 0; k <= all; ++k)
  {
    SCOPED_TRACE(k);
    vtkNew<FaultyRequests<Algorithm>> filter;
    vtkNew<Messages> said, pipelineSaid;
    said->Watch(filter);
    pipelineSaid->Watch(filter->GetExecutive());
    setUp(filter.Get());
    filter->FailAt = k;
    filter->AndAllLater = andAllLater;
    filter->Update();
    const auto points = [&filter]
    { return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(); };
    all = k == 0 ? filter->Asked : all;
    whole = k == 0 ? points() : whole;
    EXPECT_FALSE(filter->Threw);
    EXPECT_LE(said->Errors.size(), 1u);
    EXPECT_TRUE(points() == whole || points() == 0);
    if (filter->Refused)
    {
      ++refused;
      EXPECT_TRUE(andAllLater || said->Errors.size() == 1);
      EXPECT_TRUE(said->Errors.empty() || said->Errors[0].find("emory") != std::string::npos);
      filter->FailAt = 0;
      if (andAllLater)
      {
        filter->Modified(); // VTK went on to the data, whose failure was told
      }
      filter->Update();
      EXPECT_EQ(points(), whole);
    }
  }
  EXPECT_GT(refused, 0u) << "nothing was tested";
}
}

TEST(FaultsMemory, RequestsBeforeTheDataSurviveToo)
{
  vtkNew<vtkImageData> places;
  places->SetDimensions(3, 2, 1);
  for (const bool andAllLater : { false, true })
  {
    expectFirstUpdateSurvives<vtkAdaptiveHilbertDelaunay2D>([](vtkAdaptiveHilbertDelaunay2D* filter)
      { filter->SetInputData(cloudWithAll(10)); },
      andAllLater);
    expectFirstUpdateSurvives<vtkAdaptiveHilbertInterpolation2D>(
      [&places](vtkAdaptiveHilbertInterpolation2D* filter)
      {
        filter->SetInputData(cloudWithAll(10));
        filter->SetPlacesData(places);
        filter->SetTriangulation(nullptr); // told with the data
      },
      andAllLater);
  }
}

TEST(FaultsMemory, NoPlaneWhereThereIsNoMemory)
{
  auto cloud = cloudWithAll(100, VTK_INT); // to be converted
  std::size_t asked = 1;
  std::size_t refusals = 0;
  for (std::size_t k = 0; k <= asked; ++k)
  {
    memory::begin(k, false);
    vtkAbstractTransform* plane = vtkAdaptiveHilbertDelaunay2D::ComputeBestFittingPlane(cloud);
    asked = std::max(memory::end(), asked);
    EXPECT_TRUE(plane || k > 0);
    refusals += plane == nullptr;
    if (plane)
    {
      plane->Delete();
    }
  }
  EXPECT_GT(refusals, 0u);
}
