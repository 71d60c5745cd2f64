// SPDX-License-Identifier: BSD-3-Clause
//
// Distances of places from segments (Predicates/Distances.h), against rational arithmetic over the
// whole range of double.
#include "PredicatesExtremes.h"

#include "ExactSigns.h"
#include "ExactVectors.h"

#include "Predicates/Distances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

namespace ahd::test
{
namespace
{

#ifdef AHD_REDUCED_TESTS
constexpr std::uint64_t kQuick = 300;
#else
constexpr std::uint64_t kQuick = 1500;
#endif

enum Event
{
  PartLeft,
  PartInside,
  PartRight,
  NearerFirst,
  NearerSecond,
  NearerNone,
  NearerByFilter,
  Within,
  Beyond,
  WithinByFilter,
  Events
};

const char* const kEvents[] = { "part: left end", "part: inside", "part: right end",
  "nearer: the first", "nearer: the second", "nearer: none", "nearer: told by the filter", "within",
  "beyond", "within: told by the filter" };

mpq_class dot(const Vector& a, const Vector& b)
{
  return a.x * b.x + a.y * b.y;
}

/// The nearest place of a segment, as a part of the way, and its squared distance.
struct ExactFoot
{
  ExactFoot(const Segment& s, const Point& place)
  {
    const Vector way = between(s.left, s.right), to = between(s.left, place);
    part = s.left == s.right ? mpq_class(0) : mpq_class(dot(to, way) / dot(way, way));
    part = part < 0 ? mpq_class(0) : part > 1 ? mpq_class(1) : part;
    const Vector left{ to.x - part * way.x, to.y - part * way.y };
    squared = dot(left, left);
  }

  mpq_class part, squared;
};

Segment segmentOf(const Point& a, const Point& b)
{
  return lexicographicallyLess(b, a) ? Segment{ b, a } : Segment{ a, b };
}

class DistanceExaminer : public Verdict
{
public:
  bool examine(const Quadruple& q, Extremes& source)
  {
    const Segment s = segmentOf(q[0], q[1]), t = segmentOf(q[source.below(2)], q[3]);
    const Point place = q[2];
    return part(s, place) && nearer(s, t, place) && within(s, place, source);
  }
  std::uint64_t count(std::size_t event) const { return counts_[event]; }

private:
  bool part(const Segment& s, const Point& place)
  {
    const ExactFoot exact(s, place);
    const Event event = exact.part == 0 ? PartLeft : exact.part == 1 ? PartRight : PartInside;
    ++counts_[event];
    return expect(nearestPartOf(s, place) == NearestPart(event), "nearestPartOf");
  }

  bool nearer(const Segment& s, const Segment& t, const Point& place)
  {
    const int exact = cmp(ExactFoot(t, place).squared, ExactFoot(s, place).squared);
    const int sign = exact > 0 ? 1 : exact < 0 ? -1 : 0;
    ++counts_[sign == 0 ? NearerNone : sign > 0 ? NearerFirst : NearerSecond];
    const std::optional<int> filtered = stages::nearerByFilter(s, t, place);
    counts_[NearerByFilter] += filtered.has_value();
    return expect(nearerOf(s, t, place) == sign, "nearerOf") &&
      expect(stages::nearerUnbounded(s, t, place) == sign, "nearerUnbounded") &&
      expect(!filtered || *filtered == sign, "nearerByFilter");
  }

  /// By the rounding that is allowed, by what is next to the distance, and by any number.
  bool within(const Segment& s, const Point& place, Extremes& source)
  {
    const mpq_class squared = ExactFoot(s, place).squared;
    const double root = std::sqrt(squared.get_d());
    const double choices[] = { roundingAt(s, place), std::fabs(place.x),
      std::isfinite(root) ? std::fabs(ulpsFrom(root, source.whole(-2, 2))) : 1.0 };
    for (const double distance : choices)
    {
      const bool exact = squared <= mpq_class(distance) * mpq_class(distance);
      ++counts_[exact ? Within : Beyond];
      const std::optional<bool> filtered = stages::withinByFilter(s, distance, place);
      counts_[WithinByFilter] += filtered.has_value();
      if (!expect(isWithin(s, distance, place) == exact, "isWithin") ||
        !expect(stages::withinUnbounded(s, distance, place) == exact, "withinUnbounded") ||
        !expect(!filtered || *filtered == exact, "withinByFilter"))
      {
        return false;
      }
    }
    return true;
  }

  std::uint64_t counts_[Events] = {};
};

void examineAll(std::uint64_t seeds, std::uint64_t casesPerSeed)
{
  DistanceExaminer examiner;
  for (std::uint64_t task = 0; task < seeds * kExtremes; ++task)
  {
    const auto extreme = static_cast<Extreme>(task % kExtremes);
    Extremes source(extreme, kFirstSeed + task / kExtremes);
    for (std::uint64_t i = 0; i < casesPerSeed; ++i)
    {
      const Quadruple q = source.draw();
      if (!examiner.examine(q, source))
      {
        ADD_FAILURE() << examiner.what() << " is wrong: " << nameOf(extreme) << ", number " << i
                      << ": " << hexText(q[0]) << ", " << hexText(q[1]) << ", " << hexText(q[2])
                      << ", " << hexText(q[3]);
        break;
      }
    }
  }
  for (std::size_t event = 0; event < Events; ++event)
  {
    EXPECT_GT(examiner.count(event), 0u) << kEvents[event];
  }
}

TEST(PredicatesDistances, TensOfThousandsOfCases)
{
  examineAll(1, kQuick);
}

TEST(LongPredicatesDistances, AMillionCases)
{
  examineAll(100, 1000);
}

TEST(PredicatesDistances, RoundingIsSixteenUnitsInTheLastPlace)
{
  constexpr double kLargest = std::numeric_limits<double>::max();
  for (const double size : { 1.0, 1.5, 3.0, 0x1p-1022, 0x1.8p-1022, 1e300 })
  {
    const double units = (std::nextafter(size, HUGE_VAL) - size) * 16.0;
    EXPECT_EQ(roundingAt({ { -size, 0 }, { size / 2, 0 } }, { 0, size / 4 }), units);
    EXPECT_EQ(roundingAt({ { 0, 0 }, { 0, 0 } }, { 0, -size }), units);
  }
  EXPECT_EQ(roundingAt(kLargest), 16.0 * (kLargest - std::nextafter(kLargest, 0.0)));
  EXPECT_EQ(roundingAt(0.0), 16.0 * 0x1p-1074);
  EXPECT_EQ(roundingAt(0x1p-1074), 16.0 * 0x1p-1074);
}

/// Ordinary places near a rim are decided without integers.
TEST(PredicatesDistances, TheFilterDecidesNearARim)
{
  const Segment s{ { 0.1, 0.3 }, { 7.7, 2.9 } };
  const Point place{ 0.1 + 0.37 * (7.7 - 0.1), 0.3 + 0.37 * (2.9 - 0.3) };
  EXPECT_TRUE(stages::withinByFilter(s, roundingAt(s, place), place).value_or(false));
  EXPECT_FALSE(stages::withinByFilter(s, roundingAt(s, place), { 3.0, 3.0 }).value_or(true));
}

} // namespace
} // namespace ahd::test
