// SPDX-License-Identifier: BSD-3-Clause
//
// Points added to lines, so that these lie on the surface that their heights come from, or are
// short: against the definition.
#include "PrepareSurface.h"

#include "Listeners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ahd
{
namespace test
{
namespace
{

using Places = Surface::Places;

double fraction(std::mt19937_64& random)
{
  return double(random() >> 11) * 0x1p-53;
}

std::vector<Xyz> randomPoints(std::size_t count, unsigned seed, double low = 0.0, double high = 1.0)
{
  std::mt19937_64 random(seed);
  std::vector<Xyz> points(count);
  for (Xyz& p : points)
  {
    p = { { low + (high - low) * fraction(random), low + (high - low) * fraction(random),
      fraction(random) } };
  }
  return points;
}

/// On whole coordinates from 0 to `side`: lines run along edges and through vertices.
std::vector<Xyz> wholePoints(std::size_t count, unsigned seed, int side)
{
  std::vector<Xyz> points = randomPoints(count, seed, 0.0, double(side + 1));
  for (Xyz& p : points)
  {
    p[0] = std::floor(p[0]);
    p[1] = std::floor(p[1]);
  }
  return points;
}

std::vector<Xyz> grid(int side)
{
  std::vector<Xyz> points;
  for (int i = 0; i < side * side; ++i)
  {
    points.push_back({ { double(i % side), double(i / side), double(i * 7 % 11) } });
  }
  return points;
}

/// A point in the middle of an arc, which is a neighbour of all on it.
std::vector<Xyz> hub(double turn, int count = 150)
{
  std::vector<Xyz> points = { { { 0, 0, 5 } } };
  for (int k = 0; k < count; ++k)
  {
    const double angle = turn * k / (count - 1);
    points.push_back({ { std::cos(angle), std::sin(angle), std::cos(5 * angle) } });
  }
  return points;
}

/// Ends of lines through the middle, or from it.
std::vector<Xyz> spokes(std::size_t count)
{
  std::vector<Xyz> ends;
  for (const Xyz& p : randomPoints(count, 13, -1.2, 1.2))
  {
    ends.push_back(p);
    ends.push_back(ends.size() % 3 == 0 ? Xyz{ { 0, 0, 1 } } : Xyz{ { -p[0], -p[1], 1 } });
  }
  for (std::size_t k = 0; k < 8; ++k) // along axes
  {
    ends.push_back({ { k % 2 == 0 ? 0.0
        : k < 4                   ? 0.5
                                  : -0.5,
      k % 2 == 1 ? 0.0
        : k < 4  ? 0.5
                 : -0.5,
      0 } });
    ends.push_back({ { 0, 0, 0 } });
  }
  return ends;
}

struct Case
{
  std::string name;
  std::vector<Xyz> input, source;
};

std::vector<Case> cases()
{
  return { { "random", randomPoints(200, 1), randomPoints(40, 2) },
    { "across the hull", randomPoints(200, 3), randomPoints(60, 4, -1.0, 2.0) },
    { "a grid", grid(9), wholePoints(60, 5, 8) },
    { "a grid, from beyond it", grid(5), wholePoints(60, 6, 14) },
    { "whole numbers", wholePoints(40, 7, 12), wholePoints(60, 8, 12) },
    { "a triangle", { { { 0, 0, 1 } }, { { 4, 0, 2 } }, { { 0, 4, 5 } } },
      randomPoints(40, 9, -2.0, 6.0) },
    { "through a hub", hub(6.25), spokes(60) },
    { "through a hub on the hull", hub(2.5), spokes(60) },
    { "nearly on a line", wholePoints(30, 10, 2), randomPoints(40, 11, 0.0, 2.0) } };
}

/// Lines of two points each.
Cells pairsOf(std::size_t points)
{
  Cells cells;
  for (std::size_t i = 0; i + 1 < points; i += 2)
  {
    cells.push_back({ std::int64_t(i), std::int64_t(i + 1) });
  }
  return cells;
}

TEST(PrepareLines, HaveTheirPointsWhereTheDefinitionSays)
{
  for (const Case& one : cases())
  {
    SCOPED_TRACE(one.name);
    PrepareCase given(one.input, one.source, pairsOf(one.source.size()));
    const PreparedInput out = laid(given);
    const Surface surface(one.input);
    const ConstraintView chains = out.constraints();
    std::size_t stops = 0;
    for (std::size_t chain = 0; chain < chains.chains; ++chain)
    {
      Places found;
      const std::int64_t* const begin = chains.ids + chains.offsets[chain];
      const std::int64_t* const end = chains.ids + chains.offsets[chain + 1];
      for (const std::int64_t* id = begin + 1; id + 1 < end; ++id)
      {
        const Point p = out.points()[std::size_t(*id)];
        ASSERT_TRUE(found.insert({ p.x, p.y }).second) << "twice";
      }
      const Point a = out.points()[std::size_t(*begin)], b = out.points()[std::size_t(end[-1])];
      ASSERT_EQ(found, surface.stopsOf(a, b)) << chain;
      stops += found.size();
    }
    EXPECT_GT(stops, 10u);
    EXPECT_GT(out.addedToLines(), 5u);
  }
}

TEST(PrepareLines, LieOnTheSurface)
{
  for (const Case& one : cases())
  {
    SCOPED_TRACE(one.name);
    PrepareCase given(one.input, one.source, pairsOf(one.source.size()));
    const PreparedInput out = laid(given);
    const Surface surface(one.input);
    const ConstraintView chains = out.constraints();
    for (std::size_t chain = 0; chain < chains.chains; ++chain)
    {
      for (std::int64_t k = chains.offsets[chain]; k + 1 < chains.offsets[chain + 1]; ++k)
      {
        const Xyz a = out.place(std::size_t(chains.ids[k]));
        const Xyz b = out.place(std::size_t(chains.ids[k + 1]));
        for (const double t : { 0.01, 0.3, 0.5, 0.99 })
        {
          const auto at = [&](std::size_t c) { return (1.0 - t) * a[c] + t * b[c]; };
          const double height = surface.heightAt({ at(0), at(1) });
          if (!std::isnan(height))
          {
            ASSERT_NEAR(at(2), height, 1e-7) << chain;
          }
        }
      }
    }
  }
}

/// Of the points added.
Places placesOf(const PreparedInput& out)
{
  Places places;
  for (std::size_t k = 0; k < out.addedToLines(); ++k)
  {
    const Xyz p = out.place(out.inputCount() + out.sourceCount() + k);
    places.insert({ p[0], p[1] });
  }
  EXPECT_EQ(places.size(), out.addedToLines()) << "one at each place";
  return places;
}

TEST(PrepareLines, AreTheSamePointsInAnyOrderAndDirection)
{
  for (const Case& one : cases())
  {
    SCOPED_TRACE(one.name);
    Cells cells = pairsOf(one.source.size());
    PrepareCase given(one.input, one.source, cells);
    given.request.maximumSegmentLength = 0.37;
    const Places places = placesOf(laid(given));
    std::reverse(cells.begin(), cells.end());
    for (auto& cell : cells)
    {
      std::reverse(cell.begin(), cell.end());
    }
    cells.push_back(cells[3]); // the same line twice
    PrepareCase turned(one.input, one.source, cells);
    turned.request.maximumSegmentLength = 0.37;
    EXPECT_EQ(placesOf(laid(turned)), places);
  }
}

TEST(PrepareLines, AreStraightUnlessAskedFor)
{
  const Case one = cases()[0];
  PrepareCase given(one.input, one.source, pairsOf(one.source.size()));
  given.request.heights = SourceHeights::FromSurface;
  const PreparedInput straight = prepared(given.request);
  EXPECT_EQ(straight.addedToLines(), 0u);
  EXPECT_EQ(straight.points().count, one.input.size() + one.source.size());
  PrepareCase own(one.input, one.source, pairsOf(one.source.size()));
  EXPECT_EQ(laid(own, SourceHeights::Own).addedToLines(), 0u);
}

TEST(PrepareLines, LoopsAreLaidAllAround)
{
  const std::vector<Xyz> input = grid(6);
  const std::vector<Xyz> square = { { { 0.5, 0.75, -1 } }, { { 4.5, 0.75, -1 } },
    { { 4.5, 4.25, -1 } }, { { 0.5, 4.25, -1 } } };
  PrepareCase given(input, square, {}, { { 0, 1, 2, 3 }, { 0, 1, 2, 3, 0 } });
  const PreparedInput out = laid(given);
  const ConstraintView chains = out.constraints();
  ASSERT_EQ(chains.chains, 2u);
  EXPECT_EQ(chains.lines, 0u);
  const auto sizeOf = [&](std::size_t k) { return chains.offsets[k + 1] - chains.offsets[k]; };
  EXPECT_EQ(sizeOf(0) + 1, sizeOf(1)) << "the end that is its begin";
  EXPECT_EQ(std::size_t(sizeOf(0)), 4 + out.addedToLines());
  const Surface surface(input);
  std::size_t stops = 0;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const Xyz &a = square[k], &b = square[(k + 1) % 4];
    stops += surface.stopsOf({ a[0], a[1] }, { b[0], b[1] }).size();
  }
  EXPECT_EQ(out.addedToLines(), stops);
}

TEST(PrepareLines, ClosedLinesOfTwoSegmentsStayOpen)
{
  PrepareCase given(grid(6), { { { 0.5, 0.75, 0 } }, { { 4.5, 2.75, 0 } } }, { { 0, 1, 0 } });
  given.request.closedLinesAreLoops = true;
  EXPECT_EQ(laid(given).constraints().lines, 1u);
}

TEST(PrepareLines, OutsideTheSurfaceTheyAreStraight)
{
  PrepareCase given({ { { 0, 0, 0 } }, { { 4, 0, 4 } }, { { 0, 4, 0 } }, { { 4, 4, 4 } } },
    { { { -4, 1, 9 } }, { { 8, 1, 9 } } }, { { 0, 1 } });
  given.request.maximumSegmentLength = 2.0;
  const PreparedInput out = laid(given);
  EXPECT_EQ(out.outsideCount(), 2u);
  const ConstraintView chains = out.constraints();
  std::vector<Xyz> line;
  for (std::int64_t k = 0; k < chains.offsets[1]; ++k)
  {
    line.push_back(out.place(std::size_t(chains.ids[k])));
  }
  ASSERT_GE(line.size(), 8u);
  EXPECT_EQ(line[1], (Xyz{ { -2, 1, 4.5 } })) << "between its own height and that of the rim";
  EXPECT_EQ(line[2], (Xyz{ { 0, 1, 0 } }));
  EXPECT_EQ(line[line.size() - 3], (Xyz{ { 4, 1, 4 } }));
  EXPECT_EQ(line[line.size() - 2], (Xyz{ { 6, 1, 6.5 } }));
}

TEST(PrepareLines, NoPieceIsLongerThanTheMaximum)
{
  for (const SourceHeights heights : { SourceHeights::Own, SourceHeights::FromSurface })
  {
    const Case one = cases()[1];
    PrepareCase given(one.input, one.source, pairsOf(one.source.size()));
    given.request.maximumSegmentLength = 0.06;
    const PreparedInput out = laid(given, heights);
    const ConstraintView chains = out.constraints();
    for (std::size_t chain = 0; chain < chains.chains; ++chain)
    {
      const Xyz first = out.place(std::size_t(chains.ids[chains.offsets[chain]]));
      const Xyz last = out.place(std::size_t(chains.ids[chains.offsets[chain + 1] - 1]));
      for (std::int64_t k = chains.offsets[chain]; k + 1 < chains.offsets[chain + 1]; ++k)
      {
        const Xyz a = out.place(std::size_t(chains.ids[k]));
        const Xyz b = out.place(std::size_t(chains.ids[k + 1]));
        ASSERT_LE(std::hypot(b[0] - a[0], b[1] - a[1]), 0.06 * (1 + 1e-14));
        if (heights == SourceHeights::Own)
        {
          const double t = (b[0] - first[0]) / (last[0] - first[0]);
          ASSERT_NEAR(b[2], first[2] + t * (last[2] - first[2]), 1e-9) << "linear";
        }
      }
    }
  }
}

TEST(PrepareLines, AreDividedEvenIfTheirLengthIsNoDouble)
{
  PrepareCase given(grid(3), { { { -1.7e308, 0, 0 } }, { { 1.7e308, 0, 1 } } }, { { 0, 1 } });
  given.request.maximumSegmentLength = 1e308;
  const PreparedInput out = prepared(given.request);
  ASSERT_EQ(out.addedToLines(), 3u);
  EXPECT_EQ(out.place(12), (Xyz{ { 0, 0, 0.5 } }));
}

TEST(PrepareLines, AreDividedBetweenPointsOfTheInputToo)
{
  PrepareCase given(grid(3), {}, { { 0, 8 } });
  given.request.idsAreOfInput = true;
  given.request.maximumSegmentLength = 1.0;
  const PreparedInput out = prepared(given.request);
  EXPECT_EQ(out.addedToLines(), 2u);
  EXPECT_EQ(out.place(9)[0], 2.0 / 3);
  EXPECT_EQ(out.surfacePlaces().size(), 2u);
}

TEST(PrepareLines, TooManyPointsAreRefused)
{
  PrepareCase given(grid(9), { { { 0.5, 0.75, 0 } }, { { 7.5, 6.75, 0 } } }, { { 0, 1 } });
  const std::size_t all = laid(given).addedToLines();
  ASSERT_GT(all, 5u);
  PreparedInput out;
  given.request.mostCrossings = all;
  EXPECT_EQ(prepare(given.request, Context(), out), Status::Ok);
  PreparedInput none;
  given.request.mostCrossings = all - 1;
  EXPECT_EQ(prepare(given.request, Context(), none), Status::TooManyCrossings);
  PreparedInput tiny;
  given.request.maximumSegmentLength = 1e-300;
  EXPECT_EQ(prepare(given.request, Context(), tiny), Status::TooManyCrossings);
}

TEST(PrepareLines, TakeFewStepsThroughAHubAndInAnyOrder)
{
  std::vector<Xyz> fromHub = spokes(2000);
  for (std::size_t i = 1; i < fromHub.size(); i += 2)
  {
    fromHub[i] = { { 0, 0, 0 } };
  }
  std::reverse(fromHub.begin(), fromHub.end()); // each line begins at the hub
  std::vector<Xyz> pieces = randomPoints(20000, 14);
  for (std::size_t i = 1; i < pieces.size(); i += 2)
  {
    pieces[i] = { { pieces[i - 1][0] + 0.001, pieces[i - 1][1], 0 } };
  }
  const std::vector<Case> many = { { "hub", hub(6.25, 20000), fromHub },
    { "short segments in random order", randomPoints(40000, 15), pieces } };
  for (const Case& one : many)
  {
    SCOPED_TRACE(one.name);
    PrepareCase given(one.input, one.source, pairsOf(one.source.size()));
    given.request.heights = SourceHeights::FromSurface;
    const auto stepsOf = [&given](bool areLaid)
    {
      given.request.linesOnSurface = areLaid;
      Listener counter;
      PreparedInput out;
      EXPECT_EQ(prepare(given.request, Context{ &counter, nullptr }, out), Status::Ok);
      return counter.askings() * kStepsPerAsking;
    };
    const std::size_t straight = stepsOf(false);
    EXPECT_LE(stepsOf(true), straight + 200 * one.source.size());
  }
}

TEST(PrepareLines, GoThroughNoPointThatWasMergedIntoAnother)
{
  std::vector<Xyz> input = grid(5);
  input.push_back({ { 2.001, 2.0, 50 } }); // near a vertex on the line
  PrepareCase given(input, { { { 0.5, 2, 0 } }, { { 3.5, 2, 0 } } }, { { 0, 1 } });
  given.request.tolerance = 0.001;
  const PreparedInput out = laid(given);
  ASSERT_EQ(out.merged().size(), 1u);
  const ConstraintView chains = out.constraints();
  for (std::int64_t k = 0; k < chains.offsets[1]; ++k)
  {
    EXPECT_FALSE(out.points().skipped(std::size_t(chains.ids[k])));
  }
}

} // namespace
} // namespace test
} // namespace ahd
