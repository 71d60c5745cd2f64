// SPDX-License-Identifier: BSD-3-Clause
#include "Counts.h"

#include "../Core/Dispatch.h"
#include "../Surface/OrderDrawing.h"
#include "Refusal.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>

namespace ahd
{
namespace
{

using Made = JobResult;

/// The count of what is known of every run.
struct SizeRow
{
  const char* name;
  std::size_t (*get)(const JobSizes&);
};
constexpr SizeRow kSizes[] = {
  { "points", [](const JobSizes& s) { return s.points; } },
  { "memory_estimate", [](const JobSizes& s) { return s.estimate; } },
  { "memory_allowed", [](const JobSizes& s) { return s.allowed; } },
  { "most_boxes", [](const JobSizes& s) { return s.mostBoxes; } },
  { "most_crossings", [](const JobSizes& s) { return s.mostCrossings; } },
  { "threads_used", [](const JobSizes& s) { return std::size_t(s.threadsUsed); } },
  { "dispatch_target",
    [](const JobSizes&)
    {
      return std::size_t(processorHas(InstructionSet::Avx512) ? InstructionSet::Avx512
          : processorHas(InstructionSet::Avx2)                ? InstructionSet::Avx2
                                                              : InstructionSet::Baseline);
    } },
};

const Report& countsOf(const Made& m)
{
  return m.triangulation.report();
}

const ConstraintReport& constraintsOf(const Made& m)
{
  return m.triangulation.constraints();
}

DrawnOrder drawnOrderOf(const Made& m)
{
  return drawnOrder(m.triangulation, m.settings.is(IntSetting::WantCurve));
}

struct CountRow
{
  const char* name;
  std::uint64_t (*get)(const Made&);
};
constexpr CountRow kCounts[] = {
  { "input_points", [](const Made& m) { return std::uint64_t(m.points.inputCount()); } },
  { "source_points", [](const Made& m) { return std::uint64_t(m.points.sourceCount()); } },
  { "added_points", [](const Made& m) { return std::uint64_t(m.points.addedCount()); } },
  { "split_crossings", [](const Made& m) { return std::uint64_t(m.points.crossings().size()); } },
  { "inserted", [](const Made& m) { return std::uint64_t(countsOf(m).inserted); } },
  { "duplicates", [](const Made& m) { return std::uint64_t(countsOf(m).duplicates); } },
  { "not_finite", [](const Made& m) { return std::uint64_t(countsOf(m).notFinite); } },
  // to the engine those that were merged are skipped, too
  { "skipped",
    [](const Made& m) { return std::uint64_t(countsOf(m).skipped - m.points.merged().size()); } },
  { "merged_points", [](const Made& m) { return std::uint64_t(m.points.merged().size()); } },
  { "beyond_limit", [](const Made& m) { return std::uint64_t(countsOf(m).beyondLimit); } },
  { "first_not_finite", [](const Made& m) { return std::uint64_t(m.oddPoints.firstNotFinite); } },
  { "odd_z", [](const Made& m) { return std::uint64_t(m.oddPoints.oddZ); } },
  { "delaunay_triangles", [](const Made& m) { return std::uint64_t(m.delaunayTriangles); } },
  { "kept_triangles", [](const Made& m) { return std::uint64_t(countsOf(m).triangles); } },
  { "trimmed_triangles", [](const Made& m) { return std::uint64_t(countsOf(m).trimmed); } },
  { "bare_vertices", [](const Made& m) { return std::uint64_t(countsOf(m).bareVertices); } },
  { "triangles", [](const Made& m) { return std::uint64_t(m.triangleCount()); } },
  { "lines", [](const Made& m) { return std::uint64_t(m.selection.lines.size() / 2); } },
  { "vertices", [](const Made& m) { return std::uint64_t(m.selection.vertices.size()); } },
  { "cells", [](const Made& m) { return std::uint64_t(m.cellCount()); } },
  { "segments", [](const Made& m) { return std::uint64_t(constraintsOf(m).segments); } },
  { "segments_of_no_length", [](const Made& m) { return std::uint64_t(constraintsOf(m).points); } },
  { "segments_without_vertex",
    [](const Made& m) { return std::uint64_t(constraintsOf(m).withoutVertex); } },
  { "segments_crossing", [](const Made& m) { return std::uint64_t(constraintsOf(m).crossing); } },
  { "unfilled_loops", [](const Made& m) { return std::uint64_t(constraintsOf(m).unfilledLoops); } },
  { "constraint_edges", [](const Made& m) { return std::uint64_t(constraintsOf(m).edges); } },
  { "first_crossing_cell",
    [](const Made& m)
    {
      const auto& out = constraintsOf(m).leftOut;
      return std::uint64_t(out.empty() ? 0 : m.points.cellOf(out[0].chain));
    } },
  { "first_crossed_cell",
    [](const Made& m)
    {
      const auto& out = constraintsOf(m).leftOut;
      return std::uint64_t(out.empty() ? 0 : m.points.cellOf(out[0].otherChain));
    } },
  { "unfit_ids", [](const Made& m) { return std::uint64_t(m.points.unfitIds().count); } },
  { "first_unfit_id", [](const Made& m) { return std::uint64_t(m.points.unfitIds().firstId); } },
  { "first_unfit_cell",
    [](const Made& m) { return std::uint64_t(m.points.unfitIds().firstCell); } },
  { "bent_segments", [](const Made& m) { return std::uint64_t(m.points.bentCount()); } },
  { "first_bent_cell", [](const Made& m) { return std::uint64_t(m.points.firstBentCell()); } },
  { "points_off_surface", [](const Made& m) { return std::uint64_t(m.points.outsideCount()); } },
  { "is_projected", [](const Made& m) { return std::uint64_t(m.points.isProjected()); } },
  { "on_one_line", [](const Made& m) { return std::uint64_t(m.areOnOneLine); } },
  { "stacked", [](const Made& m) { return std::uint64_t(m.areStacked); } },
  { "boxes", [](const Made& m) { return std::uint64_t(m.triangulation.boxes().size()); } },
  { "drawn_points", [](const Made& m) { return std::uint64_t(drawnOrderOf(m).points()); } },
  { "drawn_cells", [](const Made& m) { return std::uint64_t(drawnOrderOf(m).cells()); } },
  { "triangles_walked", [](const Made& m) { return countsOf(m).trianglesWalked; } },
  { "triangles_removed", [](const Made& m) { return countsOf(m).trianglesRemoved; } },
  { "exact_in_circle", [](const Made& m) { return countsOf(m).exactInCircle; } },
  { "exact_orient", [](const Made& m) { return countsOf(m).exactOrient; } },
  { "insertion_attempts", [](const Made& m) { return countsOf(m).insertionAttempts; } },
  { "deferred_points", [](const Made& m) { return countsOf(m).deferredPoints; } },
  { "critical_path", [](const Made& m) { return countsOf(m).criticalPath; } },
  { "sampled_places", [](const Made& m) { return std::uint64_t(m.sampling.places); } },
  { "sampled_valued", [](const Made& m) { return std::uint64_t(m.sampling.report.valued); } },
  { "sampled_outside", [](const Made& m) { return std::uint64_t(m.sampling.report.outside); } },
  { "sampled_not_finite",
    [](const Made& m) { return std::uint64_t(m.sampling.report.notFinite); } },
  { "sampled_without_value",
    [](const Made& m) { return std::uint64_t(m.sampling.report.withoutValue); } },
  { "sampled_left_out", [](const Made& m) { return std::uint64_t(m.sampling.report.leftOut); } },
  { "sampling_estimate", [](const Made& m) { return std::uint64_t(m.sampling.estimate); } },
};

double ifCounted(const Made& m, double mean)
{
  return m.settings.is(IntSetting::CountWork) ? mean : -1.0;
}

struct MeasureRow
{
  const char* name;
  double (*get)(const Made&, const JobProgress&);
};

template <Phase phase>
double secondsOf(const Made&, const JobProgress& progress)
{
  return progress.seconds(phase);
}

constexpr MeasureRow kMeasures[] = {
  { "np", [](const Made& m, const JobProgress&) { return ifCounted(m, countsOf(m).np()); } },
  { "nr", [](const Made& m, const JobProgress&) { return ifCounted(m, countsOf(m).nr()); } },
  { "trimmed_area", [](const Made& m, const JobProgress&) { return countsOf(m).trimmedArea; } },
  { "seconds_merge", secondsOf<Phase::Merge> },
  { "seconds_split", secondsOf<Phase::Split> },
  { "seconds_read", secondsOf<Phase::Read> },
  { "seconds_sort", secondsOf<Phase::Sort> },
  { "seconds_insert", secondsOf<Phase::Insert> },
  { "seconds_constrain", secondsOf<Phase::Constrain> },
  { "seconds_extract", secondsOf<Phase::Extract> },
  { "seconds_outputs", secondsOf<Phase::Outputs> },
  { "seconds_sample", [](const Made& m, const JobProgress&) { return m.sampling.seconds; } },
};

/// The row of that name; null if there is none.
template <typename Row, std::size_t count>
const Row* find(const Row (&rows)[count], const char* name)
{
  const Row* const row = std::find_if(std::begin(rows), std::end(rows),
    [name](const Row& r) { return name && std::strcmp(r.name, name) == 0; });
  return row == std::end(rows) ? nullptr : row;
}

[[noreturn]] void refuseName(const char* kind, const char* name)
{
  refuse(Reason::UnknownName,
    "There is no " + std::string(kind) + " \"" + std::string(name ? name : "(null)") + "\".");
}

} // namespace

std::int64_t countOf(Job& job, const char* name)
{
  if (const SizeRow* const row = find(kSizes, name))
  {
    return static_cast<std::int64_t>(row->get(job.sizes()));
  }
  if (const CountRow* const row = find(kCounts, name))
  {
    return static_cast<std::int64_t>(row->get(job.result()));
  }
  refuseName("count", name);
}

double measureOf(Job& job, const char* name)
{
  if (const MeasureRow* const row = find(kMeasures, name))
  {
    return row->get(job.result(), job.progress);
  }
  refuseName("measure", name);
}

const char* countName(std::size_t number)
{
  const std::size_t sizes = std::size(kSizes), counts = std::size(kCounts);
  return number < sizes       ? kSizes[number].name
    : number < sizes + counts ? kCounts[number - sizes].name
                              : nullptr;
}

const char* measureName(std::size_t number)
{
  return number < std::size(kMeasures) ? kMeasures[number].name : nullptr;
}

} // namespace ahd
