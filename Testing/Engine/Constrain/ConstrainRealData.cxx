// SPDX-License-Identifier: BSD-3-Clause
//
// Real data with constraints, if the folder named by the environment variable AHD_DATA has them:
// faults.vtk, sweden.txt, coastline.csv. None of it is part of the project.
#include "ConstrainedRun.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <string>
#include <utility>

namespace ahd
{
namespace test
{
namespace
{

/// The file of this name; in a failed state if there is none.
std::ifstream dataFile(const std::string& name)
{
  const char* folder = std::getenv("AHD_DATA");
  return std::ifstream(folder ? std::string(folder) + "/" + name : "", std::ios::binary);
}

#define SKIP_WITHOUT(file, name)                                                                   \
  if (!(file))                                                                                     \
  {                                                                                                \
    GTEST_SKIP() << (name) << " is not in the folder AHD_DATA";                                    \
  }

/// Numbers of a legacy VTK file, 4 bytes each, the most significant first.
std::uint32_t nextWord(std::istream& file)
{
  std::array<unsigned char, 4> bytes{};
  file.read(reinterpret_cast<char*>(bytes.data()), 4);
  return std::uint32_t(bytes[0]) << 24 | std::uint32_t(bytes[1]) << 16 |
    std::uint32_t(bytes[2]) << 8 | std::uint32_t(bytes[3]);
}

float nextFloat(std::istream& file)
{
  const std::uint32_t word = nextWord(file);
  float result = 0.0f;
  std::memcpy(&result, &word, sizeof result);
  return result;
}

/// Reads on to a line that begins with this word; returns the words after it.
std::string afterKeyword(std::istream& file, const std::string& keyword)
{
  std::string line;
  while (std::getline(file, line))
  {
    if (line.rfind(keyword + " ", 0) == 0)
    {
      return line.substr(keyword.size() + 1);
    }
  }
  return "0 0";
}

TEST(ConstrainRealData, FaultLines)
{
  std::ifstream file = dataFile("faults.vtk");
  SKIP_WITHOUT(file, "faults.vtk")
  ConstraintCase given;
  const std::size_t points = std::stoul(afterKeyword(file, "POINTS"));
  for (std::size_t i = 0; i < points; ++i)
  {
    const double x = nextFloat(file);
    const double y = nextFloat(file);
    nextFloat(file);
    given.points.push_back({ x, y });
  }
  const std::size_t lines = std::stoul(afterKeyword(file, "LINES"));
  for (std::size_t k = 0; k < lines; ++k)
  {
    Chain chain(nextWord(file));
    for (std::int64_t& id : chain)
    {
      id = std::int64_t(nextWord(file));
    }
    given.constraints.addLine(chain);
  }
  ASSERT_TRUE(file) << "the file ends too early";
  ASSERT_EQ(points, 1933u);
  EXPECT_EQ(faultsOfConstraining(given, FillRule::Orientation), "");
  EXPECT_GT(constrain(given, FillRule::Orientation).constraints.edges, 100u);
}

TEST(ConstrainRealData, OutlineOfSweden)
{
  std::ifstream file = dataFile("sweden.txt");
  SKIP_WITHOUT(file, "sweden.txt")
  std::size_t points = 0, edges = 0;
  file >> points >> edges;
  ConstraintCase given;
  given.points.resize(points);
  for (Point& p : given.points)
  {
    file >> p.x >> p.y;
  }
  for (std::size_t k = 0; k < edges; ++k)
  {
    std::int64_t from = -1, to = -1;
    file >> from >> to;
    given.constraints.addLine({ from, to });
  }
  ASSERT_TRUE(file) << "the file ends too early";
  EXPECT_EQ(faultsOfConstraining(given, FillRule::Orientation), "");
  const ConstraintReport report = constrain(given, FillRule::Orientation).constraints;
  EXPECT_EQ(report.segments, 2619u);
  EXPECT_EQ(report.edges + report.crossing, 2619u);
}

TEST(ConstrainRealData, ShoreOfAustralia)
{
  std::ifstream file = dataFile("coastline.csv");
  SKIP_WITHOUT(file, "coastline.csv")
  ConstraintCase given;
  Chain shore;
  std::string line;
  std::getline(file, line); // the names of the columns
  while (std::getline(file, line))
  {
    const std::size_t comma = line.find(',');
    ASSERT_NE(comma, std::string::npos) << line;
    shore.push_back(std::int64_t(given.points.size()));
    given.points.push_back({ std::stod(line), std::stod(line.substr(comma + 1)) });
  }
  given.constraints.addLoop(shore);
  for (const FillRule rule : kFillRules)
  {
    EXPECT_EQ(faultsOfConstraining(given, rule), "") << nameOf(rule);
  }
  const ConstrainedOutcome land = constrain(given, FillRule::EvenOdd);
  EXPECT_EQ(land.constraints.unfilledLoops, 0u);
  // A simple polygon of n corners has n - 2 triangles.
  EXPECT_EQ(land.report.triangles, land.report.inserted - 2);
}

} // namespace
} // namespace test
} // namespace ahd
