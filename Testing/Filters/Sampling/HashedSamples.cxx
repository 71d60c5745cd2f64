// SPDX-License-Identifier: BSD-3-Clause
#include "HashedSamples.h"

#include "ConstraintTestSupport.h"
#include "Hash.h"
#include "SampleTestSupport.h"

#include "Distributions.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"

#include <string>
#include <vector>

namespace ahdtest
{

using ahd::test::Distribution;
using ahd::test::Hash;
using Filter = vtkAdaptiveHilbertInterpolation2D;

namespace
{

void add(Hash& hash, vtkFieldData* data)
{
  hash.add(data->GetNumberOfArrays());
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    for (const char* letter = array->GetName(); *letter; ++letter)
    {
      hash.add(*letter);
    }
    hash.add(array->GetDataType());
    for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        const double value = array->GetComponent(k, c);
        hash.add(std::isnan(value) ? 0.5e-300 : value); // NaN has many bits
      }
    }
  }
}

void add(Hash& hash, vtkDataSet* data)
{
  hash.add(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    hash.add(ahd::Point{ p[0], p[1] });
    hash.add(p[2]);
  }
  add(hash, data->GetPointData());
  add(hash, data->GetFieldData());
}

/// Points of a distribution, of either precision, with heights and arrays of two types.
vtkSmartPointer<vtkPolyData> points(Distribution distribution, int type = VTK_DOUBLE)
{
  std::vector<Xyz> all;
  for (const ahd::Point& p : ahd::test::makePoints(distribution, 1500, 5))
  {
    all.push_back({ p.x, p.y, 0.1 * p.x - 0.3 * p.y });
  }
  auto made = makeCloud(all, type);
  addArray<vtkFloatArray>(made, "f", [](vtkIdType i) { return double(i % 7) / 3.0; });
  addArray<vtkIntArray>(made, "i", [](vtkIdType i) { return double(i % 5); });
  addArray<vtkDoubleArray>(
    made, "odd", [](vtkIdType i) { return i % 100 == 3 ? kNaN : double(i); });
  return made;
}

struct Case
{
  std::string name;
  vtkSmartPointer<vtkPolyData> input;
  std::function<void(Filter*)> set;
};

std::vector<Case> rasterCases()
{
  const auto mixed = points(Distribution::Mixed);
  const auto utm = points(Distribution::Utm, VTK_FLOAT);
  return { { "linear", mixed, [](Filter* f) { f->GenerateGradientsOn(); } },
    { "natural", mixed, [](Filter* f) { f->SetMethodToNaturalNeighbor(); } },
    { "laplace", mixed, [](Filter* f) { f->SetMethodToLaplace(); } },
    { "nearest", mixed, [](Filter* f) { f->SetMethodToNearest(); } },
    { "utm", utm,
      [](Filter* f)
      {
        f->SetRasterSizeToByCellSize();
        f->SetCellSize(17.3, 21.9);
        f->AlignToCellSizeOn();
      } },
    { "surface", mixed,
      [](Filter* f)
      {
        f->SetOutputTypeToSurface();
        f->SetNoValue(-9999.0);
      } },
    { "outside", mixed,
      [](Filter* f)
      {
        f->SetOutsideToNearestVertex();
        f->UseBoundsOn();
        f->SetBounds(-1, 2, -1, 2);
      } },
    { "alpha", mixed, [](Filter* f) { f->GetTriangulation()->SetAlpha(0.05); } },
    { "meanZ", mixed, [](Filter* f) { f->GetTriangulation()->SetDuplicatePolicyToMeanZ(); } } };
}

std::vector<Case> otherCases()
{
  const auto uniform = points(Distribution::Uniform);
  const auto line = points(Distribution::Line);
  const auto source = makeSource({ { 0, 700 }, { 5, 900, 30 } }, { { 11, 222, 333, 444 } });
  const auto places = points(Distribution::Cross, VTK_FLOAT);
  return { { "constraints", uniform,
             [source](Filter* f)
             {
               f->SetSourceData(source);
               f->SetMethodToNaturalNeighbor();
             } },
    { "split", uniform,
      [source](Filter* f)
      {
        f->SetSourceData(source);
        f->GetTriangulation()->SetCrossingModeToSplit();
      } },
    { "places", uniform,
      [places](Filter* f)
      {
        f->SetPlacesData(places);
        f->GenerateGradientsOn();
      } },
    { "bestFit", uniform,
      [places](Filter* f)
      {
        f->GetTriangulation()->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
        f->SetPlacesData(places);
      } },
    { "line", line, [](Filter* f) { f->SetMethodToLaplace(); } } };
}

std::string hashOf(
  const Case& given, const std::function<void()>& before, const std::function<void()>& after)
{
  WatchedInterpolation filter; // its messages are not printed
  given.set(filter.Filter);
  filter->SetInputData(given.input);
  filter->SetDimensions(61, 47);
  Hash hash;
  for (int run = 0; run < 2; ++run)
  {
    before();
    filter->Update();
    after();
    add(hash, filter->GetOutput());
    given.input->Modified();
  }
  return hash.text();
}

} // namespace

ahd::test::Hashes hashedSamples(
  const std::function<void()>& before, const std::function<void()>& after)
{
  ahd::test::Hashes result;
  for (const std::vector<Case>& cases : { rasterCases(), otherCases() })
  {
    for (const Case& given : cases)
    {
      result.push_back({ "sample/" + given.name, hashOf(given, before, after) });
    }
  }
  return result;
}

} // namespace ahdtest
