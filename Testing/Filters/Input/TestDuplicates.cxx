// SPDX-License-Identifier: BSD-3-Clause
//
// Which of the points at one place is shown, and the mean of them; against a literal search.
#include "FilterTestSupport.h"
#include "Input/vtkAHDDuplicates.h"
#include "Pipeline/vtkAHDExecutor.h"
#include "Pipeline/vtkAHDProgress.h"

#include "vtkAlgorithm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

using namespace ahdtest;

namespace
{
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Work
{
  vtkNew<vtkAlgorithm> Filter;
  vtkAHDProgress Progress{ this->Filter };
  vtkAHDExecutor Executor{ 2 };
};

/// Points at few places, with few z.
std::vector<Xyz> crowd(std::size_t count, unsigned seed)
{
  std::mt19937 random(seed); // its sequence is fixed by the standard
  std::vector<Xyz> points(count);
  for (Xyz& p : points)
  {
    p = { double(random() % 6), double(random() % 6), double(random() % 5) / 10 };
    const unsigned odd = unsigned(random() % 10);
    p[2] = odd == 0 ? kNaN : odd == 1 ? (random() % 2 ? kInfinity : -kInfinity) : p[2];
  }
  return points;
}

ahd::PointView viewOf(const std::vector<Xyz>& points)
{
  return ahd::PointView(points[0].data(), points.size(), 3);
}

using Place = std::pair<double, double>;

/// What the engine says of these points; every tenth is left out.
std::vector<std::int64_t> fatesOf(const std::vector<Xyz>& points)
{
  std::map<Place, std::int64_t> first;
  std::vector<std::int64_t> fates;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Place place(points[i][0], points[i][1]);
    fates.push_back(i % 10 == 9 ? -2 : first.emplace(place, std::int64_t(i)).first->second);
  }
  return fates;
}

std::vector<Xyz> shuffled(const std::vector<Xyz>& points, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Xyz> other = points;
  for (std::size_t i = other.size(); i > 1; --i)
  {
    std::swap(other[i - 1], other[random() % i]);
  }
  return other;
}
}

TEST(Duplicates, TheLowestAndTheHighestAreShown)
{
  for (unsigned seed = 0; seed < 500; ++seed)
  {
    const bool highest = seed % 2 == 1;
    const std::vector<Xyz> points = crowd(1 + seed, seed);
    const std::vector<std::int64_t> fates = fatesOf(points);
    Work work;
    vtkAHDDuplicates shown;
    ASSERT_TRUE(shown.Choose(fates.data(), viewOf(points), highest, work.Progress));
    std::vector<std::int64_t> changed = fates;
    ASSERT_TRUE(shown.Apply(changed.data(), changed.size(), work.Executor, work.Progress));
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      std::int64_t expected = fates[i];
      for (std::size_t j = 0; j < points.size() && fates[i] >= 0; ++j)
      {
        const double z = points[j][2], best = points[std::size_t(expected)][2];
        const bool better = std::isfinite(z) &&
          (!std::isfinite(best) || (highest ? z > best : z < best));
        expected = fates[j] == fates[i] && better ? std::int64_t(j) : expected;
      }
      ASSERT_EQ(changed[i], expected) << "point " << i << " of crowd " << seed;
    }
  }
}

TEST(Duplicates, WithoutAnyNothingIsKept)
{
  const std::vector<Xyz> points = { { 1, 2, 3 }, { 2, 2, 3 }, { 1, 2, 3 } };
  const std::vector<std::int64_t> fates = { 0, 1, 0 };
  Work work;
  vtkAHDDuplicates shown;
  ASSERT_TRUE(shown.Choose(fates.data(), viewOf(points), false, work.Progress));
  EXPECT_TRUE(shown.IsEmpty()) << "the smaller id stands where the z are the same";
  EXPECT_EQ(shown.Get(2), 2);
  EXPECT_EQ(shown.Get(-1), -1);
}

TEST(Duplicates, IdsOfAllKindsAreReplaced)
{
  const std::vector<Xyz> points = { { 1, 2, 3 }, { 2, 2, 3 }, { 1, 2, 2 }, { 1, 2, kNaN } };
  const std::vector<std::int64_t> fates = { 0, 1, 0, 0 };
  Work work;
  vtkAHDDuplicates shown;
  ASSERT_TRUE(shown.Choose(fates.data(), viewOf(points), false, work.Progress));
  EXPECT_FALSE(shown.IsEmpty());
  EXPECT_EQ(shown.Get(0), 2);
  EXPECT_EQ(shown.Get(1), 1);
  EXPECT_EQ(shown.Get(4), 4) << "a point that was added";

  for (bool wide : { false, true })
  {
    vtkNew<vtkCellArray> cells;
    wide ? cells->Use64BitStorage() : cells->Use32BitStorage();
    cells->InsertNextCell({ 1, 0, 4 });
    ASSERT_TRUE(shown.Apply(cells, work.Executor, work.Progress));
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(0, size, ids);
    EXPECT_EQ((std::vector<vtkIdType>(ids, ids + size)), (std::vector<vtkIdType>{ 1, 2, 4 }));
  }
  EXPECT_TRUE(shown.Apply(nullptr, work.Executor, work.Progress));

  std::vector<std::int64_t> ranks = { 5, 6, -1, -1 };
  shown.Swap(ranks.data());
  EXPECT_EQ(ranks, (std::vector<std::int64_t>{ -1, 6, 5, -1 }));
  std::vector<std::int64_t> beyondLimit = { -2, 1, 0, 0 };
  ASSERT_TRUE(shown.Apply(beyondLimit.data(), 4, work.Executor, work.Progress));
  shown.Swap(beyondLimit.data());
  EXPECT_EQ(beyondLimit, (std::vector<std::int64_t>{ 2, 1, -2, 2 }));
}

TEST(Duplicates, MeansAreOfFiniteZ)
{
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    const std::vector<Xyz> points = crowd(1 + seed, seed);
    const std::vector<std::int64_t> fates = fatesOf(points);
    Work work;
    std::vector<vtkAHDMean> means;
    ASSERT_TRUE(
      vtkAHDFindMeans(fates.data(), viewOf(points), viewOf(points), work.Progress, means));
    std::map<std::int64_t, std::vector<double>> expected;
    std::map<std::int64_t, int> members;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (fates[i] >= 0)
      {
        ++members[fates[i]];
        if (std::isfinite(points[i][2]))
        {
          expected[fates[i]].push_back(points[i][2]);
        }
      }
    }
    std::size_t next = 0;
    for (const auto& [id, all] : expected)
    {
      if (members[id] < 2)
      {
        continue;
      }
      ASSERT_LT(next, means.size());
      double sum = 0.0;
      for (double z : all)
      {
        sum += z;
      }
      EXPECT_EQ(means[next].Id, id);
      EXPECT_EQ(means[next].Position[0], points[std::size_t(id)][0]);
      EXPECT_EQ(means[next].Position[1], points[std::size_t(id)][1]);
      EXPECT_NEAR(means[next].Position[2], sum / double(all.size()), 1e-15);
      ++next;
    }
    EXPECT_EQ(next, means.size());
    ASSERT_FALSE(HasFailure()) << "crowd " << seed;
  }
}

TEST(Duplicates, TheOrderOfThePointsHasNoSayInTheirMean)
{
  std::vector<Xyz> points = scatteredPoints(1000);
  for (Xyz& p : points)
  {
    p = { 0.1, 0.2, p[0] };
  }
  const std::vector<std::int64_t> fates(points.size(), 0);
  Work work;
  std::vector<vtkAHDMean> means, others;
  ASSERT_TRUE(vtkAHDFindMeans(fates.data(), viewOf(points), viewOf(points), work.Progress, means));
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const std::vector<Xyz> other = shuffled(points, seed);
    ASSERT_TRUE(vtkAHDFindMeans(fates.data(), viewOf(other), viewOf(other), work.Progress, others));
    ASSERT_EQ(means.size(), 1u);
    ASSERT_EQ(others.size(), 1u);
    EXPECT_EQ(others[0].Position, means[0].Position);
  }
  EXPECT_EQ(means[0].Position[0], 0.1) << "what all have in common is not rounded";
}

TEST(Duplicates, MeansOfHugeAndOfOddNumbers)
{
  const double most = std::numeric_limits<double>::max();
  const std::vector<Xyz> points = { { 0, 0, most }, { 0, 0, most / 2 }, { 0, 0, kInfinity },
    { 1, 0, kNaN }, { 1, 0, kInfinity } };
  const std::vector<std::int64_t> fates = { 0, 0, 0, 3, 3 };
  Work work;
  std::vector<vtkAHDMean> means;
  ASSERT_TRUE(vtkAHDFindMeans(fates.data(), viewOf(points), viewOf(points), work.Progress, means));
  ASSERT_EQ(means.size(), 1u);
  EXPECT_EQ(means[0].Position[2], most * 0.75);
}

TEST(Duplicates, InAPlaneTheMeanIsOneOfPositions)
{
  // two points one above the other in a plane that is not x, y; the third has no place in it
  const std::vector<Xyz> places = { { 5, 5, 1 }, { 5, 5, 3 }, { kNaN, kNaN, kNaN } };
  const std::vector<Xyz> positions = { { 1, 2, 3 }, { 5, 2, 7 }, { kNaN, 0, 0 } };
  const std::vector<std::int64_t> fates = { 0, 0, -1 };
  Work work;
  std::vector<vtkAHDMean> means;
  ASSERT_TRUE(
    vtkAHDFindMeans(fates.data(), viewOf(places), viewOf(positions), work.Progress, means));
  ASSERT_EQ(means.size(), 1u);
  EXPECT_EQ(means[0].Position, (Xyz{ 3, 2, 5 }));
}

TEST(Duplicates, AnAbortIsHeard)
{
  const std::vector<Xyz> points = crowd(10, 1);
  const std::vector<std::int64_t> fates = fatesOf(points);
  Work work;
  work.Filter->SetAbortExecute(1);
  vtkAHDDuplicates shown;
  std::vector<vtkAHDMean> means;
  EXPECT_FALSE(shown.Choose(fates.data(), viewOf(points), false, work.Progress));
  EXPECT_FALSE(vtkAHDFindMeans(fates.data(), viewOf(points), viewOf(points), work.Progress, means));
}
