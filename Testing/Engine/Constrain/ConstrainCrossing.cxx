// SPDX-License-Identifier: BSD-3-Clause
//
// Segments along the curve of which some cross: those are taken out again and inserted in the order
// given, or, where they are many, all of them are. Certified, and the same with threads.
#include "ConstrainedRun.h"
#include "Executors.h"

#include "Triangulate.h"

#include <gtest/gtest.h>

#include <utility>

namespace ahd
{
namespace test
{
namespace
{

using Lines = std::vector<Chain>;

/// So many edges, here and there, of the Delaunay triangulation of every `step`-th point: none
/// crosses another.
Lines edgesOfEvery(std::size_t step, const std::vector<Point>& points, std::size_t count)
{
  Triangulation made;
  Workspace workspace;
  triangulate(
    PointView(&points[0].x, points.size() / step, 2 * step), Options(), workspace, {}, made);
  std::vector<std::int64_t> triples(3 * made.report().triangles);
  made.writeTriangles(triples.data(), {});
  Lines lines;
  for (std::size_t h = 0; h < triples.size(); ++h)
  {
    const std::int64_t from = triples[h], to = triples[h % 3 == 2 ? h - 2 : h + 1];
    if (from < to)
    {
      lines.push_back({ std::int64_t(step) * from, std::int64_t(step) * to });
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    lines[i] = lines[lines.size() / count * i];
  }
  lines.resize(count);
  return lines;
}

void add(const Lines& lines, ConstraintCase& given)
{
  for (const Chain& line : lines)
  {
    given.constraints.addLine(line);
  }
}

Lines reversed(Lines lines)
{
  for (Chain& line : lines)
  {
    std::swap(line.front(), line.back());
  }
  return lines;
}

void expectCertified(const ConstraintCase& given)
{
  EXPECT_EQ(faultsOfConstraining(given, FillRule::Orientation), "");
}

/// Certified, and the same with threads.
void expectRight(const ConstraintCase& given)
{
  expectCertified(given);
  const ConstrainedOutcome expected = constrain(given, FillRule::Orientation);
  EXPECT_GT(expected.constraints.crossing, 0u);
  ThreadExecutor two(2);
  EXPECT_EQ(differenceByThreads(given, FillRule::Orientation, expected, two), "");
  if (!kOnlyThreadsMatter)
  {
    BackwardExecutor backward(5);
    EXPECT_EQ(differenceByThreads(given, FillRule::Orientation, expected, backward), "");
  }
}

constexpr std::size_t kPoints = 34000; // enough for threads

/// Few segments between many, before or after them.
TEST(ConstrainCrossing, FewCrossOthersWithThreads)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, kPoints, 21);
  const Lines many = edgesOfEvery(3, points, 12000), few = edgesOfEvery(4, points, 300);
  for (const bool fewFirst : { false, true })
  {
    SCOPED_TRACE(fewFirst);
    ConstraintCase given;
    given.points = points;
    add(fewFirst ? few : many, given);
    add(fewFirst ? many : few, given);
    add(reversed(few), given); // the same edges once more
    expectRight(given);
  }
}

/// So many that one after the other is faster.
TEST(ConstrainCrossing, ManyCrossOthersWithThreads)
{
  ConstraintCase given;
  given.points = makePoints(Distribution::Uniform, kPoints, 22);
  add(edgesOfEvery(3, given.points, 6000), given);
  add(edgesOfEvery(4, given.points, 6000), given);
  expectRight(given);
}

/// Of a lattice: segments along rows, of five edges each, which share the last one with the next
/// segment, a few across one of their edges, and one edge beside those.
TEST(ConstrainCrossing, RowsOfEdgesAreTakenOutWithThreads)
{
  constexpr std::int64_t kSide = 185;
  ConstraintCase given;
  given.points = makePoints(Distribution::Lattice, kSide * kSide, 1);
  Lines rows, across;
  for (std::int64_t row = 1; row + 1 < kSide; row += 3)
  {
    for (std::int64_t column = 0; column + 5 < kSide; column += 4)
    {
      const std::int64_t begin = row * kSide + column;
      rows.push_back({ begin, begin + 5 });
      if ((row + column) % 20 == 0)
      {
        const std::int64_t crossed = begin + column % 5;
        across.push_back({ crossed - kSide, crossed + kSide + 1 });
        const std::int64_t beside = begin + (column % 5 + 1) % 5;
        rows.push_back({ beside, beside + 1 });
      }
    }
  }
  for (const bool fewFirst : { false, true })
  {
    SCOPED_TRACE(fewFirst);
    given.constraints = ConstraintSet();
    add(fewFirst ? across : rows, given);
    add(fewFirst ? rows : across, given);
    expectRight(given);
  }
}

/// One edge that very many segments are, crossed by one.
TEST(ConstrainCrossing, OneEdgeOfVeryManySegmentsWithThreads)
{
  ConstraintCase given;
  given.points = makePoints(Distribution::Uniform, kPoints, 23);
  const Lines many = edgesOfEvery(3, given.points, 4000);
  const Lines few = edgesOfEvery(4, given.points, 4000);
  add(few, given);
  const std::vector<LeftOut> crossings = [&]
  {
    ConstraintCase both = given;
    add(many, both);
    return constrain(both, FillRule::Orientation).constraints.leftOut;
  }();
  ASSERT_FALSE(crossings.empty());
  for (const bool isForward : { true, false })
  {
    const Chain across = few[crossings[0].otherChain];
    const Chain edge = many[crossings[0].chain - few.size()];
    given.constraints = ConstraintSet();
    add(Lines(3000, edge), given);
    add(isForward ? Lines{ across } : reversed({ across }), given);
    expectRight(given);
  }
}

/// A segment through very many triangles, crossed by a short one: taking it out needs too many
/// flips.
TEST(ConstrainCrossing, ALongSegmentIsCrossed)
{
  ConstraintCase given;
  const std::int64_t n = 160000;
  given.points = makePoints(Distribution::Uniform, std::size_t(n), 24);
  given.points.insert(
    given.points.end(), { { 0.01, 0.5 }, { 0.99, 0.5001 }, { 0.7, 0.499 }, { 0.7002, 0.502 } });
  for (const bool longFirst : { true, false })
  {
    for (const bool isForward : { true, false })
    {
      const Chain across = { n, n + 1 };
      const Lines both[] = { isForward ? Lines{ across } : reversed({ across }),
        { { n + 2, n + 3 } } };
      given.constraints = ConstraintSet();
      add(both[longFirst ? 0 : 1], given);
      add(both[longFirst ? 1 : 0], given);
      expectCertified(given);
    }
  }
}

/// All are taken out of the mesh, and the flips of one move edges of others, on both sides, to
/// triangles that come before it.
TEST(ConstrainCrossing, EdgesThatFlipsMoveAreTakenOut)
{
  ConstraintCase given;
  given.points = { { 2, 2 }, { 7, 1 }, { 8, 2 }, { 5, 1 }, { 0, 0 }, { 4, 1 }, { 4, 1 }, { 2, 2 },
    { 3, 1 }, { 3, 0 }, { 1, 1 }, { 1, 2 }, { 1, 2 }, { 3, 2 }, { 3, 2 }, { 8, 1 }, { 3, 0 },
    { 4, 2 }, { 8, 2 }, { 6, 1 }, { 8, 0 }, { 1, 1 }, { 1, 2 }, { 0, 1 }, { 1, 0 }, { 7, 1 },
    { 5, 0 }, { 6, 0 }, { 0, 0 }, { 0, 2 }, { 3, 0 }, { 7, 1 }, { 7, 2 }, { 2, 0 }, { 4, 1 },
    { 5, 2 }, { 4, 1 }, { 2, 1 }, { 4, 0 }, { 3, 1 }, { 7, 0 }, { 6, 2 } };
  add({ { 31, 28 }, { 16, 41 }, { 41, 21 }, { 7, 15 }, { 3, 26 }, { 26, 37 }, { 11, 36 },
        { 22, 30 }, { 19, 4 }, { 27, 10 }, { 10, 17 }, { 17, 34 }, { 34, 28 }, { 28, 8 },
        { 39, 13 }, { 13, 20 }, { 20, 0 }, { 0, 9 }, { 9, 6 }, { 25, 10 }, { 18, 5 }, { 33, 23 },
        { 28, 14 }, { 1, 12 }, { 11, 36 }, { 36, 11 }, { 2, 39 } },
    given);
  expectRight(given);
}

} // namespace
} // namespace test
} // namespace ahd
