/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef ahd_h
#define ahd_h

/*
 * The C interface of the engine: exact, canonical Delaunay triangulation in the plane, for C and
 * for any language that can call C. C99; the shared library is libadaptivehilbertdelaunay.
 *
 *     ahd_job* job = ahd_job_new();
 *     ahd_array points = { xy, AHD_FLOAT64, 2, count, 2 * sizeof(double), sizeof(double) };
 *     ahd_set_array(job, "points", &points);
 *     ahd_set_int(job, "want_neighbors", 1);
 *     if (ahd_run(job) == AHD_OK)
 *     {
 *       uint64_t triangles, three;
 *       ahd_array_size(job, "triangles", &triangles, &three);
 *       int32_t* ids = malloc(triangles * three * sizeof(int32_t));
 *       ahd_get_array(job, "triangles", AHD_INT32, ids, triangles * three);
 *     }
 *     else
 *       puts(ahd_message(job));
 *     ahd_job_free(job);
 *
 * Settings, arrays and counts have names; ahd_name() lists them, and a wrong name is an error. They
 * keep name and meaning while AHD_ABI_VERSION is the same; new ones may be added.
 *
 * Errors. Functions return an ahd_status; ahd_message() then has the error. Nothing is thrown,
 * printed or read from the environment. A call that failed changed only the message, the memory it
 * was given to write to, times and threads_used; after ahd_run() there is no result, and the counts
 * are those of this run.
 *
 * Threads. One thread at a time may use a job; several jobs may run in several threads. Only
 * ahd_cancel() may be called while another call of the same job runs: from another thread or from a
 * callback. Other calls from a callback return AHD_BUSY. A callback must return: if
 * longjmp() leaves it, its call never ends, the job stays busy and must not be freed. No state
 * outlives the jobs, except the processor's instruction sets, which are looked up once.
 *
 * Memory. Arrays given to ahd_set_array() are read in place: they must stay unchanged until they
 * are replaced or the job is freed. Floats and doubles are not copied if the distance between rows
 * is a multiple of their size and the numbers of a row are contiguous.
 * Results are written into the caller's memory.
 *
 * The same triangles in the same order, byte for byte, for every setting that does not say
 * otherwise, any number of threads and any processor.
 */

#include <stdint.h>

#if defined(_WIN32) && defined(AHD_BUILDING_LIBRARY)
#define AHD_EXPORT __declspec(dllexport)
#elif defined(_WIN32) && !defined(AHD_STATIC)
#define AHD_EXPORT __declspec(dllimport)
#elif defined(__GNUC__)
#define AHD_EXPORT __attribute__((visibility("default")))
#else
#define AHD_EXPORT
#endif
#ifdef __cplusplus
#define AHD_API extern "C" AHD_EXPORT
#else
#define AHD_API AHD_EXPORT
#endif

/* Changes when programs compiled with the previous header can no longer use the library. */
#define AHD_ABI_VERSION 1

/* The AHD_ABI_VERSION that the library was built with: compare it before any other call. */
AHD_API uint32_t ahd_abi_version(void);
/* The version of the project, like "1.0.0". */
AHD_API const char* ahd_version(void);

/* --- Constants ------------------------------------------------------------------------------- */

/* How a call ended. */
typedef int32_t ahd_status;
enum
{
  AHD_OK = 0,                 /* done; a result without triangles is no error */
  AHD_CANCELLED = 1,          /* by a callback or ahd_cancel() */
  AHD_TOO_MANY_POINTS = 2,    /* more than 2^28 - 2 */
  AHD_TOO_MANY_BOXES = 3,     /* with want_boxes: more than most_boxes */
  AHD_OUT_OF_MEMORY = 4,      /* an allocation failed */
  AHD_MEMORY_LIMIT = 5,       /* the estimate is above the limit */
  AHD_TOO_MANY_CROSSINGS = 6, /* of segments, or points on them: more than most_crossings */
  AHD_UNKNOWN_NAME = 7,       /* no setting, array or count has this name */
  AHD_BAD_VALUE = 8,          /* out of range, or inconsistent with other values */
  AHD_BAD_ARRAY = 9,          /* wrong type, shape or size, or a null pointer */
  AHD_NOT_AVAILABLE = 10,     /* no result, or not requested before the run */
  AHD_BUSY = 11,              /* a call of the job is running */
  AHD_NO_JOB = 12,            /* the job is a null pointer */
  AHD_FAILED = 13             /* a fault of the library */
};

/* Types of numbers. */
enum
{
  AHD_FLOAT32 = 1,
  AHD_FLOAT64 = 2,
  AHD_INT32 = 3,
  AHD_INT64 = 4,
  AHD_UINT8 = 5
};

/* Phases of the work. They come in this order, and some may be absent; the last two, which begin
 * with each array that is written, may come earlier and repeatedly. */
enum
{
  AHD_PHASE_MERGE = 0,     /* copy points, project them, merge points near each other */
  AHD_PHASE_SPLIT = 1,     /* read constraints, split them where they cross */
  AHD_PHASE_READ = 2,      /* read every point once */
  AHD_PHASE_SORT = 3,      /* canonical order, duplicates, insertion order */
  AHD_PHASE_INSERT = 4,    /* insert the points */
  AHD_PHASE_CONSTRAIN = 5, /* insert constraints, remove triangles outside loops */
  AHD_PHASE_EXTRACT = 6,   /* number and sort triangles */
  AHD_PHASE_OUTPUTS = 7    /* make tables, write arrays */
};

/* insertion_order */
enum
{
  AHD_ORDER_ADAPTIVE_HILBERT = 0, /* multi-grid, boxes along an adaptive Hilbert curve */
  AHD_ORDER_MULTI_GRID = 1,       /* multi-grid, boxes line by line */
  AHD_ORDER_REGULAR_GRID = 2,     /* one even grid, boxes line by line */
  AHD_ORDER_AS_GIVEN = 3
};

/* control_points: points inserted before all others */
enum
{
  AHD_CONTROL_OFF = 0,
  AHD_CONTROL_SINGLE_LEVEL = 1,
  AHD_CONTROL_EVERY_LEVEL = 2
};

/* duplicates: which of several points at one place represents the vertex */
enum
{
  AHD_DUPLICATES_FIRST = 0,     /* the one of smallest id */
  AHD_DUPLICATES_LOWEST_Z = 1,  /* of lowest finite z, of several the one of smallest id */
  AHD_DUPLICATES_HIGHEST_Z = 2, /* of highest finite z, of several the one of smallest id */
  AHD_DUPLICATES_MEAN_Z = 3     /* of smallest id, moved to the mean of all with a finite z */
};

/* cell_ids: the points that line_ids and loop_ids refer to */
enum
{
  AHD_IDS_OF_INPUT = 0,
  AHD_IDS_OF_SOURCE = 1 /* rows of source_points, from 0 */
};

/* source_heights: the origin of z and point data of source_points */
enum
{
  AHD_HEIGHTS_OWN = 0,
  AHD_HEIGHTS_FROM_SURFACE = 1, /* linear interpolation in the triangulation of the input alone */
  AHD_HEIGHTS_MIXED = 2         /* where z is NaN, in that of the input and the points with z,
                                   constrained by the segments between these; else own */
};

/* fill_rule: which regions between loops are kept */
enum
{
  AHD_FILL_ORIENTATION = 0, /* regions on the left of every loop edge that bounds them */
  AHD_FILL_EVEN_ODD = 1     /* regions inside an odd number of loops */
};

/* plane: of the triangulation */
enum
{
  AHD_PLANE_XY = 0,
  AHD_PLANE_BEST_FIT = 1, /* least squares of distances; see plane_matrix. If all points share a
                             coordinate, the other two unchanged: x, y; y, z; z, x */
  AHD_PLANE_MATRIX = 2,   /* x, y of the points transformed by the array matrix */
  AHD_PLANE_CALLBACK = 3  /* x, y of the points projected by ahd_set_projection() */
};

/* rim: of a surface; nothing is trimmed with bounding, or limits on the size of triangles */
enum
{
  AHD_RIM_AUTOMATIC = 0,   /* convex hull in AHD_PLANE_XY, and in AHD_PLANE_BEST_FIT if all points
                              share a coordinate; trimmed in any other plane */
  AHD_RIM_CONVEX_HULL = 1, /* the triangles cover the convex hull */
  AHD_RIM_TRIMMED = 2      /* without flat triangles (an angle above 158.2 degrees) along it */
};

/* voronoi_clip: where cells end */
enum
{
  AHD_CLIP_HULL = 0,   /* at the convex hull of the vertices */
  AHD_CLIP_BOUNDS = 1, /* at their bounding box */
  AHD_CLIP_POLYGON = 2 /* at voronoi_polygon, inner cells too; each vertex has a cell, though one
                          without corners if no part of the polygon is nearest to it */
};

/* Values of point_status that are not ids. */
enum
{
  AHD_POINT_NOT_FINITE = -1,   /* rejected: x or y is NaN or infinite */
  AHD_POINT_NOT_INSERTED = -2, /* skipped, or beyond insertion_limit */
  AHD_POINT_WITHIN_ERROR = -3  /* left out of a simplified surface; see maximum_error */
};

/* --- Jobs ------------------------------------------------------------------------------------ */

/* Settings, input and result. Working memory is kept from run to run. */
typedef struct ahd_job ahd_job;

/* A job with default settings and no input; null if there is no memory for it. */
AHD_API ahd_job* ahd_job_new(void);
/* Null is allowed. No call of the job may be running. */
AHD_API void ahd_job_free(ahd_job* job);
/* The error of the last call, empty if there was none; UTF-8, valid until the next call of the job.
 * Never null. In a callback: of the last call from it. */
AHD_API const char* ahd_message(const ahd_job* job);

/* --- Settings --------------------------------------------------------------------------------
 *
 * int (made of Filters/Settings/job.toml, as what is double)
 *   insertion_order  0        AHD_ORDER_...; changes the time, never the triangles
 *   nmax             50       1 to 2^31 - 1: a box with more points is divided
 *   control_points   2        AHD_CONTROL_...
 *   gene_rotation    1        0, 1: the curve in a divided box turns to meet its neighbours
 *   count_work       0        0, 1: count np, nr, exact tests; one thread inserts
 *   insertion_limit  0        insert only so many points of the order; 0: all
 *   maximum_vertices  0       of the best simplified surface; 0: no limit
 *   second_pass      0        0, 1: simplified once more: fewer points within the same error
 *   duplicates       0        AHD_DUPLICATES_...
 *   skip_mask        255      1 to 255: a point is skipped if its mark has one of these bits
 *   cell_ids         0        AHD_IDS_...
 *   first_cell       0        0 to 2^62: number of the first line in reports; loops follow lines
 *   closed_lines     0        0, 1: lines that are closed, alone or joined, are loops
 *   points_as_line   0        0, 1: source_points without lines and loops are a line
 *   split_crossings  0        0, 1: split crossing segments by points; 0: the later is left out
 *   source_heights   0        AHD_HEIGHTS_...
 *   zero_is_missing  0        0, 1: with AHD_HEIGHTS_MIXED, z = 0 of source_points is as NaN
 *   lines_on_surface  1       0, 1: add points where segments with its heights cross edges of it
 *   fill_rule        0        AHD_FILL_...
 *   plane            0        AHD_PLANE_...
 *   rim              0        AHD_RIM_...
 *   bounding         0        0, 1: add VTK's eight bounding points; in AHD_PLANE_XY only
 *   alpha_triangles  1        0, 1: with alpha, output triangles
 *   alpha_lines      1        0, 1: with alpha, output other edges of at most 2 alpha
 *   alpha_vertices   1        0, 1: with alpha, output the points in neither
 *   voronoi_clip     0        AHD_CLIP_...
 *   want_voronoi     0        0, 1: compute the Voronoi diagram, which ignores constraints
 *   want_order       0        0, 1: keep the insertion order
 *   want_boxes       0        0, 1: keep the boxes of the grid, and the order
 *   want_curve       0        0, 1: draw the curve in ahd_draw_order(), and keep the order
 *   want_point_status  0      0, 1: announce this array for estimate and progress
 *   want_errors      0        0, 1: as want_point_status
 *   want_insertion_ranks  0   0, 1: required to get them; keeps the order
 *   want_constraint_edges  0  0, 1: as want_point_status
 *   want_regions     0        0, 1: as want_point_status
 *   want_neighbors   0        0, 1: as want_point_status
 *   want_samples     0        0, 1: announce values between points instead of triangles
 *   threads          0        0 to 1024; 0: one for each processor the process may run on
 *   memory_limit     0        bytes, 0 to 2^62; 0: what the process can get without swapping
 *   other_memory     0        bytes, 0 to 2^62: of the caller, added to the estimate
 *   other_memory_per_point  0  bytes, 0 to 2^31 - 1: for each point, if some are added or left out
 * double
 *   tolerance        0        0 to 1: merge points within this fraction of the diagonal of all
 *   offset           1        0.75 to 1.7e308: distance of the bounding points, in diagonals
 *   alpha            0        0 to infinity: largest circumradius in space; 0: no limit
 *   maximum_edge_length  0    0 to infinity: of edges in the plane; 0: no limit
 *   maximum_error    0        0 to 1.7e308: vertical: points within it are left out; 0: off
 *   maximum_segment_length  0  0 to infinity: in the plane; longer segments are divided; 0: none
 *   progress_delay   0        seconds, 0 to infinity: no report in the first so many of a call
 *
 * AHD_UNKNOWN_NAME, AHD_BAD_VALUE (NaN too); ahd_get_...: AHD_BAD_ARRAY if `value` is null. */
AHD_API ahd_status ahd_set_int(ahd_job* job, const char* name, int64_t value);
AHD_API ahd_status ahd_set_double(ahd_job* job, const char* name, double value);
AHD_API ahd_status ahd_get_int(ahd_job* job, const char* name, int64_t* value);
AHD_API ahd_status ahd_get_double(ahd_job* job, const char* name, double* value);

/* --- Input (for a surface that was made before: ahd_sample.h) ---------------------------------
 *
 *   points         real     (n, 2 or 3)     x, y and optionally z, else z is 0; NaN is legal
 *   skip           uint8    (n)             marks of points to skip; see skip_mask
 *   source_points  real     (m, 2 or 3)     triangulated too, with the ids n to n + m - 1
 *   line_ids       integer  (k) or (c, w)   points of open chains. Each segment is constrained
 *   loop_ids       integer  (k) or (c, w)   points of closed chains, which bound the surface.
 *                                           With several columns each row is a chain
 *   line_offsets   integer  (c + 1)         with one column: chain i has the ids from offset i
 *   loop_offsets   integer  (c + 1)         to offset i + 1, which is not in it; ascending.
 *                                           Without, the ids are one chain
 *   matrix         float64  (4, 4)          for AHD_PLANE_MATRIX: applied to (x, y, z, 1)
 *   values         real     (n) or (n + m)  of which maximum_error is the error; NaN: it stays
 *   weights        real     (n)             times which errors count; negative or NaN: it stays
 *   keep           uint8    (n)             not 0: the point stays in a simplified surface
 *   voronoi_polygon  float64  (k, 2)        for AHD_CLIP_POLYGON, in the plane: two opposite
 *                                           corners of a box, or those of a convex polygon in
 *                                           their order
 *
 * real: AHD_FLOAT32 or AHD_FLOAT64. integer: AHD_INT32 or AHD_INT64. Ids of no point are counted,
 * and their segments left out. Inconsistent arrays (skip and points, offsets and ids; no convex
 * polygon) are refused by ahd_run(). */
typedef struct ahd_array
{
  const void* data;      /* the first number; may be null only without rows */
  int32_t type;          /* AHD_FLOAT32, ... */
  int32_t columns;       /* 1: a list */
  int64_t rows;          /* 0 or more */
  int64_t row_stride;    /* bytes from row to row; may be negative or 0 */
  int64_t column_stride; /* bytes from column to column; the same */
} ahd_array;

/* A null `array` removes it. Discards the result. AHD_UNKNOWN_NAME, AHD_BAD_ARRAY. */
AHD_API ahd_status ahd_set_array(ahd_job* job, const char* name, const ahd_array* array);

/* Moves points (x, y, z each) in place: to their position in the plane, and their height above it.
 * Called on the calling thread, with at most 2^14 points at a time. Non-zero cancels. A point with
 * a coordinate that is not finite is rejected whatever the result is. */
typedef int32_t (*ahd_projection)(void* user, double* xyz, uint64_t count);
AHD_API ahd_status ahd_set_projection(ahd_job* job, ahd_projection projection, void* user);

/* Reports the phase, and the fraction of the run and of writing the announced arrays that is done:
 * 0 to 1, never falling. Called on the calling thread when a phase begins, at each hundredth, and
 * at least ten times a second; not within progress_delay. Non-zero cancels. Null: no reports. */
typedef int32_t (*ahd_progress)(void* user, int32_t phase, double fraction);
AHD_API ahd_status ahd_set_progress(ahd_job* job, ahd_progress progress, void* user);

/* --- Running --------------------------------------------------------------------------------- */

/* Upper estimate of the bytes that ahd_run() and the announced arrays take, other_memory included;
 * without what is only known during the run: crossings, loops, segments that are long or cross. */
AHD_API ahd_status ahd_estimate(ahd_job* job, uint64_t* bytes);

/* Triangulates. Discards the previous result. */
AHD_API ahd_status ahd_run(ahd_job* job);

/* Cancels the running call; if there is none, the next one that can be cancelled. */
AHD_API void ahd_cancel(ahd_job* job);

/* Bytes of working memory kept for the next run, without those of a result. 0 while a call of the
 * job runs. */
AHD_API uint64_t ahd_kept_bytes(ahd_job* job);
/* Discards the result and keeps its memory for the next run, unless more than `most` bytes would be
 * kept in all: then it is returned to the system. Settings and input stay, and the counts that are
 * known after every run. */
AHD_API ahd_status ahd_release(ahd_job* job, uint64_t most);
/* The same, and makes the job as new: default settings, no input, no callbacks. */
AHD_API ahd_status ahd_reset(ahd_job* job, uint64_t most);

/* The plane that fits the input points best, without a run: a (4, 4) matrix, row by row, that moves
 * points to the plane (x, y) and their height above it. AHD_CANCELLED, AHD_OUT_OF_MEMORY. */
AHD_API ahd_status ahd_fit_plane(ahd_job* job, double matrix[16]);
/* AHD_PLANE_BEST_FIT if the input points stand like a wall, else AHD_PLANE_XY: for `plane`, which
 * it does not set. Like a wall: the plane that fits best is steeper than 45 degrees; the footprint
 * in x, y is a line or narrower than a quarter of its length; z is no function of x, y (among
 * neighbours there it spreads by more than a quarter of its variance); points are at most half as
 * thick as that plane is wide, and at most 16 times as high as long. Widths are standard
 * deviations. A function of the points alone. AHD_CANCELLED, AHD_OUT_OF_MEMORY. */
AHD_API ahd_status ahd_choose_plane(ahd_job* job, int64_t* plane);

/* --- Results: counts and measures ------------------------------------------------------------
 *
 * Counts, known after every run:
 *   points              input, source, bounding points and crossings, as far as they were known
 *   memory_estimate     bytes, the last estimate
 *   memory_allowed      bytes, the limit it was compared with
 *   most_boxes          that fit in memory
 *   most_crossings      that fit in memory, of those that are split
 *   threads_used        that shared work, later calls included; 1 if nothing was worth sharing
 *   dispatch_target     instruction set of the processor: 0 baseline, 1 AVX2, 2 AVX-512
 * Known after AHD_OK:
 *   input_points, source_points, added_points (source, those on lines, bounding, crossings),
 *   split_crossings     crossings that were split
 *   points_added_to_lines  where segments cross edges of the surface, or are divided
 *   crossings           the same, or, without the setting split_crossings, segments_crossing
 *   inserted, duplicates, not_finite, skipped, merged_points, beyond_limit, within_error
 *                       numbers of points by status; their sum is points. not_finite: rejected
 *   first_not_finite    smallest id of these, 0 if there is none
 *   odd_z               points with finite x, y and a z that is not finite
 *   delaunay_triangles  before constraints
 *   kept_estimate       bytes that the job keeps at most, once it has interpolated
 *   kept_triangles      not removed by loops or trimming
 *   trimmed_triangles, bare_vertices (left in no triangle by trimming)
 *   triangles, lines, vertices, cells (all three)
 *                       of the output
 *   segments            = segments_of_no_length + segments_without_vertex + segments_crossing
 *                       (left out) + those that became edges
 *   unfilled_loops      that bound nothing, because a segment is missing
 *   constraint_edges    distinct edges that are constraints
 *   first_crossing_cell, first_crossed_cell
 *                       of the first segment left out, and of the one it crosses; else 0
 *   unfit_ids, first_unfit_id, first_unfit_cell
 *                       ids of chains that are not ids of points, the first, and its cell
 *   bent_segments, first_bent_cell
 *                       segments through a vertex that is not exactly on them
 *   points_off_surface  of the source, outside the surface that they should take heights from
 *   source_apart        0, 1: boxes around source_points and points do not meet in the plane
 *   loops_miss_input    0, 1: no point is in what loops of source_points keep, nor at its border
 *   lines_at_zero       lines and loops of source_points at z = 0, all points being above or below
 *   lines_unclosed      0, 1: with closed_lines, there are lines, and none is a loop
 *   is_projected        0, 1: the plane is not that of x, y
 *   steep_plane         0, 1: with AHD_PLANE_BEST_FIT, it is steeper than 80 degrees, and the
 *                       points are no wall: z is a function of x, y, in a narrow footprint of the
 *                       place along it, or they are 16 times as high as long
 *   on_one_line         0, 1: there are no triangles and all points are on one line in space
 *   stacked             0, 1: most points are above or below another one
 *   boxes               of the grid, with want_boxes
 *   drawn_points, drawn_cells
 *                       of ahd_draw_order()
 *   triangles_walked, triangles_removed, exact_in_circle, exact_orient
 *                       with count_work, else 0
 *   insertion_attempts, deferred_points, critical_path
 *                       how threads shared the insertion: see Report in Result.h
 * Measures, known after AHD_OK:
 *   np, nr              triangles tested to locate a point, and removed to insert it, as means;
 *                       -1 without count_work
 *   largest_error       of the points that maximum_error or maximum_vertices left out, vertically
 *   trimmed_area        as a part of the convex hull's
 *   seconds_merge, seconds_split, seconds_read, seconds_sort, seconds_insert, seconds_constrain,
 *   seconds_extract, seconds_outputs
 *                       wall-clock time of each phase, later calls included
 *
 * AHD_UNKNOWN_NAME, AHD_NOT_AVAILABLE, AHD_BAD_ARRAY if `value` is null. */
AHD_API ahd_status ahd_count(ahd_job* job, const char* name, int64_t* value);
AHD_API ahd_status ahd_measure(ahd_job* job, const char* name, double* value);
/* All of them, in the order of ahd_name(). AHD_NOT_AVAILABLE if there is no result; AHD_BAD_ARRAY
 * if `capacity`, the numbers that there is room for, is too small. */
AHD_API ahd_status ahd_counts(ahd_job* job, int64_t* values, uint64_t capacity);
AHD_API ahd_status ahd_measures(ahd_job* job, double* values, uint64_t capacity);

/* --- Results: arrays -------------------------------------------------------------------------
 *
 * Ids are numbers of output points: input, source, bounding points, crossings. Cells are vertices,
 * lines, triangles, numbered in this order from 0. id: AHD_INT32 or AHD_INT64.
 *
 *   triangles           id       (t, 3)       counterclockwise in the plane, canonical order
 *   lines               id       (l, 2)       with alpha
 *   vertices            id       (v)          with alpha
 *   neighbors           id       (cells, 3)   cell across the edge from corner e to e + 1, or -1
 *   constraint_edges    uint8    (cells)      bit e is set if edge e is a constraint
 *   regions             id       (cells)      separated by constraints, numbered from 0; -1
 *                                             if the cell is not a triangle
 *   points              real     (points, 3)  in space
 *   plane_points        float64  (points, 3)  in the plane, and the height above it
 *   heights             float64  (points)     of the surface, means of duplicates included
 *   plane_matrix        float64  (4, 4)       moves points there; not AHD_PLANE_CALLBACK
 *   point_status        id       (points)     its own id if it represents a vertex, the id of the
 *                                             point that does, or AHD_POINT_...
 *   errors              float64  (points)     how far the surface is from it; NaN: no surface
 *   vertex_of_point     id       (points)     number of its vertex in canonical order, or -1
 *   point_of_vertex     id       (vertices)   the id that represents it
 *   vertex_bounds       float64  (2, 2)       smallest and largest x, y of these; NaN without any
 *   order               id       (inserted)   ids in the order of insertion
 *   insertion_ranks     id       (points)     position of each point in it, or -1
 *   box_bounds          float64  (boxes, 4)   xmin, xmax, ymin, ymax
 *   box_levels          int32    (boxes)      divisions that made it
 *   box_counts          id       (boxes)      distinct points in it
 *   voronoi_points      float64  (p, 2)       corners of Voronoi cells, in the plane
 *   voronoi_offsets     id       (c + 1)      cell i has the corners from offset i to i + 1
 *   voronoi_corners     id       (k)          rows of voronoi_points, counterclockwise
 *   voronoi_sites       id       (c)          the point of the cell; ascending vertices' ids
 *   merged              id       (m, 2)       points merged by tolerance, and into which
 *   surface_corners     id       (s, 3)       with heights from a surface, or points added to
 *   surface_weights     float64  (s, 3)       lines, of each source point, then of each of those:
 *                                             between which it lies, to be found in this order;
 *                                             weights 0: it keeps its own height and data
 *   crossing_ends       id       (x, 4)       of each crossing that was added: the ends of its two
 *   crossing_fractions  float64  (x, 2)       segments, and where on them it lies
 *   crossing_cells      id       (r, 2)       cells of segments that cross, later and earlier:
 *                                             first those split, then those left out; to 1000
 *   left_out            id       (o, 4)       cell and segment left out, cell and segment crossed
 *
 * order, insertion_ranks, box_... and voronoi_... must be requested by their want_... before the
 * run. Cancelled and failed calls may be repeated.
 *
 * `columns`: 1 for a list. `out` has room for `capacity` numbers (not bytes), at least rows *
 * columns; they are written row by row. AHD_UNKNOWN_NAME, AHD_NOT_AVAILABLE, AHD_BAD_ARRAY,
 * AHD_CANCELLED, AHD_OUT_OF_MEMORY. */
AHD_API ahd_status ahd_array_size(
  ahd_job* job, const char* name, uint64_t* rows, uint64_t* columns);
AHD_API ahd_status ahd_get_array(
  ahd_job* job, const char* name, int32_t type, void* out, uint64_t capacity);

/* The insertion order as it is drawn. Points: with want_curve the inserted ones in their order,
 * then four corners of each box, counterclockwise. Cells: the curve (with want_curve, if there are
 * two points or more), then the boxes. */
typedef struct ahd_drawing
{
  double* xyz;     /* 3 * drawn_points */
  void* ranks;     /* drawn_points: the position in the order; -1 for corners */
  void* ids;       /* drawn_points: the id; -1 for corners */
  int32_t* levels; /* drawn_cells: -1 for the curve; divisions that made the box */
  void* counts;    /* drawn_cells: points on the curve; distinct points in the box */
} ahd_drawing;
/* `type`: AHD_INT32 or AHD_INT64, of ranks, ids and counts. AHD_NOT_AVAILABLE without want_curve
 * and want_boxes. */
AHD_API ahd_status ahd_draw_order(ahd_job* job, int32_t type, const ahd_drawing* drawing);

/* Point data of points that lie between others. `values`: `columns` numbers for each output point,
 * row by row, with those of input points and of source points filled in. Replaces them, by linear
 * interpolation, at source points laid on the surface and points added to lines (AHD_AT_SURFACE),
 * and then at crossings (AHD_AT_CROSSINGS); `where` is one of these or their sum. Cannot be
 * cancelled. */
enum
{
  AHD_AT_SURFACE = 1,
  AHD_AT_CROSSINGS = 2
};
AHD_API ahd_status ahd_interpolate(ahd_job* job, int32_t where, double* values, int32_t columns);

/* Where places lie in the triangulation; exact. */
enum
{
  AHD_IN_TRIANGLE = 0,
  AHD_ON_EDGE = 1,
  AHD_ON_VERTEX = 2,
  AHD_OUTSIDE = 3, /* of the convex hull */
  AHD_NOWHERE = 4  /* the place is not finite, or there are no triangles */
};
/* xy: `count` places in the plane, x and y each. kinds: one of these for each place. ids: three for
 * each; the corners of the triangle, the ends of the edge or the vertex, else -1. cells: the number
 * of an output triangle that has the place inside or on its edge, or -1; may be null. */
AHD_API ahd_status ahd_locate(
  ahd_job* job, const double* xy, uint64_t count, int32_t* kinds, int64_t* ids, int64_t* cells);

/* --- Names ----------------------------------------------------------------------------------- */

enum
{
  AHD_INT_SETTINGS = 0,
  AHD_DOUBLE_SETTINGS = 1,
  AHD_INPUT_ARRAYS = 2,
  AHD_COUNTS = 3,
  AHD_MEASURES = 4,
  AHD_OUTPUT_ARRAYS = 5
};
/* The names of one kind, numbered from 0; null past the last. */
AHD_API const char* ahd_name(int32_t kind, uint32_t number);
/* "AHD_BAD_VALUE"; "?" if the number is not a status. */
AHD_API const char* ahd_status_name(ahd_status status);

/* --- The machine ----------------------------------------------------------------------------- */

/* Processors that this process may run on; at least 1. */
AHD_API uint32_t ahd_processors(void);
/* Bytes that this process can still allocate without swapping. */
AHD_API uint64_t ahd_available_memory(void);
/* 128 bits that differ, in practice, where bytes or `kind` do; 0, 0 for null or absurd counts. */
AHD_API void ahd_fingerprint(const void* bytes, uint64_t count, uint64_t kind, uint64_t out[2]);

#include "ahd_edit.h"     /* points that come, go and move */
#include "ahd_messages.h" /* messages about a run */
#include "ahd_outline.h"  /* the outline of a surface as polygons with holes */
#include "ahd_refine.h"   /* points with which triangles have wide angles */
#include "ahd_sample.h"   /* values between the points, at any places or on a raster */
#include "ahd_tiles.h"    /* more points than memory holds, leaf by leaf */
#endif
