// SPDX-License-Identifier: BSD-3-Clause
#include "CgalConstrained.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <utility>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using Face = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex, Face>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
  CGAL::No_constraint_intersection_tag>;
using Splitting =
  CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;
} // namespace

struct CgalConstrained::Input
{
  std::vector<std::pair<Kernel::Point_2, std::size_t>> points;
  std::vector<std::pair<std::size_t, std::size_t>> segments;
};

CgalConstrained::CgalConstrained(const ConstraintCase& given)
  : input_(new Input)
{
  for (const Point& p : given.points)
  {
    input_->points.emplace_back(Kernel::Point_2(p.x, p.y), input_->points.size());
  }
  for (const GivenSegment& s : segmentsOf(given.constraints.view()))
  {
    input_->segments.emplace_back(std::size_t(s.from), std::size_t(s.to));
  }
}

CgalConstrained::~CgalConstrained() = default;

std::size_t CgalConstrained::triangulate(
  const std::function<void()>& triangulated, const std::function<void()>& constrained) const
{
  Constrained triangulation;
  triangulation.insert(input_->points.begin(), input_->points.end());
  triangulated();
  std::vector<Constrained::Vertex_handle> vertices(input_->points.size());
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end();
       ++v)
  {
    vertices[v->info()] = v;
  }
  for (const auto& segment : input_->segments)
  {
    triangulation.insert_constraint(vertices[segment.first], vertices[segment.second]);
  }
  constrained();
  return triangulation.number_of_faces();
}

std::size_t CgalConstrained::split() const
{
  Splitting triangulation;
  triangulation.insert(input_->points.begin(), input_->points.end());
  std::vector<Splitting::Vertex_handle> vertices(input_->points.size());
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end();
       ++v)
  {
    vertices[v->info()] = v;
  }
  for (const auto& segment : input_->segments)
  {
    triangulation.insert_constraint(vertices[segment.first], vertices[segment.second]);
  }
  return triangulation.number_of_faces();
}

} // namespace test
} // namespace ahd
