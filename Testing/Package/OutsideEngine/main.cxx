// SPDX-License-Identifier: BSD-3-Clause
//
// Triangulates a square, a point on its side, one in its middle and a duplicate, and checks the
// result.
#include "Triangulate.h"

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <vector>

namespace
{
const std::vector<double> kPlaces = { 0, 0, 2, 0, 2, 2, 0, 2, 1, 0, 1, 1, 2, 2 };
const std::size_t kCount = kPlaces.size() / 2;

bool check(bool holds, const char* what)
{
  if (!holds)
  {
    std::cerr << "wrong: " << what << "\n";
  }
  return holds;
}

/// Twice the area of a triangle of point ids.
double doubleArea(const std::int32_t* ids)
{
  const auto x = [&](int k) { return kPlaces[2 * std::size_t(ids[k])]; };
  const auto y = [&](int k) { return kPlaces[2 * std::size_t(ids[k]) + 1]; };
  return (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
}

/// All counterclockwise, and together as large as the square.
bool trianglesAreRight(ahd::Triangulation& square)
{
  const std::size_t count = square.report().triangles;
  std::vector<std::int32_t> ids(3 * count);
  if (!check(
        square.writeTriangles(ids.data(), ahd::Context()) == ahd::Status::Ok, "writing triangles"))
  {
    return false;
  }
  double area = 0.0;
  for (std::size_t t = 0; t < count; ++t)
  {
    const double twice = doubleArea(&ids[3 * t]);
    if (!check(twice > 0.0, "a triangle is not counterclockwise"))
    {
      return false;
    }
    area += 0.5 * twice;
  }
  return check(area == 4.0, "the area of all triangles");
}

bool pointsAreRight(ahd::Triangulation& square)
{
  std::vector<std::int64_t> status(kCount);
  return check(square.writePointStatus(status.data(), ahd::Context()) == ahd::Status::Ok,
           "writing point status") &&
    check(status == std::vector<std::int64_t>({ 0, 1, 2, 3, 4, 5, 2 }), "the duplicate's vertex");
}

bool placesAreFound(ahd::Triangulation& square)
{
  using ahd::Location;
  if (!check(square.makeNeighbors(ahd::Context()) == ahd::Status::Ok, "making neighbours"))
  {
    return false;
  }
  const Location middle = square.locate(ahd::Point{ 1, 1 });
  return check(middle.kind == Location::OnVertex, "a place on a vertex") &&
    check(square.pointOf(square.origin(middle.halfEdge)) == 5, "which vertex it is") &&
    check(square.locate(ahd::Point{ 1, 0.5 }).kind == Location::OnEdge, "a place on an edge") &&
    check(square.locate(ahd::Point{ 0.25, 0.5 }).kind == Location::InTriangle,
      "a place in a triangle") &&
    check(square.locate(ahd::Point{ 3, 1 }).kind == Location::Outside, "a place outside");
}
}

int main()
{
  ahd::Workspace workspace;
  ahd::Triangulation square;
  const ahd::PointView points(kPlaces.data(), kCount, 2);
  const ahd::Status status = ahd::triangulate(
    points, ahd::Options(), workspace, ahd::Context(), square);
  if (!check(status == ahd::Status::Ok, "the triangulation"))
  {
    return 1;
  }
  // 2v - 2 - h: six vertices, of which five lie on the hull
  const bool right = check(square.vertexCount() == 6, "the number of vertices") &&
    check(square.report().triangles == 5, "the number of triangles") && trianglesAreRight(square) &&
    pointsAreRight(square) && placesAreFound(square);
  std::cout << square.report().triangles << " triangles\n";
  return right ? 0 : 1;
}
