// SPDX-License-Identifier: BSD-3-Clause
//
// Interpolation on a surface whose own triangulation is kept: no second one, and the same
// bytes as if the interpolation had been given points and settings itself.
#include "ConstraintTestSupport.h"
#include "SampleTestSupport.h"

#include "vtkCellArray.h"
#include "vtkMultiBlockDataSet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <thread>

namespace
{

using namespace ahdtest;
using Delaunay = vtkAdaptiveHilbertDelaunay2D;
using Filter = vtkAdaptiveHilbertInterpolation2D;
using Setting = std::function<void(Delaunay*)>;

void askForRaster(Filter* filter)
{
  filter->UseBoundsOn();
  filter->SetBounds(-0.1, 1.1, -0.6, 1.1);
  filter->SetDimensions(90, 80);
}

bool areSameBytes(const std::vector<double>& a, const std::vector<double>& b)
{
  return !a.empty() && a.size() == b.size() &&
    std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

bool areSame(vtkDataSet* a, vtkDataSet* b)
{
  bool same = true;
  for (const char* name : { "Elevation", "a", "vtkValidPointMask" })
  {
    same = same && areSameBytes(numbersOf(a, name), numbersOf(b, name));
  }
  return same;
}

/// The result of interpolating directly.
vtkSmartPointer<vtkImageData> directly(
  vtkPolyData* cloud, int method, const Setting& set = nullptr, vtkPolyData* source = nullptr)
{
  WatchedInterpolation filter;
  vtkNew<Messages> said; // of constraints that cross
  said->Watch(filter->GetTriangulation());
  filter->SetInputData(cloud);
  filter->SetSourceData(source);
  if (set)
  {
    set(filter->GetTriangulation());
  }
  askForRaster(filter.Filter);
  filter->SetMethod(method);
  filter->Update();
  EXPECT_GT(filter->GetNumberOfValidPlaces(), 300);
  return vtkImageData::SafeDownCast(filter->GetOutput());
}

/// A surface, by the filter that made it, and an interpolation on it.
struct Surface
{
  explicit Surface(vtkPolyData* cloud, const Setting& set = nullptr, vtkPolyData* source = nullptr)
  {
    this->Said->Watch(this->Maker);
    this->Maker->SetInputData(cloud);
    this->Maker->SetSourceData(source);
    if (set)
    {
      set(this->Maker);
    }
    askForRaster(this->Sampler.Filter);
    this->Update();
  }
  /// As pvserver passes it on.
  void Update()
  {
    this->Maker->Update();
    this->Copy->ShallowCopy(this->Maker->GetOutput());
    this->Sampler->SetInputData(this->Copy);
  }
  vtkDataSet* Sample(int method)
  {
    this->Sampler->SetMethod(method);
    this->Sampler->Update();
    EXPECT_TRUE(this->Sampler.Said->Errors.empty());
    return vtkDataSet::SafeDownCast(this->Sampler->GetOutputDataObject(0));
  }
  vtkIdType Triangulations() { return this->Sampler->GetNumberOfTriangulations(); }

  vtkNew<Delaunay> Maker;
  vtkNew<Messages> Said;
  vtkNew<vtkPolyData> Copy;
  WatchedInterpolation Sampler;
};

void expectTheSame(const Setting& set, vtkPolyData* source = nullptr)
{
  auto cloud = hills();
  Surface surface(cloud, set, source);
  for (const int method :
    { Filter::LINEAR, Filter::NATURAL_NEIGHBOR, Filter::LAPLACE, Filter::NEAREST })
  {
    EXPECT_TRUE(areSame(directly(cloud, method, set, source), surface.Sample(method))) << method;
  }
  EXPECT_EQ(surface.Triangulations(), 0);
}

TEST(InterpolationKept, OfPointsAlone)
{
  expectTheSame(nullptr);
  expectTheSame([](Delaunay* f) { f->SetDuplicatePolicyToHighestZ(); });
  expectTheSame([](Delaunay* f) { f->SetDuplicatePolicyToMeanZ(); });
  expectTheSame([](Delaunay* f) { f->BoundingTriangulationOn(); });
  expectTheSame([](Delaunay* f) { f->SetInsertionLimit(900); });
}

TEST(InterpolationKept, WithTrianglesLeftOut)
{
  expectTheSame([](Delaunay* f) { f->SetMaximumEdgeLength(0.06); });
  expectTheSame([](Delaunay* f) { f->SetAlpha(0.03); });
  expectTheSame([](Delaunay* f) { f->SetTolerance(0.01); });
  expectTheSame([](Delaunay* f) { f->SetRimToTrimmed(); });
}

/// Natural neighbours end at exactly the constraints.
TEST(InterpolationKept, WithConstraints)
{
  const auto lines = makeSource({ { 0, 700 }, { 5, 900, 30 } }, {});
  expectTheSame(nullptr, lines);
  const auto loop = makeSource({ { 0, 700 }, { 5, 900, 30 } }, { { 11, 222, 333, 444 } });
  expectTheSame(nullptr, loop);
  expectTheSame([](Delaunay* f) { f->SetCrossingModeToSplit(); }, loop);
  expectTheSame([](Delaunay* f) { f->SetAlpha(0.1); }, lines);
}

TEST(InterpolationKept, IsGoneWithTheFilterOrItsLimit)
{
  auto cloud = hills();
  vtkNew<vtkPolyData> copy;
  {
    vtkNew<Delaunay> maker;
    maker->SetInputData(cloud);
    maker->Update();
    copy->ShallowCopy(maker->GetOutput());
  }
  WatchedInterpolation filter;
  filter->SetInputData(copy);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
  Surface limited(cloud, [](Delaunay* f) { f->SetReuseLimit(100); }); // KiB; 600 are needed
  limited.Sample(Filter::LINEAR);
  EXPECT_EQ(limited.Triangulations(), 1);
}

/// A filter that executes anew takes it back from earlier surfaces.
TEST(InterpolationKept, IsThatOfTheLastExecution)
{
  auto cloud = hills();
  Surface surface(cloud);
  surface.Sample(Filter::LINEAR);
  surface.Maker->SetMaximumEdgeLength(0.06);
  surface.Maker->Update();
  surface.Sample(Filter::NATURAL_NEIGHBOR); // the copy is the surface of before
  EXPECT_EQ(surface.Triangulations(), 1);
  surface.Update();
  const Setting set = [](Delaunay* f) { f->SetMaximumEdgeLength(0.06); };
  EXPECT_TRUE(areSame(directly(cloud, Filter::LINEAR, set), surface.Sample(Filter::LINEAR)));
  EXPECT_EQ(surface.Triangulations(), 1);
}

/// Changed points or triangles, with and without Modified().
TEST(InterpolationKept, ChangedSurfacesAreOthers)
{
  auto cloud = hills();
  Surface lifted(cloud);
  double p[3];
  lifted.Copy->GetPoint(700, p);
  lifted.Copy->GetPoints()->SetPoint(700, p[0], p[1], p[2] + 1.0); // not Modified()
  lifted.Sample(Filter::LINEAR);
  EXPECT_EQ(lifted.Triangulations(), 1);

  Surface moved(cloud, [](Delaunay* f) { f->SetDuplicatePolicyToMeanZ(); }); // has own points
  ASSERT_NE(moved.Copy->GetPoints()->GetData(), cloud->GetPoints()->GetData());
  cloud->GetPoints()->SetPoint(700, p);
  moved.Sample(Filter::LINEAR);
  EXPECT_EQ(moved.Triangulations(), 1);

  Surface fewer(cloud);
  vtkNew<vtkPolyData> deep;
  deep->DeepCopy(fewer.Copy);
  fewer.Sampler->SetInputData(deep);
  fewer.Sample(Filter::LINEAR);
  EXPECT_EQ(fewer.Triangulations(), 1);

  Surface touched(cloud);
  touched.Copy->GetPolys()->GetConnectivityArray()->Modified();
  touched.Sample(Filter::LINEAR);
  EXPECT_EQ(touched.Triangulations(), 1);
}

/// Another plane than x, y: raster and places follow the settings of the interpolation.
TEST(InterpolationKept, InOtherPlanesThereIsNone)
{
  auto cloud = makeCloud(onPlane(scatteredPoints(500)));
  for (const bool isFitted : { false, true })
  {
    Surface surface(cloud,
      [isFitted](Delaunay* f)
      { f->SetProjectionPlaneMode(isFitted ? VTK_BEST_FITTING_PLANE : VTK_DELAUNAY_XY_PLANE); });
    surface.Sampler->GetTriangulation()->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
    surface.Sampler->UseBoundsOff();
    surface.Sampler->Update();
    EXPECT_EQ(surface.Triangulations(), 1);
  }
}

/// Earlier points are not held when their surface is passed on for equal ones.
TEST(InterpolationKept, HoldsNoOldInput)
{
  auto cloud = hills();
  Surface surface(cloud);
  std::vector<vtkSmartPointer<vtkDataArray>> arrays;
  for (int i = 0; i < 2; ++i)
  {
    arrays.emplace_back(cloud->GetPoints()->GetData());
    cloud->SetPoints(hills()->GetPoints());
    surface.Update();
  }
  EXPECT_EQ(surface.Maker->GetNumberOfTriangulations(), 2); // the third execution passes on
  EXPECT_EQ(arrays[0]->GetReferenceCount(), 1);
  EXPECT_EQ(arrays[1]->GetReferenceCount(), 1);
  EXPECT_TRUE(areSame(directly(cloud, Filter::LINEAR), surface.Sample(Filter::LINEAR)));
}

/// All blocks of the places are interpolated on the lent triangulation.
TEST(InterpolationKept, ForBlocksOfPlaces)
{
  auto cloud = hills();
  Surface surface(cloud);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeCloud(scatteredPoints(300, 4)));
  blocks->SetBlock(1, makeCloud(scatteredPoints(200, 5)));
  WatchedInterpolation direct;
  direct->SetInputData(cloud);
  for (Filter* filter : { direct.Filter.Get(), surface.Sampler.Filter.Get() })
  {
    filter->SetInputDataObject(1, blocks);
    filter->SetMethodToNaturalNeighbor();
    filter->Update();
  }
  for (unsigned k = 0; k < 2; ++k)
  {
    const auto block = [k](Filter* filter)
    {
      auto* all = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
      return vtkDataSet::SafeDownCast(all->GetBlock(k));
    };
    EXPECT_TRUE(areSame(block(direct.Filter), block(surface.Sampler.Filter)));
  }
  EXPECT_EQ(surface.Triangulations(), 0);
  surface.Sampler->SetInputConnection(1, nullptr);
  surface.Sample(Filter::LINEAR);
  EXPECT_EQ(surface.Triangulations(), 0); // it was returned
}

/// An aborted interpolation returns it.
TEST(InterpolationKept, IsGivenBack)
{
  auto cloud = hills();
  Surface surface(cloud);
  surface.Sampler->SetBounds(1, 0, 0, 1); // no area: an error
  surface.Sampler->Update();
  ASSERT_EQ(surface.Sampler.Said->Errors.size(), 1u);
  surface.Sampler.Said->Errors.clear();
  askForRaster(surface.Sampler.Filter);
  surface.Sample(Filter::LINEAR);
  EXPECT_EQ(surface.Triangulations(), 0);
}

/// Interpolations at the same time, while the filter that made the surface executes anew: one that
/// finds the triangulation lent or gone makes one, and all have the same values.
TEST(InterpolationKept, ManyAtATime)
{
  auto cloud = hills();
  const auto expected = directly(cloud, Filter::LINEAR);
  for (int round = 0; round < 20; ++round)
  {
    Surface surface(cloud);
    std::vector<vtkSmartPointer<Filter>> filters;
    for (int k = 0; k < 3; ++k)
    {
      vtkNew<vtkPolyData> copy;
      copy->ShallowCopy(surface.Copy);
      filters.push_back(vtkSmartPointer<Filter>::New());
      filters.back()->SetInputData(copy);
      filters.back()->GetTriangulation()->SetNumberOfThreads(1);
      askForRaster(filters.back());
    }
    surface.Maker->SetNmax(51);
    std::vector<std::thread> threads;
    for (Filter* filter : filters)
    {
      threads.emplace_back([filter] { filter->Update(); });
    }
    surface.Maker->Update();
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    for (Filter* filter : filters)
    {
      vtkDataSet* found = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
      EXPECT_EQ(numbersOf(expected, "vtkValidPointMask"), numbersOf(found, "vtkValidPointMask"));
    }
  }
}

} // namespace
