// SPDX-License-Identifier: BSD-3-Clause
#include "CgalLiving.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <ctime>

namespace ahd
{
namespace test
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>,
  CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Constrained>;

double seconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

std::vector<Kernel::Point_2> copyOf(const std::vector<Point>& points)
{
  std::vector<Kernel::Point_2> made;
  for (const Point& p : points)
  {
    made.emplace_back(p.x, p.y);
  }
  return made;
}
} // namespace

EditTimes cgalEdits(
  const std::vector<Point>& points, const EditPlan& plan, const std::vector<Point>& steps)
{
  const std::vector<Kernel::Point_2> given = copyOf(points);
  Delaunay made;
  std::vector<Delaunay::Vertex_handle> vertices;
  vertices.reserve(given.size());
  const double begin = seconds();
  Delaunay::Face_handle hint;
  for (const Kernel::Point_2& p : given)
  {
    vertices.push_back(made.insert(p, hint));
    hint = vertices.back()->face();
  }
  const double inserted = seconds();
  for (std::size_t k = 0; k < plan.changes; ++k)
  {
    made.remove(vertices[plan.removed(k)]);
  }
  const double removed = seconds();
  for (std::size_t k = 0; k < plan.changes; ++k)
  {
    const auto v = vertices[plan.moved(k)];
    made.move_if_no_collision(v, { v->point().x() + steps[k].x, v->point().y() + steps[k].y });
  }
  return { { inserted - begin, removed - inserted, seconds() - removed } };
}

std::size_t cgalMesh(const MeshInput& input, double angle)
{
  const std::vector<Kernel::Point_2> points = copyOf(input.points), holes = copyOf(input.holes);
  Constrained made;
  made.insert_constraints(
    points.begin(), points.end(), input.segments.begin(), input.segments.end());
  const std::size_t before = made.number_of_vertices();
  const double sine = std::sin(angle * std::acos(-1.0) / 180.0);
  CGAL::refine_Delaunay_mesh_2(made, holes.begin(), holes.end(), Criteria(sine * sine, 0.0));
  return made.number_of_vertices() - before;
}

} // namespace test
} // namespace ahd
