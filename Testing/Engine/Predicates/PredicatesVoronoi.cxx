// SPDX-License-Identifier: BSD-3-Clause
//
// The arithmetic of Voronoi cells (Predicates/Circles.h, Voronoi/Circumcentre.h,
// Voronoi/ConvexPolygon.h)
// and the distances of merging (Merge.h), against rational arithmetic over the whole range of
// double.
#include "PredicatesExtremes.h"
#include "PredicatesFastOracle.h"

#include "ExactSigns.h"
#include "ExactVectors.h"

#include "Merge/Merge.h"
#include "Voronoi/Circumcentre.h"
#include "Voronoi/ConvexPolygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace ahd::test
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();

#ifdef AHD_REDUCED_TESTS
constexpr std::uint64_t kQuick = 300;
#else
constexpr std::uint64_t kQuick = 1500;
#endif

enum Event
{
  CentreFinite,
  CentreOutOfRange,
  CentreOfHuge,
  SideLeft,
  SideRight,
  SideOn,
  SideByFilter,
  NearerFirst,
  NearerSecond,
  NearerNone,
  NearerByFilter,
  AngleAcute,
  AngleRight,
  AngleObtuse,
  AngleByFilter,
  BisectorFinite,
  BisectorOutOfRange,
  BisectorParallel,
  ExitSide,
  ExitCorner,
  Near,
  JustNear,
  Far,
  JustFar,
  NearAtInfinity,
  Events
};

const char* const kEvents[] = { "circumcentre: finite", "circumcentre: beyond the largest double",
  "circumcentre: of quarters", "side: left", "side: right", "side: on the line",
  "side: told by the filter", "nearer: the first", "nearer: the second", "nearer: none",
  "nearer: told by the filter", "angle: acute", "angle: right", "angle: obtuse",
  "angle: told by the filter", "bisector: finite", "bisector: beyond the largest double",
  "bisector: parallel", "box: left by a side", "box: left by a corner", "merge: near",
  "merge: near by a hair", "merge: far", "merge: far by a hair", "merge: any distance" };

mpq_class normOf(const Vector& v)
{
  return abs(v.x) + abs(v.y);
}

mpq_class dot(const Vector& a, const Vector& b)
{
  return a.x * b.x + a.y * b.y;
}

mpq_class powerOfTwo(int exponent)
{
  mpq_class one = 1;
  return exponent < 0 ? mpq_class(one >> (unsigned long)(-exponent))
                      : mpq_class(one << (unsigned long)(exponent));
}

/// The circumcentre as offset from corner a, and the size of its operands.
struct ExactCentre
{
  Vector u, v, offset; ///< the offset times the divisor
  mpq_class divisor;

  explicit ExactCentre(const Corners& t)
    : u(between(t.a, t.b))
    , v(between(t.a, t.c))
  {
    const mpq_class uu = dot(u, u), vv = dot(v, v);
    offset = { uu * v.y - vv * u.y, vv * u.x - uu * v.x };
    divisor = 2 * cross(u, v);
  }
};

class VoronoiExaminer : public Verdict
{
public:
  bool examine(Quadruple q, Extremes& source)
  {
    const int turn = oracle_.orient(q[0], q[1], q[2]);
    if (turn < 0)
    {
      std::swap(q[0], q[1]);
    }
    const Corners triangle{ q[0], q[1], q[2] };
    const bool isTriangle = turn != 0;
    const bool isSegment = !(q[2] == q[3]);
    return (!isTriangle || centre(triangle)) &&
      (!isTriangle || !isSegment || side(triangle, q[2], q[3])) &&
      (q[0] == q[1] || !isSegment || bisector(q[0], q[1], { q[2], q[3] })) &&
      nearer(q[0], q[1], q[2]) && angle(q[0], q[1], q[2]) && exit(q) && merge(q[0], q[1], source);
  }
  std::uint64_t count(std::size_t event) const { return counts_[event]; }

private:
  /// Is it no more than 0.501 units in the last place away, and on no other side of a double?
  static bool isRoundedOnce(double found, const mpq_class& exact)
  {
    const double nearest = rounded(exact);
    if (found == nearest)
    {
      return true;
    }
    if (!std::isfinite(nearest) || !std::isfinite(found)) // where the range ends, and a hair beyond
    {
      const mpq_class end = mpq_class(kLargest) + powerOfTwo(970);
      return found == std::copysign(kLargest, sgn(exact)) && abs(exact) <= end + powerOfTwo(960);
    }
    const mpq_class off = abs(mpq_class(found) - exact), least = abs(mpq_class(nearest) - exact);
    return off * 1000 <= least * 1005;
  }

  static bool areRoundedOnce(const Point& found, const Vector& exact)
  {
    return isRoundedOnce(found.x, exact.x) && isRoundedOnce(found.y, exact.y);
  }

  bool centre(const Corners& triangle)
  {
    const Point found = circumcentre(triangle);
    const ExactCentre e(triangle);
    const Vector exact = { mpq_class(triangle.a.x) + e.offset.x / e.divisor,
      mpq_class(triangle.a.y) + e.offset.y / e.divisor };
    ++counts_[isFinite(found) ? CentreFinite : CentreOutOfRange];
    counts_[CentreOfHuge] += std::max(normOf(e.u), normOf(e.v)) > powerOfTwo(1010);
    const Point always = stages::circumcentreUnbounded(triangle);
    return expect(areRoundedOnce(found, exact), "circumcentre " + hexText(found)) &&
      expect(always.x == rounded(exact.x) && always.y == rounded(exact.y),
        "circumcentreUnbounded " + hexText(always));
  }

  /// Of a sign by filter, always, and as it is used.
  bool sign(std::optional<int> filtered, int always, int found, int exact, Event byFilter)
  {
    counts_[byFilter] += filtered.has_value();
    return expect(found == exact, "a sign") && expect(always == exact, "a sign by integers") &&
      expect(!filtered || *filtered == exact, "a sign by filter");
  }

  bool side(const Corners& triangle, const Point& from, const Point& to)
  {
    const ExactCentre e(triangle);
    const Vector along = between(from, to), corner = between(from, triangle.a);
    const int exact = sgn(mpq_class(cross(along, corner) * e.divisor + cross(along, e.offset)));
    ++counts_[exact == 0 ? SideOn : exact > 0 ? SideLeft : SideRight];
    return sign(stages::sideByFilter(triangle, from, to), stages::sideUnbounded(triangle, from, to),
      sideOfCircumcentre(triangle, from, to), exact, SideByFilter);
  }

  bool nearer(const Point& p, const Point& q, const Point& place)
  {
    const Vector toP = between(place, p), toQ = between(place, q);
    const int exact = sgn(mpq_class(dot(toQ, toQ) - dot(toP, toP)));
    ++counts_[exact == 0 ? NearerNone : exact > 0 ? NearerFirst : NearerSecond];
    return sign(stages::nearerByFilter(p, q, place), stages::nearerUnbounded(p, q, place),
      nearerOf(p, q, place), exact, NearerByFilter);
  }

  bool angle(const Point& p, const Point& r, const Point& q)
  {
    const int exact = sgn(dot(between(r, p), between(r, q)));
    ++counts_[exact == 0 ? AngleRight : exact > 0 ? AngleAcute : AngleObtuse];
    return sign(stages::acutenessByFilter(p, r, q), stages::acutenessUnbounded(p, r, q),
      acuteness(p, r, q), exact, AngleByFilter);
  }

  bool bisector(const Point& p, const Point& q, const Line& line)
  {
    const Vector along = between(line.from, line.to), apart = between(p, q);
    const Vector toP = between(line.from, p), toQ = between(line.from, q);
    const mpq_class steep = 2 * dot(along, apart);
    if (sgn(steep) == 0)
    {
      ++counts_[BisectorParallel];
      return true;
    }
    const Point found = bisectorOnLine(p, q, line);
    const mpq_class part = dot({ toP.x + toQ.x, toP.y + toQ.y }, apart) / steep;
    const Vector exact = { mpq_class(line.from.x) + part * along.x,
      mpq_class(line.from.y) + part * along.y };
    ++counts_[isFinite(found) ? BisectorFinite : BisectorOutOfRange];
    const Point always = stages::bisectorUnbounded(p, q, line);
    return expect(areRoundedOnce(found, exact), "bisectorOnLine " + hexText(found)) &&
      expect(always.x == rounded(exact.x) && always.y == rounded(exact.y),
        "bisectorUnbounded " + hexText(always));
  }

  /// Out of the box around four points: between a corner that is no nearer to the first and one
  /// that is.
  bool exit(const Quadruple& q)
  {
    Bounds bounds{ q[0].x, q[0].x, q[0].y, q[0].y };
    for (const Point& p : q)
    {
      bounds = { std::min(bounds.xmin, p.x), std::max(bounds.xmax, p.x), std::min(bounds.ymin, p.y),
        std::max(bounds.ymax, p.y) };
    }
    const ConvexPolygon box({ { bounds.xmin, bounds.ymin }, { bounds.xmax, bounds.ymax } });
    if (box.fault() != PolygonFault::None || q[0] == q[1])
    {
      return true;
    }
    ConvexPolygon::Crossing crossing;
    if (!expect(box.isCrossed(q[0], q[1], crossing), "a box is left"))
    {
      return false;
    }
    const std::uint32_t at = crossing.exit;
    const auto side = [&](std::uint32_t k)
    {
      const Vector toP = between(box.corner(k), q[0]), toQ = between(box.corner(k), q[1]);
      return sgn(mpq_class(dot(toQ, toQ) - dot(toP, toP)));
    };
    const bool isCorner = at % 2 == 0;
    ++counts_[isCorner ? ExitCorner : ExitSide];
    return expect(isCorner ? side(at / 2) == 0 : side(at / 2) < 0, "where a box is left") &&
      expect(side(at / 2 + 1) > 0, "what comes after where a box is left");
  }

  /// `exact` rounded to the nearest double, ties to even; infinite if it rounds to that.
  static double rounded(const mpq_class& exact)
  {
    const mpq_class magnitude = abs(exact);
    if (magnitude >= mpq_class(kLargest) + powerOfTwo(970))
    {
      return sgn(exact) < 0 ? -kInfinity : kInfinity;
    }
    const double below = std::fabs(exact.get_d()); // towards zero
    const double above = std::nextafter(below, kInfinity);
    if (above == kInfinity)
    {
      return std::copysign(below, sgn(exact));
    }
    const int nearer = cmp(
      mpq_class(mpq_class(below) + mpq_class(above)), mpq_class(2 * magnitude));
    std::int64_t bits = FastOracle::key(below);
    const double result = nearer < 0 || (nearer == 0 && bits % 2 != 0) ? above : below;
    return std::copysign(result, sgn(exact));
  }

  static double squared(double value, const mpq_class& scale)
  {
    if (!std::isfinite(value))
    {
      return kInfinity;
    }
    const double scaled = rounded(mpq_class(value) * scale);
    return std::isfinite(scaled) ? rounded(mpq_class(scaled) * mpq_class(scaled)) : kInfinity;
  }

  /// Merge.h, operation by operation.
  static bool isNear(const Point& a, const Point& b, double distance, double& most, double& length)
  {
    const mpq_class scale = distance == kInfinity
      ? mpq_class(1)
      : powerOfTwo(std::min(-std::ilogb(distance), 1023));
    most = squared(distance, scale);
    const double x = squared(rounded(mpq_class(a.x) - mpq_class(b.x)), scale);
    const double y = squared(rounded(mpq_class(a.y) - mpq_class(b.y)), scale);
    length = std::isfinite(x) && std::isfinite(y) ? rounded(mpq_class(x) + mpq_class(y))
                                                  : kInfinity;
    return length <= most;
  }

  bool merge(const Point& a, const Point& b, Extremes& source)
  {
    double distance = std::hypot(0.5 * a.x - 0.5 * b.x, 0.5 * a.y - 0.5 * b.y);
    distance = std::isfinite(2.0 * distance) ? 2.0 * distance : kLargest;
    const std::uint64_t how = source.below(8);
    distance = how == 0 ? kInfinity
      : how == 1        ? std::fabs(a.x)
                        : std::fabs(ulpsFrom(distance, source.whole(-2, 2)));
    if (a == b || !(distance > 0.0))
    {
      return true;
    }
    double most = 0.0, length = 0.0;
    const bool expected = isNear(a, b, distance, most, length);
    const bool isClose = std::isfinite(length) && std::fabs(length - most) <= most * 0x1p-51;
    ++counts_[expected ? Near : Far];
    counts_[JustNear] += expected && isClose;
    counts_[JustFar] += !expected && isClose;
    counts_[NearAtInfinity] += distance == kInfinity;
    const double xy[] = { a.x, a.y, b.x, b.y };
    MergedPoints merged;
    const bool isOk = mergeWithin(PointView(xy, 2, 2), distance, nullptr, merged) == Status::Ok;
    const Index kept = FastOracle::less(a, b) ? 0 : 1;
    char text[40];
    std::snprintf(text, sizeof text, "mergeWithin %a", distance);
    return expect(isOk && merged.pairs.size() == (expected ? 1u : 0u) &&
        (!expected || (merged.pairs[0].keptId == kept && merged.pairs[0].id == 1 - kept)),
      text);
  }

  FastOracle oracle_;
  std::uint64_t counts_[Events] = {};
};

void examineAll(std::uint64_t seeds, std::uint64_t casesPerSeed, VoronoiExaminer& examiner)
{
  for (std::uint64_t task = 0; task < seeds * kExtremes; ++task)
  {
    const auto extreme = static_cast<Extreme>(task % kExtremes);
    const std::uint64_t seed = kFirstSeed + task / kExtremes;
    Extremes source(extreme, seed);
    for (std::uint64_t i = 0; i < casesPerSeed; ++i)
    {
      const Quadruple q = source.draw();
      if (!examiner.examine(q, source))
      {
        ADD_FAILURE() << examiner.what() << " is wrong: " << nameOf(extreme) << ", seed " << seed
                      << ", number " << i << ": " << hexText(q[0]) << ", " << hexText(q[1]) << ", "
                      << hexText(q[2]) << ", " << hexText(q[3]);
        break;
      }
    }
  }
  for (std::size_t event = 0; event < Events; ++event)
  {
    EXPECT_GT(examiner.count(event), 0u) << kEvents[event];
  }
}

TEST(PredicatesVoronoi, TensOfThousandsOfCases)
{
  VoronoiExaminer examiner;
  examineAll(1, kQuick, examiner);
}

/// A way longer than the largest double, and one that is left out by all but a few bits.
TEST(PredicatesVoronoi, BisectorsOfLinesOfAnyLength)
{
  const Line widest{ { -kLargest, 0 }, { kLargest, 0 } };
  const double there = 0.75 * kLargest;
  EXPECT_TRUE((bisectorOnLine({ there, 1 }, { there, -1 }, { { there, -9 }, { there, 9 } }) ==
    Point{ there, 0 }));
  const Point met = bisectorOnLine({ 0.5 * kLargest, 1 }, { kLargest, 1 }, widest);
  EXPECT_TRUE((met == Point{ there, 0 })) << hexText(met);
  const Point near = bisectorOnLine({ 0, 0 }, { -0x1p-79, 0 }, { { -1, 0 }, { 0, 0 } });
  EXPECT_TRUE((near == Point{ -0x1p-80, 0 })) << hexText(near);
}

TEST(LongPredicatesVoronoi, AMillionCases)
{
  VoronoiExaminer examiner;
  examineAll(100, 1000, examiner);
  for (std::size_t event = 0; event < Events; ++event)
  {
    std::printf(
      "%-40s %10llu\n", kEvents[event], static_cast<unsigned long long>(examiner.count(event)));
  }
}

} // namespace
} // namespace ahd::test
