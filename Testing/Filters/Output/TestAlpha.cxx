// SPDX-License-Identifier: BSD-3-Clause
//
// Alpha beside the real vtkDelaunay2D, on points of which both make the same triangles; messages;
// MaximumEdgeLength.
#include "FilterTestSupport.h"

#include "vtkDelaunay2D.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace
{

using ahdtest::Xyz;
using Cells = std::set<std::vector<vtkIdType>>;

/// Cells of one kind, each with its corners in ascending order. Expects none twice.
Cells cellsOf(vtkCellArray* cells)
{
  Cells result;
  vtkNew<vtkIdList> ids;
  for (vtkIdType k = 0; k < cells->GetNumberOfCells(); ++k)
  {
    cells->GetCellAtId(k, ids);
    std::vector<vtkIdType> cell(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfIds());
    std::sort(cell.begin(), cell.end());
    EXPECT_TRUE(result.insert(cell).second) << "a cell is there twice";
  }
  return result;
}

struct Shape
{
  explicit Shape(vtkPolyData* surface)
    : triangles(cellsOf(surface->GetPolys()))
    , lines(cellsOf(surface->GetLines()))
    , verts(cellsOf(surface->GetVerts()))
  {
  }
  Cells triangles, lines, verts;
};

/// Far enough for the outline to be convex here.
void keepTheHull(vtkDelaunay2D* filter)
{
  filter->SetOffset(1000.0);
}
void keepTheHull(vtkAdaptiveHilbertDelaunay2D* filter)
{
  filter->SetRimToConvexHull();
}

/// The common part of both.
template <typename Filter>
vtkSmartPointer<vtkPolyData> run(vtkPolyData* points, double alpha, vtkAbstractTransform* transform)
{
  vtkNew<Filter> filter;
  filter->SetInputData(points);
  filter->SetAlpha(alpha);
  filter->SetTolerance(0.0);
  keepTheHull(filter);
  filter->SetTransform(transform);
  filter->SetProjectionPlaneMode(transform ? VTK_SET_TRANSFORM_PLANE : VTK_DELAUNAY_XY_PLANE);
  filter->Update();
  return filter->GetOutput();
}

Shape ours(vtkPolyData* points, double alpha, vtkAbstractTransform* transform = nullptr)
{
  return Shape(run<vtkAdaptiveHilbertDelaunay2D>(points, alpha, transform));
}

Shape theirs(vtkPolyData* points, double alpha, vtkAbstractTransform* transform = nullptr)
{
  return Shape(run<vtkDelaunay2D>(points, alpha, transform));
}

/// Of about `count` points in a unit square.
std::vector<double> manyAlphas(std::size_t count)
{
  const double spacing = 1.0 / std::sqrt(double(count));
  std::vector<double> alphas = { 0.0 };
  for (double factor = 0.05; factor < 50.0; factor *= 1.35)
  {
    alphas.push_back(factor * spacing);
  }
  return alphas;
}

void expectSame(vtkPolyData* points, double alpha, vtkAbstractTransform* transform = nullptr)
{
  const Shape mine = ours(points, alpha, transform);
  const Shape vtks = theirs(points, alpha, transform);
  EXPECT_EQ(mine.triangles, vtks.triangles) << "alpha " << alpha;
  EXPECT_EQ(mine.lines, vtks.lines) << "alpha " << alpha;
  EXPECT_EQ(mine.verts, vtks.verts) << "alpha " << alpha;
}

class AlphaBesideVtk : public testing::TestWithParam<std::size_t>
{
};

/// With all alphas, if both make the same triangles. Where they do not, vtkDelaunay2D has left some
/// out at the border.
int compare(vtkPolyData* points)
{
  if (ours(points, 0.0).triangles != theirs(points, 0.0).triangles)
  {
    return 0;
  }
  for (const double alpha : manyAlphas(std::size_t(points->GetNumberOfPoints())))
  {
    expectSame(points, alpha);
  }
  return 1;
}

TEST_P(AlphaBesideVtk, PointsOfAPlane)
{
  int compared = 0;
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    compared += compare(ahdtest::makeCloud(ahdtest::scatteredPoints(GetParam(), seed)));
  }
  EXPECT_GE(compared, 2);
}

TEST_P(AlphaBesideVtk, Heights)
{
  int compared = 0;
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    std::vector<Xyz> xyz = ahdtest::scatteredPoints(GetParam(), seed);
    for (Xyz& p : xyz)
    {
      p[2] = 0.3 * std::sin(9.0 * p[0]) + p[1] * p[1];
    }
    compared += compare(ahdtest::makeCloud(xyz));
  }
  EXPECT_GE(compared, 2);
}

INSTANTIATE_TEST_SUITE_P(Counts, AlphaBesideVtk, testing::Values(3, 10, 60, 300));

TEST(Alpha, BesideVtkWithATransform)
{
  // Triangulated in y and z, measured in space.
  vtkNew<vtkTransform> transform;
  transform->RotateY(90.0);
  transform->Scale(3.0, 1.0, 1.0);
  std::vector<Xyz> xyz = ahdtest::scatteredPoints(60);
  for (Xyz& p : xyz)
  {
    p = { p[0] * p[1], p[0], p[1] };
  }
  const auto points = ahdtest::makeCloud(xyz);
  ASSERT_EQ(ours(points, 0.0, transform).triangles, theirs(points, 0.0, transform).triangles);
  for (const double alpha : manyAlphas(60))
  {
    expectSame(points, alpha, transform);
  }
}

TEST(Alpha, BesideVtkOnALine)
{
  // No triangles; but lines from one point to the next, where that is not too far.
  const auto points = ahdtest::makeCloud(
    { { 0, 0, 0 }, { 4, 0, 0 }, { 1, 0, 0 }, { 9, 0, 0 }, { 4.5, 0, 0 } });
  const Shape mine = ours(points, 1.0);
  EXPECT_EQ(mine.triangles, Cells{});
  EXPECT_EQ(mine.lines, (Cells{ { 0, 2 }, { 1, 4 } }));
  EXPECT_EQ(mine.verts, (Cells{ { 3 } }));
  const Shape vtks = theirs(points, 1.0);
  EXPECT_EQ(mine.lines, vtks.lines);
  EXPECT_EQ(mine.verts, vtks.verts);
}

TEST(Alpha, BesideVtkDuplicatesAreVerts)
{
  std::vector<Xyz> xyz = ahdtest::scatteredPoints(60);
  xyz.push_back(xyz[7]);
  xyz.push_back(xyz[30]);
  const auto points = ahdtest::makeCloud(xyz);
  for (const double alpha : { 0.02, 0.1, 1.0 })
  {
    expectSame(points, alpha);
    const Cells verts = ours(points, alpha).verts;
    EXPECT_TRUE(verts.count({ 60 }) && verts.count({ 61 }));
  }
}

TEST(Alpha, MergedPointsAreVerts)
{
  std::vector<Xyz> xyz = ahdtest::scatteredPoints(60);
  xyz.push_back({ xyz[7][0] + 1e-6, xyz[7][1], 0.0 });
  ahdtest::WatchedFilter filter;
  filter->SetInputData(ahdtest::makeCloud(xyz));
  filter->SetTolerance(1e-5);
  filter->SetAlpha(1.0);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfMergedPoints(), 1);
  EXPECT_EQ(Shape(filter->GetOutput()).verts.size(), 1u);
}

TEST(Alpha, LimitsAreClosed)
{
  // A right triangle: the circle's radius is half the longest edge.
  const auto points = ahdtest::makeCloud({ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } });
  EXPECT_EQ(ours(points, 2.5).triangles.size(), 1u);
  const double less = std::nextafter(2.5, 0.0);
  EXPECT_EQ(ours(points, less).triangles.size(), 0u);
  EXPECT_EQ(ours(points, less).lines, (Cells{ { 0, 1 }, { 0, 2 } }));
  EXPECT_EQ(ours(points, 1.5).lines, (Cells{ { 0, 1 } }));
  EXPECT_EQ(ours(points, 1.5).verts, (Cells{ { 2 } }));
  EXPECT_EQ(ours(points, std::nextafter(1.5, 0.0)).verts.size(), 3u);
}

TEST(Alpha, EachKindCanBeHidden)
{
  const auto points = ahdtest::makeCloud(ahdtest::scatteredPoints(300));
  const double alpha = 0.03;
  const Shape all = ours(points, alpha);
  ASSERT_TRUE(!all.triangles.empty() && !all.lines.empty() && !all.verts.empty());
  for (int hidden = 0; hidden < 8; ++hidden)
  {
    vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
    filter->SetInputData(points);
    filter->SetAlpha(alpha);
    filter->SetAlphaTris((hidden & 1) == 0);
    filter->SetAlphaLines((hidden & 2) == 0);
    filter->SetAlphaVerts((hidden & 4) == 0);
    filter->Update();
    const Shape some(filter->GetOutput());
    EXPECT_EQ(some.triangles, (hidden & 1) ? Cells{} : all.triangles);
    EXPECT_EQ(some.lines, (hidden & 2) ? Cells{} : all.lines);
    EXPECT_EQ(some.verts, (hidden & 4) ? Cells{} : all.verts);
    EXPECT_EQ(filter->GetNumberOfTriangles(), vtkIdType(some.triangles.size()));
  }
}

TEST(Alpha, WithoutAlphaNothingIsHidden)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(ahdtest::makeCloud(ahdtest::scatteredPoints(50)));
  filter->AlphaTrisOff();
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPolys(), 80);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), filter->GetOutput()->GetNumberOfPolys());
}

TEST(Alpha, PointsThatAreNoVerticesAreNoVerts)
{
  // One beyond the limit, one without a place.
  std::vector<Xyz> xyz = ahdtest::scatteredPoints(20);
  xyz[4][0] = std::numeric_limits<double>::quiet_NaN();
  ahdtest::WatchedFilter filter;
  filter->SetInputData(ahdtest::makeCloud(xyz));
  filter->SetAlpha(1e-9);
  filter->SetInsertionLimit(10);
  filter->Update();
  const Shape shape(filter->GetOutput());
  EXPECT_EQ(shape.verts.size(), 10u);
  EXPECT_EQ(shape.verts.count({ 4 }), 0u);
}

TEST(Alpha, HeightsThatAreNoNumbers)
{
  // As in vtkDelaunay2D: a size that is NaN drops no triangle, and makes no line.
  std::vector<Xyz> xyz = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1.1, 0 } };
  xyz[2][2] = std::numeric_limits<double>::quiet_NaN();
  const auto points = ahdtest::makeCloud(xyz);
  ahdtest::WatchedFilter filter;
  filter->SetInputData(points);
  filter->SetAlpha(0.1);
  filter->Update();
  const Shape shape(filter->GetOutput());
  for (const auto& triangle : shape.triangles)
  {
    EXPECT_TRUE(std::count(triangle.begin(), triangle.end(), 2)) << "could be measured";
  }
  EXPECT_FALSE(shape.triangles.empty());
  EXPECT_TRUE(shape.lines.empty());
}

TEST(Alpha, AnyMagnitude)
{
  for (const double scale : { 1e-300, 1e-150, 1e150, 1e300 })
  {
    std::vector<Xyz> xyz = ahdtest::scatteredPoints(60);
    const Shape plain = ours(ahdtest::makeCloud(xyz), 0.08);
    for (Xyz& p : xyz)
    {
      p = { p[0] * scale, p[1] * scale, p[2] * scale };
    }
    const Shape scaled = ours(ahdtest::makeCloud(xyz), 0.08 * scale);
    EXPECT_EQ(plain.triangles, scaled.triangles) << scale;
    EXPECT_EQ(plain.lines, scaled.lines) << scale;
    EXPECT_EQ(plain.verts, scaled.verts) << scale;
  }
}

TEST(Alpha, CoordinatesOfAnyType)
{
  std::vector<Xyz> xyz;
  for (const Xyz& p : ahdtest::scatteredPoints(100))
  {
    xyz.push_back({ std::floor(1000 * p[0]), std::floor(1000 * p[1]), std::floor(50 * p[0]) });
  }
  const Shape doubles = ours(ahdtest::makeCloud(xyz), 70.0);
  for (const int type : { VTK_FLOAT, VTK_INT, VTK_SHORT })
  {
    const Shape others = ours(ahdtest::makeCloud(xyz, type), 70.0);
    EXPECT_EQ(doubles.triangles, others.triangles);
    EXPECT_EQ(doubles.lines, others.lines);
    EXPECT_EQ(doubles.verts, others.verts);
  }
}

TEST(Alpha, SaysWhenNothingIsLeft)
{
  ahdtest::WatchedFilter filter;
  filter->SetInputData(ahdtest::makeCloud(ahdtest::scatteredPoints(20)));
  filter->SetAlpha(1e-9);
  filter->Update();
  EXPECT_TRUE(filter.Said->Warnings.empty()) << "there are verts";
  filter->AlphaVertsOff();
  filter->Update();
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find(" keep none of"), std::string::npos);
}

double longestEdge(vtkPolyData* surface, const std::vector<vtkIdType>& cell)
{
  double longest = 0.0;
  for (std::size_t i = 0; i < cell.size(); ++i)
  {
    double p[3], q[3];
    surface->GetPoint(cell[i], p);
    surface->GetPoint(cell[(i + 1) % cell.size()], q);
    longest = std::max(longest, std::hypot(p[0] - q[0], p[1] - q[1]));
  }
  return longest;
}

vtkSmartPointer<vtkPolyData> cut(vtkPolyData* points, double length, double alpha = 0.0)
{
  vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
  filter->SetInputData(points);
  filter->SetMaximumEdgeLength(length);
  filter->SetAlpha(alpha);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangles(), filter->GetOutput()->GetNumberOfPolys());
  EXPECT_EQ(ahdtest::idsOf(filter->GetOutput()->GetFieldData(), "NumberOfTriangles"),
    std::vector<vtkIdType>{ filter->GetNumberOfTriangles() });
  return filter->GetOutput();
}

TEST(MaximumEdgeLength, DropsTrianglesWithALongerEdge)
{
  std::vector<Xyz> xyz = ahdtest::scatteredPoints(400);
  for (Xyz& p : xyz)
  {
    p[2] = 1000.0 * p[0]; // heights do not count
  }
  const auto points = ahdtest::makeCloud(xyz);
  const auto all = cut(points, 0.0);
  for (const double length : { 0.03, 0.06, 0.1, 2.0 })
  {
    const auto kept = cellsOf(cut(points, length)->GetPolys());
    for (const auto& triangle : cellsOf(all->GetPolys()))
    {
      EXPECT_EQ(kept.count(triangle) == 1, longestEdge(all, triangle) <= length);
    }
    EXPECT_EQ(cut(points, length)->GetNumberOfCells(), vtkIdType(kept.size()));
  }
  // The order of those that are left is the same.
  const auto some = ahdtest::trianglesOf(cut(points, 0.06));
  const auto before = ahdtest::trianglesOf(all);
  EXPECT_TRUE(std::is_sorted(some.begin(), some.end(),
    [&](const auto& a, const auto& b)
    {
      return std::find(before.begin(), before.end(), a) <
        std::find(before.begin(), before.end(), b);
    }));
}

TEST(MaximumEdgeLength, IsClosed)
{
  const auto points = ahdtest::makeCloud({ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } });
  EXPECT_EQ(cut(points, 5.0)->GetNumberOfPolys(), 1);
  EXPECT_EQ(cut(points, std::nextafter(5.0, 0.0))->GetNumberOfPolys(), 0);
}

TEST(MaximumEdgeLength, CombinesWithAlpha)
{
  const auto points = ahdtest::makeCloud(ahdtest::scatteredPoints(300));
  const double alpha = 0.04;
  const double length = 0.06;
  const Shape both(cut(points, length, alpha));
  const auto surface = ours(points, alpha);
  Cells triangles;
  const auto places = cut(points, 0.0);
  for (const auto& triangle : surface.triangles)
  {
    if (longestEdge(places, triangle) <= length)
    {
      triangles.insert(triangle);
    }
  }
  EXPECT_EQ(both.triangles, triangles);
  EXPECT_LT(both.triangles.size(), surface.triangles.size());
  for (const auto& line : both.lines)
  {
    EXPECT_LE(longestEdge(places, line), length);
  }
  const auto isNew = [&](const auto& line) { return surface.lines.count(line) == 0; };
  EXPECT_GT(std::count_if(both.lines.begin(), both.lines.end(), isNew), 0)
    << "edges of what was too long only";
}

}
