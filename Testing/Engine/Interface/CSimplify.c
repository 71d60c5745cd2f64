/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * maximum_error and maximum_vertices: what is left out, what is said about it, what is refused.
 */
#include "Check.h"

#include <stdlib.h>

#define SIDE 60
#define POINTS (SIDE * SIDE + 2)

/* A raster of two hills, a duplicate of a point that is left out, and a point to skip. */
static ahd_job* job_of_hills(double* xyz)
{
  static unsigned char marks[POINTS];
  ahd_job* job;
  ahd_array skip = { marks, AHD_UINT8, 1, POINTS, 1, 1 };
  int k;
  for (k = 0; k < POINTS; ++k)
  {
    const double x = k % SIDE, y = k / SIDE;
    const double p = (x - 15) / 9, q = (y - 20) / 9, r = (x - 40) / 15, s = (y - 40) / 15;
    xyz[3 * k] = x;
    xyz[3 * k + 1] = y;
    xyz[3 * k + 2] = 8 / (1 + p * p + q * q) - 5 / (1 + r * r + s * s);
  }
  marks[POINTS - 1] = 1;
  job = ahd_job_of(xyz, POINTS, 3);
  CHECK_OK(job, ahd_set_array(job, "skip", &skip));
  return job;
}

static double measured(ahd_job* job, const char* name)
{
  double value = -7;
  CHECK_OK(job, ahd_measure(job, name, &value));
  return value;
}

static void check_counts(ahd_job* job)
{
  CHECK(ahd_counted(job, "inserted") + ahd_counted(job, "duplicates") +
      ahd_counted(job, "not_finite") + ahd_counted(job, "skipped") +
      ahd_counted(job, "merged_points") + ahd_counted(job, "beyond_limit") +
      ahd_counted(job, "within_error") ==
    ahd_counted(job, "points"));
  CHECK(ahd_counted(job, "skipped") == 1);
}

static void test_error(ahd_job* job, double* xyz)
{
  uint64_t rows = 0;
  int64_t *status, left_out = 0;
  int k;
  CHECK_OK(job, ahd_set_int(job, "want_point_status", 1));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "within_error") == 0 && measured(job, "largest_error") == 0);
  CHECK_OK(job, ahd_set_double(job, "maximum_error", 0.25));
  CHECK_OK(job, ahd_run(job));
  check_counts(job);
  CHECK(ahd_counted(job, "inserted") < POINTS / 10 && ahd_counted(job, "inserted") > 10);
  CHECK(measured(job, "largest_error") > 0.1 && measured(job, "largest_error") <= 0.25);
  status = ahd_read_ids(job, "point_status", &rows);
  CHECK(rows == POINTS && status[POINTS - 1] == AHD_POINT_NOT_INSERTED);
  for (k = 0; k < POINTS; ++k)
  {
    left_out += status[k] == AHD_POINT_WITHIN_ERROR;
  }
  CHECK(left_out == ahd_counted(job, "within_error"));
  free(status);
  xyz[3 * (SIDE * SIDE / 2) + 2] += 1; /* in the caller's array */
  CHECK_OK(job, ahd_run(job));
  status = ahd_read_ids(job, "point_status", &rows);
  CHECK(status[SIDE * SIDE / 2] == SIDE * SIDE / 2);
  free(status);
}

static void test_limit(ahd_job* job)
{
  int64_t once;
  CHECK_OK(job, ahd_set_double(job, "maximum_error", 0));
  CHECK_OK(job, ahd_set_int(job, "maximum_vertices", 100));
  CHECK_OK(job, ahd_run(job));
  check_counts(job);
  once = ahd_counted(job, "inserted");
  CHECK(once > 50 && once <= 100 && measured(job, "largest_error") > 0);
  CHECK_OK(job, ahd_set_int(job, "second_pass", 1));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "inserted") <= once);
  CHECK_OK(job, ahd_set_double(job, "maximum_error", 2));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "inserted") < 50 && measured(job, "largest_error") <= 2);
}

/* Of points left out; 0 for vertices, and NaN for the one skipped. */
static double largest_error(ahd_job* job, double* errors)
{
  double largest = 0;
  uint64_t rows;
  int64_t* const status = ahd_read_ids(job, "point_status", &rows);
  int k;
  CHECK_OK(job, ahd_get_array(job, "errors", AHD_FLOAT64, errors, POINTS));
  for (k = 0; k < POINTS; ++k)
  {
    CHECK(k == POINTS - 1 ? errors[k] != errors[k] : errors[k] >= 0);
    CHECK(status[k] != k || errors[k] == 0);
    largest = status[k] == AHD_POINT_WITHIN_ERROR && errors[k] > largest ? errors[k] : largest;
  }
  free(status);
  return largest;
}

/* errors; values in place of z, weights, points that stay: read in place, whatever their stride. */
static void test_numbers(ahd_job* job, const double* xyz)
{
  static double errors[POINTS];
  static float numbers[2 * POINTS];
  static unsigned char keep[POINTS];
  const ahd_array values = { numbers, AHD_FLOAT32, 1, POINTS, 2 * sizeof(float), 0 };
  const ahd_array weights = { numbers + 1, AHD_FLOAT32, 1, POINTS, 2 * sizeof(float), 4 };
  const ahd_array marks = { keep, AHD_UINT8, 1, POINTS, 1, 1 };
  int k;
  for (k = 0; k < POINTS; ++k)
  {
    numbers[2 * k] = (float)(xyz[3 * k + 2] * 4);
    numbers[2 * k + 1] = k % 2 ? 0.5f : 2.0f;
    keep[k] = k % 100 == 3;
  }
  CHECK_OK(job, ahd_set_double(job, "maximum_error", 1));
  CHECK_OK(job, ahd_set_int(job, "maximum_vertices", 0));
  CHECK_OK(job, ahd_set_int(job, "want_errors", 1));
  CHECK_OK(job, ahd_set_array(job, "values", &values));
  CHECK_OK(job, ahd_run(job));
  CHECK(largest_error(job, errors) == measured(job, "largest_error"));
  CHECK(measured(job, "largest_error") > 0.5 && measured(job, "largest_error") <= 1);
  CHECK_OK(job, ahd_set_array(job, "weights", &weights));
  CHECK_OK(job, ahd_set_array(job, "keep", &marks));
  CHECK_OK(job, ahd_run(job));
  CHECK(largest_error(job, errors) > 0.5);
  for (k = 0; k < POINTS - 1; ++k)
  {
    CHECK(errors[k] <= (k == SIDE * SIDE ? 40 : k % 2 ? 2 : 0.5)); /* a duplicate has its own */
    CHECK(!keep[k] || errors[k] == 0);
  }
}

static void test_unfit_numbers(ahd_job* job)
{
  static const double numbers[POINTS];
  ahd_array values = { numbers, AHD_FLOAT64, 1, POINTS - 1, 8, 8 };
  CHECK_OK(job, ahd_set_array(job, "values", &values));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_run(job));
  CHECK_SAYS(job, "\"values\" has 3601 rows, and \"points\" 3602.");
  CHECK_OK(job, ahd_set_array(job, "values", NULL));
  CHECK_OK(job, ahd_set_array(job, "weights", NULL));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "keep", &values));
  CHECK_OK(job, ahd_set_array(job, "keep", NULL));
}

static void test_refusals(ahd_job* job)
{
  CHECK_OK(job, ahd_set_int(job, "insertion_limit", 7));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_run(job));
  CHECK_SAYS(job, "\"maximum_error\" or \"maximum_vertices\" and \"insertion_limit\" exclude");
  CHECK_OK(job, ahd_set_int(job, "insertion_limit", 0));
  CHECK_OK(job, ahd_set_double(job, "alpha", 3));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_run(job));
  CHECK_SAYS(job, "\"alpha\" exclude");
  CHECK_OK(job, ahd_set_double(job, "alpha", 0));
  CHECK_OK(job, ahd_set_int(job, "duplicates", AHD_DUPLICATES_MEAN_Z));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_run(job));
  CHECK_SAYS(job, "AHD_DUPLICATES_MEAN_Z exclude");
  CHECK_OK(job, ahd_set_int(job, "duplicates", AHD_DUPLICATES_LOWEST_Z));
  CHECK_OK(job, ahd_run(job));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_set_double(job, "maximum_error", -1));
}

void test_simplify(void)
{
  double* const xyz = (double*)malloc(POINTS * 3 * sizeof(double));
  ahd_job* const job = job_of_hills(xyz);
  test_error(job, xyz);
  test_limit(job);
  test_numbers(job, xyz);
  test_unfit_numbers(job);
  test_refusals(job);
  ahd_job_free(job);
  free(xyz);
}
