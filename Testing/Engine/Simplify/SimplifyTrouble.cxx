// SPDX-License-Identifier: BSD-3-Clause
//
// simplify() of few points, of points on one line, where it is cancelled, and where memory runs
// out. This program's operator new counts, and fails on demand.
#include "SimplifyCase.h"

#include "Listeners.h"
#include "MemoryListener.h"
#include "OwnMemory.h"

#include <limits>

namespace ahd
{
namespace test
{
namespace
{

TEST(SimplifyTrouble, FewPointsAndPointsOnOneLineAreKept)
{
  for (std::size_t n = 0; n < 4; ++n)
  {
    SimplifyCase given = hills(n, 1);
    given.settings.maximumError = 1000.0;
    const SimplifyResult result = given.simplified();
    EXPECT_EQ(result.kept, n);
    EXPECT_EQ(result.lots.size(), n);
    EXPECT_EQ(keptIds(result).size(), n);
  }
  SimplifyCase line;
  for (int k = 0; k < 10000; ++k)
  {
    line.add({ double(k), 2.0 * k }, double(k % 7));
  }
  line.settings.maximumError = 1000.0;
  EXPECT_EQ(line.simplified().kept, line.count());
  line.add({ 3.0, 4.0 }, 0.0);
  EXPECT_EQ(line.simplified().kept, 3u) << "a triangle, and the line is an edge of it";
}

TEST(SimplifyTrouble, PointsThatAreSkippedOrNotFinite)
{
  SimplifyCase given = hills(2000, 2);
  given.settings.maximumError = 0.5;
  std::vector<unsigned char> skip(given.count(), 0);
  skip[10] = 4;
  skip[11] = 3;
  given.numbers[60] = std::numeric_limits<double>::quiet_NaN();
  SimplifyRequest request = given.request();
  request.points.skip = skip.data();
  request.points.skipMask = 4;
  SimplifyResult result;
  ASSERT_EQ(simplify(request, Context(), result), Status::Ok);
  EXPECT_EQ(result.lots[10], PointLot::Skipped);
  EXPECT_NE(result.lots[11], PointLot::Skipped);
  EXPECT_EQ(result.lots[20], PointLot::Kept) << "it is for triangulate() to reject";
  EXPECT_EQ(result.kept + result.withinError, given.count() - 2);
}

TEST(SimplifyTrouble, Bounds)
{
  EXPECT_TRUE(isErrorBound(0.0));
  EXPECT_TRUE(isErrorBound(1e300));
  EXPECT_FALSE(isErrorBound(-1e-300));
  EXPECT_FALSE(isErrorBound(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(isErrorBound(std::numeric_limits<double>::infinity()));
}

SimplifyCase everything(std::size_t n)
{
  SimplifyCase given = hills(n, 3, 0.3);
  given.constraints.addLine({ 1, 2, 3, 2, 1 });
  given.settings.maximumError = 0.1;
  given.settings.secondPass = true;
  return given;
}

TEST(SimplifyTrouble, AnyAskingCanCancel)
{
  const SimplifyCase given = everything(reduced(30000));
  Listener all;
  SimplifyResult made;
  ASSERT_EQ(simplify(given.request(), Context{ &all, nullptr }, made), Status::Ok);
  EXPECT_GT(all.askings(), 50u);
  EXPECT_EQ(all.phases(), (std::vector<Phase>{ Phase::Read, Phase::Sort, Phase::Insert }));
  for (std::size_t k = 1; k <= all.askings(); k += 1 + all.askings() / 50)
  {
    Listener listener(k);
    ASSERT_EQ(simplify(given.request(), Context{ &listener, nullptr }, made), Status::Cancelled);
    EXPECT_EQ(listener.askings(), k) << "nobody is asked again";
  }
}

TEST(SimplifyTrouble, AnyAllocationCanFail)
{
  const SimplifyCase given = everything(reduced(3000));
  const std::vector<std::size_t> expected = keptIds(given.simplified());
  for (std::size_t failed = 0;; failed += 1 + failed / 8)
  {
    const std::size_t before = account.held;
    Status status = Status::Ok;
    {
      SimplifyResult made;
      const SimplifyRequest request = given.request();
      account.allocations = 0;
      account.failAt = failed + 1;
      status = simplify(request, Context(), made);
      account.failAt = 0;
      EXPECT_TRUE(status != Status::Ok || keptIds(made) == expected);
    }
    EXPECT_EQ(account.held, before) << "something leaked";
    if (status == Status::Ok)
    {
      EXPECT_GT(failed, 20u);
      break;
    }
    ASSERT_EQ(status, Status::OutOfMemory) << "allocation " << failed + 1;
  }
}

TEST(SimplifyTrouble, TakesNoMoreThanItEstimatesAndRequests)
{
  for (const double bound : { 0.0, 0.01, 1.0 })
  {
    SimplifyCase given = everything(reduced(30000));
    given.settings.maximumError = bound;
    const SimplifyRequest request = given.request();
    MemoryListener listener;
    SimplifyResult made;
    const std::size_t before = account.held;
    account.peak = before;
    ASSERT_EQ(simplify(request, Context{ &listener, nullptr }, made), Status::Ok);
    EXPECT_LE(account.peak - before, simplifyMemoryEstimate(request) + listener.memory.most())
      << bound;
    EXPECT_LE(account.peak - before, given.count() * 400);
    MemoryListener refusing(listener.memory.most() - 1);
    EXPECT_EQ(simplify(request, Context{ &refusing, nullptr }, made), Status::OutOfMemory);
    EXPECT_TRUE(refusing.memory.wasRefused());
  }
}

} // namespace
} // namespace test
} // namespace ahd
