/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Results: known answers for small inputs, each feature once, and layouts of the input that change
 * nothing.
 */
#include "Check.h"

#include <math.h>
#include <stdlib.h>

/* A square with a point in the middle, one twice, one that is not finite. */
static const double kSquare[] = { 0, 0, 0, 4, 0, 1, 4, 4, 2, 0, 4, 3, 2, 1, 4, 2, 1, 8, (double)NAN,
  0, 0 };
enum
{
  kSquareCount = 7
};

static int are(ahd_job* job, const char* name, const int64_t* expected, uint64_t count)
{
  uint64_t numbers = 0;
  int64_t* found = ahd_read_ids(job, name, &numbers);
  const int same = numbers == count && memcmp(found, expected, count * sizeof(int64_t)) == 0;
  free(found);
  return same;
}

static int are_doubles(ahd_job* job, const char* name, const double* expected, uint64_t count)
{
  uint64_t numbers = 0, i;
  double* found = ahd_read_doubles(job, name, &numbers);
  int same = numbers == count;
  for (i = 0; i < count && same; ++i)
  {
    same = found[i] == expected[i];
  }
  free(found);
  return same;
}

#define ARE(job, name, ...)                                                                        \
  do                                                                                               \
  {                                                                                                \
    static const int64_t expected[] = { __VA_ARGS__ };                                             \
    CHECK(are(job, name, expected, sizeof(expected) / sizeof(expected[0])));                       \
  } while (0)

#define ARE_DOUBLES(job, name, ...)                                                                \
  do                                                                                               \
  {                                                                                                \
    static const double expected[] = { __VA_ARGS__ };                                              \
    CHECK(are_doubles(job, name, expected, sizeof(expected) / sizeof(expected[0])));               \
  } while (0)

static void test_square(void)
{
  static const double xy[] = { 2, 0.5, 4, 2.5, 0, 0, 9, 9, (double)NAN, 0 };
  ahd_job* job = ahd_job_of(kSquare, kSquareCount, 3);
  int32_t kinds[5],
    kind_of[] = { AHD_IN_TRIANGLE, AHD_ON_EDGE, AHD_ON_VERTEX, AHD_OUTSIDE, AHD_NOWHERE };
  int64_t ids[15], cells[5];
  uint64_t numbers = 0;
  int64_t* status;
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 4);
  CHECK(ahd_counted(job, "cells") == 4);
  CHECK(ahd_counted(job, "inserted") == 5);
  CHECK(ahd_counted(job, "duplicates") == 1);
  CHECK(ahd_counted(job, "not_finite") == 1);
  CHECK(ahd_counted(job, "first_not_finite") == 6);
  CHECK(ahd_counted(job, "points") == 7);
  CHECK(ahd_counted(job, "threads_used") == 1);
  CHECK(ahd_counted(job, "stacked") == 0);
  ARE(job, "point_status", 0, 1, 2, 3, 4, 4, -1);
  ARE_DOUBLES(job, "vertex_bounds", 0, 4, 0, 4);
  status = ahd_read_ids(job, "vertex_of_point", &numbers);
  CHECK(numbers == 7 && status[4] == status[5] && status[6] == -1);
  free(status);
  CHECK_OK(job, ahd_locate(job, xy, 5, kinds, ids, cells));
  CHECK(memcmp(kinds, kind_of, sizeof(kinds)) == 0);
  CHECK(cells[0] >= 0 && cells[1] >= 0 && cells[2] >= 0 && cells[3] == -1 && cells[4] == -1);
  CHECK(ids[0] >= 0 && ids[2] >= 0 && ids[5] == -1 && ids[6] == 0 && ids[7] == -1 && ids[9] == -1);
  CHECK((ids[3] == 1 && ids[4] == 2) || (ids[3] == 2 && ids[4] == 1));
  CHECK_OK(job, ahd_locate(job, xy, 5, kinds, ids, NULL));
  CHECK_OK(job, ahd_locate(job, NULL, 0, NULL, NULL, NULL));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_locate(job, NULL, 1, kinds, ids, NULL));
  CHECK_SAYS(job, "The pointer to the places is null.");
  ahd_job_free(job);
}

/* Points of any layout give the same triangles. */
static void test_layouts(void)
{
  enum
  {
    kCount = 1000
  };
  double* const xy = ahd_scattered(kCount);
  float floats[2 * kCount];
  double columns[2][kCount], wide[5 * kCount], back[3 * kCount], rounded[2 * kCount];
  unsigned char bytes[kCount * 17 + 1];
  const ahd_array layouts[] = {
    { columns, AHD_FLOAT64, 2, kCount, 8, 8 * kCount },        /* column after column */
    { wide, AHD_FLOAT64, 2, kCount, 40, 8 },                   /* in wider rows */
    { wide, AHD_FLOAT64, 3, kCount, 40, 8 },                   /* with z */
    { back + 3 * kCount - 2, AHD_FLOAT64, 2, kCount, -24, 8 }, /* backwards */
    { bytes + 1, AHD_FLOAT64, 2, kCount, 17, 8 },              /* anywhere */
  };
  ahd_job *first = ahd_job_of(xy, kCount, 2), *job = ahd_job_new();
  uint64_t numbers = 0, others = 0, i;
  int64_t *expected, *found;
  ahd_array array = { floats, AHD_FLOAT32, 2, kCount, 8, 4 };
  for (i = 0; i < kCount; ++i)
  {
    columns[0][i] = wide[5 * i] = xy[2 * i];
    columns[1][i] = wide[5 * i + 1] = xy[2 * i + 1];
    wide[5 * i + 2] = wide[5 * i + 3] = wide[5 * i + 4] = 7;
    memcpy(back + 3 * (kCount - i) - 2, xy + 2 * i, 16);
    memcpy(bytes + 1 + 17 * i, xy + 2 * i, 16);
    rounded[2 * i] = floats[2 * i] = (float)xy[2 * i];
    rounded[2 * i + 1] = floats[2 * i + 1] = (float)xy[2 * i + 1];
  }
  CHECK_OK(first, ahd_run(first));
  expected = ahd_read_ids(first, "triangles", &numbers);
  for (i = 0; i < sizeof(layouts) / sizeof(layouts[0]); ++i)
  {
    CHECK_OK(job, ahd_set_array(job, "points", &layouts[i]));
    CHECK_OK(job, ahd_run(job));
    found = ahd_read_ids(job, "triangles", &others);
    CHECK(numbers == others && memcmp(found, expected, numbers * 8) == 0);
    free(found);
  }
  free(expected);
  CHECK_OK(job, ahd_set_array(job, "points", &array));
  CHECK_OK(job, ahd_run(job));
  found = ahd_read_ids(job, "triangles", &numbers);
  ahd_job_free(first);
  first = ahd_job_of(rounded, kCount, 2);
  CHECK_OK(first, ahd_run(first));
  expected = ahd_read_ids(first, "triangles", &others);
  CHECK(numbers == others && memcmp(found, expected, numbers * 8) == 0);
  free(found);
  free(expected);
  free(xy);
  ahd_job_free(first);
  ahd_job_free(job);
}

/* Without a third column z is 0, whatever the memory there has: in the plane, in space, in counts.
 */
static void test_flat_rows(void)
{
  static double rows[] = { 0, 0, 50, 8, 0, 0, 8, 8, 7, 0, 8, 9, 0, 8, -9 };
  ahd_array flat = { rows, AHD_FLOAT64, 2, 5, 24, 8 };
  ahd_job* job = ahd_job_new();
  rows[5] = (double)NAN;
  CHECK_OK(job, ahd_set_array(job, "points", &flat));
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_BEST_FIT));
  CHECK_OK(job, ahd_set_int(job, "duplicates", AHD_DUPLICATES_HIGHEST_Z));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 2 && ahd_counted(job, "odd_z") == 0);
  CHECK(ahd_counted(job, "not_finite") == 0);
  ARE_DOUBLES(job, "plane_matrix", 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  ARE_DOUBLES(job, "points", 0, 0, 0, 8, 0, 0, 8, 8, 0, 0, 8, 0, 0, 8, 0);
  ARE(job, "point_status", 0, 1, 2, 3, 3);
  flat.columns = 3;
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_XY));
  CHECK_OK(job, ahd_set_array(job, "points", &flat));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 2 && ahd_counted(job, "odd_z") == 1);
  ARE(job, "point_status", 0, 1, 2, 3, 3);
  CHECK_OK(job, ahd_set_int(job, "duplicates", AHD_DUPLICATES_LOWEST_Z));
  CHECK_OK(job, ahd_run(job));
  ARE(job, "point_status", 0, 1, 2, 4, 4);
  ahd_job_free(job);
}

/* Points that are left out, and the representative of several. */
static void test_points(void)
{
  static const unsigned char marks[] = { 0, 9, 0, 9, 4, 9, 0, 9, 0, 9, 0, 9, 0 };
  static const double means[] = { 2, 1, 6 };
  ahd_job* job = ahd_job_of(kSquare, kSquareCount, 3);
  ahd_array skip = { marks, AHD_UINT8, 1, kSquareCount, 2, 0 };
  uint64_t numbers = 0;
  double* points;
  float floats[3 * kSquareCount];
  CHECK_OK(job, ahd_set_array(job, "skip", &skip));
  CHECK_OK(job, ahd_set_int(job, "skip_mask", 3));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "skipped") == 0);
  CHECK_OK(job, ahd_set_int(job, "skip_mask", 4));
  CHECK_OK(job, ahd_set_int(job, "duplicates", AHD_DUPLICATES_HIGHEST_Z));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "skipped") == 1);
  ARE(job, "point_status", 0, 1, -2, 3, 5, 5, -1);
  CHECK_OK(job, ahd_set_array(job, "skip", NULL));
  CHECK_OK(job, ahd_set_int(job, "duplicates", AHD_DUPLICATES_LOWEST_Z));
  CHECK_OK(job, ahd_run(job));
  ARE(job, "point_status", 0, 1, 2, 3, 4, 4, -1);
  CHECK_OK(job, ahd_set_int(job, "duplicates", AHD_DUPLICATES_MEAN_Z));
  CHECK_OK(job, ahd_run(job));
  points = ahd_read_doubles(job, "points", &numbers);
  CHECK(numbers == 3 * kSquareCount && memcmp(points + 12, means, sizeof(means)) == 0);
  CHECK(points[17] == 8);
  free(points);
  points = ahd_read_doubles(job, "heights", &numbers);
  CHECK(numbers == kSquareCount && points[4] == 6 && points[5] == 8);
  free(points);
  CHECK_OK(job, ahd_get_array(job, "points", AHD_FLOAT32, floats, 3 * kSquareCount));
  CHECK(floats[14] == 6);
  CHECK_OK(job, ahd_set_int(job, "duplicates", AHD_DUPLICATES_FIRST));
  CHECK_OK(job, ahd_set_double(job, "tolerance", 0.4)); /* of sqrt(32): 2.26 */
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "merged_points") == 2 && ahd_counted(job, "skipped") == 0);
  ARE(job, "merged", 4, 0, 5, 0);
  ARE(job, "point_status", 0, 1, 2, 3, 0, 0, -1);
  ahd_job_free(job);
}

/* Two segments that cross in the middle of a square, as chains of every layout. */
static void test_constraints(void)
{
  static const double square[] = { 0, 0, 0, 4, 0, 8, 4, 4, 4, 0, 4, 4 };
  static const int64_t crossing[] = { 0, 2, 1, 3 }, offsets[] = { 0, 2, 4 }, loop[] = { 0, 1, 2 };
  static const int32_t short_ids[] = { 0, 2, 1, 3, 0, 99 }, short_offsets[] = { 0, 2, 4, 6 };
  ahd_job* job = ahd_job_of(square, 4, 3);
  ahd_array array = ahd_ids(crossing, 2, 2);
  double values[10] = { 10, 1, 20, 2, 30, 3, 40, 4, -7, -7 };
  CHECK_OK(job, ahd_set_array(job, "line_ids", &array));
  CHECK_OK(job, ahd_set_int(job, "first_cell", 5));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "constraint_edges") == 1 && ahd_counted(job, "segments_crossing") == 1);
  CHECK(ahd_counted(job, "first_crossing_cell") == 6);
  CHECK(ahd_counted(job, "first_crossed_cell") == 5);
  ARE(job, "crossing_cells", 6, 5);
  ARE(job, "left_out", 6, 0, 5, 0);
  ARE(job, "triangles", 0, 2, 3, 0, 1, 2);
  ARE(job, "neighbors", 1, -1, -1, -1, -1, 0);
  ARE(job, "regions", 0, 1);
  {
    uint8_t edges[2] = { 77, 77 };
    CHECK_OK(job, ahd_get_array(job, "constraint_edges", AHD_UINT8, edges, 2));
    CHECK(edges[0] == 1 && edges[1] == 4);
  }
  array = ahd_ids(crossing, 4, 1);
  CHECK_OK(job, ahd_set_array(job, "line_ids", &array));
  array = ahd_ids(offsets, 3, 1);
  CHECK_OK(job, ahd_set_array(job, "line_offsets", &array));
  CHECK_OK(job, ahd_set_int(job, "split_crossings", 1));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "split_crossings") == 1 && ahd_counted(job, "added_points") == 1);
  CHECK(ahd_counted(job, "constraint_edges") == 4 && ahd_counted(job, "triangles") == 4);
  ARE(job, "crossing_ends", 0, 2, 3, 1);
  ARE_DOUBLES(job, "crossing_fractions", 0.5, 0.5);
  ARE_DOUBLES(job, "points", 0, 0, 0, 4, 0, 8, 4, 4, 4, 0, 4, 4, 2, 2, 4);
  CHECK_OK(job, ahd_interpolate(job, AHD_AT_SURFACE, values, 2));
  CHECK(values[8] == -7);
  CHECK_OK(job, ahd_interpolate(job, AHD_AT_SURFACE | AHD_AT_CROSSINGS, values, 2));
  CHECK(values[8] == 25 && values[9] == 2.5);
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_interpolate(job, 0, values, 2));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_interpolate(job, 4, values, 2));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_interpolate(job, AHD_AT_CROSSINGS, NULL, 2));
  CHECK_SAYS(job, "The pointer to the values is null.");
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_interpolate(job, AHD_AT_CROSSINGS, values, -1));
  CHECK_SAYS(job, "The values have -1 columns.");
  CHECK_OK(job, ahd_interpolate(job, AHD_AT_CROSSINGS, NULL, 0));
  { /* 32 bits, an id that is none, with offsets of either type */
    ahd_array ids = { short_ids, AHD_INT32, 1, 6, 4, 4 };
    ahd_array ends = { short_offsets, AHD_INT32, 1, 4, 4, 4 };
    static const int64_t long_offsets[] = { 0, 2, 4, 6 };
    ahd_array long_ends = ahd_ids(long_offsets, 4, 1);
    CHECK_OK(job, ahd_set_array(job, "line_ids", &ids));
    CHECK_OK(job, ahd_set_array(job, "line_offsets", &ends));
    CHECK_OK(job, ahd_run(job));
    CHECK(ahd_counted(job, "unfit_ids") == 1 && ahd_counted(job, "first_unfit_id") == 99);
    CHECK(ahd_counted(job, "first_unfit_cell") == 7 && ahd_counted(job, "constraint_edges") == 4);
    CHECK_OK(job, ahd_set_array(job, "line_offsets", &long_ends));
    CHECK_OK(job, ahd_run(job));
    CHECK(ahd_counted(job, "unfit_ids") == 1 && ahd_counted(job, "constraint_edges") == 4);
  }
  CHECK_OK(job, ahd_set_array(job, "line_ids", NULL));
  CHECK_OK(job, ahd_set_array(job, "line_offsets", NULL));
  array = ahd_ids(loop, 3, 1); /* one chain */
  CHECK_OK(job, ahd_set_array(job, "loop_ids", &array));
  CHECK_OK(job, ahd_run(job));
  ARE(job, "triangles", 0, 1, 2);
  CHECK(ahd_counted(job, "delaunay_triangles") == 2 && ahd_counted(job, "kept_triangles") == 1);
  array = ahd_ids(loop + 2, 3, 1); /* backwards: clockwise */
  array.row_stride = -8;
  CHECK_OK(job, ahd_set_array(job, "loop_ids", &array));
  CHECK_OK(job, ahd_run(job));
  ARE(job, "triangles", 0, 2, 3);
  CHECK_OK(job, ahd_set_int(job, "fill_rule", AHD_FILL_EVEN_ODD));
  CHECK_OK(job, ahd_run(job));
  ARE(job, "triangles", 0, 1, 2);
  ahd_job_free(job);
}

/* Points of the source: with ids of their own, closed lines, laid on the surface. */
static void test_source(void)
{
  static const double square[] = { 0, 0, 0, 8, 0, 8, 8, 8, 16, 0, 8, 8 };
  static const float source[] = { 2, 2, 6, 2, 4, 6 };
  static const int64_t line[] = { 0, 1, 2, 0 };
  ahd_job* job = ahd_job_of(square, 4, 3);
  ahd_array points = { source, AHD_FLOAT32, 2, 3, 8, 4 }, ids = ahd_ids(line, 4, 1);
  double values[7] = { 0, 8, 16, 8, -7, -7, -7 };
  CHECK_OK(job, ahd_set_array(job, "source_points", &points));
  CHECK_OK(job, ahd_set_array(job, "line_ids", &ids));
  CHECK_OK(job, ahd_set_int(job, "cell_ids", AHD_IDS_OF_SOURCE));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "input_points") == 4 && ahd_counted(job, "source_points") == 3);
  CHECK(ahd_counted(job, "constraint_edges") == 3);
  ARE_DOUBLES(job, "points", 0, 0, 0, 8, 0, 8, 8, 8, 16, 0, 8, 8, 2, 2, 0, 6, 2, 0, 4, 6, 0);
  CHECK_OK(job, ahd_set_int(job, "closed_lines", 1));
  CHECK_OK(job, ahd_set_int(job, "source_heights", AHD_HEIGHTS_FROM_SURFACE));
  CHECK_OK(job, ahd_set_int(job, "lines_on_surface", 0));
  CHECK_OK(job, ahd_run(job));
  ARE(job, "triangles", 4, 5, 6);
  ARE_DOUBLES(job, "points", 0, 0, 0, 8, 0, 8, 8, 8, 16, 0, 8, 8, 2, 2, 4, 6, 2, 8, 4, 6, 10);
  CHECK(ahd_counted(job, "points_off_surface") == 0);
  {
    uint64_t corners = 0, weights = 0;
    free(ahd_read_ids(job, "surface_corners", &corners));
    free(ahd_read_doubles(job, "surface_weights", &weights));
    CHECK(corners == 9 && weights == 9);
  }
  CHECK_OK(job, ahd_interpolate(job, AHD_AT_SURFACE, values, 1));
  CHECK(values[4] == 4 && values[5] == 8 && values[6] == 10);
  CHECK_OK(job, ahd_set_int(job, "lines_on_surface", 1)); /* a diagonal is crossed once */
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "points_added_to_lines") == 1 && ahd_counted(job, "added_points") == 4);
  CHECK_OK(job, ahd_set_double(job, "maximum_segment_length", 1.0));
  CHECK_OK(job, ahd_run(job));
  {
    uint64_t weights = 0;
    free(ahd_read_doubles(job, "surface_weights", &weights));
    CHECK((int64_t)weights == 3 * (3 + ahd_counted(job, "points_added_to_lines")) && weights > 36);
  }
  ahd_job_free(job);
}

/* A source of points alone as a line; lines that meet; what is counted of sources that may be
 * wrong. */
static void test_source_lines(void)
{
  static const double square[] = { 0, 0, 5, 8, 0, 6, 8, 8, 7, 0, 8, 6 };
  static const double shore[] = { 2, 2, 0, 6, 2, 0, 4, 6, 0, 2, 2, 0 };
  static const double far[] = { 20, 2, 5, 60, 2, 5, 40, 6, 5, 20, 2, 5 };
  static const int64_t pieces[] = { 0, 1, 2, 1, 3, 2 };
  ahd_job* job = ahd_job_of(square, 4, 3);
  ahd_array points = { shore, AHD_FLOAT64, 3, 4, 24, 8 }, ids = ahd_ids(pieces, 3, 2);
  CHECK_OK(job, ahd_set_array(job, "source_points", &points));
  CHECK_OK(job, ahd_set_int(job, "cell_ids", AHD_IDS_OF_SOURCE));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "segments") == 0 && ahd_counted(job, "lines_at_zero") == 0);
  CHECK_OK(job, ahd_set_int(job, "points_as_line", 1));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "segments") == 3 && ahd_counted(job, "constraint_edges") == 3);
  CHECK(ahd_counted(job, "lines_at_zero") == 1 && ahd_counted(job, "source_apart") == 0);
  CHECK_OK(job, ahd_set_int(job, "closed_lines", 1));
  CHECK_OK(job, ahd_run(job));
  ARE(job, "triangles", 4, 5, 6);
  CHECK(ahd_counted(job, "loops_miss_input") == 1 && ahd_counted(job, "lines_unclosed") == 0);
  CHECK_OK(job, ahd_set_array(job, "line_ids", &ids));
  CHECK_OK(job, ahd_set_int(job, "fill_rule", AHD_FILL_EVEN_ODD)); /* they run both ways */
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 1 && ahd_counted(job, "lines_at_zero") == 3);
  ids.rows = 2;
  points.data = far;
  CHECK_OK(job, ahd_set_array(job, "line_ids", &ids));
  CHECK_OK(job, ahd_set_array(job, "source_points", &points));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "lines_unclosed") == 1 && ahd_counted(job, "source_apart") == 1);
  CHECK(ahd_counted(job, "loops_miss_input") == 0 && ahd_counted(job, "lines_at_zero") == 0);
  ahd_job_free(job);
}

/* The cells that limits on size leave. */
static void test_sizes(void)
{
  static const double strip[] = { 0, 0, 1, 0, 0, 1, 5, 0, 5, 9 };
  ahd_job* job = ahd_job_of(strip, 5, 2);
  CHECK_OK(job, ahd_set_double(job, "alpha", 1.0));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 1 && ahd_counted(job, "lines") == 0);
  ARE(job, "triangles", 0, 1, 2);
  ARE(job, "vertices", 3, 4);
  ARE(job, "neighbors", -1, -1, -1, -1, -1, -1, -1, -1, -1);
  CHECK_OK(job, ahd_set_double(job, "alpha", 2.0));
  CHECK_OK(job, ahd_run(job));
  ARE(job, "lines", 1, 3);
  CHECK(ahd_counted(job, "cells") == 3);
  CHECK_OK(job, ahd_set_int(job, "alpha_lines", 0));
  CHECK_OK(job, ahd_set_int(job, "alpha_vertices", 0));
  CHECK_OK(job, ahd_set_int(job, "alpha_triangles", 0));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "cells") == 0);
  CHECK_OK(job, ahd_set_double(job, "alpha", 0.0));
  CHECK_OK(job, ahd_set_double(job, "maximum_edge_length", 1.5));
  CHECK_OK(job, ahd_run(job));
  ARE(job, "triangles", 0, 1, 2);
  ahd_job_free(job);
}

/* Moves the plane y, z to x, y. */
static int32_t turn(void* user, double* xyz, uint64_t count)
{
  uint64_t i;
  ++*(int*)user;
  for (i = 0; i < count; ++i)
  {
    const double x = xyz[3 * i];
    xyz[3 * i] = xyz[3 * i + 1];
    xyz[3 * i + 1] = xyz[3 * i + 2];
    xyz[3 * i + 2] = x;
  }
  return 0;
}

/* A wall above a line, in every kind of plane. */
static void test_planes(void)
{
  static const double wall[] = { 5, 0, 0, 5, 8, 0, 5, 8, 8, 5, 0, 8, 5, 3, 4 };
  static const double matrix[] = { 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1 };
  const ahd_array moves = { matrix, AHD_FLOAT64, 4, 4, 32, 8 };
  double fitted[16];
  int64_t plane = -1;
  int calls = 0;
  ahd_job* job = ahd_job_of(wall, 5, 3);
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 0 && ahd_counted(job, "on_one_line") == 0);
  CHECK(ahd_counted(job, "is_projected") == 0);
  ARE_DOUBLES(job, "plane_matrix", 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  CHECK_OK(job, ahd_fit_plane(job, fitted));
  CHECK(fitted[11] == -5); /* so that heights are from the plane */
  fitted[11] = 0;
  CHECK(memcmp(fitted, matrix, sizeof(matrix)) == 0);
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_fit_plane(job, NULL));
  CHECK_OK(job, ahd_choose_plane(job, &plane));
  CHECK(plane == AHD_PLANE_BEST_FIT);
  CHECK_OK(job, ahd_get_int(job, "plane", &plane));
  CHECK(plane == AHD_PLANE_XY);
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_choose_plane(job, NULL));
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_BEST_FIT));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 4 && ahd_counted(job, "is_projected") == 1);
  ARE_DOUBLES(job, "plane_matrix", 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, -5, 0, 0, 0, 1);
  ARE_DOUBLES(job, "plane_points", 0, 0, 0, 8, 0, 0, 8, 8, 0, 0, 8, 0, 3, 4, 0);
  ARE_DOUBLES(job, "points", 5, 0, 0, 5, 8, 0, 5, 8, 8, 5, 0, 8, 5, 3, 4);
  CHECK_OK(job, ahd_set_array(job, "matrix", &moves));
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_MATRIX));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 4);
  ARE_DOUBLES(job, "plane_points", 0, 0, 5, 8, 0, 5, 8, 8, 5, 0, 8, 5, 3, 4, 5);
  ARE_DOUBLES(job, "plane_matrix", 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1);
  CHECK_OK(job, ahd_set_projection(job, turn, &calls));
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_CALLBACK));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 4 && calls == 1);
  ARE_DOUBLES(job, "plane_points", 0, 0, 5, 8, 0, 5, 8, 8, 5, 0, 8, 5, 3, 4, 5);
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_get_array(job, "plane_matrix", AHD_FLOAT64, fitted, 16));
  ahd_job_free(job);
}

/* The flat triangle along a bent side, bounding points, and the Voronoi diagram. */
static void test_rims(void)
{
  static const double bent[] = { 0, 0, 4, 0.001, 8, 0, 4, 4 };
  static const double square[] = { 0, 0, 2, 0, 2, 2, 0, 2 };
  ahd_job* job = ahd_job_of(bent, 4, 2);
  double area = -7.0;
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 3 && ahd_counted(job, "trimmed_triangles") == 0);
  CHECK_OK(job, ahd_set_int(job, "rim", AHD_RIM_TRIMMED));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 2 && ahd_counted(job, "trimmed_triangles") == 1);
  CHECK(ahd_counted(job, "bare_vertices") == 0);
  CHECK_OK(job, ahd_measure(job, "trimmed_area", &area));
  CHECK(area > 0.0002 && area < 0.0003);
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_BEST_FIT)); /* all z are the same */
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "trimmed_triangles") == 1);
  CHECK_OK(job, ahd_set_int(job, "rim", AHD_RIM_AUTOMATIC));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 3 && ahd_counted(job, "trimmed_triangles") == 0);
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_XY));
  CHECK_OK(job, ahd_set_int(job, "rim", AHD_RIM_TRIMMED));
  CHECK_OK(job, ahd_set_int(job, "bounding", 1));
  CHECK_OK(job, ahd_set_double(job, "offset", 2.0));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "added_points") == 8 && ahd_counted(job, "inserted") == 12);
  CHECK(ahd_counted(job, "trimmed_triangles") == 0);
  ahd_job_free(job);
  job = ahd_job_of(square, 4, 2);
  CHECK_OK(job, ahd_set_int(job, "want_voronoi", 1));
  CHECK_OK(job, ahd_run(job));
  ARE(job, "voronoi_offsets", 0, 4, 8, 12, 16);
  ARE(job, "voronoi_sites", 0, 1, 2, 3);
  {
    uint64_t corners = 0, numbers = 0;
    free(ahd_read_ids(job, "voronoi_corners", &corners));
    free(ahd_read_doubles(job, "voronoi_points", &numbers));
    CHECK(corners == 16 && numbers == 18);
  }
  CHECK_OK(job, ahd_set_int(job, "voronoi_clip", AHD_CLIP_BOUNDS));
  CHECK_OK(job, ahd_run(job));
  ARE(job, "voronoi_offsets", 0, 4, 8, 12, 16);
  {
    static const double polygon[] = { -1, -1, -1, 9, 9, -1, 0,
      0 }; /* the lower left half of a box */
    ahd_array corners = { polygon, AHD_FLOAT64, 2, 3, 2 * sizeof(double), sizeof(double) };
    uint64_t estimate = 0;
    CHECK_OK(job, ahd_set_int(job, "voronoi_clip", AHD_CLIP_POLYGON));
    CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_run(job)); /* there is none */
    CHECK_SAYS(job, "\"voronoi_polygon\" has no area");
    CHECK_OK(job, ahd_set_array(job, "voronoi_polygon", &corners));
    CHECK_OK(job, ahd_estimate(job, &estimate));
    CHECK_OK(job, ahd_run(job));
    ARE(job, "voronoi_sites", 0, 1, 2, 3);
    corners.rows = 2; /* a box of no width */
    CHECK_OK(job, ahd_set_array(job, "voronoi_polygon", &corners));
    CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_run(job));
    CHECK_SAYS(job, "has no area");
    corners.rows = 4;
    CHECK_OK(job, ahd_set_array(job, "voronoi_polygon", &corners));
    CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_run(job));
    CHECK_SAYS(job, "is not convex");
    corners.type = AHD_FLOAT32;
    CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "voronoi_polygon", &corners));
    CHECK_OK(job, ahd_set_int(job, "want_voronoi", 0));
    CHECK_OK(job, ahd_run(job)); /* not looked at */
    CHECK_OK(job, ahd_set_int(job, "want_voronoi", 1));
    CHECK_OK(job, ahd_set_int(job, "voronoi_clip", AHD_CLIP_HULL));
  }
  CHECK_OK(job, ahd_set_array(job, "points", NULL));
  CHECK_OK(job, ahd_run(job)); /* of no points */
  ARE(job, "voronoi_offsets", 0);
  CHECK(ahd_counted(job, "triangles") == 0 && ahd_counted(job, "points") == 0);
  ahd_job_free(job);
}

/* The order of four points, and as it is drawn. */
static void test_order(void)
{
  static const double square[] = { 0, 0, 1, 2, 0, 1, 2, 2, 1, 0, 2, 1 };
  ahd_job* job = ahd_job_of(square, 4, 3);
  double xyz[60];
  int32_t levels[5] = { 7, 7, 7, 7, 7 }, ranks[20], ids[20], counts[5];
  ahd_drawing drawing = { xyz, ranks, ids, levels, counts };
  double np = 7;
  CHECK_OK(job, ahd_set_int(job, "insertion_order", AHD_ORDER_AS_GIVEN));
  CHECK_OK(job, ahd_run(job));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_get_array(job, "order", AHD_INT32, ids, 20));
  CHECK_SAYS(job, "want_order");
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_get_array(job, "box_levels", AHD_INT32, ids, 20));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_draw_order(job, AHD_INT32, &drawing));
  CHECK_OK(job, ahd_measure(job, "np", &np));
  CHECK(np == -1);
  CHECK_OK(job, ahd_set_int(job, "want_order", 1));
  CHECK_OK(job, ahd_set_int(job, "insertion_limit", 3));
  CHECK_OK(job, ahd_set_int(job, "count_work", 1));
  CHECK_OK(job, ahd_run(job));
  ARE(job, "order", 0, 1, 2);
  ARE(job, "insertion_ranks", 0, 1, 2, 3);
  CHECK(ahd_counted(job, "beyond_limit") == 1 && ahd_counted(job, "triangles") == 1);
  CHECK_OK(job, ahd_measure(job, "np", &np));
  CHECK(np >= 0);
  CHECK_OK(job, ahd_set_int(job, "insertion_limit", 0));
  CHECK_OK(job, ahd_set_int(job, "insertion_order", AHD_ORDER_REGULAR_GRID));
  CHECK_OK(job, ahd_set_int(job, "want_boxes", 1));
  CHECK_OK(job, ahd_set_int(job, "want_curve", 1));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "boxes") == 4);
  {
    static const double expected[] = { 0, 1, 0, 1, 1, 2, 0, 1, 0, 1, 1, 2, 1, 2, 1, 2 };
    uint64_t numbers = 0, i;
    double* bounds = ahd_read_doubles(job, "box_bounds", &numbers);
    CHECK(numbers == 16);
    for (i = 0; i < numbers; ++i) /* they are quantised */
    {
      CHECK(fabs(bounds[i] - expected[i]) < 1e-6);
    }
    free(bounds);
  }
  ARE(job, "box_counts", 1, 1, 1, 1);
  CHECK(ahd_counted(job, "drawn_points") == 20 && ahd_counted(job, "drawn_cells") == 5);
  CHECK_OK(job, ahd_draw_order(job, AHD_INT32, &drawing));
  CHECK(levels[0] == -1 && counts[0] == 4 && counts[1] == 1 && ranks[3] == 3 && ranks[4] == -1);
  CHECK(xyz[12] == 0 && fabs(xyz[15] - 1) < 1e-6 && xyz[14] == 1 && ids[7] == -1);
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_draw_order(job, AHD_FLOAT32, &drawing));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_draw_order(job, AHD_INT32, NULL));
  drawing.ids = NULL;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_draw_order(job, AHD_INT32, &drawing));
  ahd_job_free(job);
}

void test_results(void)
{
  test_square();
  test_layouts();
  test_flat_rows();
  test_points();
  test_constraints();
  test_source();
  test_source_lines();
  test_sizes();
  test_planes();
  test_rims();
  test_order();
}
