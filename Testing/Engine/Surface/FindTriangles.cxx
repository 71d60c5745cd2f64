// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles looked up in a triangulation of their points: those present, those missing, and that
// constraints restore the missing ones of a surface.
#include "Surface/FindTriangles.h"

#include "ConstrainedRun.h"
#include "Distributions.h"
#include "EngineRun.h"
#include "Listeners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace ahd
{
namespace test
{
namespace
{

std::vector<std::int64_t> triplesOf(Triangulation& made)
{
  std::vector<std::int64_t> ids(3 * made.report().triangles);
  EXPECT_EQ(made.writeTriangles(ids.data(), {}), Status::Ok);
  return ids;
}

FoundTriangles found(Triangulation& made, const std::vector<std::int64_t>& ids)
{
  FoundTriangles result;
  EXPECT_EQ(findTriangles(made, ids.data(), ids.size() / 3, {}, result), Status::Ok);
  return result;
}

void triangulatePoints(const std::vector<Point>& points, Triangulation& made)
{
  static Workspace workspace;
  ASSERT_EQ(
    triangulate(PointView(&points[0].x, points.size(), 2), {}, workspace, {}, made), Status::Ok);
}

TEST(FindTriangles, AllOfItsOwn)
{
  for (const Distribution d :
    { Distribution::Uniform, Distribution::Circle, Distribution::Lattice })
  {
    const std::vector<Point> points = makePoints(d, 2000, 3);
    Triangulation made;
    triangulatePoints(points, made);
    std::vector<std::int64_t> ids = triplesOf(made);
    std::rotate(ids.begin(), ids.begin() + 3 * 77, ids.end()); // in whatever order
    for (std::size_t i = 0; i < ids.size(); i += 6)
    {
      std::rotate(&ids[i], &ids[i] + 1, &ids[i] + 3); // from whatever corner
    }
    const FoundTriangles all = found(made, ids);
    EXPECT_TRUE(all.missing.empty());
    EXPECT_EQ(all.keptCount, made.triangleCount());
    EXPECT_EQ(std::count(all.kept.begin(), all.kept.end(), 1), std::ptrdiff_t(all.keptCount));
    ids.resize(ids.size() / 2 / 3 * 3);
    EXPECT_EQ(found(made, ids).keptCount, ids.size() / 3);
  }
}

TEST(FindTriangles, WhatIsNoneIsMissing)
{
  const std::vector<Point> points = { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 1, 2 }, { 0, 0 } };
  Triangulation made;
  triangulatePoints(points, made);
  std::vector<std::int64_t> ids = triplesOf(made);
  const std::size_t all = ids.size() / 3;
  for (std::int64_t& id : ids)
  {
    id = id == 0 ? 5 : id; // a duplicate is at the same vertex
  }
  const std::int64_t more[] = { 0, 2, 1, /**/ 0, 1, 99, /**/ -1, 1, 2, /**/ 0, 0, 1, /**/ 0, 1, 2 };
  ids.insert(ids.end(), std::begin(more), std::end(more));
  const FoundTriangles result = found(made, ids);
  EXPECT_EQ(result.keptCount, all);
  EXPECT_EQ(result.missing, (std::vector<std::size_t>{ all, all + 1, all + 2, all + 3, all + 4 }));
}

TEST(FindTriangles, ConstraintsBringBackASurface)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 3000, 8);
  std::vector<std::int64_t> chain(60), offsets = { 0 };
  for (std::size_t i = 0; i < 30; ++i)
  {
    chain[2 * i] = std::int64_t(97 * i);
    chain[2 * i + 1] = std::int64_t(91 * i + 1500) % 3000;
    offsets.push_back(std::int64_t(2 * i + 2));
  }
  Triangulation surface;
  triangulatePoints(points, surface);
  ASSERT_EQ(constrain(std::move(surface), { chain.data(), offsets.data(), 30, 30 },
              FillRule::Orientation, {}, surface),
    Status::Ok);
  const std::vector<std::int64_t> ids = triplesOf(surface);
  Triangulation again;
  triangulatePoints(points, again);
  const FoundTriangles without = found(again, ids);
  EXPECT_GT(without.missing.size(), 100u);
  std::vector<std::int64_t> edges, begins = { 0 };
  for (const std::size_t t : without.missing)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      edges.push_back(ids[3 * t + k % 3]);
    }
    begins.push_back(std::int64_t(edges.size()));
  }
  const std::size_t chains = without.missing.size();
  ASSERT_EQ(constrain(std::move(again), { edges.data(), begins.data(), chains, chains },
              FillRule::Orientation, {}, again),
    Status::Ok);
  const FoundTriangles with = found(again, ids);
  EXPECT_TRUE(with.missing.empty());
  EXPECT_EQ(with.keptCount, ids.size() / 3);
}

TEST(FindTriangles, NothingInNothing)
{
  Triangulation none;
  FoundTriangles result;
  const std::int32_t ids[] = { 0, 1, 2 };
  EXPECT_EQ(findTriangles(none, ids, 1, {}, result), Status::Ok);
  EXPECT_EQ(result.missing.size(), 1u);
  EXPECT_TRUE(result.kept.empty());
}

} // namespace
} // namespace test
} // namespace ahd
