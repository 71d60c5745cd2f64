// SPDX-License-Identifier: BSD-3-Clause
//
// The longest delay of an abort: the longest processor time, on one thread, between two polls of
// the filter, from the beginning of Update() to its end. For settings that take every step, on
// points of every kind. A row each, and the largest gap of each setting last.
//   AbortGaps [--points=1000000] [--settings=voronoi,split,...] [--distributions=Uniform,...]
#include "Distributions.h"

#include <vtkAdaptiveHilbertDelaunay2D.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace
{

using ahd::test::Distribution;

double processSeconds()
{
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// Records the times of polls for an abort.
class AskedFilter : public vtkAdaptiveHilbertDelaunay2D
{
public:
  static AskedFilter* New() { VTK_STANDARD_NEW_BODY(AskedFilter); }
  vtkTypeMacro(AskedFilter, vtkAdaptiveHilbertDelaunay2D);

  int GetAbortExecute() override
  {
    this->Note();
    return this->Superclass::GetAbortExecute();
  }
  void Note()
  {
    const double now = processSeconds();
    if (this->Last > 0.0 && now - this->Last > this->Gap)
    {
      this->Gap = now - this->Last;
      this->GapEndsAt = this->GetProgress();
    }
    this->Last = now;
    ++this->Askings;
  }

  double Last = 0.0;
  double Gap = 0.0;       // seconds
  double GapEndsAt = 0.0; // as part of the whole
  long Askings = 0;
};

/// Segments between points of the source, which are places among those of the input.
void addSegments(vtkPolyData* source, const std::vector<ahd::Point>& among, std::size_t count)
{
  std::mt19937_64 random(count);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (std::size_t i = 0; i < count; ++i)
  {
    lines->InsertNextCell(2);
    for (int end = 0; end < 2; ++end)
    {
      const ahd::Point& p = among[random() % among.size()];
      lines->InsertCellPoint(points->InsertNextPoint(p.x, p.y, 0.0));
    }
  }
  source->SetPoints(points);
  source->SetLines(lines);
}

/// A polygon of so many corners: the places by their angle around the first.
void addLoop(vtkPolyData* source, std::vector<ahd::Point> corners, std::size_t count)
{
  corners.resize(std::min(corners.size(), count));
  std::sort(corners.begin(), corners.end(),
    [](const ahd::Point& p, const ahd::Point& q)
    { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(static_cast<vtkIdType>(corners.size()));
  for (const ahd::Point& p : corners)
  {
    polygons->InsertCellPoint(points->InsertNextPoint(p.x, p.y, 0.0));
  }
  source->SetPoints(points);
  source->SetPolys(polygons);
}

using Filter = vtkAdaptiveHilbertDelaunay2D;

struct Setting
{
  const char* name;
  void (*set)(Filter*);
  std::size_t segments = 0;
  std::size_t corners = 0;
};

const Setting kSettings[] = {
  { "plain", [](Filter*) {} },
  { "arrays",
    [](Filter* f)
    {
      f->GenerateNeighborsOn();
      f->GenerateRegionIdsOn();
      f->GenerateConstraintEdgesOn();
      f->GeneratePointStatusOn();
      f->GenerateInsertionRankOn();
    } },
  { "alpha", [](Filter* f) { f->SetAlpha(1e-3); } },
  { "order",
    [](Filter* f)
    {
      f->SetInsertionOrderToMultiGrid();
      f->SetNmax(1);
      f->GenerateBoxesOn();
      f->GenerateInsertionCurveOn();
    } },
  { "as-given", [](Filter* f) { f->SetInsertionOrderToAsGiven(); } },
  { "voronoi", [](Filter* f) { f->GenerateVoronoiOn(); } },
  { "voronoi-bounds",
    [](Filter* f)
    {
      f->GenerateVoronoiOn();
      f->SetVoronoiClipToBounds();
    } },
  { "tolerance", [](Filter* f) { f->SetTolerance(1e-4); } },
  { "means", [](Filter* f) { f->SetDuplicatePolicyToMeanZ(); } },
  { "plane",
    [](Filter* f)
    {
      f->SetProjectionPlaneMode(VTK_BEST_FITTING_PLANE);
      f->GenerateVoronoiOn();
    } },
  { "lines", [](Filter* f) { f->SetSourceModeToCoordinates(); }, 1000 },
  { "loop", [](Filter* f) { f->SetSourceModeToCoordinates(); }, 0, 100000 },
  { "heights",
    [](Filter* f)
    {
      f->SetSourceModeToCoordinates();
      f->SetSourceHeightsToFromSurface();
    },
    1000 },
  { "split",
    [](Filter* f)
    {
      f->SetSourceModeToCoordinates();
      f->SetCrossingModeToSplit();
    },
    1000 },
};

vtkSmartPointer<vtkPolyData> cloud(const std::vector<ahd::Point>& places)
{
  vtkNew<vtkDoubleArray> xyz;
  xyz->SetNumberOfComponents(3);
  xyz->SetNumberOfTuples(static_cast<vtkIdType>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const ahd::Point& p = places[i];
    xyz->SetTuple3(static_cast<vtkIdType>(i), p.x, p.y, 0.25 * p.x + 0.5 * p.y);
  }
  vtkNew<vtkPoints> points;
  points->SetData(xyz);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

double measure(const Setting& setting, Distribution distribution, std::size_t count)
{
  const std::vector<ahd::Point> places = ahd::test::makePoints(distribution, count, 1);
  vtkNew<AskedFilter> filter;
  filter->SetNumberOfThreads(1);
  filter->SetInputData(cloud(places));
  vtkNew<vtkPolyData> source;
  if (setting.segments > 0)
  {
    addSegments(source, places, setting.segments);
    filter->SetSourceData(source);
  }
  if (setting.corners > 0)
  {
    addLoop(source, places, setting.corners);
    filter->SetSourceData(source);
  }
  setting.set(filter);
  const double begin = processSeconds();
  filter->Last = begin;
  filter->Update();
  filter->Note();
  std::printf("%-16s %-16s %8.2f s in all, %8ld askings, longest gap %7.1f ms, ends at %5.3f\n",
    setting.name, nameOf(distribution), processSeconds() - begin, filter->Askings,
    1e3 * filter->Gap, filter->GapEndsAt);
  std::fflush(stdout);
  return filter->Gap;
}

bool isAmong(const std::string& names, const char* name)
{
  return names.empty() || ("," + names + ",").find("," + std::string(name) + ",") != names.npos;
}

} // namespace

int main(int argc, char** argv)
{
  std::map<std::string, std::string> given;
  for (int i = 1; i < argc; ++i)
  {
    const std::string text = argv[i];
    given[text.substr(0, text.find('='))] = text.substr(std::min(text.size(), text.find('=') + 1));
  }
  const double count = given.count("--points") ? std::atof(given["--points"].c_str()) : 1e6;
  vtkObject::GlobalWarningDisplayOff();
  std::map<std::string, double> longest;
  for (const Setting& setting : kSettings)
  {
    for (int d = 0; d <= int(Distribution::AnyFinite); ++d)
    {
      const auto distribution = static_cast<Distribution>(d);
      if (isAmong(given["--settings"], setting.name) &&
        isAmong(given["--distributions"], nameOf(distribution)))
      {
        double& most = longest[setting.name];
        most = std::max(most, measure(setting, distribution, std::size_t(count)));
      }
    }
  }
  for (const auto& row : longest)
  {
    std::printf("| %s | %.0f |\n", row.first.c_str(), 1e3 * row.second);
  }
  return 0;
}
