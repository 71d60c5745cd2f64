// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PrepareSurface_h
#define ahd_PrepareSurface_h

// Shared by the tests of lines on a surface: the surface, by looking at all edges and triangles.
#include "PrepareCase.h"

#include "Predicates/Predicates.h"
#include "Predicates/Segments.h"
#include "Triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace ahd
{
namespace test
{

constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();
inline PreparedInput prepared(const InputRequest& request)
{
  PreparedInput out;
  EXPECT_EQ(prepare(request, Context(), out), Status::Ok);
  return out;
}

inline PreparedInput laid(PrepareCase& given, SourceHeights heights = SourceHeights::FromSurface)
{
  given.request.heights = heights;
  given.request.linesOnSurface = true;
  return prepared(given.request);
}

/// A surface to compare with: its corners and triangles.
struct Surface
{
  using Places = std::set<std::pair<double, double>>;

  explicit Surface(const std::vector<Xyz>& input, const Cells& lines = {})
    : corners(input)
  {
    Workspace workspace;
    Triangulation made;
    const PointView view = viewOf(corners);
    EXPECT_EQ(triangulate(view, {}, workspace, {}, made), Status::Ok);
    const CellStore store(lines);
    const ConstraintView chains = { store.ids64.data(), store.offsets64.data(), lines.size(),
      lines.size() };
    EXPECT_EQ(constrain(std::move(made), chains, FillRule::EvenOdd, Context(), made), Status::Ok);
    triangles.resize(made.report().triangles);
    if (!triangles.empty())
    {
      EXPECT_EQ(made.writeTriangles(triangles[0].data(), Context()), Status::Ok);
    }
  }

  Point at(std::int64_t id) const
  {
    const Xyz& p = corners[std::size_t(id)];
    return { p[0], p[1] };
  }

  /// By the plane of a triangle that the place is on; NaN outside.
  double heightAt(const Point& p) const
  {
    double best = -1e-9, height = kNoHeight;
    for (const auto& t : triangles)
    {
      const Point a = at(t[0]), b = at(t[1]), c = at(t[2]);
      const double all = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      const double v = ((p.x - a.x) * (c.y - a.y) - (p.y - a.y) * (c.x - a.x)) / all;
      const double w = ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / all;
      const double least = std::min({ v, w, 1.0 - v - w });
      const auto z = [&](std::size_t k) { return corners[std::size_t(t[k])][2]; };
      if (least >= best)
      {
        best = least;
        height = (1.0 - v - w) * z(0) + v * z(1) + w * z(2);
      }
    }
    return height;
  }

  /// Where a segment has to have points, by the definition.
  Places stopsOf(const Point& a, const Point& b) const
  {
    Places stops;
    const Segment segment = lexicographicallyLess(a, b) ? Segment{ a, b } : Segment{ b, a };
    const auto stop = [&](const Point& p)
    {
      if (!(p == a || p == b))
      {
        stops.insert({ p.x, p.y });
      }
    };
    for (const auto& t : triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Point p = at(t[k]), q = at(t[(k + 1) % 3]);
        const Segment edge = lexicographicallyLess(p, q) ? Segment{ p, q } : Segment{ q, p };
        const bool isBetween = lexicographicallyLess(segment.left, p) &&
          lexicographicallyLess(p, segment.right);
        if (isBetween && orient2d(a, b, p) == 0)
        {
          stop(p);
        }
        if (orient2d(a, b, p) * orient2d(a, b, q) >= 0 ||
          orient2d(p, q, a) * orient2d(p, q, b) >= 0)
        {
          continue;
        }
        const bool isThroughP = roundsTo(segment, p), isThroughQ = roundsTo(segment, q);
        isThroughP ? stop(p) : void();
        isThroughQ ? stop(q) : void();
        if (!isThroughP && !isThroughQ && !roundsTo(edge, a) && !roundsTo(edge, b))
        {
          stop(crossingOf(segment, edge));
        }
      }
    }
    return stops;
  }

  std::vector<Xyz> corners;
  std::vector<std::array<std::int64_t, 3>> triangles;
};

} // namespace test
} // namespace ahd

#endif
