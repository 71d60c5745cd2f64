/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * What spares callers calls: all counts and measures in one, a job as new, no early reports.
 */
#include "Check.h"

#include <stdlib.h>

enum
{
  kRoom = 256,
  kMany = 200000
};

static void test_all_numbers(void)
{
  static const double square[] = { 0, 0, 1, 0, 1, 1, 0, 1, 0, 0 };
  ahd_job* job = ahd_job_of(square, 5, 2);
  int64_t counts[kRoom] = { 0 };
  double measures[kRoom] = { 0 };
  uint32_t k;
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_counts(job, counts, kRoom));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_measures(job, measures, kRoom));
  CHECK_OK(job, ahd_set_int(job, "count_work", 1));
  CHECK_OK(job, ahd_run(job));
  CHECK_OK(job, ahd_counts(job, counts, kRoom));
  CHECK_OK(job, ahd_measures(job, measures, kRoom));
  for (k = 0; ahd_name(AHD_COUNTS, k); ++k)
  {
    CHECK(counts[k] == ahd_counted(job, ahd_name(AHD_COUNTS, k)));
  }
  CHECK(k > 60 && counts[k] == 0);
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_counts(job, counts, k - 1));
  CHECK_OK(job, ahd_counts(job, counts, k));
  for (k = 0; ahd_name(AHD_MEASURES, k); ++k)
  {
    double value = -1;
    CHECK_OK(job, ahd_measure(job, ahd_name(AHD_MEASURES, k), &value));
    CHECK(measures[k] == value);
  }
  CHECK(k > 8 && measures[k] == 0);
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_measures(job, measures, k - 1));
  CHECK_SAYS(job, "room for");
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_counts(job, NULL, kRoom));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_measures(job, NULL, kRoom));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_counts(NULL, counts, kRoom));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_measures(NULL, measures, kRoom));
  ahd_job_free(job);
}

static int32_t count_calls(void* user, int32_t phase, double fraction)
{
  (void)phase;
  (void)fraction;
  ++*(int*)user;
  return 0;
}

static int32_t lift(void* user, double* xyz, uint64_t count)
{
  (void)xyz;
  *(int*)user += (int)count;
  return 0;
}

/* Nothing of what it was given is left. */
static void test_reset(void)
{
  static const double triangle[] = { 0, 0, 1, 0, 0, 1 };
  const ahd_array points = { triangle, AHD_FLOAT64, 2, 3, 16, 8 };
  ahd_job *job = ahd_job_of(triangle, 3, 2), *fresh = ahd_job_new();
  int calls = 0, lifted = 0;
  uint32_t k;
  for (k = 0; ahd_name(AHD_INT_SETTINGS, k); ++k)
  {
    CHECK_OK(job, ahd_set_int(job, ahd_name(AHD_INT_SETTINGS, k), 1));
  }
  for (k = 0; ahd_name(AHD_DOUBLE_SETTINGS, k); ++k)
  {
    CHECK_OK(job, ahd_set_double(job, ahd_name(AHD_DOUBLE_SETTINGS, k), 0.75));
  }
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 0));
  CHECK_OK(job, ahd_set_int(job, "source_heights", 0));
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_CALLBACK));
  CHECK_OK(job, ahd_set_int(job, "bounding", 0));
  CHECK_OK(job, ahd_set_int(job, "maximum_vertices", 0)); /* not with all others */
  CHECK_OK(job, ahd_set_double(job, "maximum_error", 0));
  CHECK_OK(job, ahd_set_double(job, "progress_delay", 0));
  CHECK_OK(job, ahd_set_projection(job, lift, &lifted));
  CHECK_OK(job, ahd_set_progress(job, count_calls, &calls));
  CHECK_OK(job, ahd_run(job));
  CHECK(calls > 0 && lifted == 3);
  CHECK_OK(job, ahd_reset(job, UINT64_MAX));
  CHECK(ahd_kept_bytes(job) > 0);
  CHECK(ahd_counted(job, "points") == 0);
  for (k = 0; ahd_name(AHD_INT_SETTINGS, k); ++k)
  {
    int64_t is = -1, usual = -2;
    CHECK_OK(job, ahd_get_int(job, ahd_name(AHD_INT_SETTINGS, k), &is));
    CHECK_OK(fresh, ahd_get_int(fresh, ahd_name(AHD_INT_SETTINGS, k), &usual));
    CHECK(is == usual);
  }
  for (k = 0; ahd_name(AHD_DOUBLE_SETTINGS, k); ++k)
  {
    double is = -1, usual = -2;
    CHECK_OK(job, ahd_get_double(job, ahd_name(AHD_DOUBLE_SETTINGS, k), &is));
    CHECK_OK(fresh, ahd_get_double(fresh, ahd_name(AHD_DOUBLE_SETTINGS, k), &usual));
    CHECK(is == usual);
  }
  calls = lifted = 0;
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "points") == 0);
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_CALLBACK));
  CHECK_OK(job, ahd_set_array(job, "points", &points));
  CHECK(ahd_run(job) != AHD_OK); /* without a projection */
  CHECK(calls == 0 && lifted == 0);
  CHECK_OK(job, ahd_reset(job, 0));
  CHECK(ahd_kept_bytes(job) == 0);
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_reset(NULL, 0));
  ahd_job_free(fresh);
  ahd_job_free(job);
}

/* No report within the delay; each call of the library begins anew. */
static void test_progress_delay(void)
{
  double* xy = ahd_scattered(kMany);
  ahd_job* job = ahd_job_of(xy, kMany, 2);
  int calls = 0;
  CHECK_OK(job, ahd_set_progress(job, count_calls, &calls));
  CHECK_OK(job, ahd_set_double(job, "progress_delay", 1e9));
  CHECK_OK(job, ahd_run(job));
  CHECK(calls == 0);
  CHECK_OK(job, ahd_set_double(job, "progress_delay", 1e-9));
  CHECK_OK(job, ahd_run(job));
  CHECK(calls > 20);
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_set_double(job, "progress_delay", -1));
  free(xy);
  ahd_job_free(job);
}

void test_at_once(void)
{
  test_all_numbers();
  test_reset();
  test_progress_delay();
}
