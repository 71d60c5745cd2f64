// SPDX-License-Identifier: BSD-3-Clause
//
// All outputs of the filter and the source of points, as hashes in Data/Hashes/Filter.txt: equal
// with every VTK and with any floating-point settings of a host program, which are restored.
#include "FilterTestSupport.h"
#include "Hash.h"
#include "HashFile.h"
#include "HashedSamples.h"
#include "HostModes.h"
#include "SettingRows.h"

#include "Distributions.h"
#include "Engine/Core/Threads.h"

#include "vtkAdaptiveHilbertQualityMesh2D.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlanarPointSource.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cfenv>
#include <functional>

namespace
{

using ahd::test::Distribution;
using ahd::test::Hash;
using ahd::test::Hashes;
using ahd::test::HostMode;
using ahdtest::Xyz;

const std::string kFile = AHD_HASHES_DIRECTORY "/Filter.txt";

void add(Hash& hash, vtkFieldData* data)
{
  hash.add(data->GetNumberOfArrays());
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    for (const char* letter = array->GetName(); letter && *letter; ++letter)
    {
      hash.add(*letter);
    }
    for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k)
    {
      const int size = array->GetNumberOfComponents();
      hash.add(array->GetComponent(k / size, int(k % size)));
    }
  }
}

void add(Hash& hash, vtkPolyData* data)
{
  hash.add(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    hash.add(ahd::Point{ p[0], p[1] });
    hash.add(p[2]);
  }
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    data->GetCellPoints(cell, size, ids);
    hash.add(data->GetCellType(cell));
    hash.add(std::vector<vtkIdType>(ids, ids + size));
  }
  add(hash, data->GetPointData());
  add(hash, data->GetCellData());
}

/// All but the seconds, the threads and the memory.
void addMeasures(Hash& hash, vtkAdaptiveHilbertDelaunay2D* filter)
{
  for (const vtkIdType count :
    { filter->GetNumberOfPointsInserted(), filter->GetNumberOfDuplicates(),
      filter->GetNumberOfRejectedPoints(), filter->GetNumberOfSkippedPoints(),
      filter->GetNumberOfPointsBeyondLimit(), filter->GetNumberOfTriangles(),
      filter->GetNumberOfMergedPoints(), filter->GetNumberOfAddedPoints(),
      filter->GetNumberOfConstraintEdges(), filter->GetNumberOfCrossings(),
      filter->GetNumberOfConstraintsLeftOut(), filter->GetNumberOfUnfilledLoops() })
  {
    hash.add(count);
  }
  hash.add(filter->GetNP());
  hash.add(filter->GetNR());
}

/// Points of a distribution with heights, some of them at the same x, y.
std::vector<Xyz> heights(Distribution distribution, std::size_t count)
{
  ahd::test::Random random(3);
  std::vector<Xyz> result;
  for (const ahd::Point& p : ahd::test::makePoints(distribution, count, 5))
  {
    result.push_back({ p.x, p.y, 0.1 * p.x - 0.3 * p.y + 0.01 * random.unit() });
  }
  for (std::size_t i = 0; i < count / 10; ++i)
  {
    result.push_back(result[i]);
    result.back()[2] += random.unit();
  }
  return result;
}

vtkSmartPointer<vtkPolyData> cloudOf(const std::vector<Xyz>& xyz, int type = VTK_DOUBLE)
{
  auto cloud = ahdtest::makeCloud(xyz, type);
  vtkNew<vtkDoubleArray> thirds;
  thirds->SetName("thirds");
  for (std::size_t i = 0; i < xyz.size(); ++i)
  {
    thirds->InsertNextValue(double(i) / 3.0);
  }
  cloud->GetPointData()->AddArray(thirds);
  return cloud;
}

/// Polylines between any of the points, and a loop about the middle.
vtkSmartPointer<vtkPolyData> someLines(vtkPolyData* cloud, std::size_t count)
{
  ahd::test::Random random(4);
  auto source = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> lines;
  const auto any = [&] { return vtkIdType(random.below(std::size_t(cloud->GetNumberOfPoints()))); };
  for (std::size_t i = 0; i < count; ++i)
  {
    const vtkIdType from = any();
    const vtkIdType ids[] = { from, any() };
    lines->InsertNextCell(2, ids);
  }
  source->SetPoints(cloud->GetPoints());
  source->SetLines(lines);
  return source;
}

vtkSmartPointer<vtkTransform> tilted()
{
  const double rows[16] = { 0.36, 0.48, -0.8, 1.5, -0.8, 0.6, 0.0, 0.25, 0.48, 0.64, 0.6, -3.0, 0.0,
    0.0, 0.0, 1.0 };
  auto transform = vtkSmartPointer<vtkTransform>::New();
  transform->SetMatrix(rows);
  return transform;
}

struct Case
{
  std::string name;
  vtkSmartPointer<vtkDataObject> input;
  std::function<void(vtkAdaptiveHilbertDelaunay2D*)> set;
};

std::vector<Case> plainCases()
{
  using Filter = vtkAdaptiveHilbertDelaunay2D*;
  const auto mixed = cloudOf(heights(Distribution::Mixed, 1500));
  const auto singles = cloudOf(heights(Distribution::Utm, 1500), VTK_FLOAT);
  const auto tiny = cloudOf(heights(Distribution::Tiny, 300));
  return { { "plain", mixed, [](Filter f) { f->CountWorkOn(); } },
    { "float", singles, [](Filter) {} }, { "tiny", tiny, [](Filter f) { f->GenerateVoronoiOn(); } },
    { "arrays", mixed,
      [](Filter f)
      {
        f->GenerateFateOn();
        f->GenerateNeighborsOn();
        f->GenerateInsertionRankOn();
        f->GenerateInsertionCurveOn();
        f->GenerateBoxesOn();
        f->GenerateVoronoiOn();
      } },
    { "voronoiInBox", singles,
      [](Filter f)
      {
        f->GenerateVoronoiOn();
        f->SetVoronoiClipToBounds();
      } },
    { "alpha", mixed, [](Filter f) { f->SetAlpha(0.02); } },
    { "maximumEdgeLength", mixed, [](Filter f) { f->SetMaximumEdgeLength(0.05); } },
    { "tolerance", mixed, [](Filter f) { f->SetTolerance(0.01); } },
    { "bounding", mixed,
      [](Filter f)
      {
        f->BoundingTriangulationOn();
        f->SetOffset(1.3);
      } },
    { "meanZ", mixed, [](Filter f) { f->SetDuplicatePolicyToMeanZ(); } },
    { "highestZ", singles, [](Filter f) { f->SetDuplicatePolicyToHighestZ(); } } };
}

std::vector<Case> planesAndSources()
{
  using Filter = vtkAdaptiveHilbertDelaunay2D*;
  const auto uniform = cloudOf(heights(Distribution::Uniform, 1200));
  const auto singles = cloudOf(heights(Distribution::Cross, 1200), VTK_FLOAT);
  const auto lines = someLines(uniform, 30);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, uniform);
  blocks->SetBlock(1, singles);
  return { { "bestFit", uniform,
             [](Filter f) { f->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE); } },
    { "bestFitFloat", singles,
      [](Filter f) { f->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE); } },
    { "transform", uniform,
      [](Filter f)
      {
        f->SetProjectionPlaneMode(VTK_SET_TRANSFORM_PLANE);
        f->SetTransform(tilted());
      } },
    { "constraints", uniform,
      [lines](Filter f)
      {
        f->SetSourceData(lines);
        f->GenerateConstraintEdgesOn();
        f->GenerateRegionIdsOn();
      } },
    { "everyOutput", uniform,
      [lines](Filter f)
      {
        f->SetSourceData(lines);
        for (const ahdtest::SettingRow& row : ahdtest::kSettingRows)
        {
          if (std::string(row.Name).rfind("Generate", 0) == 0)
          {
            row.Set(f, 1.0);
          }
        }
      } },
    { "split", uniform,
      [lines](Filter f)
      {
        f->SetSourceData(lines);
        f->SetCrossingModeToSplit();
      } },
    { "coordinates", singles,
      [lines](Filter f)
      {
        f->SetSourceData(lines);
        f->SetSourceModeToCoordinates();
        f->SetCrossingModeToSplit();
      } },
    { "blocks", blocks, [](Filter f) { f->MergeBlocksOn(); } } };
}

/// Runs it twice, the second time on the kept triangulation, between `before` and `after`.
std::string hashOf(
  const Case& given, const std::function<void()>& before, const std::function<void()>& after)
{
  ahdtest::WatchedFilter filter; // its messages are not printed
  given.set(filter.Filter);
  filter->SetInputDataObject(given.input);
  filter->KeepTriangulationOn();
  Hash hash;
  for (int run = 0; run < 2; ++run)
  {
    before();
    filter->Update();
    after();
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      add(hash, vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port)));
    }
    addMeasures(hash, filter.Filter);
    given.input->Modified();
  }
  return hash.text();
}

struct MeshCase
{
  std::string name;
  vtkSmartPointer<vtkPolyData> input;
  std::function<void(vtkAdaptiveHilbertQualityMesh2D*)> set;
};

std::vector<MeshCase> meshCases()
{
  using Filter = vtkAdaptiveHilbertQualityMesh2D*;
  const auto uniform = cloudOf(heights(Distribution::Uniform, 400));
  const auto singles = cloudOf(heights(Distribution::Cross, 400), VTK_FLOAT);
  const auto lines = someLines(uniform, 12);
  vtkNew<vtkDoubleArray> sizes;
  sizes->SetName("sizes");
  for (vtkIdType i = 0; i < uniform->GetNumberOfPoints(); ++i)
  {
    sizes->InsertNextValue(0.02 + double(i) / 5000.0);
  }
  uniform->GetPointData()->AddArray(sizes);
  return { { "angle", singles, [](Filter f) { f->SetMinimumAngle(28); } },
    { "split", uniform,
      [lines](Filter f)
      {
        f->SetSourceData(lines);
        f->GetTriangulation()->SetCrossingModeToSplit();
        f->SetMaximumLength(0.05);
      } },
    { "sizes", uniform,
      [](Filter f)
      {
        f->SetSizeArrayName("sizes");
        f->SetMaximumNumberOfAddedPoints(150);
      } },
    { "bestFit", uniform,
      [](Filter f)
      {
        f->GetTriangulation()->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
        f->SetMaximumArea(0.002);
      } } };
}

std::string hashOfMesh(
  const MeshCase& given, const std::function<void()>& before, const std::function<void()>& after)
{
  vtkNew<vtkAdaptiveHilbertQualityMesh2D> mesh;
  vtkNew<ahdtest::Messages> said; // its messages are not printed
  said->Watch(mesh);
  given.set(mesh);
  mesh->SetInputData(given.input);
  before();
  mesh->Update();
  after();
  Hash hash;
  add(hash, mesh->GetOutput(0));
  add(hash, mesh->GetOutput(1));
  add(hash, mesh->GetOutput(0)->GetFieldData());
  hash.add(mesh->GetLeastAngle());
  return hash.text();
}

std::string hashOfSource(int distribution, int precision, const std::function<void()>& before,
  const std::function<void()>& after)
{
  vtkNew<vtkPlanarPointSource> source;
  source->SetDistribution(distribution);
  source->SetOutputPointsPrecision(precision);
  source->SetNumberOfPoints(40000);
  before();
  source->Update();
  after();
  Hash hash;
  add(hash, source->GetOutput());
  return hash.text();
}

void nothing() {}

Hashes allHashes(
  const std::function<void()>& before = nothing, const std::function<void()>& after = nothing)
{
  Hashes result;
  for (const std::vector<Case>& cases : { plainCases(), planesAndSources() })
  {
    for (const Case& given : cases)
    {
      result.push_back({ "surface/" + given.name, hashOf(given, before, after) });
    }
  }
  for (int d = vtkPlanarPointSource::UNIFORM; d <= vtkPlanarPointSource::LATTICE; ++d)
  {
    const int precision = d % 2 == 0 ? vtkAlgorithm::SINGLE_PRECISION
                                     : vtkAlgorithm::DOUBLE_PRECISION;
    result.push_back({ "source/" + std::to_string(d), hashOfSource(d, precision, before, after) });
  }
  const Hashes samples = ahdtest::hashedSamples(before, after);
  result.insert(result.end(), samples.begin(), samples.end());
  for (const MeshCase& given : meshCases())
  {
    result.push_back({ "mesh/" + given.name, hashOfMesh(given, before, after) });
  }
  return result;
}

TEST(Hashes, AreThoseOfTheRepository)
{
  const std::string changed = ahd::test::differencesFromFile(kFile, allHashes());
  EXPECT_TRUE(changed.empty()) << changed;
}

TEST(Hashes, NoModeOfTheHostChangesOne)
{
  const Hashes expected = allHashes();
  for (const HostMode& mode : ahd::test::hostModes())
  {
    if (mode.traps != 0)
    {
      continue; // VTK's own pipeline computes with them
    }
    const auto after = [&]
    {
      const bool isKept = ahd::test::isIn(mode);
      ahd::test::leaveHostMode();
      EXPECT_TRUE(isKept) << mode.name;
    };
    const Hashes found = allHashes([&] { ahd::test::enter(mode); }, after);
    EXPECT_EQ(ahd::test::differences(expected, found), "") << mode.name;
  }
}

/// Threads may be shared: those started here begin with the mode of the caller.
TEST(Hashes, ThreadsComputeAsTheEngineDoes)
{
  const HostMode asPrograms = { "", FE_TONEAREST, 0, 0 };
  for (const HostMode& mode : ahd::test::hostModes())
  {
    std::atomic<int> tasks{ 0 }, wrong{ 0 };
    ahd::test::enter(mode);
    {
      ahd::Threads executor(3);
      const auto task = [&](std::size_t)
      {
        ++tasks;
        wrong += ahd::test::isIn(asPrograms) ? 0 : 1;
      };
      executor.run(100, task, nothing);
    }
    const bool isKept = ahd::test::isIn(mode);
    ahd::test::leaveHostMode();
    EXPECT_TRUE(isKept) << mode.name;
    EXPECT_EQ(tasks, 100);
    EXPECT_EQ(wrong, 0) << mode.name;
  }
}

TEST(Hashes, AbortedTheModeIsPutBackToo)
{
  for (const HostMode& mode : ahd::test::hostModes())
  {
    if (mode.traps != 0)
    {
      continue;
    }
    vtkNew<vtkAdaptiveHilbertDelaunay2D> filter;
    filter->SetInputData(cloudOf(heights(Distribution::Uniform, 40000)));
    vtkNew<vtkCallbackCommand> abort;
    abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
      { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
    filter->AddObserver(vtkCommand::ProgressEvent, abort);
    ahd::test::enter(mode);
    filter->Update();
    const bool isKept = ahd::test::isIn(mode);
    ahd::test::leaveHostMode();
    EXPECT_TRUE(isKept) << mode.name;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  }
}

TEST(Hashes, NoModeChangesThePlaneComputed)
{
  const auto cloud = cloudOf(heights(Distribution::Mixed, 2000));
  const auto rows = [&]
  {
    const auto plane = vtkSmartPointer<vtkAbstractTransform>::Take(
      vtkAdaptiveHilbertDelaunay2D::ComputeBestFittingPlane(cloud));
    return vtkSmartPointer<vtkTransform>(vtkTransform::SafeDownCast(plane));
  };
  const auto expected = rows();
  for (const HostMode& mode : ahd::test::hostModes())
  {
    ahd::test::enter(mode);
    const auto found = rows();
    const bool isKept = ahd::test::isIn(mode);
    ahd::test::leaveHostMode();
    EXPECT_TRUE(isKept) << mode.name;
    for (int i = 0; i < 16; ++i)
    {
      EXPECT_EQ(found->GetMatrix()->GetElement(i / 4, i % 4),
        expected->GetMatrix()->GetElement(i / 4, i % 4))
        << mode.name;
    }
  }
}

} // namespace
