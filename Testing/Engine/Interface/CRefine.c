/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Points to add: a run with them has the triangles that were promised, and data that were
 * interpolated; refusals, cancelling.
 */
#include "Check.h"

#include <math.h>
#include <stdlib.h>

static const double kSquares[] = { 0, 0, 8, 0, 8, 8, 0, 8, 2, 2, 3, 2, 3, 3, 2, 3, 6, 5, 7.5, 7 };
static const int64_t kLoops[] = { 0, 1, 2, 3, 4, 5, 6, 7 }, kOffsets[] = { 0, 4, 8 };
static const int64_t kLine[] = { 8, 9 };

static ahd_job* job_of_squares(void)
{
  ahd_job* job = ahd_job_of(kSquares, 10, 2);
  ahd_array loops = ahd_ids(kLoops, 8, 1), offsets = ahd_ids(kOffsets, 3, 1);
  ahd_array line = ahd_ids(kLine, 1, 2);
  CHECK_OK(job, ahd_set_array(job, "loop_ids", &loops));
  CHECK_OK(job, ahd_set_array(job, "loop_offsets", &offsets));
  CHECK_OK(job, ahd_set_array(job, "line_ids", &line));
  CHECK_OK(job, ahd_set_int(job, "fill_rule", AHD_FILL_EVEN_ODD));
  CHECK_OK(job, ahd_run(job));
  return job;
}

/* x and y are linear, so the weights give the places. */
static void check_weights(const double* all, const ahd_refined* made, uint64_t count)
{
  uint64_t k;
  int e;
  for (k = 0; k < count; ++k)
  {
    double x = 0.0, y = 0.0;
    for (e = 0; e < 3; ++e)
    {
      const int64_t id = made->corners[3 * k + (uint64_t)e];
      const double weight = made->weights[3 * k + (uint64_t)e];
      CHECK(id >= 0 ? id < 10 : e == 2 && weight == 0.0);
      x += id < 0 ? 0.0 : weight * all[2 * id];
      y += id < 0 ? 0.0 : weight * all[2 * id + 1];
    }
    CHECK(fabs(x - made->places[2 * k]) < 1e-14 && fabs(y - made->places[2 * k + 1]) < 1e-14);
  }
}

/* Of the outline, a hole and a line, in this order of cells: the line is cell 0. */
static void check_pieces(const ahd_refined* made, const ahd_refine_report* report)
{
  uint64_t k, of_cell[3] = { 0, 0, 0 };
  for (k = 0; k < report->pieces; ++k)
  {
    CHECK((made->piece_cells[k] == 0) == (k < report->inner_pieces));
    CHECK(made->piece_edges[2 * k] < 10 && made->piece_edges[2 * k + 1] < 10);
    CHECK(made->pieces[2 * k] != made->pieces[2 * k + 1]);
    ++of_cell[made->piece_cells[k]];
  }
  CHECK(report->inner_pieces > 1 && of_cell[0] == report->inner_pieces);
  CHECK(of_cell[1] > of_cell[2] && of_cell[2] >= 4);
}

/* Every triangle is of the one region, and the least angle is as wished. */
static void check_triangles(ahd_job* job, ahd_job* run)
{
  const uint64_t count = (uint64_t)ahd_counted(run, "triangles");
  int32_t* corners = (int32_t*)malloc(3 * count * sizeof(int32_t));
  int64_t* regions = (int64_t*)calloc(count, sizeof(int64_t));
  ahd_refined_triangles triangles;
  triangles.corners = corners;
  triangles.count = count;
  triangles.regions = regions;
  triangles.bad = NULL;
  CHECK_OK(run, ahd_get_array(run, "triangles", AHD_INT32, corners, 3 * count));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_refine_triangles(NULL, &triangles));
  CHECK_STATUS(run, AHD_NOT_AVAILABLE, ahd_refine_triangles(run, &triangles));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_refine_triangles(job, NULL));
  CHECK_OK(job, ahd_refine_triangles(job, &triangles));
  CHECK(triangles.least_angle > 30.0 - 1e-9 && triangles.least_angle < 60.0 && regions[0] == 0);
  corners[0] = -1;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_refine_triangles(job, &triangles));
  corners[0] = 1 << 30;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_refine_triangles(job, &triangles));
  triangles.corners = NULL;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_refine_triangles(job, &triangles));
  triangles.count = 0;
  CHECK_OK(job, ahd_refine_triangles(job, &triangles));
  CHECK(triangles.least_angle == 0.0);
  free(corners);
  free(regions);
}

static void test_a_run_with_them(void)
{
  const ahd_refine_request wished = { 30.0, 0.5, 0.0, NULL, AHD_REFINE_ALL };
  ahd_refine_report report;
  ahd_refined made;
  ahd_job *job = job_of_squares(), *run;
  ahd_array lines, offsets, loops, loop_offsets;
  double* all;
  int64_t ends[3], first;
  CHECK_OK(job, ahd_refine(job, &wished, &report));
  CHECK(report.points > 100 && report.on_segments > 10 && report.lines == 1);
  CHECK(report.chains == 3 && report.bad == 0 && report.encroached_pieces == 0);
  all = (double*)malloc((20 + 2 * report.points) * sizeof(double));
  memcpy(all, kSquares, sizeof kSquares);
  memset(&made, 0, sizeof made);
  CHECK_OK(job, ahd_refine_write(job, &made));
  made.places = all + 20;
  made.corners = (int64_t*)malloc(3 * report.points * sizeof(int64_t));
  made.weights = (double*)malloc(3 * report.points * sizeof(double));
  made.ids = (int64_t*)malloc(report.ids * sizeof(int64_t));
  made.offsets = (int64_t*)malloc((report.chains + 1) * sizeof(int64_t));
  made.pieces = (int64_t*)malloc(2 * report.pieces * sizeof(int64_t));
  made.piece_edges = (int64_t*)malloc(2 * report.pieces * sizeof(int64_t));
  made.piece_cells = (int64_t*)malloc(report.pieces * sizeof(int64_t));
  CHECK_OK(job, ahd_refine_write(job, &made));
  check_weights(all, &made, report.points);
  check_pieces(&made, &report);
  run = ahd_job_of(all, (int64_t)(10 + report.points), 2);
  first = made.offsets[report.lines];
  lines = ahd_ids(made.ids, first, 1);
  offsets = ahd_ids(made.offsets, (int64_t)report.lines + 1, 1);
  CHECK_OK(run, ahd_set_array(run, "line_ids", &lines));
  CHECK_OK(run, ahd_set_array(run, "line_offsets", &offsets));
  loops = ahd_ids(made.ids + first, (int64_t)report.ids - first, 1);
  ends[0] = 0;
  ends[1] = made.offsets[2] - first;
  ends[2] = made.offsets[3] - first;
  loop_offsets = ahd_ids(ends, 3, 1);
  CHECK_OK(run, ahd_set_array(run, "loop_ids", &loops));
  CHECK_OK(run, ahd_set_array(run, "loop_offsets", &loop_offsets));
  CHECK_OK(run, ahd_set_int(run, "fill_rule", AHD_FILL_EVEN_ODD));
  CHECK_OK(run, ahd_run(run));
  CHECK(ahd_counted(run, "triangles") == (int64_t)report.triangles);
  check_triangles(job, run);
  free(all);
  free(made.corners);
  free(made.weights);
  free(made.ids);
  free(made.offsets);
  free(made.pieces);
  free(made.piece_edges);
  free(made.piece_cells);
  ahd_job_free(run);
  ahd_job_free(job);
}

/* Both are the same triangle: its corners counterclockwise, from any of them. */
static int is_same_triangle(const int32_t* one, const int64_t* other)
{
  int from;
  for (from = 0; from < 3; ++from)
  {
    if (one[from] == other[0] && one[(from + 1) % 3] == other[1] && one[(from + 2) % 3] == other[2])
    {
      return 1;
    }
  }
  return 0;
}

/* With a few points only, triangles that are too large or narrow are named by their corners and by
 * their numbers alike. */
static void test_what_is_left(void)
{
  const ahd_refine_request wished = { 20.0, 4.0, 0.0, NULL, 5 };
  ahd_refine_report report;
  ahd_refined made;
  ahd_refined_triangles triangles;
  ahd_job *job = ahd_job_of(kSquares, 8, 2), *run;
  double all[26];
  int32_t* corners;
  uint64_t k;
  CHECK_OK(job, ahd_run(job));
  CHECK_OK(job, ahd_refine(job, &wished, &report));
  CHECK(report.points == 5 && report.bad > 2 && report.bad < report.triangles);
  memcpy(all, kSquares, 16 * sizeof(double));
  memset(&made, 0, sizeof made);
  made.places = all + 16;
  made.bad = (int64_t*)malloc(3 * report.bad * sizeof(int64_t));
  made.reasons = (int32_t*)malloc(report.bad * sizeof(int32_t));
  CHECK_OK(job, ahd_refine_write(job, &made));
  run = ahd_job_of(all, 13, 2);
  CHECK_OK(run, ahd_run(run));
  memset(&triangles, 0, sizeof triangles);
  triangles.count = (uint64_t)ahd_counted(run, "triangles");
  CHECK(triangles.count == report.triangles);
  corners = (int32_t*)malloc(3 * triangles.count * sizeof(int32_t));
  CHECK_OK(run, ahd_get_array(run, "triangles", AHD_INT32, corners, 3 * triangles.count));
  triangles.corners = corners;
  triangles.bad = (int64_t*)malloc(report.bad * sizeof(int64_t));
  CHECK_OK(job, ahd_refine_triangles(job, &triangles));
  for (k = 0; k < report.bad; ++k)
  {
    const int64_t number = triangles.bad[k];
    CHECK(number >= 0 && (uint64_t)number < triangles.count);
    CHECK(is_same_triangle(corners + 3 * number, made.bad + 3 * k));
    CHECK(made.reasons[k] == AHD_REFINE_BUDGET);
  }
  free(corners);
  free(triangles.bad);
  free(made.bad);
  free(made.reasons);
  ahd_job_free(run);
  ahd_job_free(job);
}

static int32_t cancel(void* user, int32_t phase, double fraction)
{
  (void)user;
  (void)phase;
  (void)fraction;
  return 1;
}

static void test_refusals(void)
{
  ahd_refine_request wished = { 35.0, 0.0, 0.0, NULL, AHD_REFINE_ALL };
  double sizes[] = { 1, 1, 1, 1, 1, 1, 1, -2, 1, 1 };
  ahd_refine_report report;
  ahd_refined none;
  ahd_job *job = job_of_squares(), *fresh = ahd_job_new();
  memset(&none, 0, sizeof none);
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_refine(NULL, &wished, &report));
  CHECK_STATUS(fresh, AHD_NOT_AVAILABLE, ahd_refine(fresh, &wished, &report));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_refine_write(job, &none));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_refine(job, NULL, &report));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_refine(job, &wished, NULL));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_refine(job, &wished, &report));
  CHECK_SAYS(job, "35.0");
  wished.minimum_angle = 20.0;
  wished.sizes = sizes;
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_refine(job, &wished, &report));
  CHECK_SAYS(job, "The size at point 7 is -2.0");
  sizes[7] = 1.0;
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 20000));
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_refine(job, &wished, &report));
  CHECK_SAYS(job, "Refining the triangles of");
  CHECK(report.memory_needed > report.memory_allowed && report.memory_allowed == 20000);
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 0));
  CHECK_OK(job, ahd_set_progress(job, cancel, NULL));
  CHECK_STATUS(job, AHD_CANCELLED, ahd_refine(job, &wished, &report));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_refine_write(job, &none));
  CHECK_OK(job, ahd_set_progress(job, NULL, NULL));
  CHECK_OK(job, ahd_refine(job, &wished, &report));
  CHECK(report.points > 60);
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_refine_write(job, NULL));
  ahd_job_free(fresh);
  ahd_job_free(job);
}

/* Points on a line have no triangle, and so no chain: one offset, 0. */
static void test_without_a_triangle(void)
{
  static const double line[] = { 0, 0, 1, 1, 2, 2 };
  ahd_refine_request wished = { 20.0, 0.0, 0.0, NULL, AHD_REFINE_ALL };
  ahd_refine_report report;
  ahd_refined made;
  int64_t offset = 7;
  ahd_job* job = ahd_job_of(line, 3, 2);
  CHECK_OK(job, ahd_run(job));
  CHECK_OK(job, ahd_refine(job, &wished, &report));
  CHECK(report.points == 0 && report.chains == 0 && report.bad == 0);
  memset(&made, 0, sizeof made);
  made.offsets = &offset;
  CHECK_OK(job, ahd_refine_write(job, &made));
  CHECK(offset == 0);
  ahd_job_free(job);
}

void test_refine(void)
{
  test_without_a_triangle();
  test_a_run_with_them();
  test_what_is_left();
  test_refusals();
}
