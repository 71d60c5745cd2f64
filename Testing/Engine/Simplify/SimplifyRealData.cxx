// SPDX-License-Identifier: BSD-3-Clause
//
// Real data, if the folder named by the environment variable AHD_DATA has them: lidar.csv,
// soundings.csv. None of it is part of the project. How many points are kept is compared with exact
// greedy insertion, one by one (a prototype's figures).
#include "SimplifyCase.h"

#include <cstdlib>
#include <fstream>
#include <string>

namespace ahd
{
namespace test
{
namespace
{

/// One count of exact greedy insertion.
struct Greedy
{
  const char* file;
  double bound;
  std::size_t kept;
};

constexpr Greedy kGreedy[] = { { "lidar.csv", 5.0, 24548 }, { "lidar.csv", 0.25, 45250 },
  { "soundings.csv", 200.0, 7271 }, { "soundings.csv", 50.0, 25162 },
  { "soundings.csv", 10.0, 52376 } };

SimplifyCase read(const std::string& name)
{
  SimplifyCase given;
  const char* folder = std::getenv("AHD_DATA");
  std::ifstream file(folder ? std::string(folder) + "/" + name : "");
  std::string line;
  std::getline(file, line); // names
  double x, y, z;
  char comma;
  while (file >> x >> comma >> y >> comma >> z)
  {
    given.add({ x, y }, z);
  }
  return given;
}

TEST(SimplifyRealData, KeepsAboutAsManyPointsAsOneByOne)
{
  for (const Greedy& greedy : kGreedy)
  {
    SimplifyCase given = read(greedy.file);
    if (given.count() == 0)
    {
      GTEST_SKIP() << greedy.file << " is not in the folder AHD_DATA";
    }
    given.settings.maximumError = greedy.bound;
    const SimplifyResult once = given.simplified();
    EXPECT_LE(once.largestError, greedy.bound);
    EXPECT_LE(double(once.kept), 1.03 * double(greedy.kept)) << greedy.file;
    EXPECT_GE(double(once.kept), 0.9 * double(greedy.kept)) << greedy.file;
    given.settings.secondPass = true;
    const SimplifyResult twice = given.simplified();
    EXPECT_LE(twice.largestError, greedy.bound);
    EXPECT_LE(double(twice.kept), 0.965 * double(greedy.kept)) << greedy.file;
  }
}

} // namespace
} // namespace test
} // namespace ahd
