// SPDX-License-Identifier: BSD-3-Clause
//
// Interpolation on a surface that a vtkAdaptiveHilbertDelaunay2D made: on its own triangles, as if
// the interpolation had been given the points and all settings itself.
#include "ConstraintTestSupport.h"
#include "SampleTestSupport.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace ahdtest;
using Delaunay = vtkAdaptiveHilbertDelaunay2D;
using Filter = vtkAdaptiveHilbertInterpolation2D;

/// Fewer vertices have other numbers, so weights are rounded otherwise.
bool areSame(const std::vector<double>& a, const std::vector<double>& b, double off)
{
  bool same = a.size() == b.size();
  for (std::size_t i = 0; i < a.size() && same; ++i)
  {
    same = std::isnan(a[i]) ? std::isnan(b[i]) : std::abs(a[i] - b[i]) <= off;
  }
  return same;
}

/// Interpolates on the surface of the settings `set`, in one filter and in two.
void expectTheSame(const std::function<void(Delaunay*)>& set, vtkPolyData* source,
  const std::vector<int>& methods, bool setsPlane = false, double off = 1e-12)
{
  auto cloud = hills();
  vtkNew<Delaunay> delaunay;
  vtkNew<Messages> said; // of constraints that cross
  said->Watch(delaunay);
  delaunay->SetInputData(cloud);
  delaunay->SetSourceData(source);
  delaunay->SetReuseLimit(0); // so that its own triangulation is gone
  set(delaunay);
  WatchedInterpolation direct, behind;
  direct->SetInputData(cloud);
  direct->SetSourceData(source);
  set(direct->GetTriangulation());
  behind->SetInputConnection(delaunay->GetOutputPort());
  if (setsPlane)
  {
    set(behind->GetTriangulation());
  }
  for (WatchedInterpolation* filter : { &direct, &behind })
  {
    (*filter)->UseBoundsOn();
    (*filter)->SetBounds(-0.1, 1.1, -0.6, 1.1);
    (*filter)->SetDimensions(90, 80);
  }
  for (const int method : methods)
  {
    direct->SetMethod(method);
    direct->Update();
    behind->SetMethod(method);
    behind->Update();
    EXPECT_GT(direct->GetNumberOfValidPlaces(), 300);
    for (const char* name : { "Elevation", "a", "vtkValidPointMask" })
    {
      EXPECT_TRUE(
        areSame(numbersOf(direct->GetOutput(), name), numbersOf(behind->GetOutput(), name), off))
        << name << " " << method;
    }
  }
  EXPECT_EQ(behind->GetNumberOfTriangulations(), 1);
  EXPECT_TRUE(behind.Said->Errors.empty());
  EXPECT_TRUE(behind.Said->Warnings.empty());
}

const std::vector<int> kAll = { Filter::LINEAR, Filter::NATURAL_NEIGHBOR, Filter::LAPLACE,
  Filter::NEAREST };

TEST(InterpolationSurface, OfPointsAlone)
{
  expectTheSame([](Delaunay*) {}, nullptr, kAll);
  expectTheSame([](Delaunay* f) { f->SetDuplicatePolicyToHighestZ(); }, nullptr, kAll);
  expectTheSame([](Delaunay* f) { f->SetDuplicatePolicyToMeanZ(); }, nullptr, { Filter::LINEAR });
}

TEST(InterpolationSurface, WithTrianglesLeftOut)
{
  expectTheSame([](Delaunay* f) { f->SetMaximumEdgeLength(0.06); }, nullptr, { 0, 1 });
  expectTheSame([](Delaunay* f) { f->SetAlpha(0.03); }, nullptr, { 0 });
  const auto ofMeans = [](Delaunay* f)
  {
    f->SetDuplicatePolicyToMeanZ(); // which the lengths are measured with
    f->SetMaximumEdgeLength(0.06);
  };
  expectTheSame(ofMeans, nullptr, { 0 });
  expectTheSame([](Delaunay* f) { f->SetTolerance(0.01); }, nullptr, kAll);
}

/// Down to one triangle, the others are not made again.
TEST(InterpolationSurface, OfOneTriangle)
{
  vtkNew<Delaunay> delaunay;
  delaunay->SetInputData(makeCloud({ { 0, 0, 1 }, { 1, 0, 2 }, { 0, 1, 3 }, { 9, 9, 4 } }));
  delaunay->SetMaximumEdgeLength(2.0);
  delaunay->Update();
  ASSERT_EQ(delaunay->GetOutput()->GetNumberOfPolys(), 1);
  vtkNew<vtkPolyData> copy; // that no triangulation is lent for
  copy->DeepCopy(delaunay->GetOutput());
  for (vtkPolyData* surface : { delaunay->GetOutput(), copy.Get() })
  {
    WatchedInterpolation filter;
    filter->SetInputData(surface);
    filter->SetPlacesData(makeCloud({ { 0.25, 0.25, 0 }, { 5, 5, 0 } }));
    filter->Update();
    const auto heights = numbersOf(filter->GetOutput(), "Elevation");
    EXPECT_NEAR(heights[0], 1.75, 1e-12);
    EXPECT_TRUE(std::isnan(heights[1]));
    EXPECT_TRUE(filter.Said->Warnings.empty());
  }
}

TEST(InterpolationSurface, WithConstraints)
{
  const auto source = makeSource({ { 0, 700 }, { 5, 900, 30 } }, { { 11, 222, 333, 444 } });
  expectTheSame([](Delaunay*) {}, source, { Filter::LINEAR });
  // Natural neighbours end at constraints, which this array names, and nowhere else.
  const auto named = [](Delaunay* f) { f->GenerateConstraintEdgesOn(); };
  expectTheSame(named, source, { Filter::LINEAR, Filter::NATURAL_NEIGHBOR, Filter::LAPLACE });
  expectTheSame([](Delaunay* f) { f->SetCrossingModeToSplit(); }, source, { Filter::LINEAR });
}

/// Marks each constraint edge where it is edge `at` of its triangles: their corners are turned.
vtkSmartPointer<vtkPolyData> turned(vtkPolyData* surface, int at)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(surface);
  vtkDataArray* const edges = copy->GetCellData()->GetArray("ConstraintEdges");
  vtkNew<vtkCellArray> cells;
  for (vtkIdType t = 0; t < copy->GetNumberOfCells(); ++t)
  {
    const Triangle ids = trianglesOf(surface)[static_cast<std::size_t>(t)];
    const int bits = static_cast<int>(edges->GetComponent(t, 0));
    int turn = 0; // corners k, k + 1 are those of the first marked edge
    while (turn < 3 && (bits >> turn & 1) == 0)
    {
      ++turn;
    }
    turn = turn == 3 ? 0 : (turn + 3 - at) % 3;
    cells->InsertNextCell(
      { ids[std::size_t(turn)], ids[std::size_t(turn + 1) % 3], ids[std::size_t(turn + 2) % 3] });
    edges->SetComponent(t, 0, ((bits >> turn) | (bits << (3 - turn))) & 7);
  }
  copy->SetPolys(cells);
  return copy;
}

/// Whichever edge of its triangles a constraint is, natural neighbours end there.
TEST(InterpolationSurface, ConstraintsAtEachEdgeOfTheirTriangles)
{
  const auto points = scatteredPoints(60, 21);
  std::vector<Xyz> hilly = points;
  for (Xyz& p : hilly)
  {
    p[2] = std::sin(9 * p[0]) + std::cos(7 * p[1]);
  }
  // a Delaunay edge, so that no triangle is there because of it
  vtkNew<Delaunay> plain, marked;
  plain->SetInputData(makeCloud(hilly));
  plain->Update();
  const Triangle inside = trianglesOf(plain->GetOutput())[20];
  marked->SetInputData(makeCloud(hilly));
  marked->SetSourceData(makeSource({ { inside[0], inside[1] } }, {}));
  marked->GenerateConstraintEdgesOn();
  marked->Update();
  const auto sample = [](vtkPolyData* surface)
  {
    WatchedInterpolation filter;
    filter->SetInputData(surface);
    filter->SetMethodToNaturalNeighbor();
    filter->SetDimensions(60, 60);
    filter->Update();
    EXPECT_TRUE(filter.Said->Errors.empty());
    return numbersOf(filter->GetOutput(), "Elevation");
  };
  const auto expected = sample(turned(marked->GetOutput(), 0));
  EXPECT_FALSE(areSame(expected, sample(plain->GetOutput()), 1e-6)) << "the constraint has no say";
  for (const int at : { 1, 2 })
  {
    EXPECT_TRUE(areSame(expected, sample(turned(marked->GetOutput(), at)), 1e-12)) << at;
  }
  EXPECT_TRUE(areSame(expected, sample(marked->GetOutput()), 1e-12));
}

/// One that crosses itself in the plane is refused, with the number of triangles that do, of all
/// that it has.
TEST(InterpolationSurface, ThatFolds)
{
  vtkNew<Delaunay> delaunay;
  delaunay->SetInputData(makeCloud({ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 0, 3, 0 },
    { 1, 1, 0 }, { 20, 0, 0 }, { 6, 0, 0 }, { 6, 3, 0 } }));
  delaunay->SetMaximumEdgeLength(5.0); // the point far away has no triangle
  delaunay->Update();
  ASSERT_EQ(delaunay->GetOutput()->GetNumberOfPolys(), 6);
  vtkNew<vtkPolyData> folded;
  folded->DeepCopy(delaunay->GetOutput());
  folded->GetPoints()->SetPoint(4, -1, 1, 0); // behind an edge of the square
  WatchedInterpolation filter;
  filter->SetInputData(folded);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_NE(
    filter.Said->Errors[0].find("4 of the 6 triangles of the surface cross others in the plane"),
    std::string::npos)
    << filter.Said->Errors[0];
  folded->GetPoints()->SetPoint(4, 2, 2, 0);
  folded->Modified();
  filter->Update();
  EXPECT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_GT(filter->GetNumberOfValidPlaces(), 0);
}

TEST(InterpolationSurface, InAnotherPlane)
{
  expectTheSame(
    [](Delaunay* f)
    {
      f->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
      f->SetRimToConvexHull();
    },
    nullptr, { Filter::LINEAR }, true);
}

/// A plane is fitted to all points that the surface was made from, those without triangles too, and
/// not to those that were added; so is the raster that is announced.
TEST(InterpolationSurface, InThePlaneOfAllPoints)
{
  auto cloud = hills();
  for (const Xyz& far : { Xyz{ { 30, 0, -40 } }, Xyz{ { 31, 5, -60 } }, Xyz{ { 0, 40, 50 } } })
  {
    cloud->GetPoints()->InsertNextPoint(far.data());
  }
  cloud->GetPointData()->Initialize();
  auto source = makeSource({}, {}, { { { 0.5, 0.5, 3.0 } } });
  const auto set = [](Delaunay* f)
  {
    f->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
    f->SetMaximumEdgeLength(0.3);
    f->SetSourceModeToCoordinates();
  };
  vtkNew<Delaunay> delaunay;
  vtkNew<Messages> said; // of a source that constrains nothing
  said->Watch(delaunay);
  delaunay->SetInputData(cloud);
  delaunay->SetSourceData(source);
  WatchedInterpolation direct, behind;
  direct->SetInputData(cloud);
  direct->SetSourceData(source);
  for (Delaunay* f : { delaunay.Get(), direct->GetTriangulation(), behind->GetTriangulation() })
  {
    set(f);
  }
  behind->SetInputConnection(delaunay->GetOutputPort());
  for (WatchedInterpolation* filter : { &direct, &behind })
  {
    (*filter)->SetDimensions(700, 900);
    (*filter)->Update();
    EXPECT_TRUE(filter->Said->Errors.empty());
  }
  EXPECT_EQ(vtkPolyData::SafeDownCast(delaunay->GetOutput())->GetNumberOfPoints(), 1505);
  auto* const one = vtkImageData::SafeDownCast(direct->GetOutput());
  auto* const two = vtkImageData::SafeDownCast(behind->GetOutput());
  double announced[3];
  behind->GetOutputInformation(0)->Get(vtkDataObject::ORIGIN(), announced);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(one->GetOrigin()[k], two->GetOrigin()[k]);
    EXPECT_EQ(announced[k], two->GetOrigin()[k]);
    EXPECT_EQ(one->GetSpacing()[k], two->GetSpacing()[k]);
  }
  EXPECT_GT(direct->GetNumberOfValidPlaces(), 10);
  EXPECT_TRUE(areSame(numbersOf(one, "Elevation"), numbersOf(two, "Elevation"), 1e-12));
}

/// The memory that a refusal states is enough, and that of the triangles: one KiB less is refused
/// before they are looked at.
TEST(InterpolationSurface, TheMemoryThatARefusalStatesIsEnough)
{
  vtkNew<Delaunay> delaunay;
  delaunay->SetReuseLimit(0); // so that its own triangulation is gone
  delaunay->SetInputData(hills(20000));
  for (const double longest : { 0.0, 0.008 }) // all triangles, and some
  {
    delaunay->SetMaximumEdgeLength(longest);
    delaunay->Update();
    WatchedInterpolation filter;
    filter->SetDimensions(10, 10);
    filter->SetInputData(delaunay->GetOutput());
    filter->GetTriangulation()->SetMemoryLimit(1);
    filter->Update();
    const vtkTypeInt64 stated = filter->GetMemoryEstimate();
    filter->GetTriangulation()->SetMemoryLimit(stated - 1);
    filter->Update();
    EXPECT_EQ(filter->GetMemoryEstimate(), stated);
    EXPECT_EQ(filter->GetNumberOfTriangulations(), 0);
    EXPECT_EQ(filter.Said->Errors.size(), 2u);
    filter->GetTriangulation()->SetMemoryLimit(stated);
    filter->Update();
    EXPECT_EQ(filter->GetMemoryEstimate(), stated);
    EXPECT_EQ(filter->GetNumberOfPlaces(), 100);
    EXPECT_EQ(filter.Said->Errors.size(), 2u);
  }
}

/// Edges that become constraints, and their memory, are known when the triangles are looked up.
TEST(InterpolationSurface, MemoryOfConstraintsIsLimited)
{
  vtkNew<Delaunay> delaunay;
  delaunay->SetInputData(hills(20000));
  vtkNew<vtkPolyData> marked;
  delaunay->Update();
  marked->DeepCopy(delaunay->GetOutput());
  vtkNew<vtkUnsignedCharArray> edges;
  edges->SetName("ConstraintEdges");
  edges->SetNumberOfValues(marked->GetNumberOfCells());
  edges->Fill(7);
  marked->GetCellData()->AddArray(edges);
  WatchedInterpolation filter;
  filter->SetDimensions(10, 10);
  filter->SetInputData(delaunay->GetOutput());
  filter->Update();
  const vtkTypeInt64 without = filter->GetMemoryEstimate();
  filter->SetInputData(marked);
  filter->Update();
  const vtkTypeInt64 all = filter->GetMemoryEstimate();
  EXPECT_GT(all, without + 24 * 3 * 40000 / 1024 - 100);
  filter->GetTriangulation()->SetMemoryLimit(all - 1);
  filter->Update();
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_NE(filter.Said->Errors[0].find("MemoryLimit allows"), std::string::npos);
  filter->GetTriangulation()->SetMemoryLimit(all);
  filter->Update();
  EXPECT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_EQ(filter->GetNumberOfPlaces(), 100);
}

TEST(InterpolationSurface, IsKnownAgain)
{
  vtkNew<Delaunay> delaunay;
  delaunay->SetInputData(hills());
  delaunay->SetReuseLimit(0); // so that its own triangulation is gone
  delaunay->SetMaximumEdgeLength(0.1);
  delaunay->Update();
  WatchedInterpolation filter;
  vtkNew<vtkPolyData> copy; // as ParaView passes it on
  copy->ShallowCopy(delaunay->GetOutput());
  filter->SetInputData(copy);
  filter->Update();
  filter->SetMethodToNaturalNeighbor();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 1);
  const vtkIdType valid = filter->GetNumberOfValidPlaces();
  delaunay->SetMaximumEdgeLength(0.05); // fewer triangles of the same points
  delaunay->Update();
  copy->ShallowCopy(delaunay->GetOutput());
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTriangulations(), 2);
  EXPECT_LT(filter->GetNumberOfValidPlaces(), valid);
}

/// Triangles of other filters are ignored: the points count.
TEST(InterpolationSurface, OthersAreOnlyPoints)
{
  vtkNew<Delaunay> delaunay;
  delaunay->SetInputData(hills());
  delaunay->SetMaximumEdgeLength(0.05);
  delaunay->Update();
  vtkNew<vtkPolyData> without;
  without->CopyStructure(delaunay->GetOutput());
  WatchedInterpolation filter;
  filter->SetInputData(without);
  filter->Update();
  const vtkIdType all = filter->GetNumberOfValidPlaces();
  filter->SetInputData(delaunay->GetOutput());
  filter->Update();
  EXPECT_LT(filter->GetNumberOfValidPlaces(), all);
}

TEST(InterpolationSurface, TurnedOverItIsAnError)
{
  vtkNew<Delaunay> delaunay;
  delaunay->SetInputData(hills());
  delaunay->Update();
  vtkNew<vtkPolyData> turned;
  turned->DeepCopy(delaunay->GetOutput());
  for (vtkIdType i = 0; i < turned->GetNumberOfPoints(); ++i)
  {
    const double* p = turned->GetPoint(i);
    turned->GetPoints()->SetPoint(i, -p[0], p[1], p[2]);
  }
  WatchedInterpolation filter;
  filter->SetInputData(turned);
  filter->Update();
  ASSERT_EQ(filter.Said->Errors.size(), 1u);
  EXPECT_NE(filter.Said->Errors[0].find("inverted"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

} // namespace
