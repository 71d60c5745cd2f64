// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FeatureTestSupport_h
#define ahd_FeatureTestSupport_h

// Filters with everything switched on, in several combinations since not all go together, and their
// outputs as one string of bytes: for tests of properties that no feature may break.
#include "ConstraintTestSupport.h"
#include "FilterTestSupport.h"
#include "SettingRows.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <functional>
#include <string>
#include <vector>

namespace ahdtest
{

/// A way to use the filter: the input and the settings.
struct Feature
{
  const char* Name;
  std::function<void(vtkAdaptiveHilbertDelaunay2D*, std::size_t count)> SetUp;
};

/// Scattered points of which some are at the place of others, with heights, names and a ghost.
inline vtkSmartPointer<vtkPolyData> cloudWithAll(std::size_t count, int type = VTK_DOUBLE)
{
  std::vector<Xyz> places = scatteredPoints(count, 5);
  for (std::size_t i = 0; i < count; ++i)
  {
    places[i][0] *= 1000;
    places[i][1] *= 1000;
    places[i][2] = double(i % 17);
    if (i % 10 == 9)
    {
      places[i][0] = places[i - 5][0];
      places[i][1] = places[i - 5][1];
    }
  }
  auto cloud = makeCloud(places, type);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  for (std::size_t i = 0; i < count; ++i)
  {
    heights->InsertNextValue(0.5 * double(i));
    names->InsertNextValue("a name of point " + std::to_string(i));
    marks->InsertNextValue(i == 3 ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
  }
  cloud->GetPointData()->SetScalars(heights);
  cloud->GetPointData()->AddArray(names);
  cloud->GetPointData()->AddArray(marks);
  return cloud;
}

/// Lines that cross and a square with a hole, with points of their own, and some that name none.
inline vtkSmartPointer<vtkPolyData> sourceWithAll()
{
  return makeSource({ { 0, 1 }, { 2, 3 }, { 4, 99 } }, { { 5, 6, 7, 8 }, { 9, 10, 11 } },
    { { 100, 510, 1 }, { 900, 520, 2 }, { 500, 100, 3 }, { 510, 900, 4 }, { 20, 30, 0 },
      { 50, 50, 0 }, { 950, 50, 0 }, { 950, 950, 0 }, { 50, 950, 0 }, //
      { 600, 600, 0 }, { 600, 800, 0 }, { 800, 600, 0 } });
}

inline void generateAll(vtkAdaptiveHilbertDelaunay2D* filter)
{
  for (const SettingRow& row : kSettingRows)
  {
    if (std::string(row.Name).compare(0, 8, "Generate") == 0)
    {
      row.Set(filter, 1.0);
    }
  }
  filter->SetNmax(5);
}

/// Three tiles, of which one has ghost marks of its own.
inline vtkSmartPointer<vtkMultiBlockDataSet> tilesWithAll(std::size_t count)
{
  auto tiles = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned tile = 0; tile < 3; ++tile)
  {
    auto cloud = cloudWithAll(count / 3);
    vtkPoints* points = cloud->GetPoints();
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double p[3];
      points->GetPoint(i, p);
      points->SetPoint(i, p[0] + 990.0 * tile, p[1], p[2]);
    }
    if (tile != 1)
    {
      cloud->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    }
    tiles->SetBlock(tile, cloud);
  }
  return tiles;
}

inline void shrink(vtkAdaptiveHilbertDelaunay2D* filter)
{
  filter->SetAlpha(100.0);
  filter->AlphaLinesOn();
  filter->AlphaVertsOn();
}

inline std::vector<Feature> featuresInTheGivenPlane()
{
  using Filter = vtkAdaptiveHilbertDelaunay2D;
  return {
    { "plain",
      [](Filter* f, std::size_t n) { f->SetInputData(makeCloud(scatteredPoints(n), VTK_FLOAT)); } },
    { "ids",
      [](Filter* f, std::size_t n)
      {
        f->SetInputData(cloudWithAll(n));
        f->SetSourceData(makeSource({ { 0, 5, 11 }, { 7, 12 } }, { { 20, 21, 22 } }));
        f->SetDuplicatePolicy(Filter::MEAN_Z);
        generateAll(f);
        shrink(f);
      } },
    { "coordinates, split",
      [](Filter* f, std::size_t n)
      {
        f->SetInputData(cloudWithAll(n, VTK_INT));
        f->SetSourceData(sourceWithAll());
        f->SetSourceMode(Filter::SOURCE_COORDINATES);
        f->SetCrossingMode(Filter::SPLIT);
        f->SetFillRule(Filter::EVEN_ODD);
        f->SetTolerance(0.01);
        generateAll(f);
      } },
    { "coordinates, split, means",
      [](Filter* f, std::size_t n)
      {
        f->SetInputData(cloudWithAll(n));
        f->SetSourceData(sourceWithAll());
        f->SetSourceMode(Filter::SOURCE_COORDINATES);
        f->SetCrossingMode(Filter::SPLIT);
        f->SetDuplicatePolicy(Filter::MEAN_Z);
        f->SetMaximumEdgeLength(300.0);
        shrink(f);
      } },
  };
}

inline std::vector<Feature> featuresElsewhere()
{
  using Filter = vtkAdaptiveHilbertDelaunay2D;
  return {
    { "best fit",
      [](Filter* f, std::size_t n)
      {
        f->SetInputData(cloudWithAll(n));
        f->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
        f->SetDuplicatePolicy(Filter::HIGHEST_Z);
        f->SetSourceData(sourceWithAll());
        f->SetSourceMode(Filter::SOURCE_COORDINATES);
        f->SetVoronoiClip(Filter::CLIP_TO_BOUNDS);
        generateAll(f);
        shrink(f);
      } },
    { "transform",
      [](Filter* f, std::size_t n)
      {
        f->SetInputData(cloudWithAll(n, VTK_FLOAT));
        vtkNew<vtkTransform> transform;
        transform->RotateX(20.0);
        f->SetTransform(transform);
        f->SetInsertionOrder(Filter::MULTI_GRID);
        f->SetInsertionLimit(100);
        generateAll(f);
      } },
    { "bounding",
      [](Filter* f, std::size_t n)
      {
        f->SetInputData(cloudWithAll(n));
        f->BoundingTriangulationOn();
        f->SetDuplicatePolicy(Filter::LOWEST_Z);
        f->CountWorkOn();
        generateAll(f);
      } },
    { "blocks",
      [](Filter* f, std::size_t n)
      {
        f->MergeBlocksOn();
        f->SetInputDataObject(tilesWithAll(n));
        generateAll(f);
      } },
    { "collinear",
      [](Filter* f, std::size_t n)
      {
        std::vector<Xyz> places(n);
        for (std::size_t i = 0; i < n; ++i)
        {
          places[i] = { double(i), 2 * double(i), 0 };
        }
        f->SetInputData(makeCloud(places));
        f->SetSourceData(makeSource({ { 0, 1 } }, {}));
        f->SetVoronoiClip(Filter::CLIP_TO_BOUNDS);
        generateAll(f);
        shrink(f);
      } },
  };
}

/// Every feature of the filter occurs in one of them at least.
inline std::vector<Feature> allFeatures()
{
  std::vector<Feature> all = featuresInTheGivenPlane();
  for (const Feature& feature : featuresElsewhere())
  {
    all.push_back(feature);
  }
  return all;
}

inline void addBytes(vtkAbstractArray* array, std::string& bytes)
{
  bytes += array && array->GetName() ? array->GetName() : "-";
  if (!array)
  {
    return;
  }
  bytes += array->GetClassName() + std::to_string(array->GetNumberOfComponents()) + ":";
  bytes += std::to_string(array->GetNumberOfTuples()) + ":";
  if (array->IsNumeric())
  {
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
    return;
  }
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    bytes += array->GetVariantValue(i).ToString() + ";";
  }
}

inline void addBytes(vtkFieldData* data, std::string& bytes)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    addBytes(data->GetAbstractArray(i), bytes);
  }
}

/// All outputs of the filter, bit by bit, as a string.
inline std::string outputOf(vtkAdaptiveHilbertDelaunay2D* filter)
{
  std::string bytes;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
    addBytes(output->GetPoints() ? output->GetPoints()->GetData() : nullptr, bytes);
    for (vtkCellArray* cells : { output->GetVerts(), output->GetLines(), output->GetPolys() })
    {
      // without cells the type of the ids is VTK's choice
      addBytes(cells->GetNumberOfCells() > 0 ? cells->GetOffsetsArray() : nullptr, bytes);
      addBytes(cells->GetNumberOfCells() > 0 ? cells->GetConnectivityArray() : nullptr, bytes);
    }
    addBytes(output->GetPointData(), bytes);
    addBytes(output->GetCellData(), bytes);
    addBytes(output->GetFieldData(), bytes);
  }
  return bytes;
}

/// Points, cells and arrays of all outputs.
inline vtkIdType sizeOfOutput(vtkAdaptiveHilbertDelaunay2D* filter)
{
  vtkIdType size = 0;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
    size += output->GetNumberOfPoints() + output->GetNumberOfCells() +
      output->GetPointData()->GetNumberOfArrays() + output->GetCellData()->GetNumberOfArrays() +
      output->GetFieldData()->GetNumberOfArrays();
  }
  return size;
}

} // namespace ahdtest

#endif
