// SPDX-License-Identifier: BSD-3-Clause
//
// Every predicate, every stage of it and the filters that the insertion inlines, against GMP over
// the whole range of double (PredicatesExtremes.h): 10^6 cases, in the long run 10^8. A case is one
// call of one predicate. Answers are counted by stage: all must occur.
#include "PredicatesExtremes.h"
#include "PredicatesCounts.h"
#include "PredicatesFastOracle.h"
#include "PredicatesOracle.h"

#include "ExactSigns.h"

#include "Arithmetic/WideInteger.h"
#include "Predicates/Filters.h"
#include "Predicates/Predicates.h"
#include "Predicates/Stages.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace ahd::test
{
namespace
{

#ifdef AHD_HAS_INT128
constexpr bool kHasGrid = true;
#else
constexpr bool kHasGrid = false;
#endif

// Other ways to compile the engine (CMakeLists.txt) have seeds of their own, and fewer.
#ifdef AHD_PREDICATES_BUILD
constexpr std::uint64_t kFirstSeed = 1 + 1000 * AHD_PREDICATES_BUILD, kLongSeeds = 25;
#else
constexpr std::uint64_t kFirstSeed = 1, kLongSeeds = 100;
#endif

/// Quadruples of each kind in the quick run.
#if defined(AHD_PREDICATES_BUILD)
constexpr std::uint64_t kQuick = 4000;
#elif defined(AHD_REDUCED_TESTS)
constexpr std::uint64_t kQuick = 1200;
#else
constexpr std::uint64_t kQuick = 12000;
#endif

/// The insertion's data of a, b, c relative to p (Insert/Kernel.h).
struct SeenFrom
{
  Lifted a, b, c;
  double guard;

  SeenFrom(const Point& p, const Point& q, const Point& r, const Point& s)
    : a(liftedFrom(p, q))
    , b(liftedFrom(p, r))
    , c(liftedFrom(p, s))
  {
    const double width = std::max(std::max(p.x, q.x), std::max(r.x, s.x)) -
      std::min(std::min(p.x, q.x), std::min(r.x, s.x));
    const double height = std::max(std::max(p.y, q.y), std::max(r.y, s.y)) -
      std::min(std::min(p.y, q.y), std::min(r.y, s.y));
    guard = inCircleGuard(4 * squaredLength(width, height));
  }

  bool orientCertain() const { return orientIsCertain(cross(a, b), a.z, b.z); }
  double inCircleInWalk() const { return inCircleDeterminant(a, b, c, cross(a, b)); }
  /// Of b, a, c.
  double inCircleInCavity() const
  {
    return multiplyAdd(a.z, cross(c, b), multiplyAdd(b.z, cross(a, c), -(c.z * cross(a, b))));
  }
  bool inCircleCertain(double det) const { return inCircleIsCertain(det, a.z, b.z, c.z, guard); }
};

bool isCertain(Border border, const Quadruple& q)
{
  switch (border)
  {
    case OrientBorder:
      return stages::orient2dByFilter(q[0], q[1], q[2]).has_value();
    case InCircleBorder:
      return stages::inCircleByFilter(q[0], q[1], q[2], q[3]).has_value();
    case FlatnessBorder:
      return stages::flatnessByFilter(q[0], q[1], q[2]).has_value();
    case KernelOrientBorder:
      return SeenFrom(q[2], q[0], q[1], q[3]).orientCertain();
    default:
      const SeenFrom seen(q[3], q[0], q[1], q[2]);
      return seen.inCircleCertain(seen.inCircleInWalk());
  }
}

/// The place of b for which the angle at c is as wide as in the last triangle that is not flat:
/// along -(5/2 A + A turned clockwise), where A runs from c to a; but for rounding.
Point atTheLimitOfFlatness(const Point& a, const Point& c)
{
  const double x = a.x - c.x, y = a.y - c.y;
  return { c.x - (2.5 * x + y), c.y - (2.5 * y - x) };
}

/// Tests all predicates on one quadruple after the other, until one is wrong.
class Examiner : public Verdict
{
public:
  /// Returns false if an answer was wrong: what() has it.
  bool examine(const Quadruple& q, Extreme extreme)
  {
    extreme_ = static_cast<std::size_t>(extreme);
    return orient(q[0], q[1], q[2]) && inCircle(q) && kernelFilters(q) && conflict(q) &&
      flat(q[0], q[1], q[2]) && nearlyFlat(q[3], q[1]) && less(q[0], q[1]) && less(q[2], q[3]);
  }

  /// Moves q to the border of one of the filters first, if found.
  bool examineAtBorder(Quadruple q, Extreme extreme, Extremes& source)
  {
    const auto border = static_cast<Border>(source.below(Borders));
    bool isThere = false;
    for (int tries = 0; tries < 3 && !isThere; ++tries)
    {
      Point& p = q[source.below(4)];
      double& coordinate = source.below(2) == 0 ? p.x : p.y;
      isThere = moveToBorder(coordinate, source, [&] { return isCertain(border, q); });
    }
    counts_.borders[border] += isThere;
    return examine(q, extreme);
  }

  const Counts& counts() const { return counts_; }

private:
  static bool agrees(const std::optional<int>& answer, int expected)
  {
    return !answer || *answer == expected;
  }

  bool orient(const Point& a, const Point& b, const Point& c)
  {
    turn_ = oracle_.orient(a, b, c);
    const auto byFilter = stages::orient2dByFilter(a, b, c);
    const auto onGrid = stages::orient2dOnGrid(a, b, c);
    const int stage = byFilter ? 0 : onGrid ? 1 : 2;
    ++counts_.orient[extreme_][stage][turn_ + 1];
    return expect(agrees(byFilter, turn_), "orient2dByFilter") &&
      expect(agrees(onGrid, turn_), "orient2dOnGrid") &&
      expect(stages::orient2dUnbounded(a, b, c) == turn_, "orient2dUnbounded") &&
      expect(orient2d(a, b, c) == turn_, "orient2d");
  }

  bool inCircle(const Quadruple& q)
  {
    const Point &a = q[0], &b = q[1], &c = q[2], &d = q[3];
    circle_ = oracle_.inCircle(a, b, c, d);
    const auto byFilter = stages::inCircleByFilter(a, b, c, d);
    const auto onGrid = stages::inCircleOnGrid(a, b, c, d);
    const int stage = byFilter ? 0 : onGrid ? 1 : 2;
    ++counts_.inCircle[extreme_][stage][circle_ + 1];
    return expect(agrees(byFilter, circle_), "inCircleByFilter") &&
      expect(agrees(onGrid, circle_), "inCircleOnGrid") &&
      expect(stages::inCircleUnbounded(a, b, c, d) == circle_, "inCircleUnbounded") &&
      expect(ahd::inCircle(a, b, c, d) == circle_, "inCircle");
  }

  bool flat(const Point& a, const Point& b, const Point& c)
  {
    const int expected = oracle_.flatness(a, b, c);
    const auto byFilter = stages::flatnessByFilter(a, b, c);
    const auto onGrid = stages::flatnessOnGrid(a, b, c);
    const int stage = byFilter ? 0 : onGrid ? 1 : 2;
    ++counts_.flatness[extreme_][stage][expected + 1];
    return expect(agrees(byFilter, expected), "flatnessByFilter") &&
      expect(agrees(onGrid, expected), "flatnessOnGrid") &&
      expect(stages::flatnessUnbounded(a, b, c) == expected, "flatnessUnbounded") &&
      expect(isFlat(a, b, c) == (expected < 0), "isFlat");
  }

  bool nearlyFlat(const Point& a, const Point& c)
  {
    const Point b = atTheLimitOfFlatness(a, c);
    return !std::isfinite(b.x) || !std::isfinite(b.y) || flat(a, b, c);
  }

  bool kernelFilters(const Quadruple& q)
  {
    const SeenFrom fromC(q[2], q[0], q[1], q[3]); // orient2d(a, b, c) is orient2d(c, a, b)
    const bool isOriented = fromC.orientCertain();
    ++counts_.kernelOrient[isOriented];
    const SeenFrom fromD(q[3], q[0], q[1], q[2]);
    const double inWalk = fromD.inCircleInWalk(), inCavity = fromD.inCircleInCavity();
    const bool isCertainInWalk = fromD.inCircleCertain(inWalk);
    const bool isCertainInCavity = fromD.inCircleCertain(inCavity);
    ++counts_.kernelInCircle[isCertainInWalk];
    ++counts_.kernelInCircle[isCertainInCavity];
    return expect(!isOriented || signOf(cross(fromC.a, fromC.b)) == turn_, "orientIsCertain") &&
      expect(!isCertainInWalk || signOf(inWalk) == circle_, "inCircleIsCertain, walk") &&
      expect(!isCertainInCavity || signOf(inCavity) == -circle_, "inCircleIsCertain, cavity");
  }

  bool conflict(Quadruple q)
  {
    if (turn_ == 0 || q[3] == q[0] || q[3] == q[1] || q[3] == q[2])
    {
      return true;
    }
    if (turn_ < 0)
    {
      std::swap(q[0], q[1]);
      circle_ = -circle_;
    }
    const Point &a = q[0], &b = q[1], &c = q[2], &d = q[3];
    const bool expected = oracle_.inConflict(a, b, c, d, circle_);
    if (circle_ == 0)
    {
      const auto largest = std::max_element(q.begin(), q.end(), FastOracle::less) - q.begin();
      ++counts_.ties[largest][expected];
      if (!expect(stages::conflictOnCircle(a, b, c, d) == expected, "conflictOnCircle"))
      {
        return false;
      }
    }
    else
    {
      ++counts_.conflicts[expected];
    }
    return expect(inConflict(a, b, c, d) == expected, "inConflict") &&
      expect(inConflictExact(a, b, c, d) == expected, "inConflictExact");
  }

  bool less(const Point& p, const Point& q)
  {
    const bool expected = FastOracle::less(p, q);
    ++counts_.less[expected];
    const bool isEqual = !expected && !FastOracle::less(q, p);
    return expect(lexicographicallyLess(p, q) == expected, "lexicographicallyLess") &&
      expect((p == q) == isEqual, "operator==");
  }

  FastOracle oracle_;
  Counts counts_;
  std::size_t extreme_ = 0;
  int turn_ = 0;
  int circle_ = 0;
};

std::string textOf(const Quadruple& q)
{
  return hexText(q[0]) + ", " + hexText(q[1]) + ", " + hexText(q[2]) + ", " + hexText(q[3]);
}

/// The number of a draw and its extreme make a task; threads take them in turn.
struct Volume
{
  std::uint64_t firstSeed;
  std::uint64_t seeds;
  std::uint64_t quadruplesPerSeed;
  unsigned threads;
};

/// Every fourth quadruple is moved to the border of a filter.
std::string examineTask(
  Examiner& examiner, Extreme extreme, std::uint64_t seed, std::uint64_t count)
{
  Extremes source(extreme, seed);
  for (std::uint64_t i = 0; i < count; ++i)
  {
    const Quadruple q = source.draw();
    const bool isRight = i % 4 == 3 ? examiner.examineAtBorder(q, extreme, source)
                                    : examiner.examine(q, extreme);
    if (!isRight)
    {
      return examiner.what() + " is wrong: " + nameOf(extreme) + ", seed " + std::to_string(seed) +
        ", number " + std::to_string(i) + (i % 4 == 3 ? ", before it was moved: " : ": ") +
        textOf(q) + "\n";
    }
  }
  return "";
}

Counts examineAll(const Volume& volume)
{
  std::atomic<std::uint64_t> next{ 0 };
  std::vector<Examiner> examiners(volume.threads);
  std::vector<std::string> failures(volume.threads);
  const auto work = [&](unsigned thread)
  {
    for (std::uint64_t task = next++; task < volume.seeds * kExtremes; task = next++)
    {
      failures[thread] += examineTask(examiners[thread], static_cast<Extreme>(task % kExtremes),
        volume.firstSeed + task / kExtremes, volume.quadruplesPerSeed);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < volume.threads; ++i)
  {
    threads.emplace_back(work, i);
  }
  work(0);
  Counts counts;
  for (unsigned i = 0; i < volume.threads; ++i)
  {
    if (i > 0)
    {
      threads[i - 1].join();
    }
    counts.add(examiners[i].counts());
    EXPECT_EQ(failures[i], "");
  }
  return counts;
}

/// Each stage with each answer it can give.
void expectAllStages(const char* name, const std::uint64_t (&counts)[kExtremes][3][3])
{
  for (int stage = 0; stage < 3; ++stage)
  {
    for (int sign = -1; sign <= 1; ++sign)
    {
      std::uint64_t sum = 0;
      for (std::size_t i = 0; i < kExtremes; ++i)
      {
        sum += counts[i][stage][sign + 1];
      }
      const bool isPossible = stage == 0 ? sign != 0 : stage == 2 || kHasGrid;
      EXPECT_EQ(sum > 0, isPossible) << name << ", stage " << stage << ", answer " << sign;
    }
  }
  for (std::size_t i = 0; i < kExtremes; ++i)
  {
    EXPECT_GT(sumOf(counts[i][1]) + sumOf(counts[i][2]), sumOf(counts[i]) / 100)
      << name << ": " << nameOf(static_cast<Extreme>(i)) << " is not hard any more";
  }
}

void expectAllReached(const Counts& counts)
{
  expectAllStages("orient2d", counts.orient);
  expectAllStages("inCircle", counts.inCircle);
  expectAllStages("flatness", counts.flatness);
  for (std::size_t largest = 0; largest < 4; ++largest)
  {
    EXPECT_GT(counts.ties[largest][0], 0u) << largest;
    EXPECT_EQ(counts.ties[largest][1] > 0, largest != 3) << largest;
  }
  for (std::size_t answer = 0; answer < 2; ++answer)
  {
    EXPECT_GT(counts.conflicts[answer], 0u);
    EXPECT_GT(counts.kernelOrient[answer], 0u);
    EXPECT_GT(counts.kernelInCircle[answer], 0u);
    EXPECT_GT(counts.less[answer], 0u);
  }
  for (const std::uint64_t count : counts.borders)
  {
    EXPECT_GT(count, 0u);
  }
}

TEST(PredicatesExtremes, AMillionCases)
{
  const Counts counts = examineAll({ kFirstSeed, 1, kQuick, 1 });
#ifndef AHD_REDUCED_TESTS
  EXPECT_GE(casesOf(counts), 1000000u);
#endif
  expectAllReached(counts);
}

TEST(PredicatesExtremes, BothOraclesAgree)
{
  FastOracle fast;
  for (std::size_t i = 0; i < kExtremes; ++i)
  {
    Extremes source(static_cast<Extreme>(i), 0);
    for (int k = 0; k < 500; ++k)
    {
      const Quadruple q = source.draw();
      const Point &a = q[0], &b = q[1], &c = q[2], &d = q[3];
      ASSERT_EQ(fast.orient(a, b, c), oracleOrient2d(a, b, c)) << textOf(q);
      ASSERT_EQ(fast.flatness(a, b, c), oracleFlatness(a, b, c)) << textOf(q);
      const int sign = oracleInCircle(a, b, c, d);
      ASSERT_EQ(fast.inCircle(a, b, c, d), sign) << textOf(q);
      ASSERT_EQ(fast.inConflict(a, b, c, d, sign), oracleInConflict(a, b, c, d)) << textOf(q);
      ASSERT_EQ(FastOracle::less(a, b), lexicographicallyLess(a, b)) << textOf(q);
    }
  }
}

TEST(LongPredicatesExtremes, AHundredMillionCases)
{
  const Counts counts = examineAll({ kFirstSeed, kLongSeeds, 12000, 2 });
  EXPECT_GE(casesOf(counts), kLongSeeds * 1000000);
  print(counts);
  expectAllReached(counts);
}

} // namespace
} // namespace ahd::test
