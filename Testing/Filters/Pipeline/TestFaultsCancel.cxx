// SPDX-License-Identifier: BSD-3-Clause
//
// Aborted at random moments with all features on: empty outputs, no message, and the next execution
// is that of a new filter. Executed in two threads at once, each filter with copies of its own.
#include "FeatureTestSupport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <random>
#include <thread>

using namespace ahdtest;

namespace
{

/// Counts the progress events of an execution; aborts at one of them, or at the first after `Asked`
/// was set by another thread.
class Aborter : public vtkCommand
{
public:
  static Aborter* New() { return new Aborter; }

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    if (++this->Events == this->AbortAt || this->Asked)
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
      this->Aborted = true;
    }
  }

  int AbortAt = 0; ///< 0: never
  int Events = 0;
  std::atomic<bool> Asked{ false };
  bool Aborted = false;
};

/// A filter that is aborted and runs on.
struct AbortedFilter
{
  AbortedFilter(const Feature& feature, std::size_t count)
  {
    feature.SetUp(this->Filter.Filter, count);
    this->Filter->AddObserver(vtkCommand::ProgressEvent, this->Abort);
    this->Execute(0);
    this->Events = this->Abort->Events;
    this->Whole = outputOf(this->Filter.Filter);
  }

  void Execute(int abortAt)
  {
    this->Abort->AbortAt = abortAt;
    this->Abort->Events = 0;
    this->Abort->Aborted = false;
    this->Filter->SetAbortExecute(0); // VTK 9.1 does this by itself
    this->Filter->Modified();
    this->Filter->Update();
    EXPECT_TRUE(this->Filter.Said->Errors.empty()) << this->Filter.Said->Errors[0];
  }

  /// After an execution that was aborted, or no longer.
  void ExpectReusable()
  {
    // The last event may come after all work.
    const bool isWhole = outputOf(this->Filter.Filter) == this->Whole;
    EXPECT_TRUE(isWhole || sizeOfOutput(this->Filter.Filter) == 0);
    EXPECT_TRUE(isWhole || this->Abort->Aborted);
    this->Empty += !isWhole;
    this->Abort->Asked = false;
    this->Execute(0);
    EXPECT_TRUE(outputOf(this->Filter.Filter) == this->Whole);
  }

  WatchedFilter Filter;
  vtkNew<Aborter> Abort;
  std::string Whole;
  int Events = 0;
  int Empty = 0; ///< executions that were aborted before their end
};

void expectReusable(std::size_t count, int moments)
{
  std::mt19937 random(1);
  const std::vector<Feature> features = allFeatures();
  for (const Feature& feature : features)
  {
    SCOPED_TRACE(feature.Name);
    AbortedFilter filter(feature, count);
    ASSERT_GT(filter.Events, 2);
    const int each = moments / int(features.size()) + 1;
    for (int i = 0; i < each; ++i)
    {
      filter.Execute(1 + int(random() % unsigned(filter.Events)));
      filter.ExpectReusable();
    }
    EXPECT_GT(filter.Empty, each / 4);
  }
}

/// The observer aborts, on the thread that executes, when another thread has requested it: that
/// thread must not call SetAbortExecute itself, as VTK's flag is not atomic.
void expectReusableByTheClock(std::size_t count, int moments)
{
  AbortedFilter filter(allFeatures()[1], count);
  std::mt19937 random(1);
  for (int i = 0; i < moments; ++i)
  {
    const std::chrono::microseconds wait(random() % 20000);
    Aborter* const abort = filter.Abort;
    std::thread other(
      [abort, wait]
      {
        std::this_thread::sleep_for(wait);
        abort->Asked = true;
      });
    filter.Execute(0);
    other.join();
    filter.ExpectReusable();
  }
}

/// Two filters in two threads. Each has a pipeline of its own, with shallow copies: the arrays are
/// shared, the data objects are not.
void expectAlikeInTwoThreads(const Feature& feature, std::size_t count, int rounds)
{
  SCOPED_TRACE(feature.Name);
  WatchedFilter alone;
  feature.SetUp(alone.Filter, count);
  alone->Update();
  const std::string expected = outputOf(alone.Filter);
  WatchedFilter filters[2];
  for (WatchedFilter& filter : filters)
  {
    feature.SetUp(filter.Filter, count);
    for (int port = 0; port < 2; ++port)
    {
      if (vtkDataObject* given = alone->GetTotalNumberOfInputConnections() > port
          ? alone->GetInputDataObject(port, 0)
          : nullptr)
      {
        auto copy = vtkSmartPointer<vtkDataObject>::Take(given->NewInstance());
        copy->ShallowCopy(given);
        filter->SetInputDataObject(port, copy);
      }
    }
  }
  const auto work = [&](WatchedFilter& filter)
  {
    for (int i = 0; i < rounds; ++i)
    {
      filter->Modified();
      filter->Update();
    }
  };
  std::thread other([&] { work(filters[0]); });
  work(filters[1]);
  other.join();
  EXPECT_TRUE(outputOf(filters[0].Filter) == expected);
  EXPECT_TRUE(outputOf(filters[1].Filter) == expected);
}

}

TEST(FaultsCancel, AbortedAtRandomMoments)
{
  expectReusable(3000, 200);
}

TEST(LongFaultsCancel, AbortedAtAThousandRandomMoments)
{
  expectReusable(20000, 1000);
}

TEST(FaultsCancel, AbortedFromAnotherThread)
{
  expectReusableByTheClock(5000, 30);
}

TEST(LongFaultsCancel, AbortedFromAnotherThreadAtAThousandMoments)
{
  expectReusableByTheClock(20000, 1000);
}

TEST(FaultsCancel, TwoFiltersInTwoThreadsShareTheArrays)
{
  for (const Feature& feature : allFeatures())
  {
    expectAlikeInTwoThreads(feature, 2000, 5);
  }
}

TEST(FaultsCancel, PointsChangedWhereTheyLieAreSeenOnceModified)
{
  auto cloud = makeCloud(scatteredPoints(500));
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->Update();
  const std::string before = outputOf(filter.Filter);
  const std::vector<Triangle> triangles = trianglesOf(filter->GetOutput());
  cloud->GetPoints()->SetPoint(7, 2.0, 2.0, 0.0);
  filter->Update();
  EXPECT_EQ(trianglesOf(filter->GetOutput()), triangles) << "nobody said that they changed";
  cloud->GetPoints()->Modified();
  filter->Update();
  EXPECT_NE(trianglesOf(filter->GetOutput()), triangles);
  WatchedFilter fresh;
  fresh->SetInputData(cloud);
  fresh->Update();
  EXPECT_TRUE(outputOf(filter.Filter) == outputOf(fresh.Filter));

  cloud->SetPoints(makePoints(scatteredPoints(300, 9))); // other arrays
  filter->Update();
  fresh->Update();
  EXPECT_TRUE(outputOf(filter.Filter) == outputOf(fresh.Filter));
}

TEST(FaultsCancel, AnInputLivesAsLongAsTheFilterNeedsIt)
{
  WatchedFilter filter;
  std::string expected;
  {
    auto cloud = makeCloud(scatteredPoints(500));
    WatchedFilter other;
    other->SetInputData(cloud);
    other->Update();
    expected = outputOf(other.Filter);
    filter->SetInputData(cloud);
  }
  filter->Update();
  EXPECT_TRUE(outputOf(filter.Filter) == expected);

  // and the output of a deleted one feeds another
  vtkSmartPointer<vtkPolyData> surface = filter->GetOutput();
  const std::vector<Triangle> triangles = trianglesOf(surface);
  {
    WatchedFilter first;
    first->SetInputData(surface);
    first->Update();
    surface = first->GetOutput();
  }
  filter->SetInputData(surface);
  filter->Update();
  EXPECT_EQ(trianglesOf(filter->GetOutput()), triangles);
}
