// SPDX-License-Identifier: BSD-3-Clause
//
// Segments in orders that are bad for inserting them one by one, and many on one line: results, and
// bounds of the work, by the polls of Progress. Bounds: Algorithm.md ("Work").
#include "ConstrainedRun.h"
#include "ConstraintFamilies.h"
#include "Listeners.h"

#include "Crossings/Crossings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace ahd::test
{
namespace
{

/// Steps are at most this times m log2(m), for m points and ends of segments.
constexpr double kMostSteps = 20.0;

/// The constraints: the family's segments, or the pieces they are split into.
ConstraintCase segmentsOf(const ConstraintFamily& family)
{
  if (!family.split)
  {
    return family.given;
  }
  SplitConstraints split;
  EXPECT_EQ(splitAtCrossings(family.given.view(), family.given.constraints.view(), nullptr, split),
    Status::Ok);
  ConstraintCase result;
  result.points = family.given.points;
  for (const auto& point : split.points)
  {
    result.points.push_back(point.at);
  }
  const ConstraintView chains = split.view();
  for (std::size_t k = 0; k < chains.chains; ++k)
  {
    result.constraints.addLine(
      Chain(chains.ids + chains.offsets[k], chains.ids + chains.offsets[k + 1]));
  }
  return result;
}

/// Steps divided by m log2(m). `crossing`: so many of the segments must be left out.
double stepsOver(const ConstraintCase& given, std::size_t crossing = 0)
{
  StepCounter counter;
  Engine engine;
  EXPECT_EQ(engine.run(given.view(), Options(), nullptr), Status::Ok);
  EXPECT_EQ(engine.constrain(given.constraints.view(), FillRule::EvenOdd, &counter), Status::Ok);
  EXPECT_EQ(engine.constraints().crossing, crossing);
  const double size = double(given.points.size() + 2 * engine.constraints().segments);
  return counter.steps(Phase::Constrain) / (size * std::log2(size));
}

TEST(ConstrainWork, FamiliesMadeToBeHard)
{
  for (const ConstraintFamily& family : constraintFamilies(reduced(10000)))
  {
    EXPECT_LE(stepsOver(segmentsOf(family)), kMostSteps) << family.name;
  }
}

TEST(ConstrainWork, RandomFamilies)
{
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    EXPECT_LE(stepsOver(segmentsOf(randomFamily(seed, reduced(4000)))), kMostSteps) << seed;
  }
}

TEST(LongConstrainWork, LargeFamilies)
{
  for (const ConstraintFamily& family : constraintFamilies(reduced(100000)))
  {
    EXPECT_LE(stepsOver(segmentsOf(family)), kMostSteps) << family.name;
  }
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    EXPECT_LE(stepsOver(segmentsOf(randomFamily(seed, reduced(20000)))), kMostSteps) << seed;
  }
}

/// A few that cross do not bring the square back.
TEST(ConstrainWork, FewThatCross)
{
  const std::size_t n = 10000, rungs = n / 200;
  EXPECT_LE(stepsOver(crossedLadder(n, rungs, true), rungs / 2), kMostSteps);
  EXPECT_LE(stepsOver(crossedLadder(n, rungs, false), 1), kMostSteps);
  EXPECT_LE(stepsOver(crossedNested(n, 0.02, true), n / 50 + 1), kMostSteps);
  EXPECT_LE(stepsOver(crossedNested(n, 0.02, false), 1), kMostSteps);
  EXPECT_LE(stepsOver(crossedNested(n, 0.5, false), 1), kMostSteps);
}

/// Cases with no bound but the square: segments inserted one by one, as many cross. (If this fails
/// the bounds have become better, and Algorithm.md must say so.)
TEST(ConstrainWork, WhatIsNotBounded)
{
  const std::size_t n = 10000;
  EXPECT_GT(stepsOver(crossedLadder(n, n / 16, false), 1), 2 * kMostSteps);
  EXPECT_GT(stepsOver(crossedNested(n, 0.5, true), n / 2 - 1), 2 * kMostSteps);
}

std::vector<ConstraintCase> smallCases()
{
  std::vector<ConstraintCase> cases;
  for (const ConstraintFamily& family : constraintFamilies(400))
  {
    cases.push_back(segmentsOf(family));
  }
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    cases.push_back(segmentsOf(randomFamily(seed, 400)));
  }
  for (const bool isFirst : { true, false })
  {
    for (const std::size_t rungs : { 2, 10, 50 })
    {
      cases.push_back(crossedLadder(400, rungs, isFirst));
    }
    for (const double part : { 0.01, 0.1, 0.5 })
    {
      cases.push_back(crossedNested(400, part, isFirst));
    }
  }
  return cases;
}

TEST(ConstrainWork, AreCertified)
{
  for (const ConstraintCase& given : smallCases())
  {
    EXPECT_EQ(faultsOfConstraining(given, FillRule::EvenOdd), "");
  }
}

TEST(ConstrainWork, TheOrderChangesNothing)
{
  for (const ConstraintFamily& family : constraintFamilies(4000))
  {
    const ConstraintCase given = segmentsOf(family);
    if (given.constraints.lines() == given.constraints.chains())
    {
      const ConstrainedOutcome expected = constrain(given, FillRule::EvenOdd);
      EXPECT_EQ(difference(expected, constrain(shuffled(given, 1), FillRule::EvenOdd)), "")
        << family.name;
    }
  }
}

TEST(ConstrainWork, NoThreadChangesAByte)
{
  ThreadExecutor three(3);
  for (const ConstraintCase& given : { ladder(20000, 0.25), crossedLadder(20000, 100, false),
         crossedNested(16000, 0.02, true), randomFamily(1, 30000).given })
  {
    const ConstrainedOutcome expected = constrain(given, FillRule::EvenOdd);
    EXPECT_EQ(differenceByThreads(given, FillRule::EvenOdd, expected, three), "");
  }
}

} // namespace
} // namespace ahd::test
