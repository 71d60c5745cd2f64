// SPDX-License-Identifier: BSD-3-Clause
#include "CgalRun.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace ahd
{
namespace test
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
} // namespace

struct CgalRun::Input
{
  std::vector<Kernel::Point_2> points;
};

CgalRun::CgalRun(const std::vector<Point>& points)
  : input_(new Input)
{
  for (const Point& p : points)
  {
    input_->points.emplace_back(p.x, p.y);
  }
}

CgalRun::~CgalRun()
{
  delete input_;
}

std::size_t CgalRun::triangulate() const
{
  const Delaunay delaunay(input_->points.begin(), input_->points.end());
  return delaunay.number_of_faces();
}

} // namespace test
} // namespace ahd
