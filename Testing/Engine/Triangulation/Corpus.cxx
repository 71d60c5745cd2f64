// SPDX-License-Identifier: BSD-3-Clause
//
// Data/Corpus: small inputs that are hard for a reason, given in their first line. Every bug that
// is found leaves a file there.
#include "Corpus.h"
#include "EngineRun.h"

#include <gtest/gtest.h>

namespace ahd
{
namespace test
{
namespace
{

TEST(Corpus, EveryFileIsCertifiedUnderEverySetting)
{
  const std::vector<CorpusFile> files = readCorpus(AHD_CORPUS_DIRECTORY);
  ASSERT_GE(files.size(), 10u);
  Engine engine;
  for (const CorpusFile& file : files)
  {
    SCOPED_TRACE(file.name + ": " + file.reason);
    EXPECT_EQ(file.fault, "");
    EXPECT_GE(file.reason.size(), 20u) << "the first line has to say why the file is there";
    const Outcome expected = triangulate(file.points);
    ASSERT_EQ(faultsOf(file.points, expected), "");
    for (const Options& options : everySetting())
    {
      const Outcome outcome = triangulate(engine, viewOf(file.points), options);
      ASSERT_EQ(expected.triples, outcome.triples) << describe(options);
      ASSERT_EQ(expected.pointStatus, outcome.pointStatus) << describe(options);
    }
  }
}

TEST(Corpus, SmallFilesAreWhatTheDefinitionSays)
{
  std::size_t compared = 0;
  for (const CorpusFile& file : readCorpus(AHD_CORPUS_DIRECTORY))
  {
    if (file.points.size() <= 16)
    {
      ++compared;
      EXPECT_EQ(asSet(triangulate(file.points).triples), delaunayByDefinition(file.points))
        << file.name;
    }
  }
  EXPECT_GE(compared, 5u);
}

TEST(Corpus, EveryFileReversedAndMirroredIsCertified)
{
  for (const CorpusFile& file : readCorpus(AHD_CORPUS_DIRECTORY))
  {
    std::vector<Point> reversed(file.points.rbegin(), file.points.rend());
    EXPECT_EQ(faultsOf(reversed, triangulate(reversed)), "") << file.name;
    for (Point& p : reversed)
    {
      p = { p.y, -p.x };
    }
    EXPECT_EQ(faultsOf(reversed, triangulate(reversed)), "") << file.name;
  }
}

} // namespace
} // namespace test
} // namespace ahd
