// SPDX-License-Identifier: BSD-3-Clause
//
// The order of insertion as a point array, and the limit that stops halfway.
#include "FilterTestSupport.h"

#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

using namespace ahdtest;
using Filter = vtkAdaptiveHilbertDelaunay2D;

namespace
{
const double kNan = std::numeric_limits<double>::quiet_NaN();

/// Points of which the engine inserts all but a duplicate (10), one that is not finite (20) and, in
/// the cloud made of them, a ghost (30).
std::vector<Xyz> faultyPoints(std::size_t count)
{
  std::vector<Xyz> points = scatteredPoints(count);
  points[10] = points[3];
  points[20][0] = kNan;
  return points;
}

vtkSmartPointer<vtkPolyData> makeFaultyCloud(const std::vector<Xyz>& points)
{
  auto cloud = makeCloud(points);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(static_cast<vtkIdType>(points.size()));
  marks->FillValue(0);
  marks->SetValue(30, vtkDataSetAttributes::DUPLICATEPOINT);
  cloud->GetPointData()->AddArray(marks);
  return cloud;
}

/// Each triangle from its smallest corner on, as a set: the same however points are numbered.
std::set<Triangle> asSet(std::vector<Triangle> triangles)
{
  for (Triangle& t : triangles)
  {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  return { triangles.begin(), triangles.end() };
}

/// Calls check(filter) with every InsertionOrder and ControlPoints, and the gene off once.
template <typename Check>
void forEverySetting(WatchedFilter& filter, const Check& check)
{
  for (int order = Filter::ADAPTIVE_HILBERT; order <= Filter::AS_GIVEN; ++order)
  {
    for (int control = Filter::NO_CONTROL_POINTS; control <= Filter::EVERY_LEVEL; ++control)
    {
      for (bool gene : { true, false })
      {
        SCOPED_TRACE("InsertionOrder " + std::to_string(order) + ", ControlPoints " +
          std::to_string(control) + (gene ? "" : ", no gene"));
        filter->SetInsertionOrder(order);
        filter->SetControlPoints(control);
        filter->SetGeneRotation(gene);
        check();
      }
    }
  }
}

std::vector<vtkIdType> ranksOf(WatchedFilter& filter)
{
  return idsOf(filter->GetOutput()->GetPointData(), "InsertionRank");
}
}

TEST(InsertionRank, IsThereOnRequestOnly)
{
  vtkNew<Filter> filter;
  filter->SetInputData(makeCloud(scatteredPoints(100)));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  filter->GenerateInsertionRankOn();
  filter->Update();
  EXPECT_NE(filter->GetOutput()->GetPointData()->GetArray("InsertionRank"), nullptr);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfPoints(), 0) << "only the array was asked for";
  filter->GenerateInsertionRankOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
}

TEST(InsertionRank, IsAPermutationOfTheVertices)
{
  const std::vector<Xyz> points = faultyPoints(700);
  WatchedFilter filter;
  filter->SetInputData(makeFaultyCloud(points));
  filter->GenerateInsertionRankOn();
  forEverySetting(filter,
    [&]
    {
      filter->Update();
      std::vector<vtkIdType> ranks = ranksOf(filter);
      ASSERT_EQ(ranks.size(), points.size());
      for (vtkIdType id : { 10, 20, 30 })
      {
        EXPECT_EQ(ranks[id], -1) << "point " << id << " is in no order";
      }
      if (filter->GetInsertionOrder() == Filter::AS_GIVEN)
      {
        std::vector<vtkIdType> given = ranks;
        given.erase(std::remove(given.begin(), given.end(), -1), given.end());
        EXPECT_TRUE(std::is_sorted(given.begin(), given.end()));
      }
      std::sort(ranks.begin(), ranks.end());
      std::vector<vtkIdType> expected(697);
      std::iota(expected.begin(), expected.end(), 0);
      expected.insert(expected.begin(), 3, -1);
      EXPECT_EQ(ranks, expected);
    });
}

TEST(InsertionRank, DiffersBetweenTheOrders)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(scatteredPoints(700)));
  filter->GenerateInsertionRankOn();
  filter->SetNmax(3); // boxes are divided twice
  std::set<std::vector<vtkIdType>> found;
  forEverySetting(filter,
    [&]
    {
      filter->Update();
      found.insert(ranksOf(filter));
    });
  // RG and AS_GIVEN have no control points; only HG uses genes.
  EXPECT_EQ(found.size(), 6u + 3u + 1u + 1u);
}

TEST(InsertionRank, IsTheSameForAnyNumberOfThreads)
{
  auto cloud = makeCloud(scatteredPoints(300000));
  std::vector<vtkIdType> expected;
  for (int threads : { 1, 2, 5 })
  {
    WatchedFilter filter;
    filter->SetInputData(cloud);
    filter->GenerateInsertionRankOn();
    filter->SetNumberOfThreads(threads);
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfThreadsUsed(), threads);
    expected = expected.empty() ? ranksOf(filter) : expected;
    EXPECT_TRUE(ranksOf(filter) == expected) << threads << " threads";
  }
}

TEST(InsertionLimit, GivesTheTriangulationOfTheFirstPoints)
{
  const std::vector<Xyz> points = faultyPoints(400);
  auto cloud = makeFaultyCloud(points);
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->GenerateInsertionRankOn();
  filter->SetNmax(10);
  forEverySetting(filter,
    [&]
    {
      for (vtkIdType limit : { 3, 4, 50, 396 })
      {
        filter->SetInsertionLimit(limit);
        filter->Update();
        const std::vector<vtkIdType> ranks = ranksOf(filter);
        std::vector<Xyz> first;
        std::vector<vtkIdType> ids;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          if (ranks[i] >= 0 && ranks[i] < limit)
          {
            first.push_back(points[i]);
            ids.push_back(static_cast<vtkIdType>(i));
          }
        }
        std::vector<Triangle> expected = triangulate(first);
        ASSERT_FALSE(expected.empty());
        for (Triangle& t : expected)
        {
          t = { ids[t[0]], ids[t[1]], ids[t[2]] };
        }
        EXPECT_EQ(asSet(trianglesOf(filter->GetOutput())), asSet(expected)) << "limit " << limit;
      }
    });
}

TEST(InsertionLimit, IsAPropertyOfTheOrderNotOfTheRanks)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(scatteredPoints(500)));
  filter->GenerateInsertionRankOn();
  forEverySetting(filter,
    [&]
    {
      filter->SetInsertionLimit(0);
      filter->Update();
      const std::vector<vtkIdType> all = ranksOf(filter);
      filter->SetInsertionLimit(77);
      filter->Update();
      EXPECT_EQ(ranksOf(filter), all);
    });
}

TEST(InsertionLimit, AtItsEnds)
{
  const std::vector<Xyz> points = faultyPoints(200);
  auto cloud = makeFaultyCloud(points);
  WatchedFilter all;
  all->SetInputData(cloud);
  all->Update();
  const std::vector<Triangle> expected = trianglesOf(all->GetOutput());
  for (vtkIdType limit : { vtkIdType(-5), vtkIdType(0), vtkIdType(1), vtkIdType(2), vtkIdType(3),
         vtkIdType(196), vtkIdType(197), vtkIdType(198), vtkIdType(200), vtkIdType(VTK_ID_MAX) })
  {
    WatchedFilter filter;
    filter->SetInputData(cloud);
    filter->SetInsertionLimit(limit);
    filter->Update();
    const vtkIdType inserted = limit > 0 && limit < 197 ? limit : 197;
    EXPECT_EQ(filter->GetNumberOfPointsInserted(), inserted) << "limit " << limit;
    EXPECT_EQ(filter->GetNumberOfPointsBeyondLimit(), 197 - inserted) << "limit " << limit;
    EXPECT_EQ(filter->GetNumberOfDuplicates(), 1);
    EXPECT_EQ(filter->GetNumberOfRejectedPoints(), 1);
    EXPECT_EQ(filter->GetNumberOfSkippedPoints(), 1);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 200);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), filter->GetNumberOfTriangles());
    vtkDataArray* field = filter->GetOutput()->GetFieldData()->GetArray(
      "NumberOfPointsBeyondLimit");
    ASSERT_NE(field, nullptr);
    EXPECT_EQ(field->GetTuple1(0), 197 - inserted);
    if (inserted == 197)
    {
      EXPECT_EQ(trianglesOf(filter->GetOutput()), expected) << "limit " << limit;
    }
    else if (inserted <= 3)
    {
      EXPECT_EQ(filter->GetNumberOfTriangles(), inserted == 3 ? 1 : 0);
    }
    else
    {
      EXPECT_LT(filter->GetNumberOfTriangles(), vtkIdType(expected.size())) << "limit " << limit;
    }
  }
}

TEST(InsertionLimit, FateSaysWhoIsBeyond)
{
  const std::vector<Xyz> points = faultyPoints(200);
  WatchedFilter filter;
  filter->SetInputData(makeFaultyCloud(points));
  filter->GenerateFateOn();
  filter->GenerateInsertionRankOn();
  for (vtkIdType limit : { 1, 60, 196, 197 })
  {
    filter->SetInsertionLimit(limit);
    filter->Update();
    const std::vector<vtkIdType> ranks = ranksOf(filter);
    const std::vector<vtkIdType> fates = idsOf(filter->GetOutput()->GetPointData(), "Fate");
    ASSERT_EQ(fates.size(), points.size());
    for (vtkIdType i = 0; i < 200; ++i)
    {
      const vtkIdType expected = i == 10 ? (ranks[3] < limit ? 3 : -2)
        : i == 20                        ? -1
        : i == 30                        ? -2
        : ranks[i] < limit               ? i
                                         : -2;
      EXPECT_EQ(fates[i], expected) << "point " << i << ", limit " << limit;
    }
  }
}

TEST(InsertionLimit, DuplicatesDoNotCount)
{
  const std::vector<Xyz> lattice = latticePoints(3000, 20);
  const std::set<Xyz> distinct(lattice.begin(), lattice.end());
  WatchedFilter filter;
  filter->SetInputData(makeCloud(lattice));
  filter->SetInsertionLimit(100);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfPointsInserted(), 100);
  EXPECT_EQ(filter->GetNumberOfPointsBeyondLimit(), vtkIdType(distinct.size() - 100));
  EXPECT_EQ(filter->GetNumberOfDuplicates(), vtkIdType(3000 - distinct.size()));
}

TEST(InsertionLimit, IsTheSameForAnyNumberOfThreads)
{
  auto cloud = makeCloud(scatteredPoints(50000));
  std::vector<Triangle> expected;
  for (int threads : { 1, 3 })
  {
    WatchedFilter filter;
    filter->SetInputData(cloud);
    filter->SetInsertionLimit(30000);
    filter->SetNumberOfThreads(threads);
    filter->Update();
    EXPECT_GT(filter->GetNumberOfTriangles(), 59000);
    expected = expected.empty() ? trianglesOf(filter->GetOutput()) : expected;
    EXPECT_TRUE(trianglesOf(filter->GetOutput()) == expected) << threads << " threads";
  }
}

TEST(InsertionLimit, TellsWhyThereIsNoTriangle)
{
  // Along a line first, then the apex.
  const std::vector<Xyz> points = { { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 }, { 3, 3, 0 },
    { 0, 3, 0 } };
  const std::pair<vtkIdType, std::string> expected[] = {
    { 1, "stops after the first 1 of 5 distinct points, fewer than three." },
    { 2, "stops after the first 2 of 5 distinct points, fewer than three." },
    { 3, "stops after the first 3 of 5 distinct points, and these are collinear." },
    { 4, "stops after the first 4 of 5 distinct points, and these are collinear." }, { 5, "" },
    { 0, "" }
  };
  for (const auto& [limit, text] : expected)
  {
    WatchedFilter filter;
    filter->SetInputData(makeCloud(points));
    filter->SetInsertionOrderToAsGiven();
    filter->SetInsertionLimit(limit);
    filter->Update();
    EXPECT_TRUE(filter.Said->Errors.empty()) << filter.Said->Errors[0];
    ASSERT_EQ(filter.Said->Warnings.size(), text.empty() ? 0u : 1u) << "limit " << limit;
    if (!text.empty())
    {
      EXPECT_NE(filter.Said->Warnings[0].find(text), std::string::npos) << filter.Said->Warnings[0];
      EXPECT_NE(filter.Said->Warnings[0].find("InsertionLimit"), std::string::npos);
    }
    EXPECT_EQ(filter->GetNumberOfTriangles() > 0, text.empty()) << "limit " << limit;
  }
}

TEST(InsertionLimit, OfCollinearPointsIsNotBlamedWhereAllAreInserted)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud({ { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } }));
  filter->SetInsertionLimit(3);
  filter->Update();
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("all distinct points are collinear"), std::string::npos)
    << filter.Said->Warnings[0];
}

TEST(InsertionLimit, CountsNothingWhereTheRunIsRefused)
{
  WatchedFilter filter;
  filter->SetInputData(makeCloud(scatteredPoints(3000)));
  filter->SetInsertionLimit(1000);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfPointsBeyondLimit(), 2000);
  filter->SetMemoryLimit(1);
  filter->Update();
  EXPECT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_EQ(filter->GetNumberOfPointsBeyondLimit(), 0);
}

TEST(InsertionLimit, NothingIsLeftOverWhenItChanges)
{
  auto cloud = makeCloud(scatteredPoints(3000));
  WatchedFilter filter;
  filter->SetInputData(cloud);
  for (vtkIdType limit : { 0, 500, 3, 2000, 1, 0 }) // memory of the run before is used again
  {
    filter->SetInsertionLimit(limit);
    filter->Update();
    WatchedFilter fresh;
    fresh->SetInputData(cloud);
    fresh->SetInsertionLimit(limit);
    fresh->Update();
    EXPECT_EQ(trianglesOf(filter->GetOutput()), trianglesOf(fresh->GetOutput()))
      << "limit " << limit;
    EXPECT_EQ(filter->GetNumberOfPointsBeyondLimit(), fresh->GetNumberOfPointsBeyondLimit());
  }
}
