/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Refused, cancelled and busy calls; memory; threads; progress.
 */
#include "Check.h"

#include <pthread.h>
#include <stdlib.h>
#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#endif

#ifdef AHD_REDUCED_TESTS
static const int64_t kMany = 30000;
#else
static const int64_t kMany = 300000;
#endif

/* Every function without a job. */
static void test_no_job(void)
{
  int64_t number = 0;
  double value = 0;
  uint64_t bytes = 0;
  int32_t kind = 0;
  ahd_drawing drawing = { 0 };
  ahd_cancel(NULL);
  CHECK(ahd_kept_bytes(NULL) == 0);
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_set_int(NULL, "nmax", 1));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_set_double(NULL, "alpha", 1));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_get_int(NULL, "nmax", &number));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_get_double(NULL, "alpha", &value));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_set_array(NULL, "points", NULL));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_set_projection(NULL, NULL, NULL));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_set_progress(NULL, NULL, NULL));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_estimate(NULL, &bytes));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_run(NULL));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_release(NULL, 0));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_fit_plane(NULL, NULL));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_choose_plane(NULL, NULL));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_count(NULL, "points", &number));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_measure(NULL, "np", &value));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_array_size(NULL, "lines", &bytes, &bytes));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_get_array(NULL, "lines", AHD_INT32, &kind, 1));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_draw_order(NULL, AHD_INT32, &drawing));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_interpolate(NULL, 1, &value, 1));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_locate(NULL, &value, 0, &kind, &number, NULL));
}

/* Counts and arrays without a result, and wrong requests. */
static void test_no_result(void)
{
  static const double triangle[] = { 0, 0, 1, 0, 0, 1 };
  ahd_job* job = ahd_job_of(triangle, 3, 2);
  int64_t number = 0;
  double value = 0;
  uint64_t rows = 7, columns = 7;
  int32_t ids[3] = { 7, 7, 7 };
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_count(job, "triangles", &number));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_measure(job, "np", &value));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_array_size(job, "triangles", &rows, &columns));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_get_array(job, "triangles", AHD_INT32, ids, 3));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_interpolate(job, 1, &value, 1));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_locate(job, &value, 0, NULL, NULL, NULL));
  CHECK_OK(job, ahd_count(job, "points", &number));
  CHECK_OK(job, ahd_run(job));
  CHECK_STATUS(job, AHD_UNKNOWN_NAME, ahd_count(job, "triangle", &number));
  CHECK_STATUS(job, AHD_UNKNOWN_NAME, ahd_measure(job, NULL, &value));
  CHECK_STATUS(job, AHD_UNKNOWN_NAME, ahd_array_size(job, "np", &rows, &columns));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_count(job, "triangles", NULL));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_measure(job, "np", NULL));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_array_size(job, "triangles", NULL, &columns));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_array_size(job, "triangles", &rows, NULL));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_get_array(job, "triangles", AHD_INT32, ids, 2));
  CHECK_SAYS(job, "\"triangles\" has 3 numbers, and there is room for 2");
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_get_array(job, "triangles", AHD_INT32, NULL, 3));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_get_array(job, "triangles", AHD_UINT8, ids, 3));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_get_array(job, "triangles", 99, ids, 3));
  CHECK(ids[0] == 7 && rows == 7);
  CHECK_OK(job, ahd_get_array(job, "triangles", AHD_INT32, ids, 3));
  CHECK(ids[0] == 0 && ids[1] == 1 && ids[2] == 2);
  CHECK_OK(job, ahd_get_array(job, "lines", AHD_INT64, NULL, 0));
  CHECK_OK(job, ahd_set_array(job, "skip", NULL)); /* any array: the result reads them */
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_count(job, "triangles", &number));
  CHECK_OK(job, ahd_run(job));
  CHECK_OK(job, ahd_release(job, UINT64_MAX));
  CHECK(ahd_kept_bytes(job) > 0);
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_count(job, "triangles", &number));
  CHECK_OK(job, ahd_run(job));
  CHECK_OK(job, ahd_release(job, 0));
  CHECK(ahd_kept_bytes(job) == 0);
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 1);
  ahd_job_free(job);
}

/* Counts that no memory has: a caller's -1. Nothing is read or written. */
static void test_absurd_counts(void)
{
  static const double triangle[] = { 0, 0, 1, 0, 0, 1 };
  static const uint64_t absurd[] = { (UINT64_C(1) << 48) + 1, UINT64_MAX / 2 + 1, UINT64_MAX };
  ahd_job* job = ahd_job_of(triangle, 3, 2);
  int k;
  CHECK_OK(job, ahd_run(job));
  for (k = 0; k < 3; ++k)
  {
    double value = 7;
    int32_t kind = 7;
    int64_t id = 7;
    uint64_t bytes = 7, print[2] = { 7, 7 };
    ahd_places places = { triangle, 1, { 0, 0 }, { 1, 1 }, 0, 0 };
    ahd_sampled array = { triangle, 1, &value, NULL };
    CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_locate(job, triangle, absurd[k], &kind, &id, NULL));
    CHECK_SAYS(job, "places do not fit in any memory");
    CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_to_plane(job, &value, absurd[k]));
    CHECK_STATUS(job, AHD_BAD_VALUE, ahd_sample(job, &places, &array, absurd[k], NULL));
    CHECK_SAYS(job, "arrays are too many");
    CHECK_STATUS(job, AHD_BAD_VALUE, ahd_sample_estimate(job, &places, absurd[k], &bytes));
    places.count = absurd[k];
    CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_sample(job, &places, &array, 1, NULL));
    CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_sample_estimate(job, &places, 1, &bytes));
    CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_sample_weights(job, &places));
    places.xy = NULL;
    places.count = 0;
    places.columns = places.rows = absurd[k];
    CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_sample(job, &places, &array, 1, NULL));
    CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_sample_weights(job, &places));
    CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_get_array(job, "triangles", AHD_INT32, NULL, absurd[k]));
    ahd_fingerprint(triangle, absurd[k], 0, print);
    CHECK(print[0] == 0 && print[1] == 0);
    CHECK(value == 7 && kind == 7 && id == 7 && bytes == 7);
  }
  CHECK_STATUS(
    job, AHD_BAD_VALUE, ahd_interpolate(job, AHD_AT_SURFACE, (double*)triangle, INT32_MAX));
  CHECK_SAYS(job, "2147483647 columns are too many");
  ahd_job_free(job);
}

/* A job with everything that takes time. */
static ahd_job* busy_job(double* xy, int64_t* chain)
{
  ahd_job* job = ahd_job_of(xy, kMany, 2);
  ahd_array ids;
  int64_t i;
  for (i = 0; i < 40; ++i)
  {
    chain[i] = i * 7;
  }
  ids = ahd_ids(chain, 20, 2);
  CHECK_OK(job, ahd_set_array(job, "line_ids", &ids));
  CHECK_OK(job, ahd_set_int(job, "split_crossings", 1));
  CHECK_OK(job, ahd_set_int(job, "want_voronoi", 1));
  CHECK_OK(job, ahd_set_int(job, "want_neighbors", 1));
  CHECK_OK(job, ahd_set_double(job, "tolerance", 1e-9));
  return job;
}

typedef struct listener
{
  ahd_job* job;
  int calls, last_call; /* the call that cancels; 0: none does */
  int phases;           /* a bit for each */
  double fraction;
  ahd_status busy;
} listener;

static int32_t listen(void* user, int32_t phase, double fraction)
{
  listener* own = (listener*)user;
  int64_t number = 0;
  CHECK(phase >= AHD_PHASE_MERGE && phase <= AHD_PHASE_OUTPUTS);
  CHECK(fraction >= own->fraction && fraction <= 1.0);
  own->phases |= 1 << phase;
  own->fraction = fraction;
  own->busy = ahd_count(own->job, "points", &number);
  CHECK_SAYS(own->job, "at work");
  return ++own->calls == own->last_call;
}

/* The callbacks of a run; cancelled at any of them, the job can run again. */
static void test_progress(void)
{
  double* xy = ahd_scattered(kMany);
  int64_t chain[40], *first, *again;
  uint64_t numbers = 0, others = 0;
  ahd_job* job = busy_job(xy, chain);
  listener own = { 0 };
  double seconds = -1, all = 0;
  ahd_status status;
  int calls, k;
  own.job = job;
  CHECK_OK(job, ahd_set_progress(job, listen, &own));
  CHECK_OK(job, ahd_run(job));
  calls = own.calls;
  CHECK(calls >= 20);
  CHECK(own.busy == AHD_BUSY);
  CHECK(own.phases == 0xFF);
  CHECK(own.fraction > 0.5);
  first = ahd_read_ids(job, "triangles", &numbers);
  free(ahd_read_ids(job, "neighbors", &others));
  CHECK(own.fraction > 0.85);
  CHECK_OK(job, ahd_measure(job, "seconds_insert", &seconds));
  CHECK(seconds > 0);
  for (k = 0; ahd_name(AHD_MEASURES, (uint32_t)k); ++k)
  {
    CHECK_OK(job, ahd_measure(job, ahd_name(AHD_MEASURES, (uint32_t)k), &seconds));
    all += strncmp(ahd_name(AHD_MEASURES, (uint32_t)k), "seconds_", 8) == 0 ? seconds : 0;
  }
  CHECK(all > 0);
  for (k = 1; k < calls - 5; k += calls / 10)
  {
    own.calls = 0;
    own.fraction = 0;
    own.last_call = k;
    status = ahd_run(job);
    if (k > 1 && own.calls < k) /* the clock adds calls, on a busy machine more: here fewer */
    {
      CHECK(status == AHD_OK);
      break;
    }
    CHECK(status == AHD_CANCELLED);
    CHECK(own.calls == k); /* and never again */
    CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_array_size(job, "triangles", &others, &others));
  }
  own.last_call = 0;
  own.fraction = 0;
  CHECK_OK(job, ahd_run(job));
  own.last_call = own.calls + 1;
  CHECK_STATUS(job, AHD_CANCELLED, ahd_get_array(job, "triangles", AHD_INT64, first, numbers));
  own.last_call = 0;
  again = ahd_read_ids(job, "triangles", &others);
  CHECK_OK(job, ahd_get_array(job, "triangles", AHD_INT64, first, numbers));
  CHECK(numbers == others && memcmp(first, again, numbers * sizeof(int64_t)) == 0);
  free(first);
  free(again);
  free(xy);
  ahd_job_free(job);
}

static int32_t cancel_now(void* user, int32_t phase, double fraction)
{
  (void)fraction;
  if (phase == AHD_PHASE_INSERT)
  {
    ahd_cancel((ahd_job*)user);
  }
  return 0;
}

static int32_t refuse_all(void* user, double* xyz, uint64_t count)
{
  (void)user;
  (void)xyz;
  (void)count;
  return 1;
}

static void* cancel_soon(void* user)
{
  ahd_cancel((ahd_job*)user);
  return NULL;
}

/* Cancelled from a callback, before the call, by a projection, and from another thread. */
static void test_cancel(void)
{
  double* xy = ahd_scattered(kMany);
  ahd_job* job = ahd_job_of(xy, kMany, 2);
  pthread_t thread;
  ahd_status status;
  CHECK_OK(job, ahd_set_progress(job, cancel_now, job));
  CHECK_STATUS(job, AHD_CANCELLED, ahd_run(job));
  CHECK_SAYS(job, "Cancelled");
  CHECK_OK(job, ahd_set_progress(job, NULL, NULL));
  CHECK_OK(job, ahd_run(job));
  ahd_cancel(job);
  CHECK_STATUS(job, AHD_CANCELLED, ahd_run(job));
  CHECK_OK(job, ahd_set_projection(job, refuse_all, NULL));
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_CALLBACK));
  CHECK_STATUS(job, AHD_CANCELLED, ahd_run(job));
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_XY));
  CHECK(pthread_create(&thread, NULL, cancel_soon, job) == 0);
  status = ahd_run(job);
  CHECK(pthread_join(thread, NULL) == 0);
  CHECK(status == AHD_OK || status == AHD_CANCELLED);
  if (status == AHD_OK) /* it came too late, and is for the next call */
  {
    CHECK_STATUS(job, AHD_CANCELLED, ahd_run(job));
  }
  CHECK_OK(job, ahd_run(job));
  free(xy);
  ahd_job_free(job);
}

/* The estimate, the limit that it is compared with, and boxes that may not be kept. */
static void test_memory(void)
{
  static const double triangle[] = { 0, 0, 1, 0, 0, 1 };
  double* xy = ahd_scattered(kMany);
  ahd_job* job = ahd_job_of(xy, kMany, 2);
  uint64_t bytes = 0, more = 0;
  ahd_array huge = { triangle, AHD_FLOAT64, 2, (int64_t)1 << 40, 0, 8 };
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_estimate(job, NULL));
  CHECK_OK(job, ahd_estimate(job, &bytes));
  CHECK(bytes > (uint64_t)kMany * 50 && bytes < (uint64_t)kMany * 1000);
  CHECK_OK(job, ahd_set_int(job, "want_voronoi", 1));
  CHECK_OK(job, ahd_estimate(job, &more));
  CHECK(more > bytes);
  CHECK_OK(job, ahd_set_int(job, "want_voronoi", 0));
  CHECK_OK(job, ahd_set_int(job, "other_memory", 12345));
  CHECK_OK(job, ahd_estimate(job, &more));
  CHECK(more == bytes + 12345);
  CHECK_OK(job, ahd_set_int(job, "memory_limit", (int64_t)more - 1));
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_run(job));
  CHECK_SAYS(job, "memory_limit");
  CHECK(ahd_counted(job, "memory_estimate") == (int64_t)more);
  CHECK(ahd_counted(job, "memory_allowed") == (int64_t)more - 1);
  CHECK(ahd_counted(job, "points") == kMany);
  CHECK_OK(job, ahd_set_int(job, "memory_limit", (int64_t)more));
  CHECK_OK(job, ahd_run(job));
  CHECK_OK(job, ahd_set_int(job, "want_boxes", 1));
  CHECK_OK(job, ahd_estimate(job, &more));
  CHECK_OK(job, ahd_set_int(job, "memory_limit", (int64_t)more + 1000));
  CHECK_STATUS(job, AHD_TOO_MANY_BOXES, ahd_run(job));
  CHECK(ahd_counted(job, "most_boxes") > 0 && ahd_counted(job, "most_boxes") < 10);
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 0));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "memory_allowed") > ahd_counted(job, "memory_estimate"));
  CHECK_OK(job, ahd_set_int(job, "other_memory", (int64_t)1 << 60));
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_run(job));
  CHECK_OK(job, ahd_set_array(job, "points", &huge));
  CHECK_STATUS(job, AHD_TOO_MANY_POINTS, ahd_run(job));
  CHECK_SAYS(job, "1099511627776 points");
  CHECK(ahd_counted(job, "points") == (int64_t)1 << 40);
  CHECK_STATUS(job, AHD_TOO_MANY_POINTS, ahd_estimate(job, &more));
  CHECK(ahd_available_memory() > 0);
#if defined(__linux__) || defined(_WIN32) || defined(__APPLE__)
  CHECK(ahd_available_memory() < (uint64_t)1 << 48); /* the system has a count */
#endif
  free(xy);
  ahd_job_free(job);
}

/* Points that can be read where they lie are not copied: those aligned, x and y side by side, and as
 * many whole numbers apart. */
static void test_memory_of_copies(void)
{
  static const struct
  {
    int32_t columns;
    int64_t row_stride, column_stride, offset;
    int is_copied;
  } kinds[] = { { 2, 16, 8, 0, 0 }, { 2, 24, 8, 0, 0 }, { 2, 24, 8, 8, 0 }, { 3, 40, 8, 0, 0 },
    { 2, 20, 8, 0, 1 }, { 2, 16, 8, 4, 1 }, { 2, 24, 16, 0, 1 }, { 2, 8, 8000, 0, 1 },
    { 2, -16, 8, 15984, 1 } };
  double* numbers = ahd_scattered(10000);
  uint64_t least = 0, bytes = 0;
  size_t k;
  for (k = 0; k < sizeof kinds / sizeof kinds[0]; ++k)
  {
    ahd_job* job = ahd_job_new();
    ahd_array points = { NULL, AHD_FLOAT64, 0, 1000, 0, 0 };
    points.data = (const char*)numbers + kinds[k].offset;
    points.columns = kinds[k].columns;
    points.row_stride = kinds[k].row_stride;
    points.column_stride = kinds[k].column_stride;
    CHECK_OK(job, ahd_set_array(job, "points", &points));
    CHECK_OK(job, ahd_estimate(job, &bytes));
    least = k == 0 ? bytes : least;
    CHECK(bytes == least + (kinds[k].is_copied ? 16000u : 0u));
    ahd_job_free(job);
  }
  free(numbers);
}

/* Segments that cross in more places than points are allowed. */
static void test_crossings(void)
{
  enum
  {
    kSide = 60
  };
  double ends[4 * kSide * 2];
  int64_t ids[2 * kSide * 2], i;
  uint64_t bytes = 0;
  ahd_job* job;
  ahd_array chains;
  for (i = 0; i < kSide; ++i) /* a lattice of lines */
  {
    double* const across = ends + 8 * i;
    across[0] = across[5] = 0;
    across[2] = across[7] = kSide + 1;
    across[1] = across[3] = across[4] = across[6] = (double)i + 1;
  }
  for (i = 0; i < 4 * kSide; ++i)
  {
    ids[i] = i;
  }
  job = ahd_job_of(ends, 4 * kSide, 2);
  chains = ahd_ids(ids, 2 * kSide, 2);
  CHECK_OK(job, ahd_set_array(job, "line_ids", &chains));
  CHECK_OK(job, ahd_set_int(job, "split_crossings", 1));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "split_crossings") == kSide * kSide);
  CHECK(ahd_counted(job, "most_crossings") >= kSide * kSide);
  CHECK_OK(job, ahd_estimate(job, &bytes));
  CHECK_OK(job, ahd_set_int(job, "memory_limit", (int64_t)bytes + 100000));
  CHECK_STATUS(job, AHD_TOO_MANY_CROSSINGS, ahd_run(job));
  CHECK_SAYS(job, "places");
  CHECK(ahd_counted(job, "most_crossings") < kSide * kSide);
  CHECK(ahd_counted(job, "memory_estimate") > ahd_counted(job, "memory_allowed"));
  ahd_job_free(job);
}

/* Memory known only while loops are inserted: the table of their edges. */
static void test_asked_memory(void)
{
  enum
  {
    kSquares = 600
  };
  double xy[4 * kSquares * 2];
  int64_t ids[4 * kSquares], i, needed, none;
  uint64_t bytes = 0;
  ahd_job* job;
  ahd_array loops;
  for (i = 0; i < 4 * kSquares; ++i) /* within each other */
  {
    const double half = (double)(i / 4) + 1;
    xy[2 * i] = i % 4 == 1 || i % 4 == 2 ? half : -half;
    xy[2 * i + 1] = i % 4 < 2 ? -half : half;
    ids[i] = i;
  }
  job = ahd_job_of(xy, 4 * kSquares, 2);
  loops = ahd_ids(ids, kSquares, 4);
  CHECK_OK(job, ahd_set_array(job, "loop_ids", &loops));
  CHECK_OK(job, ahd_set_int(job, "threads", 1));
  CHECK_OK(job, ahd_estimate(job, &bytes));
  CHECK_OK(job, ahd_run(job));
  needed = ahd_counted(job, "memory_estimate");
  CHECK(needed > (int64_t)bytes);
  for (i = 0; i < 20; ++i) /* requested memory is returned, refused or not */
  {
    CHECK_OK(job, ahd_set_int(job, "memory_limit", i % 3 == 0 ? (int64_t)bytes : needed - 1));
    CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_run(job));
    CHECK_SAYS(job, "\"memory_limit\" allows");
    CHECK(ahd_counted(job, "memory_estimate") > ahd_counted(job, "memory_allowed"));
    CHECK(ahd_counted(job, "points") == 4 * kSquares);
    CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_count(job, "triangles", &none));
    CHECK_OK(job, ahd_set_int(job, "memory_limit", needed));
    CHECK_OK(job, ahd_run(job));
    CHECK(ahd_counted(job, "memory_estimate") == needed);
  }
  ahd_job_free(job);
}

/* Same bytes for any number of threads; two jobs in two threads. */
static void* run_and_read(void* user)
{
  ahd_job* job = (ahd_job*)user;
  uint64_t numbers = 0;
  CHECK_OK(job, ahd_run(job));
  return ahd_read_ids(job, "neighbors", &numbers);
}

/* Engine.OwnThreads has the same of Linux. */
static void test_processors(void)
{
#ifdef _WIN32
  DWORD_PTR allowed = 0, group = 0;
  CHECK(GetProcessAffinityMask(GetCurrentProcess(), &allowed, &group));
  CHECK(SetProcessAffinityMask(GetCurrentProcess(), allowed & (~allowed + 1)));
  CHECK(ahd_processors() == 1);
  CHECK(SetProcessAffinityMask(GetCurrentProcess(), allowed));
#endif
  CHECK(ahd_processors() >= 1);
}

static void test_threads(void)
{
  double* xy = ahd_scattered(kMany);
  ahd_job *one = ahd_job_of(xy, kMany, 2), *four = ahd_job_of(xy, kMany, 2);
  pthread_t thread;
  void *first, *second = NULL;
  CHECK_OK(one, ahd_set_int(one, "threads", 1));
  CHECK_OK(four, ahd_set_int(four, "threads", 4));
  CHECK(pthread_create(&thread, NULL, run_and_read, one) == 0);
  second = run_and_read(four);
  CHECK(pthread_join(thread, &first) == 0);
  CHECK(memcmp(first, second, (size_t)ahd_counted(one, "triangles") * 24) == 0);
  CHECK(ahd_counted(one, "threads_used") == 1);
  CHECK(ahd_counted(four, "threads_used") == 4);
  CHECK(ahd_counted(one, "dispatch_target") >= 0 && ahd_counted(one, "dispatch_target") <= 2);
  free(first);
  free(second);
  free(xy);
  ahd_job_free(one);
  ahd_job_free(four);
}

static void test_fingerprint(void)
{
  unsigned char bytes[40] = { 0 };
  uint64_t a[2], b[2];
  int i;
  ahd_fingerprint(bytes, sizeof(bytes), 1, a);
  CHECK(a[0] != 0 || a[1] != 0);
  ahd_fingerprint(bytes, sizeof(bytes), 1, b);
  CHECK(memcmp(a, b, sizeof(a)) == 0);
  ahd_fingerprint(bytes, sizeof(bytes), 2, b);
  CHECK(memcmp(a, b, sizeof(a)) != 0);
  for (i = 0; i < 39; i += 13)
  {
    bytes[i] = 1;
    ahd_fingerprint(bytes, 39, 1, b);
    CHECK(memcmp(a, b, sizeof(a)) != 0);
  }
  ahd_fingerprint(NULL, 8, 0, a);
  CHECK(a[0] == 0 && a[1] == 0);
  ahd_fingerprint(NULL, 0, 0, a);
  CHECK(a[0] != 0 || a[1] != 0);
}

void test_trouble(void)
{
  test_no_job();
  test_no_result();
  test_progress();
  test_cancel();
  test_memory();
  test_memory_of_copies();
  test_crossings();
  test_asked_memory();
  test_processors();
  test_threads();
  test_fingerprint();
  test_absurd_counts();
}
