// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Catalogue_h
#define ahd_Catalogue_h

#include "Messages.h"

namespace ahd
{

/// One message.
///
/// `when`: conditions on facts, given or derived (Messages.cxx), separated by spaces: "name", it is
/// there and not 0; "!name", it is not; "name=text", it is this text.
///
/// `text`: braces hold the name of a phrase or fact:
///   {name}           its text or number; several as "a, b and 3 more", four numbers as a box
///   {name?one|other} the first if the number is 1, else the second; both may have braces
///   {name+text}      the text if it is there and not 0
struct Row
{
  Topic topic;
  const char* name;
  const char* when;
  const char* text;
};

/// Of refusals only the first that applies is given.
constexpr Row kRows[] = {
  { Topic::Refusal, "voronoi polygon", "polygon_fault",
    "{voronoi_polygon} {polygon_fault}, but it must be two opposite corners of a box, or the "
    "corners of a convex polygon in their order. Nothing was computed." },
  { Topic::Refusal, "simplification", "conflict",
    "{simplification} and {conflict_with_limit+{insertion_limit}}{conflict_with_alpha+{alpha}}"
    "{conflict_with_mean+{mean_heights}} exclude each other. Nothing was computed. Reset one of "
    "them." },
  { Topic::Refusal, "too many points", "refused=points",
    "{points} points are too many: at most {most_points} can be triangulated." },
  { Topic::Refusal, "too many boxes", "refused=boxes",
    "The grid of {points} points has more than {most_boxes} boxes. Writing more may take more than "
    "{of_memory}. Nothing was computed. {no_boxes}, take fewer points or a larger {nmax}, "
    "{or_set_limit}" },
  { Topic::Refusal, "too many crossings", "refused=crossings",
    "{the_lines} need points in more than {most_crossings} places, where they cross or are "
    "divided. Triangulating {own_points} points and these may take more than {of_memory}. Nothing "
    "was computed. {fewer_lines}, {or_set_limit}" },
  { Topic::Refusal, "memory to triangulate", "refused=limit !doing",
    "Triangulating {points} points may take {of_memory}. Nothing was computed. Take fewer points, "
    "{fewer_arrays}, {or_set_limit}" },
  { Topic::Refusal, "out of memory", "refused=memory !doing",
    "Out of memory while triangulating {points} points; about {needed} are needed{limit_is_less+, "
    "and {memory_limit} allows {allowed}}. Take fewer points, or {fewer_arrays}." },
  { Topic::Refusal, "memory to interpolate", "refused=limit doing=interpolating",
    "Interpolating at {places_are_unknown?the places of a raster|{places} places} from {points} "
    "points may take {of_memory}. Nothing was computed. Take a larger CellSize, smaller "
    "Dimensions, fewer places or points, {or_set_limit}" },
  { Topic::Refusal, "out of memory to interpolate", "refused=memory doing=interpolating",
    "Out of memory while interpolating at {places_are_unknown?the places of a raster|{places} "
    "places} from {points} points; about {needed} are needed. Take a larger CellSize, smaller "
    "Dimensions, fewer places or points." },
  { Topic::Refusal, "memory to sample", "refused=limit doing=sampling",
    "Values at {places} places may take {needed_besides} of memory besides the triangulation, but "
    "{is_limited?{memory_limit} leaves|there are} {allowed}. Take fewer places or columns at a "
    "time, {or_set_limit}" },
  { Topic::Refusal, "memory to merge blocks", "refused=limit doing=merging",
    "Merging blocks of {points} points may take {of_memory}. Nothing was computed. Take fewer or "
    "smaller blocks, {or_set_limit}" },
  { Topic::Refusal, "memory to make points", "refused=limit doing=making",
    "Making {points} points takes {of_memory}. No point was made. Make fewer." },
  { Topic::Refusal, "out of memory to make points", "refused=memory doing=making",
    "Out of memory while making {points} points." },
  { Topic::Refusal, "memory to outline", "refused=limit doing=outlining",
    "The outline of {polygons} cells may take {of_memory}. Nothing was computed. Take fewer cells, "
    "{or_set_limit}" },
  { Topic::Refusal, "out of memory to outline", "refused=memory doing=outlining",
    "Out of memory while outlining {polygons} cells; about {needed} are needed. Take fewer "
    "cells." },
  { Topic::Refusal, "memory to refine", "refused=limit doing=refining",
    "Refining the triangles of {points} points takes more than {of_memory}. Nothing was added. "
    "Take larger triangles or a smaller angle, add fewer points, {or_set_limit}" },
  { Topic::Refusal, "out of memory to refine", "refused=memory doing=refining",
    "Out of memory while refining the triangles of {points} points; about {needed} are needed. "
    "Take larger triangles or a smaller angle, or add fewer points." },
  { Topic::Refusal, "memory to edit", "refused=limit doing=editing",
    "Editing {points} points may take {of_memory}. None was inserted. Insert fewer points, "
    "{or_set_limit}" },
  { Topic::Refusal, "memory of a rank", "refused=limit doing=distributing",
    "{work} {points} points on {ranks} ranks may take {needed} of memory on rank "
    "{rank}{share+{share}}, but {but_allowed}. The output is empty. Take fewer points or more "
    "ranks, {or_set_limit}" },
  { Topic::Refusal, "memory of one rank for all", "refused=limit doing=gathering",
    "{setting} is computed on one rank, with the points of all. {are_sent?Sending them there|This} "
    "may take {needed} of memory on rank {rank}, for {points} points, but {but_allowed}. The "
    "output is empty. Take fewer points, reset that setting, {or_set_limit}" },
  { Topic::Refusal, "damaged cells", "refused=cells cells",
    "The {cells} are damaged: the offsets of number {bad_cell} among them are {begin} and {end}, "
    "but offsets must ascend from 0 to the number of point ids, {ids}. Nothing was computed." },
  { Topic::Refusal, "damaged cells of a rank", "refused=cells !cells",
    "Cells of the source are damaged on one of the ranks: their offsets do not ascend from 0 to "
    "the number of point ids. Nothing was computed." },
  { Topic::Refusal, "folded surface", "folded_triangles",
    "{folded_triangles} of the {triangles} triangles of the surface cross others in the plane of "
    "Triangulation, or are inverted there. Nothing was computed. Set its ProjectionPlaneMode to "
    "that of the surface, or take the points without the triangles." },
  { Topic::Refusal, "no triangulation", "triangulation_is_null",
    "Triangulation is null, so there are no settings to triangulate with. Set it to a "
    "vtkAdaptiveHilbertDelaunay2D." },
  { Topic::Refusal, "nothing to refine", "not_to_refine",
    "A triangulation with {not_to_refine} cannot be refined. Nothing was computed. Reset it; an "
    "outline of polygons in the source leaves parts out." },
  { Topic::Refusal, "unfit sizes", "unfit_sizes",
    "The points have no numeric array {unfit_sizes} with one number each, the size of triangles. "
    "Nothing was computed." },
  { Topic::Refusal, "a mesh on ranks", "mesh_ranks",
    "A quality mesh is made of the points of one rank, and there are {mesh_ranks} ranks. Nothing "
    "was "
    "computed. Gather the points on one rank and run the filter there alone, or reset "
    "DistributePoints of Triangulation: then each rank has a mesh of its own points." },
  { Topic::Refusal, "changed input", "input_is_changed",
    "An observer gave an array of the input other memory or another size while the filter worked. "
    "The output is empty. Change inputs before or after an update." },
  { Topic::Refusal, "cell size", "raster=cell_size",
    "CellSize is {cell_width}, {cell_height}, but both numbers must be greater than 0 and finite, "
    "or both 0. Nothing was computed." },
  { Topic::Refusal, "bounds", "raster=bounds",
    "Bounds are {bounds}, but they must be finite, the first of each two below the second. Nothing "
    "was computed." },
  { Topic::Refusal, "too many cells", "raster=too_many",
    "With a CellSize of {cell_width}, {cell_height} the raster would have {columns} x {rows} "
    "cells, but 2147483647 along x and y are the most. Nothing was computed." },
  { Topic::Refusal, "raster too wide", "raster=too_wide",
    "The raster would be wider or higher than the largest number of double precision, 1.8e+308. "
    "Nothing was computed." },
  { Topic::Refusal, "raster out of numbers", "raster=out_of_numbers",
    "A raster of {columns} x {rows} cells has coordinates that double precision cannot tell apart. "
    "Nothing was computed." },
  { Topic::Refusal, "heights named as marks", "heights_name=vtkGhostType",
    "HeightArrayName is \"{heights_name}\", the name of the array by which VTK hides points. "
    "Nothing was computed." },
  { Topic::Refusal, "mask named as marks", "mask_name=vtkGhostType",
    "ValidPointMaskArrayName is \"{mask_name}\", the name of the array by which VTK hides points. "
    "Nothing was computed." },
  { Topic::Refusal, "one name for two", "is_of_heights",
    "HeightArrayName and ValidPointMaskArrayName are both \"{mask_name}\", but two arrays cannot "
    "have one name. Nothing was computed." },
  { Topic::Refusal, "mask named as gradients", "is_of_gradients",
    "ValidPointMaskArrayName is \"{mask_name}\", the name of the gradients of the heights. Nothing "
    "was computed." },

  { Topic::Triangulation, "no transform", "transform_is_missing",
    "ProjectionPlaneMode needs a Transform, but none is set: the points were triangulated in x and "
    "y." },
  { Topic::Triangulation, "steep plane", "is_steep",
    "{plane_was_chosen?The points stand like a wall: they are triangulated in the plane that fits "
    "them best, not in x and y. Set {plane_of_wall} if that is meant, or {plane_of_terrain}|The "
    "plane that fits the points best is steeper than 80 degrees, though they are no wall, as where "
    "x and y are degrees and z is in metres. The surface may fold over itself. Set "
    "{plane_of_terrain} for heights above x and y}." },
  { Topic::Triangulation, "no bounding points", "bounding_is_missing",
    "There is no bounding triangulation, because the points are triangulated in another plane than "
    "x and y." },
  { Topic::Triangulation, "unfit marks", "marks_are_unfit",
    "The point data array vtkGhostType does not have one value for each of the {input_points} "
    "points, or is not of type unsigned char, so no point was skipped." },
  { Topic::Triangulation, "unfit numbers", "unfit_numbers",
    "Point arrays that are missing, or do not have one number for each point, are not used: "
    "{unfit_numbers}." },
  { Topic::Triangulation, "not finite", "not_finite",
    "{not_finite} of {points} points were rejected, because {is_projected?they have no finite "
    "position in the plane of the triangulation|their x or y is NaN or infinite}; the first is "
    "point {first_not_finite}." },
  { Topic::Triangulation, "odd z", "odd_z",
    "{odd_z} of {points} points have a z that is NaN or infinite. They are part of the "
    "triangulation, which is computed in x and y{but_not_drawn}." },
  { Topic::Triangulation, "diagram in the plane", "diagram_in_plane",
    "The Voronoi diagram lies in the plane z = 0, because Transform has no inverse to move it back "
    "to the points." },
  { Topic::Triangulation, "limits keep none", "kept_triangles !cells",
    "The output is empty: {size_limits} keep none of {kept_triangles} "
    "{kept_triangles?triangle|triangles}, no line and no vertex. Less strict limits keep more, and "
    "0 is no limit." },
  { Topic::Triangulation, "emptied by loops", "may_be_emptied_by_loops",
    "There is no triangle, because {the_loops} keep none (see {fill_rule}), or all distinct points "
    "are collinear." },
  { Topic::Triangulation, "no triangle yet", "has_no_triangle beyond_limit",
    "There is no triangle yet, because {insertion_limit} stops after the first {inserted} of "
    "{distinct} distinct points, {are_few?fewer than three.|and these are collinear.}" },
  { Topic::Triangulation, "no triangle", "has_no_triangle !beyond_limit",
    "There is no triangle, because {are_few?there are fewer than three distinct points|all "
    "distinct points are collinear}: {inserted} distinct points among {points}{merged_points+, of "
    "which {tolerance} merged {merged_points} into others}.{is_wall+ They are not collinear in "
    "space. {other_plane}.}" },
  { Topic::Triangulation, "stacked", "stacked",
    "{duplicates} of {points} points have the x and y of others and lie above or below them: the "
    "surface has one point of each stack (see {duplicate_policy}). {other_plane}; for a volume "
    "mesh, triangulate one layer of points." },
  { Topic::Triangulation, "loops keep none", "delaunay_triangles !untrimmed",
    "There is no triangle, because {the_loops} keep none of the {delaunay_triangles} triangles "
    "(see {fill_rule})." },
  { Topic::Triangulation, "trimmed rim", "is_much_trimmed",
    "{is_empty?There is no triangle left: trimming|Trimming} the rim removed {is_empty?all "
    "|}{trimmed_triangles} of {untrimmed} triangles, {trimmed_percent} % of the area in the plane, "
    "and left {bare_vertices} {bare_vertices?point|points} without a triangle. Set {convex_rim} to "
    "keep them all." },
  { Topic::Triangulation, "nothing constrained", "constrains_nothing", "{nothing_constrained}" },
  { Topic::Triangulation, "strips", "source_strips !constrains_nothing",
    "{source_strips} {source_strips?triangle strip|triangle strips} of the source "
    "{source_strips?is|are} ignored: only lines and polygons constrain." },
  { Topic::Triangulation, "source elsewhere", "source_apart",
    "The source does not overlap the points. Source: {source_box}; points: {input_box}"
    "{in_the_plane}. Both must have the same units, origin and order of x and y." },
  { Topic::Triangulation, "points elsewhere", "loops_miss_input",
    "None of the points lies inside {the_loops}, so the surface has points of the source only (see "
    "{fill_rule}). Source: {source_box}; points: {input_box}{in_the_plane}." },
  { Topic::Triangulation, "lines at zero", "lines_at_zero",
    "{lines_at_zero} {lines_at_zero?line or polygon of the source lies|lines and polygons of the "
    "source lie} at z = 0, but the points from {lowest_z} to {highest_z}. If that is a map "
    "without heights, {take_heights}." },
  { Topic::Triangulation, "no closed line", "lines_unclosed", "{no_closed_line}" },
  { Topic::Triangulation, "off the surface", "points_off_surface !source_apart",
    "{points_off_surface} of {source_points} {points_of_source} lie outside the surface "
    "{heights_are_mixed?that heights come from and stay without one|of the input and keep their "
    "own z} (see {source_heights})." },
  { Topic::Triangulation, "crossing", "segments_crossing",
    "{segments_crossing}{of_segments} were left out, because they cross others that come before "
    "them; the first is in {chain} {first_crossing_cell} and crosses {chain} "
    "{first_crossed_cell}{chain_order}.{unfilled}" },
  { Topic::Triangulation, "bent", "bent_segments",
    "{bent_segments} {bent_segments?segment|segments}{of_the_source} {bent_segments?bends|bend} by "
    "rounding, through a point that is not exactly on {bent_segments?it|them}; the first is in "
    "{chain} {first_bent_cell}{chain_order}." },
  { Topic::Triangulation, "unfit ids", "unfit_ids",
    "{segments_without_vertex}{of_segments} were left out: {unfit_ids} of the ids in its cells are "
    "not ids of points; the first is {first_unfit_id} in {chain} {first_unfit_cell}. Ids refer to "
    "the points of {cell_ids?the source.|the input (see {source_mode}).}{are_unsaid+{unfilled}}" },
  { Topic::Triangulation, "without vertex",
    "segments_without_vertex delaunay_triangles !unfit_ids !limit_is_told",
    "{segments_without_vertex}{of_segments} were left out, because an end is a point that was "
    "rejected, was skipped or is beyond {insertion_limit}.{are_unsaid+{unfilled}}" },

  { Topic::Columns, "unfit arrays", "unfit_array",
    "Point arrays that are not numeric, have no name or do not have one tuple for each point are "
    "not interpolated: {unfit_array}." },
  { Topic::Columns, "replaced arrays", "replaced_array",
    "Point arrays of the input with the name of an output array are not interpolated: "
    "{replaced_array}. See HeightArrayName and ValidPointMaskArrayName." },
  { Topic::Columns, "no gradients", "gradients_are_missing",
    "There are no gradients: only Method Linear computes them." },

  { Topic::Places, "places not finite", "sampled_not_finite",
    "{sampled_not_finite} of {sampled_places} places have no value, because their x or y is NaN or "
    "infinite." },
  { Topic::Places, "none on the surface", "sampled_outside !sampled_valued",
    "None of {sampled_places} places is on the surface{triangles+ of {triangles} "
    "triangles}. Places: {wanted}; points: {surface}." },
  { Topic::Places, "without value", "sampled_without_value",
    "{sampled_without_value} values at places on the surface are missing, because values of points "
    "are NaN{valueless+: {valueless}.}{heights_are_whole+ No height is "
    "missing.}{valueless_added+{they_lack} {valueless_added}.}" },
  { Topic::Places, "neighbours left out", "sampled_left_out",
    "{sampled_left_out} values at places are interpolated without some of their natural "
    "neighbours, whose values are NaN{incomplete+: {incomplete}.}{incomplete_added+{they_lack} "
    "{incomplete_added}.}" },

  { Topic::Blocks, "blocks", "other_blocks",
    "{other_blocks} {other_blocks?block has no points of its own and was left out; it is a|blocks "
    "have no points of their own and were left out; the first is a} {first_other}." },
  { Topic::Blocks, "unfit marks of blocks", "unfit_marks",
    "In {unfit_marks} {unfit_marks?block|blocks} the point data array vtkGhostType does not have "
    "one value for each of the points, or is not of type unsigned char, so none of these points "
    "was skipped." },
  { Topic::Blocks, "no points", "without_points !without_points=vtkTable",
    "A {without_points} has no points of its own: nothing was triangulated for it." },
  { Topic::Blocks, "table", "without_points=vtkTable",
    "A table has no points: apply Table To Points (vtkTableToPolyData) to it first. Nothing was "
    "triangulated for it." },
  { Topic::Blocks, "meshes of ranks", "mesh_ranks",
    "There are {mesh_ranks} ranks, and each refines its own points only: the meshes of the ranks "
    "do "
    "not join." },
  { Topic::Blocks, "blocks of the source", "other_sources",
    "{other_sources} {other_sources?block of the source is not a vtkPolyData and was left out; it "
    "is a|blocks of the source are not vtkPolyData and were left out; the first is a} "
    "{first_other_source}." },

  { Topic::Outline, "no polygon", "has_no_polygon",
    "There is no outline: the input has no polygon. To points, apply Delaunay 2D (Adaptive "
    "Hilbert) first." },
  { Topic::Outline, "strips of polygons", "polygon_strips",
    "{polygon_strips} triangle {polygon_strips?strip is|strips are} not in the outline. Apply "
    "vtkTriangleFilter (Triangulate) before it." },
  { Topic::Outline, "blocks not outlined", "outlined_blocks",
    "{outlined_blocks} {outlined_blocks?block is|blocks are} not in the outline: not "
    "vtkPolyData." },
  { Topic::Outline, "unfit group", "unfit_group",
    "The cells have no numeric array {unfit_group} with one number each. All are outlined "
    "together." },
  { Topic::Outline, "unfit cells", "unfit_cells",
    "{unfit_cells} {unfit_cells?cell has|cells have} fewer than three corners at different places, "
    "or corners that are not finite or no points: left out of the outline." },
  { Topic::Outline, "unfit edges", "unfit_edges",
    "At {unfit_edges} {unfit_edges?edge|edges} more than two cells meet, or the surface is "
    "one-sided: these edges are in the outline. Polygons may then have outlines that cross." },
};

/// Phrases that differ between the C interface, VTK's classes and NumPy; null: as the first.
struct Phrase
{
  const char* name;
  const char* in[3];
};

constexpr Phrase kPhrases[] = {
  { "of_memory", { "{needed} of memory, but {but_allowed}" } },
  { "but_allowed",
    { "{is_limited?{memory_limit}{of_triangulation+ of Triangulation} allows|there are} "
      "{allowed}" } },
  { "or_set_limit",
    { "or set {memory_limit} to {units_needed} or more ({unit}{of_rank+, of each rank})." } },
  { "memory_limit", { "\"memory_limit\"", "MemoryLimit" } },
  { "simplification",
    { "\"maximum_error\" or \"maximum_vertices\"", "MaximumError or MaximumNumberOfVertices",
      "`maximum_error` or `maximum_vertices`" } },
  { "alpha", { "\"alpha\"", "Alpha", "`alpha`" } },
  { "mean_heights",
    { "\"duplicates\" AHD_DUPLICATES_MEAN_Z", "DuplicatePolicy Mean z", "duplicates='mean_z'" } },
  { "voronoi_polygon", { "\"voronoi_polygon\"", "VoronoiPolygon" } },
  { "unit", { "bytes", "KiB" } },
  { "no_boxes", { "Ask for no boxes", "Switch GenerateBoxes off" } },
  { "nmax", { "\"nmax\"", "Nmax" } },
  { "fewer_arrays", { "ask for fewer arrays", "switch off outputs that are not needed" } },
  { "the_lines", { "Segments", "The lines and polygons of the source" } },
  { "fewer_lines",
    { "Take fewer segments or a larger \"maximum_segment_length\", leave out those that cross",
      "Take fewer lines or a larger MaximumSegmentLength, set CrossingMode to Leave Out",
      "Take fewer segments or a larger `maximum_segment_length`, leave out those that cross" } },
  { "but_not_drawn", { "", ", but cannot be drawn" } },
  { "size_limits",
    { "\"alpha\" and \"maximum_edge_length\"", "Alpha, its switches and MaximumEdgeLength",
      "alpha and maximum_edge_length" } },
  { "the_loops", { "the loops", "the polygons of the source" } },
  { "fill_rule", { "\"fill_rule\"", "FillRule", "`fill_rule`" } },
  { "insertion_limit", { "\"insertion_limit\"", "InsertionLimit", "insertion_limit" } },
  { "tolerance", { "\"tolerance\"", "Tolerance", "tolerance" } },
  { "plane_of_wall",
    { "\"plane\" to AHD_PLANE_BEST_FIT", "ProjectionPlaneMode to Best-Fitting Plane",
      "plane='best_fit'" } },
  { "plane_of_terrain",
    { "\"plane\" to AHD_PLANE_XY", "ProjectionPlaneMode to XY Plane", "plane='xy'" } },
  { "other_plane", { "To triangulate a wall, set {plane_of_wall}" } },
  { "duplicate_policy", { "\"duplicates\"", "DuplicatePolicy", "`duplicates`" } },
  { "convex_rim", { "\"rim\" to AHD_RIM_CONVEX_HULL", "Rim to Convex Hull", "rim='convex_hull'" } },
  { "nothing_constrained",
    { "The source_points constrain nothing: there are no segments, lines or loops of two points or "
      "more. They are points like the others{may_be_line+; with {points_as_line} they are a "
      "line, in their order}.",
      "The source constrains nothing: it has no line and no polygon of two points or more. "
      "Found{source_strips+ (strips are ignored)}: {source_content}.{may_be_line+ With "
      "SourceMode Coordinates and {points_as_line} its points are a line, in their order.}" } },
  { "points_as_line", { "\"points_as_line\"", "PointsAsLine", "points_as_line" } },
  { "in_the_plane", { "{is_projected+, in the plane}" } },
  { "take_heights",
    { "set \"source_heights\" to AHD_HEIGHTS_FROM_SURFACE; if some of its points have heights, to "
      "AHD_HEIGHTS_MIXED with \"zero_is_missing\"",
      "set SourceHeights to From Surface; if some of its points have heights, to Mixed with "
      "ZeroIsMissing",
      "set source_heights='surface'; if some of its points have heights, 'mixed' with "
      "zero_is_missing=True" } },
  { "no_closed_line",
    { "None of the lines is closed, alone or joined to others, so none is a loop (see "
      "\"closed_lines\").{joined_where}",
      "None of the lines of the source is closed, alone or joined to others, so none is an outline "
      "(see ClosedLines).{joined_where}",
      "None of the lines is closed, alone or joined to others, so none is a loop (see "
      "`closed_lines_are_loops`).{joined_where}" } },
  { "joined_where", { " Lines are joined where two of them end and no third." } },
  { "source_heights", { "\"source_heights\"", "SourceHeights", "`source_heights`" } },
  { "source_mode", { "\"cell_ids\"", "SourceMode" } },
  { "of_segments",
    { "{splits? segments or pieces of segments| of {segments} segments}{of_the_source}" } },
  { "points_of_source", { "source points", "points of the source" } },
  { "of_the_source", { "", " of the source" } },
  { "chain", { "cell", "cell", "chain" } },
  { "chain_order", { "", "", " (segments come before lines, lines before loops)" } },
  { "loop", { "loop", "polygon" } },
  { "unfilled",
    { "{unfilled_loops+ {unfilled_loops} {unfilled_loops?{loop} bounds|{loop}s bound} nothing, "
      "because a segment is missing.}" } },
  { "they_lack", { " Added points (of the source, for example) lack" } },
};

} // namespace ahd

#endif
