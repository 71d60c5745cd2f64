// SPDX-License-Identifier: BSD-3-Clause
//
// Whether points stand like a wall: the cases that decide, each in any order, unit and number of
// threads; and the spread of heights within cells, by its definition.
#include "Surface/Footprint.h"

#include "PlaneMaker.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <functional>
#include <map>
#include <string>

namespace ahd
{
namespace test
{
namespace
{

enum class Expected
{
  Xy,
  XyAndToldIfFitted,
  Wall
};

struct Case
{
  const char* name;
  Expected expected;
  std::size_t count;
  std::function<Xyz(double, double, double, std::size_t)> make; ///< of numbers from 0 to 1
};

constexpr double kDegree = 1 / 111000.0;

/// Trees of 20 m on level ground: every other point is one of them.
double forest(double s, std::size_t i)
{
  return i % 2 == 0 ? 20 * s : 0.1 * s;
}

double hills(double along)
{
  return 30 * std::sin(9 * along) + 3 * std::sin(40 * along);
}

Xyz inDegrees(const Xyz& p)
{
  return { { 10 + kDegree * p[0], 50 + kDegree * p[1], p[2] } };
}

/// A road of 5 km and 12 m, with a crown and noise.
Xyz road(double s, double t, double u)
{
  const double x = 5000 * s, y = 12 * (t - 0.5);
  return { { 0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y, hills(s) - 0.02 * std::fabs(y) + 0.02 * u } };
}

/// A face of 20 m and 10 m with relief, leaning back from the vertical.
Xyz face(double s, double t, double relief, double lean)
{
  const double along = 20 * s, up = 10 * t;
  const double out = relief * (std::sin(1.3 * along + up) + std::sin(2.9 * up - 0.4 * along));
  const double back = up * std::sin(lean) - out * std::cos(lean);
  return { { 0.9 * along - 0.43 * back, 0.43 * along + 0.9 * back,
    up * std::cos(lean) + out * std::sin(lean) } };
}

std::vector<Case> broadCases()
{
  using Size = std::size_t;
  return {
    { "soundings in metres", Expected::Xy, 20000,
      [](double s, double t, double, Size) {
        return Xyz{ { 3e5 * s, 2e5 * t, 2000 * std::sin(5 * s) * std::cos(4 * t) } };
      } },
    { "soundings in degrees", Expected::XyAndToldIfFitted, 20000,
      [](double s, double t, double, Size) {
        return Xyz{ { 245 + 3 * s, 25 + 2 * t, 2000 * std::sin(5 * s) * std::cos(4 * t) } };
      } },
    { "shallow soundings in degrees", Expected::XyAndToldIfFitted, 20000,
      [](double s, double t, double, Size) {
        return Xyz{ { 245 + 3 * s, 25 + 2 * t, 10 * std::sin(5 * s) * std::cos(4 * t) } };
      } },
    { "a track in degrees", Expected::XyAndToldIfFitted, 600,
      [](double s, double t, double, Size) {
        return Xyz{ { 245 + 3 * s, 25 + s + 0.05 * t, 2000 * std::sin(5 * s) } };
      } },
    { "lidar in metres", Expected::Xy, 20000,
      [](double s, double t, double u, Size i) {
        return Xyz{ { 1200 * s, 400 * t, hills(s) + forest(u, i) } };
      } },
    { "lidar in degrees", Expected::XyAndToldIfFitted, 20000,
      [](double s, double t, double u, Size i) {
        return inDegrees({ { 1200 * s, 400 * t, hills(s) + forest(u, i) } });
      } },
    { "a corridor of forest in metres", Expected::Xy, 20000,
      [](double s, double t, double u, Size i) {
        return Xyz{ { 1200 * s, 40 * t, forest(u, i) } };
      } },
    { "a corridor of forest in degrees", Expected::XyAndToldIfFitted, 20000,
      [](double s, double t, double u, Size i) {
        return inDegrees({ { 1200 * s, 40 * t, forest(u, i) } });
      } },
    { "a grid on a slope of 45 degrees", Expected::Xy, 900,
      [](double, double, double, Size i) {
        return Xyz{ { double(i % 30), double(i / 30), double(i % 30) } };
      } },
    { "a narrow grid on a steeper slope", Expected::Xy, 500,
      [](double, double, double, Size i) {
        return Xyz{ { double(i % 100), double(i / 100), 3.0 * double(i % 100) } };
      } },
  };
}

std::vector<Case> narrowCases()
{
  using Size = std::size_t;
  return {
    { "a road", Expected::XyAndToldIfFitted, 5000,
      [](double s, double t, double u, Size) { return road(s, t, u); } },
    { "a road in degrees", Expected::XyAndToldIfFitted, 5000,
      [](double s, double t, double u, Size) { return inDegrees(road(s, t, u)); } },
    { "a level road", Expected::Xy, 5000,
      [](double s, double t, double u, Size) {
        return Xyz{ { 5000 * s, 12 * t, 0.02 * u } };
      } },
    { "a dike by profiles", Expected::Xy, 420,
      [](double, double, double, Size i)
      {
        const double y = 2.0 * double(i % 21) - 20;
        return Xyz{ { 50.0 * double(i / 21), y, 5 * std::max(0.0, 1 - std::fabs(y) / 15) } };
      } },
    { "a volume", Expected::Xy, 5000,
      [](double s, double t, double u, Size) {
        return Xyz{ { s, t, u } };
      } },
    { "a volume of layers", Expected::Xy, 1000,
      [](double, double, double, Size i) {
        return Xyz{ { double(i % 10), double(i / 10 % 10), double(i / 100) } };
      } },
    { "a beam", Expected::Xy, 5000,
      [](double s, double t, double u, Size) {
        return Xyz{ { 20 * s, 2 * t, 2 * u } };
      } },
    { "a wall along x", Expected::Wall, 40,
      [](double s, double, double u, Size) {
        return Xyz{ { 20 * s, 3, 8 * u } };
      } },
    { "a wall of columns", Expected::Wall, 40,
      [](double, double, double, Size i) {
        return Xyz{ { double(i % 8), 2.0 * double(i % 8), double(i / 8) } };
      } },
    { "four corners of a wall", Expected::Wall, 4,
      [](double, double, double, Size i) {
        return Xyz{ { 5e5 + 0.7 * double(i % 2), 5e6 + 0.1 * double(i % 2), double(i / 2) } };
      } },
    { "a scanned wall", Expected::Wall, 20000,
      [](double s, double, double u, Size) { return face(s, u, 0.02, 0); } },
    { "a rock face", Expected::Wall, 20000,
      [](double s, double, double u, Size) { return face(s, u, 0.6, 0); } },
    { "a rock face that leans", Expected::Wall, 20000,
      [](double s, double, double u, Size) { return face(s, u, 0.5, 0.2); } },
    { "a smooth wall that leans", Expected::Xy, 5000,
      [](double s, double, double u, Size) { return face(s, u, 0.01, 0.1); } },
    { "a pole", Expected::XyAndToldIfFitted, 500,
      [](double s, double t, double u, Size) {
        return Xyz{ { 0.1 * s, 0.1 * t, 30 * u } };
      } },
    { "soundings, and one point far away", Expected::Xy, 20000,
      [](double s, double t, double, Size i)
      {
        const double far = i == 77 ? 1e6 : 0.0;
        return Xyz{ { s + far, t, 200 * std::sin(5 * s) } };
      } },
  };
}

std::vector<Case> cases()
{
  std::vector<Case> all = broadCases();
  const std::vector<Case> others = narrowCases();
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

std::vector<Xyz> pointsOf(const Case& one)
{
  std::mt19937_64 random(5);
  const auto number = [&random] { return double(random() >> 11) * 0x1p-53; };
  std::vector<Xyz> points;
  for (std::size_t i = 0; i < one.count; ++i)
  {
    const double s = number(), t = number(), u = number();
    points.push_back(one.make(s, t, u, i));
  }
  return points;
}

TEST(Footprint, TellsWallsFromTerrain)
{
  for (const Case& one : cases())
  {
    SCOPED_TRACE(one.name);
    const std::vector<Xyz> points = pointsOf(one);
    const Stance stance = fit(points).stance();
    EXPECT_EQ(stance.isWall, one.expected == Expected::Wall);
    EXPECT_EQ(stance.isSteep, one.expected == Expected::XyAndToldIfFitted);
  }
}

TEST(Footprint, OrderThreadsAndUnitDoNotDecide)
{
  Maker maker(3);
  for (const Case& one : cases())
  {
    SCOPED_TRACE(one.name);
    std::vector<Xyz> points = pointsOf(one);
    const Stance stance = fit(points).stance();
    expectSame(fit(points, 3), fit(points));
    const Plane before = fit(points);
    maker.shuffle(points);
    expectSame(fit(points), before);
    for (const int exponent : { -900, 900 })
    {
      std::vector<Xyz> scaled = points;
      for (Xyz& p : scaled)
      {
        p = { { std::ldexp(p[0], exponent), std::ldexp(p[1], exponent),
          std::ldexp(p[2], exponent) } };
      }
      EXPECT_EQ(fit(scaled).stance().isWall, stance.isWall);
      EXPECT_EQ(fit(scaled).stance().isSteep, stance.isSteep);
    }
  }
}

TEST(Footprint, PointsWithoutPlaceDoNotCount)
{
  std::vector<Xyz> points = pointsOf(cases()[0]);
  points.resize(500);
  points.push_back({ { NAN, 0, 0 } });
  points.push_back({ { 0, 0, HUGE_VAL } });
  EXPECT_FALSE(fit(points).stance().isWall);
  for (Xyz& p : points)
  {
    p[1] = 3;
    p[2] = 1e4 * std::fmod(p[0], 7.0);
  }
  EXPECT_TRUE(fit(points).stance().isWall);
  for (std::size_t n = 0; n < 3; ++n)
  {
    EXPECT_FALSE(fit(std::vector<Xyz>(n, { { 1, 2, 3 } })).stance().isWall);
  }
  EXPECT_FALSE(fit({ { { 1, 2, 3 } }, { { 1, 2, 4 } }, { { 1, 2, 9 } } }).stance().isWall);
}

/// Their width and thickness are rounding, whose ratio says nothing.
TEST(Footprint, CollinearPointsAreNoWall)
{
  for (const Xyz& step : { Xyz{ { 0.1, 0.03, 0.7 } }, Xyz{ { 1, 2, 5 } }, Xyz{ { 1, 0, 9 } } })
  {
    std::vector<Xyz> points = { { { 0.3, 0.7, 0 } } };
    for (std::size_t n = 2; n < 10; ++n)
    {
      const Xyz last = points.back();
      points.push_back({ { last[0] + step[0], last[1] + step[1], last[2] + step[2] } });
      EXPECT_FALSE(fit(points).stance().isWall) << n;
      EXPECT_FALSE(fit(points).stance().isSteep) << n;
    }
  }
}

/// A huge coordinate that all have is no distance.
TEST(Footprint, ACoordinateOfAllHasNoSay)
{
  for (const double far : { 0.0, -1e300, DBL_MAX })
  {
    for (const double size : { 1e-3, 1e-40, 1e-290 })
    {
      std::vector<Xyz> wall, profile;
      for (std::size_t i = 0; i < 100; ++i)
      {
        const double y = double(i % 10), z = double(i / 10);
        wall.push_back({ { far, size * y, size * z } });
        profile.push_back({ { far, size * double(i), size * (0.02 * double(i * i) + z) } });
      }
      EXPECT_TRUE(fit(wall).stance().isWall) << far << " " << size;
      EXPECT_FALSE(fit(profile).stance().isWall) << far << " " << size;
    }
  }
}

// --- The spread within cells

struct Point3
{
  std::size_t along, across;
  double level;
};

double varianceOf(const std::vector<std::vector<double>>& groups)
{
  double squares = 0.0, free = 0.0;
  for (const std::vector<double>& group : groups)
  {
    double mean = 0.0;
    for (const double level : group)
    {
      mean += level / double(group.size());
    }
    for (const double level : group)
    {
      squares += (level - mean) * (level - mean);
    }
    free += double(group.size()) - 1.0;
  }
  return squares / free;
}

double spreadByDefinition(const std::vector<Point3>& points, int bitsAcross)
{
  for (int step = 0;; ++step)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> cells;
    for (const Point3& p : points)
    {
      cells[{ p.along >> step, p.across >> std::min(step, bitsAcross) }].push_back(p.level);
    }
    std::size_t sharing = 0;
    std::vector<std::vector<double>> groups(1);
    std::vector<std::vector<double>> inCells;
    for (const auto& cell : cells)
    {
      sharing += cell.second.size() > 1 ? cell.second.size() : 0;
      inCells.push_back(cell.second);
      groups[0].insert(groups[0].end(), cell.second.begin(), cell.second.end());
    }
    if (2 * sharing >= points.size())
    {
      return varianceOf(inCells) / varianceOf(groups);
    }
  }
}

TEST(Footprint, SpreadWithinCellsIsThatOfItsDefinition)
{
  std::mt19937_64 random(9);
  for (const int bitsAcross : { 0, 1, 3, 5 })
  {
    for (const std::size_t count : { 2u, 3u, 10u, 100u, 3000u })
    {
      std::vector<Point3> points;
      CellLevels levels, parts[3];
      for (std::size_t i = 0; i < count; ++i)
      {
        const std::size_t along = random() % (std::size_t(1) << (Footprint::kBits - bitsAcross));
        const std::size_t across = random() % (std::size_t(1) << bitsAcross);
        const std::uint64_t level = (random() % 30000) + 30 * along;
        points.push_back({ along, across, double(level) });
        const std::size_t cell = (along << bitsAcross) + across;
        levels.add(cell, level);
        parts[i % 3].add(cell, level);
      }
      EXPECT_NEAR(spreadWithin(levels, bitsAcross), spreadByDefinition(points, bitsAcross), 1e-9);
      parts[0].merge(parts[1]);
      parts[2].merge(parts[0]);
      EXPECT_EQ(spreadWithin(parts[2], bitsAcross), spreadWithin(levels, bitsAcross));
    }
  }
  CellLevels level;
  level.add(1, 5);
  level.add(9, 5);
  EXPECT_EQ(spreadWithin(level, 0), 0.0) << "all at one height";
}

} // namespace
} // namespace test
} // namespace ahd
