// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_test_PredicatesSegments_h
#define ahd_test_PredicatesSegments_h

#include "PredicatesExtremes.h"

#include "Predicates/Segments.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

/// Pairs of segments and a point that are hard for the predicates of splitting, and the correct
/// answers, in rational arithmetic.
namespace ahd::test
{

struct SegmentsAndPoint
{
  Segment s;
  Segment t;
  Point p;
};

inline Segment segmentBetween(const Point& a, const Point& b)
{
  return lexicographicallyLess(a, b) ? Segment{ a, b } : Segment{ b, a };
}

/// Draws segments from the families of Extremes, and some of its own: lines that meet exactly above
/// or below p or beside it, each then moved by an ulp.
class SegmentSource
{
public:
  SegmentSource(Extreme extreme, std::uint64_t seed)
    : extremes_(extreme, seed)
  {
  }

  SegmentsAndPoint draw() { return below(3) == 0 ? meeting() : fromQuadruple(); }
  /// Moves p to where `isCertain(case)`, not true of this one, becomes true. Returns false if there
  /// is no such place.
  template <class IsCertain>
  bool moveToBorderOf(SegmentsAndPoint& c, IsCertain isCertain)
  {
    double& coordinate = below(4) == 0 ? c.p.x : c.p.y;
    return moveToBorder(coordinate, extremes_, [&] { return isCertain(c); });
  }

private:
  std::uint64_t below(std::uint64_t n) { return extremes_.below(n); }
  double ofEither(double a, double b) { return below(2) == 0 ? a : b; }

  double near(double value)
  {
    return below(2) == 0 ? value : ulpsFrom(value, extremes_.whole(-3, 3));
  }

  /// Both segments reach from p or before to p or beyond, if p is not moved out.
  SegmentsAndPoint fromQuadruple()
  {
    Quadruple q = extremes_.draw();
    std::sort(q.begin(), q.end(), lexicographicallyLess);
    const bool crossed = below(2) == 0;
    const Segment s = segmentBetween(q[0], crossed ? q[2] : q[3]);
    const Segment t = segmentBetween(q[1], crossed ? q[3] : q[2]);
    Point p = q[1 + below(2)];
    if (below(2) == 0) // on s, rounded
    {
      const double part = double(below(1025)) / 1024.0;
      p.x = s.left.x * (1.0 - part) + s.right.x * part;
      p.y = s.left.y * (1.0 - part) + s.right.y * part;
    }
    else if (below(2) == 0)
    {
      p.y = ofEither(q[below(4)].y, ofEither(0.5 * s.left.y + 0.5 * t.right.y, q[below(4)].y));
    }
    return { s, t, { near(p.x), near(p.y) } };
  }

  /// Lines through one point m, and p above or below it, or at it, in integers of any scale.
  SegmentsAndPoint meeting()
  {
    const int reach = 1 << extremes_.whole(1, 20);
    const auto vector = [&] {
      return Point{ double(extremes_.whole(0, reach)), double(extremes_.whole(-reach, reach)) };
    };
    const Point m = { double(extremes_.whole(-reach, reach)),
      double(extremes_.whole(-reach, reach)) };
    const auto through = [&](const Point& way)
    {
      const double back = extremes_.whole(0, 5), on = extremes_.whole(0, 5);
      return segmentBetween(
        { m.x - back * way.x, m.y - back * way.y }, { m.x + on * way.x, m.y + on * way.y });
    };
    const Point first = vector();
    SegmentsAndPoint result = { through(first), through(below(4) == 0 ? first : vector()),
      { m.x, m.y + double(below(3) == 0 ? 0 : extremes_.whole(-reach, reach)) } };
    const int ex = scale(), ey = below(2) == 0 ? ex : scale();
    double* const coordinates[] = { &result.s.left.x, &result.s.left.y, &result.s.right.x,
      &result.s.right.y, &result.t.left.x, &result.t.left.y, &result.t.right.x, &result.t.right.y,
      &result.p.x, &result.p.y };
    for (std::size_t i = 0; i < 10; ++i)
    {
      *coordinates[i] = std::ldexp(*coordinates[i], i % 2 == 0 ? ex : ey);
    }
    if (below(2) == 0)
    {
      double& moved = *coordinates[below(10)];
      moved = ulpsFrom(moved, below(2) == 0 ? 1 : -1);
    }
    result.s = segmentBetween(result.s.left, result.s.right);
    result.t = segmentBetween(result.t.left, result.t.right);
    return result;
  }

  int scale()
  {
    static const int critical[] = { -1074, -1030, -537, -520, -400, 0, 400, 485, 500, 980 };
    return below(2) == 0 ? extremes_.whole(-1074, 990)
                         : std::max(-1074, critical[below(10)] + extremes_.whole(-12, 12));
  }

  Extremes extremes_;
};

/// A segment and its line, exactly.
struct ExactSegment
{
  mpq_class x, y, dx, dy;

  explicit ExactSegment(const Segment& s)
    : x(s.left.x)
    , y(s.left.y)
    , dx(mpq_class(s.right.x) - x)
    , dy(mpq_class(s.right.y) - y)
  {
  }
};

/// orderAt by definition: the line of p is x = p.x - eps (y - p.y), eps positive and infinitesimal.
/// Where it meets a segment that is not vertical, y is h - eps m (h - p.y), with h the height at
/// p.x and m the slope; a vertical one that reaches p in lexicographic order contains p.
inline int exactOrderAt(const Segment& s, const Segment& t, const Point& p)
{
  const ExactSegment S(s), T(t);
  const mpq_class px(p.x), py(p.y);
  const auto above = [&](const ExactSegment& e)
  { return sgn(e.dx) == 0 ? mpq_class(0) : mpq_class(e.y + e.dy / e.dx * (px - e.x) - py); };
  const mpq_class hs = above(S), ht = above(T);
  if (hs != ht)
  {
    return hs > ht ? 1 : -1;
  }
  if (sgn(hs) == 0)
  {
    return 0;
  }
  return sgn(mpq_class((T.dy / T.dx - S.dy / S.dx) * hs));
}

/// Is a double the nearest one to `exact`, the even one if two are?
inline bool isNearest(double value, const mpq_class& exact, bool& isTie)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  const mpq_class error = abs(mpq_class(value) - exact);
  for (const double other : { std::nextafter(value, -kInfinity), std::nextafter(value, kInfinity) })
  {
    if (std::isfinite(other))
    {
      const int farther = cmp(mpq_class(abs(mpq_class(other) - exact)), error);
      isTie = isTie || farther == 0;
      if (farther < 0 || (farther == 0 && (bits & 1) != 0))
      {
        return false;
      }
    }
  }
  return true;
}

/// The numbers that round to `value`, ends not included.
inline std::pair<mpq_class, mpq_class> whatRoundsTo(double value)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double low = std::nextafter(value, -kInfinity), high = std::nextafter(value, kInfinity);
  const mpq_class v(value);
  const mpq_class down = std::isfinite(low) ? mpq_class(v - mpq_class(low))
                                            : mpq_class(mpq_class(high) - v);
  const mpq_class up = std::isfinite(high) ? mpq_class(mpq_class(high) - v) : down;
  return { v - down / 2, v + up / 2 };
}

/// roundsTo by definition: which part of the segment, from 0 to 1, lies inside.
inline bool exactRoundsTo(const Segment& s, const Point& p)
{
  if (p == s.left || p == s.right)
  {
    return false;
  }
  const ExactSegment S(s);
  mpq_class first = -1, last = 2; // it lies inside between these, which do not count
  const auto clip = [&](const mpq_class& from, const mpq_class& way, double value)
  {
    const auto [low, high] = whatRoundsTo(value);
    if (sgn(way) == 0)
    {
      return low < from && from < high;
    }
    mpq_class a = (low - from) / way, b = (high - from) / way;
    if (a > b)
    {
      std::swap(a, b);
    }
    first = std::max(first, a);
    last = std::min(last, b);
    return true;
  };
  return clip(S.x, S.dx, p.x) && clip(S.y, S.dy, p.y) && first < last && first < 1 && last > 0;
}

} // namespace ahd::test

#endif
