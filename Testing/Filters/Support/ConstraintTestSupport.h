// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ConstraintTestSupport_h
#define ahd_ConstraintTestSupport_h

#include "FilterTestSupport.h"

#include <algorithm>
#include <set>
#include <utility>

namespace ahdtest
{

using Chain = std::vector<vtkIdType>;

inline vtkSmartPointer<vtkCellArray> makeCells(const std::vector<Chain>& chains)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const Chain& chain : chains)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(chain.size()), chain.data());
  }
  return cells;
}

/// Lines and polygons, with points of their own if there are some.
inline vtkSmartPointer<vtkPolyData> makeSource(const std::vector<Chain>& lines,
  const std::vector<Chain>& polygons, const std::vector<Xyz>& points = {})
{
  auto source = makeCloud(points);
  source->SetLines(makeCells(lines));
  source->SetPolys(makeCells(polygons));
  return source;
}

/// The points (x, y) of a square of side `side` - 1; the id of (x, y) is x * side + y.
inline std::vector<Xyz> squareLattice(int side)
{
  std::vector<Xyz> points;
  for (int x = 0; x < side; ++x)
  {
    for (int y = 0; y < side; ++y)
    {
      points.push_back({ double(x), double(y), 0.0 });
    }
  }
  return points;
}

/// All triangles of `surface` together, in x and y.
inline double areaOf(vtkPolyData* surface)
{
  double area = 0.0;
  for (const Triangle& t : trianglesOf(surface))
  {
    double a[3], b[3], c[3];
    surface->GetPoint(t[0], a);
    surface->GetPoint(t[1], b);
    surface->GetPoint(t[2], c);
    area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  return area;
}

/// The edges of the triangles, smaller id first.
inline std::set<std::pair<vtkIdType, vtkIdType>> edgesOf(vtkPolyData* surface)
{
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  for (const Triangle& t : trianglesOf(surface))
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
    }
  }
  return edges;
}

inline bool hasEdge(vtkPolyData* surface, vtkIdType a, vtkIdType b)
{
  return edgesOf(surface).count(std::minmax(a, b)) == 1;
}

/// A watched filter that has run on points and a source.
struct ConstrainedFilter : WatchedFilter
{
  ConstrainedFilter(const std::vector<Xyz>& points, vtkPolyData* source)
  {
    this->Filter->SetInputData(makeCloud(points));
    this->Filter->SetSourceData(source);
  }
  vtkPolyData* Run()
  {
    this->Said->Warnings.clear();
    this->Said->Errors.clear();
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
};

} // namespace ahdtest

#endif
