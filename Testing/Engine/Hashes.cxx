// SPDX-License-Identifier: BSD-3-Clause
//
// Every result of the engine as a hash that stands in Data/Hashes/Engine.txt: so a change of any
// result is seen in review, and compilers, builds, threads and settings are held to the same bytes.
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

Hashes allHashes(const Way& way)
{
  Hashes all = hashesOfTriangles(AHD_CORPUS_DIRECTORY, way);
  for (const Hashes& more : { hashesOfConstrained(way), hashesOfTheRest(way) })
  {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

TEST(Hashes, AreThoseOfTheRepository)
{
  const Hashes all = allHashes(Way());
  std::set<std::string> names;
  for (const NamedHash& hash : all)
  {
    EXPECT_TRUE(names.insert(hash.name).second) << hash.name << " is there twice";
  }
  const std::string changed = differencesFromFile(kFile, all);
  EXPECT_TRUE(changed.empty()) << changed;
}

} // namespace
} // namespace test
} // namespace ahd
