// SPDX-License-Identifier: BSD-3-Clause
//
// The filter on several threads: the same bytes, progress and abort on the calling thread only, and
// the working memory that is kept for the next execution.
#include "FilterTestSupport.h"

#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkTypeInt32Array.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <thread>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

using namespace ahdtest;

namespace
{
constexpr std::size_t kCount = 120000;  // well above the engine's threshold for threads
constexpr std::size_t kShared = 300000; // the threshold of the filter's own loops

/// All triangle data of an output, as it lies in memory.
std::vector<char> bytesOf(vtkPolyData* surface)
{
  std::vector<char> bytes;
  for (vtkDataArray* array : { surface->GetPolys()->GetConnectivityArray(),
         surface->GetPolys()->GetOffsetsArray(), surface->GetPointData()->GetArray("Fate") })
  {
    if (array)
    {
      const char* begin = static_cast<const char*>(array->GetVoidPointer(0));
      bytes.insert(
        bytes.end(), begin, begin + array->GetNumberOfValues() * array->GetDataTypeSize());
    }
  }
  return bytes;
}

/// Notes progress and the thread it comes from, and aborts at a given one.
class ThreadWatch : public vtkCommand
{
public:
  static ThreadWatch* New() { return new ThreadWatch; }
  void Execute(vtkObject* caller, unsigned long, void* amount) override
  {
    this->OnOtherThread += std::this_thread::get_id() != this->Home;
    this->Seen.push_back(*static_cast<double*>(amount));
    if (!this->Aborted && this->Seen.back() >= this->AbortAt)
    {
      this->Aborted = true;
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
    else if (this->Aborted)
    {
      ++this->SeenAfterAbort;
    }
  }

  const std::thread::id Home = std::this_thread::get_id();
  std::vector<double> Seen;
  double AbortAt = 2.0;
  bool Aborted = false;
  int OnOtherThread = 0;
  int SeenAfterAbort = 0;
};
}

TEST(Threads, AnyNumberGivesTheSameBytes)
{
  struct Case
  {
    int Side;
    int Type;
    std::size_t Count;
  };
  for (const Case& c : { Case{ 1000000, VTK_DOUBLE, kCount }, Case{ 300, VTK_FLOAT, kCount },
         Case{ 400, VTK_INT, kShared } }) // the latter: ties and duplicates
  {
    auto cloud = makeCloud(latticePoints(c.Count, c.Side), c.Type);
    std::vector<char> expected;
    for (int threads : { 1, 2, 3, 5, 8, 0 })
    {
      vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
      filter->SetInputData(cloud);
      filter->SetNumberOfThreads(threads);
      filter->GenerateFateOn();
      filter->Update();
      const std::vector<char> bytes = bytesOf(filter->GetOutput());
      ASSERT_FALSE(bytes.empty());
      expected = expected.empty() ? bytes : expected;
      EXPECT_TRUE(bytes == expected) << threads << " threads, lattice of " << c.Side;
      if (threads > 0)
      {
        EXPECT_EQ(filter->GetNumberOfThreadsUsed(), threads);
      }
    }
  }
}

TEST(Threads, MessagesAreTheSame)
{
  std::vector<Xyz> points = latticePoints(kShared, 1000000);
  points[70017][1] = std::numeric_limits<double>::quiet_NaN();
  points[100][2] = std::numeric_limits<double>::infinity();
  points[290000][0] = std::numeric_limits<double>::infinity();
  for (int threads : { 1, 5 })
  {
    WatchedFilter filter;
    filter->SetInputData(makeCloud(points));
    filter->SetNumberOfThreads(threads);
    filter->Update();
    ASSERT_EQ(filter.Said->Warnings.size(), 2u);
    EXPECT_NE(filter.Said->Warnings[0].find("first is point 70017."), std::string::npos);
    EXPECT_NE(filter.Said->Warnings[1].find("1 of 300000 points"), std::string::npos);
  }
}

TEST(Threads, NumberUsed)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  EXPECT_EQ(filter->GetNumberOfThreadsUsed(), 0) << "nothing was executed";
  filter->SetInputData(makeCloud(latticePoints(100, 1000)));
  filter->SetNumberOfThreads(4);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfThreadsUsed(), 1) << "too few points to share";

  filter->SetInputData(makeCloud(latticePoints(kCount, 1000000)));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfThreadsUsed(), 4);
  vtkSMPTools::Initialize(1);
  filter->SetNumberOfThreads(0);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfThreadsUsed(), 1);
  vtkSMPTools::Initialize(0);
}

TEST(Threads, ProgressComesFromTheCallingThreadOnlyAndRises)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(makeCloud(latticePoints(2 * kCount, 1000000)));
  filter->SetNumberOfThreads(3);
  vtkNew<ThreadWatch> watch;
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  EXPECT_EQ(watch->OnOtherThread, 0);
  ASSERT_FALSE(watch->Seen.empty());
  EXPECT_EQ(watch->Seen.back(), 1.0);
  for (std::size_t i = 1; i < watch->Seen.size(); ++i)
  {
    EXPECT_GE(watch->Seen[i], watch->Seen[i - 1]) << "at report " << i;
  }
}

TEST(Threads, AbortIsHeardAtOnceAndLeavesAReusableFilter)
{
  for (int type : { VTK_DOUBLE, VTK_INT })
  {
    auto cloud = makeCloud(latticePoints(kCount, 1000000), type);
    vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
    filter->SetInputData(cloud);
    filter->SetNumberOfThreads(4);
    filter->Update();
    const std::vector<char> expected = bytesOf(filter->GetOutput());
    for (double at : { 0.0, 0.1, 0.3, 0.6, 0.9 })
    {
      vtkNew<ThreadWatch> watch;
      watch->AbortAt = at;
      const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, watch);
      filter->SetAbortExecute(0);
      filter->Modified();
      filter->Update();
      EXPECT_TRUE(watch->Aborted) << at;
      // The pipeline may report once, with 1, that the filter is done.
      EXPECT_LE(watch->SeenAfterAbort, 1) << "work went on after the abort at " << at;
      EXPECT_EQ(watch->OnOtherThread, 0);
      EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << at;
      EXPECT_EQ(filter->GetNumberOfThreadsUsed(), 0) << at;
      filter->RemoveObserver(tag);
      filter->SetAbortExecute(0);
      filter->Modified();
      filter->Update();
      EXPECT_TRUE(bytesOf(filter->GetOutput()) == expected) << "after an abort at " << at;
    }
  }
}

TEST(Threads, TwoFiltersAtATime)
{
  auto cloud = makeCloud(latticePoints(kCount, 1000000));
  vtkNew<vtkAdaptiveHilbertDelaunay2D> reference;
  reference->SetInputData(cloud);
  reference->Update();
  const std::vector<char> expected = bytesOf(reference->GetOutput());
  std::vector<int> right(3, 0);
  std::vector<std::thread> users;
  for (std::size_t user = 0; user < right.size(); ++user)
  {
    auto own = makeCloud(latticePoints(kCount, 1000000)); // pipelines do not share inputs
    users.emplace_back(
      [&right, &expected, own, user]
      {
        vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
        filter->SetInputData(own);
        filter->SetNumberOfThreads(3);
        for (int i = 0; i < 3; ++i)
        {
          filter->Modified();
          filter->Update();
          right[user] += bytesOf(filter->GetOutput()) == expected;
        }
      });
  }
  for (std::thread& user : users)
  {
    user.join();
  }
  EXPECT_EQ(right, std::vector<int>(3, 3));
}

TEST(Threads, SettingsThatWantOneThreadGiveTheSame)
{
  auto cloud = makeCloud(latticePoints(50000, 1000000));
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(cloud);
  filter->SetNumberOfThreads(3);
  filter->Update();
  const std::vector<char> expected = bytesOf(filter->GetOutput());
  filter->CountWorkOn();
  filter->Update();
  EXPECT_TRUE(bytesOf(filter->GetOutput()) == expected);
  EXPECT_GT(filter->GetNP(), 1.0);
  filter->SetInsertionOrderToMultiGrid();
  filter->Update();
  EXPECT_TRUE(bytesOf(filter->GetOutput()) == expected);
}

#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
namespace
{
/// Bytes that the program holds on the heap and in large blocks beside it.
std::size_t heldByProgram()
{
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}
}

TEST(Reuse, KeepsWorkingMemoryUpToTheLimit)
{
  const std::size_t count = 200000;
  auto cloud = makeCloud(latticePoints(count, 1000000));
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(cloud);
  filter->SetNumberOfThreads(1);
  const auto heldAfter = [&](vtkTypeInt64 limit)
  {
    filter->SetReuseLimit(limit);
    filter->Modified();
    filter->Update();
    filter->GetOutput()->Initialize(); // memory of the filter itself is left
    return heldByProgram();
  };
  const std::size_t none = heldAfter(0);
  const std::size_t kept = heldAfter(262144);
  EXPECT_GT(kept, none + 64 * count) << "two triangles of 32 bytes per point";
  EXPECT_LT(heldAfter(262144), kept + count) << "a second run holds more than the first";
  EXPECT_LT(heldAfter(1000), none + count) << "more than a limit of 1000 KiB is held";
  EXPECT_GT(heldAfter(262144), none + 64 * count);
  EXPECT_LT(heldAfter(0), none + count);
  for (vtkTypeInt64 limit = 4000; limit < 60000; limit += 2000)
  {
    EXPECT_LT(heldAfter(limit), none + std::size_t(limit) * 1024 + count) << limit;
  }
}

TEST(Reuse, NothingIsKeptOfAnAbortedExecution)
{
  const std::size_t count = 200000;
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(makeCloud(latticePoints(count, 1000000)));
  filter->SetNumberOfThreads(1);
  const std::size_t none = heldByProgram();
  filter->Update();
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(filter->GetOutput());
  EXPECT_GT(heldByProgram(), none + (64 + 32) * count)
    << "working memory and two triangles a point";
  vtkNew<ThreadWatch> watch;
  watch->AbortAt = 0.5;
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Modified();
  filter->Update();
  copy->Initialize();
  EXPECT_LT(heldByProgram(), none + count);
}

TEST(Reuse, OutputsWithinAMemoryLimitTakeNoLargerMemory)
{
  const std::size_t more = 200000, fewer = 170000;
  const auto larger = makeCloud(latticePoints(more, 1000000));
  const auto smaller = makeCloud(latticePoints(fewer, 1000000));
  vtkTypeInt64 estimate = 0;
  const auto heldWith = [&](vtkTypeInt64 limit)
  {
    const std::size_t before = heldByProgram();
    vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
    filter->SetNumberOfThreads(1);
    filter->SetInputData(larger);
    filter->Update();
    filter->GetOutput()->Initialize();
    filter->SetInputData(smaller);
    filter->SetMemoryLimit(limit);
    filter->Update();
    EXPECT_EQ(std::size_t(filter->GetNumberOfPointsInserted()), fewer);
    estimate = filter->GetMemoryEstimate();
    return heldByProgram() - before;
  };
  const std::size_t unlimited = heldWith(0);
  EXPECT_LT(heldWith(estimate), unlimited - 16 * (more - fewer));
}
#endif

TEST(Reuse, TheInputIsNotKept)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  auto cloud = makeCloud(latticePoints(kCount, 1000000));
  filter->SetInputData(cloud);
  filter->Update();
  vtkPoints* points = cloud->GetPoints();
  filter->GetOutput()->Initialize();
  filter->SetInputData(nullptr);
  EXPECT_EQ(points->GetReferenceCount(), 1);
}
