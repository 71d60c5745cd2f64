// SPDX-License-Identifier: BSD-3-Clause
#include "FilterJudge.h"

#include "ExactSigns.h"
#include "FilterArrays.h"
#include "SimplifiedJudge.h"

#include "vtkAdaptiveHilbertDelaunay2D.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace ahd
{
namespace fuzz
{

const vtkIdTypeArray* idsOf(vtkFieldData* data, const char* name)
{
  return vtkIdTypeArray::SafeDownCast(data->GetAbstractArray(name));
}

vtkIdType countOf(vtkPolyData* surface, const char* what)
{
  const std::string name = std::string("NumberOf") + what;
  const auto* count = idsOf(surface->GetFieldData(), name.c_str());
  return count && count->GetNumberOfValues() == 1 ? count->GetValue(0) : -1;
}

std::string faultOfCells(vtkCellArray* cells, vtkIdType points, vtkIdType least, vtkIdType most)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, ids);
    if (ids->GetNumberOfIds() < least || ids->GetNumberOfIds() > most)
    {
      return "a cell of " + std::to_string(ids->GetNumberOfIds()) + " points";
    }
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      if (ids->GetId(i) < 0 || ids->GetId(i) >= points)
      {
        return "a cell with the id " + std::to_string(ids->GetId(i));
      }
    }
  }
  return "";
}

std::string faultOfArrays(vtkDataSetAttributes* data, vtkIdType count)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const vtkIdType tuples = data->GetAbstractArray(i)->GetNumberOfTuples();
    if (tuples != count)
    {
      return "an array of " + std::to_string(tuples) + " tuples for " + std::to_string(count);
    }
  }
  return "";
}

std::string faultOfTriangles(vtkPolyData* surface, bool inPlane)
{
  vtkCellArray* triangles = surface->GetPolys();
  if (triangles->GetNumberOfCells() != countOf(surface, "Triangles"))
  {
    return "another number of triangles than is said";
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells() && inPlane; ++cell)
  {
    triangles->GetCellAtId(cell, ids);
    std::array<Point, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double* p = surface->GetPoint(ids->GetId(static_cast<vtkIdType>(i)));
      corners[i] = { p[0], p[1] };
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
      {
        return "a triangle with a corner nowhere";
      }
    }
    if (test::orientSign(corners[0], corners[1], corners[2]) <= 0)
    {
      return "a triangle that is not counterclockwise";
    }
  }
  return "";
}

namespace
{

std::string textOf(const char* name, vtkCellArray* cells)
{
  std::string text = name;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      text += " " + std::to_string(ids->GetId(i));
    }
    text += ",";
  }
  return text + "\n";
}

/// Arrays of the filter that are mistaken for one of the input.
std::string faultOfAttributes(vtkPointData* data, vtkAdaptiveHilbertDelaunay2D* filter)
{
  for (int k = 0; k < vtkDataSetAttributes::NUM_ATTRIBUTES; ++k)
  {
    vtkAbstractArray* active = data->GetAbstractAttribute(k);
    const std::string name = active && active->GetName() ? active->GetName() : "";
    if ((name == "Fate" && filter->GetGenerateFate()) ||
      (name == "Error" && filter->GetGenerateErrors()) ||
      (name == "OriginalPointIds" && hasPointsOfCellsOnly(filter)) ||
      (name == "InsertionRank" && filter->GetGenerateInsertionRank()))
    {
      return name + " as another attribute";
    }
  }
  return "";
}

std::string faultOfFates(vtkPolyData* surface)
{
  const auto* fates = idsOf(surface->GetPointData(), "Fate");
  vtkIdType vertices = 0, others = 0, rejected = 0, out = 0, within = 0;
  for (vtkIdType i = 0; i < fates->GetNumberOfValues(); ++i)
  {
    const vtkIdType fate = fates->GetValue(i);
    if (fate < -3 || fate >= fates->GetNumberOfValues() ||
      (fate >= 0 && fates->GetValue(fate) != fate))
    {
      return "a fate that is no vertex: " + std::to_string(fate);
    }
    vertices += fate == i;
    others += fate >= 0 && fate != i;
    rejected += fate == -1;
    out += fate == -2;
    within += fate == -3;
  }
  const bool fit = vertices == countOf(surface, "PointsInserted") &&
    rejected == countOf(surface, "RejectedPoints");
  // points that duplicate or are merged into a point beyond the limit are out, too, and those
  // merged into one within the error are so
  const vtkIdType merged = countOf(surface, "MergedPoints");
  const vtkIdType doubles = countOf(surface, "Duplicates") + merged;
  const vtkIdType beyond = countOf(surface, "PointsBeyondLimit");
  const vtkIdType less = countOf(surface, "PointsWithinError");
  const bool lessFit = within >= less && within <= less + (less > 0 ? merged : 0);
  const bool doubleFit = beyond > 0 ? others <= doubles : others == doubles - (within - less);
  const bool sumFits = others + out + within ==
    doubles + beyond + less + countOf(surface, "SkippedPoints");
  return fit && lessFit && doubleFit && sumFits ? "" : "fates that are not as many as the counts";
}

std::string faultOfSurface(vtkPolyData* surface, vtkAdaptiveHilbertDelaunay2D* filter)
{
  const vtkIdType points = surface->GetNumberOfPoints();
  std::string fault;
  const auto add = [&fault](const std::string& other) { fault = fault.empty() ? other : fault; };
  add(faultOfCells(surface->GetVerts(), points, 1, 1));
  add(faultOfCells(surface->GetLines(), points, 2, 2));
  add(faultOfCells(surface->GetPolys(), points, 3, 3));
  add(faultOfArrays(surface->GetCellData(), surface->GetNumberOfCells()));
  if (!fault.empty() || countOf(surface, "PointsInserted") < 0)
  {
    return !fault.empty() ? fault : points > 0 ? "points that nobody counted" : "";
  }
  vtkIdType sum = 0;
  for (const char* what : { "PointsInserted", "Duplicates", "RejectedPoints", "SkippedPoints",
         "PointsBeyondLimit", "MergedPoints", "PointsWithinError" })
  {
    sum += countOf(surface, what);
  }
  const bool areAll = !hasPointsOfCellsOnly(filter);
  add(areAll ? sum == points ? "" : "counts that do not add up to the points"
             : faultOfPointsOfCells(surface, sum));
  const bool inPlane = filter->GetProjectionPlaneMode() != VTK_BEST_FITTING_PLANE &&
    !filter->GetTransform();
  add(faultOfTriangles(surface, inPlane));
  add(faultOfAttributes(surface->GetPointData(), filter));
  if (filter->GetGenerateFate())
  {
    add(faultOfFates(surface));
  }
  if (countOf(surface, "AddedPoints") > 0)
  {
    add(faultOfArrays(surface->GetPointData(), points));
  }
  return fault;
}

/// The second and the third output.
std::string faultOfOther(vtkPolyData* data, vtkIdType least)
{
  const vtkIdType points = data->GetNumberOfPoints();
  std::string fault = faultOfCells(data->GetPolys(), points, least, VTK_ID_MAX);
  fault = fault.empty() ? faultOfCells(data->GetLines(), points, 2, VTK_ID_MAX) : fault;
  fault = fault.empty() ? faultOfArrays(data->GetPointData(), points) : fault;
  return fault.empty() ? faultOfArrays(data->GetCellData(), data->GetNumberOfCells()) : fault;
}
}

std::string textOf(vtkDataObject* data)
{
  std::string text;
  for (vtkDataObject* leaf : leavesOf(data))
  {
    text += leaf->GetClassName() + std::string("\n") + textOf(leaf->GetFieldData());
    auto* set = vtkPointSet::SafeDownCast(leaf);
    if (set && set->GetPoints())
    {
      char word[100];
      for (vtkIdType i = 0; i < set->GetNumberOfPoints(); ++i)
      {
        double p[3];
        set->GetPoint(i, p);
        for (double& coordinate : p)
        {
          coordinate = std::isnan(coordinate) ? std::fabs(coordinate) : coordinate;
        }
        std::snprintf(word, sizeof word, "%a %a %a, ", p[0], p[1], p[2]);
        text += word;
      }
      text += "\n" + textOf(set->GetPointData()) + textOf(set->GetCellData());
    }
    if (auto* surface = vtkPolyData::SafeDownCast(leaf))
    {
      text += textOf("verts", surface->GetVerts()) + textOf("lines", surface->GetLines()) +
        textOf("polys", surface->GetPolys()) + textOf("strips", surface->GetStrips());
    }
  }
  return text;
}

std::string outputsOf(vtkAdaptiveHilbertDelaunay2D* filter)
{
  std::string text;
  for (int port : { 0, 1, 2 })
  {
    text += "output " + std::to_string(port) + "\n" + textOf(filter->GetOutputDataObject(port));
  }
  return text;
}

std::string faultOf(vtkAdaptiveHilbertDelaunay2D* filter, bool said)
{
  vtkDataObject* first = filter->GetOutputDataObject(0);
  std::string fault;
  for (vtkDataObject* leaf : leavesOf(first))
  {
    auto* surface = vtkPolyData::SafeDownCast(leaf);
    const std::string other = surface ? faultOfSurface(surface, filter) : "no polydata";
    fault = fault.empty() ? other : fault;
    fault = fault.empty() && surface == first ? faultOfSimplified(filter, surface) : fault;
    if (surface == first && said && surface->GetNumberOfPoints() + surface->GetNumberOfCells() > 0)
    {
      return "an error, and an output";
    }
  }
  for (int port : { 1, 2 })
  {
    for (vtkDataObject* leaf : leavesOf(filter->GetOutputDataObject(port)))
    {
      auto* data = vtkPolyData::SafeDownCast(leaf);
      const std::string other = data ? faultOfOther(data, 3) : "no polydata";
      fault = fault.empty() ? other : fault;
    }
  }
  return fault;
}

} // namespace fuzz
} // namespace ahd
