// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CgalConstrained_h
#define ahd_CgalConstrained_h

#include "ConstraintMakers.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace ahd
{
namespace test
{

/// Points and segments in CGAL's form, made before the clock starts.
class CgalConstrained
{
public:
  explicit CgalConstrained(const ConstraintCase& given);
  ~CgalConstrained();

  /// Constrained_Delaunay_triangulation_2 over Exact_predicates_inexact_constructions_kernel: all
  /// points inserted as one range, which CGAL sorts spatially, and then the segments between the
  /// vertices that came of them, one by one. Calls `triangulated` between the two and `constrained`
  /// before the result is freed. Returns the number of finite triangles: nothing is filled.
  std::size_t triangulate(
    const std::function<void()>& triangulated, const std::function<void()>& constrained) const;

  /// The same with Exact_predicates_tag: a vertex is added where segments cross.
  std::size_t split() const;

private:
  struct Input;
  std::unique_ptr<Input> input_;
};

} // namespace test
} // namespace ahd

#endif
