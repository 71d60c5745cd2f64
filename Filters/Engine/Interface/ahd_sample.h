/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef ahd_sample_h
#define ahd_sample_h

/*
 * The part of the C interface that gives values between the points, after ahd_run(): at any places
 * or on a raster. ahd.h includes it. Heights at the centres of 3 x 2 cells, from those of the
 * points in `z`:
 *
 *     ahd_places cells = { NULL, 0, { 0.5, 0.5 }, { 1.0, 1.0 }, 3, 2 };
 *     double heights[6];
 *     uint8_t mask[6];
 *     ahd_sampled array = { z, 1, heights, NULL };
 *     ahd_set_int(job, "sample_method", AHD_SAMPLE_NATURAL_NEIGHBOR);
 *     if (ahd_sample(job, &cells, &array, 1, mask) != AHD_OK)
 *       puts(ahd_message(job));
 *
 * The triangle, edge or vertex of a place is determined exactly: a place on a vertex gets the value
 * of the vertex, one on an edge a value from its two ends alone, the same from either side. One
 * that is outside by no more than rounding has the value at the nearest place of the surface: at
 * most 16 units in the last place of the largest coordinate of it and an edge with one triangle,
 * exactly. ahd_locate() says that it is outside, or in which triangle. Farther outside the output
 * triangles there is no value, unless requested: the mask is 0 and values are NaN.
 *
 * Of vertices one is nearest that can be reached in a straight line which does not leave the
 * surface through a constraint edge that bounds a hole or the outline, and is in a triangle that
 * loops keep (or in none): with AHD_SAMPLE_NEAREST and AHD_OUTSIDE_NEAREST_VERTEX alike.
 *
 * The settings, of type int, apply to subsequent calls:
 *   sample_method    0   AHD_SAMPLE_...
 *   sample_outside   0   AHD_OUTSIDE_...
 * besides them threads, memory_limit and other_memory.
 *
 * Counts, of the last ahd_sample() or ahd_sample_weights() of the result that returned AHD_OK, 0
 * before:
 *   sampled_places        = sampled_valued + sampled_outside + sampled_not_finite
 *   sampled_valued        on the surface, or outside by rounding; with AHD_SAMPLE_NEAREST all that
 *                         are finite, if there is a vertex to be nearest
 *   sampled_outside       outside the hull, in a hole or in a removed triangle
 *   sampled_not_finite    with a NaN or infinite x or y
 *   sampled_without_value numbers at valued places that are NaN, because values at points are NaN
 *   sampled_left_out      numbers computed without some neighbours, whose values are NaN (with
 *                         AHD_SAMPLE_NATURAL_NEIGHBOR and _LAPLACE)
 *   sampling_estimate     bytes that it was estimated to take besides the result
 * Measure:
 *   seconds_sample        wall-clock time of the last one
 *
 * A surface that was made before, in place of constraints. Input arrays:
 *   surface          integer  (t, 3)   corners of its triangles: ids of points
 *   surface_edges    uint8    (t)      bit e is set if edge e of the row is a constraint
 * Setting, of type int:
 *   unfitted_points  0        0 to 2^62: the last of points, which were added where the surface was
 *                             made: AHD_PLANE_BEST_FIT is not fitted to them
 * Count, known after every run:
 *   folded_triangles          of the surface, that cannot be had: they cross others in the plane,
 *                             are clockwise there, or have corners that are no vertices or equal.
 *                             ahd_run() returns AHD_BAD_VALUE
 * With a row or more, ahd_run() makes these triangles, and they alone are put out and sampled, each
 * once. Of the points, their corners are triangulated, whatever is in skip. Edges become
 * constraints if surface_edges says so, or if a triangle cannot be had otherwise. AHD_BAD_ARRAY:
 * with source points, lines or loops. AHD_BAD_VALUE: with a setting that drops points or triangles,
 * or bounding; the message names all of these.
 *
 * Arrays, made by ahd_sample_weights():
 *   weight_offsets   int64    (places + 1)   place i has the entries from offset i to i + 1
 *   weight_points    id       (entries)      points with a weight there, each once
 *   weights          float64  (entries)      not negative; those of a place sum to 1 when rounded
 */

#include "ahd.h"

/* sample_method: the points that determine the value at a place, and their weights */
enum
{
  AHD_SAMPLE_LINEAR = 0,           /* the corners of its triangle, by areas */
  AHD_SAMPLE_NATURAL_NEIGHBOR = 1, /* by the area it would take from their Voronoi cells (Sibson) */
  AHD_SAMPLE_LAPLACE = 2,          /* by the common borders of its cell, over distances */
  AHD_SAMPLE_NEAREST = 3           /* the nearest vertex; of several the smallest in (x, y) */
};

/* sample_outside: the values at finite places outside the surface */
enum
{
  AHD_OUTSIDE_NO_VALUE = 0,
  AHD_OUTSIDE_NEAREST_VERTEX = 1, /* the values of the nearest vertex; the mask stays 0 */
  AHD_OUTSIDE_BOUNDARY = 2        /* those at the nearest place of the surface; the mask stays 0 */
};

/* The places of the values, in the plane of the triangulation: `count` places `xy`, x and y each;
 * or, if `xy` is null, the raster whose place row * columns + column lies at origin + (column,
 * row) * spacing. Spacing is finite and not 0. */
typedef struct ahd_places
{
  const double* xy;
  uint64_t count;
  double origin[2];
  double spacing[2];
  uint64_t columns, rows;
} ahd_places;

/* Numbers to interpolate: `columns` for each output point, row by row; NaN is legal. Of several
 * points at one place, the numbers of the one that represents the vertex are used: for heights that
 * follow "duplicates" take the array heights, or z of points. */
typedef struct ahd_sampled
{
  const double* values;
  int32_t columns;
  double* out;       /* `columns` for each place, row by row */
  double* gradients; /* null; with AHD_SAMPLE_LINEAR x and y slope of each of them */
} ahd_sampled;

/* Moves `count` points, (x, y, z) each, in place: to their position in the plane of the result, and
 * their height above it, to the bit like points of a source if x, y and z are finite.
 * AHD_NOT_AVAILABLE: also with AHD_PLANE_CALLBACK, as the caller projects. AHD_BAD_ARRAY. */
AHD_API ahd_status ahd_to_plane(ahd_job* job, double* xyz, uint64_t count);

/* Interpolates `count` arrays. `mask`: null, or 1 for each place that has a value of its own, else
 * 0. A callback gets the fraction of this call. A call that may take more memory than memory_limit
 * or than the process can get is refused before anything is written; a cancelled or failed call may
 * be repeated, and its outputs must not be used. AHD_NOT_AVAILABLE,
 * AHD_BAD_VALUE, AHD_BAD_ARRAY, AHD_MEMORY_LIMIT, AHD_CANCELLED, AHD_OUT_OF_MEMORY. */
AHD_API ahd_status ahd_sample(
  ahd_job* job, const ahd_places* places, const ahd_sampled* arrays, uint64_t count, uint8_t* mask);

/* Upper estimate of the bytes that ahd_sample() takes for arrays of so many columns together,
 * without the memory it writes to, except as other_memory. AHD_MEMORY_LIMIT, with `bytes` written,
 * if it would be refused. */
AHD_API ahd_status ahd_sample_estimate(
  ahd_job* job, const ahd_places* places, uint64_t columns, uint64_t* bytes);

/* The same before there is a result, for so many points: the memory of sampling beyond the
 * triangulation and its tables (want_samples). `fills`: whether places outside get the values of
 * the nearest vertex, with a method other than AHD_SAMPLE_NEAREST, which has one column. Places are
 * counted, not read. AHD_BAD_VALUE, AHD_BAD_ARRAY. */
AHD_API ahd_status ahd_sample_estimate_before(ahd_job* job, uint64_t points,
  const ahd_places* places, uint64_t columns, int32_t fills, uint64_t* bytes);

/* Makes the arrays weight_... and weights, for callers that interpolate themselves. sample_outside
 * does not affect them. Those of the last call are kept, and counted, until these are complete. */
AHD_API ahd_status ahd_sample_weights(ahd_job* job, const ahd_places* places);

#endif
