// SPDX-License-Identifier: BSD-3-Clause
//
// The certifier must detect faults: every kind is planted here and must be named. The engine is not
// used: the correct triangulations come from the oracle.
#include "Certifier.h"
#include "Oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ahd
{
namespace test
{
namespace
{

/// Points with their correct triangulation, to be corrupted.
struct Sample
{
  explicit Sample(std::vector<Point> p)
    : points(std::move(p))
    , pointStatus(points.size())
  {
    for (const Triple& triple : delaunayByDefinition(points))
    {
      triples.insert(triples.end(), triple.begin(), triple.end());
    }
    std::iota(pointStatus.begin(), pointStatus.end(), 0);
  }

  std::string complaints() const
  {
    return joined(certify(PointView(&points[0].x, points.size(), 2), triples, pointStatus));
  }

  void removeTriangle(std::size_t t)
  {
    const auto first = triples.begin() + std::ptrdiff_t(3 * t);
    triples.erase(first, first + 3);
  }

  /// The place of the triangle with these corners, counterclockwise.
  std::size_t find(const Triple& corners) const
  {
    for (std::size_t t = 0; 3 * t < triples.size(); ++t)
    {
      if (smallestFirst({ triples[3 * t], triples[3 * t + 1], triples[3 * t + 2] }) ==
        smallestFirst(corners))
      {
        return t;
      }
    }
    ADD_FAILURE() << "no such triangle";
    return 0;
  }

  void replace(const Triple& corners, const Triple& by)
  {
    std::copy(by.begin(), by.end(), triples.begin() + std::ptrdiff_t(3 * find(corners)));
  }

  std::vector<Point> points;
  std::vector<std::int32_t> triples;
  std::vector<std::int64_t> pointStatus;
};

/// A hexagon, not regular, round a centre (6): six triangles (i, i + 1, 6).
Sample hexagon()
{
  return Sample(
    { { 4, 0 }, { 2, 3 }, { -2, 3.5 }, { -4, 0 }, { -2, -3 }, { 2, -3.5 }, { 0.1, 0 } });
}

#define EXPECT_COMPLAINT(sample, words)                                                            \
  EXPECT_NE((sample).complaints().find(words), std::string::npos) << "complaints:\n"               \
                                                                  << (sample).complaints()

TEST(CertifierFaults, RightTriangulationIsCertified)
{
  const Sample sample = hexagon();
  EXPECT_EQ(sample.triples.size(), 18u);
  EXPECT_EQ(sample.complaints(), "");
}

TEST(CertifierFaults, ClockwiseTriangle)
{
  Sample sample = hexagon();
  std::swap(sample.triples[3], sample.triples[4]);
  EXPECT_COMPLAINT(sample, "clockwise: triangle 1 of point");
}

TEST(CertifierFaults, TriangleWithoutArea)
{
  Sample sample({ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 0, 3 } });
  sample.triples.insert(sample.triples.end(), { 0, 1, 2 });
  EXPECT_COMPLAINT(sample, "no area: triangle");
}

TEST(CertifierFaults, CoordinatesAreNamedInHexadecimal)
{
  Sample sample({ { 0, 0 }, { 1, 0 }, { 0, 0.1 } });
  std::swap(sample.triples[0], sample.triples[1]);
  EXPECT_COMPLAINT(sample, "0x1.999999999999ap-4");
}

TEST(CertifierFaults, MissingTriangleAtTheHull)
{
  Sample sample = hexagon();
  sample.removeTriangle(2);
  EXPECT_COMPLAINT(sample, "hull not convex: at point 6");
}

TEST(CertifierFaults, MissingTriangleInside)
{
  Sample sample({ { 0, 0 }, { 9, 0 }, { 0, 9 }, { 2, 2 }, { 3, 2 }, { 2, 3 } });
  sample.removeTriangle(sample.find({ 3, 4, 5 }));
  EXPECT_COMPLAINT(sample, "hull is not one simple loop");
  EXPECT_COMPLAINT(sample, "Euler");
}

TEST(CertifierFaults, FlippedEdge)
{
  Sample sample = hexagon();
  // Triangles 0 1 6 and 1 2 6 share the edge 1-6. Put 0-2 in its place; 0 1 2 6 is convex.
  sample.replace({ 0, 1, 6 }, { 0, 1, 2 });
  sample.replace({ 1, 2, 6 }, { 0, 2, 6 });
  EXPECT_COMPLAINT(sample, "not Delaunay: edge point");
}

TEST(CertifierFaults, TieBrokenTheWrongWay)
{
  Sample sample({ { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } });
  sample.triples = { 0, 1, 3, 0, 3, 2 };
  EXPECT_COMPLAINT(sample, "tie broken the wrong way: edge point");
}

TEST(CertifierFaults, TieBrokenTheWrongWayInANearlyCocircularWorld)
{
  // One unit in the last place decides between a tie and none.
  const double above = std::nextafter(1.0, 2.0);
  Sample sample({ { 0, 0 }, { 1, 0 }, { 0, 1 }, { above, above } });
  EXPECT_EQ(sample.complaints(), "");
  sample.triples = { 0, 1, 3, 0, 3, 2 };
  EXPECT_COMPLAINT(sample, "not Delaunay: edge point");
}

TEST(CertifierFaults, TriangleTwice)
{
  Sample sample = hexagon();
  const std::vector<std::int32_t> copy(sample.triples.begin(), sample.triples.begin() + 3);
  sample.triples.insert(sample.triples.end(), copy.begin(), copy.end());
  EXPECT_COMPLAINT(sample, "edge used twice: point");
}

TEST(CertifierFaults, CornerThatIsNoPoint)
{
  Sample sample = hexagon();
  sample.triples[4] = 7;
  EXPECT_COMPLAINT(sample, "corner: 7 is not");
  sample.triples[4] = -1;
  EXPECT_COMPLAINT(sample, "corner: -1 is not");
}

TEST(CertifierFaults, VertexLeftOutOfTheTriangles)
{
  Sample sample = hexagon();
  sample.points.push_back({ 1, 1 });
  sample.pointStatus.push_back(7);
  EXPECT_COMPLAINT(sample, "vertex in no triangle: point 7 (0x1p+0, 0x1p+0)");
  EXPECT_COMPLAINT(sample, "Euler");
}

TEST(CertifierFaults, CollinearHullPointLeftOut)
{
  Sample sample({ { 0, 0 }, { 2, 0 }, { 0, 2 } });
  sample.points.push_back({ 1, 0 });
  sample.pointStatus.push_back(3);
  EXPECT_COMPLAINT(sample, "vertex in no triangle: point 3");
}

TEST(CertifierFaults, PointLost)
{
  Sample sample = hexagon();
  sample.points.push_back({ 1, 1 });
  EXPECT_COMPLAINT(sample, "pointStatus: 7 for 8 points");
  sample.pointStatus.push_back(-1);
  EXPECT_COMPLAINT(sample, "point status: point 7 (0x1p+0, 0x1p+0) has -1 instead of 7");
  sample.pointStatus[7] = 6;
  EXPECT_COMPLAINT(sample, "has 6 instead of 7");
}

TEST(CertifierFaults, DuplicateOfTheWrongPoint)
{
  Sample sample = hexagon();
  sample.points.insert(sample.points.end(), { { 0.1, 0.0 }, { 0.1, -0.0 } });
  sample.pointStatus.insert(sample.pointStatus.end(), { 6, 6 });
  EXPECT_EQ(sample.complaints(), "");
  sample.pointStatus[8] = 7;
  EXPECT_COMPLAINT(sample, "point status: point 8");
  sample.pointStatus[8] = 8;
  EXPECT_COMPLAINT(sample, "point status: point 8");
}

TEST(CertifierFaults, NotFiniteTakenForAVertex)
{
  Sample sample = hexagon();
  sample.points.push_back({ std::numeric_limits<double>::quiet_NaN(), 0 });
  sample.pointStatus.push_back(-1);
  EXPECT_EQ(sample.complaints(), "");
  sample.pointStatus.back() = 7;
  EXPECT_COMPLAINT(sample, "point status: point 7");
}

TEST(CertifierFaults, SkippedPointUsed)
{
  const Sample sample({ { 0, 0 }, { 1, 0 }, { 0, 1 }, { 3, 3 } });
  const unsigned char skip[] = { 0, 0, 0, 4 };
  PointView view(&sample.points[0].x, 4, 2);
  view.skip = skip;
  EXPECT_NE(joined(certify(view, sample.triples, sample.pointStatus)), "");
  view.skipMask = 3;
  EXPECT_EQ(joined(certify(view, sample.triples, sample.pointStatus)), "");
}

TEST(CertifierFaults, TwoPieces)
{
  Sample sample({ { 0, 0 }, { 1, 0 }, { 0, 1 }, { 9, 9 }, { 10, 9 }, { 9, 10 } });
  sample.triples = { 0, 1, 2, 3, 4, 5 };
  EXPECT_COMPLAINT(sample, "not connected: 1 of 2 triangles");
  EXPECT_COMPLAINT(sample, "hull is not one simple loop");
}

TEST(CertifierFaults, FanThatGoesRoundTwice)
{
  // A convex ring of eleven points, each joined to the next but one and to the centre: the loop is
  // convex everywhere and every edge is used once, but the fan winds round the centre twice.
  const std::int32_t centre = 11;
  Sample sample({ { 10, 0 }, { 8, 6 }, { 3, 9 }, { -3, 9 }, { -8, 6 }, { -10, 0 }, { -8, -6 },
    { -3, -9 }, { 3, -9 }, { 8, -6 }, { 9.5, -3.2 }, { 0, 0 } });
  sample.triples.clear();
  for (std::int32_t i = 0; i < 11; ++i)
  {
    sample.triples.insert(sample.triples.end(), { i, (i + 2) % 11, centre });
  }
  EXPECT_COMPLAINT(sample, "goes round 2 times");
}

TEST(CertifierFaults, NoTrianglesWhereThereAreSome)
{
  Sample sample = hexagon();
  sample.triples.clear();
  EXPECT_COMPLAINT(sample, "no triangles: point 0");
  const Sample line({ { 0, 0 }, { 1, 1 }, { 5, 5 }, { -3, -3 } });
  EXPECT_EQ(line.complaints(), "");
}

TEST(CertifierFaults, ManyFaultsAreCounted)
{
  Sample sample = hexagon();
  std::fill(sample.pointStatus.begin(), sample.pointStatus.end(), -2);
  EXPECT_COMPLAINT(sample, "point status: 2 more of this kind");
}

} // namespace
} // namespace test
} // namespace ahd
