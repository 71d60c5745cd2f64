/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * A failed call changes nothing: all that a job returns is the same before and after.
 */
#include "Check.h"

#include <math.h>
#include <stdlib.h>

enum
{
  kMost = 4096
};

/* Fingerprints of all that a job returns. */
typedef struct snapshot
{
  uint64_t words[kMost];
  int count;
} snapshot;

static void add(snapshot* to, const void* bytes, uint64_t size)
{
  if (to->count + 2 <= kMost)
  {
    ahd_fingerprint(bytes, size, 0, to->words + to->count);
  }
  to->count += 2;
}

static void add_array(snapshot* to, ahd_job* job, const char* name)
{
  static const int32_t types[] = { AHD_INT64, AHD_FLOAT64, AHD_UINT8, AHD_INT32 };
  uint64_t rows = 0, columns = 0;
  ahd_status status = ahd_array_size(job, name, &rows, &columns);
  void* numbers = malloc((size_t)(rows * columns * 8 + 8));
  int k;
  add(to, &status, sizeof(status));
  for (k = 0; status == AHD_OK && k < 4; ++k)
  {
    memset(numbers, 0, (size_t)(rows * columns * 8 + 8));
    if (ahd_get_array(job, name, types[k], numbers, rows * columns) == AHD_OK)
    {
      add(to, numbers, rows * columns * 8);
    }
  }
  free(numbers);
}

/* threads_used and times may change. */
static void take(snapshot* to, ahd_job* job)
{
  const char* name;
  uint64_t bytes = 0;
  uint32_t i;
  memset(to, 0, sizeof(*to));
  for (i = 0; (name = ahd_name(AHD_INT_SETTINGS, i)) != NULL; ++i)
  {
    int64_t value = -1;
    CHECK_OK(job, ahd_get_int(job, name, &value));
    add(to, &value, sizeof(value));
  }
  for (i = 0; (name = ahd_name(AHD_DOUBLE_SETTINGS, i)) != NULL; ++i)
  {
    double value = -1;
    CHECK_OK(job, ahd_get_double(job, name, &value));
    add(to, &value, sizeof(value));
  }
  for (i = 0; (name = ahd_name(AHD_OUTPUT_ARRAYS, i)) != NULL; ++i)
  {
    add_array(to, job, name);
  }
  for (i = 0; (name = ahd_name(AHD_COUNTS, i)) != NULL; ++i)
  {
    const int64_t value = ahd_counted(job, name);
    add(to, &value, strcmp(name, "threads_used") == 0 ? 0 : sizeof(value));
  }
  for (i = 0; (name = ahd_name(AHD_MEASURES, i)) != NULL; ++i)
  {
    double value = -1;
    const int is_time = strncmp(name, "seconds_", 8) == 0 && strcmp(name, "seconds_sample") != 0;
    const ahd_status status = ahd_measure(job, name, &value);
    add(to, &status, sizeof(status));
    add(to, &value, is_time ? 0 : sizeof(value));
  }
  (void)ahd_estimate(job, &bytes);
  add(to, &bytes, sizeof(bytes));
  CHECK(to->count <= kMost);
}

/* The call fails with this status, and the job equals `before`. */
#define CHECK_UNCHANGED(job, before, expected, call)                                               \
  do                                                                                               \
  {                                                                                                \
    snapshot after;                                                                                \
    CHECK_STATUS(job, expected, call);                                                             \
    take(&after, job);                                                                             \
    CHECK(memcmp(&after, before, sizeof(after)) == 0);                                             \
  } while (0)

static void check_settings_and_input(ahd_job* job, const snapshot* before)
{
  static const double number[] = { 0 };
  ahd_array array = { number, AHD_UINT8, 2, 1, 8, 8 };
  uint64_t bytes = 7;
  int64_t value = 7;
  CHECK_UNCHANGED(job, before, AHD_UNKNOWN_NAME, ahd_set_int(job, "nmx", 3));
  CHECK_UNCHANGED(job, before, AHD_BAD_VALUE, ahd_set_int(job, "nmax", 0));
  CHECK_UNCHANGED(job, before, AHD_BAD_VALUE, ahd_set_double(job, "alpha", (double)NAN));
  CHECK_UNCHANGED(job, before, AHD_UNKNOWN_NAME, ahd_get_int(job, "alpha", &value));
  CHECK_UNCHANGED(job, before, AHD_BAD_ARRAY, ahd_get_int(job, "nmax", NULL));
  CHECK_UNCHANGED(job, before, AHD_UNKNOWN_NAME, ahd_set_array(job, "point", NULL));
  CHECK_UNCHANGED(job, before, AHD_BAD_ARRAY, ahd_set_array(job, "points", &array));
  CHECK_UNCHANGED(job, before, AHD_BAD_ARRAY, ahd_estimate(job, NULL));
  CHECK_UNCHANGED(job, before, AHD_BAD_ARRAY, ahd_fit_plane(job, NULL));
  CHECK(bytes == 7 && value == 7);
}

static void check_results(ahd_job* job, const snapshot* before)
{
  int64_t value = 7;
  int32_t ids[3] = { 7, 7, 7 };
  ahd_drawing drawing = { 0 };
  CHECK_UNCHANGED(job, before, AHD_UNKNOWN_NAME, ahd_count(job, "point", &value));
  CHECK_UNCHANGED(job, before, AHD_BAD_ARRAY, ahd_measure(job, "np", NULL));
  CHECK_UNCHANGED(job, before, AHD_BAD_ARRAY, ahd_array_size(job, "points", NULL, NULL));
  CHECK_UNCHANGED(job, before, AHD_BAD_ARRAY, ahd_get_array(job, "triangles", AHD_INT32, ids, 2));
  CHECK_UNCHANGED(job, before, AHD_NOT_AVAILABLE, ahd_get_array(job, "order", AHD_INT32, ids, 3));
  CHECK_UNCHANGED(job, before, AHD_NOT_AVAILABLE, ahd_draw_order(job, AHD_INT32, &drawing));
  CHECK_UNCHANGED(job, before, AHD_BAD_ARRAY, ahd_draw_order(job, AHD_INT32, NULL));
  CHECK_UNCHANGED(job, before, AHD_BAD_VALUE, ahd_interpolate(job, 9, NULL, 1));
  CHECK_UNCHANGED(job, before, AHD_BAD_ARRAY, ahd_locate(job, NULL, 1, NULL, NULL, NULL));
  CHECK(value == 7 && ids[0] == 7);
}

/* Cancels the call at its second progress. */
static int32_t cancel_late(void* user, int32_t phase, double fraction)
{
  (void)phase;
  (void)fraction;
  return ++*(int*)user > 1;
}

static void check_samples(ahd_job* job, const double* xy, snapshot* before)
{
  static const double place[] = { 0.5, 0.5 };
  ahd_places places = { place, 1, { 0, 0 }, { 0, 0 }, 0, 0 };
  ahd_places raster = { NULL, 0, { 0, 0 }, { 0.01, 0.01 }, 100, 100 };
  double* out = (double*)malloc(100 * 100 * sizeof(double));
  ahd_sampled array = { xy, 1, out, NULL };
  uint64_t bytes = 0;
  int told = 0, k;
  CHECK_UNCHANGED(job, before, AHD_BAD_ARRAY, ahd_sample(job, NULL, &array, 1, NULL));
  CHECK_UNCHANGED(job, before, AHD_BAD_ARRAY, ahd_sample_weights(job, NULL));
  raster.spacing[0] = 0;
  CHECK_UNCHANGED(job, before, AHD_BAD_VALUE, ahd_sample_weights(job, &raster));
  raster.spacing[0] = 0.01;
  for (k = 0; k < 2; ++k)
  {
    CHECK_OK(job, ahd_set_progress(job, cancel_late, &told));
    told = 0;
    CHECK_STATUS(job, AHD_CANCELLED,
      k == 0 ? ahd_sample(job, &raster, &array, 1, NULL) : ahd_sample_weights(job, &raster));
    CHECK_OK(job, ahd_set_progress(job, NULL, NULL));
    ahd_cancel(job);
    CHECK_UNCHANGED(job, before, AHD_CANCELLED,
      k == 0 ? ahd_sample(job, &places, &array, 1, NULL) : ahd_sample_weights(job, &places));
  }
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 1));
  take(before, job); /* the setting */
  CHECK_UNCHANGED(job, before, AHD_MEMORY_LIMIT, ahd_sample_weights(job, &raster));
  CHECK_UNCHANGED(job, before, AHD_MEMORY_LIMIT, ahd_sample(job, &raster, &array, 1, NULL));
  CHECK_UNCHANGED(job, before, AHD_MEMORY_LIMIT, ahd_sample_estimate(job, &raster, 1, &bytes));
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 0));
  free(out);
}

/* Requests after a run, with samples and weights. */
static void test_calls(void)
{
  enum
  {
    kCount = 2000
  };
  static const double place[] = { 0.25, 0.75, 0.5, 0.125 };
  double *xy = ahd_scattered(kCount), out[2];
  ahd_places places = { place, 2, { 0, 0 }, { 0, 0 }, 0, 0 };
  ahd_sampled array = { xy, 1, out, NULL };
  ahd_job* job = ahd_job_of(xy, kCount, 2);
  snapshot* before = (snapshot*)malloc(sizeof(snapshot));
  int has_samples;
  CHECK_OK(job, ahd_run(job));
  for (has_samples = 0; has_samples < 2; ++has_samples)
  {
    if (has_samples)
    {
      CHECK_OK(job, ahd_sample(job, &places, &array, 1, NULL));
      CHECK_OK(job, ahd_sample_weights(job, &places));
      CHECK(ahd_counted(job, "sampled_places") == 2);
    }
    take(before, job);
    check_settings_and_input(job, before);
    check_results(job, before);
    check_samples(job, xy, before);
  }
  free(before);
  free(xy);
  ahd_job_free(job);
}

/* A failed run leaves no result, and settings and input unchanged. */
static void test_run(void)
{
  double* xy = ahd_scattered(100);
  ahd_job* job = ahd_job_of(xy, 100, 2);
  snapshot *first = (snapshot*)malloc(sizeof(snapshot)),
           *again = (snapshot*)malloc(sizeof(snapshot));
  int64_t number = 0;
  CHECK_OK(job, ahd_run(job));
  take(first, job);
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 1));
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_run(job));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_count(job, "triangles", &number));
  CHECK(ahd_counted(job, "points") == 100 && ahd_counted(job, "memory_allowed") == 1);
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 0));
  CHECK_OK(job, ahd_run(job));
  take(again, job);
  for (number = 0; number < again->count; ++number) /* all but the machine's free memory */
  {
    again->words[number] = first->words[number] == again->words[number] ? 0 : 1;
  }
  for (number = 0; number < again->count; ++number)
  {
    again->words[0] += number > 0 ? again->words[number] : 0;
  }
  CHECK(again->words[0] <= 6); /* memory_allowed, most_boxes, most_crossings: two words each */
  free(first);
  free(again);
  free(xy);
  ahd_job_free(job);
}

/* After ahd_release() the documented data remain. */
static void test_release(void)
{
  double* xy = ahd_scattered(100);
  ahd_job* job = ahd_job_of(xy, 100, 2);
  int64_t estimate, nmax = 0, number = 0;
  CHECK_OK(job, ahd_set_int(job, "nmax", 7));
  CHECK_OK(job, ahd_run(job));
  estimate = ahd_counted(job, "memory_estimate");
  CHECK_OK(job, ahd_release(job, 0));
  CHECK(ahd_counted(job, "points") == 100 && ahd_counted(job, "memory_estimate") == estimate);
  CHECK(ahd_counted(job, "threads_used") >= 1 && ahd_counted(job, "memory_allowed") >= estimate);
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_count(job, "inserted", &number));
  CHECK_OK(job, ahd_get_int(job, "nmax", &nmax));
  CHECK(nmax == 7);
  CHECK_OK(job, ahd_run(job)); /* the points are there */
  CHECK(ahd_counted(job, "inserted") == 100);
  free(xy);
  ahd_job_free(job);
}

typedef struct caller
{
  ahd_job* job;
  int calls, busy;
} caller;

static int32_t call_all(void* user, int32_t phase, double fraction)
{
  caller* own = (caller*)user;
  ahd_job* job = own->job;
  uint64_t bytes = 0, rows = 0, columns = 0;
  int64_t number = 0;
  double value = 0, matrix[16];
  ahd_places places = { &value, 0, { 0, 0 }, { 0, 0 }, 0, 0 };
  ahd_drawing drawing = { 0 };
  int k;
  const ahd_status found[] = { ahd_set_int(job, "nmax", 3), ahd_set_double(job, "alpha", 3),
    ahd_get_int(job, "nmax", &number), ahd_get_double(job, "alpha", &value),
    ahd_set_array(job, "points", NULL), ahd_set_projection(job, NULL, NULL),
    ahd_set_progress(job, NULL, NULL), ahd_estimate(job, &bytes), ahd_run(job), ahd_release(job, 0),
    ahd_fit_plane(job, matrix), ahd_choose_plane(job, &number), ahd_count(job, "points", &number),
    ahd_measure(job, "np", &value), ahd_array_size(job, "points", &rows, &columns),
    ahd_get_array(job, "points", AHD_FLOAT64, &value, 1), ahd_draw_order(job, AHD_INT32, &drawing),
    ahd_interpolate(job, 1, &value, 1), ahd_locate(job, &value, 0, NULL, NULL, NULL),
    ahd_sample(job, &places, NULL, 0, NULL), ahd_sample_estimate(job, &places, 0, &bytes),
    ahd_sample_weights(job, &places) };
  (void)phase;
  (void)fraction;
  for (k = 0; k < (int)(sizeof(found) / sizeof(found[0])); ++k)
  {
    own->busy += found[k] == AHD_BUSY;
    ++own->calls;
  }
  CHECK(strstr(ahd_message(job), "at work"));
  CHECK(ahd_kept_bytes(job) == 0);
  return 0;
}

/* Every call from a callback is refused with a message, which is cleared when the running call
ends. */
static void test_busy(void)
{
  double* xy = ahd_scattered(5000);
  ahd_job* job = ahd_job_of(xy, 5000, 2);
  caller own = { 0 };
  int64_t nmax = 0;
  own.job = job;
  CHECK_OK(job, ahd_set_progress(job, call_all, &own));
  CHECK_OK(job, ahd_run(job));
  CHECK(own.calls > 20 && own.busy == own.calls);
  CHECK_OK(job, ahd_get_int(job, "nmax", &nmax));
  CHECK(nmax == 50 && ahd_counted(job, "inserted") == 5000);
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 1));
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_run(job));
  CHECK_SAYS(job, "memory_limit");
  free(xy);
  ahd_job_free(job);
}

void test_unchanged(void)
{
  test_calls();
  test_run();
  test_release();
  test_busy();
}
