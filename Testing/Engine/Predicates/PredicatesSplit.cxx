// SPDX-License-Identifier: BSD-3-Clause
//
// The predicates of splitting (Predicates/Segments.h), each stage, against rational arithmetic over
// the whole range of double. Each stage must give each answer.
#include "PredicatesFastOracle.h"
#include "PredicatesSegments.h"

#include "ExactSigns.h"

#include "Predicates/SegmentStages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace ahd::test
{
namespace
{

#ifdef AHD_REDUCED_TESTS
constexpr std::uint64_t kQuick = 300;
#else
constexpr std::uint64_t kQuick = 2000;
#endif

/// How often it happened; signs at sign + 1.
struct Counts
{
  std::uint64_t sides[3] = {};           ///< orderAt: decided by the sides of p
  std::uint64_t onBoth = 0;              ///< orderAt: both at p
  std::uint64_t heightsByFilter[3] = {}; ///< orderAt: by the heights
  std::uint64_t heightsUnbounded[3] = {};
  std::uint64_t steepness[2][3] = {}; ///< orderAt: of equal heights, above p and below
  std::uint64_t steepnessByLeft = 0;  ///< the same, where the right end does not decide
  std::uint64_t outOfBox = 0;         ///< roundsTo
  std::uint64_t passes = 0;
  std::uint64_t meets[2] = {};
  std::uint64_t crossings = 0;
  std::uint64_t exact = 0; ///< coordinates of crossings: not rounded
  std::uint64_t ties = 0;
  std::uint64_t subnormal = 0;
  std::uint64_t zeros = 0;
  std::uint64_t borders[2] = {};   ///< cases at the border of a filter: heights, passes
  std::uint64_t fractions[2] = {}; ///< without and with halves
};

std::string textOf(const SegmentsAndPoint& c)
{
  return hexText(c.s.left) + " to " + hexText(c.s.right) + ", " + hexText(c.t.left) + " to " +
    hexText(c.t.right) + ", p = " + hexText(c.p);
}

/// Tests one case after the other. Each function returns true if all answers are correct.
class SplitExaminer : public Verdict
{
public:
  bool examine(const SegmentsAndPoint& c)
  {
    const bool areSegments = !(c.s.left == c.s.right) && !(c.t.left == c.t.right);
    return !areSegments || !isFinite(c.p) ||
      (order(c) && rounding(c.s, c.p) && rounding(c.t, c.p) && crossing(c.s, c.t) &&
        fraction(c.s, c.p));
  }
  /// The same, of a case moved to the border of a filter if that has one there.
  bool examineAtBorder(SegmentsAndPoint c, bool ofHeights, SegmentSource& source)
  {
    const bool isThere = source.moveToBorderOf(c,
      [&](const SegmentsAndPoint& moved)
      {
        return ofHeights ? stages::heightsByFilter(moved.s, moved.t, moved.p).has_value()
                         : stages::passesByFilter(moved.s, moved.p);
      });
    counts_.borders[ofHeights ? 0 : 1] += isThere;
    return examine(c);
  }
  const Counts& counts() const { return counts_; }

private:
  static bool reaches(const Segment& s, const Point& p)
  {
    return !FastOracle::less(p, s.left) && !FastOracle::less(s.right, p);
  }

  bool order(const SegmentsAndPoint& c)
  {
    if (!reaches(c.s, c.p) || !reaches(c.t, c.p))
    {
      return true;
    }
    const int sideOfS = oracle_.orient(c.s.left, c.s.right, c.p);
    const int sideOfT = oracle_.orient(c.t.left, c.t.right, c.p);
    const int expected = exactOrderAt(c.s, c.t, c.p);
    if (sideOfS != sideOfT)
    {
      ++counts_.sides[expected + 1];
    }
    else if (sideOfS == 0)
    {
      ++counts_.onBoth;
    }
    else if (!heights(c, sideOfS, expected))
    {
      return false;
    }
    return expect(orderAt(c.s, sideOfS, c.t, sideOfT, c.p) == expected, "orderAt") &&
      expect(orderAt(c.t, sideOfT, c.s, sideOfS, c.p) == -expected, "orderAt, exchanged");
  }

  bool heights(const SegmentsAndPoint& c, int side, int expected)
  {
    const auto byFilter = stages::heightsByFilter(c.s, c.t, c.p);
    const int unbounded = stages::heightsUnbounded(c.s, c.t, c.p);
    if (byFilter)
    {
      ++counts_.heightsByFilter[expected + 1];
    }
    else if (unbounded != 0)
    {
      ++counts_.heightsUnbounded[expected + 1];
    }
    else
    {
      ++counts_.steepness[side < 0][expected + 1];
      counts_.steepnessByLeft += oracle_.orient(c.t.left, c.t.right, c.s.right) == 0;
    }
    return expect(!byFilter || *byFilter == expected, "heightsByFilter") &&
      expect(unbounded == 0 || unbounded == expected, "heightsUnbounded");
  }

  bool rounding(const Segment& s, const Point& p)
  {
    const bool expected = exactRoundsTo(s, p);
    const double low = std::min(s.left.y, s.right.y), high = std::max(s.left.y, s.right.y);
    if (p.x < s.left.x || p.x > s.right.x || p.y < low || p.y > high)
    {
      ++counts_.outOfBox;
    }
    else
    {
      const bool passes = stages::passesByFilter(s, p);
      counts_.passes += passes;
      counts_.meets[expected] += !passes;
      if (!expect(!(passes && expected), "passesByFilter"))
      {
        return false;
      }
    }
    return expect(roundsTo(s, p) == expected, "roundsTo");
  }

  bool areApart(const Segment& s, const Segment& t)
  {
    return oracle_.orient(s.left, s.right, t.left) * oracle_.orient(s.left, s.right, t.right) >=
      0 ||
      oracle_.orient(t.left, t.right, s.left) * oracle_.orient(t.left, t.right, s.right) >= 0;
  }

  bool crossing(const Segment& s, const Segment& t)
  {
    if (areApart(s, t))
    {
      return true;
    }
    ++counts_.crossings;
    const ExactSegment S(s), T(t);
    const mpq_class part = ((T.x - S.x) * T.dy - (T.y - S.y) * T.dx) / (S.dx * T.dy - S.dy * T.dx);
    const Point p = crossingOf(s, t), turned = crossingOf(t, s);
    return coordinate(p.x, S.x + part * S.dx) && coordinate(p.y, S.y + part * S.dy) &&
      expect(hexText(p) == hexText(turned), "crossingOf, exchanged");
  }

  bool coordinate(double value, const mpq_class& exact)
  {
    bool isTie = false;
    if (!expect(isNearest(value, exact, isTie), "crossingOf"))
    {
      return false;
    }
    counts_.ties += isTie;
    counts_.exact += mpq_class(value) == exact;
    counts_.zeros += value == 0.0;
    counts_.subnormal += value != 0.0 && std::fabs(value) < 0x1p-1022;
    return expect(value != 0.0 || !std::signbit(value), "crossingOf gives -0");
  }

  /// Ten roundings are generous. Where both ways are nearly as long, either may be taken.
  bool fraction(const Segment& s, const Point& p)
  {
    const double found = fractionOfWay(s.left, s.right, p);
    const ExactSegment S(s);
    const mpq_class width = abs(S.dx), height = abs(S.dy);
    const mpq_class slack(1.0 + 0x1p-50);
    counts_
      .fractions[!std::isfinite(s.right.x - s.left.x) || !std::isfinite(s.right.y - s.left.y)]++;
    bool isRight = false;
    if (sgn(width) != 0 && width * slack >= height)
    {
      isRight = isNear(found, (mpq_class(p.x) - S.x) / S.dx);
    }
    if (sgn(height) != 0 && height * slack >= width)
    {
      isRight = isRight || isNear(found, (mpq_class(p.y) - S.y) / S.dy);
    }
    return expect(isRight && found >= 0.0 && found <= 1.0, "fractionOfWay");
  }

  static bool isNear(double found, const mpq_class& exact)
  {
    const mpq_class inside = exact < 0 ? mpq_class(0) : exact > 1 ? mpq_class(1) : exact;
    return abs(mpq_class(found) - inside) <=
      10 * mpq_class(0x1p-53) * inside + mpq_class(0x1p-1074);
  }

  FastOracle oracle_;
  Counts counts_;
};

Counts examineAll(std::uint64_t seeds, std::uint64_t casesPerSeed)
{
  SplitExaminer examiner;
  for (std::uint64_t task = 0; task < seeds * kExtremes; ++task)
  {
    const auto extreme = static_cast<Extreme>(task % kExtremes);
    const std::uint64_t seed = kFirstSeed + task / kExtremes;
    SegmentSource source(extreme, seed);
    for (std::uint64_t i = 0; i < casesPerSeed; ++i)
    {
      const SegmentsAndPoint c = source.draw();
      const bool isRight = i % 4 < 2 ? examiner.examine(c)
                                     : examiner.examineAtBorder(c, i % 4 == 2, source);
      if (!isRight)
      {
        ADD_FAILURE() << examiner.what() << " is wrong: " << nameOf(extreme) << ", seed " << seed
                      << ", number " << i << ", p before it was moved: " << textOf(c);
        break;
      }
    }
  }
  return examiner.counts();
}

void print(const Counts& n)
{
  const auto row = [](const char* name, const std::uint64_t* counts, std::size_t size)
  {
    std::printf("%-44s", name);
    for (std::size_t i = 0; i < size; ++i)
    {
      std::printf(" %10llu", static_cast<unsigned long long>(counts[i]));
    }
    std::printf("\n");
  };
  row("orderAt by sides: -, +", std::array<std::uint64_t, 2>{ n.sides[0], n.sides[2] }.data(), 2);
  row("orderAt: both at p", &n.onBoth, 1);
  row("heights by filter: -, 0, +", n.heightsByFilter, 3);
  row("heights unbounded: -, 0, +", n.heightsUnbounded, 3);
  row("equal heights above p: -, 0, +", n.steepness[1], 3);
  row("equal heights below p: -, 0, +", n.steepness[0], 3);
  row("the same, told by the left end", &n.steepnessByLeft, 1);
  row("roundsTo: out of the box", &n.outOfBox, 1);
  row("roundsTo: passes by filter", &n.passes, 1);
  row("roundsTo, exactly: no, yes", n.meets, 2);
  row("crossingOf", &n.crossings, 1);
  row("coordinates of crossings: exact", &n.exact, 1);
  row("coordinates of crossings: ties", &n.ties, 1);
  row("coordinates of crossings: subnormal", &n.subnormal, 1);
  row("coordinates of crossings: zero", &n.zeros, 1);
  row("borders of filters: heights, passes", n.borders, 2);
  row("fractionOfWay: as it is, of halves", n.fractions, 2);
}

void expectAllReached(const Counts& n)
{
  for (const int sign : { -1, 1 })
  {
    const int k = sign + 1;
    EXPECT_GT(n.sides[k], 0u) << sign;
    EXPECT_GT(n.heightsByFilter[k], 0u) << sign;
    EXPECT_GT(n.heightsUnbounded[k], 0u) << sign;
    EXPECT_GT(n.steepness[0][k], 0u) << sign;
    EXPECT_GT(n.steepness[1][k], 0u) << sign;
  }
  EXPECT_GT(n.steepness[0][1], 0u);
  EXPECT_GT(n.steepness[1][1], 0u);
  EXPECT_EQ(n.sides[1] + n.heightsByFilter[1] + n.heightsUnbounded[1], 0u);
  for (const std::uint64_t count : { n.onBoth, n.steepnessByLeft, n.outOfBox, n.passes, n.meets[0],
         n.meets[1], n.crossings, n.exact, n.ties, n.subnormal, n.zeros, n.borders[0], n.borders[1],
         n.fractions[0], n.fractions[1] })
  {
    EXPECT_GT(count, 0u);
  }
}

TEST(PredicatesSplit, TensOfThousandsOfCases)
{
  expectAllReached(examineAll(1, kQuick));
}

TEST(LongPredicatesSplit, TwoMillionCases)
{
  const Counts counts = examineAll(100, 2000);
  print(counts);
  expectAllReached(counts);
}

} // namespace
} // namespace ahd::test
