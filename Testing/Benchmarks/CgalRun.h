// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CgalRun_h
#define ahd_CgalRun_h

#include "Points/Points.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace ahd
{
namespace test
{

/// The points in CGAL's form, made before the clock starts.
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

  /// The same; calls `triangulated` before the result is freed, to end a measurement there.
  std::size_t triangulate(const std::function<void()>& triangulated) const;

  /// Triangulates: is the result valid for CGAL (is_valid(), with exact predicates)?
  bool isValid() const;

  /// CGAL's version, as "5.5.1".
  static const char* version();

private:
  struct Input;
  Input* input_;
};

} // namespace test
} // namespace ahd

#endif
