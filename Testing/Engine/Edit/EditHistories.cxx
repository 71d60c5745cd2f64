// SPDX-License-Identifier: BSD-3-Clause
//
// After any history the living triangles are those of a fresh run of what is left; and every
// request is accepted or refused as a fresh run has it.
#include "EditHistory.h"

namespace ahd
{
namespace test
{
namespace
{

/// Places far from the origin, one unit in the last place and more apart.
std::vector<Point> farLattice()
{
  std::vector<Point> places;
  for (int k = 0; k < 49; ++k)
  {
    places.push_back({ 1e14 + double(k % 7) / 64.0, -1e14 + double(k / 7) / 64.0 });
  }
  return places;
}

void expectHistories(
  const std::vector<Point>& places, std::uint64_t seed, std::size_t steps, std::size_t* counts)
{
  History history(places, seed);
  for (std::size_t k = 0; k < steps; ++k)
  {
    history.step();
    if (k % 5 == 0)
    {
      history.expectAsFresh();
    }
    ASSERT_FALSE(::testing::Test::HasFailure()) << "seed " << seed << ", step " << k;
  }
  for (int k = 0; k < 9; ++k)
  {
    counts[k] += history.count[k];
  }
}

void expectAllKinds(std::uint64_t histories)
{
  std::size_t counts[9] = {};
  for (const Distribution d : { Distribution::Uniform, Distribution::Lattice,
         Distribution::DecimalLattice, Distribution::OnIntegerCircle, Distribution::Collinear,
         Distribution::NearlyCollinear, Distribution::Utm, Distribution::Slivers,
         Distribution::RepeatedDraws, Distribution::AnyFinite })
  {
    for (std::uint64_t seed = 1; seed <= histories; ++seed)
    {
      ASSERT_NO_FATAL_FAILURE(expectHistories(makePoints(d, 2 + seed % 37, seed), seed, 80, counts))
        << nameOf(d);
      ASSERT_FALSE(::testing::Test::HasFailure()) << nameOf(d);
    }
  }
  for (std::uint64_t seed = 1; seed <= histories; ++seed)
  {
    ASSERT_NO_FATAL_FAILURE(expectHistories(farLattice(), seed, 100, counts));
    ASSERT_FALSE(::testing::Test::HasFailure());
  }
  counts[int(EditOutcome::SegmentsMeet)] = 1; // rare; below
  for (int k = 0; k < 9; ++k)
  {
    EXPECT_EQ(counts[k] > 0, EditOutcome(k) != EditOutcome::NotTried) << "outcome " << k;
  }
}

TEST(EditHistories, EqualAFreshRun)
{
  expectAllKinds(reduced(40));
}

TEST(LongEditHistories, EqualAFreshRun)
{
  expectAllKinds(2000);
}

/// Two segments that meet at a vertex inside of both would cross without it.
TEST(EditHistories, AVertexStaysWhereSegmentsMeet)
{
  Edit edit;
  const std::int64_t middle = insertOne(edit, { 1.0, 1.0 });
  for (const Point& p : { Point{ 0.0, 0.0 }, { 2.0, 2.0 }, { 0.0, 2.0 }, { 2.0, 0.0 } })
  {
    insertOne(edit, p);
  }
  EXPECT_EQ(constrainOne(edit, middle + 1, middle + 2), EditOutcome::Done);
  EXPECT_EQ(constrainOne(edit, middle + 3, middle + 4), EditOutcome::Done);
  EXPECT_EQ(removeOne(edit, middle), EditOutcome::SegmentsMeet);
  EXPECT_EQ(moveOne(edit, middle, { 1.0, 1.5 }), EditOutcome::SegmentsMeet);
  expectFresh(edit);
  EXPECT_EQ(releaseOne(edit, middle + 4, middle + 3), EditOutcome::Done);
  EXPECT_EQ(moveOne(edit, middle, { 1.0, 1.5 }), EditOutcome::Done);
  EXPECT_EQ(constrainOne(edit, middle + 3, middle + 4), EditOutcome::Crosses);
  expectFresh(edit);
}

/// Points on a line and one beside it, which comes and goes.
TEST(EditHistories, TrianglesBeginAndEnd)
{
  Edit edit;
  std::vector<std::int64_t> ids;
  for (int k = 0; k < 20; ++k)
  {
    ids.push_back(insertOne(edit, { double(k), 2.0 * double(k) }));
  }
  EXPECT_EQ(constrainOne(edit, ids[2], ids[9]), EditOutcome::Done);
  EXPECT_EQ(constrainOne(edit, ids[5], ids[15]), EditOutcome::Done);
  for (int round = 0; round < 3; ++round)
  {
    expectFresh(edit);
    EXPECT_EQ(edit.mesh().vertexCount(), 0u);
    const std::int64_t apex = insertOne(edit, { 3.0, 1.0 + double(round) });
    const std::int64_t same = insertOne(edit, { 3.0, 1.0 + double(round) });
    EXPECT_GT(edit.mesh().vertexCount(), 0u);
    expectFresh(edit);
    EXPECT_EQ(removeOne(edit, ids[std::size_t(6 + round)]), EditOutcome::Done);
    expectFresh(edit);
    EXPECT_EQ(removeOne(edit, apex), EditOutcome::Done);
    expectFresh(edit);
    EXPECT_GT(edit.mesh().vertexCount(), 0u) << "its duplicate takes its place";
    EXPECT_EQ(moveOne(edit, same, { 30.0, 60.0 }), EditOutcome::Done);
    expectFresh(edit);
  }
  const EditedInput left = inputOf(edit);
  for (const std::int64_t id : left.ids)
  {
    const bool isEnd = id == ids[2] || id == ids[9] || id == ids[5] || id == ids[15];
    EXPECT_EQ(removeOne(edit, id), isEnd ? EditOutcome::EndOfSegment : EditOutcome::Done);
  }
  EXPECT_EQ(releaseOne(edit, ids[9], ids[2]), EditOutcome::Done);
  EXPECT_EQ(releaseOne(edit, ids[5], ids[15]), EditOutcome::Done);
  for (const std::size_t k : { 2, 5, 9, 15 })
  {
    EXPECT_EQ(removeOne(edit, ids[k]), EditOutcome::Done);
    EXPECT_EQ(removeOne(edit, ids[k]), EditOutcome::NoPoint);
  }
  EXPECT_EQ(edit.pointCount(), 0u);
  expectFresh(edit);
}

/// A vertex of many neighbours: in time that is not their number squared.
TEST(EditHistories, TheMiddleOfACircleComesAndGoes)
{
  Edit edit;
  const std::vector<Point> circle = makePoints(Distribution::OnCircle, reduced(50000), 1);
  std::int64_t first = -1;
  ASSERT_EQ(edit.insert(viewOf(circle), Context(), first), Status::Ok);
  for (int round = 0; round < 2; ++round)
  {
    const std::int64_t middle = insertOne(edit, { 0.0, 0.0 });
    expectFresh(edit);
    EXPECT_EQ(removeOne(edit, middle), EditOutcome::Done);
    expectFresh(edit);
  }
}

} // namespace
} // namespace test
} // namespace ahd
