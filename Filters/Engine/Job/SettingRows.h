// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
#ifndef ahd_JobSettingRows_h
#define ahd_JobSettingRows_h

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>

namespace ahd
{

enum class IntSetting : std::size_t
{
  InsertionOrder,
  Nmax,
  ControlPoints,
  GeneRotation,
  CountWork,
  InsertionLimit,
  MaximumVertices,
  SecondPass,
  Duplicates,
  SkipMask,
  UnfittedPoints,
  CellIds,
  FirstCell,
  ClosedLines,
  PointsAsLine,
  SplitCrossings,
  SourceHeights,
  ZeroIsMissing,
  LinesOnSurface,
  FillRule,
  Plane,
  Rim,
  Bounding,
  AlphaTriangles,
  AlphaLines,
  AlphaVertices,
  VoronoiClip,
  WantVoronoi,
  WantOrder,
  WantBoxes,
  WantCurve,
  WantPointStatus,
  WantErrors,
  WantInsertionRanks,
  WantConstraintEdges,
  WantRegions,
  WantNeighbors,
  WantSamples,
  SampleMethod,
  SampleOutside,
  SampleFirstColumn,
  SampleFirstRow,
  Threads,
  MemoryLimit,
  OtherMemory,
  OtherMemoryPerPoint
};

enum class DoubleSetting : std::size_t
{
  Tolerance,
  Offset,
  Alpha,
  MaximumEdgeLength,
  MaximumError,
  MaximumSegmentLength,
  ProgressDelay
};

template <typename Number>
struct SettingRow
{
  const char* name;
  Number preset, least, most;
};

constexpr SettingRow<std::int64_t> kIntRows[] = {
  { "insertion_order", 0, 0, 3 },
  { "nmax", 50, 1, 2147483647 },
  { "control_points", 2, 0, 2 },
  { "gene_rotation", 1, 0, 1 },
  { "count_work", 0, 0, 1 },
  { "insertion_limit", 0, 0, 9223372036854775807 },
  { "maximum_vertices", 0, 0, 9223372036854775807 },
  { "second_pass", 0, 0, 1 },
  { "duplicates", 0, 0, 3 },
  { "skip_mask", 255, 1, 255 },
  { "unfitted_points", 0, 0, 4611686018427387904 },
  { "cell_ids", 0, 0, 1 },
  { "first_cell", 0, 0, 4611686018427387904 },
  { "closed_lines", 0, 0, 1 },
  { "points_as_line", 0, 0, 1 },
  { "split_crossings", 0, 0, 1 },
  { "source_heights", 0, 0, 2 },
  { "zero_is_missing", 0, 0, 1 },
  { "lines_on_surface", 1, 0, 1 },
  { "fill_rule", 0, 0, 1 },
  { "plane", 0, 0, 3 },
  { "rim", 0, 0, 2 },
  { "bounding", 0, 0, 1 },
  { "alpha_triangles", 1, 0, 1 },
  { "alpha_lines", 1, 0, 1 },
  { "alpha_vertices", 1, 0, 1 },
  { "voronoi_clip", 0, 0, 2 },
  { "want_voronoi", 0, 0, 1 },
  { "want_order", 0, 0, 1 },
  { "want_boxes", 0, 0, 1 },
  { "want_curve", 0, 0, 1 },
  { "want_point_status", 0, 0, 1 },
  { "want_errors", 0, 0, 1 },
  { "want_insertion_ranks", 0, 0, 1 },
  { "want_constraint_edges", 0, 0, 1 },
  { "want_regions", 0, 0, 1 },
  { "want_neighbors", 0, 0, 1 },
  { "want_samples", 0, 0, 1 },
  { "sample_method", 0, 0, 3 },
  { "sample_outside", 0, 0, 2 },
  { "sample_first_column", 0, 0, 4503599627370496 },
  { "sample_first_row", 0, 0, 4503599627370496 },
  { "threads", 0, 0, 1024 },
  { "memory_limit", 0, 0, 4611686018427387904 },
  { "other_memory", 0, 0, 4611686018427387904 },
  { "other_memory_per_point", 0, 0, 2147483647 },
};

constexpr SettingRow<double> kDoubleRows[] = {
  { "tolerance", 0.0, 0.0, 1.0 },
  { "offset", 1.0, 0.75, 1.7e+308 },
  { "alpha", 0.0, 0.0, std::numeric_limits<double>::infinity() },
  { "maximum_edge_length", 0.0, 0.0, std::numeric_limits<double>::infinity() },
  { "maximum_error", 0.0, 0.0, 1.7e+308 },
  { "maximum_segment_length", 0.0, 0.0, std::numeric_limits<double>::infinity() },
  { "progress_delay", 0.0, 0.0, std::numeric_limits<double>::infinity() },
};

template <typename Setting, typename Number>
struct OnSurface
{
  Setting setting;
  Number value;
};

/// The settings that a surface made before has used up, and the values that count with it.
constexpr OnSurface<IntSetting, std::int64_t> kIntsOnSurface[] = {
  { IntSetting::InsertionLimit, 0 },
  { IntSetting::MaximumVertices, 0 },
  { IntSetting::SecondPass, 0 },
  { IntSetting::Duplicates, 0 },
  { IntSetting::CellIds, 0 },
  { IntSetting::PointsAsLine, 0 },
  { IntSetting::SplitCrossings, 0 },
  { IntSetting::SourceHeights, 0 },
  { IntSetting::ZeroIsMissing, 0 },
  { IntSetting::LinesOnSurface, 1 },
  { IntSetting::Rim, 1 },
  { IntSetting::Bounding, 0 },
  { IntSetting::AlphaTriangles, 1 },
  { IntSetting::AlphaLines, 1 },
  { IntSetting::AlphaVertices, 1 },
};

constexpr OnSurface<DoubleSetting, double> kDoublesOnSurface[] = {
  { DoubleSetting::Tolerance, 0.0 },
  { DoubleSetting::Alpha, 0.0 },
  { DoubleSetting::MaximumEdgeLength, 0.0 },
  { DoubleSetting::MaximumError, 0.0 },
  { DoubleSetting::MaximumSegmentLength, 0.0 },
};

constexpr std::size_t kIntSettings = std::size(kIntRows);
constexpr std::size_t kDoubleSettings = std::size(kDoubleRows);

} // namespace ahd

#endif
