// SPDX-License-Identifier: BSD-3-Clause
//
// Point arrays as users have them: of a wrong length, of strings, variants and bits, without a
// name, with a name twice, with the names of the filter's own. Each has its documented result.
#include "BadDataSupport.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariantArray.h"

#include <cmath>

using namespace ahdtest;

namespace
{
const std::vector<Xyz> kSquare = { { 0, 0, 1 }, { 4, 0, 2 }, { 4, 4, 3 }, { 0, 4, 4 } };

/// An array of `count` values: 0, 1, 2, ... as far as the type can represent them.
template <typename Array>
vtkSmartPointer<Array> makeArray(const char* name, vtkIdType count)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->SetVariantValue(i, vtkVariant(static_cast<int>(i)));
  }
  return array;
}

/// The value as a number, whatever the array holds.
int valueOf(vtkAbstractArray* array, vtkIdType i)
{
  auto* numbers = vtkArrayDownCast<vtkDataArray>(array); // bits are no variants
  return numbers ? static_cast<int>(numbers->GetComponent(i, 0))
                 : array->GetVariantValue(i).ToInt();
}

/// All four kinds, of the given length.
std::vector<vtkSmartPointer<vtkAbstractArray>> makeArrays(vtkIdType count)
{
  return { makeArray<vtkDoubleArray>("numbers", count), makeArray<vtkStringArray>("texts", count),
    makeArray<vtkVariantArray>("variants", count), makeArray<vtkBitArray>("bits", count) };
}

vtkSmartPointer<vtkPolyData> makeSquareWith(
  const std::vector<vtkSmartPointer<vtkAbstractArray>>& arrays)
{
  auto cloud = makeCloud(kSquare);
  for (const auto& array : arrays)
  {
    cloud->GetPointData()->AddArray(array);
  }
  return cloud;
}

/// Adds two points of a source that has none of the arrays, and one where its lines cross.
void addPoints(WatchedFilter& filter)
{
  filter->SetSourceData(
    makeSource({ { 0, 1 }, { 2, 3 } }, {}, { { 0, 2, 1 }, { 4, 2, 1 }, { 2, 0, 1 }, { 2, 4, 1 } }));
  filter->SetSourceModeToCoordinates();
  filter->SetCrossingModeToSplit();
}
}

TEST(BadDataArrays, OfAnyLengthArePassedOnAsTheyAre)
{
  for (vtkIdType length : { 0, 1, 3, 4, 5, 1000 })
  {
    SCOPED_TRACE(length);
    const auto arrays = makeArrays(length);
    WatchedFilter filter;
    filter->SetInputData(makeSquareWith(arrays));
    filter->GenerateFateOn();
    filter->Update();
    expectWarnings(filter, 0);
    EXPECT_EQ(trianglesOf(filter->GetOutput()), triangulate(kSquare));
    for (const auto& array : arrays)
    {
      EXPECT_EQ(filter->GetOutput()->GetPointData()->GetAbstractArray(array->GetName()), array);
    }
  }
}

TEST(BadDataArrays, OfAnyLengthHaveAValueForEachPointWherePointsAreAdded)
{
  for (vtkIdType length : { 0, 1, 3, 4, 5, 1000 })
  {
    SCOPED_TRACE(length);
    const auto arrays = makeArrays(length);
    WatchedFilter filter;
    filter->SetInputData(makeSquareWith(arrays));
    addPoints(filter);
    filter->Update();
    expectWarnings(filter, 0);
    const vtkIdType count = 4 + 4 + 1;
    ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), count);
    vtkPointData* data = filter->GetOutput()->GetPointData();
    EXPECT_EQ(data->GetNumberOfArrays(), 4);
    for (const auto& array : arrays)
    {
      vtkAbstractArray* made = data->GetAbstractArray(array->GetName());
      ASSERT_NE(made, nullptr);
      EXPECT_NE(made, array);
      EXPECT_EQ(made->GetDataType(), array->GetDataType());
      ASSERT_EQ(made->GetNumberOfTuples(), count) << array->GetName();
      EXPECT_EQ(array->GetNumberOfTuples(), length) << "the input was changed";
      for (vtkIdType i = 0; i < std::min<vtkIdType>(length, 4); ++i)
      {
        EXPECT_EQ(valueOf(made, i), valueOf(array, i)) << array->GetName();
      }
    }
    for (vtkIdType i = std::min<vtkIdType>(length, 4); i < count; ++i)
    {
      EXPECT_TRUE(std::isnan(data->GetArray("numbers")->GetComponent(i, 0))) << i;
      EXPECT_EQ(data->GetAbstractArray("texts")->GetVariantValue(i).ToString(), "") << i;
      EXPECT_FALSE(data->GetAbstractArray("variants")->GetVariantValue(i).IsValid()) << i;
      EXPECT_EQ(data->GetArray("bits")->GetComponent(i, 0), 0.0) << i;
    }
  }
}

TEST(BadDataArrays, OfTheSourceThatAreTooShortLeaveTheRestWithout)
{
  auto source = makeSource({ { 0, 1 } }, {}, { { 1, 1, 1 }, { 2, 1, 1 }, { 3, 1, 1 } });
  source->GetPointData()->AddArray(makeArray<vtkIntArray>("numbers", 1));
  source->GetPointData()->AddArray(makeArray<vtkDoubleArray>("texts", 3)); // of another kind
  source->GetPointData()->AddArray(makeArray<vtkStringArray>("bits", 3));
  source->GetPointData()->AddArray(makeArray<vtkVariantArray>("variants", 1000));
  WatchedFilter filter;
  filter->SetInputData(makeSquareWith(makeArrays(4)));
  filter->SetSourceData(source);
  filter->SetSourceModeToCoordinates();
  filter->Update();
  expectWarnings(filter, 0);
  vtkPointData* data = filter->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetArray("numbers")->GetComponent(4, 0), 0.0);
  EXPECT_TRUE(std::isnan(data->GetArray("numbers")->GetComponent(5, 0)));
  EXPECT_EQ(data->GetAbstractArray("texts")->GetVariantValue(5).ToString(), "");
  EXPECT_EQ(data->GetArray("bits")->GetComponent(5, 0), 0.0);
  EXPECT_EQ(data->GetAbstractArray("variants")->GetVariantValue(6).ToInt(), 2);
  EXPECT_EQ(data->GetAbstractArray("variants")->GetNumberOfTuples(), 7);
}

TEST(BadDataArrays, OfStringsVariantsAndBitsAreMerged)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeSquareWith(makeArrays(4)));
  auto other = makeCloud({ { 9, 9, 9 }, { 8, 1, 0 } });
  for (const auto& array : makeArrays(2))
  {
    other->GetPointData()->AddArray(array);
  }
  blocks->SetBlock(1, other);
  WatchedFilter filter;
  filter->MergeBlocksOn();
  filter->SetInputDataObject(blocks);
  filter->Update();
  expectWarnings(filter, 0);
  vtkPointData* data = filter->GetOutput()->GetPointData();
  ASSERT_EQ(data->GetNumberOfArrays(), 4);
  for (const char* name : { "numbers", "texts", "variants", "bits" })
  {
    ASSERT_EQ(data->GetAbstractArray(name)->GetNumberOfTuples(), 6) << name;
    EXPECT_EQ(valueOf(data->GetAbstractArray(name), 1), 1) << name;
    EXPECT_EQ(valueOf(data->GetAbstractArray(name), 4), 0) << name;
    EXPECT_EQ(valueOf(data->GetAbstractArray(name), 5), 1) << name;
  }
}

TEST(BadDataArrays, AreInTheVoronoiDiagramIfThereIsAValueForEachPoint)
{
  for (vtkIdType length : { 0, 3, 4, 1000 })
  {
    SCOPED_TRACE(length);
    WatchedFilter filter;
    filter->SetInputData(makeSquareWith(makeArrays(length)));
    filter->GenerateVoronoiOn();
    filter->Update();
    expectWarnings(filter, 0);
    vtkCellData* data = filter->GetOutput(2)->GetCellData();
    ASSERT_EQ(filter->GetOutput(2)->GetNumberOfCells(), 4);
    EXPECT_EQ(data->GetNumberOfArrays(), length < 4 ? 1 : 5);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      EXPECT_EQ(data->GetAbstractArray(i)->GetNumberOfTuples(), 4) << data->GetArrayName(i);
      EXPECT_EQ(valueOf(data->GetAbstractArray(i), 0), 0) << data->GetArrayName(i);
      EXPECT_EQ(valueOf(data->GetAbstractArray(i), 1), 1) << data->GetArrayName(i);
    }
  }
}

TEST(BadDataArrays, WithoutANameArePassedOnToo)
{
  for (bool added : { false, true })
  {
    for (bool merged : { false, true })
    {
      SCOPED_TRACE(std::string(added ? "added " : "") + (merged ? "merged" : ""));
      auto cloud = makeCloud(kSquare);
      cloud->GetPointData()->AddArray(makeArray<vtkDoubleArray>(nullptr, 4));
      cloud->GetPointData()->AddArray(makeArray<vtkIntArray>(nullptr, 4));
      cloud->GetPointData()->AddArray(makeArray<vtkIntArray>("numbers", 4));
      WatchedFilter filter;
      filter->SetInputData(cloud);
      vtkNew<vtkMultiBlockDataSet> blocks;
      blocks->SetBlock(0, cloud);
      if (merged)
      {
        filter->MergeBlocksOn();
        filter->SetInputDataObject(blocks);
      }
      if (added)
      {
        addPoints(filter);
      }
      filter->GenerateVoronoiOn();
      filter->Update();
      expectWarnings(filter, 0);
      vtkPolyData* surface = filter->GetOutput();
      EXPECT_EQ(surface->GetPointData()->GetNumberOfArrays(), 3);
      for (int i = 0; i < surface->GetPointData()->GetNumberOfArrays(); ++i)
      {
        EXPECT_EQ(surface->GetPointData()->GetAbstractArray(i)->GetNumberOfTuples(),
          surface->GetNumberOfPoints());
        EXPECT_EQ(surface->GetPointData()->GetArray(i)->GetComponent(2, 0), 2.0);
      }
    }
  }
}

TEST(BadDataArrays, OfTwoWithOneNameTheLastCounts)
{
  // VTK adds none under an existing name, but an array can be renamed afterwards.
  auto cloud = makeCloud(kSquare);
  cloud->GetPointData()->AddArray(makeArray<vtkStringArray>("first", 4));
  cloud->GetPointData()->AddArray(makeArray<vtkDoubleArray>("second", 4));
  cloud->GetPointData()->AddArray(makeArray<vtkIntArray>("third", 4));
  cloud->GetPointData()->GetAbstractArray(1)->SetName("first");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud);
  for (int way = 0; way < 3; ++way) // as they are, with points added, merged
  {
    SCOPED_TRACE(way);
    WatchedFilter filter;
    filter->SetMergeBlocks(way == 2);
    filter->SetInputDataObject(way == 2 ? static_cast<vtkDataObject*>(blocks) : cloud);
    filter->GenerateVoronoiOn();
    if (way == 1)
    {
      addPoints(filter);
    }
    filter->Update();
    expectWarnings(filter, 0);
    const vtkIdType count = filter->GetOutput()->GetNumberOfPoints();
    vtkPointData* points = filter->GetOutput()->GetPointData();
    vtkCellData* cells = filter->GetOutput(2)->GetCellData();
    for (vtkDataSetAttributes* data :
      { static_cast<vtkDataSetAttributes*>(points), static_cast<vtkDataSetAttributes*>(cells) })
    {
      EXPECT_EQ(data->GetNumberOfArrays(), data == points ? 2 : 3);
      ASSERT_NE(vtkDoubleArray::SafeDownCast(data->GetAbstractArray("first")), nullptr);
      ASSERT_NE(vtkIntArray::SafeDownCast(data->GetAbstractArray("third")), nullptr);
      for (const char* name : { "first", "third" })
      {
        EXPECT_EQ(data->GetArray(name)->GetNumberOfTuples(), count) << name;
        EXPECT_EQ(data->GetArray(name)->GetComponent(3, 0), 3.0) << name;
      }
    }
  }
}

TEST(BadDataArrays, WithTheNamesOfTheFiltersAreReplacedWhereItMakesThem)
{
  auto cloud = makeCloud(kSquare);
  const char* names[] = { "Fate", "InsertionRank", "OriginalPointIds" };
  for (const char* name : names)
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetName(name);
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(4);
    normals->Fill(0.5);
    cloud->GetPointData()->AddArray(normals);
  }
  cloud->GetFieldData()->AddArray(makeArray<vtkStringArray>("NumberOfTriangles", 7));
  const int attributes[] = { vtkDataSetAttributes::NORMALS, vtkDataSetAttributes::VECTORS,
    vtkDataSetAttributes::NORMALS };
  for (int k = 0; k < 3; ++k)
  {
    SCOPED_TRACE(names[k]);
    cloud->GetPointData()->SetActiveAttribute(names[k], attributes[k]);
    WatchedFilter filter;
    filter->SetInputData(cloud);
    filter->GenerateFateOn();
    filter->GenerateInsertionRankOn();
    filter->GenerateVoronoiOn();
    for (int step = 0; step < 3; ++step) // the last one is passed on as kept
    {
      cloud->Modified();
      filter->Update();
      expectWarnings(filter, 0);
      vtkPointData* data = filter->GetOutput()->GetPointData();
      EXPECT_EQ(data->GetNumberOfArrays(), 3);
      EXPECT_EQ(idsOf(data, "Fate"), (std::vector<vtkIdType>{ 0, 1, 2, 3 }));
      EXPECT_EQ(idsOf(data, "InsertionRank").size(), 4u);
      EXPECT_EQ(data->GetArray("OriginalPointIds"), cloud->GetPointData()->GetArray(names[2]));
      // users of normals assume three components
      vtkDataArray* active = vtkArrayDownCast<vtkDataArray>(
        data->GetAbstractAttribute(attributes[k]));
      EXPECT_TRUE(!active || active->GetNumberOfComponents() == 3);
      EXPECT_EQ(
        filter->GetOutput()->GetFieldData()->GetArray("NumberOfTriangles")->GetComponent(0, 0), 2);

      vtkCellData* cells = filter->GetOutput(2)->GetCellData();
      EXPECT_EQ(idsOf(cells, "OriginalPointIds").size(), 4u);
      active = vtkArrayDownCast<vtkDataArray>(cells->GetAbstractAttribute(attributes[k]));
      EXPECT_TRUE(!active || active->GetNumberOfComponents() == 3);
    }
    EXPECT_EQ(cloud->GetPointData()->GetArray("Fate")->GetNumberOfComponents(), 3);
    EXPECT_EQ(cloud->GetFieldData()->GetAbstractArray("NumberOfTriangles")->GetNumberOfTuples(), 7);
  }
}

TEST(BadDataArrays, WithTheNamesOfTheFiltersStayWhereItMakesNone)
{
  auto cloud = makeSquareWith({ makeArray<vtkDoubleArray>("Fate", 4) });
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->Update();
  EXPECT_EQ(
    filter->GetOutput()->GetPointData()->GetArray("Fate"), cloud->GetPointData()->GetArray("Fate"));
}

TEST(BadDataArrays, CrossingsOfAFilterBeforeAreNotThoseOfThisOne)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> before;
  before->SetInputData(makeCloud(kSquare));
  before->SetSourceData(makeSource({ { 0, 2 }, { 1, 3 } }, {}));
  WatchedFilter filter;
  filter->SetInputConnection(before->GetOutputPort());
  for (int step = 0; step < 3; ++step)
  {
    before->Modified();
    filter->Update();
    ASSERT_EQ(idsOf(before->GetOutput()->GetFieldData(), "Crossings").size(), 2u);
    EXPECT_EQ(filter->GetNumberOfCrossings(), 0);
    EXPECT_FALSE(filter->GetOutput()->GetFieldData()->HasArray("Crossings"));
  }
}

TEST(BadDataArrays, MarksThatAreNoBytesAreIgnoredAndTold)
{
  for (bool merged : { false, true })
  {
    auto marks = makeArray<vtkIntArray>(vtkDataSetAttributes::GhostArrayName(), 4);
    marks->FillValue(vtkDataSetAttributes::HIDDENPOINT);
    auto cloud = makeSquareWith({ marks });
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, cloud);
    WatchedFilter filter;
    filter->SetMergeBlocks(merged);
    filter->SetInputDataObject(merged ? static_cast<vtkDataObject*>(blocks) : cloud);
    filter->Update();
    expectWarnings(filter, 1, { "vtkGhostType", "skipped" });
    EXPECT_EQ(filter->GetNumberOfSkippedPoints(), 0);
    EXPECT_EQ(filter->GetNumberOfTriangles(), 2);
  }
}

TEST(BadDataArrays, WholeNumbersAtTheEndOfTheirRangeStayThereAtCrossings)
{
  auto far = vtkSmartPointer<vtkLongLongArray>::New();
  far->SetName("far");
  far->SetNumberOfValues(4);
  far->FillValue(VTK_LONG_LONG_MAX);
  WatchedFilter filter;
  filter->SetInputData(makeSquareWith({ far }));
  filter->SetSourceData(makeSource({ { 0, 2 }, { 1, 3 } }, {}));
  filter->SetCrossingModeToSplit();
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 5);
  vtkDataArray* made = filter->GetOutput()->GetPointData()->GetArray("far");
  EXPECT_EQ(made->GetVariantValue(0).ToLongLong(), VTK_LONG_LONG_MAX);
  EXPECT_GT(made->GetVariantValue(4).ToLongLong(), VTK_LONG_LONG_MAX - 4096)
    << "of all four ends it is the largest";
}

TEST(BadDataArrays, NumbersOfTheSourceThatDoNotFitAreRounded)
{
  const auto kind = makeArray<vtkUnsignedCharArray>("kind", 4);
  const auto exact = makeArray<vtkLongLongArray>("exact", 4);
  auto source = makeSource({}, {}, { { 1, 1, 0 }, { 2, 1, 0 }, { 3, 1, 0 }, { 2, 3, 0 } });
  const auto kinds = makeArray<vtkDoubleArray>("kind", 4);
  const double values[] = { kNan, 1e300, -7.0, 2.6 };
  for (vtkIdType i = 0; i < 4; ++i)
  {
    kinds->SetValue(i, values[i]);
  }
  const auto numbers = makeArray<vtkIdTypeArray>("exact", 4);
  numbers->SetValue(0, (vtkIdType(1) << 53) + 1);
  source->GetPointData()->AddArray(kinds);
  source->GetPointData()->AddArray(numbers);
  WatchedFilter filter;
  filter->SetInputData(makeSquareWith({ kind, exact }));
  filter->SetSourceData(source);
  filter->SetSourceModeToCoordinates();
  filter->Update();
  vtkDataArray* made = filter->GetOutput()->GetPointData()->GetArray("kind");
  const double expected[] = { 0, 255, 0, 3 };
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(made->GetComponent(4 + i, 0), expected[i]) << values[i];
  }
  made = filter->GetOutput()->GetPointData()->GetArray("exact");
  EXPECT_EQ(made->GetVariantValue(4).ToLongLong(), (1LL << 53) + 1);
}

TEST(BadDataArrays, AnotherLengthInOneBlockLeavesTheArrayOutOfAllAndMarksBeside)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeSquareWith(makeArrays(4)));
  blocks->SetBlock(1, makeSquareWith(makeArrays(0)));
  WatchedFilter filter;
  filter->MergeBlocksOn();
  filter->SetInputDataObject(blocks);
  filter->Update();
  expectWarnings(filter, 0);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(filter->GetNumberOfDuplicates(), 4);
}
