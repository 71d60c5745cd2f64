// SPDX-License-Identifier: BSD-3-Clause
#include "TilesJudge.h"

#include "Judge.h"
#include "TilesRun.h"

namespace ahd
{
namespace fuzz
{

void expectTiles(const FuzzCase& given, const std::vector<Point>& points,
  const ConstraintView& chains, FillRule rule, const std::vector<std::int32_t>& triples)
{
  constexpr std::size_t kMostInTiles = 200;
  if (points.size() > kMostInTiles)
  {
    return;
  }
  test::TilesWay way;
  way.most = 1 + given.head[kMostBoxes] % 40u;
  way.lines = test::linesOf(points, chains, rule);
  const std::vector<std::int64_t> whole(triples.begin(), triples.end());
  test::TilesRun run(test::viewOf(points), way);
  expect(
    run.isFine() && run.triangles() == whole, "leaf by leaf the triangles are the same", given);
  expect(chains.chains != 0 || run.trianglesOfSecondVisits() == whole,
    "second visits have the same triangles", given);
  expect(run.isFine(), "no step was refused", given);
}

} // namespace fuzz
} // namespace ahd
