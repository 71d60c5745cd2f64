// SPDX-License-Identifier: BSD-3-Clause
//
// The canonical order of the triangles, beside a plain sort, and on several threads.
#include "Distributions.h"
#include "EngineRun.h"
#include "Executors.h"

#include "Extract/Extractor.h"
#include "Extract/SortKeys.h"
#include "Insert/Insert.h"
#include "Order/Rank.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

namespace ahd
{
namespace test
{
namespace
{

using Triple = std::array<std::int64_t, 3>;

/// A finished mesh of these points.
struct Made
{
  explicit Made(const std::vector<Point>& points)
  {
    Ticker ticker(nullptr, Phase::Insert, points.size());
    EXPECT_EQ(readPoints(viewOf(points), ticker, ranked), Status::Ok);
    EXPECT_EQ(rankPoints(viewOf(points), ticker, ranked), Status::Ok);
    if (ranked.count < 3)
    {
      return;
    }
    slots.allocate(Mesh::bytesFor(ranked.count));
    mesh.begin(ranked.count, slots.data());
    SharedWork shared;
    hasTriangles = insertByRounds(ranked, mesh, ticker, nullptr, shared) == InsertionEnd::Done;
    scratch.allocate(kExtractScratchPerPoint * ranked.count);
  }

  bool isFinite(std::size_t triangle) const
  {
    const std::uint32_t* const corners = mesh.data() + Mesh::slotOfTriangle(triangle);
    return std::find(corners, corners + 3, mesh.ghost()) == corners + 3;
  }

  std::size_t triangles() const { return mesh.end() / Mesh::kSlotSize; }

  /// The definition: ranks from the lowest on, sorted, as ids.
  std::vector<Triple> expected() const
  {
    std::vector<Triple> result;
    for (std::size_t t = 0; t < triangles(); ++t)
    {
      if (isFinite(t))
      {
        const std::uint32_t* const corners = mesh.data() + Mesh::slotOfTriangle(t);
        Triple triple{ corners[0], corners[1], corners[2] };
        std::rotate(triple.begin(), std::min_element(triple.begin(), triple.end()), triple.end());
        result.push_back(triple);
      }
    }
    std::sort(result.begin(), result.end());
    for (Triple& triple : result)
    {
      for (std::int64_t& corner : triple)
      {
        corner = ranked.id[static_cast<std::size_t>(corner)];
      }
    }
    return result;
  }

  template <typename Id>
  std::vector<Triple> written(Executor* executor)
  {
    Ticker ticker(nullptr, Phase::Extract, triangles(), executor);
    const std::size_t hull = countHullVertices(mesh, ticker);
    const std::size_t count = triangles() - hull;
    std::vector<Id> ids(3 * count, Id(-1));
    EXPECT_TRUE(writeCanonical(mesh, ranked.id.data(), ids.data(), scratch, ticker));
    std::vector<Triple> result(count);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      result[i / 3][i % 3] = ids[i];
    }
    return result;
  }

  RankedPoints ranked;
  Mesh mesh;
  Scratch slots, scratch;
  bool hasTriangles = false;
};

void expectCanonical(const std::vector<Point>& points, const std::string& what)
{
  Made made(points);
  if (!made.hasTriangles)
  {
    return;
  }
  const std::vector<Triple> expected = made.expected();
  ASSERT_EQ(made.written<std::int32_t>(nullptr), expected) << what;
  ASSERT_EQ(made.written<std::int64_t>(nullptr), expected) << what;
  for (const unsigned threads : { 2u, 3u, 5u, 8u })
  {
    ThreadExecutor parallel(threads);
    ASSERT_EQ(made.written<std::int32_t>(&parallel), expected) << what << ", " << threads;
    BackwardExecutor backward(threads);
    ASSERT_EQ(made.written<std::int64_t>(&backward), expected) << what << ", " << threads;
  }
}

/// Few of many by a walk along the hull, many by a test of each triangle.
TEST(Extract, HullVerticesAreTheGhostsNeighboursOnThreads)
{
  for (const Distribution d :
    { Distribution::Uniform, Distribution::OnCircle, Distribution::NearlyCollinear })
  {
    for (const std::size_t n : { std::size_t(5), std::size_t(1000), reduced(300000) })
    {
      Made made(makePoints(d, n, 1));
      std::size_t ghosts = 0;
      for (std::size_t t = 0; t < made.triangles(); ++t)
      {
        ghosts += made.isFinite(t) ? 0 : 1;
      }
      for (const unsigned count : { 1u, 3u })
      {
        ThreadExecutor threads(count);
        Ticker ticker(nullptr, Phase::Insert, n, &threads);
        EXPECT_EQ(countHullVertices(made.mesh, ticker), ghosts) << nameOf(d) << ", " << n;
      }
    }
  }
}

TEST(Extract, IsAPlainSort)
{
  for (const Distribution d : allDistributions())
  {
    for (const std::size_t n : { std::size_t(3), std::size_t(20), affordable(d, 20000) })
    {
      expectCanonical(makePoints(d, n, 11), nameOf(d));
    }
  }
}

/// n points of a quarter circle around a centre: n - 1 triangles meet there.
std::vector<Point> fan(std::size_t n, const Point& centre, double side)
{
  std::vector<Point> points{ centre };
  for (std::size_t i = 0; i < n; ++i)
  {
    const double angle = 1.5707963267948966 * double(i) / double(n);
    points.push_back({ centre.x + side * std::cos(angle), centre.y + side * std::sin(angle) });
  }
  return points;
}

TEST(Extract, Fans)
{
  // The centre has the lowest rank (bottom left, where the curve begins), the highest, or neither.
  for (const std::size_t n : { 3u, 4u, 5u, 6u, 7u, 8u, 9u, 10u, 17u, 100u, 5000u })
  {
    expectCanonical(fan(n, { 0, 0 }, 1), "lowest");
    expectCanonical(fan(n, { 0, 0 }, -1), "not lowest");
    std::vector<Point> both = fan(n, { 0, 0 }, 1);
    const std::vector<Point> other = fan(n, { 0, 0 }, -1);
    both.insert(both.end(), other.begin(), other.end());
    expectCanonical(both, "amid");
  }
}

TEST(Extract, FanOfVeryMany)
{
  expectCanonical(fan(reduced(300000), { 0, 0 }, 1), "lowest");
  expectCanonical(fan(reduced(300000), { 5, 7 }, -1), "not lowest");
}

TEST(Extract, AnyNumberOfTasks)
{
  Made made(makePoints(Distribution::Uniform, reduced(400000), 12));
  const std::vector<Triple> expected = made.expected();
  for (const unsigned threads : { 4u, 9u, 17u, 33u, 64u, 200u })
  {
    BackwardExecutor backward(threads);
    ASSERT_EQ(made.written<std::int32_t>(&backward), expected) << threads;
  }
}

TEST(Extract, ManyKeysSortedAreSorted)
{
  std::mt19937_64 random(5);
  Ticker ticker(nullptr, Phase::Extract, 0);
  for (const std::size_t n :
    { std::size_t(0), std::size_t(1), std::size_t(4096), std::size_t(4097), reduced(300000) })
  {
    for (const unsigned bits : { 20u, 41u, 64u })
    {
      std::vector<TriangleKeys::Key> keys(n);
      std::iota(keys.begin(), keys.end(), 0u);
      for (TriangleKeys::Key& key : keys)
      {
        key |= bits == 20 ? 0 : (random() >> (64 - bits)) & ~TriangleKeys::Key(0xFFFFF);
      }
      std::shuffle(keys.begin(), keys.end(), random);
      std::vector<TriangleKeys::Key> expected = keys;
      std::sort(expected.begin(), expected.end());
      ASSERT_TRUE(sortManyKeys(keys.data(), n, bits, ticker));
      ASSERT_EQ(keys, expected) << n << " keys of " << bits << " bits";
    }
  }
}

TEST(Extract, CancelledInAFan)
{
  struct Cancel : Progress
  {
    std::size_t askings = 0, noAt = 0;
    bool advance(Phase, double) override { return ++askings != noAt; }
  };
  Made made(fan(reduced(300000), { 0, 0 }, 1));
  ASSERT_TRUE(made.hasTriangles);
  std::vector<std::int32_t> ids(3 * made.triangles());
  Cancel count;
  {
    Ticker ticker(&count, Phase::Extract, made.triangles());
    ASSERT_TRUE(writeCanonical(made.mesh, made.ranked.id.data(), ids.data(), made.scratch, ticker));
  }
  // Read twice, counted, scattered and sorted: many polls, and each can cancel.
  EXPECT_GE(count.askings, 3 * made.triangles() / kStepsPerAsking);
  for (std::size_t at = 1; at <= count.askings; at += 1 + count.askings / 20)
  {
    Cancel cancel;
    cancel.noAt = at;
    Ticker ticker(&cancel, Phase::Extract, made.triangles());
    EXPECT_FALSE(
      writeCanonical(made.mesh, made.ranked.id.data(), ids.data(), made.scratch, ticker));
    EXPECT_EQ(cancel.askings, at);
  }
}

} // namespace
} // namespace test
} // namespace ahd
