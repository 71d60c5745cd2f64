// SPDX-License-Identifier: BSD-3-Clause
//
// The interpolation in VTK's pipeline: information for downstream filters, abort, threads,
// settings.
#include "PipelineSupport.h"
#include "ProgressWatch.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"

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

/// Type and components of the scalars, which are those of the points or heights.
TEST(InterpolationPipeline, FiltersBehindKnowTheScalars)
{
  auto points = cloud();
  vtkNew<vtkFloatArray> floats;
  vtkNew<vtkIntArray> ints;
  vtkDataArray* const arrays[] = { floats, ints };
  for (vtkDataArray* array : arrays)
  {
    array->SetName(array->GetClassName());
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(points->GetNumberOfPoints());
    array->Fill(1.0);
    points->GetPointData()->AddArray(array);
  }
  WatchedInterpolation filter;
  filter->SetInputData(points);
  for (const char* name : { "", "vtkFloatArray", "vtkIntArray" })
  {
    for (const int method : { Filter::LINEAR, Filter::NEAREST })
    {
      points->GetPointData()->SetActiveScalars(name);
      filter->SetMethod(method);
      filter->UpdateInformation();
      vtkInformation* const announced = vtkDataObject::GetActiveFieldInformation(
        filter->GetOutputInformation(0), vtkDataObject::FIELD_ASSOCIATION_POINTS,
        vtkDataSetAttributes::SCALARS);
      ASSERT_NE(announced, nullptr);
      filter->Update();
      vtkDataArray* const made = filter->GetOutput()->GetPointData()->GetScalars();
      ASSERT_NE(made, nullptr);
      EXPECT_EQ(announced->Get(vtkDataObject::FIELD_ARRAY_TYPE()), made->GetDataType());
      EXPECT_EQ(
        announced->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()), made->GetNumberOfComponents());
      EXPECT_EQ(made->GetNumberOfComponents(), *name ? 3 : 1);
    }
  }
}

/// An impossible raster is not announced either.
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
  filter->SetCellSize(0, 1);
  behind->Update();
  EXPECT_EQ(filter.Said->Errors.size(), 3u);
  EXPECT_TRUE(behind->HadAll);
  filter->SetCellSize(0.1, 0.1);
  behind->Update();
  EXPECT_EQ(behind->GetOutput()->GetNumberOfPoints(), 100);
}

/// An announced raster that fails: downstream filters do not run, of any kind, and the next
/// successful update is correct.
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

/// Aborted at any progress: no output, no message, and correct afterwards.
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

/// Nor at the last report, when all places have their values.
TEST(InterpolationPipeline, AbortedBehindTheLastPlace)
{
  for (const int method : { 0, 1, 2, 3 })
  {
    WatchedInterpolation filter;
    vtkNew<ProgressWatch> watch;
    filter->SetInputData(cloud(200));
    filter->SetMethod(method);
    filter->SetDimensions(120, 140);
    filter->AddObserver(vtkCommand::ProgressEvent, watch);
    watch->AbortAt = 1.0;
    filter->Update();
    EXPECT_LE(watch->SeenAfterAbort, 1); // that of newer pipelines
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
    EXPECT_EQ(filter->GetNumberOfPlaces(), 0);
    EXPECT_TRUE(filter.Said->Errors.empty());
  }
}

/// Counts the polls for an abort.
class AskedInterpolation : public Filter
{
public:
  static AskedInterpolation* New() { VTK_STANDARD_NEW_BODY(AskedInterpolation); }
  vtkTypeMacro(AskedInterpolation, Filter);
  int GetAbortExecute() override
  {
    ++this->Asked;
    return this->Superclass::GetAbortExecute();
  }
  int Asked = 0;
};

/// Each array of numbers that may be NaN is looked through, where a place lacks a value.
TEST(InterpolationPipeline, AbortsAreHeardWhileMissingValuesAreLookedUp)
{
  constexpr vtkIdType kPoints = 200000, kSteps = kPoints >> 14;
  auto points = cloud(kPoints);
  vtkNew<AskedInterpolation> filter;
  vtkNew<Messages> said; // of places without a value
  said->Watch(filter);
  double place[3];
  points->GetPoint(7, place);
  filter->SetPlacesData(makeCloud({ { place[0], place[1], 0 } }));
  filter->GetTriangulation()->SetNumberOfThreads(1);
  const auto asked = [&](double value)
  {
    addArray<vtkDoubleArray>(points, "a", [value](vtkIdType i) { return i == 7 ? value : 1.0; });
    points->Modified();
    filter->SetInputData(points);
    filter->Asked = 0;
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfPlacesWithoutValue(), std::isnan(value) ? 1 : 0);
    return filter->Asked;
  };
  asked(1.0); // triangulates
  const int without = asked(2.0);
  EXPECT_GE(asked(kNaN), without + 2 * kSteps); // of heights and array
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
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
  filter->SetDimensions(1, -5);
  EXPECT_EQ(filter->GetDimensions()[0], 1);
  EXPECT_EQ(filter->GetDimensions()[1], 0);
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
  std::string header;
  for (const char* name : { "2D", "Algorithm" })
  {
    std::ifstream file(
      AHD_FILTERS_DIRECTORY "/vtkAdaptiveHilbertInterpolation" + std::string(name) + ".h");
    header.append(std::istreambuf_iterator<char>(file), {});
  }
  const std::regex getter("vtkGet(Object|Vector.)?Macro\\((\\w+),");
  int count = 0;
  for (std::sregex_iterator i(header.begin(), header.end(), getter), end; i != end; ++i, ++count)
  {
    EXPECT_NE(text.str().find(" " + (*i)[2].str() + ": "), std::string::npos) << (*i)[2];
  }
  EXPECT_GT(count, 18);
}

} // namespace
