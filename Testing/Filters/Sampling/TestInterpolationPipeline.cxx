// SPDX-License-Identifier: BSD-3-Clause
//
// The interpolation in VTK's pipeline: what filters behind are told, abort, threads, settings.
#include "ProgressWatch.h"
#include "SampleTestSupport.h"

#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
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
  bool HadAll = true;       ///< each time, all that it asked for
  bool HadItsPlace = false; ///< the last time, origin and spacing that it was told

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
    bool isThere = true;
    for (int k = 0; k < 6; k += 2)
    {
      isThere = isThere &&
        (wanted[k] > wanted[k + 1] || (there[k] <= wanted[k] && wanted[k + 1] <= there[k + 1]));
    }
    this->HadAll = this->HadAll && isThere &&
      output->GetScalarType() ==
        (input->GetPointData()->GetScalars() ? input->GetPointData()->GetScalars()->GetDataType()
                                             : output->GetScalarType());
    this->HadItsPlace = input->GetNumberOfPoints() == 0 ||
      (std::equal(output->GetOrigin(), output->GetOrigin() + 3, input->GetOrigin()) &&
        std::equal(output->GetSpacing(), output->GetSpacing() + 3, input->GetSpacing()));
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
    EXPECT_TRUE(behind->HadItsPlace);
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
  double EmptyAt = -1.0; ///< the time at which there are no points
  double Begin = 0.0;    ///< where they begin, times the time

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
    if (time != this->EmptyAt)
    {
      output->ShallowCopy(cloud(1000, 1.0 + time));
      vtkPoints* const points = output->GetPoints();
      for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
      {
        double p[3];
        points->GetPoint(i, p);
        points->SetPoint(i, p[0] + this->Begin * time, p[1], p[2]);
      }
    }
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
}

/// VTK asks for extents before there are data, and filters behind cannot be told of others then.
/// All cells that they ask for are there.
TEST(InterpolationPipeline, FiltersBehindHaveWhatTheyWereToldAtEachTime)
{
  vtkNew<Moving> moving;
  WatchedInterpolation filter;
  vtkNew<Behind> behind;
  moving->EmptyAt = 1.5;
  filter->SetInputConnection(moving->GetOutputPort());
  filter->SetRasterSizeToByCellSize();
  filter->SetCellSize(0.1, 0.1);
  behind->SetInputConnection(filter->GetOutputPort());
  const auto expect = [&](vtkIdType places, vtkIdType pixels)
  {
    EXPECT_EQ(filter->GetNumberOfPlaces(), places);
    EXPECT_EQ(behind->GetOutput()->GetNumberOfPoints(), pixels);
    EXPECT_TRUE(behind->HadAll);
    EXPECT_TRUE(filter.Said->Errors.empty());
    EXPECT_TRUE(filter.PipelineSaid->Errors.empty());
  };
  behind->UpdateTimeStep(1.0);
  behind->Update();
  expect(400, 400);
  behind->UpdateTimeStep(2.0); // larger: those that it was told are a part of it
  expect(900, 400);
  behind->Update();
  expect(900, 900);
  behind->UpdateTimeStep(0.0); // smaller: cells beyond the points have no value
  expect(900, 900);
  EXPECT_LT(filter->GetNumberOfValidPlaces(), 101);
  EXPECT_GT(filter->GetNumberOfValidPlaces(), 80);
  behind->Update();
  expect(100, 100);
  behind->UpdateTimeStep(1.5); // nothing says where it is
  expect(100, 100);
  EXPECT_EQ(filter->GetNumberOfValidPlaces(), 0);
  EXPECT_TRUE(behind->HadItsPlace);
  filter->UseBoundsOn();
  for (const double time : { 0.0, 2.0, 1.0 })
  {
    behind->UpdateTimeStep(time);
    expect(100, 100);
    EXPECT_TRUE(behind->HadItsPlace);
  }
}

/// As many cells somewhere else: filters for images place them where they were told, which is said
/// once, and are right from the next update on.
TEST(InterpolationPipeline, AnotherPlaceIsSaidOnce)
{
  vtkNew<Moving> moving;
  moving->Begin = 5.0;
  WatchedInterpolation filter;
  vtkNew<Behind> behind;
  filter->SetInputConnection(moving->GetOutputPort());
  behind->SetInputConnection(filter->GetOutputPort());
  for (const double time : { 0.0, 1.0, 2.0 })
  {
    behind->UpdateTimeStep(time);
    EXPECT_EQ(behind->HadItsPlace, time == 0.0);
    EXPECT_EQ(filter.Said->Warnings.size(), time == 0.0 ? 0u : 1u);
    behind->Update();
    EXPECT_TRUE(behind->HadItsPlace);
  }
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("UseBounds"), std::string::npos);
  WatchedInterpolation alone; // nobody was told anything
  alone->SetInputConnection(moving->GetOutputPort());
  for (const double time : { 0.0, 1.0, 2.0 })
  {
    alone->UpdateTimeStep(time);
    EXPECT_EQ(alone->GetOutput()->GetBounds()[0] > 4.0, time > 0.0);
  }
  EXPECT_TRUE(alone.Said->Warnings.empty());
}

/// An executive whose memory nobody gets again when it is deleted, but is of no use: who follows a
/// pointer to it ends there.
class Tombstone : public vtkStreamingDemandDrivenPipeline
{
public:
  static Tombstone* New() { VTK_STANDARD_NEW_BODY(Tombstone); }
  vtkTypeMacro(Tombstone, vtkStreamingDemandDrivenPipeline);
  static void* operator new(std::size_t size) { return std::malloc(size); }
  static void operator delete(void* memory, std::size_t size) { std::memset(memory, 0xA5, size); }
};

/// VTK's list of consumers keeps those that were deleted while they were connected.
TEST(InterpolationPipeline, FiltersBehindThatWereDeleted)
{
  for (const bool isAnotherThere : { false, true })
  {
    vtkNew<Moving> moving;
    WatchedInterpolation filter;
    filter->SetInputConnection(moving->GetOutputPort());
    filter->SetRasterSizeToByCellSize();
    filter->SetCellSize(0.1, 0.1);
    {
      vtkNew<Behind> behind;
      vtkNew<Tombstone> executive;
      behind->SetExecutive(executive);
      behind->SetInputConnection(filter->GetOutputPort());
      behind->UpdateTimeStep(2.0);
      behind->Update();
      EXPECT_EQ(behind->GetOutput()->GetNumberOfPoints(), 900);
    }
    vtkNew<Behind> another;
    if (isAnotherThere)
    {
      another->SetInputConnection(filter->GetOutputPort());
      another->Update();
    }
    for (const double time : { 1.0, 0.0 })
    {
      filter->UpdateTimeStep(time);
      const vtkIdType own = time == 1.0 ? 400 : 100, before = time == 1.0 ? 900 : 400;
      EXPECT_EQ(filter->GetNumberOfPlaces(), isAnotherThere ? before : own); // what it was told
      filter->Update();
      EXPECT_EQ(filter->GetNumberOfPlaces(), own);
    }
    filter->SetHeightArrayName("vtkValidPointMask"); // an error
    filter->Update();
    EXPECT_EQ(filter.Said->Errors.size(), 1u);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

/// What comes to nothing though it was announced: those behind are not run, whatever they are, and
/// the next update that comes to something is right.
TEST(InterpolationPipeline, NobodyIsRunBehindARasterThatCameToNothing)
{
  for (const bool isAborted : { false, true })
  {
    WatchedInterpolation filter;
    vtkNew<Behind> behind;
    vtkNew<ProgressWatch> watch;
    vtkNew<Messages> quiet;
    quiet->Watch(behind->GetExecutive());
    filter->SetInputData(cloud());
    filter->SetDimensions(30, 20);
    behind->SetInputConnection(filter->GetOutputPort());
    behind->Update();
    ASSERT_EQ(behind->Executed, 1);
    filter->AddObserver(vtkCommand::ProgressEvent, watch);
    if (isAborted)
    {
      watch->AbortAt = 0.5;
      filter->Modified();
    }
    else
    {
      filter->SetHeightArrayName("vtkValidPointMask");
    }
    behind->Update();
    EXPECT_EQ(behind->Executed, 1);
    EXPECT_EQ(filter.Said->Errors.size(), isAborted ? 0u : 1u);
    EXPECT_EQ(filter.PipelineSaid->Errors.size(), 1u) << "VTK says that it ended so";
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    watch->AbortAt = 2.0;
    filter->SetAbortExecute(0);
    filter->SetHeightArrayName("Elevation");
    filter->Modified();
    behind->Update();
    EXPECT_EQ(behind->Executed, 2);
    EXPECT_EQ(behind->GetOutput()->GetNumberOfPoints(), 600);
    EXPECT_TRUE(behind->HadAll);
  }
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
