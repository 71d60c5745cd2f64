// SPDX-License-Identifier: BSD-3-Clause
//
// The predicates for final triangles of a block (Predicates/Discs.h), against rational arithmetic
// over the whole range of double: boxes that circles touch, exactly and by a unit in the last
// place, boxes on both sides of the filter's border, segments that touch triangles.
#include "PredicatesExtremes.h"
#include "PredicatesFastOracle.h"

#include "ExactSigns.h"
#include "ExactVectors.h"

#include "Predicates/Discs.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <optional>
#include <string>

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
  Meets,
  Misses,
  MeetsByFilter,
  MissesByFilter,
  JustTouches,
  CentreInside,
  CentreBeside,
  CentreAtCorner,
  AtBorder,
  Within,
  WithinHalfPlane,
  SegmentTouches,
  SegmentMisses,
  SegmentIsPoint,
  Events
};

const char* const kEvents[] = { "disc: meets", "disc: misses", "disc: meets by filter",
  "disc: misses by filter", "disc: just touches", "centre: inside", "centre: beside",
  "centre: at a corner", "disc: at the border of the filter", "disc: within",
  "disc: within a half-plane", "segment: touches", "segment: misses", "segment: a point" };

Bounds boxAround(const Point& p, const Point& q)
{
  return { std::min(p.x, q.x), std::max(p.x, q.x), std::min(p.y, q.y), std::max(p.y, q.y) };
}

class DiscExaminer : public Verdict
{
public:
  bool examine(Quadruple q, const Quadruple& more, Extremes& source)
  {
    const int turn = oracle_.orient(q[0], q[1], q[2]);
    if (turn == 0)
    {
      return true;
    }
    if (turn < 0)
    {
      std::swap(q[0], q[1]);
    }
    const Corners triangle{ q[0], q[1], q[2] };
    const Point& other = source.below(2) == 0 ? q[3] : more[3];
    const Bounds box = boxAround(q[3], more[0]), anywhere = boxAround(other, more[1]);
    return disc(triangle, box) && disc(triangle, anywhere) &&
      disc(triangle, boxAround(q[3], q[3])) && atBorder(triangle, box, source) &&
      within(triangle, anywhere) && within(triangle, halfPlane(triangle, more[2], source)) &&
      segment(triangle, q[3], more[0]) && segment(triangle, other, more[1]) &&
      segment(triangle, q[3], q[source.below(3)]) && segment(triangle, other, other);
  }
  std::uint64_t count(std::size_t event) const { return counts_[event]; }

private:
  /// The centre and the squared radius.
  struct Circle
  {
    Vector centre;
    mpq_class squared;

    explicit Circle(const Corners& t)
    {
      const Vector u = between(t.a, t.b), v = between(t.a, t.c);
      const mpq_class uu = u.x * u.x + u.y * u.y, vv = v.x * v.x + v.y * v.y;
      const mpq_class divisor = 2 * cross(u, v);
      const Vector off = { (uu * v.y - vv * u.y) / divisor, (vv * u.x - uu * v.x) / divisor };
      squared = off.x * off.x + off.y * off.y;
      centre = { mpq_class(t.a.x) + off.x, mpq_class(t.a.y) + off.y };
    }
  };

  /// How far a coordinate lies outside of an interval.
  static mpq_class outside(const mpq_class& v, double low, double high)
  {
    return v < mpq_class(low) ? mpq_class(mpq_class(low) - v)
      : v > mpq_class(high)   ? mpq_class(v - mpq_class(high))
                              : mpq_class(0);
  }

  bool disc(const Corners& triangle, const Bounds& box)
  {
    const Circle circle(triangle);
    const mpq_class x = outside(circle.centre.x, box.xmin, box.xmax);
    const mpq_class y = outside(circle.centre.y, box.ymin, box.ymax);
    const int gap = sgn(mpq_class(x * x + y * y - circle.squared));
    const bool exact = gap <= 0;
    ++counts_[exact ? Meets : Misses];
    counts_[JustTouches] += gap == 0;
    ++counts_[sgn(x) == 0 && sgn(y) == 0 ? CentreInside
        : sgn(x) == 0 || sgn(y) == 0     ? CentreBeside
                                         : CentreAtCorner];
    const Circumdisc found(triangle);
    const std::optional<bool> filtered = found.meetsByFilter(box);
    counts_[MeetsByFilter] += filtered && *filtered;
    counts_[MissesByFilter] += filtered && !*filtered;
    return expect(!filtered || *filtered == exact, "a disc by filter") &&
      expect(stages::discMeetsUnbounded(triangle, box) == exact, "a disc by integers") &&
      expect(found.meets(box) == exact, "a disc");
  }

  /// The same of a box with a side where the filter begins to be certain.
  bool atBorder(const Corners& triangle, Bounds box, Extremes& source)
  {
    double* const sides[] = { &box.xmin, &box.xmax, &box.ymin, &box.ymax };
    double& side = *sides[source.below(4)];
    const Circumdisc found(triangle);
    if (!found.meetsByFilter(box) &&
      moveToBorder(side, source, [&] { return found.meetsByFilter(box).has_value(); }) &&
      box.xmin <= box.xmax && box.ymin <= box.ymax)
    {
      ++counts_[AtBorder];
      return disc(triangle, box);
    }
    return true;
  }

  /// All of the plane but for one or two sides.
  static Bounds halfPlane(const Corners& triangle, const Point& at, Extremes& source)
  {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Bounds result{ -kInfinity, kInfinity, -kInfinity, kInfinity };
    const std::uint64_t sides = source.below(16);
    result.xmin = sides & 1 ? std::min(at.x, triangle.a.x) : result.xmin;
    result.xmax = sides & 2 ? std::max(at.x, triangle.a.x) : result.xmax;
    result.ymin = sides & 4 ? std::min(at.y, triangle.b.y) : result.ymin;
    result.ymax = sides & 8 ? std::max(at.y, triangle.b.y) : result.ymax;
    return result;
  }

  bool within(const Corners& triangle, const Bounds& box)
  {
    if (!Circumdisc(triangle).isCertainlyWithin(box))
    {
      return true;
    }
    const Circle circle(triangle);
    const auto isBefore = [&](const mpq_class& way)
    { return sgn(way) > 0 && way * way > circle.squared; };
    const auto isFinite = [](double side) { return std::isfinite(side); };
    ++counts_[isFinite(box.xmin) && isFinite(box.xmax) && isFinite(box.ymin) && isFinite(box.ymax)
        ? Within
        : WithinHalfPlane];
    const Vector& c = circle.centre;
    return expect((!isFinite(box.xmin) || isBefore(c.x - mpq_class(box.xmin))) &&
        (!isFinite(box.xmax) || isBefore(mpq_class(box.xmax) - c.x)) &&
        (!isFinite(box.ymin) || isBefore(c.y - mpq_class(box.ymin))) &&
        (!isFinite(box.ymax) || isBefore(mpq_class(box.ymax) - c.y)),
      "a disc within");
  }

  /// Has an edge a point of the segment, or has the triangle an end of it?
  bool touchesByDefinition(const Corners& t, const Point& p, const Point& q)
  {
    const auto side = [&](const Point& from, const Point& to, const Point& at)
    { return oracle_.orient(from, to, at); };
    const auto isBetween = [](const Point& low, const Point& high, const Point& at)
    {
      return std::min(low.x, high.x) <= at.x && at.x <= std::max(low.x, high.x) &&
        std::min(low.y, high.y) <= at.y && at.y <= std::max(low.y, high.y);
    };
    const auto meet = [&](const Point& from, const Point& to)
    {
      const int ofP = side(from, to, p), ofQ = side(from, to, q);
      const int ofFrom = side(p, q, from), ofTo = side(p, q, to);
      return (ofP * ofQ < 0 && ofFrom * ofTo < 0) || (ofP == 0 && isBetween(from, to, p)) ||
        (ofQ == 0 && isBetween(from, to, q)) || (ofFrom == 0 && isBetween(p, q, from)) ||
        (ofTo == 0 && isBetween(p, q, to));
    };
    const bool isInside = side(t.a, t.b, p) >= 0 && side(t.b, t.c, p) >= 0 &&
      side(t.c, t.a, p) >= 0;
    return isInside || meet(t.a, t.b) || meet(t.b, t.c) || meet(t.c, t.a);
  }

  bool segment(const Corners& triangle, const Point& p, const Point& q)
  {
    const bool exact = touchesByDefinition(triangle, p, q);
    ++counts_[exact ? SegmentTouches : SegmentMisses];
    counts_[SegmentIsPoint] += p == q;
    return expect(touches(triangle, p, q) == exact, "touches") &&
      expect(touches(triangle, q, p) == exact, "touches, exchanged");
  }

  FastOracle oracle_;
  std::uint64_t counts_[Events] = {};
};

void examineAll(std::uint64_t seeds, std::uint64_t casesPerSeed, DiscExaminer& examiner)
{
  for (std::uint64_t task = 0; task < seeds * kExtremes; ++task)
  {
    const auto extreme = static_cast<Extreme>(task % kExtremes);
    const std::uint64_t seed = kFirstSeed + task / kExtremes;
    Extremes source(extreme, seed);
    for (std::uint64_t i = 0; i < casesPerSeed; ++i)
    {
      const Quadruple q = source.draw();
      const Quadruple more = source.draw();
      if (!examiner.examine(q, more, source))
      {
        ADD_FAILURE() << examiner.what() << " is wrong: " << nameOf(extreme) << ", seed " << seed
                      << ", number " << i << ": " << hexText(q[0]) << ", " << hexText(q[1]) << ", "
                      << hexText(q[2]) << ", " << hexText(q[3]) << "; " << hexText(more[0]) << ", "
                      << hexText(more[1]);
        return;
      }
    }
  }
}

TEST(PredicatesDiscs, EachIsTheExactAnswerOverTheWholeRangeOfDouble)
{
  DiscExaminer examiner;
  examineAll(1, kQuick, examiner);
  for (std::size_t event = 0; event < Events; ++event)
  {
    EXPECT_GT(examiner.count(event), 0u) << kEvents[event];
  }
}

TEST(LongPredicatesDiscs, EachIsTheExactAnswerOverTheWholeRangeOfDouble)
{
  DiscExaminer examiner;
  examineAll(10, 4 * kQuick, examiner);
  for (std::size_t event = 0; event < Events; ++event)
  {
    std::printf(
      "%-40s %10llu\n", kEvents[event], static_cast<unsigned long long>(examiner.count(event)));
  }
}

/// A filter that leaves everything open would be correct, too.
TEST(PredicatesDiscs, TheFilterDecidesWhatIsNotClose)
{
  std::size_t open = 0;
  Cases cases(Family::Uniform);
  for (int i = 0; i < 1000; ++i)
  {
    Quadruple q = cases.draw();
    if (orientSign(q[0], q[1], q[2]) < 0)
    {
      std::swap(q[0], q[1]);
    }
    for (const int exponent : { -1000, -300, 0, 300, 1000 })
    {
      const auto at = [&](const Point& p) {
        return Point{ std::ldexp(p.x, exponent), std::ldexp(p.y, exponent) };
      };
      const Corners triangle{ at(q[0]), at(q[1]), at(q[2]) };
      open += Circumdisc(triangle).meetsByFilter(boxAround(at(q[3]), at(q[3]))) ? 0 : 1;
    }
  }
  EXPECT_LT(open, 20u);
}

} // namespace
} // namespace ahd::test
