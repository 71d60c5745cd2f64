// SPDX-License-Identifier: BSD-3-Clause
//
// Output port 2. Testing/Engine/Voronoi/Voronoi.cxx checks the cells; here, that they are output
// with the data of their points, and at their places.
#include "FilterTestSupport.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPolygon.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace
{

using ahdtest::idsOf;
using ahdtest::WatchedFilter;
using ahdtest::Xyz;

/// Of a polygon in the x, y plane; negative if it is clockwise.
double areaOf(vtkPolyData* cells, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  cells->GetCellPoints(cell, ids);
  double normal[3];
  const double area = vtkPolygon::ComputeArea(
    cells->GetPoints(), ids->GetNumberOfIds(), ids->GetPointer(0), normal);
  return normal[2] > 0.0 ? area : -area;
}

double wholeArea(vtkPolyData* cells)
{
  double area = 0.0;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    EXPECT_GT(areaOf(cells, cell), 0.0);
    area += areaOf(cells, cell);
  }
  return area;
}

vtkSmartPointer<vtkPolyData> cloudWithData(const std::vector<Xyz>& xyz)
{
  auto cloud = ahdtest::makeCloud(xyz);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  for (std::size_t i = 0; i < xyz.size(); ++i)
  {
    heights->InsertNextValue(0.5 * double(i));
    names->InsertNextValue("p" + std::to_string(i));
  }
  cloud->GetPointData()->SetScalars(heights);
  cloud->GetPointData()->AddArray(names);
  return cloud;
}

TEST(VoronoiOutput, IsEmptyUnlessAskedFor)
{
  WatchedFilter filter;
  filter->SetInputData(ahdtest::makeCloud(ahdtest::scatteredPoints(50)));
  filter->Update();
  EXPECT_EQ(filter->GetOutput(2)->GetNumberOfPoints(), 0);
  filter->GenerateVoronoiOn();
  filter->Update();
  EXPECT_EQ(filter->GetOutput(2)->GetNumberOfPolys(), 50);
  filter->GenerateVoronoiOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput(2)->GetNumberOfCells(), 0);
}

TEST(VoronoiOutput, CarriesThePointData)
{
  std::vector<Xyz> xyz = ahdtest::scatteredPoints(100);
  xyz[20] = xyz[10]; // has no cell of its own
  WatchedFilter filter;
  filter->SetInputData(cloudWithData(xyz));
  filter->GenerateVoronoiOn();
  filter->Update();
  vtkPolyData* cells = filter->GetOutput(2);
  ASSERT_EQ(cells->GetNumberOfPolys(), 99);
  vtkCellData* data = cells->GetCellData();
  const auto original = idsOf(data, "OriginalPointIds");
  ASSERT_EQ(original.size(), 99u);
  auto* heights = vtkDoubleArray::SafeDownCast(data->GetScalars());
  auto* names = vtkStringArray::SafeDownCast(data->GetAbstractArray("Name"));
  ASSERT_TRUE(heights && names);
  ASSERT_EQ(heights->GetNumberOfValues(), 99);
  for (std::size_t k = 0; k < 99; ++k)
  {
    EXPECT_EQ(original[k], vtkIdType(k < 20 ? k : k + 1));
    EXPECT_EQ(heights->GetValue(vtkIdType(k)), 0.5 * double(original[k]));
    EXPECT_EQ(names->GetValue(vtkIdType(k)), "p" + std::to_string(original[k]));
    EXPECT_GT(areaOf(cells, vtkIdType(k)), 0.0);
  }
  EXPECT_EQ(cells->GetPoints()->GetDataType(), VTK_DOUBLE);
}

TEST(VoronoiOutput, FillsHullOrBox)
{
  std::vector<Xyz> xyz = ahdtest::scatteredPoints(300);
  xyz.insert(xyz.end(), { { -1, 0.5, 0 }, { 0.5, -1, 0 }, { 2, 0.5, 0 }, { 0.5, 2, 0 } });
  WatchedFilter filter;
  filter->SetInputData(ahdtest::makeCloud(xyz));
  filter->GenerateVoronoiOn();
  filter->Update();
  EXPECT_NEAR(wholeArea(filter->GetOutput(2)), 4.5, 1e-12);
  filter->SetVoronoiClipToBounds();
  filter->Update();
  EXPECT_NEAR(wholeArea(filter->GetOutput(2)), 9.0, 1e-12);
}

/// Cells that are empty there are left out.
TEST(VoronoiOutput, FillsAPolygonOfOnesOwn)
{
  std::vector<Xyz> xyz = ahdtest::scatteredPoints(300); // within 0 to 1
  WatchedFilter filter;
  filter->SetInputData(cloudWithData(xyz));
  filter->GenerateVoronoiOn();
  filter->SetVoronoiClipToPolygon();
  filter->SetVoronoiPolygon("-1 -1, 3 0; 0.5 2.5");
  filter->Update();
  EXPECT_NEAR(wholeArea(filter->GetOutput(2)), 6.25, 1e-12);
  EXPECT_EQ(filter->GetOutput(2)->GetNumberOfCells(), 300);
  filter->SetVoronoiPolygon("0.75 0.25 0.25 0.5"); // a box
  filter->Update();
  vtkPolyData* const cells = filter->GetOutput(2);
  EXPECT_NEAR(wholeArea(cells), 0.125, 1e-14);
  EXPECT_LT(cells->GetNumberOfCells(), 100);
  const auto ids = idsOf(cells->GetCellData(), "OriginalPointIds");
  auto* heights = vtkDoubleArray::SafeDownCast(cells->GetCellData()->GetScalars());
  ASSERT_EQ(vtkIdType(ids.size()), cells->GetNumberOfCells());
  ASSERT_EQ(heights->GetNumberOfValues(), cells->GetNumberOfCells());
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    EXPECT_EQ(heights->GetValue(vtkIdType(k)), 0.5 * double(ids[k]));
    EXPECT_TRUE(k == 0 || ids[k - 1] < ids[k]);
  }
  for (const std::size_t count : { 1, 2 })
  {
    xyz.resize(count);
    filter->SetInputData(cloudWithData(xyz));
    filter->SetVoronoiPolygon("0, 0, 1, 1");
    filter->Update();
    EXPECT_EQ(filter->GetOutput(2)->GetNumberOfCells(), vtkIdType(count));
    EXPECT_NEAR(wholeArea(filter->GetOutput(2)), 1.0, 1e-15);
  }
  EXPECT_TRUE(filter.Said->Errors.empty());
}

TEST(VoronoiOutput, RefusesAPolygonThatIsNone)
{
  WatchedFilter filter;
  filter->SetInputData(ahdtest::makeCloud(ahdtest::scatteredPoints(20)));
  filter->SetVoronoiClipToPolygon();
  filter->Update();
  EXPECT_TRUE(filter.Said->Errors.empty()) << "there is no diagram";
  filter->GenerateVoronoiOn();
  const std::pair<const char*, const char*> texts[] = { { "", "has no area" },
    { "0 0, 1 1, 2 2", "has no area" }, { "3 0, 3 7", "has no area" },
    { "0 0, 1 0, 1 one", "has a coordinate that is not a finite number" },
    { "0 0, 1 0, 1 1e999", "has a coordinate that is not a finite number" },
    { "0 0, 1 0, 1 1, 5", "has a coordinate that is not a finite number" },
    { "0 0, 4 0, 4 4, 1 1, 0 4", "is not convex" }, { "0 0, 1 1, 1 0, 0 1", "is not convex" } };
  for (const auto& [text, fault] : texts)
  {
    filter.Said->Errors.clear();
    filter->SetVoronoiPolygon(text);
    filter->Update();
    ASSERT_EQ(filter.Said->Errors.size(), 1u) << text;
    EXPECT_NE(
      filter.Said->Errors[0].find(std::string("VoronoiPolygon ") + fault), std::string::npos)
      << filter.Said->Errors[0];
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  }
}

TEST(VoronoiOutput, IsThatOfThePointsWhateverIsDropped)
{
  const auto cloud = ahdtest::makeCloud(ahdtest::scatteredPoints(100));
  WatchedFilter plain;
  plain->SetInputData(cloud);
  plain->GenerateVoronoiOn();
  plain->Update();
  WatchedFilter other;
  other->SetInputData(cloud);
  other->GenerateVoronoiOn();
  other->SetAlpha(0.05);
  vtkNew<vtkPolyData> source;
  vtkNew<vtkCellArray> loops;
  const vtkIdType loop[] = { 3, 50, 71 };
  loops->InsertNextCell(3, loop);
  source->SetPolys(loops);
  other->SetSourceData(source);
  other->Update();
  EXPECT_NE(plain->GetNumberOfTriangles(), other->GetNumberOfTriangles());
  vtkPolyData* a = plain->GetOutput(2);
  vtkPolyData* b = other->GetOutput(2);
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(0.0, std::sqrt(vtkMath::Distance2BetweenPoints(a->GetPoint(i), b->GetPoint(i))));
  }
}

/// Vertices a few units in the last place apart near the border: no corner is farther from its own
/// vertex than from another.
TEST(VoronoiOutput, HasNoSpikesAlongTheBorder)
{
  const std::vector<Xyz> sets[] = {
    { { 10.499999999999998, 10.2, 0 }, { 10.499999999999998, 10.4, 0 },
      { 10.4, 10.299999999999999, 0 }, { 10.5, 10.2, 0 }, { 10.1, 10.4, 0 } },
    { { 431234.5, 431234.4999999999, 0 }, { 431234.39999999997, 431234.39999999997, 0 },
      { 431234.5, 431234.5, 0 }, { 431234.29999999993, 431234.4999999999, 0 },
      { 431234.1, 431234.4999999999, 0 } }
  };
  const auto distance = [](const double* p, const Xyz& q)
  { return std::hypot(p[0] - q[0], p[1] - q[1]); };
  for (const std::vector<Xyz>& xyz : sets)
  {
    for (const int clip : { 0, 1 })
    {
      WatchedFilter filter;
      filter->SetInputData(ahdtest::makeCloud(xyz));
      filter->GenerateVoronoiOn();
      filter->SetVoronoiClip(clip);
      filter->Update();
      vtkPolyData* cells = filter->GetOutput(2);
      const auto sites = idsOf(cells->GetCellData(), "OriginalPointIds");
      ASSERT_EQ(sites.size(), 5u);
      for (vtkIdType cell = 0; cell < 5; ++cell)
      {
        vtkPoints* corners = cells->GetCell(cell)->GetPoints();
        const Xyz& own = xyz[std::size_t(sites[std::size_t(cell)])];
        for (vtkIdType i = 0; i < corners->GetNumberOfPoints(); ++i)
        {
          for (const Xyz& other : xyz)
          {
            EXPECT_LE(distance(corners->GetPoint(i), own) - distance(corners->GetPoint(i), other),
              1e-15 * own[0])
              << "cell " << cell << ", corner " << i << ", clip " << clip;
          }
        }
      }
    }
  }
}

TEST(VoronoiOutput, LiesInThePlaneOfTheTriangulation)
{
  // x and z, far away; y is the height above the plane.
  std::vector<Xyz> xyz;
  for (const Xyz& p : ahdtest::scatteredPoints(200))
  {
    xyz.push_back({ p[0] + 500.0, 0.0, p[1] - 300.0 });
  }
  vtkNew<vtkTransform> transform;
  transform->RotateX(90.0); // y = -z, z = y
  for (const int mode : { VTK_SET_TRANSFORM_PLANE, VTK_BEST_FITTING_PLANE })
  {
    WatchedFilter filter;
    filter->SetInputData(ahdtest::makeCloud(xyz));
    filter->SetTransform(mode == VTK_SET_TRANSFORM_PLANE ? transform.Get() : nullptr);
    filter->SetProjectionPlaneMode(mode);
    filter->GenerateVoronoiOn();
    filter->Update();
    vtkPolyData* cells = filter->GetOutput(2);
    ASSERT_EQ(cells->GetNumberOfPolys(), 200);
    double bounds[6];
    cells->GetBounds(bounds);
    const double expected[6] = { 500.0, 501.0, 0.0, 0.0, -300.0, -299.0 };
    for (int k = 0; k < 6; ++k)
    {
      EXPECT_NEAR(bounds[k], expected[k], k == 2 || k == 3 ? 1e-9 : 0.05) << mode;
    }
    EXPECT_TRUE(filter.Said->Warnings.empty());
  }
}

TEST(VoronoiOutput, StaysInThePlaneIfThereIsNoWayBack)
{
  vtkNew<vtkTransform> flat;
  flat->Scale(1.0, 1.0, 0.0);
  WatchedFilter filter;
  filter->SetInputData(ahdtest::makeCloud(ahdtest::scatteredPoints(20)));
  filter->SetTransform(flat);
  filter->SetProjectionPlaneMode(VTK_SET_TRANSFORM_PLANE);
  filter->GenerateVoronoiOn();
  filter->Update();
  EXPECT_EQ(filter->GetOutput(2)->GetNumberOfPolys(), 20);
  ASSERT_EQ(filter.Said->Warnings.size(), 1u);
  EXPECT_NE(filter.Said->Warnings[0].find("no inverse"), std::string::npos);
}

TEST(VoronoiOutput, DoesNotCarryMarks)
{
  const auto cloud = ahdtest::makeCloud(ahdtest::scatteredPoints(20));
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  for (int i = 0; i < 20; ++i)
  {
    marks->InsertNextValue(i == 7 ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
  }
  cloud->GetPointData()->AddArray(marks);
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->GenerateVoronoiOn();
  filter->Update();
  EXPECT_EQ(filter->GetOutput(2)->GetNumberOfPolys(), 19);
  EXPECT_EQ(filter->GetOutput(2)->GetCellData()->GetNumberOfArrays(), 1);
}

TEST(VoronoiOutput, DoesNotCarryArraysWithTooFewValues)
{
  const std::vector<Xyz> xyz = ahdtest::scatteredPoints(2000);
  const auto cloud = cloudWithData(xyz);
  vtkNew<vtkStringArray> words;
  words->SetName("Words");
  words->InsertNextValue("one");
  words->InsertNextValue("two");
  vtkNew<vtkDoubleArray> few;
  few->SetName("Few");
  few->SetNumberOfValues(1999);
  few->FillValue(1.0);
  cloud->GetPointData()->AddArray(words);
  cloud->GetPointData()->AddArray(few);
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->GenerateVoronoiOn();
  filter->Update();
  vtkPolyData* cells = filter->GetOutput(2);
  ASSERT_EQ(cells->GetNumberOfPolys(), 2000);
  vtkCellData* data = cells->GetCellData();
  EXPECT_EQ(data->GetNumberOfArrays(), 3);
  for (const char* name : { "OriginalPointIds", "Height", "Name" })
  {
    ASSERT_TRUE(data->HasArray(name)) << name;
    EXPECT_EQ(data->GetAbstractArray(name)->GetNumberOfTuples(), 2000) << name;
  }
  EXPECT_EQ(data->GetScalars(), data->GetArray("Height"));
  EXPECT_TRUE(filter->GetOutput(0)->GetPointData()->HasArray("Words"));
}

TEST(VoronoiOutput, DoesNotCarryGlobalIds)
{
  const auto cloud = cloudWithData(ahdtest::scatteredPoints(20));
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Ids");
  ids->SetNumberOfValues(20);
  ids->FillValue(7);
  cloud->GetPointData()->SetGlobalIds(ids);
  WatchedFilter filter;
  filter->SetInputData(cloud);
  filter->GenerateVoronoiOn();
  filter->Update();
  EXPECT_EQ(filter->GetOutput(2)->GetCellData()->GetNumberOfArrays(), 3);
  EXPECT_FALSE(filter->GetOutput(2)->GetCellData()->HasArray("Ids"));
}

TEST(VoronoiOutput, OfFewOrCollinearPoints)
{
  WatchedFilter filter;
  filter->GenerateVoronoiOn();
  filter->SetInputData(ahdtest::makeCloud({ { 0, 0, 0 }, { 2, 1, 0 }, { 4, 2, 0 } }));
  filter->Update();
  EXPECT_EQ(filter->GetOutput(2)->GetNumberOfCells(), 0) << "the hull has no area";
  filter->SetVoronoiClipToBounds();
  filter->Update();
  EXPECT_EQ(filter->GetOutput(2)->GetNumberOfCells(), 3);
  EXPECT_NEAR(wholeArea(filter->GetOutput(2)), 8.0, 1e-14);
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_EQ(filter->GetOutput(2)->GetNumberOfCells(), 0);
}

}
