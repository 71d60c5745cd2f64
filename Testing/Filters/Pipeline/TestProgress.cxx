// SPDX-License-Identifier: BSD-3-Clause
//
// Progress is reported and never goes back; an abort at any time leaves nothing and breaks nothing.
#include "FilterTestSupport.h"
#include "ProgressWatch.h"

#include <gtest/gtest.h>

using namespace ahdtest;

namespace
{
constexpr std::size_t kCount = 100000;
}

TEST(Progress, RisesFromZeroToOne)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(makeCloud(latticePoints(kCount, 1000000)));
  vtkNew<ProgressWatch> watch;
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  ASSERT_GT(watch->Seen.size(), 10u);
  EXPECT_LE(watch->Seen.size(), 110u) << "observers may be slow";
  EXPECT_EQ(watch->Seen.front(), 0.0);
  EXPECT_EQ(watch->Seen.back(), 1.0);
  for (std::size_t i = 1; i < watch->Seen.size(); ++i)
  {
    EXPECT_GE(watch->Seen[i], watch->Seen[i - 1]) << "at report " << i;
  }
}

TEST(Progress, AbortAnywhereLeavesAnEmptyOutputAndAReusableFilter)
{
  auto cloud = makeCloud(latticePoints(kCount, 1000000));
  vtkNew<vtkAdaptiveHilbertDelaunay2D> reference;
  reference->SetInputData(cloud);
  reference->Update();
  const std::vector<Triangle> expected = trianglesOf(reference->GetOutput());

  for (double at : { 0.01, 0.1, 0.3, 0.6, 0.85, 0.95 })
  {
    WatchedFilter filter;
    filter->SetInputData(cloud);
    vtkNew<ProgressWatch> watch;
    watch->AbortAt = at;
    filter->AddObserver(vtkCommand::ProgressEvent, watch);
    filter->Update();
    ASSERT_TRUE(watch->Aborted) << "no progress of " << at << " was ever reported";
    // The pipeline may say once, with 1, that it is done with the filter.
    EXPECT_LE(watch->SeenAfterAbort, 1) << "work went on after the abort at " << at;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << "aborted at " << at;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0) << "aborted at " << at;
    EXPECT_EQ(filter->GetNumberOfTriangles(), 0) << "aborted at " << at;
    EXPECT_TRUE(filter.Said->Errors.empty()) << filter.Said->Errors[0];
    EXPECT_TRUE(filter.Said->Warnings.empty()) << filter.Said->Warnings[0];

    watch->AbortAt = 2.0;
    filter->SetAbortExecute(0); // VTK 9.1 does this by itself, later VTK leaves it to the user
    filter->Modified();
    filter->Update();
    EXPECT_TRUE(trianglesOf(filter->GetOutput()) == expected) << "after an abort at " << at;
  }
}
