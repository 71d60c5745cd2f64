// SPDX-License-Identifier: BSD-3-Clause
//
// The blocks of a composite data set, merged into one point set.
#include "ContextSupport.h"
#include "FilterTestSupport.h"
#include "Input/vtkAHDBlocks.h"

#include "vtkAlgorithm.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

using namespace ahdtest;

namespace
{
vtkSmartPointer<vtkPolyData> merge(vtkCompositeDataSet* blocks)
{
  const Work work;
  return vtkAHDBlocks(blocks).Merge(work.Context);
}

template <typename Array>
void addArray(vtkPointSet* block, const char* name, const std::vector<double>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (double value : values)
  {
    array->InsertNextValue(static_cast<typename Array::ValueType>(value));
  }
  block->GetPointData()->AddArray(array);
}

/// Acts at the first event.
class AtFirst : public vtkCommand
{
public:
  static AtFirst* New() { return new AtFirst; }
  void Execute(vtkObject*, unsigned long, void*) override
  {
    if (this->Do)
    {
      this->Do();
      this->Do = nullptr;
    }
  }
  std::function<void()> Do;
};

std::vector<Xyz> pointsOf(vtkPointSet* set)
{
  std::vector<Xyz> points(static_cast<std::size_t>(set->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    set->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}

std::vector<double> valuesOf(vtkPointSet* set, const char* name)
{
  vtkDataArray* array = set->GetPointData()->GetArray(name);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}
}

/// Events come while blocks are merged: the blocks of the beginning are merged, whatever observers
/// do to them.
TEST(Blocks, AreHeldWhileTheyAreMerged)
{
  for (const bool isDisturbed : { false, true })
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (unsigned b = 0; b < 5; ++b)
    {
      auto cloud = makeCloud({ { double(b), 1, 2 }, { double(b), 3, 4 } });
      addArray<vtkDoubleArray>(cloud, "a", { 10.0 * b, 10.0 * b + 1 });
      blocks->SetBlock(b, cloud);
    }
    vtkNew<vtkAlgorithm> filter;
    vtkNew<AtFirst> observer;
    observer->Do = [&blocks, isDisturbed]
    {
      for (unsigned b = 0; b < 5 && isDisturbed; ++b)
      {
        vtkPolyData::SafeDownCast(blocks->GetBlock(b))->Initialize();
        blocks->SetBlock(b, nullptr);
      }
    };
    filter->AddObserver(vtkCommand::ProgressEvent, observer);
    static double now = 0.0;
    vtkAHDProgress progress(filter, [] { return now += 1.0; }); // each time a report is due
    ahd::Threads threads(1);
    vtkAHDOutputMemory memory;
    const auto merged = vtkAHDBlocks(blocks).Merge(vtkAHDContext(progress, threads, memory));
    EXPECT_FALSE(observer->Do) << "it was not heard";
    ASSERT_EQ(merged->GetNumberOfPoints(), 10);
    EXPECT_EQ(pointsOf(merged)[9], (Xyz{ 4, 3, 4 }));
    EXPECT_EQ(valuesOf(merged, "a"), (std::vector<double>{ 0, 1, 10, 11, 20, 21, 30, 31, 40, 41 }));
  }
}

TEST(Blocks, PointsFollowEachOtherInTheOrderOfTheBlocks)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, makeCloud({ { 2, 0, 0 }, { 3, 0, 0 } }));
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(makePoints({ { 4, 5, 6 } }));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeCloud({ { 0.1, 0, 0 }, { 1, 0, 0 } }));
  blocks->SetBlock(2, inner);
  blocks->SetBlock(3, grid);
  const auto merged = merge(blocks);
  EXPECT_EQ(pointsOf(merged),
    (std::vector<Xyz>{ { 0.1, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 5, 6 } }));
  EXPECT_EQ(merged->GetNumberOfCells(), 0);
  EXPECT_EQ(vtkAHDBlocks(blocks).GetCount(), 5);
  EXPECT_EQ(vtkAHDBlocks(blocks).GetNumberOfOthers(), 0);
}

TEST(Blocks, PartitionsAreBlocks)
{
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, makeCloud({ { 0, 0, 0 } }));
  parts->SetPartition(1, makeCloud({ { 1, 0, 0 } }));
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, parts);
  EXPECT_EQ(pointsOf(merge(collection)), (std::vector<Xyz>{ { 0, 0, 0 }, { 1, 0, 0 } }));
}

TEST(Blocks, WhatHasNoPointsIsPassedOver)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkPolyData>());
  blocks->SetBlock(1, vtkNew<vtkImageData>());
  auto cloud = makeCloud({ { 1, 2, 3 } });
  addArray<vtkDoubleArray>(cloud, "depth", { 7 });
  blocks->SetBlock(2, cloud);
  blocks->SetBlock(3, vtkNew<vtkImageData>());
  const vtkAHDBlocks seen(blocks);
  EXPECT_EQ(seen.GetNumberOfOthers(), 2);
  EXPECT_EQ(seen.GetFirstOther(), "vtkImageData");
  const auto merged = merge(blocks);
  EXPECT_EQ(pointsOf(merged), (std::vector<Xyz>{ { 1, 2, 3 } }));
  EXPECT_EQ(valuesOf(merged, "depth"), std::vector<double>{ 7 }) << "an empty block has no say";
}

TEST(Blocks, NoneAtAllIsNoPoint)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  EXPECT_EQ(merge(blocks)->GetNumberOfPoints(), 0);
}

TEST(Blocks, FloatsStayFloatsWhereAllAre)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeCloud({ { 0.1, 0, 0 } }, VTK_FLOAT));
  blocks->SetBlock(1, makeCloud({ { 0.2, 0, 0 } }, VTK_FLOAT));
  EXPECT_EQ(merge(blocks)->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(pointsOf(merge(blocks))[1][0], double(0.2f));
  blocks->SetBlock(2, makeCloud({ { 0.2, 0, 0 } }));
  EXPECT_EQ(merge(blocks)->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(pointsOf(merge(blocks))[1][0], double(0.2f));
  EXPECT_EQ(pointsOf(merge(blocks))[2][0], 0.2);
  vtkNew<vtkMultiBlockDataSet> whole;
  whole->SetBlock(0, makeCloud({ { 2147483647, 0, 0 } }, VTK_INT));
  whole->SetBlock(1, makeCloud({ { 0.2, 0, 0 } }, VTK_FLOAT));
  EXPECT_EQ(pointsOf(merge(whole))[0][0], 2147483647);
}

TEST(Blocks, ArraysThatAllHaveArePassedOn)
{
  auto a = makeCloud({ { 0, 0, 0 }, { 1, 0, 0 } });
  auto b = makeCloud({ { 2, 0, 0 } });
  addArray<vtkDoubleArray>(a, "depth", { 1, 2 });
  addArray<vtkDoubleArray>(b, "depth", { 3 });
  addArray<vtkDoubleArray>(a, "only one has it", { 1, 2 });
  addArray<vtkIntArray>(a, "class", { 4, 5 });
  addArray<vtkIntArray>(b, "class", { 6 });
  addArray<vtkIntArray>(a, "type", { 4, 5 });
  addArray<vtkDoubleArray>(b, "type", { 6 });
  addArray<vtkDoubleArray>(a, "too long", { 1, 2, 3 });
  addArray<vtkDoubleArray>(b, "too long", { 3 });
  addArray<vtkDoubleArray>(a, "too short", { 1 });
  addArray<vtkDoubleArray>(b, "too short", { 3 });
  for (vtkPolyData* block : { a.Get(), b.Get() })
  {
    vtkNew<vtkStringArray> names;
    names->SetName("name");
    for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i)
    {
      names->InsertNextValue("p" + std::to_string(int(block->GetPoint(i)[0])));
    }
    block->GetPointData()->AddArray(names);
    block->GetPointData()->SetActiveScalars("depth");
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, a);
  blocks->SetBlock(1, b);
  const auto merged = merge(blocks);
  EXPECT_EQ(valuesOf(merged, "depth"), (std::vector<double>{ 1, 2, 3 }));
  EXPECT_EQ(valuesOf(merged, "class"), (std::vector<double>{ 4, 5, 6 }));
  EXPECT_NE(vtkIntArray::SafeDownCast(merged->GetPointData()->GetArray("class")), nullptr);
  auto* names = vtkStringArray::SafeDownCast(merged->GetPointData()->GetAbstractArray("name"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetValue(2), "p2");
  ASSERT_NE(merged->GetPointData()->GetScalars(), nullptr);
  EXPECT_STREQ(merged->GetPointData()->GetScalars()->GetName(), "depth");
  for (const char* other : { "only one has it", "type", "too long", "too short" })
  {
    EXPECT_EQ(merged->GetPointData()->GetAbstractArray(other), nullptr) << other;
  }
  EXPECT_EQ(merged->GetPointData()->GetNumberOfArrays(), 3);
}

TEST(Blocks, MarksOfOneBlockCountForItsPoints)
{
  auto a = makeCloud({ { 0, 0, 0 }, { 1, 0, 0 } });
  auto b = makeCloud({ { 2, 0, 0 }, { 3, 0, 0 } });
  auto c = makeCloud({ { 4, 0, 0 } });
  const char* name = vtkDataSetAttributes::GhostArrayName();
  addArray<vtkUnsignedCharArray>(b, name, { 0, vtkDataSetAttributes::DUPLICATEPOINT });
  addArray<vtkUnsignedCharArray>(c, name, { 1, 1, 1 }); // does not fit
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, a);
  blocks->SetBlock(1, b);
  blocks->SetBlock(2, c);
  EXPECT_EQ(valuesOf(merge(blocks), name), (std::vector<double>{ 0, 0, 0, 1, 0 }));
  EXPECT_EQ(a->GetPointData()->GetNumberOfArrays(), 0) << "the input was changed";
  blocks->SetBlock(1, nullptr);
  EXPECT_EQ(merge(blocks)->GetPointData()->GetNumberOfArrays(), 0);
}

TEST(Blocks, AnAbortIsHeard)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeCloud({ { 0.1, 0, 0 } }));
  const Work work;
  work.Filter->SetAbortExecute(1);
  EXPECT_THROW(vtkAHDBlocks(blocks).Merge(work.Context), vtkAHDStop);
}
