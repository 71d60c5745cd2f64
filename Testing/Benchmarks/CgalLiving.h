// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CgalLiving_h
#define ahd_CgalLiving_h

#include "Points/Points.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace ahd
{
namespace test
{

/// Seconds of all insertions, removals and moves.
using EditTimes = std::array<double, 3>;

/// Which points of n are removed, and which are moved: every so manyth, and the one after it.
struct EditPlan
{
  std::size_t points, changes;
  std::size_t removed(std::size_t k) const { return k * (points / changes); }
  std::size_t moved(std::size_t k) const { return removed(k) + 1; }
};

/// The same with CGAL's Delaunay_triangulation_2 over exact predicates: points inserted one by one
/// in their order, from the one before; moved ones by so much.
EditTimes cgalEdits(
  const std::vector<Point>& points, const EditPlan& plan, const std::vector<Point>& steps);

/// An outline with segments, and a place in each hole.
struct MeshInput
{
  std::vector<Point> points;
  std::vector<std::pair<std::size_t, std::size_t>> segments;
  std::vector<Point> holes;
};

/// Points that CGAL's Delaunay_mesher_2 adds for a minimum angle in degrees, constraints inserted
/// before.
std::size_t cgalMesh(const MeshInput& input, double angle);

} // namespace test
} // namespace ahd

#endif
