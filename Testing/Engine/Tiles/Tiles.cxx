// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles leaf by leaf, byte for byte those of one run with all points.
#include "Executors.h"
#include "HashedResults.h"
#include "TilesRun.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ahd
{
namespace test
{
namespace
{

/// So that about so many leaves have points.
std::uint64_t mostFor(std::size_t points, std::size_t leaves)
{
  return std::max<std::uint64_t>(1, leaves == 1 ? points : 2 * points / leaves);
}

/// Both ways to the stream of all triangles.
void expectTheStream(const PointView& points, const TilesWay& way, const std::string& name)
{
  const std::vector<std::int64_t> whole = trianglesOfOneRun(points, way.representative);
  TilesRun run(points, way);
  ASSERT_EQ(run.fault, "") << name;
  EXPECT_EQ(run.triangles(), whole) << name << ", " << run.plan().leaves() << " leaves";
  EXPECT_EQ(run.trianglesOfSecondVisits(), whole)
    << name << ", " << run.plan().leaves() << " leaves, second visits";
  EXPECT_EQ(run.status, Status::Ok);
  EXPECT_EQ(run.fault, "") << name;
}

TEST(Tiles, EveryDistributionIsAsInOneRun)
{
  for (const Distribution d : allDistributions())
  {
    const std::vector<Point> points = makePoints(d, affordable(d, 2000), 1);
    for (const std::size_t leaves : { 1, 16, 300 })
    {
      TilesWay way;
      way.most = mostFor(points.size(), leaves);
      expectTheStream(viewOf(points), way, nameOf(d));
    }
  }
}

TEST(Tiles, EveryFileOfTheCorpusIsAsInOneRun)
{
  for (const NamedPoints& given : pointsOfCorpus(AHD_CORPUS_DIRECTORY))
  {
    for (const std::uint64_t most : { 1, 5, 40 })
    {
      TilesWay way;
      way.most = most;
      expectTheStream(viewOf(given.points), way, given.name);
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
