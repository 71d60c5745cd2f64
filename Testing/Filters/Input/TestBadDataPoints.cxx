// SPDX-License-Identifier: BSD-3-Clause
//
// Points as users have them: heights and places that are not finite, whole numbers, no points, all
// in one place, the largest numbers. Each has its documented message and result.
#include "BadDataSupport.h"

#include "vtkAdaptiveHilbertInterpolation2D.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPerspectiveTransform.h"
#include "vtkTable.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

using namespace ahdtest;

namespace
{
const std::vector<Xyz> kSquare = { { 0, 0, 1 }, { 4, 0, 2 }, { 4, 4, 3 }, { 0, 4, 4 } };

/// Every feature that reads coordinates is on.
void switchAllOn(vtkAdaptiveHilbertDelaunay2D* filter)
{
  filter->GenerateFateOn();
  filter->GenerateInsertionRankOn();
  filter->GenerateInsertionCurveOn();
  filter->GenerateBoxesOn();
  filter->GenerateVoronoiOn();
  filter->GenerateNeighborsOn();
  filter->GenerateRegionIdsOn();
  filter->GenerateConstraintEdgesOn();
}

/// Every corner of the diagram's cells is a number.
void expectFinite(vtkPolyData* data)
{
  vtkIdType odd = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* p = data->GetPoint(i);
    odd += !std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]);
  }
  EXPECT_EQ(odd, 0) << "of " << data->GetNumberOfPoints();
}
}

TEST(BadDataPoints, DepthsThatAreNoNumbersHaveNoSayWhateverIsAskedFor)
{
  // A hydrographer's gaps: x, y good, z missing, at duplicates as well.
  std::vector<Xyz> points = scatteredPoints(300);
  points.push_back({ points[7][0], points[7][1], 5.0 });
  const std::vector<Triangle> expected = triangulate(points);
  points[7][2] = kNan;
  points[8][2] = -kInf;
  for (int policy : { 0, 1, 2, 3 })
  {
    SCOPED_TRACE("policy " + std::to_string(policy));
    WatchedFilter filter;
    switchAllOn(filter.Filter);
    filter->SetInputData(makeCloud(points));
    filter->SetDuplicatePolicy(policy);
    filter->BoundingTriangulationOff();
    filter->Update();
    expectWarnings(filter, 1, { "2 of 301 points have a z that is NaN or infinite" });
    expectCountsOfFates(filter.Filter);
    EXPECT_EQ(filter->GetNumberOfRejectedPoints(), 0);
    EXPECT_EQ(filter->GetNumberOfDuplicates(), 1);
    expectFinite(filter->GetOutput(2));
    const vtkIdType shown = policy == 1 || policy == 2 ? 300 : 7;
    EXPECT_EQ(idsOf(filter->GetOutput()->GetPointData(), "Fate")[7], shown);
    std::vector<Triangle> triangles = trianglesOf(filter->GetOutput());
    for (Triangle& t : triangles)
    {
      std::replace(t.begin(), t.end(), vtkIdType(300), vtkIdType(7));
    }
    EXPECT_EQ(triangles, expected);
    const double z = filter->GetOutput()->GetPoint(7)[2];
    EXPECT_TRUE(policy == 3 ? z == 5.0 : std::isnan(z)) << z;
  }
}

TEST(BadDataPoints, AroundDepthsThatAreNoNumbersThereIsABoundingTriangulation)
{
  std::vector<Xyz> points = kSquare;
  for (Xyz& p : points)
  {
    p[2] = kNan;
  }
  WatchedFilter filter;
  filter->SetInputData(makeCloud(points));
  filter->BoundingTriangulationOn();
  filter->GenerateFateOn();
  filter->Update();
  expectWarnings(filter, 1, { "4 of 12 points" });
  expectCountsOfFates(filter.Filter);
  EXPECT_EQ(filter->GetOutput()->GetPoint(4)[2], 0.0) << "no height is known";
}

TEST(BadDataPoints, WithoutAPlaceTheyHaveNoCellAnywhere)
{
  std::vector<Xyz> points = scatteredPoints(100);
  const Xyz odd[] = { { kNan, 0, 0 }, { 0, kNan, 0 }, { kInf, 0, 0 }, { 0, -kInf, 0 },
    { kNan, kInf, kNan } };
  points.insert(points.begin() + 50, std::begin(odd), std::end(odd));
  for (int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    WatchedFilter filter;
    switchAllOn(filter.Filter);
    filter->SetInputData(makeCloud(points, type));
    filter->SetTolerance(0.01);
    filter->SetAlpha(1e9); // points that nothing uses become vertices
    filter->Update();
    expectWarnings(filter, 1, { "5 of 105 points were rejected", "the first is point 50" });
    expectCountsOfFates(filter.Filter);
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < filter->GetOutput()->GetNumberOfCells(); ++cell)
    {
      filter->GetOutput()->GetCellPoints(cell, ids);
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        EXPECT_TRUE(ids->GetId(i) < 50 || ids->GetId(i) > 54) << ids->GetId(i);
      }
    }
    for (int port : { 1, 2 })
    {
      expectFinite(filter->GetOutput(port));
    }
  }
}

TEST(BadDataPoints, OfBytesBitsAndLongNumbersAreConverted)
{
  const std::vector<Xyz> points = latticePoints(200, 100);
  const std::vector<Triangle> expected = triangulate(points);
  for (int type : { VTK_UNSIGNED_CHAR, VTK_SIGNED_CHAR, VTK_CHAR, VTK_UNSIGNED_SHORT, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG })
  {
    SCOPED_TRACE("VTK type " + std::to_string(type));
    WatchedFilter filter;
    switchAllOn(filter.Filter);
    filter->SetInputData(makeCloud(points, type));
    filter->Update();
    expectWarnings(filter, 0);
    expectCountsOfFates(filter.Filter);
    EXPECT_EQ(trianglesOf(filter->GetOutput()), expected);
    EXPECT_EQ(filter->GetOutput()->GetPoints()->GetDataType(), type);
  }
  EXPECT_EQ(
    triangulate({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, VTK_BIT).size(), 2u);
}

TEST(BadDataPoints, WholeNumbersThatDoublesDoNotTellApartAreDuplicates)
{
  auto cloud = makeCloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0 } }, VTK_LONG_LONG);
  auto* numbers = vtkArrayDownCast<vtkDataArray>(cloud->GetPoints()->GetData());
  const long long big = (1LL << 53) + 1; // a double rounds it to 2^53
  numbers->SetVariantValue(6, vtkVariant(big - 1));
  numbers->SetVariantValue(9, vtkVariant(big));
  WatchedFilter filter;
  filter->GenerateFateOn();
  filter->SetInputData(cloud);
  filter->Update();
  // (2^53, 1) and (2^53 + 1, 0): other places in y
  EXPECT_EQ(filter->GetNumberOfDuplicates(), 0);
  numbers->SetVariantValue(10, vtkVariant(1));
  cloud->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfDuplicates(), 1);
  EXPECT_EQ(idsOf(filter->GetOutput()->GetPointData(), "Fate")[3], 2);
  EXPECT_EQ(numbers->GetVariantValue(9).ToLongLong(), big) << "the points are put out as they are";
}

TEST(BadDataPoints, NoneOneOrTwoComeThroughEverySetting)
{
  for (std::size_t count : { 0u, 1u, 2u })
  {
    for (int mode : { VTK_DELAUNAY_XY_PLANE, VTK_BEST_FITTING_PLANE })
    {
      for (bool bounding : { false, true })
      {
        SCOPED_TRACE(std::to_string(count) + " points, mode " + std::to_string(mode));
        const std::vector<Xyz> points(kSquare.begin(), kSquare.begin() + std::ptrdiff_t(count));
        WatchedFilter filter;
        switchAllOn(filter.Filter);
        filter->SetInputData(makeCloud(points));
        filter->SetSourceData(makeSource({ { 0, 1 } }, { { 0, 1, 2 } }));
        filter->SetProjectionPlaneMode(mode);
        filter->SetBoundingTriangulation(bounding);
        filter->SetTolerance(1e-6);
        filter->SetDuplicatePolicyToMeanZ();
        filter->SetAlpha(1e9);
        filter->SetCrossingModeToSplit();
        filter->SetVoronoiClipToBounds();
        filter->Update();
        EXPECT_TRUE(filter.Said->Errors.empty());
        expectCountsOfFates(filter.Filter);
        const bool isBounded = bounding && count > 0 && mode == VTK_DELAUNAY_XY_PLANE;
        EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), vtkIdType(count) + (isBounded ? 8 : 0));
        EXPECT_EQ(filter->GetNumberOfPointsInserted() > 2,
          isBounded && count == 2 && filter->GetNumberOfTriangles() > 0);
      }
    }
  }
}

TEST(BadDataPoints, AMillionInOnePlace)
{
  const std::vector<Xyz> points(1000000, { 637177.98, 849393.95, -12.5 });
  auto cloud = makeCloud(points);
  for (int mode : { VTK_DELAUNAY_XY_PLANE, VTK_BEST_FITTING_PLANE })
  {
    for (double tolerance : { 0.0, 0.5 })
    {
      SCOPED_TRACE("mode " + std::to_string(mode) + ", tolerance " + std::to_string(tolerance));
      WatchedFilter filter;
      switchAllOn(filter.Filter);
      filter->SetInputData(cloud);
      filter->SetProjectionPlaneMode(mode);
      filter->SetTolerance(tolerance);
      filter->SetDuplicatePolicyToMeanZ();
      filter->SetAlpha(1.0);
      filter->Update();
      expectWarnings(filter, 1, { "fewer than three", "1 distinct points among 1000000" });
      expectCountsOfFates(filter.Filter);
      EXPECT_EQ(filter->GetNumberOfDuplicates() + filter->GetNumberOfMergedPoints(), 999999);
      EXPECT_EQ(filter->GetOutput()->GetNumberOfVerts(), 1000000) << "used by nothing";
      EXPECT_EQ(filter->GetOutput()->GetPoint(0)[2], -12.5);
      EXPECT_EQ(filter->GetOutput(2)->GetNumberOfCells(), 0);
    }
  }
}

TEST(BadDataPoints, AMillionInOnePlaceAmongOthers)
{
  std::vector<Xyz> points(1000000, { 0.5, 0.25, 3.0 });
  points.insert(points.end(), kSquare.begin(), kSquare.end());
  WatchedFilter filter;
  filter->GenerateFateOn();
  filter->SetInputData(makeCloud(points));
  filter->Update();
  expectWarnings(filter, 0);
  expectCountsOfFates(filter.Filter);
  EXPECT_EQ(filter->GetNumberOfDuplicates(), 999999);
  EXPECT_EQ(filter->GetNumberOfTriangles(), 4);
}

TEST(BadDataPoints, OfACollapsedTransformAreOnALineOrInOnePlace)
{
  for (double y : { 1.0, 0.0 })
  {
    vtkNew<vtkTransform> transform;
    transform->Scale(y, 0.0, 1.0);
    WatchedFilter filter;
    switchAllOn(filter.Filter);
    filter->SetInputData(makeCloud(scatteredPoints(100)));
    filter->SetTransform(transform);
    filter->Update();
    expectCountsOfFates(filter.Filter);
    EXPECT_EQ(filter->GetNumberOfTriangles(), 0);
    ASSERT_EQ(filter.Said->Warnings.size(), 2u);
    EXPECT_NE(filter.Said->Warnings[0].find("no inverse"), std::string::npos);
    EXPECT_NE(
      filter.Said->Warnings[1].find(y == 1.0 ? "all distinct points are collinear: 100 distinct"
                                             : "fewer than three distinct points: 1 distinct"),
      std::string::npos)
      << filter.Said->Warnings[1];
  }
}

TEST(BadDataPoints, OfATransformThatGivesNoNumbersAreAllRejected)
{
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, kNan);
  vtkNew<vtkTransform> linear;
  linear->SetMatrix(matrix);
  vtkNew<vtkPerspectiveTransform> perspective;
  perspective->SetMatrix(matrix);
  for (vtkAbstractTransform* transform :
    { static_cast<vtkAbstractTransform*>(linear), static_cast<vtkAbstractTransform*>(perspective) })
  {
    WatchedFilter filter;
    switchAllOn(filter.Filter);
    filter->SetInputData(makeCloud(scatteredPoints(100)));
    filter->SetTransform(transform);
    filter->SetTolerance(0.1);
    filter->Update();
    expectCountsOfFates(filter.Filter);
    EXPECT_EQ(filter->GetNumberOfRejectedPoints(), 100);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 100);
    EXPECT_TRUE(std::any_of(filter.Said->Warnings.begin(), filter.Said->Warnings.end(),
      [](const std::string& said)
      { return said.find("100 of 100 points were rejected") != std::string::npos; }));
  }
}

TEST(BadDataPoints, AsLargeAsNumbersGetComeThroughEverySetting)
{
  for (double scale : { 1e300, 1.7e308 })
  {
    std::vector<Xyz> points = scatteredPoints(200);
    for (Xyz& p : points)
    {
      p = { (p[0] - 0.5) * 2 * scale, (p[1] - 0.5) * 2 * scale, (p[0] - p[1]) * scale };
    }
    for (int mode : { VTK_DELAUNAY_XY_PLANE, VTK_BEST_FITTING_PLANE })
    {
      for (bool toBounds : { false, true })
      {
        SCOPED_TRACE(std::to_string(scale) + " mode " + std::to_string(mode));
        WatchedFilter filter;
        switchAllOn(filter.Filter);
        filter->SetInputData(makeCloud(points));
        filter->SetProjectionPlaneMode(mode);
        filter->SetAlpha(1e299);
        filter->SetVoronoiClip(toBounds);
        filter->BoundingTriangulationOn();
        filter->Update();
        EXPECT_TRUE(filter.Said->Errors.empty());
        expectCountsOfFates(filter.Filter);
        expectFinite(filter->GetOutput(0));
        expectFinite(filter->GetOutput(1));
        if (mode == VTK_DELAUNAY_XY_PLANE || scale < 1e308)
        {
          EXPECT_GT(filter->GetNumberOfPointsInserted(), 199);
          expectFinite(filter->GetOutput(2)); // else its corners may be beyond all numbers
        }
      }
    }
  }
}

TEST(BadDataPoints, HugeOnesHaveTheVoronoiDiagramOfSmallOnes)
{
  std::vector<Xyz> points = scatteredPoints(100);
  std::vector<vtkIdType> sizes[2];
  for (int k : { 0, 1 })
  {
    WatchedFilter filter;
    filter->SetInputData(makeCloud(points));
    filter->GenerateVoronoiOn();
    filter->Update();
    expectWarnings(filter, 0);
    expectFinite(filter->GetOutput(2));
    for (vtkIdType i = 0; i < filter->GetOutput(2)->GetNumberOfCells(); ++i)
    {
      vtkNew<vtkIdList> ids;
      filter->GetOutput(2)->GetCellPoints(i, ids);
      sizes[k].push_back(ids->GetNumberOfIds());
    }
    for (Xyz& p : points)
    {
      p = { p[0] * 0x1p1023, p[1] * 0x1p1023, 0 };
    }
  }
  EXPECT_EQ(sizes[0].size(), 100u);
  EXPECT_EQ(sizes[0], sizes[1]);
}

TEST(BadDataPoints, OfBlocksThatAreEmptyOrMissing)
{
  const std::vector<Xyz> points = latticePoints(200, 1000);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkPolyData>());
  auto unset = vtkSmartPointer<vtkPolyData>::New();
  unset->SetPoints(vtkNew<vtkPoints>());
  blocks->SetBlock(1, unset);
  blocks->SetBlock(3, makeCloud(points));
  blocks->SetBlock(4, vtkNew<vtkMultiBlockDataSet>());
  for (bool merge : { false, true })
  {
    SCOPED_TRACE(merge ? "merged" : "one by one");
    WatchedFilter filter;
    filter->SetMergeBlocks(merge);
    filter->SetInputDataObject(blocks);
    filter->Update();
    expectWarnings(filter, 0);
    vtkDataObject* made = filter->GetOutputDataObject(0);
    if (!merge)
    {
      auto* surfaces = vtkMultiBlockDataSet::SafeDownCast(made);
      ASSERT_NE(surfaces, nullptr);
      EXPECT_EQ(surfaces->GetBlock(2), nullptr) << "there is none";
      for (unsigned int k : { 0u, 1u })
      {
        auto* empty = vtkPolyData::SafeDownCast(surfaces->GetBlock(k));
        ASSERT_NE(empty, nullptr);
        EXPECT_EQ(empty->GetNumberOfPoints() + empty->GetNumberOfCells(), 0);
      }
      made = surfaces->GetBlock(3);
    }
    ASSERT_NE(vtkPolyData::SafeDownCast(made), nullptr);
    EXPECT_EQ(trianglesOf(vtkPolyData::SafeDownCast(made)), triangulate(points));
  }
}

TEST(BadDataPoints, AnImageIsRefusedByThePipeline)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 1);
  for (bool merge : { false, true })
  {
    WatchedFilter filter;
    filter->SetMergeBlocks(merge);
    filter->SetInputDataObject(image);
    filter->Update();
    EXPECT_TRUE(filter.Said->Errors.empty());
    ASSERT_EQ(filter.PipelineSaid->Errors.size(), 1u);
    EXPECT_NE(filter.PipelineSaid->Errors[0].find("vtkImageData"), std::string::npos);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  }
}

TEST(BadDataPoints, ATableIsOneMessageThatSaysWhatToDo)
{
  vtkNew<vtkTable> table;
  const auto expectOne = [](Messages* said, Messages* ofPipeline)
  {
    EXPECT_TRUE(said->Errors.empty() && ofPipeline->Errors.empty());
    ASSERT_EQ(said->Warnings.size(), 1u);
    EXPECT_NE(said->Warnings[0].find("Table To Points"), std::string::npos) << said->Warnings[0];
  };
  for (bool merge : { false, true })
  {
    WatchedFilter filter;
    filter->SetMergeBlocks(merge);
    filter->SetInputDataObject(table);
    filter->Update();
    expectOne(filter.Said, filter.PipelineSaid);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  }
  vtkNew<vtkAdaptiveHilbertInterpolation2D> raster;
  vtkNew<Messages> said, ofPipeline;
  said->Watch(raster);
  ofPipeline->Watch(raster->GetExecutive());
  raster->SetInputDataObject(table);
  raster->Update();
  expectOne(said, ofPipeline);
}

TEST(BadDataPoints, WithCellsOfEveryKindAndGhostsAmongThemAreTriangulatedAsPoints)
{
  auto cloud = makeCloud(kSquare);
  cloud->SetVerts(makeCells({ { 0 }, { 1, 2 } }));
  cloud->SetLines(makeCells({ { 0, 1, 2 }, {} }));
  cloud->SetPolys(makeCells({ { 0, 1, 2, 3 } }));
  cloud->SetStrips(makeCells({ { 0, 1, 2, 3 } }));
  vtkNew<vtkUnsignedCharArray> cellMarks; // of cells: they do not apply to points
  cellMarks->SetName(vtkDataSetAttributes::GhostArrayName());
  cellMarks->SetNumberOfValues(cloud->GetNumberOfCells());
  cellMarks->FillValue(vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL);
  cloud->GetCellData()->AddArray(cellMarks);
  WatchedFilter filter;
  filter->GenerateFateOn();
  filter->SetInputData(cloud);
  filter->Update();
  expectWarnings(filter, 0);
  EXPECT_EQ(filter->GetNumberOfSkippedPoints(), 0);
  EXPECT_EQ(trianglesOf(filter->GetOutput()), triangulate(kSquare));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 2);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetNumberOfArrays(), 0);

  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(4);
  marks->FillValue(vtkDataSetAttributes::DUPLICATEPOINT);
  cloud->GetPointData()->AddArray(marks);
  filter->Update();
  expectWarnings(filter, 0); // nothing is left for a triangle
  EXPECT_EQ(filter->GetNumberOfSkippedPoints(), 4);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  expectCountsOfFates(filter.Filter);
}

TEST(BadDataPoints, BitsThatChangeAreSeen)
{
  auto cloud = makeCloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, VTK_BIT);
  WatchedFilter filter;
  filter->SetInputData(cloud);
  for (int step = 0; step < 3; ++step)
  {
    cloud->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfTriangles(), 2);
  }
  cloud->GetPoints()->SetPoint(3, 0, 0, 0);
  cloud->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangles(), 1);
  EXPECT_EQ(filter->GetNumberOfDuplicates(), 1);
}
