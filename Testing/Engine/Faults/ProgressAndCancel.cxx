// SPDX-License-Identifier: BSD-3-Clause
//
// The engine's progress, how often it polls, and that it stops when cancelled.
#include "Distributions.h"
#include "EngineRun.h"

#include <gtest/gtest.h>

#include <array>

namespace ahd
{
namespace test
{
namespace
{

const char* nameOfPhase(Phase phase)
{
  static const char* const kNames[] = { "Merge", "Split", "Read", "Sort", "Insert", "Constrain",
    "Extract", "Outputs" };
  static_assert(sizeof kNames / sizeof *kNames == kPhases, "a name for each phase");
  return kNames[int(phase)];
}

/// Records violations of the rules of Progress.h, and cancels at one poll if set.
class Listener : public Progress
{
public:
  explicit Listener(std::size_t cancelAt = 0)
    : cancelAt_(cancelAt)
  {
  }

  void beginPhase(Phase phase) override
  {
    if (!begun_.empty() && int(phase) <= int(begun_.back()))
    {
      faults_ += std::string(nameOfPhase(phase)) + " begins after " + nameOfPhase(begun_.back()) +
        "\n";
    }
    begun_.push_back(phase);
    fraction_ = 0.0;
  }

  bool advance(Phase phase, double fraction) override
  {
    ++askings_[std::size_t(phase)];
    ++allAskings_;
    if (begun_.empty() || phase != begun_.back())
    {
      faults_ += std::string("asked in ") + nameOfPhase(phase) + ", which is not the phase\n";
    }
    if (!(fraction >= fraction_ && fraction <= 1.0))
    {
      faults_ += std::string(nameOfPhase(phase)) + ": fraction " + std::to_string(fraction) +
        " after " + std::to_string(fraction_) + "\n";
    }
    fraction_ = fraction;
    if (cancelled_)
    {
      faults_ += "asked again after it was cancelled\n";
    }
    cancelled_ = allAskings_ == cancelAt_;
    return !cancelled_;
  }

  const std::string& faults() const { return faults_; }
  const std::vector<Phase>& begun() const { return begun_; }
  std::size_t askings() const { return allAskings_; }
  std::size_t askings(Phase phase) const { return askings_[std::size_t(phase)]; }

private:
  std::size_t cancelAt_;
  std::size_t allAskings_ = 0;
  std::array<std::size_t, kPhases> askings_{};
  std::vector<Phase> begun_;
  double fraction_ = 0.0;
  bool cancelled_ = false;
  std::string faults_;
};

/// Runs with every step counted and checks how often the engine polled.
void expectAskedOften(const std::vector<Point>& points, Options options)
{
  options.countWork = true;
  Engine engine;
  Listener listener;
  const Outcome outcome = triangulate(engine, viewOf(points), options, &listener);
  ASSERT_EQ(outcome.status, Status::Ok);
  EXPECT_EQ(listener.faults(), "");
  EXPECT_EQ(listener.begun(),
    (std::vector<Phase>{
      Phase::Read, Phase::Sort, Phase::Insert, Phase::Extract, Phase::Outputs }));
  const std::uint64_t inserting = outcome.report.trianglesWalked + outcome.report.trianglesRemoved;
  EXPECT_GE(listener.askings(Phase::Read), points.size() / kStepsPerAsking);
  EXPECT_GE(listener.askings(Phase::Sort), outcome.report.inserted / kStepsPerAsking);
  EXPECT_GE(listener.askings(Phase::Insert), inserting / kStepsPerAsking)
    << inserting << " triangles walked and removed";
  EXPECT_GE(listener.askings(Phase::Extract), outcome.report.triangles / kStepsPerAsking);
  EXPECT_GE(listener.askings(Phase::Outputs), points.size() / kStepsPerAsking);
}

TEST(ProgressAndCancel, AskedOftenUnderEveryOrder)
{
  const std::vector<Point> points = makePoints(Distribution::Mixed, reduced(40000), 1);
  for (const Options& options : everyDistinctSetting({ 1, 50 }))
  {
    SCOPED_TRACE(describe(options));
    expectAskedOften(points, options);
  }
}

TEST(ProgressAndCancel, AskedOftenOnEveryDistribution)
{
  for (const Distribution distribution : paperDistributions())
  {
    SCOPED_TRACE(nameOf(distribution));
    expectAskedOften(makePoints(distribution, reduced(200000), 1), Options());
  }
  for (const Distribution distribution : { Distribution::KuzminDisc, Distribution::NestedClusters,
         Distribution::CrowdedBox, Distribution::Lattice, Distribution::OnCircle })
  {
    SCOPED_TRACE(nameOf(distribution));
    expectAskedOften(makePoints(distribution, reduced(50000), 1), Options());
  }
}

TEST(ProgressAndCancel, AskedWithinOneCavity)
{
  // The last insertion of the caller's order removes nearly all triangles at once; everything
  // before it is the same with and without the last point, so the additional polls were within it.
  const std::size_t n = reduced(100000);
  Options options;
  options.order = InsertionOrder::AsGiven;
  options.countWork = true;
  std::vector<Point> points = makePoints(Distribution::OnCircle, n, 1);
  std::uint64_t removed[2];
  std::size_t askings[2];
  for (int last = 0; last < 2; ++last)
  {
    Engine engine;
    Listener listener;
    const Outcome outcome = triangulate(engine, viewOf(points), options, &listener);
    ASSERT_EQ(outcome.status, Status::Ok);
    removed[last] = outcome.report.trianglesRemoved;
    askings[last] = listener.askings(Phase::Insert);
    points.push_back({ 0.01, 0.02 }); // inside the circles of all triangles
  }
  const std::uint64_t inOneCavity = removed[1] - removed[0];
  ASSERT_GT(inOneCavity, n / 2) << "the input no longer does what it is made for";
  EXPECT_GE(askings[1] - askings[0], inOneCavity / kStepsPerAsking);
}

TEST(ProgressAndCancel, DuplicatesAreStepsToo)
{
  Engine engine;
  for (const Distribution distribution :
    { Distribution::AllEqual, Distribution::RepeatedDraws, Distribution::Collinear })
  {
    Listener listener;
    const std::vector<Point> points = makePoints(distribution, reduced(400000), 1);
    const Outcome outcome = triangulate(engine, viewOf(points), Options(), &listener);
    EXPECT_EQ(outcome.status, Status::Ok);
    EXPECT_EQ(listener.faults(), "") << nameOf(distribution);
    EXPECT_GE(listener.askings(Phase::Read), points.size() / kStepsPerAsking);
    EXPECT_GE(listener.askings(Phase::Sort), points.size() / kStepsPerAsking);
  }
}

TEST(ProgressAndCancel, NothingToDo)
{
  for (std::size_t n = 0; n < 4; ++n)
  {
    Engine engine;
    Listener listener;
    const std::vector<Point> points = makePoints(Distribution::Uniform, n, 1);
    EXPECT_EQ(triangulate(engine, viewOf(points), Options(), &listener).status, Status::Ok);
    EXPECT_EQ(listener.faults(), "");
  }
}

/// Cancels at the k-th poll for all k up to the last, or for a dozen spread over them.
void expectCancelledAnywhere(const std::vector<Point>& points, const Options& options)
{
  Engine engine;
  Listener whole;
  const Outcome expected = triangulate(engine, viewOf(points), options, &whole);
  ASSERT_EQ(expected.status, Status::Ok);
  if (whole.askings() == 0)
  {
    EXPECT_LT(points.size(), kStepsPerAsking) << "never asked";
    return;
  }
  const std::size_t step = 1 + whole.askings() / 12;
  for (std::size_t k = 1; k <= whole.askings(); k += step)
  {
    Listener listener(k);
    const Outcome outcome = triangulate(engine, viewOf(points), options, &listener);
    ASSERT_EQ(outcome.status, Status::Cancelled) << "at asking " << k;
    ASSERT_EQ(listener.faults(), "") << "at asking " << k;
    ASSERT_EQ(listener.askings(), k);
  }
  const Outcome again = triangulate(engine, viewOf(points), options);
  EXPECT_EQ(again.triples, expected.triples) << "after being cancelled";
  EXPECT_EQ(again.pointStatus, expected.pointStatus) << "after being cancelled";
}

TEST(ProgressAndCancel, CancelledAtAnyAsking)
{
  const std::vector<Point> points = makePoints(Distribution::Mixed, reduced(25000), 1);
  for (const Options& options : everyDistinctSetting({ 50 }))
  {
    SCOPED_TRACE(describe(options));
    expectCancelledAnywhere(points, options);
  }
}

TEST(ProgressAndCancel, CancelledAtAnyAskingOfAwkwardInput)
{
  for (const Distribution distribution : allDistributions())
  {
    SCOPED_TRACE(nameOf(distribution));
    expectCancelledAnywhere(
      makePoints(distribution, affordable(distribution, 20000), 1), Options());
  }
}

TEST(ProgressAndCancel, CancelledRunLeavesNoTriangles)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, 50000, 1);
  Engine engine;
  ASSERT_EQ(engine.run(viewOf(points), Options(), nullptr), Status::Ok);
  ASSERT_GT(engine.report().triangles, 0u);
  Listener listener(3);
  ASSERT_EQ(engine.run(viewOf(points), Options(), &listener), Status::Cancelled);
  EXPECT_EQ(engine.report().triangles, 0u);
}

} // namespace
} // namespace test
} // namespace ahd
