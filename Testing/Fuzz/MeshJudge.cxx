// SPDX-License-Identifier: BSD-3-Clause
#include "MeshJudge.h"

#include "FilterJudge.h"

#include "vtkAdaptiveHilbertDelaunay2D.h"
#include "vtkAdaptiveHilbertQualityMesh2D.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace ahd
{
namespace fuzz
{
namespace
{

using Wide = long double;
using Mesh = vtkAdaptiveHilbertQualityMesh2D;

constexpr Wide kRounding = 1e-12L;

vtkPolyData* outputOf(Mesh* mesh, int port)
{
  return vtkPolyData::SafeDownCast(mesh->GetOutputDataObject(port));
}

bool isInPlane(Mesh* mesh)
{
  vtkAdaptiveHilbertDelaunay2D* const triangulation = mesh->GetTriangulation();
  return triangulation->GetProjectionPlaneMode() != VTK_BEST_FITTING_PLANE &&
    !triangulation->GetTransform();
}

/// Of a triangle, but for overflow beyond long double.
struct Shape
{
  Wide area;                   ///< twice
  std::array<Wide, 3> squares; ///< of the lengths, ascending
};

Shape shapeOf(vtkPolyData* made, vtkIdList* corners)
{
  std::array<std::array<double, 3>, 3> p;
  for (std::size_t k = 0; k < 3; ++k)
  {
    made->GetPoint(corners->GetId(static_cast<vtkIdType>(k)), p[k].data());
  }
  const auto side = [&](std::size_t k, std::size_t c) { return Wide(p[k][c]) - p[(k + 1) % 3][c]; };
  Shape shape;
  for (std::size_t k = 0; k < 3; ++k)
  {
    shape.squares[k] = side(k, 0) * side(k, 0) + side(k, 1) * side(k, 1);
  }
  std::sort(shape.squares.begin(), shape.squares.end());
  shape.area = std::fabs(side(0, 0) * side(1, 1) - side(0, 1) * side(1, 0));
  return shape;
}

/// Of a triangle that is as wished.
std::string faultOfShape(Mesh* mesh, const Shape& shape)
{
  const Wide sine = std::sin(Wide(mesh->GetMinimumAngle()) * std::acos(Wide(-1)) / 180);
  const Wide most = mesh->GetMaximumLength();
  return shape.area < sine * std::sqrt(shape.squares[1] * shape.squares[2]) * (1 - kRounding)
    ? "a triangle of a small angle"
    : mesh->GetMaximumArea() > 0.0 &&
      shape.area > 2 * Wide(mesh->GetMaximumArea()) * (1 + kRounding)
    ? "a triangle of a large area"
    : most > 0 && std::sqrt(shape.squares[2]) > most * (1 + kRounding) ? "a long edge"
                                                                       : "";
}

std::string faultOfTriangles(Mesh* mesh, vtkPolyData* made)
{
  std::string fault = fuzz::faultOfTriangles(made, isInPlane(mesh));
  vtkDataArray* const reasons = made->GetCellData()->GetArray("BadReason");
  if (!reasons || !idsOf(made->GetCellData(), "RegionId"))
  {
    return "triangles without regions or reasons";
  }
  vtkIdType bad = 0;
  Wide least = 180;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < made->GetNumberOfPolys() && fault.empty(); ++cell)
  {
    made->GetPolys()->GetCellAtId(cell, corners);
    const double reason = reasons->GetComponent(cell, 0);
    const Shape shape = shapeOf(made, corners);
    bad += reason >= 0.0;
    fault = reason < -1.0 || reason > 2.0 ? "a reason that is none"
      : reason < 0.0 && isInPlane(mesh)   ? faultOfShape(mesh, shape)
                                          : "";
    const Wide sine = shape.area / std::sqrt(shape.squares[1] * shape.squares[2]);
    least = std::min(least, std::asin(std::min(sine, Wide(1))) * 180 / std::acos(Wide(-1)));
  }
  const bool isLeast = made->GetNumberOfPolys() == 0
    ? mesh->GetLeastAngle() == 0.0
    : !isInPlane(mesh) || std::fabs(mesh->GetLeastAngle() - least) < 1e-6L;
  return !fault.empty()                    ? fault
    : bad != countOf(made, "BadTriangles") ? "bad triangles that are miscounted"
    : isLeast                              ? ""
                                           : "a least angle that no triangle has";
}

/// Of the edges of the triangles, as pairs of ids, each once.
std::string faultOfSegments(vtkPolyData* made, vtkPolyData* segments)
{
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < made->GetNumberOfPolys(); ++cell)
  {
    made->GetPolys()->GetCellAtId(cell, ids);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      edges.emplace(ids->GetId(k), ids->GetId((k + 1) % 3));
    }
  }
  vtkDataArray* const bounds = segments->GetCellData()->GetArray("IsBoundary");
  if (!bounds || !segments->GetCellData()->GetArray("SourceCell"))
  {
    return "segments without their arrays";
  }
  vtkIdType boundary = 0;
  for (vtkIdType cell = 0; cell < segments->GetNumberOfLines(); ++cell)
  {
    segments->GetLines()->GetCellAtId(cell, ids);
    const bool isLeft = edges.count({ ids->GetId(0), ids->GetId(1) }) != 0;
    const bool isRight = edges.count({ ids->GetId(1), ids->GetId(0) }) != 0;
    const bool isBoundary = bounds->GetComponent(cell, 0) != 0.0;
    boundary += isBoundary;
    if (isBoundary ? !isLeft || isRight : !isLeft || !isRight)
    {
      return "a segment that is not where it is said to be";
    }
  }
  const auto outer = std::count_if(edges.begin(), edges.end(),
    [&](const auto& edge) {
      return edges.count({ edge.second, edge.first }) == 0;
    });
  return outer == boundary ? "" : "a boundary that is not all along the mesh";
}

std::string faultOfPoints(Mesh* mesh, vtkPolyData* made)
{
  const auto* ids = idsOf(made->GetPointData(), "OriginalPointIds");
  const vtkIdType points = made->GetNumberOfPoints(), added = mesh->GetNumberOfAddedPoints();
  if (!ids || ids->GetNumberOfValues() != points || added > points ||
    countOf(made, "AddedPoints") != added)
  {
    return "points without their ids, or miscounted";
  }
  for (vtkIdType i = 0; i < points; ++i)
  {
    const vtkIdType id = ids->GetValue(i);
    if (id != -1 && (id != i || i >= points - added))
    {
      return "the id of another point";
    }
  }
  return added > 0 ? faultOfArrays(made->GetPointData(), points) : "";
}

} // namespace

std::string outputsOf(Mesh* mesh)
{
  return textOf(mesh->GetOutputDataObject(0)) + textOf(mesh->GetOutputDataObject(1));
}

std::string faultOf(Mesh* mesh, bool said)
{
  vtkPolyData *const made = outputOf(mesh, 0), *const segments = outputOf(mesh, 1);
  if (!made || !segments)
  {
    return said ? "" : "no polydata";
  }
  const vtkIdType points = made->GetNumberOfPoints();
  if (countOf(made, "BadTriangles") < 0)
  {
    const bool isEmpty = points + segments->GetNumberOfPoints() + made->GetNumberOfCells() +
        segments->GetNumberOfCells() ==
      0;
    return isEmpty ? "" : "an output that nobody counted";
  }
  std::string fault = said ? "an error, and an output" : "";
  const auto add = [&fault](const std::string& other) { fault = fault.empty() ? other : fault; };
  add(faultOfCells(made->GetPolys(), points, 3, 3));
  add(faultOfCells(segments->GetLines(), points, 2, 2));
  add(segments->GetNumberOfPoints() == points ? "" : "segments of other points");
  for (vtkPolyData* output : { made, segments })
  {
    add(faultOfArrays(output->GetCellData(), output->GetNumberOfCells()));
  }
  if (fault.empty())
  {
    add(faultOfPoints(mesh, made));
    add(faultOfTriangles(mesh, made));
    add(faultOfSegments(made, segments));
  }
  return fault;
}

} // namespace fuzz
} // namespace ahd
