// SPDX-License-Identifier: BSD-3-Clause
//
// The insertion is compiled for several kinds of processors: all give the same triangles.
#include "Distributions.h"
#include "EngineRun.h"
#include "Executors.h"

#include "Core/Dispatch.h"
#include "Extract/Extractor.h"
#include "Insert/Frame.h"
#include "Insert/InsertTargets.h"
#include "Order/Rank.h"
#include "Order/Sequence.h"

#include <gtest/gtest.h>

#include <memory>

namespace ahd
{

namespace test
{
namespace
{

/// The frame of an insertion for as long as one call lasts; the points are not used after it.
struct Framed
{
  Framed(RankedPoints& points, Ticker& ticker)
    : framing(points)
  {
    EXPECT_TRUE(framing.begin(ticker));
  }
  operator const Frame&()
  {
    frame = std::make_unique<Frame>(framing.frame());
    return *frame;
  }

  Framing framing;
  std::unique_ptr<Frame> frame;
};

/// The triangles that `insert(ranked, mesh, ticker)` makes of these points.
template <typename Insert>
std::vector<std::int32_t> trianglesBy(
  const std::vector<Point>& points, Executor* executor, Insert insert)
{
  RankedPoints ranked;
  Ticker ticker(nullptr, Phase::Insert, points.size(), executor);
  EXPECT_EQ(readPoints(viewOf(points), ticker, ranked), Status::Ok);
  EXPECT_EQ(rankPoints(viewOf(points), ticker, ranked), Status::Ok);
  if (ranked.count < 3)
  {
    return {};
  }
  Scratch slots;
  slots.allocate(Mesh::bytesFor(ranked.count));
  Mesh mesh;
  mesh.begin(ranked.count, slots.data());
  if (insert(ranked, mesh, ticker) != InsertionEnd::Done)
  {
    return {};
  }
  const std::size_t count = 2 * std::size_t(ranked.count) - 2 - countHullVertices(mesh, ticker);
  std::vector<std::int32_t> triples(3 * count);
  Scratch scratch;
  scratch.allocate(kExtractScratchPerPoint * (ranked.count + 1));
  EXPECT_TRUE(writeCanonical(mesh, ranked.id.data(), triples.data(), scratch, ticker));
  return triples;
}

#if AHD_HAS_X86_TARGETS
TEST(DispatchTargets, Avx2IsTheBaseline)
{
  if (!processorHas(InstructionSet::Avx2))
  {
    GTEST_SKIP() << "this processor has no fused multiply-add";
  }
  SharedWork shared;
  const auto baseline = [&](RankedPoints& points, Mesh& mesh, Ticker& ticker)
  { return baseline::insertByRoundsHere(Framed(points, ticker), mesh, ticker, nullptr, shared); };
  const auto fused = [&](RankedPoints& points, Mesh& mesh, Ticker& ticker)
  { return avx2::insertByRoundsHere(Framed(points, ticker), mesh, ticker, nullptr, shared); };
  BackwardExecutor threads(3);
  for (const Distribution d : allDistributions())
  {
    const std::vector<Point> points = makePoints(d, affordable(d, 40000), 7);
    const std::vector<std::int32_t> expected = trianglesBy(points, nullptr, baseline);
    EXPECT_EQ(trianglesBy(points, nullptr, fused), expected) << nameOf(d);
    EXPECT_EQ(trianglesBy(points, &threads, fused), expected) << nameOf(d) << ", in parts";
    EXPECT_EQ(trianglesBy(points, &threads, baseline), expected) << nameOf(d) << ", in parts";
  }
}

TEST(DispatchTargets, Avx2IsTheBaselineForSequences)
{
  if (!processorHas(InstructionSet::Avx2))
  {
    GTEST_SKIP() << "this processor has no fused multiply-add";
  }
  const auto asGiven = [](auto insertSequence)
  {
    return [insertSequence](RankedPoints& points, Mesh& mesh, Ticker& ticker)
    {
      Buffer<Index> sequence;
      Options options;
      options.order = InsertionOrder::RegularGrid;
      EXPECT_EQ(makeSequence(points, options, ticker, sequence), Status::Ok);
      return insertSequence(Framed(points, ticker), sequence, mesh, ticker, nullptr);
    };
  };
  for (const Distribution d : allDistributions())
  {
    const std::vector<Point> points = makePoints(d, affordable(d, 3000), 8);
    EXPECT_EQ(trianglesBy(points, nullptr, asGiven(avx2::insertSequenceHere)),
      trianglesBy(points, nullptr, asGiven(baseline::insertSequenceHere)))
      << nameOf(d);
  }
}
#endif

TEST(DispatchTargets, ThePublicOneIsOneOfThem)
{
  SharedWork shared;
  const std::vector<Point> points = makePoints(Distribution::Uniform, 5000, 9);
  EXPECT_EQ(trianglesBy(points, nullptr,
              [&](RankedPoints& ranked, Mesh& mesh, Ticker& ticker)
              { return insertByRounds(ranked, mesh, ticker, nullptr, shared); }),
    trianglesBy(points, nullptr,
      [&](RankedPoints& ranked, Mesh& mesh, Ticker& ticker) {
        return baseline::insertByRoundsHere(Framed(ranked, ticker), mesh, ticker, nullptr, shared);
      }));
}

} // namespace
} // namespace test
} // namespace ahd
