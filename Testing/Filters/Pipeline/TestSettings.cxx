// SPDX-License-Identifier: BSD-3-Clause
//
// Properties: their ranges, and that none of them changes the result or is changed by a run.
#include "ConstraintTestSupport.h"
#include "FilterTestSupport.h"

#include "vtkFieldData.h"
#include "vtkPlanarPointSource.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

using namespace ahdtest;
using Filter = vtkAdaptiveHilbertDelaunay2D;

TEST(Settings, HaveTheDocumentedDefaultsAndRanges)
{
  vtkNew<Filter> filter;
  EXPECT_EQ(filter->GetInsertionOrder(), Filter::ADAPTIVE_HILBERT);
  EXPECT_EQ(filter->GetNmax(), 50);
  EXPECT_EQ(filter->GetControlPoints(), Filter::EVERY_LEVEL);
  EXPECT_TRUE(filter->GetGeneRotation());
  EXPECT_FALSE(filter->GetCountWork());
  EXPECT_FALSE(filter->GetGeneratePointStatus());
  EXPECT_EQ(filter->GetInsertionLimit(), 0);
  EXPECT_FALSE(filter->GetGenerateInsertionRank());
  EXPECT_FALSE(filter->GetGenerateInsertionCurve());
  EXPECT_FALSE(filter->GetGenerateBoxes());
  EXPECT_EQ(filter->GetMemoryLimit(), 0);
  EXPECT_EQ(filter->GetNumberOfThreads(), 0);
  EXPECT_EQ(filter->GetReuseLimit(), 262144);

  filter->SetNmax(-3);
  EXPECT_EQ(filter->GetNmax(), 1);
  filter->SetInsertionOrder(17);
  EXPECT_EQ(filter->GetInsertionOrder(), Filter::AS_GIVEN);
  filter->SetControlPoints(-1);
  EXPECT_EQ(filter->GetControlPoints(), Filter::NO_CONTROL_POINTS);
  filter->SetInsertionLimit(-7);
  EXPECT_EQ(filter->GetInsertionLimit(), 0);
  filter->SetMemoryLimit(-1);
  EXPECT_EQ(filter->GetMemoryLimit(), 0);
  filter->SetNumberOfThreads(-2);
  EXPECT_EQ(filter->GetNumberOfThreads(), 0);
  filter->SetNumberOfThreads(1000000);
  EXPECT_EQ(filter->GetNumberOfThreads(), 1024);
  filter->SetReuseLimit(-1);
  EXPECT_EQ(filter->GetReuseLimit(), 0);
}

TEST(Settings, OfVtkDelaunay2DAreThere)
{
  vtkNew<Filter> filter;
  EXPECT_EQ(filter->GetAlpha(), 0.0);
  EXPECT_TRUE(filter->GetAlphaTris() && filter->GetAlphaLines() && filter->GetAlphaVerts());
  EXPECT_EQ(filter->GetTolerance(), 0.0);
  EXPECT_EQ(filter->GetOffset(), 1.0);
  EXPECT_EQ(filter->GetProjectionPlaneMode(), VTK_DELAUNAY_XY_PLANE);
  EXPECT_EQ(filter->GetTransform(), nullptr);
  EXPECT_EQ(filter->GetSource(), nullptr);
  EXPECT_FALSE(filter->GetBoundingTriangulation());
  EXPECT_FALSE(filter->GetRandomPointInsertion());
  EXPECT_FALSE(filter->GetUseHilbertSorter());

  filter->SetAlpha(-1.0);
  EXPECT_EQ(filter->GetAlpha(), 0.0);
  filter->SetTolerance(-1.0);
  EXPECT_EQ(filter->GetTolerance(), 0.0);
  filter->SetTolerance(2.0);
  EXPECT_EQ(filter->GetTolerance(), 1.0);
  filter->SetOffset(0.1);
  EXPECT_EQ(filter->GetOffset(), 0.75);
  filter->SetProjectionPlaneMode(17);
  EXPECT_EQ(filter->GetProjectionPlaneMode(), VTK_BEST_FITTING_PLANE);
  filter->SetProjectionPlaneMode(-1);
  EXPECT_EQ(filter->GetProjectionPlaneMode(), VTK_DELAUNAY_XY_PLANE);
}

TEST(Settings, BeyondVtkDelaunay2DAreOff)
{
  vtkNew<Filter> filter;
  EXPECT_EQ(filter->GetSourceMode(), Filter::SOURCE_IDS);
  EXPECT_EQ(filter->GetCrossingMode(), Filter::LEAVE_OUT);
  EXPECT_EQ(filter->GetFillRule(), Filter::ORIENTATION);
  EXPECT_EQ(filter->GetDuplicatePolicy(), Filter::FIRST);
  EXPECT_EQ(filter->GetRim(), Filter::AUTOMATIC);
  EXPECT_EQ(filter->GetVoronoiClip(), Filter::CLIP_TO_HULL);
  EXPECT_EQ(filter->GetMaximumEdgeLength(), 0.0);
  EXPECT_FALSE(filter->GetGenerateConstraintEdges());
  EXPECT_FALSE(filter->GetGenerateRegionIds());
  EXPECT_FALSE(filter->GetGenerateNeighbors());
  EXPECT_FALSE(filter->GetGenerateVoronoi());

  filter->SetSourceMode(9);
  EXPECT_EQ(filter->GetSourceMode(), Filter::SOURCE_COORDINATES);
  filter->SetCrossingMode(9);
  EXPECT_EQ(filter->GetCrossingMode(), Filter::SPLIT);
  filter->SetFillRule(9);
  EXPECT_EQ(filter->GetFillRule(), Filter::EVEN_ODD);
  filter->SetDuplicatePolicy(9);
  EXPECT_EQ(filter->GetDuplicatePolicy(), Filter::MEAN_Z);
  filter->SetRim(9);
  EXPECT_EQ(filter->GetRim(), Filter::TRIMMED);
  filter->SetVoronoiClip(9);
  EXPECT_EQ(filter->GetVoronoiClip(), Filter::CLIP_TO_POLYGON);
  filter->SetMaximumEdgeLength(-2.0);
  EXPECT_EQ(filter->GetMaximumEdgeLength(), 0.0);
}

TEST(Settings, TheTransformsChangesAreTheFilters)
{
  vtkNew<Filter> filter;
  vtkNew<vtkTransform> transform;
  filter->SetTransform(transform);
  EXPECT_EQ(filter->GetTransform(), transform.Get());
  const vtkMTimeType before = filter->GetMTime();
  transform->RotateX(90);
  EXPECT_GT(filter->GetMTime(), before);
  filter->SetTransform(nullptr);
  EXPECT_EQ(filter->GetTransform(), nullptr);
}

TEST(Settings, NamedSettersSetWhatTheySay)
{
  vtkNew<Filter> filter;
  filter->SetInsertionOrderToAsGiven();
  EXPECT_EQ(filter->GetInsertionOrder(), 3);
  filter->SetInsertionOrderToRegularGrid();
  EXPECT_EQ(filter->GetInsertionOrder(), 2);
  filter->SetInsertionOrderToMultiGrid();
  EXPECT_EQ(filter->GetInsertionOrder(), 1);
  filter->SetInsertionOrderToAdaptiveHilbert();
  EXPECT_EQ(filter->GetInsertionOrder(), 0);
  filter->SetControlPointsToNone();
  EXPECT_EQ(filter->GetControlPoints(), 0);
  filter->SetControlPointsToSingleLevel();
  EXPECT_EQ(filter->GetControlPoints(), 1);
  filter->SetControlPointsToEveryLevel();
  EXPECT_EQ(filter->GetControlPoints(), 2);
  filter->SetSourceModeToCoordinates();
  EXPECT_EQ(filter->GetSourceMode(), 1);
  filter->SetSourceModeToIds();
  EXPECT_EQ(filter->GetSourceMode(), 0);
  filter->SetClosedLinesToLoops();
  EXPECT_EQ(filter->GetClosedLines(), 1);
  filter->SetClosedLinesToLines();
  EXPECT_EQ(filter->GetClosedLines(), 0);
  filter->SetSourceHeightsToFromSurface();
  EXPECT_EQ(filter->GetSourceHeights(), 1);
  filter->SetSourceHeightsToOwn();
  EXPECT_EQ(filter->GetSourceHeights(), 0);
  filter->SetCrossingModeToSplit();
  EXPECT_EQ(filter->GetCrossingMode(), 1);
  filter->SetCrossingModeToLeaveOut();
  EXPECT_EQ(filter->GetCrossingMode(), 0);
  filter->SetFillRuleToEvenOdd();
  EXPECT_EQ(filter->GetFillRule(), 1);
  filter->SetFillRuleToOrientation();
  EXPECT_EQ(filter->GetFillRule(), 0);
  filter->SetDuplicatePolicyToMeanZ();
  EXPECT_EQ(filter->GetDuplicatePolicy(), 3);
  filter->SetDuplicatePolicyToHighestZ();
  EXPECT_EQ(filter->GetDuplicatePolicy(), 2);
  filter->SetDuplicatePolicyToLowestZ();
  EXPECT_EQ(filter->GetDuplicatePolicy(), 1);
  filter->SetDuplicatePolicyToFirst();
  EXPECT_EQ(filter->GetDuplicatePolicy(), 0);
  filter->SetRimToTrimmed();
  EXPECT_EQ(filter->GetRim(), 2);
  filter->SetRimToConvexHull();
  EXPECT_EQ(filter->GetRim(), 1);
  filter->SetRimToAutomatic();
  EXPECT_EQ(filter->GetRim(), 0);
  filter->SetVoronoiClipToBounds();
  EXPECT_EQ(filter->GetVoronoiClip(), 1);
  filter->SetVoronoiClipToHull();
  EXPECT_EQ(filter->GetVoronoiClip(), 0);
}

TEST(Settings, NoneChangesTheResult)
{
  auto cloud = makeCloud(latticePoints(4000, 100)); // ties and duplicates in plenty
  vtkNew<Filter> filter;
  filter->SetInputData(cloud);
  filter->Update();
  const std::vector<Triangle> expected = trianglesOf(filter->GetOutput());
  ASSERT_FALSE(expected.empty());
  for (int order = Filter::ADAPTIVE_HILBERT; order <= Filter::AS_GIVEN; ++order)
  {
    for (int control = Filter::NO_CONTROL_POINTS; control <= Filter::EVERY_LEVEL; ++control)
    {
      for (int nmax : { 1, 50, 1000 })
      {
        filter->SetInsertionOrder(order);
        filter->SetControlPoints(control);
        filter->SetNmax(nmax);
        filter->SetGeneRotation(nmax != 50);
        filter->SetCountWork(nmax == 1);
        filter->SetRandomPointInsertion(nmax == 1);
        filter->SetUseHilbertSorter(control == Filter::EVERY_LEVEL);
        filter->SetOffset(nmax);
        filter->Update();
        ASSERT_EQ(trianglesOf(filter->GetOutput()), expected)
          << "InsertionOrder " << order << ", ControlPoints " << control << ", Nmax " << nmax;
      }
    }
  }
}

TEST(Settings, CountsOfASplitAreFieldDataAndAreGoneAfterAnError)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud({ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 } }));
  filter->SetSourceData(makeSource({ { 0, 2 }, { 1, 3 } }, {}));
  filter->SetCrossingModeToSplit();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfCrossings(), 1);
  EXPECT_EQ(filter->GetNumberOfConstraintsLeftOut(), 0);
  auto* counts = filter->GetOutput()->GetFieldData();
  EXPECT_EQ(counts->GetArray("NumberOfCrossings")->GetTuple1(0), 1.0);
  EXPECT_EQ(counts->GetArray("NumberOfConstraintsLeftOut")->GetTuple1(0), 0.0);
  filter->SetMemoryLimit(1);
  filter->Update();
  EXPECT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_EQ(filter->GetNumberOfCrossings(), 0);
}

TEST(Settings, OffsetIsHowFarTheBoundingTriangulationReaches)
{
  vtkNew<Filter> filter;
  auto cloud = makeCloud(latticePoints(100, 1000));
  double points[6];
  cloud->GetBounds(points);
  const double diagonal = cloud->GetLength();
  filter->SetInputData(cloud);
  filter->BoundingTriangulationOn();
  for (const double offset : { 1.0, 3.0, 0.75, 20.0 })
  {
    filter->SetOffset(offset);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 108);
    double all[6];
    filter->GetOutput()->GetBounds(all);
    for (int k = 0; k < 4; k += 2) // a circle of so many diagonals around the middle
    {
      const double middle = (points[k] + points[k + 1]) / 2;
      EXPECT_NEAR(all[k], middle - offset * diagonal, 1e-9 * diagonal * offset);
      EXPECT_NEAR(all[k + 1], middle + offset * diagonal, 1e-9 * diagonal * offset);
    }
  }
}

TEST(Settings, AreReadAndNeverWrittenByARun)
{
  vtkNew<Filter> filter;
  filter->SetInputData(makeCloud(latticePoints(500, 1000)));
  filter->SetInsertionOrderToMultiGrid();
  filter->SetNmax(7);
  filter->SetControlPointsToSingleLevel();
  filter->GeneRotationOff();
  filter->CountWorkOn();
  const vtkMTimeType before = filter->GetMTime();
  filter->Update();
  EXPECT_EQ(filter->GetMTime(), before) << "running changed the filter";
  EXPECT_EQ(filter->GetInsertionOrder(), Filter::MULTI_GRID);
  EXPECT_EQ(filter->GetNmax(), 7);
  EXPECT_EQ(filter->GetControlPoints(), Filter::SINGLE_LEVEL);
  EXPECT_FALSE(filter->GetGeneRotation());
  EXPECT_TRUE(filter->GetCountWork());
}

TEST(Settings, RunningAgainGivesTheSame)
{
  vtkNew<Filter> filter;
  filter->SetInputData(makeCloud(latticePoints(2000, 300)));
  filter->Update();
  const std::vector<Triangle> first = trianglesOf(filter->GetOutput());
  const vtkIdType duplicates = filter->GetNumberOfDuplicates();
  filter->Modified();
  filter->Update();
  EXPECT_EQ(trianglesOf(filter->GetOutput()), first);
  EXPECT_EQ(filter->GetNumberOfDuplicates(), duplicates);
}

TEST(Settings, WorkIsCountedOnRequestOnly)
{
  vtkNew<Filter> filter;
  filter->SetInputData(makeCloud(latticePoints(5000, 100000)));
  filter->Update();
  EXPECT_EQ(filter->GetNP(), -1.0);
  EXPECT_EQ(filter->GetNR(), -1.0);
  filter->CountWorkOn();
  filter->Update();
  EXPECT_GT(filter->GetNP(), 1.0) << "each point tests at least the triangle it starts from";
  EXPECT_GT(filter->GetNR(), 1.0) << "each point removes at least one triangle";
  EXPECT_LT(filter->GetNR(), 10.0);
  filter->CountWorkOff();
  filter->Update();
  EXPECT_EQ(filter->GetNP(), -1.0) << "a measure of the run before is still shown";
}

TEST(Settings, TimesAreTaken)
{
  vtkNew<Filter> filter;
  filter->SetInputData(makeCloud(latticePoints(20000, 100000)));
  filter->Update();
  EXPECT_GT(filter->GetSortSeconds(), 0.0);
  EXPECT_GT(filter->GetInsertSeconds(), 0.0);
  EXPECT_GT(filter->GetOutputSeconds(), 0.0);
}

/// The settings and measures that a class declares: what a vtkGetMacro of its header names.
std::vector<std::string> gettersOf(const std::string& className)
{
  std::ifstream file(std::string(AHD_FILTERS_DIRECTORY "/") + className + ".h");
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::regex getter("vtkGet(Object)?Macro\\((\\w+),");
  std::vector<std::string> names;
  for (std::sregex_iterator i(text.begin(), text.end(), getter), end; i != end; ++i)
  {
    names.push_back((*i)[2]);
  }
  return names;
}

TEST(Settings, AreAllPrinted)
{
  vtkNew<Filter> filter;
  std::ostringstream text;
  filter->Print(text);
  std::vector<std::string> names = gettersOf("vtkAdaptiveHilbertAlgorithm");
  ASSERT_GT(names.size(), 60u) << "the superclass's header was not read";
  const std::vector<std::string> own = gettersOf("vtkAdaptiveHilbertDelaunay2D");
  ASSERT_FALSE(own.empty()) << "the class's header was not read";
  names.insert(names.end(), own.begin(), own.end());
  for (const std::string& name : names)
  {
    EXPECT_NE(text.str().find(" " + name + ": "), std::string::npos) << name;
  }
}

TEST(Settings, OfTheSourceAreAllPrinted)
{
  vtkNew<vtkPlanarPointSource> source;
  std::ostringstream text;
  source->Print(text);
  const std::vector<std::string> names = gettersOf("vtkPlanarPointSource");
  ASSERT_FALSE(names.empty());
  for (const std::string& name : names)
  {
    EXPECT_NE(text.str().find(" " + name + ": "), std::string::npos) << name;
  }
}

TEST(Settings, GenerateFateIsTheOldNameOfGeneratePointStatus)
{
  vtkNew<Filter> filter;
  filter->GenerateFateOn();
  EXPECT_TRUE(filter->GetGeneratePointStatus());
  const vtkMTimeType on = filter->GetMTime();
  filter->SetGeneratePointStatus(true);
  EXPECT_EQ(filter->GetMTime(), on);
  filter->GeneratePointStatusOff();
  EXPECT_FALSE(filter->GetGenerateFate());
  EXPECT_GT(filter->GetMTime(), on);
  filter->SetGenerateFate(true);
  EXPECT_TRUE(filter->GetGeneratePointStatus());
  filter->GenerateFateOff();
  EXPECT_FALSE(filter->GetGeneratePointStatus());
  filter->GeneratePointStatusOn();
  EXPECT_TRUE(filter->GetGenerateFate());

  filter->SetInputData(makeCloud(latticePoints(3, 3)));
  filter->Update();
  EXPECT_NE(filter->GetOutput()->GetPointData()->GetArray("Fate"), nullptr);
}

TEST(Settings, IgnoreNaN)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetTolerance(0.5);
  filter->SetOffset(2.0);
  filter->SetAlpha(3.0);
  filter->SetMaximumEdgeLength(4.0);
  const vtkMTimeType before = filter->GetMTime();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  filter->SetTolerance(nan);
  filter->SetOffset(nan);
  filter->SetAlpha(nan);
  filter->SetMaximumEdgeLength(nan);
  filter->SetAlpha(3.0); // no change either
  EXPECT_EQ(filter->GetTolerance(), 0.5);
  EXPECT_EQ(filter->GetOffset(), 2.0);
  EXPECT_EQ(filter->GetAlpha(), 3.0);
  EXPECT_EQ(filter->GetMaximumEdgeLength(), 4.0);
  EXPECT_EQ(filter->GetMTime(), before);
  filter->SetMaximumEdgeLength(5.0);
  EXPECT_GT(filter->GetMTime(), before);
}
