// SPDX-License-Identifier: BSD-3-Clause
#include "RunReport.h"

#include "../Core/Dispatch.h"

#include <iterator>

namespace ahd
{
namespace
{

using R = const RunReport&;

constexpr ReportRow kRows[] = {
  // known after every run
  { "points", false, [](R r) { return std::uint64_t(r.points); } },
  { "memory_estimate", false, [](R r) { return std::uint64_t(r.estimate); } },
  { "memory_allowed", false, [](R r) { return std::uint64_t(r.allowed); } },
  { "most_boxes", false, [](R r) { return std::uint64_t(r.mostBoxes); } },
  { "most_crossings", false, [](R r) { return std::uint64_t(r.mostCrossings); } },
  { "folded_triangles", false, [](R r) { return std::uint64_t(r.foldedTriangles); } },
  { "threads_used", false, [](R r) { return std::uint64_t(r.threadsUsed); } },
  { "dispatch_target", false,
    [](R)
    {
      return std::uint64_t(processorHas(InstructionSet::Avx512) ? InstructionSet::Avx512
          : processorHas(InstructionSet::Avx2)                  ? InstructionSet::Avx2
                                                                : InstructionSet::Baseline);
    } },
  // known where it succeeded
  { "input_points", true, [](R r) { return std::uint64_t(r.inputPoints); } },
  { "source_points", true, [](R r) { return std::uint64_t(r.sourcePoints); } },
  { "added_points", true, [](R r) { return std::uint64_t(r.addedPoints); } },
  { "split_crossings", true, [](R r) { return std::uint64_t(r.crossings); } },
  { "inserted", true, [](R r) { return std::uint64_t(r.counts.inserted); } },
  { "duplicates", true, [](R r) { return std::uint64_t(r.counts.duplicates); } },
  { "not_finite", true, [](R r) { return std::uint64_t(r.counts.notFinite); } },
  { "skipped", true, [](R r) { return std::uint64_t(r.skipped()); } },
  { "merged_points", true, [](R r) { return std::uint64_t(r.mergedPoints); } },
  { "beyond_limit", true, [](R r) { return std::uint64_t(r.counts.beyondLimit); } },
  { "first_not_finite", true, [](R r) { return std::uint64_t(r.oddPoints.firstNotFinite); } },
  { "odd_z", true, [](R r) { return std::uint64_t(r.oddPoints.oddZ); } },
  { "delaunay_triangles", true, [](R r) { return std::uint64_t(r.delaunayTriangles); } },
  { "kept_estimate", true, [](R r) { return std::uint64_t(r.keptEstimate); } },
  { "kept_triangles", true, [](R r) { return std::uint64_t(r.counts.triangles); } },
  { "trimmed_triangles", true, [](R r) { return std::uint64_t(r.counts.trimmed); } },
  { "bare_vertices", true, [](R r) { return std::uint64_t(r.counts.bareVertices); } },
  { "segments", true, [](R r) { return std::uint64_t(r.constraints.segments); } },
  { "segments_of_no_length", true, [](R r) { return std::uint64_t(r.constraints.points); } },
  { "segments_without_vertex", true,
    [](R r) { return std::uint64_t(r.constraints.withoutVertex); } },
  { "segments_crossing", true, [](R r) { return std::uint64_t(r.constraints.crossing); } },
  { "unfilled_loops", true, [](R r) { return std::uint64_t(r.constraints.unfilledLoops); } },
  { "constraint_edges", true, [](R r) { return std::uint64_t(r.constraints.edges); } },
  { "first_crossing_cell", true, [](R r) { return std::uint64_t(r.firstCrossing[0]); } },
  { "first_crossed_cell", true, [](R r) { return std::uint64_t(r.firstCrossing[1]); } },
  { "unfit_ids", true, [](R r) { return std::uint64_t(r.unfitIds.count); } },
  { "first_unfit_id", true, [](R r) { return std::uint64_t(r.unfitIds.firstId); } },
  { "first_unfit_cell", true, [](R r) { return std::uint64_t(r.unfitIds.firstCell); } },
  { "bent_segments", true, [](R r) { return std::uint64_t(r.bentConstraints); } },
  { "first_bent_cell", true, [](R r) { return std::uint64_t(r.firstBentCell); } },
  { "points_off_surface", true, [](R r) { return std::uint64_t(r.pointsOffSurface); } },
  { "is_projected", true, [](R r) { return std::uint64_t(r.isProjected); } },
  { "on_one_line", true,
    [](R r)
    { return std::uint64_t(r.delaunayTriangles == 0 && r.mayBeStacked() && r.areOnOneLine); } },
  { "stacked", true, [](R r) { return std::uint64_t(r.areStacked); } },
  { "boxes", true, [](R r) { return std::uint64_t(r.boxes); } },
  { "triangles_walked", true, [](R r) { return r.counts.trianglesWalked; } },
  { "triangles_removed", true, [](R r) { return r.counts.trianglesRemoved; } },
  { "exact_in_circle", true, [](R r) { return r.counts.exactInCircle; } },
  { "exact_orient", true, [](R r) { return r.counts.exactOrient; } },
  { "insertion_attempts", true, [](R r) { return r.counts.insertionAttempts; } },
  { "deferred_points", true, [](R r) { return r.counts.deferredPoints; } },
  { "critical_path", true, [](R r) { return r.counts.criticalPath; } },
};

} // namespace

const ReportRow* reportRow(std::size_t number)
{
  return number < std::size(kRows) ? kRows + number : nullptr;
}

} // namespace ahd
