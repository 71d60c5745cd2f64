/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Points that come, go and move: a run of what is written is that of what is left; each request is
 * reported, refusals of the call, cancelling.
 */
#include "Check.h"

#include <stdlib.h>

enum
{
  kCount = 400
};

static int64_t insert_point(ahd_job* job, double x, double y)
{
  int64_t id = -7;
  double xy[2];
  xy[0] = x;
  xy[1] = y;
  CHECK_OK(job, ahd_edit_insert(job, xy, 1, &id));
  return id;
}

/* Memory is asked for points that come, not for the other calls. */
static void test_memory_limit(void)
{
  const double xy[] = { 0, 0, 4, 0, 0, 4, 1, 1 }, to[] = { 2, 1 };
  const int64_t ids[] = { 3, 1 };
  double left[8];
  int64_t first = -7, place[3], written[4], pairs[2];
  int32_t kind = 0;
  uint8_t outcome = 0;
  ahd_job* job = ahd_job_new();
  CHECK_OK(job, ahd_edit_insert(job, xy, 4, &first));
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 1));
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_edit_insert(job, to, 1, &first));
  CHECK_OK(job, ahd_edit_move(job, ids, to, 1, &outcome));
  CHECK_OK(job, ahd_edit_constrain(job, ids, 1, &outcome));
  CHECK(outcome == AHD_EDIT_DONE);
  CHECK_OK(job, ahd_edit_locate(job, to, 1, &kind, place));
  CHECK(kind == AHD_ON_VERTEX && place[0] == 3);
  CHECK_OK(job, ahd_edit_write(job, written, left, pairs));
  CHECK(left[6] == 2 && left[7] == 1 && pairs[0] == 1 && pairs[1] == 3);
  CHECK_OK(job, ahd_edit_release(job, ids, 1, &outcome));
  CHECK_OK(job, ahd_edit_remove(job, ids, 1, &outcome));
  CHECK(outcome == AHD_EDIT_DONE);
  ahd_job_free(job);
}

/* A run of what is left has these triangles around the point, and as many as another one. */
static void test_a_history(void)
{
  static const int64_t gone[] = { 3, 4, 5, 3 }, ends[] = { 10, 200, 10, 10, 3, 9 };
  const double to[] = { 2.0, 2.0 };
  double *xy = ahd_scattered(kCount), *left = (double*)malloc(2 * kCount * sizeof(double));
  int64_t first = -7, ids[kCount + 1], pairs[2], moved = 10, place_ids[6];
  uint8_t outcomes[4];
  uint64_t points = 0, segments = 0, numbers, expected;
  int32_t kinds[2];
  ahd_job *job = ahd_job_new(), *run, *fresh;
  int64_t *triangles, *others;
  ahd_array line;
  CHECK_OK(job, ahd_edit_insert(job, xy, kCount, &first));
  CHECK(first == 0);
  CHECK_OK(job, ahd_edit_remove(job, gone, 4, outcomes));
  CHECK(outcomes[0] == AHD_EDIT_DONE && outcomes[2] == AHD_EDIT_DONE);
  CHECK(outcomes[3] == AHD_EDIT_NO_POINT);
  CHECK_OK(job, ahd_edit_constrain(job, ends, 3, outcomes));
  CHECK(outcomes[0] == AHD_EDIT_DONE && outcomes[1] == AHD_EDIT_NO_LENGTH);
  CHECK(outcomes[2] == AHD_EDIT_NO_POINT);
  CHECK_OK(job, ahd_edit_move(job, &moved, to, 1, outcomes));
  CHECK(outcomes[0] == AHD_EDIT_END_OF_SEGMENT);
  moved = 11;
  CHECK_OK(job, ahd_edit_move(job, &moved, to, 1, outcomes));
  CHECK(outcomes[0] == AHD_EDIT_DONE);
  CHECK_OK(job, ahd_edit_locate(job, to, 1, kinds, place_ids));
  CHECK(kinds[0] == AHD_ON_VERTEX && place_ids[0] == 11 && place_ids[1] == -1);
  CHECK(insert_point(job, xy[6], xy[7]) == kCount);
  CHECK_OK(job, ahd_edit_size(job, &points, &segments));
  CHECK(points == kCount - 2 && segments == 1);
  CHECK_OK(job, ahd_edit_write(job, ids, left, pairs));
  CHECK(ids[2] == 2 && ids[3] == 6 && ids[kCount - 3] == kCount);
  CHECK(ids[pairs[0]] == 10 && ids[pairs[1]] == 200);
  run = ahd_job_of(left, (int64_t)points, 2);
  line = ahd_ids(pairs, 1, 2);
  CHECK_OK(run, ahd_set_array(run, "line_ids", &line));
  CHECK_OK(run, ahd_run(run));
  triangles = ahd_read_ids(run, "triangles", &numbers);
  xy[22] = xy[23] = 2.0; /* the same history, of the input */
  memmove(xy + 6, xy + 12, (2 * kCount - 12) * sizeof(double));
  xy[2 * kCount - 6] = left[2 * kCount - 6];
  xy[2 * kCount - 5] = left[2 * kCount - 5];
  fresh = ahd_job_of(xy, (int64_t)points, 2);
  CHECK_OK(fresh, ahd_set_array(fresh, "line_ids", &line));
  CHECK_OK(fresh, ahd_run(fresh));
  others = ahd_read_ids(fresh, "triangles", &expected);
  CHECK(numbers == expected && memcmp(triangles, others, numbers * sizeof(int64_t)) == 0);
  CHECK_OK(job, ahd_edit_release(job, ends, 1, outcomes));
  CHECK(outcomes[0] == AHD_EDIT_DONE);
  CHECK_OK(job, ahd_edit_release(job, ends, 1, outcomes));
  CHECK(outcomes[0] == AHD_EDIT_NO_SEGMENT);
  CHECK_OK(job, ahd_reset(job, 0));
  CHECK_OK(job, ahd_edit_size(job, &points, &segments));
  CHECK(points == 0 && segments == 0);
  CHECK_OK(job, ahd_edit_write(job, NULL, NULL, NULL));
  free(triangles);
  free(others);
  free(left);
  free(xy);
  ahd_job_free(job);
  ahd_job_free(run);
  ahd_job_free(fresh);
}

static int32_t cancel(void* user, int32_t phase, double fraction)
{
  (void)phase;
  CHECK(fraction >= 0.0 && fraction <= 1.0);
  return --*(int32_t*)user <= 0;
}

static void test_refusals(void)
{
  enum
  {
    kMany = 50000
  };
  double* xy = ahd_scattered(kMany);
  const int64_t id = 0;
  int64_t first = -7, place[3], ends[2] = { 0, 0 };
  int32_t calls = 2, kind, ready = 7;
  uint8_t outcome = 0;
  uint64_t points = 7, segments = 7;
  ahd_job* job = ahd_job_new();
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_edit_insert(NULL, xy, 1, &first));
  CHECK_NULL(job, "points", ahd_edit_insert(job, NULL, 1, &first));
  CHECK_NULL(job, "first id", ahd_edit_insert(job, xy, 1, NULL));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_edit_insert(job, xy, (uint64_t)-1, &first));
  CHECK_STATUS(job, AHD_TOO_MANY_POINTS, ahd_edit_insert(job, xy, (uint64_t)1 << 28, &first));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_edit_remove(job, &id, (uint64_t)-1, &outcome));
  CHECK_SAYS(job, "requests do not fit in any memory");
  CHECK(outcome == 0);
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_edit_locate(job, xy, (uint64_t)-1, &kind, place));
  CHECK_SAYS(job, "places do not fit in any memory");
  CHECK_NULL(job, "requests", ahd_edit_remove(job, NULL, 1, &outcome));
  CHECK_NULL(job, "outcomes", ahd_edit_remove(job, &id, 1, NULL));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_edit_move(job, &id, NULL, 1, &outcome));
  CHECK_NULL(job, "places", ahd_edit_locate(job, NULL, 1, &kind, place));
  CHECK_NULL(job, "kinds", ahd_edit_locate(job, xy, 1, NULL, place));
  CHECK_NULL(job, "ids", ahd_edit_locate(job, xy, 1, &kind, NULL));
  CHECK_NULL(job, "points", ahd_edit_size(job, NULL, &segments));
  CHECK_NULL(job, "segments", ahd_edit_size(job, &points, NULL));
  CHECK_NULL(job, "ready", ahd_edit_ready(job, NULL));
  CHECK_OK(job, ahd_edit_remove(job, NULL, 0, NULL));
  CHECK_OK(job, ahd_edit_locate(job, NULL, 0, NULL, NULL));
  CHECK_OK(job, ahd_edit_locate(job, xy, 1, &kind, place));
  CHECK(kind == AHD_NOWHERE && place[0] == -1);
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 1000));
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_edit_insert(job, xy, kMany, &first));
  CHECK_SAYS(job, "Editing 50000 points");
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 0));
  CHECK_OK(job, ahd_set_progress(job, cancel, &calls));
  CHECK_STATUS(job, AHD_CANCELLED, ahd_edit_insert(job, xy, kMany, &first));
  CHECK_OK(job, ahd_edit_ready(job, &ready));
  CHECK(ready == 0);
  CHECK_OK(job, ahd_edit_size(job, &points, &segments));
  CHECK(points == 0 && segments == 0);
  calls = 1 << 30;
  CHECK_OK(job, ahd_edit_insert(job, xy, kMany, &first));
  CHECK(first == 0 && calls < 1 << 30);
  CHECK_OK(job, ahd_edit_ready(job, &ready));
  CHECK(ready == 1);
  ends[1] = kMany - 1;
  CHECK_OK(job, ahd_edit_constrain(job, ends, 1, &outcome));
  CHECK(outcome == AHD_EDIT_DONE);
  CHECK_NULL(job, "ids", ahd_edit_write(job, NULL, xy, ends));
  CHECK_NULL(job, "points", ahd_edit_write(job, ends, NULL, ends));
  CHECK_NULL(job, "segments", ahd_edit_write(job, ends, xy, NULL));
  ahd_cancel(job);
  CHECK_STATUS(job, AHD_CANCELLED, ahd_edit_remove(job, &id, 1, &outcome));
  CHECK(outcome == AHD_EDIT_NOT_TRIED);
  free(xy);
  ahd_job_free(job);
}

void test_edit(void)
{
  test_a_history();
  test_memory_limit();
  test_refusals();
}
