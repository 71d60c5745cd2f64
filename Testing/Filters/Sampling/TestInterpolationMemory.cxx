// SPDX-License-Identifier: BSD-3-Clause
//
// The triangulation that the interpolation keeps, and memory.
#include "ConstraintTestSupport.h"
#include "SampleTestSupport.h"

#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkSphericalTransform.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWeakPointer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#if defined(__linux__)
#include "AddressSpaceLimit.h"
#endif

namespace
{

using namespace ahdtest;

vtkSmartPointer<vtkPolyData> cloud(std::size_t count = 1000, double size = 1.0)
{
  std::vector<Xyz> points = scatteredPoints(count, 17);
  for (Xyz& p : points)
  {
    p = { p[0] * size, p[1] * size, std::sin(5 * p[0]) };
  }
  return makeCloud(points);
}

TEST(InterpolationMemory, NothingIsTriangulatedTwice)
{
  auto points = cloud();
  WatchedInterpolation filter;
  filter->SetInputData(points);
  filter->Update();
  filter->Update();
  for (const int method : { 1, 2, 3, 0 })
  {
    filter->SetMethod(method);
    filter->SetDimensions(20 + method, 30);
    filter->Update();
  }
  filter->SetOutputTypeToSurface();
  filter->SetPlacesData(cloud(50));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
  vtkNew<vtkPolyData> same; // other objects, the same points
  same->DeepCopy(points);
  addArray<vtkDoubleArray>(same, "more", [](vtkIdType) { return 4.0; });
  filter->SetInputData(same);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
  EXPECT_EQ(arrayOf(filter->GetOutput(), "more")->GetRange()[1], 4.0);
  filter->GetTriangulation()->SetNmax(40);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 2);
  filter->GetTriangulation()->KeepTriangulationOff();
  filter->Update();
  filter->SetMethodToNearest();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 4);
  filter->GetTriangulation()->KeepTriangulationOn();
  filter->GetTriangulation()->SetReuseLimit(0);
  filter->Update();
  filter->SetMethodToLinear();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 6);
}

/// Each array of the source counts, and the number of its vertices.
TEST(InterpolationMemory, AnotherSourceIsTriangulatedAnew)
{
  const auto points = cloud(200);
  WatchedInterpolation filter;
  filter->SetInputData(points);
  filter->GetTriangulation()->SetSourceModeToCoordinates();
  const auto runsWith = [&](vtkPolyData* source, double x = 0.1)
  {
    vtkNew<vtkPolyData> copy; // of other objects
    copy->DeepCopy(source);
    copy->SetPoints(makeCloud(
      { { x, 0.2, 0 }, { 0.9, 0.1, 0 }, { 0.8, 0.9, 0 }, { 0.2, 0.8, 0 }, { 0.4, 0.5, 0 },
        { 0.6, 0.4,
          0 } })->GetPoints());
    const int before = filter->GetNumberOfTriangulations();
    filter->SetSourceData(copy);
    filter->Update();
    return filter->GetNumberOfTriangulations() > before;
  };
  const auto line = makeSource({ { 0, 1, 2, 3, 4, 5 } }, {});
  auto vertex = makeSource({ { 0, 1, 2, 3, 4, 5 } }, {});
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ vtkIdType(1) });
  vertex->SetVerts(cells);
  // each differs from the one before in one thing
  const vtkSmartPointer<vtkPolyData> sources[] = { line, vertex, line,
    makeSource({ { 0, 1, 2 }, { 3, 4, 5 } }, {}), makeSource({ { 0, 1, 2 }, { 3, 5, 4 } }, {}),
    makeSource({}, { { 0, 1, 2, 3, 4, 5 } }), makeSource({}, { { 0, 1, 2 }, { 3, 4, 5 } }),
    makeSource({}, { { 0, 1, 2 }, { 3, 5, 4 } }) };
  for (const auto& source : sources)
  {
    EXPECT_TRUE(runsWith(source));
    EXPECT_FALSE(runsWith(source));
  }
  EXPECT_TRUE(runsWith(sources[0], 0.15));
  EXPECT_TRUE(runsWith(sources[0]));
}

/// Neither are points of which some are skipped, whatever other data they have, until others are.
TEST(InterpolationMemory, MarkedPointsAreKeptWithTheirMarks)
{
  const auto marked = [](vtkIdType skipped, double value)
  {
    auto points = cloud(300);
    addArray<vtkUnsignedCharArray>(points, vtkDataSetAttributes::GhostArrayName(),
      [skipped](vtkIdType i)
      { return i == skipped ? double(vtkDataSetAttributes::HIDDENPOINT) : 0; });
    addArray<vtkDoubleArray>(points, "a", [value](vtkIdType) { return value; });
    return points;
  };
  WatchedInterpolation filter;
  auto points = marked(7, 1.0);
  filter->SetInputData(points);
  filter->Update();
  filter->SetDimensions(30, 20);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
  for (const double value : { 2.0, 3.0 })
  {
    points = marked(7, value); // others of the same content
    filter->SetInputData(points);
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
    EXPECT_NEAR(arrayOf(filter->GetOutput(), "a")->GetRange()[1], value, 1e-12);
  }
  filter->SetInputData(marked(8, 3.0));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 2);
}

/// Between executions the kept triangulation holds no data of the points, except those made from
/// blocks, which count.
TEST(InterpolationMemory, OnlyTheTriangulationIsKept)
{
  auto points = cloud(20000);
  addArray<vtkDoubleArray>(points, "a", [](vtkIdType i) { return double(i); });
  vtkWeakPointer<vtkDataArray> array = points->GetPointData()->GetArray("a");
  WatchedInterpolation filter;
  filter->SetInputData(points);
  filter->SetDimensions(5, 5);
  filter->Update();
  points->GetPointData()->RemoveArray("a");
  EXPECT_EQ(array, nullptr);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
  const auto countWith = [&](vtkTypeInt64 reuseLimit)
  {
    filter->GetTriangulation()->SetReuseLimit(0);
    filter->Update();
    filter->GetTriangulation()->SetReuseLimit(reuseLimit);
    const int before = filter->GetNumberOfTriangulations();
    for (const int size : { 6, 7 })
    {
      filter->SetDimensions(size, size);
      filter->Update();
    }
    return filter->GetNumberOfTriangulations() - before;
  };
  vtkTypeInt64 least = 0; // at which it is kept
  filter->SetInputData(points);
  for (vtkTypeInt64 step = 1 << 14; step > 0; step /= 2)
  {
    least += countWith(least + step) == 2 ? step : 0;
  }
  ++least;
  EXPECT_EQ(countWith(least), 1);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, points);
  filter->SetInputDataObject(blocks);
  EXPECT_EQ(countWith(least), 2);
  EXPECT_EQ(countWith(least + 480), 1); // 20000 points of three numbers
}

/// Without a kept triangulation nothing of the input is held.
TEST(InterpolationMemory, NothingIsHeldThatIsNotKept)
{
  using Setting = std::function<void(vtkAdaptiveHilbertDelaunay2D*)>;
  const Setting off = [](auto* f) { f->KeepTriangulationOff(); };
  const Setting small = [](auto* f) { f->SetReuseLimit(10); };
  for (const Setting& set : { off, small })
  {
    WatchedInterpolation filter;
    set(filter->GetTriangulation());
    vtkSmartPointer<vtkPolyData> points = cloud(), source = makeSource({ { 0, 1, 2 } }, {});
    addArray<vtkUnsignedCharArray>(
      points, vtkDataSetAttributes::GhostArrayName(), [](vtkIdType) { return 0.0; });
    const vtkWeakPointer<vtkDataArray> arrays[] = { points->GetPoints()->GetData(),
      points->GetPointGhostArray(), source->GetLines()->GetConnectivityArray() };
    filter->SetInputData(points);
    filter->SetSourceData(source);
    filter->SetMethodToNearest();
    filter->Update();
    EXPECT_GT(filter->GetNumberOfValidPlaces(), 0);
    filter->SetInputDataObject(0, nullptr);
    filter->SetInputDataObject(2, nullptr);
    points = source = nullptr;
    for (const auto& array : arrays)
    {
      EXPECT_EQ(array, nullptr);
    }
  }
}

/// Neither are settings of others that were changed before the transform that both have.
TEST(InterpolationMemory, OtherSettingsWithTheSameTransformAreSeen)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> whole, parts;
  vtkNew<vtkTransform> transform;
  parts->SetMaximumEdgeLength(0.02);
  for (vtkAdaptiveHilbertDelaunay2D* settings : { whole.Get(), parts.Get() })
  {
    settings->SetProjectionPlaneMode(VTK_SET_TRANSFORM_PLANE);
    settings->SetTransform(transform);
  }
  transform->RotateZ(30);
  WatchedInterpolation filter;
  filter->SetInputData(cloud());
  const auto countWith = [&](vtkAdaptiveHilbertDelaunay2D* settings)
  {
    filter->SetTriangulation(settings);
    filter->Update();
    return filter->GetNumberOfValidPlaces();
  };
  const vtkIdType all = countWith(whole);
  EXPECT_LT(countWith(parts), all / 2);
  EXPECT_EQ(countWith(whole), all);
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 3);
  transform->RotateZ(30);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 4);
}

/// The kept triangulation is not used for other points.
TEST(InterpolationMemory, PointsThatChangedAreTriangulatedAnew)
{
  auto points = cloud(200);
  WatchedInterpolation filter;
  filter->SetInputData(points);
  filter->SetPlacesData(makeCloud({ { 0.5, 0.5, 0 } }));
  filter->Update();
  const auto before = numbersOf(filter->GetOutput(), "Elevation");
  // in place, and only the filter is notified
  for (vtkIdType i = 0; i < 200; ++i)
  {
    const double* p = points->GetPoint(i);
    points->GetPoints()->SetPoint(i, p[0], p[1], 100.0);
  }
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 2);
  EXPECT_NEAR(numbersOf(filter->GetOutput(), "Elevation")[0], 100.0, 1e-9);
  // the array that the kept triangulation borrows moves
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(points);
  points->GetPoints()->SetNumberOfPoints(200000);
  points->GetPoints()->SetNumberOfPoints(10);
  filter->SetInputData(copy);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 3);
  EXPECT_NEAR(numbersOf(filter->GetOutput(), "Elevation")[0], 100.0, 1e-9);
  EXPECT_NE(before[0], 100.0);
}

TEST(InterpolationMemory, MemoryIsRefusedWithFigures)
{
  WatchedInterpolation filter;
  filter->SetInputData(cloud());
  filter->SetDimensions(2147483647, 2147483647);
  filter->Update();
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_NE(
    filter.Said->Errors[0].find("4.61168601e+18 places from 1000 points"), std::string::npos)
    << filter.Said->Errors[0];
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 0);
  EXPECT_GT(filter->GetMemoryEstimate(), vtkTypeInt64(1) << 50);
  filter->SetDimensions(1000, 1000);
  filter->GetTriangulation()->SetMemoryLimit(2000);
  filter->Update();
  ASSERT_EQ(filter.Said->Errors.size(), 2u);
  EXPECT_NE(
    filter.Said->Errors[1].find("MemoryLimit of Triangulation allows 2.04 MB"), std::string::npos);
  const vtkTypeInt64 estimate = filter->GetMemoryEstimate();
  EXPECT_GT(estimate, 8000);
  EXPECT_LT(estimate, 20000);
  filter->GetTriangulation()->SetMemoryLimit(estimate - 1);
  filter->Update();
  EXPECT_EQ(filter.Said->Errors.size(), 3u);
  filter->GetTriangulation()->SetMemoryLimit(estimate);
  filter->Update();
  EXPECT_EQ(filter.Said->Errors.size(), 3u);
  EXPECT_EQ(filter->GetNumberOfPlaces(), 1000000);
  EXPECT_EQ(filter->GetMemoryEstimate(), estimate);
}

/// Each array by the numbers read for points and made for places, whichever its type; and other
/// memory for each place.
TEST(InterpolationMemory, EachArrayIsEstimatedByItsBytes)
{
  constexpr double kPoints = 5000, kPlaces = 300 * 300;
  using Add = std::function<void(vtkPolyData*)>;
  WatchedInterpolation filter;
  filter->SetDimensions(300, 300);
  const auto estimateOf = [&](const Add& add)
  {
    auto points = cloud(std::size_t(kPoints));
    add(points);
    filter->SetInputData(points);
    filter->Update();
    return 1024.0 * double(filter->GetMemoryEstimate());
  };
  const auto make = [](auto array, int components)
  {
    return Add(
      [array, components](vtkPolyData* points)
      {
        auto made = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
        made->SetName("more");
        made->SetNumberOfComponents(components);
        made->SetNumberOfTuples(points->GetNumberOfPoints());
        made->Fill(1.0);
        points->GetPointData()->AddArray(made);
      });
  };
  vtkNew<vtkDoubleArray> doubles;
  vtkNew<vtkFloatArray> floats;
  vtkNew<vtkIntArray> ints;
  vtkNew<vtkUnsignedCharArray> bytes;
  const auto expectMore = [&](const Add& add, double perPoint, double perPlace)
  {
    const double more = estimateOf(add) - estimateOf([](vtkPolyData*) {});
    EXPECT_NEAR(more, perPoint * kPoints + perPlace * kPlaces, 3 * 1024.0);
  };
  for (const int method : { 0, 1 })
  {
    SCOPED_TRACE(method);
    filter->SetMethod(method);
    // by points: the values in the order of the vertices, and those that must be read
    expectMore(make(doubles.Get(), 1), 8, 8);
    expectMore(make(doubles.Get(), 3), 24, 24);
    expectMore(make(floats.Get(), 2), 16 + 16, 2 * (8 + 4)); // made as doubles
    expectMore(make(ints.Get(), 2), 16 + 16, 16);
  }
  filter->SetMethod(0);
  filter->GenerateGradientsOn();
  expectMore(make(doubles.Get(), 1), 8, 8 + 16);
  expectMore(make(floats.Get(), 1), 8 + 8, 3 * (8 + 4));
  expectMore(make(doubles.Get(), 2), 16, 16); // none has a slope
  filter->GenerateGradientsOff();
  filter->SetMethod(vtkAdaptiveHilbertInterpolation2D::NEAREST); // values are gathered as they are
  expectMore(make(doubles.Get(), 2), 0, 16);
  expectMore(make(floats.Get(), 3), 0, 12);
  expectMore(make(ints.Get(), 1), 0, 4);
  expectMore(make(bytes.Get(), 3), 0, 3);
  const double nearest = estimateOf([](vtkPolyData*) {});
  filter->SetMethod(0);
  const double plain = estimateOf([](vtkPolyData*) {});
  // the number of each point, and of the nearest one at each place
  EXPECT_NEAR(nearest - plain, 8 * kPoints + 8 * kPlaces, 3 * 1024.0);
  filter->SetOutputTypeToSurface();
  EXPECT_NEAR(estimateOf([](vtkPolyData*) {}) - plain, 24 * kPlaces, 3 * 1024.0);
  filter->SetOutputTypeToImage();
  filter->SetOutsideToNearestVertex();
  const double outside = estimateOf([](vtkPolyData*) {}) - plain;
  EXPECT_GE(outside, 24 * kPlaces);
  EXPECT_LE(outside, 120 * kPlaces + 40 * kPoints);
  filter->SetOutsideToNoValue();
  filter->SetDimensions(600, 300); // height, mask and mark
  EXPECT_NEAR(estimateOf([](vtkPolyData*) {}) - plain, 10 * kPlaces, 4 * 1024.0);
  filter->SetPlacesData(makeCloud(scatteredPoints(std::size_t(kPlaces), 3))); // found by their keys
  const double places = estimateOf([](vtkPolyData*) {}) - plain;
  EXPECT_GE(places, 16 * kPlaces);
  EXPECT_LE(places, 64 * kPlaces);
}

/// Reported when blocks are merged for values, not when the raster is announced.
TEST(InterpolationMemory, BlocksWithoutMemoryAreOneError)
{
  WatchedInterpolation filter;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud());
  blocks->SetBlock(1, cloud(500, 2.0));
  filter->SetInputData(blocks);
  filter->GetTriangulation()->SetMemoryLimit(1);
  filter->Update();
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_NE(filter.Said->Errors[0].find("Merging blocks of 1500 points"), std::string::npos);
}

/// A transform that counts the points it moves.
class Counted : public vtkSphericalTransform
{
public:
  static Counted* New() { VTK_STANDARD_NEW_BODY(Counted); }
  vtkTypeMacro(Counted, vtkSphericalTransform);
  vtkAbstractTransform* MakeTransform() override { return Counted::New(); }
  std::size_t Asked = 0;

protected:
  void ForwardTransformPoint(const double in[3], double out[3]) override
  {
    ++this->Asked;
    this->vtkSphericalTransform::ForwardTransformPoint(in, out);
  }
};

/// The bounds of the raster are not computed either without memory for that.
TEST(InterpolationMemory, NoPointIsMovedWhereThereIsNoMemory)
{
  vtkNew<Counted> transform;
  WatchedInterpolation filter;
  filter->SetInputData(cloud());
  filter->GetTriangulation()->SetProjectionPlaneMode(VTK_SET_TRANSFORM_PLANE);
  filter->GetTriangulation()->SetTransform(transform);
  filter->GetTriangulation()->SetMemoryLimit(20); // a copy takes 24 KiB
  filter->Update();
  EXPECT_EQ(transform->Asked, 0u);
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_NE(filter.Said->Errors[0].find("65536 places from 1000 points"), std::string::npos);
  EXPECT_GT(filter->GetMemoryEstimate(), 50);
  filter->SetRasterSizeToByCellSize();
  filter->Update();
  EXPECT_EQ(transform->Asked, 0u);
  ASSERT_EQ(filter.Said->Errors.size(), 2u);
  EXPECT_NE(filter.Said->Errors[1].find("the places of a raster from 1000"), std::string::npos);
  filter->GetTriangulation()->SetMemoryLimit(0);
  filter->Update();
  EXPECT_GE(transform->Asked, 2000u);
  EXPECT_EQ(filter.Said->Errors.size(), 2u);
}

#if defined(__linux__)
/// Memory that is held from one execution to the next is there for it, beside what is free.
TEST(InterpolationMemory, WhatIsHeldCountsAsThere)
{
  auto points = cloud(300000);
  for (const bool isHeld : { false, true })
  {
    WatchedInterpolation filter;
    filter->SetInputData(points);
    filter->SetDimensions(100, 100);
    filter->GetTriangulation()->KeepTriangulationOff(); // only the memory of one
    filter->GetTriangulation()->SetReuseLimit(isHeld ? VTK_INT_MAX : 0);
    filter->Update();
    filter->Modified();
    ASSERT_EQ(filter->GetNumberOfTriangulations(), 1);
    {
      const auto needed = 1024 * static_cast<std::size_t>(filter->GetMemoryEstimate());
      AddressSpaceLimit limit(needed / 4 * 3);
      ASSERT_TRUE(limit.Works);
      filter->Update();
    }
    EXPECT_EQ(filter->GetNumberOfTriangulations(), isHeld ? 2 : 1);
    EXPECT_EQ(filter.Said->Errors.size(), isHeld ? 0u : 1u);
  }
}
#endif

} // namespace
