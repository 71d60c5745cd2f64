// SPDX-License-Identifier: BSD-3-Clause
//
// The memory of large output arrays, from those of one execution to those of the next.
#include "ContextSupport.h"
#include "FilterTestSupport.h"
#include "Pipeline/vtkAHDArray.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <thread>

using namespace ahdtest;

namespace
{
constexpr std::size_t kMiB = std::size_t(1) << 20;

/// Where the corners of its triangles lie.
const void* cornersOf(vtkAdaptiveHilbertDelaunay2D* filter)
{
  return filter->GetOutput()->GetPolys()->GetConnectivityArray()->GetVoidPointer(0);
}
}

TEST(ArrayMemory, WhatIsFreedWaitsOnlyBetweenOpenAndClose)
{
  vtkAHDArrayMemory memory;
  vtkAHDArrayMemory::Free(memory.Allocate(kMiB));
  EXPECT_EQ(memory.GetBytes(), 0u);
  memory.Open();
  vtkAHDArrayMemory::Free(memory.Allocate(kMiB));
  vtkAHDArrayMemory::Free(memory.Allocate(3 * kMiB));
  EXPECT_EQ(memory.GetBytes(), 3 * kMiB) << "the first made place for the second";
  memory.Close();
  EXPECT_EQ(memory.GetBytes(), 0u);
  vtkAHDArrayMemory::Free(memory.Allocate(kMiB));
  EXPECT_EQ(memory.GetBytes(), 0u);
}

TEST(ArrayMemory, GivesTheLeastThatFitsAndIsNotMuchTooLarge)
{
  vtkAHDArrayMemory memory;
  void* const blocks[] = { memory.Allocate(10 * kMiB), memory.Allocate(11 * kMiB),
    memory.Allocate(20 * kMiB) };
  memory.Open();
  for (void* block : blocks)
  {
    std::memset(block, 1, 10 * kMiB);
    vtkAHDArrayMemory::Free(block);
  }
  ASSERT_EQ(memory.GetBytes(), 41 * kMiB);
  void* const second = memory.Allocate(10 * kMiB + 100000);
  EXPECT_EQ(second, blocks[1]);
  void* const first = memory.Allocate(10 * kMiB + 1000);
  EXPECT_EQ(first, blocks[0]) << "a little more fits as well";
  EXPECT_EQ(memory.GetBytes(), 20 * kMiB);
  void* const other = memory.Allocate(5 * kMiB);
  EXPECT_NE(other, blocks[2]);
  EXPECT_EQ(memory.GetBytes(), 0u) << "it has to make place for what is new";
  memory.Close();
  for (void* block : { first, second, other })
  {
    vtkAHDArrayMemory::Free(block);
  }
}

TEST(ArrayMemory, ShrinksToWhatIsWanted)
{
  vtkAHDArrayMemory memory;
  void* const blocks[] = { memory.Allocate(kMiB), memory.Allocate(kMiB), memory.Allocate(kMiB) };
  memory.Open();
  for (void* block : blocks)
  {
    vtkAHDArrayMemory::Free(block);
  }
  memory.Shrink(3 * kMiB);
  EXPECT_EQ(memory.GetBytes(), 3 * kMiB);
  memory.Shrink(3 * kMiB - 1);
  EXPECT_EQ(memory.GetBytes(), 2 * kMiB);
  memory.Shrink(0);
  EXPECT_EQ(memory.GetBytes(), 0u);
}

TEST(ArrayMemory, ShrinksByTheLeastThatIsEnough)
{
  vtkAHDArrayMemory memory;
  void* const blocks[] = { memory.Allocate(4 * kMiB), memory.Allocate(2 * kMiB),
    memory.Allocate(3 * kMiB), memory.Allocate(8 * kMiB), memory.Allocate(kMiB) };
  memory.Open();
  for (void* block : blocks)
  {
    vtkAHDArrayMemory::Free(block);
  }
  memory.Shrink(16 * kMiB);
  EXPECT_EQ(memory.GetBytes(), 16 * kMiB) << "2 of 18 MiB go";
  memory.Shrink(6 * kMiB);
  EXPECT_EQ(memory.GetBytes(), 5 * kMiB) << "first the largest, 8, then 3 for 2";
}

TEST(ArrayMemory, ArraysMayOutliveItAndGrow)
{
  Work work;
  auto memory = std::make_unique<vtkAHDArrayMemory>();
  const vtkAHDContext context(work.Progress, work.Threads, memory.get());
  auto array = vtkAHDNewArray<vtkIntArray>(vtkIdType(kMiB), context);
  std::fill_n(array->GetPointer(0), kMiB, 7);
  auto few = vtkAHDNewArray<vtkIntArray>(10, context);
  memory->Open();
  few = nullptr;
  EXPECT_EQ(memory->GetBytes(), 0u) << "small ones do not wait";
  auto other = vtkAHDNewArray<vtkIntArray>(vtkIdType(kMiB), context);
  std::thread([&] { other = nullptr; }).join();
  EXPECT_EQ(memory->GetBytes(), 4 * kMiB);
  memory.reset();
  array->InsertNextValue(8); // moves
  EXPECT_EQ(array->GetValue(0), 7);
  EXPECT_EQ(array->GetValue(vtkIdType(kMiB)), 8);
}

TEST(ArrayMemory, OfAnExecutionIsThatOfTheOneBefore)
{
  constexpr std::size_t kPoints = 100000;
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(makeCloud(scatteredPoints(kPoints)));
  filter->GenerateNeighborsOn();
  filter->Update();
  const auto expected = trianglesOf(filter->GetOutput());
  const void* const first = cornersOf(filter);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(cornersOf(filter), first);
  EXPECT_EQ(trianglesOf(filter->GetOutput()), expected);
  // What somebody holds stays as it is.
  const vtkSmartPointer<vtkDataArray> held =
    filter->GetOutput()->GetPolys()->GetConnectivityArray();
  filter->SetInputData(makeCloud(scatteredPoints(kPoints, 2)));
  filter->Update();
  EXPECT_NE(cornersOf(filter), first);
  EXPECT_NE(trianglesOf(filter->GetOutput()), expected);
  std::vector<Triangle> stillThere;
  for (vtkIdType t = 0; t < held->GetNumberOfTuples() / 3; ++t)
  {
    stillThere.push_back({ { vtkIdType(held->GetTuple1(3 * t)),
      vtkIdType(held->GetTuple1(3 * t + 1)), vtkIdType(held->GetTuple1(3 * t + 2)) } });
  }
  EXPECT_EQ(stillThere, expected);
}
