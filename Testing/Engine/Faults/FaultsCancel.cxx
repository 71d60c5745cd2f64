// SPDX-License-Identifier: BSD-3-Clause
//
// Cancelled at a thousand random moments, in any call, of random inputs under random settings:
// afterwards the object works like a new one.
#include "FaultsSession.h"

#include <gtest/gtest.h>

#include <memory>

namespace ahd
{
namespace test
{
namespace
{

/// Cancels at one poll, and counts all.
class Listener : public Progress
{
public:
  explicit Listener(std::size_t cancelAt)
    : cancelAt_(cancelAt)
  {
  }
  bool advance(Phase, double) override { return ++askings_ != cancelAt_; }
  std::size_t askings() const { return askings_; }

private:
  std::size_t cancelAt_;
  std::size_t askings_ = 0;
};

Status callOnly(const Session::Call& call)
{
  return call();
}

/// The random choices of a seed.
struct Choice
{
  explicit Choice(std::uint64_t seed, std::size_t most)
    : random(seed)
  {
    const auto& distributions = allDistributions();
    const Distribution distribution = distributions[random.below(distributions.size())];
    const std::size_t n = 50 + random.below(affordable(distribution, most));
    given = chainsThrough(distribution, n, random.below(30), seed);
    const std::vector<Options> settings = everyDistinctSetting({ 1, 50 });
    options = settings[random.below(settings.size())];
  }

  Random random;
  ConstraintCase given;
  Options options;
};

/// Runs one object through so many sessions, most of them cancelled, and compares each other one
/// with a new object.
void expectReusable(std::uint64_t seeds, std::size_t most)
{
  Engine reused;
  ThreadExecutor threads(3);
  std::size_t cancelled = 0;
  for (std::uint64_t seed = 1; cancelled < seeds; ++seed)
  {
    SCOPED_TRACE(seed);
    ASSERT_LT(seed, seeds);
    Choice chosen(seed, most);
    Helpers helpers;
    helpers.executor = chosen.random.below(3) == 0 ? &threads : nullptr;
    Listener whole(0);
    helpers.progress = &whole;
    Engine fresh;
    Session expected(chosen.given, chosen.options);
    ASSERT_EQ(expected.run(fresh, callOnly, helpers), Status::Ok);
    for (int i = 0; i < 8; ++i)
    {
      Listener listener(1 + chosen.random.below(whole.askings()));
      helpers.progress = &listener;
      reused.reclaim();
      Session session(chosen.given, chosen.options);
      const Status status = session.run(reused, callOnly, helpers);
      // With threads the last polls may not come.
      ASSERT_TRUE(status == Status::Cancelled || (status == Status::Ok && helpers.executor));
      cancelled += status == Status::Cancelled;
    }
    helpers.progress = nullptr;
    reused.reclaim();
    Session again(chosen.given, chosen.options);
    ASSERT_EQ(again.run(reused, callOnly, helpers), Status::Ok);
    ASSERT_TRUE(again.bytes() == expected.bytes());
  }
}

TEST(FaultsCancel, AThousandRandomMoments)
{
  expectReusable(reduced(1000) == 1000 ? 1000 : 200, 3000);
}

TEST(LongFaultsCancel, TenThousandRandomMomentsOfLargerInputs)
{
  expectReusable(10000, 50000);
}

} // namespace
} // namespace test
} // namespace ahd
