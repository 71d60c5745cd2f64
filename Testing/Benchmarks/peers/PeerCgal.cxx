// SPDX-License-Identifier: BSD-3-Clause
//
// PeerCgal POINTS TRIANGLES VERTICES [--ids]: CGAL's Delaunay_triangulation_2 over
// Exact_predicates_inexact_constructions_kernel, all points inserted as one range (CGAL sorts them
// spatially). Timed: the insertion. Without ids the triangles are then CGAL's faces, which have
// coordinates only: VERTICES has these. With ids each vertex carries the id of its point, and an
// array of triangles in these ids is filled too within the time. CGAL is GPL: this program is for
// comparisons and is not installed.
#include "PeerFiles.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstdio>
#include <string>
#include <utility>

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Plain = CGAL::Delaunay_triangulation_2<Kernel>;
using VertexWithId = CGAL::Triangulation_vertex_base_with_info_2<std::int32_t, Kernel>;
using WithIds =
  CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexWithId>>;
using Ids = std::vector<std::int32_t>;

template <typename Delaunay, typename IdOf>
Ids triplesOf(const Delaunay& delaunay, IdOf idOf)
{
  Ids triples;
  triples.reserve(3 * delaunay.number_of_faces());
  for (auto face = delaunay.finite_faces_begin(); face != delaunay.finite_faces_end(); ++face)
  {
    for (int i = 0; i < 3; ++i)
    {
      triples.push_back(idOf(face->vertex(i)));
    }
  }
  return triples;
}

int runPlain(const std::vector<ahd::Point>& points, char** files)
{
  std::vector<Kernel::Point_2> input;
  for (const ahd::Point& p : points)
  {
    input.emplace_back(p.x, p.y);
  }
  Plain delaunay;
  const auto write = [&]
  {
    std::vector<ahd::Point> vertices;
    CGAL::Unique_hash_map<Plain::Vertex_handle, std::int32_t> ids;
    for (auto v = delaunay.finite_vertices_begin(); v != delaunay.finite_vertices_end(); ++v)
    {
      ids[v] = std::int32_t(vertices.size());
      vertices.push_back({ v->point().x(), v->point().y() });
    }
    ahd::test::writePoints(files[2], vertices);
    ahd::test::writeTriples(
      files[1], triplesOf(delaunay, [&](Plain::Vertex_handle v) { return ids[v]; }));
  };
  return ahd::test::timeCall([&] { delaunay.insert(input.begin(), input.end()); }, write);
}

int runWithIds(const std::vector<ahd::Point>& points, char** files)
{
  std::vector<std::pair<Kernel::Point_2, std::int32_t>> input;
  for (const ahd::Point& p : points)
  {
    input.emplace_back(Kernel::Point_2(p.x, p.y), std::int32_t(input.size()));
  }
  WithIds delaunay;
  Ids triples;
  const auto call = [&]
  {
    delaunay.insert(input.begin(), input.end());
    triples = triplesOf(delaunay, [](WithIds::Vertex_handle v) { return v->info(); });
  };
  return ahd::test::timeCall(call, [&] { ahd::test::writeTriples(files[1], triples); });
}

} // namespace

int main(int argc, char** argv)
{
  if (argc == 2 && std::string(argv[1]) == "--version")
  {
    std::printf("%s\n", CGAL_STR(CGAL_VERSION));
    return 0;
  }
  if (argc != 4 && argc != 5)
  {
    std::fprintf(stderr, "PeerCgal POINTS TRIANGLES VERTICES [--ids]\n");
    return 1;
  }
  const std::vector<ahd::Point> points = ahd::test::readPoints(argv[1]);
  return argc == 5 ? runWithIds(points, argv + 1) : runPlain(points, argv + 1);
}
