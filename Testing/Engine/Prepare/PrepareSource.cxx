// SPDX-License-Identifier: BSD-3-Clause
//
// A source of points alone as a line.
#include "PrepareCase.h"

#include <gtest/gtest.h>

namespace ahd
{
namespace test
{
namespace
{

using Ids = std::vector<std::int64_t>;

const std::vector<Xyz> kTerrain = { { { 0, 0, 10 } }, { { 4, 0, 20 } }, { { 4, 4, 30 } },
  { { 0, 4, 40 } } };
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

} // namespace
} // namespace test
} // namespace ahd
