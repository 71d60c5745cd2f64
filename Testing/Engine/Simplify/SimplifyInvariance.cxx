// SPDX-License-Identifier: BSD-3-Clause
//
// What simplify() keeps is a function of the points and the settings: not of their order, of
// threads, or of the unit.
#include "SimplifyCase.h"

#include "Executors.h"
#include "Hash.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ahd
{
namespace test
{
namespace
{

std::vector<SimplifyCase> cases()
{
  std::vector<SimplifyCase> result = { hills(reduced(20000), 1), hills(reduced(20000), 2, 0.4) };
  result[0].settings.maximumError = 0.02;
  result[1].settings.maximumError = 0.1;
  result[1].settings.secondPass = true;
  SimplifyCase lattice;
  Random random(5);
  for (int k = 0; k < 10000; ++k)
  {
    lattice.add({ double(k % 100), double(k / 100) }, double(random.below(4)));
  }
  lattice.constraints.addLine({ 303, 4950, 8070 });
  lattice.settings.maximumError = 1.0;
  lattice.settings.secondPass = true;
  result.push_back(lattice);
  result.push_back(lattice);
  result.back().settings.maximumError = 0.0;
  result.back().settings.maximumNumberOfVertices = 3000;
  return result;
}

/// The places kept, and the error.
std::pair<std::vector<std::pair<double, double>>, double> outcome(
  const SimplifyCase& given, const Context& context = Context())
{
  const SimplifyResult result = given.simplified(context);
  std::vector<std::pair<double, double>> places;
  for (const std::size_t id : keptIds(result))
  {
    places.push_back({ given.at(id).x, given.at(id).y });
  }
  std::sort(places.begin(), places.end());
  return { places, result.largestError };
}

TEST(SimplifyInvariance, UnderShuffles)
{
  for (const SimplifyCase& given : cases())
  {
    const auto expected = outcome(given);
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      std::vector<std::int64_t> newId(given.count());
      std::iota(newId.begin(), newId.end(), 0);
      Random random(seed);
      for (std::size_t i = newId.size(); i > 1; --i)
      {
        std::swap(newId[i - 1], newId[random.below(i)]);
      }
      SimplifyCase shuffled = given;
      for (std::size_t i = 0; i < given.count(); ++i)
      {
        std::copy_n(given.numbers.begin() + std::ptrdiff_t(3 * i), 3,
          shuffled.numbers.begin() + std::ptrdiff_t(3 * newId[i]));
      }
      shuffled.constraints = given.constraints.renamed(newId);
      EXPECT_TRUE(outcome(shuffled) == expected) << "seed " << seed;
    }
  }
}

TEST(SimplifyInvariance, UnderThreads)
{
  for (const SimplifyCase& given : cases())
  {
    const auto expected = outcome(given);
    for (const unsigned threads : { 2u, 3u, 7u })
    {
      ThreadExecutor executor(threads);
      EXPECT_TRUE(outcome(given, Context{ nullptr, &executor }) == expected) << threads;
    }
  }
}

TEST(SimplifyInvariance, UnderPowersOfTwo)
{
  for (const SimplifyCase& given : cases())
  {
    auto expected = outcome(given);
    for (const double unit : { 0x1p-300, 0x1p-20, 0x1p+40, 0x1p+400 })
    {
      SimplifyCase scaled = given;
      for (std::size_t k = 0; k < scaled.numbers.size(); ++k)
      {
        scaled.numbers[k] *= k % 3 == 2 ? 1.0 / unit : unit;
      }
      scaled.settings.maximumError /= unit;
      auto found = outcome(scaled);
      for (auto& place : found.first)
      {
        place = { place.first / unit, place.second / unit };
      }
      found.second *= unit;
      EXPECT_TRUE(found == expected) << unit;
    }
  }
}

/// The same with every compiler and on every platform.
TEST(SimplifyInvariance, HashesAreTheSameEverywhere)
{
#ifdef AHD_REDUCED_TESTS
  GTEST_SKIP() << "with fewer points they differ";
#else
  std::vector<std::string> hashes;
  for (const SimplifyCase& given : cases())
  {
    const auto found = outcome(given);
    Hash hash;
    for (const auto& place : found.first)
    {
      hash.add(Point{ place.first, place.second });
    }
    hash.add(found.second);
    hashes.push_back(hash.text());
  }
  const std::vector<std::string> expected = { "65c72321a4f28423", "1b3dc56fe80515fc",
    "fb70f1a2ffb6b445", "12867643067aa789" };
  EXPECT_EQ(hashes, expected);
#endif
}

} // namespace
} // namespace test
} // namespace ahd
