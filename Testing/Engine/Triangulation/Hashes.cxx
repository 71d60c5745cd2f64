// SPDX-License-Identifier: BSD-3-Clause
//
// Every result of the engine as a hash in Data/Hashes/Engine.txt: so a change of any result is seen
// in review, and compilers, builds, threads and settings must give the same bytes.
#include "EngineRun.h"
#include "HashedResults.h"

#include <gtest/gtest.h>

#include <set>

namespace ahd
{
namespace test
{
namespace
{

const std::string kFile = AHD_HASHES_DIRECTORY "/Engine.txt";

/// Points of every kind: the corpus, and so many of each distribution.
std::vector<NamedPoints> allKinds(std::size_t most)
{
  std::vector<NamedPoints> result = pointsOfCorpus(AHD_CORPUS_DIRECTORY);
  for (NamedPoints& more : pointsOfDistributions(most))
  {
    result.push_back(std::move(more));
  }
  return result;
}

TEST(Hashes, AreThoseOfTheRepository)
{
  const Way way;
  Hashes all = hashesOfTriangles(AHD_CORPUS_DIRECTORY, way);
  for (const Hashes& more : { hashesOfConstrained(way), hashesOfTheRest(way), hashesOfMany(way),
         hashesOfSamples(way), hashesOfManySamples(way) })
  {
    all.insert(all.end(), more.begin(), more.end());
  }
  std::set<std::string> names;
  for (const NamedHash& hash : all)
  {
    EXPECT_TRUE(names.insert(hash.name).second) << hash.name << " is there twice";
  }
  const std::string changed = differencesFromFile(kFile, all);
  EXPECT_TRUE(changed.empty()) << changed;
}

TEST(Hashes, NoNumberOfThreadsChangesOne)
{
  const Hashes expected = hashesOfMany(Way()), samples = hashesOfManySamples(Way());
  Engine engine;
#ifdef AHD_REDUCED_TESTS
  const std::vector<unsigned> counts = { 3 };
#else
  const std::vector<unsigned> counts = { 2, 3, 8 }; // Way() has one
#endif
  for (const unsigned threads : counts)
  {
    ThreadExecutor executor(threads);
    Way way;
    way.executor = &executor;
    way.engine = &engine;
    EXPECT_EQ(differences(expected, hashesOfMany(way)), "") << threads << " threads";
    EXPECT_EQ(differences(samples, hashesOfManySamples(way)), "") << threads << " threads";
  }
}

TEST(Hashes, NoSettingChangesOne)
{
  Engine engine;
  for (const NamedPoints& given : allKinds(100))
  {
    const PointView points = viewOf(given.points);
    const std::string expected = hashOfTriangles(points, Way());
    for (const Options& options : everyDistinctSetting({ 1, 50 }))
    {
      Way way;
      way.options = options;
      way.engine = &engine;
      ASSERT_EQ(hashOfTriangles(points, way), expected) << given.name << ", " << describe(options);
    }
  }
}

TEST(Hashes, NoSettingChangesOneOfConstraints)
{
  Engine engine;
  for (std::uint64_t seed = 0; seed < 100; ++seed)
  {
    const ConstraintCase given = smallConstraintCase(seed);
    const std::string expected = hashOfConstrained(given, FillRule::EvenOdd, Way());
    for (const Options& options : everyDistinctSetting({ 1, 50 }))
    {
      Way way;
      way.options = options;
      way.engine = &engine;
      ASSERT_EQ(hashOfConstrained(given, FillRule::EvenOdd, way), expected)
        << describe(options) << given.text();
    }
  }
}

TEST(Hashes, NoShuffleChangesOneOfPlaces)
{
  for (const NamedPoints& given : allKinds(1000))
  {
    std::vector<Point> points = given.points;
    const std::string expected = hashOfPlaces(viewOf(points), Way());
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      Random random(seed);
      for (std::size_t i = points.size(); i > 1; --i)
      {
        std::swap(points[i - 1], points[random.below(i)]);
      }
      EXPECT_EQ(hashOfPlaces(viewOf(points), Way()), expected) << given.name;
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
