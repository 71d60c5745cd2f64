// SPDX-License-Identifier: BSD-3-Clause
#include "CgalRun.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

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
  return this->triangulate([] {});
}

std::size_t CgalRun::triangulate(const std::function<void()>& triangulated) const
{
  const Delaunay delaunay(input_->points.begin(), input_->points.end());
  triangulated();
  return delaunay.number_of_faces();
}

bool CgalRun::isValid() const
{
  return Delaunay(input_->points.begin(), input_->points.end()).is_valid();
}

const char* CgalRun::version()
{
  return CGAL_VERSION_STR;
}

} // namespace test
} // namespace ahd
