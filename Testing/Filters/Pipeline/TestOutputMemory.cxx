// SPDX-License-Identifier: BSD-3-Clause
//
// The memory of output arrays, and of the triangulation, kept for those of the next execution.
#include "ContextSupport.h"
#include "Execution/vtkAHDExecution.h"
#include "FilterTestSupport.h"
#include "Pipeline/vtkAHDOutputMemory.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkTypeInt32Array.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <new>
#include <numeric>
#include <thread>
#include <utility>
#include <vector>

using namespace ahdtest;

namespace
{
constexpr std::size_t kPlenty = std::size_t(1) << 30;
constexpr vtkIdType kCount = 100000;
constexpr std::size_t kBytes = kCount * sizeof(double);

using Doubles = vtkSmartPointer<vtkDoubleArray>;

Doubles makeDoubles(vtkAHDOutputMemory& memory, vtkIdType count = kCount)
{
  Doubles array = memory.NewArray<vtkDoubleArray>(count);
  EXPECT_EQ(array->GetNumberOfValues(), count);
  std::iota(array->GetPointer(0), array->GetPointer(0) + count, 0.0);
  return array;
}
}

TEST(OutputMemory, CapacityIsASixteenthMoreAtMost)
{
  for (std::size_t bytes = 1024; bytes < kPlenty; bytes += bytes / 7 + 1)
  {
    EXPECT_GE(vtkAHDOutputMemory::GetCapacity(bytes), bytes);
    EXPECT_LE(vtkAHDOutputMemory::GetCapacity(bytes), bytes + bytes / 16) << bytes;
  }
  EXPECT_EQ(vtkAHDOutputMemory::GetCapacity(0), 64u);
  EXPECT_EQ(vtkAHDOutputMemory::GetCapacity(65), 128u);
}

TEST(OutputMemory, IsTakenAgainForAsMuchOrALittleMore)
{
  vtkAHDOutputMemory memory;
  memory.KeepAtMost(kPlenty);
  Doubles array = makeDoubles(memory);
  const void* const first = array->GetPointer(0);
  EXPECT_EQ(memory.GetBytes(), 0u);
  for (vtkIdType count : { kCount, kCount + kCount / 50, kCount - kCount / 10 })
  {
    array = nullptr;
    EXPECT_EQ(memory.GetBytes(), vtkAHDOutputMemory::GetCapacity(kBytes));
    array = makeDoubles(memory, count);
    EXPECT_EQ(array->GetPointer(0), first) << count;
    EXPECT_EQ(memory.GetBytes(), 0u);
  }
}

TEST(OutputMemory, TheSmallestThatIsEnoughIsTaken)
{
  vtkAHDOutputMemory memory;
  memory.KeepAtMost(kPlenty);
  Doubles arrays[] = { makeDoubles(memory, kCount + kCount / 4), makeDoubles(memory) };
  const void* const smaller = arrays[1]->GetPointer(0);
  arrays[0] = nullptr;
  arrays[1] = nullptr;
  arrays[0] = makeDoubles(memory);
  EXPECT_EQ(arrays[0]->GetPointer(0), smaller);
}

TEST(OutputMemory, IsNotTakenForMuchLessNorForMore)
{
  vtkAHDOutputMemory memory;
  memory.KeepAtMost(kPlenty);
  makeDoubles(memory);
  const std::size_t kept = memory.GetBytes();
  ASSERT_GT(kept, 0u);
  const Doubles less = makeDoubles(memory, kCount / 2);
  EXPECT_EQ(memory.GetBytes(), kept);
  const Doubles more = makeDoubles(memory, kCount + kCount / 10);
  EXPECT_EQ(memory.GetBytes(), kept);
}

TEST(OutputMemory, NoMoreIsKeptThanTheLimit)
{
  vtkAHDOutputMemory memory;
  makeDoubles(memory);
  EXPECT_EQ(memory.GetBytes(), 0u) << "before anybody said how much";
  memory.KeepAtMost(kBytes + kBytes / 2);
  Doubles arrays[] = { makeDoubles(memory), makeDoubles(memory) };
  arrays[0] = nullptr;
  arrays[1] = nullptr;
  EXPECT_EQ(memory.GetBytes(), vtkAHDOutputMemory::GetCapacity(kBytes));
  memory.KeepAtMost(kBytes / 2);
  EXPECT_EQ(memory.GetBytes(), 0u);
  makeDoubles(memory);
  EXPECT_EQ(memory.GetBytes(), 0u);
  memory.KeepAtMost(kPlenty);
  makeDoubles(memory, 100);
  EXPECT_EQ(memory.GetBytes(), 0u) << "small arrays are not kept";
  makeDoubles(memory);
  EXPECT_GT(memory.GetBytes(), 0u);
  memory.Release();
  EXPECT_EQ(memory.GetBytes(), 0u);
}

TEST(OutputMemory, ArraysOutliveIt)
{
  Doubles array;
  {
    vtkAHDOutputMemory memory;
    memory.KeepAtMost(kPlenty);
    array = makeDoubles(memory);
  }
  EXPECT_EQ(array->GetValue(kCount - 1), double(kCount - 1));
}

TEST(OutputMemory, AnArrayThatGrowsLetsGoOfIt)
{
  vtkAHDOutputMemory memory;
  memory.KeepAtMost(kPlenty);
  const Doubles array = makeDoubles(memory);
  array->InsertNextValue(7.0);
  EXPECT_EQ(memory.GetBytes(), vtkAHDOutputMemory::GetCapacity(kBytes));
  EXPECT_EQ(array->GetValue(kCount - 1), double(kCount - 1));
  EXPECT_EQ(array->GetValue(kCount), 7.0);
}

TEST(OutputMemory, BuffersBecomeArrays)
{
  vtkAHDOutputMemory memory;
  memory.KeepAtMost(kPlenty);
  ahd::Buffer<std::int32_t> buffer = memory.Take<std::int32_t>(kCount);
  ASSERT_GE(buffer.size(), std::size_t(kCount));
  const void* const first = buffer.data();
  buffer.allocate(kCount - 5); // like a function that fills it
  EXPECT_EQ(buffer.data(), first);
  std::iota(buffer.begin(), buffer.end(), 1);
  auto array = memory.MakeArray<vtkTypeInt32Array>(buffer, kCount - 5);
  EXPECT_TRUE(buffer.empty());
  EXPECT_EQ(array->GetPointer(0), first);
  EXPECT_EQ(array->GetValue(kCount - 6), kCount - 5);
  array = nullptr;
  EXPECT_EQ(memory.Take<std::int32_t>(kCount).data(), first);
  EXPECT_EQ(memory.GetBytes(), 0u) << "a buffer that becomes no array gives its memory back";
}

TEST(OutputMemory, AnyThreadLetsGo)
{
  vtkAHDOutputMemory memory;
  memory.KeepAtMost(8 * kBytes);
  for (int round = 0; round < 50; ++round)
  {
    std::vector<Doubles> arrays;
    for (int i = 0; i < 4; ++i)
    {
      arrays.push_back(makeDoubles(memory, 10000));
    }
    std::vector<std::thread> threads;
    for (Doubles& array : arrays)
    {
      threads.emplace_back(
        [&array]
        {
          EXPECT_EQ(array->GetValue(9999), 9999.0);
          array = nullptr;
        });
    }
    makeDoubles(memory, 10000);
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }
  EXPECT_EQ(memory.GetBytes() % vtkAHDOutputMemory::GetCapacity(80000), 0u);
  EXPECT_GE(memory.GetBytes(), 4 * vtkAHDOutputMemory::GetCapacity(80000));
}

namespace
{
std::vector<const void*> memoryOf(vtkPolyData* surface)
{
  std::vector<const void*> all;
  for (vtkDataArray* array : { surface->GetPolys()->GetConnectivityArray(),
         surface->GetPolys()->GetOffsetsArray(), surface->GetCellData()->GetArray("Neighbors") })
  {
    all.push_back(array->GetVoidPointer(0));
  }
  return all;
}

std::vector<vtkIdType> neighborsOf(vtkPolyData* surface)
{
  auto* array = vtkIdTypeArray::SafeDownCast(surface->GetCellData()->GetArray("Neighbors"));
  return { array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues() };
}

vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D> runOnce(std::size_t count)
{
  auto filter = vtkSmartPointer<vtkAdaptiveHilbertDelaunay2D>::New();
  filter->SetInputData(makeCloud(latticePoints(count, 1000000)));
  filter->GenerateNeighborsOn();
  filter->KeepTriangulationOff();
  filter->Update();
  return filter;
}

void runAgain(vtkAdaptiveHilbertDelaunay2D* filter)
{
  filter->Modified();
  filter->Update();
}
}

TEST(OutputMemory, TheNextExecutionWritesWhereTheLastOneDid)
{
  const auto filter = runOnce(50000);
  const std::vector<const void*> first = memoryOf(filter->GetOutput());
  const std::vector<vtkIdType> expected = neighborsOf(filter->GetOutput());
  runAgain(filter);
  EXPECT_EQ(memoryOf(filter->GetOutput()), first);
  EXPECT_EQ(neighborsOf(filter->GetOutput()), expected);
}

TEST(OutputMemory, WhatIsInUseIsLeftAlone)
{
  auto filter = runOnce(50000);
  const std::vector<vtkIdType> expected = neighborsOf(filter->GetOutput());
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(filter->GetOutput());
  const std::vector<const void*> first = memoryOf(copy);
  filter->SetInputData(makeCloud(latticePoints(50000, 999983)));
  runAgain(filter);
  const std::vector<const void*> second = memoryOf(filter->GetOutput());
  for (const void* memory : second)
  {
    EXPECT_EQ(std::count(first.begin(), first.end(), memory), 0);
  }
  EXPECT_EQ(neighborsOf(copy), expected);
  filter = nullptr; // the copy has its arrays for itself then
  EXPECT_EQ(neighborsOf(copy), expected);
}

namespace
{
/// One execution with working memory of its own, which it may lend.
struct Executed
{
  Executed(const vtkAHDSettings& settings, vtkPointSet* cloud, const Work& work)
    : Input(settings, cloud, nullptr)
    , Report(vtkAHDExecution(settings, this->Input, this->Workspace, work.Context, 0)
               .Run({ this->Surface, this->Order, this->Diagram }, &this->Lent))
  {
  }

  vtkAHDInput Input;
  ahd::Workspace Workspace;
  vtkNew<vtkPolyData> Surface, Order, Diagram;
  vtkAHDExecution::LentPointer Lent;
  vtkAHDReport Report;
};
}

/// To the last whole KiB, which is what the limit counts in.
TEST(WorkingMemory, NoMoreIsKeptThanTheLimit)
{
  auto cloud = makeCloud(latticePoints(5000, 1000000));
  const Work work(1);
  const auto bytesWith = [&](vtkTypeInt64 limit)
  {
    vtkAHDSettings settings;
    settings.ReuseLimit = limit;
    vtkAHDInput input(settings, cloud, nullptr);
    ahd::Workspace workspace;
    vtkNew<vtkPolyData> surface, order, diagram;
    const auto report =
      vtkAHDExecution(settings, input, workspace, work.Context, 0).Run({ surface, order, diagram });
    EXPECT_EQ(report.status, ahd::Status::Ok);
    EXPECT_GT(surface->GetNumberOfPolys(), 9000);
    return workspace.bytes();
  };
  const std::size_t bytes = bytesWith(VTK_INT_MAX);
  EXPECT_GT(bytes, 5000 * 12u);
  const auto held = static_cast<vtkTypeInt64>((bytes + 1023) / 1024);
  EXPECT_EQ(bytesWith(held), bytes);
  EXPECT_EQ(bytesWith(held - 1), 0u);
}

/// What an observer has written to is not lent, and its memory is for the next execution; whether
/// the surface shows these points or, with means, its own.
TEST(WorkingMemory, IsKeptWhereNothingIsLent)
{
  for (const int variant : { 0, 1, 2, 3 })
  {
    SCOPED_TRACE(variant);
    const bool writes = variant % 2 == 1;
    auto xyz = latticePoints(5000, 1000000);
    xyz.push_back(xyz[0]);
    xyz.back()[2] = 4.0;
    auto cloud = makeCloud(xyz);
    const Work work(1);
    vtkNew<vtkCallbackCommand> observer;
    observer->SetClientData(writes ? cloud.Get() : nullptr);
    observer->SetCallback(
      [](vtkObject*, unsigned long, void* data, void*)
      {
        if (data)
        {
          static_cast<vtkPolyData*>(data)->GetPoints()->GetData()->SetComponent(7, 2, 1.0);
        }
      });
    work.Filter->AddObserver(vtkCommand::ProgressEvent, observer);
    vtkAHDSettings settings;
    settings.ReuseLimit = VTK_INT_MAX;
    settings.showsMeans = variant / 2 == 1;
    const Executed made(settings, cloud, work);
    EXPECT_EQ(made.Report.status, ahd::Status::Ok);
    EXPECT_EQ(made.Surface->GetPoints()->GetPoint(0)[2], settings.showsMeans ? 2.0 : 0.0);
    EXPECT_EQ(made.Lent != nullptr, !writes);
    EXPECT_EQ(made.Workspace.bytes() > 0, writes);
  }
}

/// Nor is a triangulation lent whose places go with the input, or that takes more than the limit.
TEST(WorkingMemory, IsKeptWhereNothingMayBeLent)
{
  const auto run = [](const vtkAHDSettings& settings, int type)
  {
    auto cloud = makeCloud(latticePoints(5000, 1000000), type);
    const Work work(1);
    const Executed made(settings, cloud, work);
    EXPECT_EQ(made.Report.status, ahd::Status::Ok);
    EXPECT_EQ(made.Workspace.bytes() > 0, made.Lent == nullptr);
    return std::pair<std::size_t, std::size_t>(made.Workspace.bytes(), made.Report.keptEstimate);
  };
  vtkAHDSettings plain, projected, copied;
  plain.ReuseLimit = projected.ReuseLimit = copied.ReuseLimit = VTK_INT_MAX;
  projected.plane = ahd::PlaneKind::BestFit;
  copied.CopiesKept = true;
  const auto [none, lent] = run(plain, VTK_DOUBLE);
  EXPECT_EQ(none, 0u);
  const std::size_t bytes = run(plain, VTK_INT).first;
  EXPECT_GT(bytes, 5000 * 12u);
  EXPECT_GT(lent, bytes) << "tables are lent, too";
  EXPECT_GT(run(projected, VTK_DOUBLE).first, 0u);
  EXPECT_GT(run(copied, VTK_DOUBLE).first, 0u);
  plain.ReuseLimit = static_cast<vtkTypeInt64>(lent / 1024);
  EXPECT_EQ(run(plain, VTK_DOUBLE).first, bytes);
  ++plain.ReuseLimit;
  EXPECT_EQ(run(plain, VTK_DOUBLE).first, 0u);
}

namespace
{
/// Has no memory for its numbers when it is asked so often, as arrays of other layouts may.
class Failing : public vtkDoubleArray
{
public:
  static Failing* New() { VTK_STANDARD_NEW_BODY(Failing); }
  vtkTypeMacro(Failing, vtkDoubleArray);
  void* GetVoidPointer(vtkIdType value) override
  {
    if (++this->Asked == this->FailAt)
    {
      throw std::bad_alloc();
    }
    return this->Superclass::GetVoidPointer(value);
  }
  int Asked = 0;
  int FailAt = 0; ///< 0: never
};
}

/// A triangulation that cannot be lent for want of memory is for the next execution.
TEST(WorkingMemory, IsKeptWhereThereIsNoMemoryToLend)
{
  vtkNew<Failing> numbers;
  auto cloud = makeCloud(latticePoints(5000, 1000000));
  numbers->DeepCopy(cloud->GetPoints()->GetData());
  cloud->GetPoints()->SetData(numbers);
  int all = 0, notLent = 0;
  for (int k = 0; k <= all; ++k)
  {
    SCOPED_TRACE(k);
    const Work work(1);
    vtkAHDSettings settings;
    settings.ReuseLimit = VTK_INT_MAX;
    numbers->Asked = 0;
    numbers->FailAt = k;
    const Executed made(settings, cloud, work);
    numbers->FailAt = 0;
    all = k == 0 ? numbers->Asked : all;
    const bool isOk = made.Report.status == ahd::Status::Ok;
    EXPECT_TRUE(isOk || (k > 0 && made.Report.status == ahd::Status::OutOfMemory));
    EXPECT_EQ(made.Surface->GetNumberOfPolys() > 0, isOk);
    EXPECT_EQ(made.Workspace.bytes() > 0, isOk && made.Lent == nullptr);
    notLent += isOk && made.Lent == nullptr ? 1 : 0;
  }
  EXPECT_GT(notLent, 0);
}

/// What is lent has its part of the limit: of the outputs only the rest is kept.
TEST(WorkingMemory, WithWhatIsLentNoMoreIsKeptThanTheLimit)
{
  auto cloud = makeCloud(latticePoints(20000, 1000000));
  const auto run = [&cloud](vtkTypeInt64 limit)
  {
    const Work work(1);
    vtkAHDSettings settings;
    settings.ReuseLimit = limit;
    vtkAHDInput input(settings, cloud, nullptr);
    ahd::Workspace workspace;
    vtkAHDExecution::LentPointer lent;
    vtkAHDReport report;
    {
      vtkNew<vtkPolyData> surface, order, diagram;
      report = vtkAHDExecution(settings, input, workspace, work.Context, 0)
                 .Run({ surface, order, diagram }, &lent);
    }
    EXPECT_EQ(report.status, ahd::Status::Ok);
    EXPECT_NE(lent, nullptr);
    EXPECT_EQ(workspace.bytes(), 0u);
    return std::pair<std::size_t, std::size_t>(report.keptEstimate, work.Memory.GetBytes());
  };
  const auto [lent, outputs] = run(VTK_INT_MAX);
  EXPECT_GT(outputs, std::size_t(20000 * 2 * 3 * 4));
  const std::size_t limit = (lent + outputs / 2) / 1024;
  const std::size_t kept = run(static_cast<vtkTypeInt64>(limit)).second;
  EXPECT_GT(kept, 0u);
  EXPECT_LE(kept + lent, 1024 * limit);
}

/// Points, offsets and corners of a Voronoi diagram lie where those of the last one did.
TEST(OutputMemory, OfTheDiagramIsTakenAgain)
{
  auto cloud = makeCloud(latticePoints(30000, 1000000));
  const Work work(1);
  vtkAHDSettings settings;
  settings.ReuseLimit = VTK_INT_MAX;
  settings.voronoi = true;
  ahd::Workspace workspace;
  const auto run = [&]
  {
    vtkAHDInput input(settings, cloud, nullptr);
    vtkNew<vtkPolyData> surface, order, diagram;
    vtkAHDExecution(settings, input, workspace, work.Context, 0).Run({ surface, order, diagram });
    EXPECT_EQ(diagram->GetNumberOfPolys(), 30000);
    vtkCellArray* const cells = diagram->GetPolys();
    return std::vector<const void*>{ diagram->GetPoints()->GetVoidPointer(0),
      cells->GetOffsetsArray()->GetVoidPointer(0),
      cells->GetConnectivityArray()->GetVoidPointer(0) };
  };
  const std::vector<const void*> first = run();
  EXPECT_EQ(run(), first);
}
