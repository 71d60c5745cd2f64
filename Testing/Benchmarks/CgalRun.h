// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CgalRun_h
#define ahd_CgalRun_h

#include "Points/Points.h"

#include <cstddef>
#include <vector>

namespace ahd
{
namespace test
{

/// The points as CGAL wants them, made before the clock starts.
class CgalRun
{
public:
  explicit CgalRun(const std::vector<Point>& points);
  ~CgalRun();
  CgalRun(const CgalRun&) = delete;
  CgalRun& operator=(const CgalRun&) = delete;

  /// Delaunay_triangulation_2 over Exact_predicates_inexact_constructions_kernel, all points
  /// inserted as one range (CGAL sorts them spatially). Returns the number of finite triangles.
  std::size_t triangulate() const;

private:
  struct Input;
  Input* input_;
};

} // namespace test
} // namespace ahd

#endif
