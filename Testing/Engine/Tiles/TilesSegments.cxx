// SPDX-License-Identifier: BSD-3-Clause
//
// The segments beside a rectangle are found exactly, and without a look at all others.
#include "Tiles/TileSegments.h"

#include "EngineRun.h"
#include "Listeners.h"
#include "Predicates/Discs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace ahd
{
namespace test
{
namespace
{

/// A line, and loops of one to four corners.
TileLines linesAmong(const std::vector<Point>& corners)
{
  TileLines lines;
  lines.corners = corners;
  lines.lines = 1;
  const std::size_t half = corners.size() / 2;
  lines.offsets = { 0, static_cast<std::int64_t>(half) };
  for (std::size_t at = half, length = 1; at != corners.size(); length = 1 + length % 4)
  {
    at = std::min(at + length, corners.size());
    lines.offsets.push_back(static_cast<std::int64_t>(at));
  }
  return lines;
}

/// By the definition: a segment of some length between finite places.
std::vector<EndPair> segmentsOf(const TileLines& lines)
{
  std::vector<EndPair> all;
  for (std::size_t chain = 0; chain != lines.chains(); ++chain)
  {
    const auto begin = std::size_t(lines.offsets[chain]),
               end = std::size_t(lines.offsets[chain + 1]);
    for (std::size_t k = begin; k != end; ++k)
    {
      const bool isLast = k + 1 == end;
      const Point from = lines.corners[k], to = lines.corners[isLast ? begin : k + 1];
      if (!(isLast && chain < lines.lines) && isFinite(from) && isFinite(to) && !(from == to))
      {
        all.push_back({ from, to });
      }
    }
  }
  return all;
}

/// Two triangles make the rectangle, or it is a segment, or a point.
bool meets(const EndPair& s, const Bounds& r)
{
  const Point a{ r.xmin, r.ymin }, b{ r.xmax, r.ymin }, c{ r.xmax, r.ymax }, d{ r.xmin, r.ymax };
  return touches({ a, b, c }, s.from, s.to) || touches({ a, c, d }, s.from, s.to);
}

using Ends = std::array<double, 4>;

std::vector<Ends> sorted(const std::vector<EndPair>& segments)
{
  std::vector<Ends> ends;
  for (const EndPair& s : segments)
  {
    ends.push_back({ { s.from.x, s.from.y, s.to.x, s.to.y } });
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

std::vector<EndPair> found(const TileSegments& segments, const Bounds& region)
{
  std::vector<EndPair> found;
  Ticker ticker(nullptr, Phase::Outputs, 0);
  EXPECT_TRUE(segments.listIn(region, found, ticker));
  return found;
}

void expectThose(const TileLines& lines, const std::vector<Bounds>& regions)
{
  const TileSegments segments(lines);
  const std::vector<EndPair> all = segmentsOf(lines);
  for (const Bounds& region : regions)
  {
    std::vector<EndPair> wanted;
    std::copy_if(all.begin(), all.end(), std::back_inserter(wanted),
      [&](const EndPair& s) { return meets(s, region); });
    EXPECT_EQ(sorted(found(segments, region)), sorted(wanted)) << all.size() << " segments";
  }
}

TEST(TilesSegments, AreThoseThatTouchTheRectangle)
{
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  std::mt19937 random(5);
  for (unsigned round = 0; round != reduced(300); ++round)
  {
    const unsigned side = 2 + round % 30; // of a lattice: much touches in a point
    const double scale = std::ldexp(1.0, int(round % 7) * 300 - 1000);
    const auto number = [&] { return scale * (double(random() % (2 * side)) - side); };
    std::vector<Point> corners(random() % 200);
    for (Point& p : corners)
    {
      p = { random() % 50 == 0 ? kNaN : number(), number() };
    }
    std::vector<Bounds> regions;
    for (unsigned k = 0; k != 20; ++k)
    {
      const double x = number(), y = number();
      regions.push_back(
        { x, x + scale * double(1 + random() % side), y, y + scale * double(1 + random() % side) });
    }
    expectThose(linesAmong(corners), regions);
  }
}

TEST(TilesSegments, NoneAreNone)
{
  EXPECT_TRUE(found(TileSegments(TileLines()), { 0, 1, 0, 1 }).empty());
  expectThose(linesAmong({ { 1, 1 }, { 1, 1 }, { 1, 1 } }), { { 0, 2, 0, 2 } });
}

/// All squares of a lattice: a look at each segment from each square were 400 million steps.
TEST(TilesSegments, FewAreLookedAt)
{
  constexpr unsigned kSide = 64, kSegments = 100000;
  std::mt19937 random(6);
  std::vector<Point> corners;
  Point at{ 0.5, 0.5 };
  for (unsigned k = 0; k != 2 * kSegments; ++k)
  {
    const auto moved = [&](double v)
    { return std::min(1.0, std::max(0.0, v + 0.01 * (double(random() % 1001) / 1000 - 0.5))); };
    at = { moved(at.x), moved(at.y) };
    corners.push_back(at);
  }
  const TileSegments segments(linesAmong(corners));
  Listener listener;
  std::size_t listed = 0;
  {
    Ticker ticker(&listener, Phase::Outputs, 0);
    for (unsigned k = 0; k != kSide * kSide; ++k)
    {
      const double x = double(k % kSide) / kSide, y = double(k / kSide) / kSide;
      std::vector<EndPair> some;
      ASSERT_TRUE(segments.listIn({ x, x + 1.0 / kSide, y, y + 1.0 / kSide }, some, ticker));
      listed += some.size();
    }
  }
  EXPECT_GE(listed, std::size_t(kSegments));
  EXPECT_LE(listener.askings() * (kStepsPerAsking / 2), std::size_t(2000) * kSide * kSide);
}

} // namespace
} // namespace test
} // namespace ahd
