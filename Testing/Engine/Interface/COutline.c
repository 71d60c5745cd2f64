/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * ahd_outline(), ahd_within_radius(): triangles of a run, bands of polygons, arrays, refusals,
 * cancelling.
 */
#include "Check.h"

#include <math.h>
#include <stdlib.h>

/* A ring of four squares about a hole, and a square that touches it at a corner. */
static const double kPlaces[] = { 0, 0, 3, 0, 3, 3, 0, 3, 1, 1, 2, 1, 2, 2, 1, 2, 4, 3, 4, 4, 3,
  4 };
static const int64_t kCells[] = { 0, 1, 5, 4, 2, 6, 5, 1, 2, 3, 7, 6, 3, 0, 4, 7, 2, 8, 9, 10 };

static void expect(ahd_job* job, const char* name, const int64_t* numbers, uint64_t count)
{
  uint64_t found = 0;
  int64_t* ids = ahd_read_ids(job, name, &found);
  CHECK(found == count && memcmp(ids, numbers, count * sizeof(int64_t)) == 0);
  free(ids);
}

static ahd_job* frame(void)
{
  ahd_job* job = ahd_job_of(kPlaces, 11, 2);
  const ahd_array cells = ahd_ids(kCells, 5, 4);
  CHECK_OK(job, ahd_set_array(job, "cells", &cells));
  return job;
}

static void test_rings(void)
{
  static const int64_t corners[] = { 0, 1, 2, 3, 4, 7, 6, 5, 2, 8, 9, 10 };
  static const int64_t rings[] = { 0, 4, 8, 12 }, polygons[] = { 0, 2, 3 }, cells[] = { 0, 4 };
  ahd_outline_report report = { 9, 9, 0, 0, 9 };
  int32_t narrow[12] = { -1 };
  ahd_job* job = frame();
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_get_array(job, "outline_points", AHD_INT32, narrow, 12));
  CHECK_SAYS(job, "ahd_outline");
  CHECK_OK(job, ahd_outline(job, &report));
  CHECK(report.unfit_cells == 0 && report.unfit_edges == 0 && report.plane == 2);
  CHECK(report.memory_needed > 0 && report.memory_allowed > report.memory_needed);
  expect(job, "outline_points", corners, 12);
  expect(job, "outline_rings", rings, 4);
  expect(job, "outline_polygons", polygons, 3);
  expect(job, "outline_cells", cells, 2);
  CHECK_OK(job, ahd_get_array(job, "outline_points", AHD_INT32, narrow, 12));
  CHECK(narrow[0] == 0 && narrow[11] == 10);
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_get_array(job, "outline_points", AHD_FLOAT64, narrow, 12));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_get_array(job, "outline_points", AHD_INT32, narrow, 11));
  CHECK_OK(job, ahd_release(job, 0));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_get_array(job, "outline_rings", AHD_INT32, narrow, 4));
  ahd_job_free(job);
}

static void test_groups(void)
{
  static const int64_t cells[] = { 2, 0 }; /* by their numbers */
  const double groups[] = { 7, NAN, 7, NAN, -1, NAN, 7, NAN, NAN, NAN };
  const ahd_array given = { groups, AHD_FLOAT64, 1, 5, 2 * sizeof(double), sizeof(double) };
  const ahd_array few = { groups, AHD_FLOAT64, 1, 4, sizeof(double), sizeof(double) };
  static const int64_t offsets[] = { 0, 4, 8, 12, 16, 20 };
  const ahd_array list = ahd_ids(kCells, 20, 1), ends = ahd_ids(offsets, 6, 1);
  ahd_outline_report report;
  ahd_job* job = frame();
  CHECK_OK(job, ahd_set_array(job, "cells", &list));
  CHECK_OK(job, ahd_set_array(job, "cell_offsets", &ends));
  CHECK_OK(job, ahd_set_array(job, "cell_groups", &given)); /* 7, 7, -1, 7, NaN */
  CHECK_OK(job, ahd_outline(job, &report));
  CHECK(report.unfit_cells == 0);
  expect(job, "outline_cells", cells, 2);
  CHECK_OK(job, ahd_set_array(job, "cell_groups", &few));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_outline(job, &report));
  CHECK_SAYS(job, "4 rows, and there are 5 cells");
  ahd_job_free(job);
}

/* The triangles of a run have the hull as their outline; the run's result stays. */
static void test_of_a_run(void)
{
  double* xy = ahd_scattered(2000);
  ahd_job* job = ahd_job_of(xy, 2000, 2);
  uint64_t numbers = 0, after = 0, rings = 0, one = 0;
  int64_t *triangles, *again;
  ahd_array cells;
  CHECK_OK(job, ahd_run(job));
  triangles = ahd_read_ids(job, "triangles", &numbers);
  cells = ahd_ids(triangles, (int64_t)numbers / 3, 3);
  {
    ahd_job* other = ahd_job_of(xy, 2000, 2);
    CHECK_OK(other, ahd_set_array(other, "cells", &cells));
    CHECK_OK(other, ahd_run(other)); /* cells are nothing to it */
    CHECK_OK(other, ahd_outline(other, NULL));
    CHECK_OK(other, ahd_array_size(other, "outline_rings", &rings, &one));
    CHECK(rings == 2 && one == 1);
    again = ahd_read_ids(other, "triangles", &after);
    CHECK(after == numbers && memcmp(again, triangles, numbers * sizeof(int64_t)) == 0);
    free(again);
    ahd_job_free(other);
  }
  free(triangles);
  free(xy);
  ahd_job_free(job);
}

typedef struct told
{
  int calls, last_call;
  double fraction;
} told;

static int32_t listen(void* user, int32_t phase, double fraction)
{
  told* own = (told*)user;
  (void)phase;
  CHECK(fraction >= own->fraction && fraction <= 1.0);
  own->fraction = fraction;
  return ++own->calls == own->last_call;
}

static void test_refusals(void)
{
  static const int64_t bad[] = { 0, 9, 5, 20 };
  const ahd_array list = ahd_ids(kCells, 20, 1), ends = ahd_ids(bad, 4, 1);
  ahd_outline_report report = { 0, 0, 0, 0, 0 };
  told own = { 0, 0, 0.0 };
  int32_t out[4];
  ahd_job* job = frame();
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_outline(NULL, &report));
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 100));
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_outline(job, &report));
  CHECK_SAYS(job, "outline of 5 cells");
  CHECK(report.memory_allowed == 100 && report.memory_needed > 100);
  CHECK_OK(job, ahd_set_int(job, "memory_limit", (int64_t)report.memory_needed));
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_outline(job, &report)); /* for the edges of the outline */
  CHECK_OK(job, ahd_set_int(job, "memory_limit", (int64_t)report.memory_needed));
  CHECK_OK(job, ahd_outline(job, &report));
  CHECK_OK(job, ahd_set_int(job, "other_memory", 1));
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_outline(job, &report));
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 0));
  CHECK_OK(job, ahd_set_progress(job, listen, &own));
  CHECK_OK(job, ahd_outline(job, NULL));
  CHECK(own.calls > 0 && own.fraction == 1.0);
  for (own.last_call = own.calls; own.last_call > 0; --own.last_call)
  {
    own.calls = 0;
    own.fraction = 0.0;
    CHECK_STATUS(job, AHD_CANCELLED, ahd_outline(job, NULL));
    CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_get_array(job, "outline_rings", AHD_INT32, out, 4));
  }
  CHECK_OK(job, ahd_set_progress(job, NULL, NULL));
  ahd_cancel(job);
  CHECK_STATUS(job, AHD_CANCELLED, ahd_outline(job, NULL));
  CHECK_OK(job, ahd_set_array(job, "cells", &list));
  CHECK_OK(job, ahd_set_array(job, "cell_offsets", &ends));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_outline(job, NULL));
  CHECK_OK(job, ahd_set_array(job, "cell_offsets", NULL));
  CHECK_OK(job, ahd_set_array(job, "cells", NULL));
  CHECK_OK(job, ahd_outline(job, NULL)); /* nothing has no outline */
  CHECK_OK(job, ahd_get_array(job, "outline_rings", AHD_INT32, out, 1));
  CHECK(out[0] == 0);
  ahd_job_free(job);
}

/* A triangle whose third corner is at the place of the second. */
static void test_directed(void)
{
  static const double places[] = { 0, 0, 1, 0, 1, 0 };
  static const int64_t triangle[] = { 0, 1, 2 }, corners[] = { 0, 1, 2 }, none[] = { 0 };
  const ahd_array cells = ahd_ids(triangle, 1, 3);
  ahd_outline_report report;
  ahd_job* job = ahd_job_of(places, 3, 2);
  CHECK_OK(job, ahd_set_array(job, "cells", &cells));
  CHECK_OK(job, ahd_outline(job, &report));
  CHECK(report.unfit_cells == 1);
  expect(job, "outline_polygons", none, 1);
  CHECK_OK(job, ahd_outline_directed(job, &report));
  CHECK(report.unfit_cells == 0 && report.plane == 2);
  expect(job, "outline_points", corners, 3);
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_outline_directed(NULL, &report));
  ahd_job_free(job);
}

/* Of a right angle, radius 2.5, on edge, in space, and of no points. */
static void test_within_radius(void)
{
  static const double places[] = { 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 4, 12 };
  static const int64_t triangles[] = { 0, 1, 2, 0, 2, 1, 0, 1, 3, 0, 1, 4, -1, 1, 2 };
  const ahd_array cells = ahd_ids(triangles, 5, 3), list = ahd_ids(triangles, 15, 1);
  told own = { 0, 0, 0.0 };
  uint8_t kept[5];
  ahd_job* job = ahd_job_of(places, 4, 3);
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_within_radius(job, 1.0, kept));
  CHECK_OK(job, ahd_set_array(job, "cells", &cells));
  CHECK_OK(job, ahd_within_radius(job, 2.5, kept));
  CHECK(memcmp(kept, "\1\1\0\0\0", 5) == 0);
  CHECK_OK(job, ahd_within_radius(job, 2.4999999999999996, kept));
  CHECK(memcmp(kept, "\0\0\0\0\0", 5) == 0);
  CHECK_OK(job, ahd_within_radius(job, 7, kept));
  CHECK(memcmp(kept, "\1\1\1\0\0", 5) == 0);
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_within_radius(job, 0.0, kept));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_within_radius(job, NAN, kept));
  CHECK_SAYS(job, "radius");
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_within_radius(job, 1.0, NULL));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_within_radius(NULL, 1.0, kept));
  CHECK_OK(job, ahd_set_progress(job, listen, &own));
  CHECK_OK(job, ahd_within_radius(job, 7, kept));
  CHECK(own.calls > 0 && own.fraction == 1.0);
  for (own.last_call = own.calls; own.last_call > 0; --own.last_call)
  {
    own.calls = 0;
    own.fraction = 0.0;
    CHECK_STATUS(job, AHD_CANCELLED, ahd_within_radius(job, 7, kept));
  }
  CHECK_OK(job, ahd_set_array(job, "cells", &list));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_within_radius(job, 1.0, kept));
  CHECK_SAYS(job, "three columns");
  ahd_job_free(job);
}

void test_outline(void)
{
  test_rings();
  test_directed();
  test_within_radius();
  test_groups();
  test_of_a_run();
  test_refusals();
}
