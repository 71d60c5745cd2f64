// SPDX-License-Identifier: BSD-3-Clause
//
// Merging points and splitting constraints where there is no memory: it is reported, nothing is
// thrown, nothing leaks. This program's operator new fails on demand.
#include "Crossings/Crossings.h"
#include "Merge/Merge.h"

#include "Distributions.h"
#include "EngineRun.h"
#include "MemoryListener.h"
#include "OwnMemory.h"
#include "SeparateLines.h"
#include "Shores.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ahd
{
namespace test
{
namespace
{

/// Fails the k-th allocation of `work` and all that follow, for every k, until it succeeds.
template <typename Work>
void expectOutOfMemoryIsSaid(Work work)
{
  for (std::size_t k = 1; k < 100000; ++k)
  {
    const std::size_t before = account.held;
    account.failAt = account.allocations + k;
    const Status status = work();
    account.failAt = 0;
    EXPECT_EQ(account.held, before) << "at allocation " << k;
    if (status == Status::Ok)
    {
      EXPECT_GT(k, 3u) << "it no longer allocates through operator new";
      return;
    }
    ASSERT_EQ(status, Status::OutOfMemory) << "at allocation " << k;
  }
  FAIL() << "it never got through";
}

TEST(SplitMemory, MergingSaysSo)
{
  const std::vector<Point> points = makePoints(Distribution::Utm, 5000, 1);
  expectOutOfMemoryIsSaid(
    [&]
    {
      MergedPoints merged;
      const Status status = mergeWithin(viewOf(points), 500.0, nullptr, merged);
      EXPECT_TRUE(status != Status::Ok || !merged.pairs.empty());
      return status;
    });
}

TEST(SplitMemory, SplittingSaysSo)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 20, 1);
  std::vector<std::int64_t> ids, offsets{ 0, 10, 20 };
  for (std::int64_t id = 0; id < 20; ++id)
  {
    ids.push_back(id);
  }
  ConstraintView chains;
  chains.ids = ids.data();
  chains.offsets = offsets.data();
  chains.chains = 2;
  chains.lines = 1;
  expectOutOfMemoryIsSaid(
    [&]
    {
      SplitConstraints split;
      const Status status = splitAtCrossings(viewOf(points), chains, nullptr, split);
      EXPECT_TRUE(status != Status::Ok || split.points.size() > 10);
      return status;
    });
}

struct Segments : SeparateLines
{
  Status split(std::size_t most, SplitConstraints& out, Progress* progress = nullptr) const
  {
    return splitAtCrossings(viewOf(points), view(), progress, out, most);
  }
};

/// `count` of a length about this, anywhere in the unit square.
Segments scattered(std::size_t count, double length)
{
  Segments result;
  for (const Point& p : makePoints(Distribution::Uniform, count, 7))
  {
    const double turn = 1000.0 * p.x * p.y;
    result.add(p, { p.x + length * std::cos(turn), p.y + length * std::sin(turn) });
  }
  return result;
}

/// As many as follow one another closely, from side to side; and some across all of them.
Segments sideBySide(std::size_t count, std::size_t across)
{
  Segments result;
  for (std::size_t k = 0; k != count; ++k)
  {
    const double y = double(k) / double(count);
    result.add({ 0.01 * y, y }, { 1.0 - 0.003 * y, y + 1e-7 * double(k % 3) });
  }
  for (std::size_t k = 0; k != across; ++k)
  {
    const double x = (double(k) + 0.5) / double(across);
    result.add({ x, -0.5 }, { x * x, 1.5 });
  }
  return result;
}

/// Diagonals beside each other, whose boxes all meet.
Segments bundle(std::size_t count)
{
  Segments result;
  for (std::size_t k = 0; k != count; ++k)
  {
    const double t = double(k) / double(count);
    result.add({ t, -t }, { t + 100.0, 100.0 - t });
  }
  return result;
}

/// Segments that pass exactly through the origin, or through (1/3, 1/3).
Segments diameters(std::size_t count, bool throughADouble)
{
  Segments result;
  for (std::size_t k = 1; k <= count; ++k)
  {
    const double x = double(k), y = double(count + 1 - k);
    result.add({ x, y }, throughADouble ? Point{ -x, -y } : Point{ 1 - 2 * x, 1 - 2 * y });
  }
  return result;
}

Segments shores(std::size_t islands, std::size_t rivers)
{
  Segments result;
  for (const std::vector<Point>& line : shoreLines(islands, rivers))
  {
    result.addLine(line);
  }
  return result;
}

/// The bytes that a run takes, and those it requests beyond the estimate.
struct Taken
{
  std::size_t peak, asked, crossings;
};

Taken takenBy(const Segments& segments, std::size_t most, Status expected)
{
  SplitConstraints out;
  MemoryListener listener;
  const std::size_t before = account.held;
  account.peak = before;
  EXPECT_EQ(segments.split(most, out, &listener), expected);
  return { account.peak - before, listener.memory.most(), out.crossings };
}

/// Where the number of crossings is not known before.
void expectAsked(const Segments& segments, double atMost, const char* name)
{
  const Taken taken = takenBy(segments, std::size_t(-1), Status::Ok);
  const std::size_t known = splitMemoryEstimate(segments.segments(), 0) + taken.asked;
  EXPECT_LE(taken.peak, known) << name << ": " << taken.crossings << " crossings";
  EXPECT_LE(double(known), atMost * double(taken.peak)) << name << ": " << taken.asked << " asked";
}

TEST(SplitMemory, OfWhatIsLikeShoresHalfAsMuchMoreIsEstimated)
{
  expectAsked(shores(100, 0), 1.5, "shores");
  expectAsked(shores(100, 8), 1.5, "shores and rivers");
  expectAsked(scattered(30000, 1e-6), 1.5, "short");
}

TEST(SplitMemory, OfTheWorstTwiceAsMuchIs)
{
  expectAsked(scattered(3000, 0.02), 2.0, "scattered");
  expectAsked(scattered(1000, 0.5), 2.0, "long");
  expectAsked(bundle(20000), 2.0, "bundle");
  expectAsked(sideBySide(500, 60), 2.0, "across");
  expectAsked(diameters(500, false), 2.0, "through no double");
  expectAsked(diameters(2000, true), 2.0, "through a double");
}

TEST(SplitMemory, LinesOfNoPointAreAskedFor)
{
  Segments segments = scattered(3000, 1e-6);
  for (std::size_t k = 0; k != 2000; ++k)
  {
    segments.addLine({});
  }
  expectAsked(segments, 1.5, "lines of no point");
}

TEST(SplitMemory, WhatIsAskedForMayBeRefused)
{
  for (const Segments& segments : { bundle(5000), sideBySide(500, 60), diameters(200, false) })
  {
    const Taken whole = takenBy(segments, std::size_t(-1), Status::Ok);
    ASSERT_GT(whole.asked, 0u);
    for (const std::size_t most : { std::size_t(0), whole.asked / 2, whole.asked - 1, whole.asked })
    {
      SplitConstraints out;
      MemoryListener listener(most);
      const std::size_t before = account.held;
      account.peak = before;
      const Status status = segments.split(std::size_t(-1), out, &listener);
      EXPECT_EQ(status, most == whole.asked ? Status::Ok : Status::OutOfMemory) << most;
      EXPECT_EQ(listener.memory.wasRefused(), status != Status::Ok);
      constexpr std::size_t kFew = 64 << 10; // listed before the request, and hubs
      EXPECT_LE(account.peak - before, splitMemoryEstimate(segments.segments(), 0) + most + kFew)
        << most;
    }
  }
}

std::size_t peakOf(const Segments& segments, std::size_t most, Status expected, std::size_t& found)
{
  const Taken taken = takenBy(segments, most, expected);
  found = taken.crossings;
  return taken.peak;
}

TEST(SplitMemory, TheEstimateHolds)
{
  const Segments all[] = { scattered(3000, 1e-6), scattered(3000, 0.02), scattered(1000, 0.5),
    sideBySide(2000, 0), sideBySide(500, 60), diameters(200, false) };
  for (const Segments& segments : all)
  {
    std::size_t found = 0;
    const std::size_t peak = peakOf(segments, std::size_t(-1), Status::Ok, found);
    EXPECT_LE(peak, splitMemoryEstimate(segments.segments(), found))
      << segments.count() << " segments, " << found << " crossings";
  }
}

TEST(SplitMemory, MoreCrossingsThanAllowedAreRefusedBeforeTheyTakeIt)
{
  const Segments all[] = { scattered(1000, 0.5), sideBySide(500, 60) };
  for (const Segments& segments : all)
  {
    std::size_t found = 0;
    peakOf(segments, std::size_t(-1), Status::Ok, found);
    for (const std::size_t most : { std::size_t(0), std::size_t(1000), found / 2 })
    {
      constexpr std::size_t kBetweenLooks = 100; // it searches again after so many at most
      std::size_t none = 0;
      const std::size_t peak = peakOf(segments, most, Status::TooManyCrossings, none);
      EXPECT_LE(peak, splitMemoryEstimate(segments.segments(), most + kBetweenLooks)) << most;
    }
    peakOf(segments, found, Status::Ok, found);
  }
}

TEST(SplitMemory, WhatCrossesInOneDoubleIsAllowedAsOftenAsThereArePieces)
{
  const std::size_t count = 1000, most = count;
  std::size_t found = 0;
  const std::size_t peak = peakOf(diameters(count, true), most, Status::Ok, found);
  EXPECT_EQ(found, count * (count - 1) / 2);
  EXPECT_LE(peak, splitMemoryEstimate(count, most));
  // elsewhere, four pairs for each place that is allowed
  const std::size_t less = peakOf(diameters(count, false), most, Status::TooManyCrossings, found);
  EXPECT_LE(less, splitMemoryEstimate(count, most));
  peakOf(diameters(count, false), count * count / 8, Status::Ok, found);
}

} // namespace
} // namespace test
} // namespace ahd
