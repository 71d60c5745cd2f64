/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * The C interface, from C: every function, setting, array and count, and every way to fail.
 */
#include "Check.h"

#include <stdlib.h>

int ahd_failures = 0;

ahd_job* ahd_job_of(const double* numbers, int64_t count, int32_t columns)
{
  ahd_job* job = ahd_job_new();
  const int64_t number = sizeof(double);
  ahd_array points = { numbers, AHD_FLOAT64, columns, count, columns * number, number };
  CHECK(job != NULL);
  CHECK_OK(job, ahd_set_array(job, "points", &points));
  return job;
}

ahd_array ahd_ids(const int64_t* ids, int64_t rows, int32_t columns)
{
  const int64_t number = sizeof(int64_t);
  ahd_array array = { ids, AHD_INT64, columns, rows, columns * number, number };
  return array;
}

int64_t ahd_counted(ahd_job* job, const char* name)
{
  int64_t value = -7;
  CHECK_OK(job, ahd_count(job, name, &value));
  return value;
}

static void* read_array(ahd_job* job, const char* name, int32_t type, uint64_t* numbers)
{
  uint64_t rows = 0, columns = 0;
  void* values;
  CHECK_OK(job, ahd_array_size(job, name, &rows, &columns));
  *numbers = rows * columns;
  values = calloc(*numbers + 1, sizeof(double));
  CHECK_OK(job, ahd_get_array(job, name, type, values, *numbers));
  return values;
}

int64_t* ahd_read_ids(ahd_job* job, const char* name, uint64_t* numbers)
{
  return (int64_t*)read_array(job, name, AHD_INT64, numbers);
}

double* ahd_read_doubles(ahd_job* job, const char* name, uint64_t* numbers)
{
  return (double*)read_array(job, name, AHD_FLOAT64, numbers);
}

double* ahd_scattered(int64_t count)
{
  double* xy = (double*)malloc((size_t)count * 2 * sizeof(double));
  uint64_t state = 1;
  int64_t i;
  for (i = 0; i < 2 * count; ++i)
  {
    state = state * 6364136223846793005u + 1442695040888963407u;
    xy[i] = (double)(state >> 11) / 9007199254740992.0;
  }
  return xy;
}

/* With an argument: only the file that starts threads of its own (for the thread sanitizer). */
int main(int argc, char** argv)
{
  (void)argv;
  test_trouble();
  if (argc == 1)
  {
    CHECK(ahd_abi_version() == AHD_ABI_VERSION);
    CHECK(strlen(ahd_version()) >= 5);
    test_names();
    test_settings();
    test_input();
    test_results();
    test_sample();
    test_given_surface();
    test_outline();
    test_edit();
    test_refine();
    test_messages();
    test_unchanged();
    test_at_once();
    test_simplify();
    test_tiles();
  }
  if (ahd_failures > 0)
  {
    fprintf(stderr, "%d checks failed.\n", ahd_failures);
  }
  return ahd_failures > 0;
}
