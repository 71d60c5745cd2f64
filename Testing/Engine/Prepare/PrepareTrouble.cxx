// SPDX-License-Identifier: BSD-3-Clause
//
// prepare() where it is cancelled, has no memory, too many points, or several threads. This
// program's operator new counts, and fails on demand.
#include "PrepareCase.h"

#include "Executors.h"
#include "Listeners.h"
#include "OwnMemory.h"

#include <gtest/gtest.h>

#include <functional>

namespace ahd
{
namespace test
{
namespace
{

/// Everything at once: merging, bounding points, crossings, the plane, heights.
void setAll(InputRequest& request, std::size_t variant)
{
  request.tolerance = variant % 2 == 0 ? 0.02 : 0.0;
  request.bounding = variant % 3 != 0;
  request.fitPlane = variant % 4 == 3;
  request.split = variant % 5 != 0;
  request.idsAreOfInput = variant % 7 == 5;
  request.closedLinesAreLoops = variant % 2 == 1;
  request.heights = variant == 6 ? SourceHeights::Mixed
    : variant % 4 == 2           ? SourceHeights::FromSurface
                                 : SourceHeights::Own;
  request.linesOnSurface = variant != 2;
  request.maximumSegmentLength = variant % 3 == 0 ? 0.1 : 0.0;
  request.meanHeights = variant == 6;
}

struct ManyRequests
{
  explicit ManyRequests(std::size_t points)
    : given(oddPoints(points, 1), oddPoints(points / 2, 2), linesBetween(12, points / 2, 3),
        linesBetween(4, points / 2, 4))
  {
  }
  /// Calls check() for different requests.
  void forAll(const std::function<void(const InputRequest&)>& check) const
  {
    for (std::size_t variant = 0; variant < 9; ++variant)
    {
      SCOPED_TRACE(variant);
      InputRequest request = given.request;
      setAll(request, variant);
      if (request.idsAreOfInput)
      {
        request.sourcePoints = PointView();
      }
      check(request);
    }
  }
  PrepareCase given;
};

/// Invalid offsets, in 32 and in 64 bits, on one thread and on several: the first bad cell.
TEST(PrepareTrouble, FirstCellWhoseOffsetsLieIsFound)
{
  constexpr std::size_t kCells = 300000;
  CellStore store(Cells(kCells, { 1, 2 }));
  ThreadExecutor executor(3);
  const auto find = [&](bool wide, Executor* threads, BadCell& bad) {
    return findBadCell(store.view(wide), Context{ nullptr, threads }, bad);
  };
  const auto expectAt = [&](std::size_t cell)
  {
    for (const bool wide : { false, true })
    {
      for (Executor* threads :
        { static_cast<Executor*>(nullptr), static_cast<Executor*>(&executor) })
      {
        BadCell bad;
        ASSERT_EQ(find(wide, threads, bad), cell < kCells ? Status::BadCells : Status::Ok);
        if (cell < kCells)
        {
          EXPECT_EQ(bad.cell, cell);
          EXPECT_EQ(bad.begin, store.offsets64[cell]);
          EXPECT_EQ(bad.end, store.offsets64[cell + 1]);
          EXPECT_EQ(bad.ids, 2 * kCells);
        }
      }
    }
  };
  const auto put = [&](std::size_t place, std::int64_t offset)
  {
    store.offsets64[place] = offset;
    store.offsets32[place] = std::int32_t(offset);
  };
  expectAt(kCells);
  for (const std::size_t place : { std::size_t(0), std::size_t(1), kCells / 2, kCells })
  {
    const std::int64_t was = store.offsets64[place];
    const std::size_t before = place == 0 ? 0 : place - 1;
    put(place, -1);
    expectAt(before);
    put(place, 2 * kCells + 1);
    expectAt(before);
    if (place > 0)
    {
      put(place, was - 3);
      expectAt(before);
    }
    put(place, was);
  }
  put(kCells / 3, 0);
  put(kCells - 5, -7);
  expectAt(kCells / 3 - 1);
  CellStore wide(Cells(2, { 1, 2 }));
  wide.offsets64[1] = std::numeric_limits<std::int64_t>::max();
  BadCell bad;
  EXPECT_EQ(findBadCell(wide.view(), Context(), bad), Status::BadCells);
  EXPECT_EQ(findBadCell(CellsView(), Context(), bad), Status::Ok);
  Listener listener(1);
  EXPECT_EQ(findBadCell(store.view(), Context{ &listener, nullptr }, bad), Status::Cancelled);
}

TEST(PrepareTrouble, AnyAskingCanCancel)
{
  ManyRequests(3000).forAll(
    [](const InputRequest& request)
    {
      Listener all;
      PreparedInput out;
      ASSERT_EQ(prepare(request, Context{ &all, nullptr }, out), Status::Ok);
      for (std::size_t k = 1; k <= all.askings(); ++k)
      {
        Listener listener(k);
        PreparedInput cancelled;
        ASSERT_EQ(prepare(request, Context{ &listener, nullptr }, cancelled), Status::Cancelled)
          << "asking " << k;
        ASSERT_EQ(listener.askings(), k) << "nobody is asked again";
      }
    });
}

TEST(PrepareTrouble, AnyAllocationCanFail)
{
  ManyRequests(60).forAll(
    [](const InputRequest& request)
    {
      PreparedInput expected;
      account.allocations = 0;
      const Status first = prepare(request, Context(), expected);
      const std::size_t all = account.allocations;
      ASSERT_EQ(first, Status::Ok);
      const std::string bytes = bytesOf(expected);
      for (std::size_t k = 1; k <= all; ++k)
      {
        const std::size_t before = account.held;
        {
          PreparedInput out;
          account.allocations = 0;
          account.failAt = k;
          const Status status = prepare(request, Context(), out);
          account.failAt = 0;
          ASSERT_EQ(status, Status::OutOfMemory) << "allocation " << k << " of " << all;
        }
        ASSERT_EQ(account.held, before) << "something leaked";
      }
      PreparedInput again;
      ASSERT_EQ(prepare(request, Context(), again), Status::Ok);
      EXPECT_EQ(bytesOf(again), bytes);
    });
}

TEST(PrepareTrouble, ItTakesNoMoreMemoryThanEstimated)
{
  ManyRequests(20000).forAll(
    [](InputRequest request)
    {
      request.split = false;                // the crossings are unknown
      request.maximumSegmentLength = 0.0;   // the same
      request.heights = SourceHeights::Own; // whose triangulation is estimated as such
      const std::size_t before = account.held;
      account.peak = before;
      PreparedInput out;
      ASSERT_EQ(prepare(request, Context(), out), Status::Ok);
      EXPECT_LE(account.peak - before, preparationMemoryEstimate(request) + 10000);
    });
}

TEST(PrepareTrouble, TooManyPointsAreRefusedUnseen)
{
  PrepareCase given({ { { 1, 2, 3 } } }, {});
  given.request.points.count = kMaximumPoints;
  given.request.bounding = true;
  PreparedInput out;
  EXPECT_EQ(prepare(given.request, Context(), out), Status::TooManyPoints);
}

TEST(PrepareTrouble, ThreadsHaveNoSay)
{
  constexpr std::size_t kCount = (std::size_t(1) << 18) + 100; // enough to be shared
  PrepareCase given(oddPoints(kCount, 1), oddPoints(1000, 2), linesBetween(20, 1000, 3));
  given.request.split = true;
  ThreadExecutor threads(3);
  for (const bool isFitted : { false, true })
  {
    given.request.fitPlane = isFitted;
    given.request.bounding = !isFitted;
    PreparedInput alone, together;
    ASSERT_EQ(prepare(given.request, Context(), alone), Status::Ok);
    Listener listener;
    ASSERT_EQ(prepare(given.request, Context{ &listener, &threads }, together), Status::Ok);
    EXPECT_TRUE(bytesOf(alone) == bytesOf(together));
    EXPECT_EQ(alone.plane().normal(), together.plane().normal());
    OddPoints odd, same;
    ASSERT_EQ(findOddPoints(alone.points(), Context(), odd), Status::Ok);
    ASSERT_EQ(findOddPoints(alone.points(), Context{ nullptr, &threads }, same), Status::Ok);
    EXPECT_EQ(odd.firstNotFinite, same.firstNotFinite);
    EXPECT_EQ(odd.oddZ, same.oddZ);
    EXPECT_GT(odd.firstNotFinite, 0u);
  }
}

TEST(PrepareTrouble, ThreadsHearACancel)
{
  constexpr std::size_t kCount = std::size_t(1) << 18;
  PrepareCase given(oddPoints(kCount, 1), { { { 1, 2, 3 } } });
  given.request.fitPlane = true;
  ThreadExecutor threads(3);
  for (std::size_t k = 1; k < 12; ++k)
  {
    Listener listener(k);
    PreparedInput out;
    EXPECT_EQ(prepare(given.request, Context{ &listener, &threads }, out), Status::Cancelled)
      << "asking " << k;
  }
  Listener refusal(1);
  OddPoints odd;
  EXPECT_EQ(
    findOddPoints(given.request.points, Context{ &refusal, &threads }, odd), Status::Cancelled);
}

} // namespace
} // namespace test
} // namespace ahd
