// SPDX-License-Identifier: BSD-3-Clause
//
// A source of points alone as a line; where its points and lines lie beside those of the input.
#include "PrepareCase.h"

#include <gtest/gtest.h>

namespace ahd
{
namespace test
{
namespace
{

using Ids = std::vector<std::int64_t>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const std::vector<Xyz> kTerrain = { { { 0, 0, 10 } }, { { 4, 0, 20 } }, { { 4, 4, 30 } },
  { { 0, 4, kNaN } } };
const std::vector<Xyz> kShore = { { { 1, 1, 0 } }, { { 2, 1, 0 } }, { { 2, 2, 0 } },
  { { 1, 1, 5 } } };

Cells chainsOf(const PreparedInput& out, bool ofLoops)
{
  const ConstraintView view = out.constraints();
  Cells chains;
  for (std::size_t k = ofLoops ? view.lines : 0; k < (ofLoops ? view.chains : view.lines); ++k)
  {
    chains.push_back(Ids(view.ids + view.offsets[k], view.ids + view.offsets[k + 1]));
  }
  return chains;
}

TEST(PreparePointsAsLine, AreALineInTheirOrder)
{
  PrepareCase given(kTerrain, kShore);
  given.request.firstCell = 9;
  given.request.pointsAreLine = true;
  for (const bool closes : { false, true })
  {
    given.request.closedLinesAreLoops = closes;
    PreparedInput out;
    ASSERT_EQ(prepare(given.request, Context(), out), Status::Ok);
    EXPECT_EQ(chainsOf(out, closes), (Cells{ { 4, 5, 6, 7 } }));
    EXPECT_EQ(chainsOf(out, !closes), Cells());
    EXPECT_EQ(out.cellOf(0), 0);
    EXPECT_FALSE(out.areLinesUnclosed());
  }
  EXPECT_EQ(segmentsOf(given.request), 4u) << "one less";
  const std::size_t bytes = preparationMemoryEstimate(given.request);
  given.request.pointsAreLine = false;
  EXPECT_GT(bytes, preparationMemoryEstimate(given.request));
}

TEST(PreparePointsAsLine, OnlyOfASourceOfPointsAlone)
{
  const auto countOf = [](PrepareCase& given)
  {
    given.request.pointsAreLine = true;
    PreparedInput out;
    EXPECT_EQ(prepare(given.request, Context(), out), Status::Ok);
    return out.constraints().chains;
  };
  PrepareCase line(kTerrain, kShore, { { 0, 1 } }), polygon(kTerrain, kShore, {}, { { 0, 1, 2 } }),
    empty(kTerrain, kShore, { {} }), one(kTerrain, { kShore[0] }), none(kTerrain, {}),
    ofInput(kTerrain, kShore);
  EXPECT_EQ(countOf(line), 1u);
  EXPECT_EQ(countOf(polygon), 1u);
  EXPECT_EQ(countOf(empty), 0u) << "it has a line";
  EXPECT_EQ(countOf(one), 0u);
  EXPECT_EQ(countOf(none), 0u);
  ofInput.request.idsAreOfInput = true;
  EXPECT_EQ(countOf(ofInput), 0u);
}

SourceBounds boundsOf(const PrepareCase& given)
{
  PreparedInput out;
  EXPECT_EQ(prepare(given.request, Context(), out), Status::Ok);
  return out.sourceBounds();
}

TEST(PrepareSourceBounds, AreThoseOfBoth)
{
  std::vector<Xyz> terrain = kTerrain;
  terrain.push_back({ { 99, 99, 99 } });
  terrain.push_back({ { kNaN, -99, -99 } });
  const std::vector<unsigned char> marks = { 0, 0, 0, 0, 1, 0 };
  PrepareCase given(terrain, kShore, { { 0, 1 } });
  given.request.points.skip = marks.data();
  const SourceBounds found = boundsOf(given);
  EXPECT_EQ(found.input.low, (Xyz{ { 0, 0, 10 } }));
  EXPECT_EQ(found.input.high, (Xyz{ { 4, 4, 30 } }));
  EXPECT_EQ(found.source.low, (Xyz{ { 1, 1, 0 } }));
  EXPECT_EQ(found.source.high, (Xyz{ { 2, 2, 5 } }));
  EXPECT_FALSE(found.areApart());
}

TEST(PrepareSourceBounds, AreApartWhereTheyDoNotMeet)
{
  const auto areApart = [](double x, double y)
  {
    std::vector<Xyz> moved = kShore;
    for (Xyz& p : moved)
    {
      p[0] += x;
      p[1] += y;
    }
    return boundsOf(PrepareCase(kTerrain, moved, { { 0, 1 } })).areApart();
  };
  EXPECT_FALSE(areApart(3, 0)) << "they touch";
  EXPECT_TRUE(areApart(3.5, 0));
  EXPECT_TRUE(areApart(-2.5, 0));
  EXPECT_TRUE(areApart(0, 3.5));
  EXPECT_TRUE(areApart(0, -2.5));
  EXPECT_FALSE(boundsOf(PrepareCase({}, kShore, { { 0, 1 } })).areApart()) << "no input";
  EXPECT_FALSE(boundsOf(PrepareCase(kTerrain, { { { kNaN, 0, 0 } } })).areApart());
  PrepareCase ids(kTerrain, {}, { { 0, 1 } });
  ids.request.idsAreOfInput = true;
  EXPECT_FALSE(boundsOf(ids).areApart());
}

TEST(PrepareSourceBounds, CountLinesAtZeroOffTheTerrain)
{
  const Cells lines = { { 0, 1 }, { 0, 1, 2 }, { 2, 3 }, { 1 }, {}, { 1, -1 } };
  PrepareCase given(kTerrain, kShore, lines, { { 0, 1, 2 }, { 1, 2, 3 } });
  EXPECT_EQ(boundsOf(given).chainsOffTerrain(), 3u);
  given.request.heights = SourceHeights::FromSurface;
  EXPECT_EQ(boundsOf(given).chainsOffTerrain(), 0u) << "they have no heights of their own";
  std::vector<Xyz> other = kTerrain;
  for (Xyz& p : other)
  {
    p[2] = -p[2];
  }
  EXPECT_EQ(boundsOf(PrepareCase(other, kShore, lines)).chainsOffTerrain(), 2u) << "below";
  for (const double nearest : { 0.0, 4.0, -4.0, 5.0, -5.0, 9.0, -9.0 })
  {
    std::vector<Xyz> one = kTerrain; // from there 20 on
    one[0][2] = nearest;
    one[1][2] = nearest;
    one[2][2] = nearest + (nearest < 0.0 ? -20.0 : 20.0);
    EXPECT_EQ(boundsOf(PrepareCase(one, kShore, lines)).chainsOffTerrain(),
      std::fabs(nearest) > 5.0 ? 2u : 0u)
      << nearest;
  }
  const std::vector<Xyz> flat(4, { { 0, 0, 3 } }),
    all = { { { 0, 0, -1e308 } }, { { 1, 1, 1e308 } } };
  EXPECT_EQ(boundsOf(PrepareCase(flat, kShore, lines)).chainsOffTerrain(), 2u) << "of one height";
  EXPECT_EQ(boundsOf(PrepareCase(all, kShore, lines)).chainsOffTerrain(), 0u) << "no overflow";
  EXPECT_EQ(boundsOf(PrepareCase({}, kShore, lines)).chainsOffTerrain(), 0u) << "no terrain";
}

TEST(PrepareSourceBounds, OfSeveralBlocksAreJoined)
{
  PrepareCase inputAlone({ { { 9, 9, -3 } } }, {});
  EXPECT_GT(boundsOf(inputAlone).input.low[0], 9.0) << "not looked at";
  inputAlone.request.isSourceElsewhere = true;
  EXPECT_EQ(boundsOf(inputAlone).input.low, (Xyz{ { 9, 9, -3 } }));
  SourceBounds all = boundsOf(PrepareCase({}, kShore, { { 0, 1 } }));
  all.merge(boundsOf(PrepareCase(kTerrain, { { { 7, 7, 0 } }, { { 8, 8, 0 } } }, { { 0, 1 } })));
  all.merge(SourceBounds());
  EXPECT_EQ(all.source.high, (Xyz{ { 8, 8, 5 } }));
  EXPECT_EQ(all.input.high, (Xyz{ { 4, 4, 30 } }));
  EXPECT_EQ(all.chainsOffTerrain(), 2u);
}

} // namespace
} // namespace test
} // namespace ahd
