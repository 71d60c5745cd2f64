// SPDX-License-Identifier: BSD-3-Clause
//
// The cells that limits on size leave: against a search by definition, at the limits themselves,
// and for collinear points.
#include "SelectionCase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double distance(const Xyz& a, const Xyz& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The selection by definition.
struct Expected
{
  std::vector<unsigned char> selected; ///< of the triangles that loops keep
  std::vector<std::int32_t> lines, vertices;
};

/// Is the circle through the corners larger than alpha? By the sine of an angle, in long double.
bool isLarger(const Xyz& a, const Xyz& b, const Xyz& c, double alpha)
{
  const long double la = distance(b, c), lb = distance(a, c), lc = distance(a, b);
  const long double s = (la + lb + lc) / 2;
  const long double area = std::sqrt(s * (s - la) * (s - lb) * (s - lc));
  return la * lb * lc / (4 * area) > alpha;
}

class Search
{
public:
  Search(const Surface& surface, Triangulation& triangulation, const SizeLimits& limits)
    : surface_(surface)
    , limits_(limits)
    , triples_(3 * triangulation.report().triangles)
    , status_(surface.points.size())
  {
    EXPECT_EQ(triangulation.writeTriangles(triples_.data(), Context()), Status::Ok);
    EXPECT_EQ(triangulation.writePointStatus(status_.data(), Context()), Status::Ok);
    for (const MergedPoint& merged : surface.merged.pairs)
    {
      status_[merged.id] = status_[merged.keptId];
    }
  }

  Expected run()
  {
    std::map<std::pair<int, int>, bool> isCovered; // is a triangle of the edge selected?
    std::vector<bool> isUsed(status_.size(), false);
    Expected out;
    for (std::size_t t = 0; t < triples_.size() / 3; ++t)
    {
      const bool selected = isSelected(&triples_[3 * t]);
      out.selected.push_back(selected);
      for (std::size_t e = 0; e < 3; ++e)
      {
        isCovered[edge(t, e)] = isCovered[edge(t, e)] || selected;
        isUsed[std::size_t(triples_[3 * t + e])] = isUsed[std::size_t(triples_[3 * t + e])] ||
          selected;
      }
    }
    for (std::size_t h = 0; h < triples_.size(); ++h)
    {
      const std::int32_t a = triples_[h], b = triples_[h / 3 * 3 + (h + 1) % 3];
      if (!isCovered[edge(h / 3, h % 3)] && !isTooLong(a, b) &&
        distance(inSpace(a), inSpace(b)) / 2 <= limits_.alpha)
      {
        out.lines.push_back(a);
        out.lines.push_back(b);
        isUsed[std::size_t(a)] = isUsed[std::size_t(b)] = true;
      }
      isCovered[edge(h / 3, h % 3)] = true; // by the first of its triangles
    }
    for (std::size_t i = 0; i < status_.size(); ++i)
    {
      if (!isUsed[i] && status_[i] >= 0)
      {
        out.vertices.push_back(std::int32_t(i));
      }
    }
    return out;
  }

private:
  const Xyz& inSpace(std::int32_t id) const { return surface_.inSpace[std::size_t(id)]; }

  std::pair<int, int> edge(std::size_t t, std::size_t e) const
  {
    const int a = triples_[3 * t + e], b = triples_[3 * t + (e + 1) % 3];
    return { std::min(a, b), std::max(a, b) };
  }

  bool isTooLong(std::int32_t a, std::int32_t b) const
  {
    const Xyz& p = surface_.points[std::size_t(a)];
    const Xyz& q = surface_.points[std::size_t(b)];
    return limits_.maximumEdgeLength > 0 &&
      std::hypot(p[0] - q[0], p[1] - q[1]) > limits_.maximumEdgeLength;
  }

  bool isSelected(const std::int32_t* v) const
  {
    return !isTooLong(v[0], v[1]) && !isTooLong(v[1], v[2]) && !isTooLong(v[2], v[0]) &&
      !(limits_.alpha > 0 && isLarger(inSpace(v[0]), inSpace(v[1]), inSpace(v[2]), limits_.alpha));
  }

  const Surface& surface_;
  const SizeLimits limits_;
  std::vector<std::int32_t> triples_;
  std::vector<std::int64_t> status_;
};

/// Those of the triangles that loops keep.
std::vector<unsigned char> selectedOf(Triangulation& triangulation, const Selection& selection)
{
  std::vector<unsigned char> result;
  EXPECT_EQ(triangulation.makeCorners(Context()), Status::Ok);
  EXPECT_EQ(selection.kept.size(), triangulation.triangleCount());
  for (std::size_t t = 0; t < selection.kept.size(); ++t)
  {
    if (triangulation.isKept(t))
    {
      result.push_back(selection.kept[t]);
    }
    EXPECT_TRUE(triangulation.isKept(t) || !selection.kept[t]) << "a loop drops it";
  }
  EXPECT_EQ(std::count(result.begin(), result.end(), 1), std::ptrdiff_t(selection.keptCount));
  return result;
}

TEST(Selection, IsWhatTheDefinitionSays)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const Surface surface = makeSurface(20 + 5 * seed, seed);
    Triangulation triangulation;
    surface.triangulateInto(triangulation);
    for (double alpha = 0.0101; alpha < 2; alpha *= 1.7)
    {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", alpha " << alpha);
      SizeLimits limits;
      limits.alpha = alpha;
      limits.maximumEdgeLength = seed % 3 == 0 ? 0.1234 : 0.0;
      Selection selection;
      ASSERT_EQ(
        selectBySize(triangulation, limits, surface.measured(), Context(), selection), Status::Ok);
      const Expected expected = Search(surface, triangulation, limits).run();
      ASSERT_EQ(selectedOf(triangulation, selection), expected.selected);
      ASSERT_EQ(selection.lines, expected.lines);
      ASSERT_EQ(selection.vertices, expected.vertices);
    }
  }
}

TEST(Selection, WithoutAlphaThereAreOnlyTriangles)
{
  const Surface surface = makeSurface(300, 5);
  Triangulation triangulation;
  surface.triangulateInto(triangulation);
  for (const double length : { 0.0, 0.05, 0.1, 0.4 })
  {
    SizeLimits limits;
    limits.maximumEdgeLength = length;
    limits.triangles = false; // only with alpha
    Selection selection;
    ASSERT_EQ(
      selectBySize(triangulation, limits, surface.measured(), Context(), selection), Status::Ok);
    const Expected expected = Search(surface, triangulation, limits).run();
    EXPECT_EQ(selectedOf(triangulation, selection), expected.selected);
    EXPECT_TRUE(selection.lines.empty());
    EXPECT_TRUE(selection.vertices.empty());
    EXPECT_EQ(selection.keptCount == triangulation.report().triangles, length == 0.0);
  }
}

TEST(Selection, WhatIsNotPutOutStillBoundsTheOthers)
{
  const Surface surface = makeSurface(300, 3);
  Triangulation triangulation;
  surface.triangulateInto(triangulation);
  SizeLimits limits;
  limits.alpha = 0.04;
  Selection all;
  ASSERT_EQ(selectBySize(triangulation, limits, surface.measured(), Context(), all), Status::Ok);
  ASSERT_GT(all.keptCount, 0u);
  ASSERT_FALSE(all.lines.empty());
  ASSERT_FALSE(all.vertices.empty());
  for (int hidden = 0; hidden < 8; ++hidden)
  {
    limits.triangles = hidden % 2 == 0;
    limits.lines = hidden / 2 % 2 == 0;
    limits.vertices = hidden / 4 == 0;
    Selection some;
    ASSERT_EQ(selectBySize(triangulation, limits, surface.measured(), Context(), some), Status::Ok);
    EXPECT_EQ(some.keptCount, limits.triangles ? all.keptCount : 0);
    EXPECT_EQ(std::count(some.kept.begin(), some.kept.end(), 1), std::ptrdiff_t(some.keptCount));
    EXPECT_EQ(some.lines, limits.lines ? all.lines : std::vector<std::int32_t>());
    EXPECT_EQ(some.vertices, limits.vertices ? all.vertices : std::vector<std::int32_t>());
  }
}

TEST(Selection, TheLimitsAreClosed)
{
  // sides 3, 4 and 5, radius 2.5; below that, of the sides those of no more than 5
  Surface surface;
  surface.points = surface.inSpace = { { { 0, 0, 0 } }, { { 3, 0, 0 } }, { { 0, 4, 0 } } };
  Triangulation triangulation;
  surface.triangulateInto(triangulation);
  const auto select = [&](double alpha, double length)
  {
    SizeLimits limits;
    limits.alpha = alpha;
    limits.maximumEdgeLength = length;
    Selection selection;
    EXPECT_EQ(
      selectBySize(triangulation, limits, surface.measured(), Context(), selection), Status::Ok);
    return selection;
  };
  EXPECT_EQ(select(2.5, 5).keptCount, 1u);
  EXPECT_EQ(select(2.5, std::nextafter(5, 0)).lines.size(), 4u);
  EXPECT_EQ(select(std::nextafter(2.5, 0), 0).keptCount, 0u);
  EXPECT_EQ(select(std::nextafter(2.5, 0), 0).lines.size(), 4u);
  EXPECT_EQ(select(2, 0).lines.size(), 4u);
  EXPECT_EQ(select(1.9, 0).lines.size(), 2u);
  EXPECT_EQ(select(1.9, 0).vertices, std::vector<std::int32_t>{ 2 });
  EXPECT_EQ(select(1.4, 0).vertices, (std::vector<std::int32_t>{ 0, 1, 2 }));
  EXPECT_EQ(select(0, 4.9).keptCount, 0u);
  EXPECT_EQ(select(0, 5).keptCount, 1u);
}

TEST(Selection, OfTriplesInMemoryIsTheSame)
{
  const Surface surface = makeSurface(300, 5);
  Triangulation triangulation;
  surface.triangulateInto(triangulation);
  const std::size_t count = triangulation.report().triangles;
  std::vector<std::int32_t> triples(3 * count);
  ASSERT_EQ(triangulation.writeTriangles(triples.data(), Context()), Status::Ok);
  for (const double length : { 1e-9, 0.0625, 0.1, 0.4, 2.0 })
  {
    SizeLimits limits;
    limits.maximumEdgeLength = length;
    Selection selection;
    ASSERT_EQ(
      selectBySize(triangulation, limits, surface.measured(), Context(), selection), Status::Ok);
    std::vector<unsigned char> kept;
    ASSERT_EQ(
      findShort(triples.data(), count, surface.view(), length, Context(), kept), Status::Ok);
    EXPECT_EQ(kept, selectedOf(triangulation, selection)) << length;
  }
  const std::vector<double> sides = { 0, 0, 3, 0, 0, 4 }; // the longest is 5
  const std::int32_t triple[] = { 2, 0, 1 };
  std::vector<unsigned char> kept;
  for (const double length : { 5.0, std::nextafter(5.0, 0.0) })
  {
    ASSERT_EQ(
      findShort(triple, 1, PointView(sides.data(), 3, 2), length, Context(), kept), Status::Ok);
    EXPECT_EQ(kept, std::vector<unsigned char>{ static_cast<unsigned char>(length == 5.0) });
  }
}

TEST(Selection, CollinearVerticesHaveLinesFromOneToTheNext)
{
  Surface surface;
  surface.points = { { { 3, 3, 0 } }, { { 1, 1, 0 } }, { { 3, 3, 9 } }, { { 7, 7, 0 } },
    { { kNaN, 0, 0 } }, { { 2, 2, 5 } } };
  surface.inSpace = surface.points;
  surface.options.representative = Representative::HighestZ;
  Triangulation triangulation;
  surface.triangulateInto(triangulation);
  SizeLimits limits;
  limits.alpha = 3.0; // 5.2 from 1 to 2, 4.2 from 2 to 3, 10.6 from 3 to 7
  Selection selection;
  ASSERT_EQ(
    selectBySize(triangulation, limits, surface.measured(), Context(), selection), Status::Ok);
  EXPECT_EQ(selection.lines, (std::vector<std::int32_t>{ 1, 5, 5, 2 }));
  EXPECT_EQ(selection.vertices, (std::vector<std::int32_t>{ 0, 3 }));
  EXPECT_TRUE(selection.kept.empty());

  surface.options.insertionLimit = 2;
  surface.options.order = InsertionOrder::AsGiven;
  surface.triangulateInto(triangulation); // 3 and 1
  limits.alpha = 100;
  ASSERT_EQ(
    selectBySize(triangulation, limits, surface.measured(), Context(), selection), Status::Ok);
  EXPECT_EQ(selection.lines, (std::vector<std::int32_t>{ 1, 2 }));
  EXPECT_EQ(selection.vertices, std::vector<std::int32_t>{ 0 });
}

TEST(Selection, OfNothing)
{
  Triangulation none;
  SizeLimits limits;
  limits.alpha = 1.0;
  Selection selection;
  EXPECT_EQ(selectBySize(none, limits, PointsToMeasure(), Context(), selection), Status::Ok);
  EXPECT_EQ(selection.keptCount, 0u);
  EXPECT_TRUE(selection.lines.empty());
}

} // namespace
} // namespace test
} // namespace ahd
