// SPDX-License-Identifier: BSD-3-Clause
//
// The kept triangulation and the memory of its points: the same array may have the same numbers at
// another address (double buffers, arrays that are emptied and filled again), and the former memory
// belongs to others, which may write to it.
#include "KeptTestSupport.h"
#include "SampleTestSupport.h"

#include "vtkCellArray.h"
#include "vtkIntArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <memory>
#include <vector>

namespace
{

using namespace ahdtest;
using Delaunay = vtkAdaptiveHilbertDelaunay2D;

/// Points on a plane in memory of the test's own, between which their array can be moved.
struct Buffers
{
  Buffers()
  {
    const std::vector<Xyz> xyz = onPlane(scatteredPoints(2000, 31));
    this->Numbers.assign(&xyz[0][0], &xyz[0][0] + 3 * xyz.size());
    this->Array->SetNumberOfComponents(3);
    vtkNew<vtkPoints> points;
    this->Move();
    points->SetData(this->Array);
    this->Cloud->SetPoints(points);
  }

  /// Moves the numbers to other memory; the former memory gets others.
  void Move()
  {
    const auto before = this->Now;
    this->Now = std::make_shared<std::vector<double>>(this->Numbers);
    this->All.push_back(this->Now); // so that none has the address of one before
    this->Array->SetArray(this->Now->data(), static_cast<vtkIdType>(this->Now->size()), 1);
    this->Array->Modified();
    this->Cloud->Modified();
    if (before)
    {
      std::fill(before->begin(), before->end(), -1e6);
    }
  }

  std::vector<double> Numbers;
  std::shared_ptr<std::vector<double>> Now;
  std::vector<std::shared_ptr<std::vector<double>>> All;
  vtkNew<vtkDoubleArray> Array;
  vtkNew<vtkPolyData> Cloud;
};

void expectThePlane(WatchedInterpolation& sampler)
{
  sampler->SetDimensions(40, 30);
  sampler->Modified();
  sampler->Update();
  EXPECT_GT(sampler->GetNumberOfValidPlaces(), 1000);
  EXPECT_LT(farthestFromPlane(sampler->GetOutput()), 1e-9);
}

/// The triangulation lent by the filter, to others and again for its own outputs.
TEST(InterpolationMoved, OnASurfaceWhoseArrayWasMoved)
{
  Buffers buffers;
  vtkNew<Delaunay> maker;
  maker->SetInputData(buffers.Cloud);
  maker->Update();
  WatchedInterpolation before, after;
  for (WatchedInterpolation* sampler : { &before, &after })
  {
    (*sampler)->SetInputData(maker->GetOutput());
  }
  expectThePlane(before);
  EXPECT_EQ(before->GetNumberOfTriangulations(), 0);
  buffers.Move();
  expectThePlane(after);
  EXPECT_EQ(after->GetNumberOfTriangulations(), 1);
}

/// In a pipeline that executes repeatedly, from the third execution on with outputs passed on.
TEST(InterpolationMoved, BehindAFilterThatPassesOn)
{
  Buffers buffers;
  vtkNew<Delaunay> maker;
  maker->SetInputData(buffers.Cloud);
  WatchedInterpolation sampler;
  sampler->SetInputConnection(maker->GetOutputPort());
  for (int step = 0; step < 5; ++step)
  {
    SCOPED_TRACE(step);
    expectThePlane(sampler);
    buffers.Move();
  }
  EXPECT_EQ(maker->GetNumberOfTriangulations(), 2);
}

/// The triangulation kept by the interpolation itself, of points and of their marks.
TEST(InterpolationMoved, OfPointsWhoseArrayWasMoved)
{
  Buffers buffers;
  WatchedInterpolation sampler;
  sampler->SetInputData(buffers.Cloud);
  for (int step = 0; step < 3; ++step)
  {
    SCOPED_TRACE(step);
    expectThePlane(sampler);
    EXPECT_EQ(sampler->GetNumberOfTriangulations(), step + 1);
    buffers.Move();
  }
  expectThePlane(sampler);
  expectThePlane(sampler);
  EXPECT_EQ(sampler->GetNumberOfTriangulations(), 4) << "where nothing moves, it is kept";
}

/// Converted points are kept as a copy, so their address does not matter.
TEST(InterpolationMoved, ConvertedPointsAreKept)
{
  auto cloud = makeCloud(scatteredPoints(500, 34));
  vtkNew<vtkIntArray> numbers;
  numbers->SetNumberOfComponents(3);
  numbers->SetNumberOfTuples(500);
  for (vtkIdType i = 0; i < 500; ++i)
  {
    double p[3];
    cloud->GetPoint(i, p);
    numbers->SetTuple3(i, 1000 * p[0], 1000 * p[1], 1000 * p[2]);
  }
  cloud->GetPoints()->SetData(numbers);
  WatchedInterpolation sampler;
  sampler->SetInputData(cloud);
  for (int size = 10; size < 13; ++size)
  {
    sampler->SetDimensions(size, size);
    sampler->Update();
    EXPECT_GT(sampler->GetNumberOfValidPlaces(), 0);
  }
  EXPECT_EQ(sampler->GetNumberOfTriangulations(), 1);
}

/// Marks, too, are read in place.
TEST(InterpolationMoved, MarksThatWereMoved)
{
  Buffers buffers;
  std::vector<unsigned char> first(2000, 0), second(2000, 0);
  first[5] = second[5] = 1;
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName("vtkGhostType");
  marks->SetArray(first.data(), 2000, 1);
  buffers.Cloud->GetPointData()->AddArray(marks);
  vtkNew<Delaunay> maker;
  maker->SetInputData(buffers.Cloud);
  maker->Update();
  marks->SetArray(second.data(), 2000, 1);
  std::fill(first.begin(), first.end(), 1);
  WatchedInterpolation sampler;
  sampler->SetInputData(maker->GetOutput());
  expectThePlane(sampler);
  EXPECT_EQ(sampler->GetNumberOfTriangulations(), 1);
}

/// One vtkPoints that is emptied and filled again with the same points.
TEST(InterpolationMoved, PointsThatAreFilledAgain)
{
  const std::vector<Xyz> xyz = onPlane(scatteredPoints(3000, 32));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<Delaunay> maker;
  maker->SetInputData(cloud);
  WatchedInterpolation behind, direct;
  behind->SetInputConnection(maker->GetOutputPort());
  direct->SetInputData(cloud);
  std::vector<std::vector<double>> taken; // memory that would be reused otherwise
  for (int step = 0; step < 4; ++step)
  {
    SCOPED_TRACE(step);
    points->Initialize();
    for (int k = 0; k < 30; ++k)
    {
      taken.emplace_back(3 * xyz.size(), 777.0);
    }
    for (const Xyz& p : xyz)
    {
      points->InsertNextPoint(p.data());
    }
    points->Modified();
    cloud->Modified();
    expectThePlane(behind);
    expectThePlane(direct);
  }
}

/// Triangles edited in place, without Modified(), are noticed.
TEST(InterpolationMoved, EditedTrianglesAreOthers)
{
  auto cloud = makeCloud(onPlane(scatteredPoints(500, 33)));
  vtkNew<Delaunay> maker;
  maker->SetInputData(cloud);
  maker->Update();
  vtkDataArray* corners = maker->GetOutput()->GetPolys()->GetConnectivityArray();
  auto* numbers = static_cast<vtkTypeInt32*>(corners->GetVoidPointer(0));
  std::swap_ranges(numbers, numbers + 3, numbers + 3); // the first two triangles: the same surface
  WatchedInterpolation sampler;
  sampler->SetInputData(maker->GetOutput());
  expectThePlane(sampler);
  EXPECT_EQ(sampler->GetNumberOfTriangulations(), 1);
}

} // namespace
