// SPDX-License-Identifier: BSD-3-Clause
//
// The interpolation in VTK's pipeline: what filters behind are told, the triangulation that is
// kept, memory, abort, threads, settings.
#include "ProgressWatch.h"
#include "SampleTestSupport.h"

#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSphericalTransform.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace
{

using namespace ahdtest;
using Filter = vtkAdaptiveHilbertInterpolation2D;
using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkSmartPointer<vtkPolyData> cloud(std::size_t count = 1000, double size = 1.0)
{
  std::vector<Xyz> points = scatteredPoints(count, 17);
  for (Xyz& p : points)
  {
    p = { p[0] * size, p[1] * size, std::sin(5 * p[0]) };
  }
  return makeCloud(points);
}

/// An image filter as VTK's own: it makes its output by what it was told before.
class Behind : public vtkImageAlgorithm
{
public:
  static Behind* New() { VTK_STANDARD_NEW_BODY(Behind); }
  vtkTypeMacro(Behind, vtkImageAlgorithm);
  int Executed = 0;
  bool HadAll = true;

protected:
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    ++this->Executed;
    vtkInformation* const info = outputs->GetInformationObject(0);
    auto* output = vtkImageData::GetData(info);
    auto* input = vtkImageData::GetData(inputs[0]);
    this->AllocateOutputData(output, info, info->Get(Pipeline::UPDATE_EXTENT()));
    int wanted[6], there[6];
    output->GetExtent(wanted);
    input->GetExtent(there);
    this->HadAll = this->HadAll && std::equal(wanted, wanted + 6, there) &&
      output->GetScalarType() ==
        (input->GetPointData()->GetScalars() ? input->GetPointData()->GetScalars()->GetDataType()
                                             : output->GetScalarType()) &&
      (input->GetNumberOfPoints() == 0 ||
        (std::equal(output->GetOrigin(), output->GetOrigin() + 3, input->GetOrigin()) &&
          std::equal(output->GetSpacing(), output->GetSpacing() + 3, input->GetSpacing())));
    return 1;
  }
};

TEST(InterpolationPipeline, FiltersForImagesBehindAreToldTheRaster)
{
  WatchedInterpolation filter;
  vtkNew<Behind> behind;
  auto points = cloud();
  filter->SetInputData(points);
  behind->SetInputConnection(filter->GetOutputPort());
  const auto expectSize = [&](int columns, int rows)
  {
    behind->Update();
    int dimensions[3];
    behind->GetOutput()->GetDimensions(dimensions);
    EXPECT_EQ(dimensions[0], columns);
    EXPECT_EQ(dimensions[1], rows);
    EXPECT_TRUE(behind->HadAll);
  };
  expectSize(256, 256);
  filter->SetDimensions(7, 9);
  expectSize(7, 9);
  filter->SetRasterSizeToByCellSize();
  filter->SetCellSize(0.1, 0.05);
  expectSize(10, 20);
  filter->SetInputData(cloud(1000, 3.0));
  expectSize(30, 60);
  filter->SetCellSize(0.5, 0.5);
  expectSize(6, 6);
  addArray<vtkFloatArray>(points, "f", [](vtkIdType) { return 1.0; });
  points->GetPointData()->SetActiveScalars("f");
  filter->SetInputData(points);
  expectSize(2, 2);
  EXPECT_EQ(behind->GetOutput()->GetScalarType(), VTK_FLOAT);
  filter->UseBoundsOn();
  filter->SetBounds(0, 5, 0, 2);
  expectSize(10, 4);
  const int before = behind->Executed;
  behind->Update();
  EXPECT_EQ(behind->Executed, before);
}

/// What cannot be had is not announced either.
TEST(InterpolationPipeline, FiltersBehindSurviveErrors)
{
  WatchedInterpolation filter;
  vtkNew<Messages> quiet;
  vtkNew<Behind> behind;
  quiet->Watch(behind);
  quiet->Watch(behind->GetExecutive());
  filter->SetInputData(cloud());
  behind->SetInputConnection(filter->GetOutputPort());
  filter->SetDimensions(2147483647, 2147483647);
  behind->Update();
  EXPECT_EQ(filter.Said->Errors.size(), 1u);
  filter->SetDimensions(10, 10);
  filter->GetTriangulation()->SetMemoryLimit(1);
  behind->Update();
  EXPECT_EQ(filter.Said->Errors.size(), 2u);
  filter->GetTriangulation()->SetMemoryLimit(0);
  filter->SetRasterSizeToByCellSize();
  filter->SetCellSize(0, 0);
  behind->Update();
  EXPECT_EQ(filter.Said->Errors.size(), 3u);
  EXPECT_TRUE(behind->HadAll);
  filter->SetCellSize(0.1, 0.1);
  behind->Update();
  EXPECT_EQ(behind->GetOutput()->GetNumberOfPoints(), 100);
}

/// Points that are others at each time.
class Moving : public vtkPolyDataAlgorithm
{
public:
  static Moving* New() { VTK_STANDARD_NEW_BODY(Moving); }
  vtkTypeMacro(Moving, vtkPolyDataAlgorithm);

protected:
  Moving() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const double times[] = { 0.0, 1.0, 2.0 }, range[] = { 0.0, 2.0 };
    outputs->GetInformationObject(0)->Set(Pipeline::TIME_STEPS(), times, 3);
    outputs->GetInformationObject(0)->Set(Pipeline::TIME_RANGE(), range, 2);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* const info = outputs->GetInformationObject(0);
    const double time = info->Has(Pipeline::UPDATE_TIME_STEP())
      ? info->Get(Pipeline::UPDATE_TIME_STEP())
      : 0.0;
    auto* output = vtkPolyData::GetData(outputs);
    output->ShallowCopy(cloud(1000, 1.0 + time));
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }
};

TEST(InterpolationPipeline, EachTimeHasItsRaster)
{
  vtkNew<Moving> moving;
  WatchedInterpolation filter;
  filter->SetInputConnection(moving->GetOutputPort());
  filter->SetRasterSizeToByCellSize();
  filter->SetCellSize(0.1, 0.1);
  for (const double time : { 0.0, 2.0, 1.0, 0.0, 1.0 })
  {
    filter->UpdateTimeStep(time);
    EXPECT_EQ(filter->GetNumberOfPlaces(), vtkIdType(100 * (1 + time) * (1 + time) + 0.5)) << time;
  }
  vtkNew<Behind> behind;
  vtkNew<Messages> quiet;
  quiet->Watch(behind->GetExecutive());
  behind->SetInputConnection(filter->GetOutputPort());
  behind->Update();
  EXPECT_TRUE(behind->HadAll);
  EXPECT_EQ(behind->GetOutput()->GetNumberOfPoints(), 400);
  behind->UpdateTimeStep(2.0); // was told of another raster: it is not run
  EXPECT_TRUE(behind->HadAll);
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_NE(filter.Said->Errors[0].find("UseBounds"), std::string::npos);
  behind->Update();
  EXPECT_TRUE(behind->HadAll);
  EXPECT_EQ(behind->GetOutput()->GetNumberOfPoints(), 900);
  filter->UseBoundsOn();
  filter.Said->Errors.clear();
  for (const double time : { 0.0, 2.0, 1.0 })
  {
    behind->UpdateTimeStep(time);
    EXPECT_EQ(behind->GetOutput()->GetNumberOfPoints(), 100);
  }
  EXPECT_TRUE(behind->HadAll);
  EXPECT_TRUE(filter.Said->Errors.empty());
}

TEST(InterpolationPipeline, NothingIsTriangulatedTwice)
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

/// Neither are settings of others that were changed before the transform that both have.
TEST(InterpolationPipeline, OtherSettingsWithTheSameTransformAreSeen)
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

/// What is kept is not passed for what it is not.
TEST(InterpolationPipeline, PointsThatChangedAreTriangulatedAnew)
{
  auto points = cloud(200);
  WatchedInterpolation filter;
  filter->SetInputData(points);
  filter->SetPlacesData(makeCloud({ { 0.5, 0.5, 0 } }));
  filter->Update();
  const auto before = numbersOf(filter->GetOutput(), "Elevation");
  // where they lie, and nobody is told but the filter
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

TEST(InterpolationPipeline, MemoryIsRefusedWithFigures)
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
    filter.Said->Errors[1].find("MemoryLimit of Triangulation allows 2000 KiB"), std::string::npos);
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

/// Said when it is merged for its values, not when its raster is announced.
TEST(InterpolationPipeline, BlocksWithoutMemoryAreOneError)
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

/// A transform that counts the points it is asked for.
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

/// Where the raster lies is not looked for either where there is no memory for that.
TEST(InterpolationPipeline, NoPointIsMovedWhereThereIsNoMemory)
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

/// Whatever the progress at which it is aborted: nothing put out, no message, and well again.
TEST(InterpolationPipeline, AbortedAtEachStage)
{
  auto points = cloud(40000);
  addArray<vtkFloatArray>(points, "f", [](vtkIdType i) { return double(i); });
  for (const int method : { 0, 1, 3 })
  {
    WatchedInterpolation filter;
    vtkNew<ProgressWatch> watch;
    filter->SetInputData(points);
    filter->SetMethod(method);
    filter->SetOutputTypeToSurface();
    filter->GetTriangulation()->KeepTriangulationOff();
    filter->GetTriangulation()->SetNumberOfThreads(1);
    filter->AddObserver(vtkCommand::ProgressEvent, watch);
    filter->Update();
    const auto whole = numbersOf(filter->GetOutput(), "Elevation");
    EXPECT_GT(watch->Seen.size(), 20u);
    EXPECT_TRUE(std::is_sorted(watch->Seen.begin(), watch->Seen.end()));
    for (const double at : { 0.01, 0.2, 0.4, 0.6, 0.8, 0.95 })
    {
      watch->Seen.clear();
      watch->AbortAt = at;
      watch->Aborted = false;
      filter->Modified();
      filter->Update();
      EXPECT_TRUE(watch->Aborted) << at;
      EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << at;
      EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
      EXPECT_EQ(filter->GetNumberOfPlaces(), 0);
    }
    EXPECT_TRUE(filter.Said->Errors.empty());
    watch->AbortAt = 2.0;
    watch->Aborted = false;
    filter->SetAbortExecute(0);
    filter->Modified();
    filter->Update();
    const auto again = numbersOf(filter->GetOutput(), "Elevation");
    EXPECT_TRUE(again.size() == whole.size() &&
      std::memcmp(again.data(), whole.data(), whole.size() * sizeof(double)) == 0);
  }
}

TEST(InterpolationPipeline, SameBytesWithTwoThreadsAndForShuffledPoints)
{
  std::vector<Xyz> points = scatteredPoints(40000, 23);
  for (Xyz& p : points)
  {
    p[2] = std::sin(20 * p[0]) + p[1];
  }
  std::vector<Xyz> shuffled = points;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(5));
  for (const int method : { 0, 1, 2, 3 })
  {
    std::vector<std::vector<double>> found;
    for (const int threads : { 1, 2 })
    {
      for (const auto* set : { &points, &shuffled })
      {
        WatchedInterpolation filter;
        filter->SetInputData(makeCloud(*set));
        filter->SetMethod(method);
        filter->SetDimensions(200, 300);
        filter->SetOutsideToNearestVertex();
        filter->SetGenerateGradients(method == 0);
        filter->GetTriangulation()->SetNumberOfThreads(threads);
        filter->Update();
        found.push_back(numbersOf(filter->GetOutput(), "Elevation"));
        const auto slopes = numbersOf(filter->GetOutput(), "ElevationGradient");
        found.back().insert(found.back().end(), slopes.begin(), slopes.end());
      }
    }
    for (const auto& numbers : found)
    {
      EXPECT_TRUE(numbers.size() == found[0].size() &&
        std::memcmp(numbers.data(), found[0].data(), numbers.size() * sizeof(double)) == 0)
        << method;
    }
  }
}

TEST(InterpolationPipeline, SettingsAreKeptClampedAndPrinted)
{
  vtkNew<Filter> filter;
  vtkMTimeType before = filter->GetMTime();
  const auto changed = [&]
  {
    const bool is = filter->GetMTime() > before;
    before = filter->GetMTime();
    return is;
  };
  filter->SetMethod(99);
  EXPECT_EQ(filter->GetMethod(), Filter::NEAREST);
  EXPECT_TRUE(changed());
  filter->SetDimensions(0, -5);
  EXPECT_EQ(filter->GetDimensions()[0], 1);
  EXPECT_EQ(filter->GetDimensions()[1], 1);
  EXPECT_TRUE(changed());
  filter->SetNoValue(kNaN); // as it is
  filter->SetHeightArrayName("Elevation");
  EXPECT_FALSE(changed());
  filter->SetNoValue(-1);
  EXPECT_TRUE(changed());
  filter->GetTriangulation()->SetAlpha(3.0);
  EXPECT_TRUE(changed());
  std::ostringstream text;
  filter->Print(text);
  std::ifstream file(AHD_FILTERS_DIRECTORY "/vtkAdaptiveHilbertInterpolation2D.h");
  const std::string header((std::istreambuf_iterator<char>(file)), {});
  const std::regex getter("vtkGet(Object|Vector.)?Macro\\((\\w+),");
  int count = 0;
  for (std::sregex_iterator i(header.begin(), header.end(), getter), end; i != end; ++i, ++count)
  {
    EXPECT_NE(text.str().find(" " + (*i)[2].str() + ": "), std::string::npos) << (*i)[2];
  }
  EXPECT_GT(count, 18);
}

} // namespace
