// SPDX-License-Identifier: BSD-3-Clause
//
// The representative of several points at one place, through the filter.
#include "FilterTestSupport.h"

#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

using namespace ahdtest;

namespace
{
using Filter = vtkAdaptiveHilbertDelaunay2D;

/// 1000 points at 225 places, with few z.
std::vector<Xyz> tracks(unsigned seed)
{
  std::vector<Xyz> points = latticePoints(1000, 15, seed);
  std::mt19937 random(seed);
  for (Xyz& p : points)
  {
    p[2] = random() % 12 == 0 ? std::numeric_limits<double>::quiet_NaN()
                              : -double(random() % 7) / 10;
  }
  return points;
}

std::vector<Triangle> replaced(std::vector<Triangle> triangles, const std::vector<vtkIdType>& by)
{
  for (Triangle& t : triangles)
  {
    for (vtkIdType& id : t)
    {
      id = by[std::size_t(id)];
    }
  }
  return triangles;
}

/// For each point the one that the policy shows for its place.
std::vector<vtkIdType> shownBy(int policy, const std::vector<Xyz>& points)
{
  std::map<std::pair<double, double>, vtkIdType> shown;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Xyz& p = points[i];
    const auto [at, isFirst] = shown.emplace(std::make_pair(p[0], p[1]), vtkIdType(i));
    const double best = points[std::size_t(at->second)][2];
    const bool better = !std::isnan(p[2]) &&
      (std::isnan(best) || (policy == Filter::LOWEST_Z ? p[2] < best : p[2] > best));
    at->second = !isFirst && better && policy != Filter::FIRST ? vtkIdType(i) : at->second;
  }
  std::vector<vtkIdType> all;
  for (const Xyz& p : points)
  {
    all.push_back(shown[std::make_pair(p[0], p[1])]);
  }
  return all;
}
}

TEST(DuplicatePolicy, LowestAndHighestDecideWhichIdIsTheVertex)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    const std::vector<Xyz> points = tracks(seed);
    const std::vector<Triangle> first = triangulate(points);
    for (int policy : { Filter::FIRST, Filter::LOWEST_Z, Filter::HIGHEST_Z })
    {
      vtkNew<Filter> filter;
      auto cloud = makeCloud(points);
      filter->SetInputData(cloud);
      filter->SetDuplicatePolicy(policy);
      filter->GenerateFateOn();
      filter->Update();
      const std::vector<vtkIdType> shown = shownBy(policy, points);
      EXPECT_EQ(idsOf(filter->GetOutput()->GetPointData(), "Fate"), shown);
      EXPECT_EQ(trianglesOf(filter->GetOutput()), replaced(first, shown));
      EXPECT_EQ(filter->GetOutput()->GetPoints(), cloud->GetPoints());
      ASSERT_FALSE(HasFailure()) << "policy " << policy << ", seed " << seed;
    }
  }
}

TEST(DuplicatePolicy, RankAndCurveFollow)
{
  const std::vector<Xyz> points = tracks(3);
  const std::vector<vtkIdType> shown = shownBy(Filter::LOWEST_Z, points);
  vtkNew<Filter> filter;
  filter->SetInputData(makeCloud(points));
  filter->SetDuplicatePolicyToLowestZ();
  filter->GenerateInsertionRankOn();
  filter->GenerateInsertionCurveOn();
  filter->Update();
  const std::vector<vtkIdType> ranks = idsOf(filter->GetOutput()->GetPointData(), "InsertionRank");
  vtkPolyData* order = filter->GetOutput(1);
  const std::vector<vtkIdType> ids = idsOf(order->GetPointData(), "OriginalPointIds");
  ASSERT_EQ(ids.size(), std::size_t(filter->GetNumberOfPointsInserted()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_EQ(ranks[i] >= 0, shown[i] == vtkIdType(i)) << "point " << i;
    if (ranks[i] >= 0)
    {
      EXPECT_EQ(ids[std::size_t(ranks[i])], vtkIdType(i));
      EXPECT_EQ(order->GetPoint(ranks[i])[0], points[i][0]);
      const double z = order->GetPoint(ranks[i])[2];
      EXPECT_TRUE(z == points[i][2] || (std::isnan(z) && std::isnan(points[i][2])));
    }
  }
}

TEST(DuplicatePolicy, PointsBeyondTheLimitAreNoVertices)
{
  const std::vector<Xyz> points = tracks(4);
  vtkNew<Filter> filter;
  filter->SetInputData(makeCloud(points));
  filter->SetInsertionLimit(50);
  filter->SetDuplicatePolicyToHighestZ();
  filter->GenerateFateOn();
  filter->Update();
  const std::vector<vtkIdType> fates = idsOf(filter->GetOutput()->GetPointData(), "Fate");
  std::set<vtkIdType> vertices;
  for (std::size_t i = 0; i < fates.size(); ++i)
  {
    if (fates[i] == vtkIdType(i))
    {
      vertices.insert(fates[i]);
    }
  }
  EXPECT_EQ(vertices.size(), 50u);
  for (const Triangle& t : trianglesOf(filter->GetOutput()))
  {
    for (vtkIdType id : t)
    {
      EXPECT_EQ(vertices.count(id), 1u) << "point " << id;
    }
  }
}

TEST(DuplicatePolicy, TheMeanIsShownAtTheSmallestId)
{
  for (int type : { VTK_DOUBLE, VTK_FLOAT, VTK_INT })
  {
    std::vector<Xyz> points = tracks(5);
    for (Xyz& p : points)
    {
      p[2] = type == VTK_INT ? (std::isnan(p[2]) ? 0 : p[2] * 10) : p[2];
    }
    auto cloud = makeCloud(points, type);
    vtkNew<vtkIdTypeArray> number;
    number->SetName("number");
    number->SetNumberOfValues(1000);
    number->FillValue(7);
    cloud->GetPointData()->AddArray(number);
    vtkNew<Filter> filter;
    filter->SetInputData(cloud);
    filter->SetDuplicatePolicyToMeanZ();
    filter->GenerateFateOn();
    filter->Update();
    vtkPolyData* surface = filter->GetOutput();
    EXPECT_EQ(trianglesOf(surface), triangulate(points));
    EXPECT_EQ(idsOf(surface->GetPointData(), "Fate"), shownBy(Filter::FIRST, points));
    EXPECT_EQ(surface->GetPointData()->GetArray("number"), number);
    EXPECT_EQ(surface->GetPoints()->GetDataType(), type == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE);
    std::map<std::pair<double, double>, std::vector<double>> all;
    for (vtkIdType i = 0; i < 1000; ++i)
    {
      const double* p = cloud->GetPoint(i);
      auto& z = all[std::make_pair(p[0], p[1])];
      if (!std::isnan(p[2]))
      {
        z.push_back(p[2]);
      }
    }
    const std::vector<vtkIdType> fates = idsOf(surface->GetPointData(), "Fate");
    for (vtkIdType i = 0; i < 1000; ++i)
    {
      Xyz p, q;
      cloud->GetPoint(i, p.data());
      surface->GetPoint(i, q.data());
      const auto& z = all[std::make_pair(p[0], p[1])];
      double expected = p[2];
      if (fates[std::size_t(i)] == i && !z.empty())
      {
        expected = 0.0;
        for (double one : z)
        {
          expected += one / double(z.size());
        }
      }
      EXPECT_EQ(q[0], p[0]);
      EXPECT_EQ(q[1], p[1]);
      EXPECT_TRUE(std::fabs(q[2] - expected) < 1e-6 || (std::isnan(q[2]) && std::isnan(expected)))
        << "point " << i << ": " << q[2] << ", not " << expected;
    }
  }
}

TEST(DuplicatePolicy, WithoutDuplicatesNothingIsCopied)
{
  for (int policy : { Filter::LOWEST_Z, Filter::HIGHEST_Z, Filter::MEAN_Z })
  {
    auto cloud = makeCloud(scatteredPoints(100));
    vtkNew<Filter> filter;
    filter->SetInputData(cloud);
    filter->SetDuplicatePolicy(policy);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetPoints(), cloud->GetPoints());
    EXPECT_EQ(trianglesOf(filter->GetOutput()), triangulate(scatteredPoints(100)));
  }
}

TEST(DuplicatePolicy, InAPlaneHeightDecides)
{
  // looking along y: the lowest is the one with the smallest y
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(std::array<double, 16>{ 1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1 }
                         .data()); // y becomes z, z becomes -y
  const std::vector<Xyz> points = { { 0, 5, 0 }, { 1, 5, 0 }, { 0, 5, 1 }, { 1, 5, 1 }, { 0, 3, 0 },
    { 1, 7, 0 } };
  vtkNew<Filter> filter;
  filter->SetInputData(makeCloud(points));
  filter->SetTransform(transform);
  filter->GenerateFateOn();
  filter->SetDuplicatePolicyToLowestZ();
  filter->Update();
  EXPECT_EQ(idsOf(filter->GetOutput()->GetPointData(), "Fate"),
    (std::vector<vtkIdType>{ 4, 1, 2, 3, 4, 1 }));
  filter->SetDuplicatePolicyToHighestZ();
  filter->Update();
  EXPECT_EQ(idsOf(filter->GetOutput()->GetPointData(), "Fate"),
    (std::vector<vtkIdType>{ 0, 5, 2, 3, 0, 5 }));
  filter->SetDuplicatePolicyToMeanZ();
  filter->Update();
  vtkPoints* made = filter->GetOutput()->GetPoints();
  EXPECT_EQ(made->GetPoint(0)[1], 4.0) << "in space, along the way the plane is looked at";
  EXPECT_EQ(made->GetPoint(1)[1], 6.0);
  EXPECT_EQ(made->GetPoint(2)[1], 5.0);
  EXPECT_EQ(made->GetPoint(4)[1], 3.0);
}

TEST(DuplicatePolicy, MergedPointsHaveNoSay)
{
  const std::vector<Xyz> points = { { 0, 0, 5 }, { 10, 0, 5 }, { 0, 10, 5 }, { 0, 0, 4 },
    { 0, 0.001, 1 } };
  vtkNew<Filter> filter;
  filter->SetInputData(makeCloud(points));
  filter->SetTolerance(0.001);
  filter->GenerateFateOn();
  filter->SetDuplicatePolicyToLowestZ();
  filter->Update();
  EXPECT_EQ(
    idsOf(filter->GetOutput()->GetPointData(), "Fate"), (std::vector<vtkIdType>{ 3, 1, 2, 3, 3 }));
  filter->SetDuplicatePolicyToMeanZ();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPoint(0)[2], 4.5);
}

TEST(DuplicatePolicy, ConstraintsMeetAtThePlace)
{
  // a line from a duplicate to a duplicate
  const std::vector<Xyz> points = { { 0, 0, 5 }, { 10, 0, 5 }, { 10, 1, 5 }, { 0, 1, 5 },
    { 0, 0, 1 }, { 10, 1, 1 } };
  for (const std::vector<vtkIdType>& ids :
    { std::vector<vtkIdType>{ 0, 2 }, { 4, 2 }, { 0, 5 }, { 4, 5 } })
  {
    vtkNew<vtkPolyData> source;
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({ ids[0], ids[1] });
    source->SetLines(lines);
    vtkNew<Filter> filter;
    filter->SetInputData(makeCloud(points));
    filter->SetSourceData(source);
    filter->SetDuplicatePolicyToLowestZ();
    filter->Update();
    EXPECT_EQ(filter->GetNumberOfConstraintEdges(), 1);
    int ends = 0;
    for (const Triangle& t : trianglesOf(filter->GetOutput()))
    {
      ends += int(std::count(t.begin(), t.end(), 4) + std::count(t.begin(), t.end(), 5));
      EXPECT_EQ(std::count(t.begin(), t.end(), 0) + std::count(t.begin(), t.end(), 2), 0);
    }
    EXPECT_EQ(ends, 4) << "both triangles have both ends";
  }
}

TEST(DuplicatePolicy, WhatIsKeptForOtherDataShowsTheSame)
{
  for (int policy : { Filter::LOWEST_Z, Filter::MEAN_Z })
  {
    vtkNew<Filter> filter;
    filter->SetDuplicatePolicy(policy);
    filter->GenerateFateOn();
    filter->SetInputData(makeCloud(tracks(6)));
    filter->Update();
    vtkNew<vtkPolyData> before;
    before->DeepCopy(filter->GetOutput());
    // the same numbers, through the same connection
    for (int step = 1; step < 3; ++step)
    {
      vtkPolyData::SafeDownCast(filter->GetInput())->SetPoints(makePoints(tracks(6)));
      filter->Update();
    }
    EXPECT_EQ(filter->GetNumberOfTriangulations(), 2);
    EXPECT_EQ(trianglesOf(filter->GetOutput()), trianglesOf(before));
    EXPECT_EQ(
      idsOf(filter->GetOutput()->GetPointData(), "Fate"), idsOf(before->GetPointData(), "Fate"));
    for (vtkIdType i = 0; i < before->GetNumberOfPoints(); ++i)
    {
      const double z = before->GetPoint(i)[2];
      const double now = filter->GetOutput()->GetPoint(i)[2];
      EXPECT_TRUE(z == now || (std::isnan(z) && std::isnan(now))) << "point " << i;
    }
  }
}

TEST(DuplicatePolicy, MemoryIsEstimated)
{
  vtkNew<Filter> filter;
  filter->SetInputData(makeCloud(scatteredPoints(10000)));
  filter->Update();
  const vtkTypeInt64 first = filter->GetMemoryEstimate();
  filter->SetDuplicatePolicyToHighestZ();
  filter->Update();
  const vtkTypeInt64 highest = filter->GetMemoryEstimate();
  filter->SetDuplicatePolicyToMeanZ();
  filter->Update();
  EXPECT_GE(highest, first);
  EXPECT_LE(highest, first + 12 * 10000 / 1024 + 1); // a number and a height for each point
  // the vertex of each point and a copy of the points
  EXPECT_GE(filter->GetMemoryEstimate(), first + (4 + 24) * 10000 / 1024);
  EXPECT_LE(filter->GetMemoryEstimate(), first + 2 * (4 + 24) * 10000 / 1024);
}
