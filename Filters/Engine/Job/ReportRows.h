// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ReportRows_h
#define ahd_ReportRows_h

#include "../Sample/Sample.h"
#include "RunReport.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ahd
{

/// One number of a report, by its name in ahd.h.
template <typename Number>
struct ReportRow
{
  const char* name;
  bool isOfResult; ///< it means something if the status is Ok
  Number (*get)(const RunReport&);
};

/// The instruction set of the processor, an InstructionSet.
std::uint64_t dispatchTarget();

constexpr ReportRow<std::uint64_t> kCountRows[] = {
  // known after every run
  { "points", false, [](const RunReport& r) { return std::uint64_t(r.points); } },
  { "memory_estimate", false, [](const RunReport& r) { return std::uint64_t(r.estimate); } },
  { "memory_allowed", false, [](const RunReport& r) { return std::uint64_t(r.allowed); } },
  { "most_boxes", false, [](const RunReport& r) { return std::uint64_t(r.mostBoxes); } },
  { "most_crossings", false, [](const RunReport& r) { return std::uint64_t(r.mostCrossings); } },
  { "folded_triangles", false,
    [](const RunReport& r) { return std::uint64_t(r.foldedTriangles); } },
  { "threads_used", false, [](const RunReport& r) { return std::uint64_t(r.threadsUsed); } },
  { "dispatch_target", false, [](const RunReport&) { return dispatchTarget(); } },
  // known where it succeeded
  { "input_points", true, [](const RunReport& r) { return std::uint64_t(r.inputPoints); } },
  { "source_points", true, [](const RunReport& r) { return std::uint64_t(r.sourcePoints); } },
  { "added_points", true, [](const RunReport& r) { return std::uint64_t(r.addedPoints); } },
  { "split_crossings", true, [](const RunReport& r) { return std::uint64_t(r.crossings); } },
  { "points_added_to_lines", true,
    [](const RunReport& r) { return std::uint64_t(r.addedToLines); } },
  { "inserted", true, [](const RunReport& r) { return std::uint64_t(r.counts.inserted); } },
  { "duplicates", true, [](const RunReport& r) { return std::uint64_t(r.counts.duplicates); } },
  { "not_finite", true, [](const RunReport& r) { return std::uint64_t(r.counts.notFinite); } },
  { "skipped", true, [](const RunReport& r) { return std::uint64_t(r.skipped()); } },
  { "merged_points", true, [](const RunReport& r) { return std::uint64_t(r.mergedPoints); } },
  { "within_error", true, [](const RunReport& r) { return std::uint64_t(r.withinError); } },
  { "beyond_limit", true, [](const RunReport& r) { return std::uint64_t(r.counts.beyondLimit); } },
  { "first_not_finite", true,
    [](const RunReport& r) { return std::uint64_t(r.oddPoints.firstNotFinite); } },
  { "odd_z", true, [](const RunReport& r) { return std::uint64_t(r.oddPoints.oddZ); } },
  { "delaunay_triangles", true,
    [](const RunReport& r) { return std::uint64_t(r.delaunayTriangles); } },
  { "kept_estimate", true, [](const RunReport& r) { return std::uint64_t(r.keptEstimate); } },
  { "kept_triangles", true, [](const RunReport& r) { return std::uint64_t(r.counts.triangles); } },
  { "trimmed_triangles", true, [](const RunReport& r) { return std::uint64_t(r.counts.trimmed); } },
  { "bare_vertices", true,
    [](const RunReport& r) { return std::uint64_t(r.counts.bareVertices); } },
  { "segments", true, [](const RunReport& r) { return std::uint64_t(r.constraints.segments); } },
  { "segments_of_no_length", true,
    [](const RunReport& r) { return std::uint64_t(r.constraints.points); } },
  { "segments_without_vertex", true,
    [](const RunReport& r) { return std::uint64_t(r.constraints.withoutVertex); } },
  { "segments_crossing", true,
    [](const RunReport& r) { return std::uint64_t(r.constraints.crossing); } },
  { "unfilled_loops", true,
    [](const RunReport& r) { return std::uint64_t(r.constraints.unfilledLoops); } },
  { "constraint_edges", true,
    [](const RunReport& r) { return std::uint64_t(r.constraints.edges); } },
  { "first_crossing_cell", true,
    [](const RunReport& r) { return std::uint64_t(r.firstCrossing[0]); } },
  { "first_crossed_cell", true,
    [](const RunReport& r) { return std::uint64_t(r.firstCrossing[1]); } },
  { "unfit_ids", true, [](const RunReport& r) { return std::uint64_t(r.unfitIds.count); } },
  { "first_unfit_id", true, [](const RunReport& r) { return std::uint64_t(r.unfitIds.firstId); } },
  { "first_unfit_cell", true,
    [](const RunReport& r) { return std::uint64_t(r.unfitIds.firstCell); } },
  { "bent_segments", true, [](const RunReport& r) { return std::uint64_t(r.bentConstraints); } },
  { "first_bent_cell", true, [](const RunReport& r) { return std::uint64_t(r.firstBentCell); } },
  { "points_off_surface", true,
    [](const RunReport& r) { return std::uint64_t(r.pointsOffSurface); } },
  { "source_apart", true,
    [](const RunReport& r) { return std::uint64_t(r.sourceBounds.areApart()); } },
  { "loops_miss_input", true,
    [](const RunReport& r)
    {
      const SourceBounds& bounds = r.sourceBounds;
      const bool hasInput = bounds.input.low[0] <= bounds.input.high[0];
      return std::uint64_t(r.loopsMissInput && hasInput && !bounds.areApart());
    } },
  { "lines_at_zero", true,
    [](const RunReport& r) { return std::uint64_t(r.sourceBounds.chainsOffTerrain()); } },
  { "lines_unclosed", true, [](const RunReport& r) { return std::uint64_t(r.areLinesUnclosed); } },
  { "steep_plane", true, [](const RunReport& r) { return std::uint64_t(r.isSteep); } },
  { "is_projected", true, [](const RunReport& r) { return std::uint64_t(r.isProjected); } },
  { "on_one_line", true,
    [](const RunReport& r)
    { return std::uint64_t(r.delaunayTriangles == 0 && r.mayBeStacked() && r.areOnOneLine); } },
  { "stacked", true, [](const RunReport& r) { return std::uint64_t(r.areStacked); } },
  { "boxes", true, [](const RunReport& r) { return std::uint64_t(r.boxes); } },
  { "triangles_walked", true, [](const RunReport& r) { return r.counts.trianglesWalked; } },
  { "triangles_removed", true, [](const RunReport& r) { return r.counts.trianglesRemoved; } },
  { "exact_in_circle", true, [](const RunReport& r) { return r.counts.exactInCircle; } },
  { "exact_orient", true, [](const RunReport& r) { return r.counts.exactOrient; } },
  { "insertion_attempts", true, [](const RunReport& r) { return r.counts.insertionAttempts; } },
  { "deferred_points", true, [](const RunReport& r) { return r.counts.deferredPoints; } },
  { "critical_path", true, [](const RunReport& r) { return r.counts.criticalPath; } },
  { "crossings", true,
    [](const RunReport& r)
    { return std::uint64_t(r.splits ? r.crossings : r.constraints.crossing); } },
  { "triangles", true, [](const RunReport& r) { return std::uint64_t(r.triangles); } },
  { "lines", true, [](const RunReport& r) { return std::uint64_t(r.lines); } },
  { "vertices", true, [](const RunReport& r) { return std::uint64_t(r.vertices); } },
  { "cells", true, [](const RunReport& r) { return std::uint64_t(r.cells()); } },
};

template <Phase phase>
double secondsOf(const RunReport& r)
{
  return r.seconds[std::size_t(phase)];
}

constexpr ReportRow<double> kMeasureRows[] = {
  { "np", true, [](const RunReport& r) { return r.countsWork ? r.counts.np() : -1.0; } },
  { "nr", true, [](const RunReport& r) { return r.countsWork ? r.counts.nr() : -1.0; } },
  { "trimmed_area", true, [](const RunReport& r) { return r.counts.trimmedArea; } },
  { "largest_error", true, [](const RunReport& r) { return r.largestError; } },
  { "seconds_merge", true, secondsOf<Phase::Merge> },
  { "seconds_split", true, secondsOf<Phase::Split> },
  { "seconds_read", true, secondsOf<Phase::Read> },
  { "seconds_sort", true, secondsOf<Phase::Sort> },
  { "seconds_insert", true, secondsOf<Phase::Insert> },
  { "seconds_constrain", true, secondsOf<Phase::Constrain> },
  { "seconds_extract", true, secondsOf<Phase::Extract> },
  { "seconds_outputs", true, secondsOf<Phase::Outputs> },
};

/// One number of a report on places, by its name in ahd_sample.h.
struct SampleRow
{
  const char* name;
  std::size_t (*get)(const SampleReport&);
};

constexpr SampleRow kSampleRows[] = {
  { "sampled_places", [](const SampleReport& r) { return r.places(); } },
  { "sampled_valued", [](const SampleReport& r) { return r.valued; } },
  { "sampled_outside", [](const SampleReport& r) { return r.outside; } },
  { "sampled_not_finite", [](const SampleReport& r) { return r.notFinite; } },
  { "sampled_without_value", [](const SampleReport& r) { return r.withoutValue; } },
  { "sampled_left_out", [](const SampleReport& r) { return r.leftOut; } },
};

/// The row of this name; null if there is none.
template <typename Row, std::size_t count>
constexpr const Row* findRow(const Row (&rows)[count], std::string_view name)
{
  for (const Row& row : rows)
  {
    if (row.name == name)
    {
      return &row;
    }
  }
  return nullptr;
}

} // namespace ahd

#endif
