// SPDX-License-Identifier: BSD-3-Clause
//
// Sources as readers give them: in several blocks, with outlines that are closed lines, without
// heights, and without constraints.
#include "ConstraintTestSupport.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkShortArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace ahdtest;
using Filter = vtkAdaptiveHilbertDelaunay2D;

namespace
{
/// The corners of a square of this side, counterclockwise from (at, at), the first once more.
std::vector<Xyz> ringOf(double at, double side, double z = 0.0)
{
  const double to = at + side;
  return { { at, at, z }, { to, at, z }, { to, to, z }, { at, to, z }, { at, at, z } };
}

/// As a GIS reader gives a shore, an island in it and a river: a block each, all of them lines.
vtkSmartPointer<vtkMultiBlockDataSet> makeMap()
{
  auto map = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, makeSource({ { 0, 1, 2, 3, 4 } }, {}, ringOf(0.5, 8)));
  inner->SetBlock(2, makeSource({ { 0, 1, 2, 3, 4 } }, {}, ringOf(3.5, 2)));
  map->SetBlock(0, inner);
  map->SetBlock(3, makeSource({ { 0, 1 } }, {}, { { 1.5, 1.2, 0 }, { 2.5, 7.3, 0 } }));
  return map;
}

struct MapFilter : WatchedFilter
{
  explicit MapFilter(vtkDataObject* source, int lattice = 10)
  {
    this->Filter->SetInputData(makeCloud(squareLattice(lattice)));
    this->Filter->SetInputDataObject(1, source);
    this->Filter->SetSourceModeToCoordinates();
    this->Filter->SetFillRuleToEvenOdd();
  }
};

std::string onlyWarning(const WatchedFilter& filter)
{
  EXPECT_TRUE(filter.Said->Errors.empty());
  EXPECT_EQ(filter.Said->Warnings.size(), 1u);
  return filter.Said->Warnings.empty() ? "" : filter.Said->Warnings[0];
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
}

TEST(SourceKinds, SeveralBlocksAreOneSource)
{
  MapFilter filter(makeMap());
  filter->Update();
  ASSERT_TRUE(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)));
  EXPECT_EQ(filter->GetNumberOfAddedPoints(), 12);
  EXPECT_EQ(filter->GetNumberOfDuplicates(), 2) << "each ring's last point";
  EXPECT_GE(filter->GetNumberOfConstraintEdges(), 9);
  EXPECT_TRUE(filter.Said->Warnings.empty());
  EXPECT_EQ(areaOf(filter->GetOutput()), 81.0) << "lines bound nothing";
  EXPECT_EQ(filter->GetSource(), nullptr);
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
}

TEST(SourceKinds, ClosedLinesAreLoopsOnRequest)
{
  MapFilter filter(makeMap());
  filter->SetClosedLinesToLoops();
  filter->Update();
  EXPECT_EQ(areaOf(filter->GetOutput()), 64.0 - 4.0);
  EXPECT_EQ(filter->GetNumberOfUnfilledLoops(), 0);
  filter->SetClosedLinesToLines();
  filter->Update();
  EXPECT_EQ(areaOf(filter->GetOutput()), 81.0);
}

TEST(SourceKinds, WhatBlocksAreIsWhatTheirSumIs)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkPolyData> whole;
  std::vector<Xyz> points;
  std::vector<Chain> lines, polygons;
  for (int k = 0; k < 3; ++k)
  {
    const std::vector<Xyz> ring = ringOf(0.5 + 1.25 * k, 7.5 - 2.5 * k, k);
    auto block = makeSource(k == 1 ? std::vector<Chain>{ { 0, 1, 2 } } : std::vector<Chain>{},
      k == 1 ? std::vector<Chain>{} : std::vector<Chain>{ { 0, 1, 2, 3 } }, ring);
    vtkNew<vtkIntArray> shallow;
    shallow->SetName(k == 0 ? "only here" : "everywhere");
    shallow->SetNumberOfValues(5);
    shallow->FillValue(k);
    block->GetPointData()->AddArray(shallow);
    blocks->SetBlock(static_cast<unsigned>(k), block);
    const vtkIdType begin = vtkIdType(points.size());
    (k == 1 ? lines : polygons)
      .push_back(k == 1 ? Chain{ begin, begin + 1, begin + 2 }
                        : Chain{ begin, begin + 1, begin + 2, begin + 3 });
    points.insert(points.end(), ring.begin(), ring.end());
  }
  MapFilter parted(blocks), one(makeSource(lines, polygons, points));
  parted->Update();
  one->Update();
  EXPECT_EQ(trianglesOf(parted->GetOutput()), trianglesOf(one->GetOutput()));
  EXPECT_EQ(parted->GetNumberOfConstraintEdges(), one->GetNumberOfConstraintEdges());
  for (vtkIdType i = 100; i < 115; ++i)
  {
    EXPECT_EQ(parted->GetOutput()->GetPoint(i)[2], one->GetOutput()->GetPoint(i)[2]);
  }
}

TEST(SourceKinds, BlocksOfTheInputStayBlocks)
{
  vtkNew<vtkMultiBlockDataSet> inputs;
  inputs->SetBlock(0, makeCloud(squareLattice(10)));
  inputs->SetBlock(1, makeCloud(squareLattice(9)));
  MapFilter filter(makeMap());
  filter->SetInputDataObject(0, inputs);
  filter->SetClosedLinesToLoops();
  filter->Update();
  auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(made);
  ASSERT_EQ(made->GetNumberOfBlocks(), 2u);
  for (unsigned k = 0; k < 2; ++k)
  {
    EXPECT_EQ(areaOf(vtkPolyData::SafeDownCast(made->GetBlock(k))), 60.0);
  }
  filter->MergeBlocksOn();
  filter->Update();
  ASSERT_TRUE(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)));
  EXPECT_EQ(areaOf(filter->GetOutput()), 60.0);
}

TEST(SourceKinds, BlocksThatAreNoPolygonalDataAreCounted)
{
  auto map = makeMap();
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  map->SetBlock(5, image);
  MapFilter filter(map);
  filter->Update();
  EXPECT_TRUE(contains(onlyWarning(filter), "1 block of the source is not a vtkPolyData"));
  EXPECT_EQ(filter->GetNumberOfAddedPoints(), 12);
}

TEST(SourceKinds, BlocksThatDoNotFitIntoMemoryAreRefused)
{
  MapFilter filter(makeMap());
  filter->SetMemoryLimit(1);
  filter->Update();
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_TRUE(contains(filter.Said->Errors[0], "Merging blocks")) << "before they are merged";
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(SourceKinds, IdsInBlocksAreThoseOfTheInput)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeSource({ { 0, 1 } }, {}, ringOf(0.5, 8)));
  blocks->SetBlock(1, makeSource({ { 0, 10 }, { 98, 99 } }, {}, ringOf(0.5, 8)));
  MapFilter filter(blocks);
  filter->SetSourceModeToIds();
  filter->Update();
  EXPECT_TRUE(filter.Said->Warnings.empty());
  EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 3);
}

TEST(SourceKinds, HeightsFromTheSurfaceAreTheMeansThatAreShown)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(makeCloud({ { 0, 0, 1 }, { 4, 0, 1 }, { 0, 4, 1 }, { 0, 0, 3 } }));
  filter->SetSourceData(makeSource({ { 0, 1 } }, {}, { { 0, 0, 7 }, { 1, 1, 7 } }));
  filter->SetSourceModeToCoordinates();
  filter->SetSourceHeightsToFromSurface();
  filter->SetDuplicatePolicyToMeanZ();
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 6);
  EXPECT_DOUBLE_EQ(filter->GetOutput()->GetPoint(5)[2], 0.5 * 2 + 0.5 * 1);
}

TEST(SourceKinds, SeriesOfBlocksAreKept)
{
  MapFilter filter(makeMap());
  for (int i = 0; i < 4; ++i)
  {
    filter->GetInputDataObject(0, 0)->Modified();
    filter->GetInputDataObject(1, 0)->Modified();
    filter->Update();
  }
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 4) << "as points are added";
}

TEST(SourceKinds, HeightsAndDataComeFromTheSurface)
{
  // a slope: z = 2 x, depth = 3 y
  std::vector<Xyz> slope = squareLattice(10);
  vtkNew<vtkDoubleArray> depth;
  vtkNew<vtkIntArray> whole;
  depth->SetName("depth");
  whole->SetName("whole");
  for (Xyz& p : slope)
  {
    p[2] = 2 * p[0];
    depth->InsertNextValue(3 * p[1]);
    whole->InsertNextValue(int(p[1]));
  }
  auto cloud = makeCloud(slope);
  cloud->GetPointData()->AddArray(depth);
  cloud->GetPointData()->AddArray(whole);
  MapFilter filter(
    makeSource({ { 0, 1, 2 } }, {}, { { 0.5, 0.25, 0 }, { 8.25, 7.75, 0 }, { 20, 0, 5 } }));
  filter->SetInputData(cloud);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPoint(101)[2], 0.0);
  filter->SetSourceHeightsToFromSurface();
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  vtkPointData* data = surface->GetPointData();
  EXPECT_NEAR(surface->GetPoint(100)[2], 1.0, 1e-12);
  EXPECT_EQ(surface->GetPoint(100)[0], 0.5) << "x and y stay";
  EXPECT_NEAR(surface->GetPoint(101)[2], 16.5, 1e-12);
  EXPECT_NEAR(data->GetArray("depth")->GetComponent(101, 0), 23.25, 1e-12);
  EXPECT_EQ(data->GetArray("whole")->GetComponent(101, 0), 8.0) << "rounded";
  EXPECT_EQ(surface->GetPoint(102)[2], 5.0) << "outside: its own";
  EXPECT_TRUE(std::isnan(data->GetArray("depth")->GetComponent(102, 0)));
  EXPECT_TRUE(contains(onlyWarning(filter), "1 of 3 points of the source lie outside"));
}

TEST(SourceKinds, LinesFollowTheTerrain)
{
  std::vector<Xyz> hills = squareLattice(10);
  vtkNew<vtkDoubleArray> copy; // of z
  copy->SetName("copy");
  for (Xyz& p : hills)
  {
    p[2] = std::sin(1.7 * p[0]) * std::cos(0.9 * p[1]);
    copy->InsertNextValue(p[2]);
  }
  auto cloud = makeCloud(hills);
  cloud->GetPointData()->AddArray(copy);
  vtkNew<Filter> surface;
  surface->SetInputData(cloud);
  surface->Update();
  MapFilter filter(makeSource({ { 0, 1 } }, {}, { { 0.5, 0.25, 0 }, { 8.25, 7.75, 0 } }));
  filter->SetInputData(cloud);
  filter->SetSourceHeightsToFromSurface();
  filter->Update();
  const vtkIdType added = filter->GetNumberOfAddedLinePoints();
  EXPECT_GE(added, 8 + 7 + 7) << "rows, columns and diagonals of the lattice";
  EXPECT_EQ(filter->GetNumberOfAddedPoints(), 2 + added);
  vtkPolyData* out = filter->GetOutput();
  ASSERT_EQ(out->GetNumberOfPoints(), 102 + added);
  for (vtkIdType i = 100; i < out->GetNumberOfPoints(); ++i)
  {
    const double z = out->GetPoint(i)[2];
    EXPECT_NEAR(out->GetPointData()->GetArray("copy")->GetComponent(i, 0), z, 1e-12);
  }
  filter->SourceLinesOnSurfaceOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 102);
  filter->SetMaximumSegmentLength(1.0);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfAddedLinePoints(), 10);
}

TEST(SourceKinds, ContoursKeepTheirHeightsAndARoadTakesThem)
{
  const double none = std::nan("");
  const std::vector<Xyz> lines = { { 2.5, 1.5, 9 }, { 6.5, 8.5, 9 }, { 1.5, 6.5, none },
    { 8.5, 2.25, none } };
  MapFilter filter(makeSource({ { 0, 1 }, { 2, 3 } }, {}, lines)); // over points with z = 0
  filter->SetSourceHeightsToMixed();
  filter->Update();
  EXPECT_TRUE(filter.Said->Warnings.empty()) << "nothing is left out";
  vtkPolyData* out = filter->GetOutput();
  EXPECT_EQ(out->GetPoint(100)[2], 9.0);
  EXPECT_EQ(out->GetPoint(101)[2], 9.0);
  double highest = 0.0;
  for (vtkIdType i = 102; i < out->GetNumberOfPoints(); ++i)
  {
    EXPECT_TRUE(std::isfinite(out->GetPoint(i)[2])) << i;
    highest = std::max(highest, out->GetPoint(i)[2]);
  }
  EXPECT_NEAR(highest, 9.0, 1e-12) << "where the road crosses the contour";
}

TEST(SourceKinds, OnAFittedPlaneTheHeightIsAboveIt)
{
  std::vector<Xyz> wall = squareLattice(10); // x, z; y is the height
  for (Xyz& p : wall)
  {
    p = { p[0], 0.125 * p[0], p[1] };
  }
  MapFilter filter(makeSource({ { 0, 1 } }, {}, { { 2.5, 0.9, 2.25 }, { 6.5, 0.2, 6.25 } }));
  filter->SetInputData(makeCloud(wall));
  filter->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
  filter->SetSourceHeightsToFromSurface();
  filter->Update();
  for (vtkIdType i = 100; i < 102; ++i)
  {
    const double* p = filter->GetOutput()->GetPoint(i);
    EXPECT_NEAR(p[1], 0.125 * p[0], 1e-12) << "laid on the wall";
  }
}

TEST(SourceKinds, WithIdsHeightsMeanNothing)
{
  MapFilter filter(makeSource({ { 0, 11 } }, {}));
  filter->SetSourceModeToIds();
  filter->SetSourceHeightsToFromSurface();
  filter->Update();
  EXPECT_TRUE(filter.Said->Warnings.empty());
  EXPECT_EQ(filter->GetNumberOfAddedPoints(), 0);
}

TEST(SourceKinds, WhatConstrainsNothingIsNamed)
{
  auto points = makeCloud(ringOf(0.5, 2));
  MapFilter onlyPoints(points);
  onlyPoints->Update();
  std::string said = onlyWarning(onlyPoints);
  EXPECT_TRUE(contains(said, "constrains nothing")) << said;
  EXPECT_TRUE(contains(said, "Found: 5 points.")) << said;
  EXPECT_FALSE(contains(said, "strip")) << said;

  auto strips = makeCloud(ringOf(0.5, 2));
  strips->SetStrips(makeCells({ { 0, 1, 2, 3 } }));
  strips->SetVerts(makeCells({ { 0 }, { 1 } }));
  strips->SetLines(makeCells({ { 0 } })); // of one point
  MapFilter onlyStrips(strips);
  onlyStrips->Update();
  said = onlyWarning(onlyStrips);
  EXPECT_TRUE(contains(said, "constrains nothing")) << said;
  EXPECT_TRUE(contains(said, "5 points, 2 vertices, 1 triangle strip")) << said;

  strips->SetLines(makeCells({ { 0, 1 } }));
  MapFilter some(strips);
  some->Update();
  said = onlyWarning(some);
  EXPECT_TRUE(contains(said, "1 triangle strip of the source is ignored")) << said;
  EXPECT_FALSE(contains(said, "constrains nothing")) << said;
}

TEST(SourceKinds, APolygonOfTwoPointsIsAnEdge)
{
  for (const int rule : { Filter::ORIENTATION, Filter::EVEN_ODD })
  {
    ConstrainedFilter filter(squareLattice(4), makeSource({}, { { 0, 14 } }));
    filter.Filter->SetFillRule(rule);
    EXPECT_EQ(areaOf(filter.Run()), 9.0);
    EXPECT_TRUE(hasEdge(filter->GetOutput(), 0, 14));
    EXPECT_TRUE(filter.Said->Warnings.empty());
  }
}

namespace
{
/// The same two segments in cells as VTK can store them: ids and offsets of 64 bits, of 32 bits,
/// cells of one size, ids of one more type. VTK 9.1 converts the third to the first, and refuses
/// the last.
template <typename Array>
vtkSmartPointer<vtkCellArray> twoSegments(bool ofOneSize)
{
  vtkNew<Array> ids;
  for (const int id : { 0, 11, 8, 14 })
  {
    ids->InsertNextValue(static_cast<typename Array::ValueType>(id));
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  if (ofOneSize)
  {
    return cells->SetData(2, ids) ? cells : nullptr;
  }
  vtkNew<Array> offsets;
  for (const int offset : { 0, 2, 4 })
  {
    offsets->InsertNextValue(static_cast<typename Array::ValueType>(offset));
  }
  vtkObject::GlobalWarningDisplayOff();
  const bool isPossible = cells->SetData(static_cast<vtkDataArray*>(offsets), ids);
  vtkObject::GlobalWarningDisplayOn();
  return isPossible ? cells : nullptr;
}

std::vector<double> trianglesWith(vtkCellArray* lines)
{
  auto source = makeSource({}, {});
  source->SetLines(lines);
  ConstrainedFilter filter(squareLattice(4), source);
  vtkPolyData* surface = filter.Run();
  EXPECT_TRUE(filter.Said->Warnings.empty() && filter.Said->Errors.empty());
  EXPECT_TRUE(hasEdge(surface, 0, 11) && hasEdge(surface, 8, 14));
  std::vector<double> ids;
  for (vtkIdType i = 0; i < surface->GetPolys()->GetNumberOfConnectivityIds(); ++i)
  {
    ids.push_back(surface->GetPolys()->GetConnectivityArray()->GetComponent(i, 0));
  }
  return ids;
}
}

TEST(SourceKinds, CellsAreReadHoweverTheyAreStored)
{
  const std::vector<double> expected = trianglesWith(twoSegments<vtkTypeInt64Array>(false));
  EXPECT_FALSE(expected.empty());
  const vtkSmartPointer<vtkCellArray> others[] = { twoSegments<vtkTypeInt64Array>(true),
    twoSegments<vtkTypeInt32Array>(false), twoSegments<vtkTypeInt32Array>(true),
    twoSegments<vtkIdTypeArray>(false), twoSegments<vtkShortArray>(false) };
  int stored = 0;
  for (vtkCellArray* cells : others)
  {
    stored += cells ? 1 : 0;
    EXPECT_TRUE(!cells || trianglesWith(cells) == expected);
  }
  EXPECT_GE(stored, 4);
}
