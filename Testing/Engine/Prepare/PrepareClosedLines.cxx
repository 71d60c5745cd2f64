// SPDX-License-Identifier: BSD-3-Clause
//
// Lines that end where they begin, alone or joined to others, as loops on request.
#include "PrepareCase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace ahd
{
namespace test
{
namespace
{

using Ids = std::vector<std::int64_t>;

/// A square; its first corner again, at another height; a place nearby; one that is not finite.
const std::vector<Xyz> kPoints = { { { 0, 0, 1 } }, { { 4, 0, 2 } }, { { 4, 4, 3 } },
  { { 0, 4, 4 } }, { { 0, 0, 9 } }, { { 0.1, 0, 1 } },
  { { std::numeric_limits<double>::quiet_NaN(), 0, 0 } } };

struct Chains
{
  std::vector<Ids> open, loops;
  std::vector<std::int64_t> cells;
  bool operator==(const Chains& other) const
  {
    return open == other.open && loops == other.loops && cells == other.cells;
  }
};

Chains chainsOf(PrepareCase& given)
{
  PreparedInput out;
  EXPECT_EQ(prepare(given.request, Context(), out), Status::Ok);
  const ConstraintView view = out.constraints();
  Chains result;
  for (std::size_t k = 0; k < view.chains; ++k)
  {
    const Ids ids(view.ids + view.offsets[k], view.ids + view.offsets[k + 1]);
    (k < view.lines ? result.open : result.loops).push_back(ids);
    result.cells.push_back(out.cellOf(k));
  }
  return result;
}

const Cells kLines = { { 0, 1, 2, 0 }, { 0, 1, 2 }, { 0, 1, 2, 3, 4 }, { 2, 3 }, { 0, 1, 2, 5 } };

TEST(PrepareClosedLines, AreLinesUnlessAskedFor)
{
  PrepareCase given({}, kPoints, kLines, { { 1, 2, 3 } });
  given.request.firstCell = 10;
  const Chains found = chainsOf(given);
  EXPECT_EQ(found.open, kLines);
  EXPECT_EQ(found.loops, (Cells{ { 1, 2, 3 } }));
  EXPECT_EQ(found.cells, (Ids{ 10, 11, 12, 13, 14, 15 }));
}

TEST(PrepareClosedLines, AreLoopsWhereTheirEndsCoincide)
{
  for (const bool wide : { false, true })
  {
    PrepareCase given({}, kPoints, kLines, { { 1, 2, 3 } });
    given.setWide(wide);
    given.request.firstCell = 10;
    given.request.closedLinesAreLoops = true;
    const Chains found = chainsOf(given);
    EXPECT_EQ(found.open, (Cells{ { 0, 1, 2 }, { 2, 3 }, { 0, 1, 2, 5 } }));
    EXPECT_EQ(found.loops, (Cells{ { 0, 1, 2, 0 }, { 0, 1, 2, 3, 4 }, { 1, 2, 3 } }));
    EXPECT_EQ(found.cells, (Ids{ 11, 13, 14, 10, 12, 15 })) << "each keeps its number";
  }
}

TEST(PrepareClosedLines, WithoutOneNothingMoves)
{
  const Cells lines = { { 0, 1 }, { 1, 2, 3 }, { 0, 1, 0 }, { 4, 0 }, { 6, 1, 2, 6 },
    { -1, 1, 2, -1 }, { 0, 1, 2, 9 } };
  PrepareCase given({}, kPoints, lines, { { 1, 2, 3 } });
  const Chains expected = chainsOf(given);
  given.request.closedLinesAreLoops = true;
  Chains found = chainsOf(given);
  // one id, of a rejected point: closed by its numbers
  EXPECT_EQ(found.loops, (Cells{ { 6, 1, 2, 6 }, { 1, 2, 3 } }));
  found.loops.erase(found.loops.begin());
  EXPECT_EQ(found.open.size() + 1, expected.open.size());
}

/// kPoints[4] lies at the place of kPoints[0].
TEST(PrepareClosedLines, LinesThatMeetAreJoined)
{
  struct Case
  {
    Cells lines;
    std::vector<Ids> loops;
    std::vector<std::int64_t> cells;
  };
  const std::vector<Case> cases = {
    { { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } }, { { 0, 1, 2, 3, 0 } }, { 0 } },
    { { { 2, 3 }, { 1, 2 }, { 3, 4 }, { 0, 1 } }, { { 2, 3, 4, 0, 1, 2 } }, { 0 } },
    // as that runs which begins at the least place: 3, 0 does not
    { { { 1, 0 }, { 1, 2 }, { 3, 2 }, { 3, 0 } }, { { 0, 1, 2, 3, 0 } }, { 0 } },
    { { { 1, 3 }, { 0, 1 }, { 0, 3 } }, { { 3, 1, 0, 3 } }, { 0 } },
    // longer ones, with an open one between
    { { { 3, 2, 1 }, { 5, 2 }, { 1, 0, 3 } }, { { 3, 2, 1, 0, 3 } }, { 0 } },
  };
  for (const Case& one : cases)
  {
    PrepareCase given({}, kPoints, one.lines, { { 1, 2, 3 } });
    given.request.closedLinesAreLoops = true;
    const Chains found = chainsOf(given);
    ASSERT_EQ(found.loops.size(), one.loops.size() + 1);
    EXPECT_EQ(found.loops.back(), (Ids{ 1, 2, 3 }));
    EXPECT_TRUE(std::equal(one.loops.begin(), one.loops.end(), found.loops.begin()))
      << ::testing::PrintToString(found.loops);
    EXPECT_EQ(found.cells[found.open.size()], one.cells[0]);
  }
}

TEST(PrepareClosedLines, WhereThreeEndEachEnds)
{
  const std::vector<Xyz> points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } },
    { { 0, 1, 0 } }, { { -1, 0, 0 } }, { { -1, -1, 0 } }, { { 0, -1, 0 } } };
  const auto loopsOf = [&points](const Cells& lines)
  {
    PrepareCase given({}, points, lines);
    given.request.closedLinesAreLoops = true;
    return chainsOf(given).loops;
  };
  const Cells square = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } };
  const auto with = [&square](const Cells& more)
  {
    Cells all = square;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  EXPECT_EQ(loopsOf(with({ { 0, 4 } })).size(), 1u) << "a loop at the end of a line";
  EXPECT_EQ(loopsOf(with({ { 0, 4 }, { 4, 5 }, { 5, 6 }, { 6, 0 } })).size(), 2u) << "an eight";
  EXPECT_EQ(loopsOf(with({ { 0, 2 } })).size(), 0u) << "two places where three end";
  EXPECT_EQ(loopsOf(with({ { 0, 1 } })).size(), 0u) << "one line twice";
  EXPECT_EQ(loopsOf(with({ { 0, 4, 5, 0 } })).size(), 2u) << "a closed line ends nowhere";
  EXPECT_EQ(loopsOf({ { 0, 1 }, { 1, 0 } }).size(), 0u) << "two segments";
  EXPECT_EQ(loopsOf({ { 0, 1 }, { 1, 2, 0 } }).size(), 1u);
}

TEST(PrepareClosedLines, LinesThatAllStayOpenAreReported)
{
  const auto isReported = [](const Cells& lines, const Cells& polygons, bool closes)
  {
    PrepareCase given({}, kPoints, lines, polygons);
    given.request.closedLinesAreLoops = closes;
    PreparedInput out;
    EXPECT_EQ(prepare(given.request, Context(), out), Status::Ok);
    return out.areLinesUnclosed();
  };
  EXPECT_TRUE(isReported({ { 0, 1 }, { 1, 2 } }, {}, true));
  EXPECT_TRUE(isReported({ { 0, 1 }, { 1, 2 } }, { { 1, 2, 3 } }, true));
  EXPECT_FALSE(isReported({ { 0, 1 }, { 1, 2 } }, {}, false));
  EXPECT_FALSE(isReported({ { 0, 1 }, { 1, 2 }, { 2, 3, 4 } }, {}, true));
  EXPECT_FALSE(isReported({ { 0, 1 }, { 0, 1, 2, 0 } }, {}, true));
  EXPECT_FALSE(isReported({}, { { 1, 2, 3 } }, true));
  EXPECT_FALSE(isReported({ { 0 }, {}, { 2 } }, { { 1, 2, 3 } }, true)) << "no segment";
}

/// The places that each loop joins, and how often, whatever its direction and beginning.
std::multiset<std::multiset<std::pair<Xyz, Xyz>>> placesOf(
  const std::vector<Ids>& loops, const std::vector<Xyz>& points)
{
  std::multiset<std::multiset<std::pair<Xyz, Xyz>>> all;
  for (const Ids& loop : loops)
  {
    std::multiset<std::pair<Xyz, Xyz>> segments;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Xyz& a = points[std::size_t(loop[i])];
      const Xyz& b = points[std::size_t(loop[(i + 1) % loop.size()])];
      a != b ? void(segments.insert(std::minmax(a, b))) : void();
    }
    all.insert(segments);
  }
  return all;
}

/// By their definition: lines with an end at one place belong together if no third has one there;
/// what belongs together is a loop if all its ends are joined, or the two that are not lie at one
/// place.
std::size_t loopsByDefinition(const Cells& lines, const std::vector<Xyz>& points)
{
  std::map<Xyz, std::vector<std::size_t>> at;
  std::vector<std::size_t> group(lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    group[k] = k;
    const Xyz &first = points[std::size_t(lines[k].front())],
              &last = points[std::size_t(lines[k].back())];
    first != last ? at[first].push_back(k) : void();
    first != last ? at[last].push_back(k) : void();
  }
  for (std::size_t turn = 0; turn < lines.size(); ++turn)
  {
    for (const auto& place : at)
    {
      if (place.second.size() == 2)
      {
        auto &a = group[place.second[0]], &b = group[place.second[1]];
        a = b = std::min(a, b);
      }
    }
  }
  std::map<std::size_t, std::multiset<Xyz>> loose;
  std::map<std::size_t, std::size_t> segments;
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    segments[group[k]] += lines[k].size() - 1;
    for (const std::int64_t id : { lines[k].front(), lines[k].back() })
    {
      const Xyz& place = points[std::size_t(id)];
      at[place].size() == 2 ? void() : void(loose[group[k]].insert(place));
    }
  }
  return std::size_t(std::count_if(segments.begin(), segments.end(),
    [&](const auto& one)
    {
      const std::multiset<Xyz>& ends = loose[one.first];
      return one.second > 2 &&
        (ends.empty() || (ends.size() == 2 && *ends.begin() == *ends.rbegin()));
    }));
}

TEST(PrepareClosedLines, LoopsDoNotDependOnOrderAndDirections)
{
  std::mt19937_64 random(5);
  std::size_t all = 0;
  for (int turn = 0; turn < 3000; ++turn)
  {
    // few places, each with two points
    std::vector<Xyz> points;
    const std::size_t places = 3 + random() % 8;
    for (std::size_t i = 0; i < 2 * places; ++i)
    {
      points.push_back({ { double(i % places), double(i % places * 7 % 5), 0.0 } });
    }
    Cells lines(1 + random() % 8);
    for (auto& line : lines)
    {
      line.resize(2 + (random() % 3 == 0 ? random() % 3 : 0));
      std::generate(
        line.begin(), line.end(), [&] { return std::int64_t(random() % points.size()); });
    }
    const auto loops = [&points](const Cells& some)
    {
      PrepareCase given({}, points, some);
      given.request.closedLinesAreLoops = true;
      const Chains found = chainsOf(given);
      std::size_t segments = 0, expected = 0;
      for (const auto* const chains : { &found.open, &found.loops })
      {
        for (const Ids& ids : *chains)
        {
          segments += placesOf({ ids }, points).begin()->size() -
            (chains == &found.open &&
              points[std::size_t(ids.front())] != points[std::size_t(ids.back())]);
        }
      }
      for (const Ids& ids : some)
      {
        expected += placesOf({ ids }, points).begin()->size() -
          (points[std::size_t(ids.front())] != points[std::size_t(ids.back())]);
      }
      EXPECT_EQ(segments, expected) << "none is lost";
      return found.loops;
    };
    const auto expected = placesOf(loops(lines), points);
    ASSERT_EQ(expected.size(), loopsByDefinition(lines, points)) << turn;
    all += expected.size();
    for (int again = 0; again < 3; ++again)
    {
      std::shuffle(lines.begin(), lines.end(), random);
      for (auto& line : lines)
      {
        random() % 2 == 0 ? std::reverse(line.begin(), line.end()) : void();
      }
      ASSERT_EQ(placesOf(loops(lines), points), expected) << turn;
    }
  }
  EXPECT_GT(all, 300u);
}

TEST(PrepareClosedLines, EndsThatAreMergedAreOnePoint)
{
  PrepareCase given({}, kPoints, kLines);
  given.request.closedLinesAreLoops = true;
  given.request.tolerance = 0.05; // of a diagonal of 5.7
  EXPECT_EQ(chainsOf(given).loops.size(), 3u);
}

TEST(PrepareClosedLines, TheirPlacesAreThoseInThePlane)
{
  // a wall: ends with the same place in the plane x, z lie apart in x, y
  class XZ : public Projection
  {
  public:
    bool project(const PointView& points, double* to, const Context&) const override
    {
      for (std::size_t i = 0; i < points.count; ++i)
      {
        std::swap(to[3 * i + 1], to[3 * i + 2]);
      }
      return true;
    }
  } projection;
  const std::vector<Xyz> wall = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 0, 1 } },
    { { 0, 7, 0 } } };
  PrepareCase given({}, wall, { { 0, 1, 2, 3 } });
  given.request.closedLinesAreLoops = true;
  EXPECT_EQ(chainsOf(given).loops.size(), 0u);
  given.request.projection = &projection;
  EXPECT_EQ(chainsOf(given).loops.size(), 1u);
}

TEST(PrepareClosedLines, CrossingsNameTheCells)
{
  const std::vector<Xyz> points = { { { 0, 0, 0 } }, { { 4, 0, 0 } }, { { 4, 4, 0 } },
    { { 0, 4, 0 } }, { { 2, 2, 0 } }, { { 2, 9, 0 } } };
  PrepareCase given({}, points, { { 0, 1, 2, 3, 0 }, { 4, 5 } });
  given.request.closedLinesAreLoops = given.request.split = true;
  PreparedInput out;
  ASSERT_EQ(prepare(given.request, Context(), out), Status::Ok);
  ASSERT_EQ(out.crossingCells().size(), 1u);
  EXPECT_EQ(out.crossingCells()[0], (std::array<std::int64_t, 2>{ { 0, 1 } }))
    << "the loop comes after the line";
}

} // namespace
} // namespace test
} // namespace ahd
