/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Names, settings, and input arrays that are refused.
 */
#include "Check.h"

#include <limits.h>
#include <math.h>
#include <stddef.h>

/* Names are added and never removed: there are at least so many of each kind. */
void test_names(void)
{
  static const uint32_t least[] = { 37, 4, 8, 61, 12, 33 };
  static const char* const firsts[] = { "insertion_order", "tolerance", "points", "points", "np",
    "triangles" };
  int32_t kind;
  for (kind = AHD_INT_SETTINGS; kind <= AHD_OUTPUT_ARRAYS; ++kind)
  {
    uint32_t i, k, count = 0;
    while (count < 1000 && ahd_name(kind, count))
    {
      ++count;
    }
    CHECK(count >= least[kind] && count < 1000);
    CHECK(ahd_name(kind, 0) && strcmp(ahd_name(kind, 0), firsts[kind]) == 0);
    CHECK(ahd_name(kind, count) == NULL);
    CHECK(ahd_name(kind, UINT_MAX) == NULL);
    for (i = 0; i < count; ++i)
    {
      CHECK(ahd_name(kind, i) != NULL);
      for (k = 0; k < i && ahd_name(kind, i); ++k)
      {
        CHECK(strcmp(ahd_name(kind, i), ahd_name(kind, k)) != 0);
      }
    }
  }
  CHECK(ahd_name(-1, 0) == NULL);
  CHECK(ahd_name(6, 0) == NULL);
  CHECK(strcmp(ahd_status_name(AHD_OK), "AHD_OK") == 0);
  CHECK(strcmp(ahd_status_name(AHD_BAD_VALUE), "AHD_BAD_VALUE") == 0);
  CHECK(strcmp(ahd_status_name(AHD_FAILED), "AHD_FAILED") == 0);
  CHECK(strcmp(ahd_status_name(AHD_TOO_MANY_CROSSINGS), "AHD_TOO_MANY_CROSSINGS") == 0);
  CHECK(strcmp(ahd_status_name(AHD_FAILED + 1), "?") == 0);
  CHECK(strcmp(ahd_status_name(-1), "?") == 0);
}

/* Each int setting takes the ends of its range and nothing beyond. */
static void test_ranges(ahd_job* job)
{
  uint32_t i;
  for (i = 0; ahd_name(AHD_INT_SETTINGS, i); ++i)
  {
    const char* const name = ahd_name(AHD_INT_SETTINGS, i);
    int64_t preset = -7, value = -7;
    CHECK_OK(job, ahd_get_int(job, name, &preset));
    CHECK(preset >= 0);
    CHECK_STATUS(job, AHD_BAD_VALUE, ahd_set_int(job, name, -1));
    CHECK_SAYS(job, name);
    if (strcmp(name, "insertion_limit") != 0 &&
      strcmp(name, "maximum_vertices") != 0) /* as many as there are */
    {
      CHECK_STATUS(job, AHD_BAD_VALUE, ahd_set_int(job, name, INT64_MAX));
    }
    CHECK_STATUS(job, AHD_BAD_VALUE, ahd_set_int(job, name, INT64_MIN));
    CHECK_OK(job, ahd_get_int(job, name, &value));
    CHECK(value == preset);
    CHECK_OK(job, ahd_set_int(job, name, 1));
    CHECK_OK(job, ahd_get_int(job, name, &value));
    CHECK(value == 1);
    CHECK_OK(job, ahd_set_int(job, name, preset));
  }
}

static void test_doubles(ahd_job* job)
{
  double value = -7.0;
  CHECK_OK(job, ahd_get_double(job, "offset", &value));
  CHECK(value == 1.0);
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_set_double(job, "offset", 0.5));
  CHECK_SAYS(job, "0.75 to ");
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_set_double(job, "offset", HUGE_VAL));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_set_double(job, "offset", (double)NAN));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_set_double(job, "tolerance", 1.5));
  CHECK_OK(job, ahd_set_double(job, "tolerance", 1.0));
  CHECK_OK(job, ahd_set_double(job, "alpha", HUGE_VAL));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_set_double(job, "alpha", -1e-300));
  CHECK_OK(job, ahd_get_double(job, "alpha", &value));
  CHECK(value == HUGE_VAL);
}

void test_settings(void)
{
  ahd_job* job = ahd_job_new();
  int64_t number = 0;
  double value = 0.0;
  test_ranges(job);
  test_doubles(job);
  CHECK_STATUS(job, AHD_UNKNOWN_NAME, ahd_set_int(job, "nmx", 1));
  CHECK_SAYS(job, "\"nmx\"");
  CHECK_STATUS(job, AHD_UNKNOWN_NAME, ahd_set_int(job, NULL, 1));
  CHECK_STATUS(job, AHD_UNKNOWN_NAME, ahd_set_int(job, "alpha", 1));
  CHECK_SAYS(job, "other type");
  CHECK_STATUS(job, AHD_UNKNOWN_NAME, ahd_set_double(job, "nmax", 1.0));
  CHECK_STATUS(job, AHD_UNKNOWN_NAME, ahd_get_int(job, "", &number));
  CHECK_STATUS(job, AHD_UNKNOWN_NAME, ahd_get_double(job, "a", &value));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_get_int(job, "nmax", NULL));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_get_double(job, "alpha", NULL));
  ahd_job_free(job);
  ahd_job_free(NULL);
}

/* Arrays that are refused where they are set. */
static void test_bad_arrays(ahd_job* job)
{
  static const double xyz[6] = { 0, 0, 0, 1, 1, 1 };
  const ahd_array good = { xyz, AHD_FLOAT64, 3, 2, 24, 8 };
  ahd_array array = good;
  CHECK_STATUS(job, AHD_UNKNOWN_NAME, ahd_set_array(job, "point", &array));
  CHECK_SAYS(job, "\"point\"");
  CHECK_STATUS(job, AHD_UNKNOWN_NAME, ahd_set_array(job, NULL, &array));
  array.type = AHD_INT32;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "points", &array));
  CHECK_SAYS(job, "AHD_FLOAT64");
  array.type = 77;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "points", &array));
  array = good;
  array.columns = 4;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "points", &array));
  array.columns = 1;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "source_points", &array));
  array = good;
  array.rows = -1;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "points", &array));
  array.rows = INT64_MAX;
  array.row_stride = 0;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "points", &array));
  array = good;
  array.row_stride = INT64_MIN;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "points", &array));
  array = good;
  array.data = NULL;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "points", &array));
  CHECK_SAYS(job, "null");
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "matrix", &good));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "skip", &good));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "line_ids", &good));
  CHECK_OK(job, ahd_set_array(job, "points", NULL));
  CHECK_OK(job, ahd_set_array(job, "points", &good));
}

/* Arrays that do not fit together are refused by the run. */
static void test_misfits(ahd_job* job)
{
  static const unsigned char marks[3] = { 0, 0, 0 };
  static const int64_t ids[4] = { 0, 1, 1, 0 };
  static const int64_t falling[3] = { 0, 3, 2 };
  static const int64_t beyond[3] = { 0, 2, 5 };
  static const int64_t below[3] = { -1, 2, 4 };
  ahd_array array = { marks, AHD_UINT8, 1, 3, 1, 1 };
  CHECK_OK(job, ahd_set_array(job, "skip", &array));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_run(job));
  CHECK_SAYS(job, "\"skip\" has 3 rows");
  CHECK_OK(job, ahd_set_array(job, "skip", NULL));
  array = ahd_ids(falling, 3, 1);
  CHECK_OK(job, ahd_set_array(job, "line_offsets", &array));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_run(job));
  array = ahd_ids(ids, 2, 2);
  CHECK_OK(job, ahd_set_array(job, "line_ids", &array));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_run(job));
  CHECK_SAYS(job, "\"line_offsets\" is for \"line_ids\" of one column");
  array = ahd_ids(ids, 4, 1);
  CHECK_OK(job, ahd_set_array(job, "line_ids", &array));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_run(job));
  CHECK_SAYS(job, "3 and 2 for chain 1");
  array = ahd_ids(beyond, 3, 1);
  CHECK_OK(job, ahd_set_array(job, "line_offsets", &array));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_run(job));
  array = ahd_ids(below, 3, 1);
  CHECK_OK(job, ahd_set_array(job, "line_offsets", &array));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_run(job));
  array = ahd_ids(below, 0, 1);
  CHECK_OK(job, ahd_set_array(job, "line_offsets", &array));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_run(job));
  CHECK_OK(job, ahd_set_array(job, "line_offsets", NULL));
  CHECK_OK(job, ahd_run(job));
  CHECK_OK(job, ahd_set_array(job, "line_ids", NULL));
}

/* A plane that is requested and not given. */
static void test_planes_that_lack(ahd_job* job)
{
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_MATRIX));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_run(job));
  CHECK_SAYS(job, "matrix");
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_CALLBACK));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_run(job));
  CHECK_SAYS(job, "ahd_set_projection");
}

void test_input(void)
{
  ahd_job* job = ahd_job_new();
  test_bad_arrays(job);
  test_misfits(job);
  test_planes_that_lack(job);
  ahd_job_free(job);
}
