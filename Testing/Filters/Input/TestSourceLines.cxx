// SPDX-License-Identifier: BSD-3-Clause
//
// Sources as users have them: outlines in pieces or twice, a table of points along a shore, a
// source in another place or without heights. What is wrong with them is told once.
#include "ConstraintTestSupport.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace ahdtest;

namespace
{
/// The corners of a square of this side, counterclockwise from (at, at).
std::vector<Xyz> squareOf(double at, double side, double z = 0.0)
{
  const double to = at + side;
  return { { at, at, z }, { to, at, z }, { to, to, z }, { at, to, z } };
}

/// 10 x 10 points at this height.
std::vector<Xyz> terrain(double z)
{
  std::vector<Xyz> points = squareLattice(10);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i][2] = z + (i % 3 == 0 ? 1.0 : 0.0);
  }
  return points;
}

struct LinesFilter : WatchedFilter
{
  LinesFilter(const std::vector<Xyz>& points, vtkDataObject* source)
  {
    this->Filter->SetInputData(makeCloud(points));
    this->Filter->SetInputDataObject(1, source);
    this->Filter->SetSourceModeToCoordinates();
    this->Filter->SetFillRuleToEvenOdd();
  }
  double Area()
  {
    this->Filter->Update();
    EXPECT_TRUE(this->Said->Errors.empty());
    return areaOf(this->Filter->GetOutput());
  }
  /// The only warning of the last run; empty if there is none.
  std::string Warned()
  {
    this->Said->Warnings.clear();
    this->Filter->Modified();
    this->Filter->Update();
    EXPECT_LE(this->Said->Warnings.size(), 1u) << this->Said->Warnings[1];
    return this->Said->Warnings.empty() ? "" : this->Said->Warnings[0];
  }
};

void expectParts(const std::string& text, const std::vector<std::string>& parts)
{
  for (const std::string& part : parts)
  {
    EXPECT_NE(text.find(part), std::string::npos) << "no \"" << part << "\" in: " << text;
  }
}
}

TEST(SourceLines, ThatMeetEndToEndAreAnOutline)
{
  // as Feature Edges gives them: two points each, in any direction
  const std::vector<Chain> pieces = { { 2, 1 }, { 0, 1 }, { 3, 0 }, { 2, 3 } };
  LinesFilter filter(squareLattice(10), makeSource(pieces, {}, squareOf(1.5, 4)));
  EXPECT_EQ(filter.Area(), 81.0);
  filter->SetClosedLinesToLoops();
  EXPECT_EQ(filter.Area(), 16.0);
  EXPECT_EQ(filter.Warned(), "");
  // ends that are other points at the same places
  std::vector<Xyz> twice = squareOf(1.5, 4);
  const std::vector<Xyz> again = squareOf(1.5, 4, 7);
  twice.insert(twice.end(), again.begin(), again.end());
  LinesFilter apart(
    squareLattice(10), makeSource({ { 0, 1 }, { 5, 2 }, { 6, 3 }, { 7, 4 } }, {}, twice));
  apart->SetClosedLinesToLoops();
  EXPECT_EQ(apart.Area(), 16.0);
}

TEST(SourceLines, OfWhichNoneIsClosedAreToldOnce)
{
  LinesFilter filter(
    squareLattice(10), makeSource({ { 0, 1 }, { 1, 2 }, { 2, 3 } }, {}, squareOf(1.5, 4)));
  filter->SetClosedLinesToLoops();
  EXPECT_EQ(filter.Area(), 81.0);
  expectParts(filter.Warned(), { "None of the lines of the source is closed", "ClosedLines" });
  filter->SetClosedLinesToLines();
  EXPECT_EQ(filter.Warned(), "");
}

TEST(SourceLines, ARingThatIsALineAndAPolygonCountsOnce)
{
  // as PyVista's Polygon has it
  std::vector<Xyz> points = squareOf(0.5, 8);
  const std::vector<Xyz> hole = squareOf(2.5, 3);
  points.insert(points.end(), hole.begin(), hole.end());
  const std::vector<Chain> rings = { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } };
  const std::vector<Chain> lines = { { 0, 1, 2, 3, 0 }, { 5, 6, 7, 4, 5 } };
  LinesFilter filter(squareLattice(10), makeSource(lines, rings, points));
  filter->SetClosedLinesToLoops();
  EXPECT_EQ(filter.Area(), 64.0 - 9.0);
}

TEST(SourceLines, PointsAreALineOnRequest)
{
  std::vector<Xyz> shore = squareOf(1.5, 4);
  shore.push_back(shore[0]);
  auto table = makeCloud(shore);
  LinesFilter filter(squareLattice(10), table);
  expectParts(filter.Warned(), { "constrains nothing", "PointsAsLine" });
  filter->PointsAsLineOn();
  EXPECT_EQ(filter.Area(), 81.0);
  EXPECT_GE(filter->GetNumberOfConstraintEdges(), 4);
  EXPECT_EQ(filter.Warned(), "");
  filter->SetClosedLinesToLoops();
  EXPECT_EQ(filter.Area(), 16.0);
  filter->SetSourceModeToIds();
  EXPECT_EQ(filter.Area(), 81.0) << "they stand for the input's";
  filter->SetSourceModeToCoordinates();
  table->SetStrips(makeCells({ { 0, 1, 2, 3 } }));
  EXPECT_EQ(filter.Area(), 81.0) << "a surface is no line";
  table->SetStrips(nullptr);
  table->SetVerts(makeCells({ { 0 }, { 1 } }));
  EXPECT_EQ(filter.Area(), 16.0);
  table->SetLines(makeCells({ { 0, 1 } }));
  EXPECT_EQ(filter.Area(), 81.0) << "it has lines of its own";
}

TEST(SourceLines, ElsewhereAreToldWithBothBounds)
{
  LinesFilter far(terrain(5), makeSource({}, { { 0, 1, 2, 3 } }, squareOf(100, 8, 5)));
  expectParts(
    far.Warned(), { "does not overlap", "x 100 to 108, y 100 to 108", "x 0 to 9, y 0 to 9" });
  far->SetSourceHeightsToFromSurface();
  expectParts(far.Warned(), { "does not overlap" });
  // a line is elsewhere, too
  LinesFilter line(terrain(5), makeSource({ { 0, 1 } }, {}, squareOf(100, 8, 5)));
  expectParts(line.Warned(), { "does not overlap" });
  // around no point, though the boxes overlap
  LinesFilter gap(terrain(5), makeSource({}, { { 0, 1, 2, 3 } }, squareOf(0.25, 0.5, 5)));
  expectParts(
    gap.Warned(), { "None of the points lies inside", "x 0.25 to 0.75", "x 0 to 9, y 0 to 9" });
  LinesFilter corner(terrain(5), makeSource({}, { { 0, 1, 2, 3 } }, squareOf(0.5, 0.5, 5)));
  EXPECT_EQ(corner.Warned(), "") << "one is its corner";
  corner->SetDuplicatePolicy(2);
  EXPECT_EQ(corner.Warned(), "") << "whichever stands for the place";
  // nothing to be elsewhere from
  LinesFilter alone({}, makeSource({}, { { 0, 1, 2, 3 } }, squareOf(100, 8, 5)));
  EXPECT_EQ(alone.Warned(), "");
}

TEST(SourceLines, WithoutHeightsAreTold)
{
  const std::vector<Xyz> road = squareOf(1.5, 4);
  LinesFilter filter(terrain(5), makeSource({ { 0, 1 }, { 1, 2 } }, { { 0, 1, 2, 3 } }, road));
  expectParts(filter.Warned(),
    { "3 lines and polygons", "z = 0", "from 5 to 6", "SourceHeights", "ZeroIsMissing" });
  filter->SetSourceHeightsToFromSurface();
  EXPECT_EQ(filter.Warned(), "");
  LinesFilter low(terrain(-5.5), makeSource({ { 0, 1 } }, {}, road));
  expectParts(low.Warned(), { "1 line or polygon", "from -5.5 to -4.5" });
  LinesFilter sea(terrain(-0.5), makeSource({ { 0, 1 } }, {}, road));
  EXPECT_EQ(sea.Warned(), "") << "0 is a height of the terrain";
}
