// SPDX-License-Identifier: BSD-3-Clause
//
// What the corners of Voronoi cells are computed with (Voronoi/Circumcentre.h, Voronoi/ClipBox.h)
// and how near is near when points are merged (Merge.h), against rational arithmetic over the whole
// range of double. The former promise some 100 bits, not exactness: asserted is an error of no more
// than that, 2^-95, and one rounding.
#include "PredicatesExtremes.h"
#include "PredicatesFastOracle.h"

#include "ExactSigns.h"
#include "ExactVectors.h"

#include "Merge/Merge.h"
#include "Voronoi/Circumcentre.h"
#include "Voronoi/ClipBox.h"

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
  CentreNotTold,
  SideLeft,
  SideRight,
  SideOn,
  SideNotTold,
  BisectorInside,
  BisectorFrom,
  BisectorTo,
  BisectorParallel,
  BisectorNotTold,
  LeaveInX,
  LeaveInY,
  LeaveCorner,
  Near,
  JustNear,
  Far,
  JustFar,
  NearAtInfinity,
  Events
};

const char* const kEvents[] = { "circumcentre: finite", "circumcentre: beyond the largest double",
  "circumcentre: of quarters", "circumcentre: not told by 100 bits", "side: left", "side: right",
  "side: on the line", "side: not told by 100 bits", "bisector: meets the segment",
  "bisector: nearer to its begin", "bisector: nearer to its end", "bisector: parallel",
  "bisector: not told by 100 bits", "box: left across x", "box: left across y",
  "box: left by a corner", "merge: near", "merge: near by a hair", "merge: far",
  "merge: far by a hair", "merge: any distance" };

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

const mpq_class kBits = powerOfTwo(-95);
const mpq_class kUnit = powerOfTwo(-53);
const mpq_class kSmallest = powerOfTwo(-1073);

/// The circumcentre as offset from corner a, and the size of what it is computed from.
struct ExactCentre
{
  Vector u, v, offset; ///< the offset times the divisor
  mpq_class divisor, size, divisorSize;

  explicit ExactCentre(const Corners& t)
    : u(between(t.a, t.b))
    , v(between(t.a, t.c))
  {
    const mpq_class uu = dot(u, u), vv = dot(v, v);
    offset = { uu * v.y - vv * u.y, vv * u.x - uu * v.x };
    divisor = 2 * cross(u, v);
    size = uu * normOf(v) + vv * normOf(u);
    divisorSize = 2 * normOf(u) * normOf(v);
  }

  /// Are the sides so different in length that their products underflow?
  bool isNeedle() const
  {
    const mpq_class a = normOf(u), b = normOf(v);
    return std::min(a, b) < std::max(a, b) * powerOfTwo(-250);
  }
  bool isTold() const { return !isNeedle() && abs(divisor) > divisorSize * powerOfTwo(-90); }
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
      (q[0] == q[1] || !isSegment || bisector(q[0], q[1], q[2], q[3])) && leave(q) &&
      merge(q[0], q[1], source);
  }
  std::uint64_t count(std::size_t event) const { return counts_[event]; }

private:
  bool isWithin(
    const Point& found, const Vector& exact, const mpq_class& slackX, const mpq_class& slackY) const
  {
    return isFinite(found) &&
      abs(mpq_class(found.x) - exact.x) <= slackX + abs(exact.x) * kUnit + kSmallest &&
      abs(mpq_class(found.y) - exact.y) <= slackY + abs(exact.y) * kUnit + kSmallest;
  }

  bool centre(const Corners& triangle)
  {
    const Point found = circumcentre(triangle);
    const ExactCentre e(triangle);
    if (!e.isTold())
    {
      ++counts_[CentreNotTold];
      return true;
    }
    const Vector way = { e.offset.x / e.divisor, e.offset.y / e.divisor };
    const Vector exact = { mpq_class(triangle.a.x) + way.x, mpq_class(triangle.a.y) + way.y };
    const mpq_class most = std::max(std::max(mpq_class(abs(way.x)), mpq_class(abs(way.y))),
      std::max(mpq_class(abs(exact.x)), mpq_class(abs(exact.y))));
    if (most * (1 + 4 * kUnit) > kLargest)
    {
      ++counts_[CentreOutOfRange];
      return true;
    }
    ++counts_[CentreFinite];
    counts_[CentreOfHuge] += std::max(normOf(e.u), normOf(e.v)) > powerOfTwo(1010);
    const mpq_class slack = kBits *
        (e.size + std::max(mpq_class(abs(way.x)), mpq_class(abs(way.y))) * e.divisorSize) /
        abs(e.divisor) +
      powerOfTwo(-900) * std::max(normOf(e.u), normOf(e.v));
    return expect(isWithin(found, exact, slack, slack), "circumcentre " + hexText(found));
  }

  bool side(const Corners& triangle, const Point& from, const Point& to)
  {
    const ExactCentre e(triangle);
    const Vector along = between(from, to), corner = between(from, triangle.a);
    const mpq_class exact = cross(along, corner) * e.divisor + cross(along, e.offset);
    const mpq_class size = normOf(along) * (normOf(corner) * e.divisorSize + e.size);
    const mpq_class largest = std::max(
      std::max(normOf(along), normOf(corner)), std::max(normOf(e.u), normOf(e.v)));
    const bool underflows = size < powerOfTwo(-500) * largest * largest * largest * largest;
    const int found = sideOfCircumcentre(triangle, from, to);
    if (underflows || (sgn(exact) != 0 && abs(exact) <= size * kBits))
    {
      ++counts_[SideNotTold];
      return true;
    }
    if (sgn(exact) == 0)
    {
      counts_[SideOn] += found == 0; // of another sign if products are not exact
      return true;
    }
    ++counts_[sgn(exact) > 0 ? SideLeft : SideRight];
    return expect(found == sgn(exact), "sideOfCircumcentre");
  }

  bool bisector(const Point& p, const Point& q, const Point& from, const Point& to)
  {
    const Vector along = between(from, to), apart = between(p, q);
    const Vector toP = between(from, p), toQ = between(from, q);
    const Point found = bisectorOnSegment(p, q, from, to);
    const mpq_class steep = 2 * dot(along, apart);
    const mpq_class steepSize = 2 * normOf(along) * normOf(apart);
    const mpq_class largest = std::max(
      std::max(normOf(along), normOf(apart)), std::max(normOf(toP), normOf(toQ)));
    if (!expect(isBetween(found, from, to), "bisectorOnSegment leaves the segment"))
    {
      return false;
    }
    if (steepSize < powerOfTwo(-250) * largest * largest ||
      abs(steep) <= steepSize * powerOfTwo(-90))
    {
      ++counts_[sgn(steep) == 0 ? BisectorParallel : BisectorNotTold];
      return true;
    }
    const mpq_class size = (normOf(toP) + normOf(toQ)) * normOf(apart);
    mpq_class part = dot({ toP.x + toQ.x, toP.y + toQ.y }, apart) / steep;
    const mpq_class slack = kBits * (size + abs(part) * steepSize) / abs(steep);
    const mpq_class lost = powerOfTwo(-900) * largest; // by underflow of what is scaled
    part = part < 0 ? mpq_class(0) : part > 1 ? mpq_class(1) : part;
    ++counts_[part <= 0 ? BisectorFrom : part >= 1 ? BisectorTo : BisectorInside];
    const Vector exact = { mpq_class(from.x) + part * along.x, mpq_class(from.y) + part * along.y };
    return expect(isWithin(found, exact, slack * abs(along.x) + lost, slack * abs(along.y) + lost),
      "bisectorOnSegment " + hexText(found));
  }

  static bool isBetween(const Point& p, const Point& a, const Point& b)
  {
    return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
      p.y <= std::max(a.y, b.y);
  }

  /// Is the quotient of both, if they are not 0, so large that it has no reciprocal?
  static bool isBelowDoubles(const mpq_class& a, const mpq_class& b)
  {
    const mpq_class x = abs(a), y = abs(b);
    return sgn(x) * sgn(y) != 0 && std::min(x, y) < std::max(x, y) * powerOfTwo(-1000);
  }

  /// Has half of it no bits left?
  static bool isTiny(const mpq_class& distance)
  {
    return sgn(distance) != 0 && abs(distance) < powerOfTwo(-1000);
  }

  /// From the middle of two points, out of the box around four. Distances are halved on the way, so
  /// that the last bit of subnormal ones is lost.
  bool leave(const Quadruple& q)
  {
    Bounds bounds{ q[0].x, q[0].x, q[0].y, q[0].y };
    for (const Point& p : q)
    {
      bounds = { std::min(bounds.xmin, p.x), std::max(bounds.xmax, p.x), std::min(bounds.ymin, p.y),
        std::max(bounds.ymax, p.y) };
    }
    const ClipBox box(bounds);
    if (!box.hasArea() || q[0] == q[1])
    {
      return true;
    }
    const Point p{ 0.5 * q[0].x + 0.5 * q[1].x, 0.5 * q[0].y + 0.5 * q[1].y };
    const Point found = box.leave(p, q[0], q[1]);
    const Vector apart = between(q[0], q[1]), ahead = { -apart.y, apart.x };
    const mpq_class farX = mpq_class(sgn(ahead.x) > 0 ? bounds.xmax : bounds.xmin) - mpq_class(p.x);
    const mpq_class farY = mpq_class(sgn(ahead.y) > 0 ? bounds.ymax : bounds.ymin) - mpq_class(p.y);
    const bool byX = sgn(ahead.x) != 0 && (sgn(ahead.y) == 0 || farX / ahead.x <= farY / ahead.y);
    const mpq_class part = byX ? mpq_class(farX / ahead.x) : mpq_class(farY / ahead.y);
    const Vector way = { part * ahead.x, part * ahead.y };
    const Vector exact = { mpq_class(p.x) + way.x, mpq_class(p.y) + way.y };
    bool isOnBorder = false;
    for (unsigned side = 0; side < 4; ++side)
    {
      isOnBorder = isOnBorder || box.isOnSide(found, side);
    }
    const bool isCorner = (found.x == bounds.xmin || found.x == bounds.xmax) &&
      (found.y == bounds.ymin || found.y == bounds.ymax);
    ++counts_[isCorner ? LeaveCorner : byX ? LeaveInX : LeaveInY];
    const mpq_class tiny = (abs(way.x) + abs(way.y)) * powerOfTwo(-900);
    if (isBelowDoubles(ahead.x, ahead.y) || isTiny(farX) || isTiny(farY))
    {
      return expect(isOnBorder && box.contains(found), "Box::leave is not on the border");
    }
    return expect(isOnBorder && box.contains(found), "Box::leave is not on the border") &&
      expect(isWithin(found, exact, 16 * kUnit * abs(way.x) + tiny, 16 * kUnit * abs(way.y) + tiny),
        "Box::leave " + hexText(found));
  }

  /// `exact` rounded to the nearest double, ties to even; infinite as rounding has it.
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

/// Points nearer to each other than the box is wide by more than a double tells.
TEST(PredicatesVoronoi, ABoxIsLeftAtRightAnglesToTheShortestWay)
{
  const ClipBox box(Bounds{ -1, 1, -1, 1 });
  for (const double apart : { 0x1p-1074, 0x1p-1073, 1e-310, 1e-308 })
  {
    const Point p{ 0, 0 };
    EXPECT_TRUE((box.leave(p, { 0, 0 }, { 0, apart }) == Point{ -1, p.y })) << apart;
    EXPECT_TRUE((box.leave(p, { 0, apart }, { 0, 0 }) == Point{ 1, p.y })) << apart;
  }
}

/// A way longer than the largest double, and an end that is near but not met.
TEST(PredicatesVoronoi, BisectorsOfSegmentsOfAnyLength)
{
  const Point left{ -kLargest, 0 }, right{ kLargest, 0 };
  const double there = 0.75 * kLargest;
  EXPECT_TRUE((bisectorOnSegment({ there, 1 }, { there, -1 }, left, right) == Point{ 0, 0 }));
  const Point met = bisectorOnSegment({ 0.5 * kLargest, 1 }, { kLargest, 1 }, left, right);
  EXPECT_TRUE((met == Point{ there, 0 })) << hexText(met);
  const Point near = bisectorOnSegment({ 0, 0 }, { -0x1p-79, 0 }, { -1, 0 }, { 0, 0 });
  EXPECT_TRUE((near == Point{ -0x1p-80, 0 })) << hexText(near);
  const Point begin{ -0x1p+1022, 0x1p+256 }, end{ -0x3p-1074, 0x1p-256 };
  const Point last = bisectorOnSegment(
    { -0x1p+511, -0x1.fffffffffffffp+254 }, { 0x1p-269, -0x1p-512 }, begin, end);
  EXPECT_TRUE(last.x <= end.x && last.y >= end.y) << hexText(last) << ", beyond the end";
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
