/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Values between the points: known answers, refusals, and that arrays requested in between change
 * nothing.
 */
#include "Check.h"

#include <fenv.h>
#include <math.h>
#include <stdlib.h>

/* A square of side 4 with a point in the middle; z = 3 x + 5 y + 1 and -x. */
static const double kXy[] = { 0, 0, 4, 0, 4, 4, 0, 4, 2, 2 };
static const double kZ[] = { 1, 0, 13, -4, 33, -4, 21, 0, 17, -2 };

static ahd_job* square_job(void)
{
  ahd_job* job = ahd_job_of(kXy, 5, 2);
  CHECK_OK(job, ahd_run(job));
  return job;
}

static int near_to(double a, double b)
{
  return fabs(a - b) <= 1e-13 * 33;
}

/* All methods but the nearest reproduce linear functions; on the surface alone. */
static void test_linear_functions(void)
{
  static const double xy[] = { 1, 0.5, 2, 2, 4, 1, 3, 3, 5, 5, (double)NAN, 0 };
  static const uint8_t on_surface[] = { 1, 1, 1, 1, 0, 0 };
  ahd_job* job = square_job();
  ahd_places places = { 0 };
  double out[12], slopes[24];
  uint8_t mask[6];
  ahd_sampled array = { kZ, 2, out, NULL };
  int32_t method, i;
  places.xy = xy;
  places.count = 6;
  for (method = AHD_SAMPLE_LINEAR; method <= AHD_SAMPLE_LAPLACE; ++method)
  {
    memset(mask, 7, sizeof(mask));
    array.gradients = method == AHD_SAMPLE_LINEAR ? slopes : NULL;
    CHECK_OK(job, ahd_set_int(job, "sample_method", method));
    CHECK_OK(job, ahd_sample(job, &places, &array, 1, mask));
    CHECK(memcmp(mask, on_surface, sizeof(mask)) == 0);
    for (i = 0; i < 4; ++i)
    {
      CHECK(near_to(out[2 * i], 3 * xy[2 * i] + 5 * xy[2 * i + 1] + 1));
      CHECK(near_to(out[2 * i + 1], -xy[2 * i]));
    }
    CHECK(isnan(out[8]) && isnan(out[9]) && isnan(out[10]) && isnan(out[11]));
    CHECK(ahd_counted(job, "sampled_places") == 6 && ahd_counted(job, "sampled_valued") == 4);
    CHECK(ahd_counted(job, "sampled_outside") == 1 && ahd_counted(job, "sampled_not_finite") == 1);
    CHECK(ahd_counted(job, "sampled_without_value") == 0);
    CHECK(ahd_counted(job, "sampling_estimate") > 0);
  }
  CHECK(near_to(slopes[0], 3) && near_to(slopes[1], 5));
  CHECK(near_to(slopes[2], -1) && near_to(slopes[3], 0) && isnan(slopes[16]));
  CHECK_OK(job, ahd_sample(job, &places, &array, 1, NULL));
  CHECK_OK(job, ahd_sample(job, &places, NULL, 0, mask));
  ahd_job_free(job);
}

/* The nearest vertex, as a method and for places outside; rows that run downwards. */
static void test_nearest_and_rasters(void)
{
  static const double expected[] = { 21, 17, 33, 17, 17, 17, 1, 17, 13 };
  static const double corners[] = { 21, 33, 1, 13 };
  static const double beside[] = { 6, 18, 11, 23 };
  ahd_job* job = square_job();
  ahd_places raster = { NULL, 0, { 0.5, 3.5 }, { 1.5, -1.5 }, 3, 3 };
  double z[5], out[9];
  uint8_t mask[9];
  ahd_sampled array = { z, 1, out, NULL };
  int i;
  for (i = 0; i < 5; ++i)
  {
    z[i] = kZ[2 * i];
  }
  CHECK_OK(job, ahd_set_int(job, "sample_method", AHD_SAMPLE_NEAREST));
  CHECK_OK(job, ahd_sample(job, &raster, &array, 1, mask));
  CHECK(memcmp(out, expected, sizeof(expected)) == 0 && mask[0] == 1 && mask[8] == 1);
  raster.origin[0] = -3;
  raster.origin[1] = 7;
  raster.spacing[0] = 10;
  raster.spacing[1] = -10;
  raster.columns = raster.rows = 2;
  CHECK_OK(job, ahd_set_int(job, "sample_method", AHD_SAMPLE_NATURAL_NEIGHBOR));
  CHECK_OK(job, ahd_sample(job, &raster, &array, 1, mask));
  CHECK(isnan(out[0]) && isnan(out[3]) && mask[0] == 0);
  CHECK_OK(job, ahd_set_int(job, "sample_outside", AHD_OUTSIDE_NEAREST_VERTEX));
  for (i = 0; i < 2; ++i)
  {
    memset(out, 0, sizeof(out));
    memset(mask, 7, sizeof(mask));
    CHECK_OK(job, ahd_sample(job, &raster, &array, 1, i == 0 ? NULL : mask));
    CHECK(memcmp(out, corners, sizeof(corners)) == 0);
    CHECK(ahd_counted(job, "sampled_outside") == 4 && ahd_counted(job, "sampled_valued") == 0);
  }
  CHECK(mask[0] == 0 && mask[3] == 0 && mask[4] == 7);
  raster.origin[1] = 1;
  raster.spacing[1] = 1;
  CHECK_OK(job, ahd_set_int(job, "sample_outside", AHD_OUTSIDE_BOUNDARY));
  CHECK_OK(job, ahd_sample(job, &raster, &array, 1, mask));
  CHECK(memcmp(out, beside, sizeof(beside)) == 0 && mask[0] == 0 && mask[3] == 0);
  ahd_job_free(job);
}

/* Sixteen units in the last place below the square have its values, though they are outside. */
static void test_places_at_the_rim(void)
{
  static const double xy[] = { 1, -0x1p-46, 1, -0x1p-46 - 0x1p-90 };
  ahd_job* job = square_job();
  ahd_places places = { 0 };
  double out[4];
  uint8_t mask[2];
  int32_t kinds[2];
  int64_t ids[6], cells[2];
  ahd_sampled array = { kZ, 2, out, NULL };
  places.xy = xy;
  places.count = 2;
  CHECK_OK(job, ahd_sample(job, &places, &array, 1, mask));
  CHECK(mask[0] == 1 && mask[1] == 0 && near_to(out[0], 4) && isnan(out[2]));
  CHECK(ahd_counted(job, "sampled_valued") == 1 && ahd_counted(job, "sampled_outside") == 1);
  CHECK_OK(job, ahd_locate(job, xy, 2, kinds, ids, cells));
  CHECK(kinds[0] == AHD_OUTSIDE && kinds[1] == AHD_OUTSIDE);
  ahd_job_free(job);
}

/* Weights are those used for values. */
static void test_weights(void)
{
  static const double xy[] = { 2, 1, 9, 9, 4, 4, 2, 0 };
  ahd_job* job = square_job();
  ahd_places places = { 0 };
  double *weights, sum = 0;
  int64_t offsets[5], *points;
  uint64_t numbers = 0, others = 0;
  places.xy = xy;
  places.count = 4;
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_get_array(job, "weights", AHD_FLOAT64, NULL, 0));
  CHECK_SAYS(job, "without ahd_sample_weights()");
  CHECK_OK(job, ahd_sample_weights(job, &places));
  CHECK_OK(job, ahd_get_array(job, "weight_offsets", AHD_INT64, offsets, 5));
  CHECK(offsets[0] == 0 && offsets[1] == 3 && offsets[2] == 3 && offsets[3] == 4);
  CHECK(offsets[4] == 6);
  points = ahd_read_ids(job, "weight_points", &numbers);
  weights = ahd_read_doubles(job, "weights", &others);
  CHECK(numbers == 6 && others == 6 && points[3] == 2 && weights[3] == 1);
  CHECK((points[4] == 0 && points[5] == 1) || (points[4] == 1 && points[5] == 0));
  CHECK(weights[4] == 0.5 && weights[5] == 0.5);
  for (numbers = 0; numbers < 3; ++numbers)
  {
    sum += weights[numbers] * kZ[2 * points[numbers]];
  }
  CHECK(near_to(sum, 12));
  CHECK(ahd_counted(job, "sampled_valued") == 3 && ahd_counted(job, "sampled_outside") == 1);
  free(points);
  free(weights);
  CHECK_OK(job, ahd_run(job));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_array_size(job, "weights", &numbers, &others));
  CHECK(ahd_counted(job, "sampled_places") == 0);
  ahd_job_free(job);
}

/* NaN at a point; constraints, holes and limits: no value where no triangle is in the output. */
static void test_surface(void)
{
  static const int64_t loop[] = { 0, 1, 4 };
  static const double xy[] = { 2, 1, 3, 2, 2, 3 };
  const ahd_array loops = ahd_ids(loop, 3, 1);
  ahd_job* job = ahd_job_of(kXy, 5, 2);
  ahd_places places = { 0 };
  double z[5] = { 1, 2, 3, 4, (double)NAN }, out[3];
  ahd_sampled array = { z, 1, out, NULL };
  uint8_t mask[3];
  places.xy = xy;
  places.count = 3;
  CHECK_OK(job, ahd_run(job));
  CHECK_OK(job, ahd_sample(job, &places, &array, 1, mask));
  CHECK(isnan(out[0]) && mask[0] == 1 && ahd_counted(job, "sampled_without_value") == 3);
  CHECK_OK(job, ahd_set_int(job, "sample_method", AHD_SAMPLE_LAPLACE));
  CHECK_OK(job, ahd_sample(job, &places, &array, 1, mask));
  CHECK(out[0] > 1 && out[0] < 4 && ahd_counted(job, "sampled_left_out") == 3);
  CHECK_OK(job, ahd_set_array(job, "loop_ids", &loops));
  CHECK_OK(job, ahd_run(job));
  CHECK_OK(job, ahd_sample(job, &places, &array, 1, mask));
  CHECK(mask[0] == 1 && mask[1] == 0 && mask[2] == 0);
  CHECK_OK(job, ahd_set_array(job, "loop_ids", NULL));
  CHECK_OK(job, ahd_set_double(job, "maximum_edge_length", 3.0));
  CHECK_OK(job, ahd_run(job));
  CHECK_OK(job, ahd_sample(job, &places, &array, 1, mask));
  CHECK(mask[0] == 0 && mask[1] == 0 && mask[2] == 0);
  CHECK_OK(job, ahd_set_array(job, "points", NULL));
  CHECK_OK(job, ahd_run(job));
  array.values = NULL;
  CHECK_OK(job, ahd_sample(job, &places, &array, 1, mask));
  CHECK(mask[0] == 0 && isnan(out[0]));
  ahd_job_free(job);
}

/* Every array, and every one after samples of each method: the same values and the same arrays. */
static void test_between_arrays(void)
{
  enum
  {
    kCount = 20000,
    kPlaces = 1000
  };
  double* const xy = ahd_scattered(kCount);
  double* const at = ahd_scattered(kPlaces);
  double *out = (double*)malloc(kPlaces * sizeof(double)),
         *first = (double*)malloc(4 * kPlaces * sizeof(double));
  ahd_job* job = ahd_job_of(xy, kCount, 2);
  ahd_places places = { 0 };
  ahd_sampled array = { xy, 1, out, NULL };
  const char* name;
  int32_t method, k;
  uint32_t i;
  places.xy = at;
  places.count = kPlaces;
  CHECK_OK(job, ahd_set_int(job, "duplicates", AHD_DUPLICATES_HIGHEST_Z));
  CHECK_OK(job, ahd_set_int(job, "want_order", 1));
  for (k = 0; k < 2; ++k)
  {
    CHECK_OK(job, ahd_run(job));
    for (i = 0; (name = ahd_name(AHD_OUTPUT_ARRAYS, i)) != NULL; ++i)
    {
      uint64_t rows = 0, columns = 0, numbers = 0;
      method = (int32_t)(i % 4);
      CHECK_OK(job, ahd_set_int(job, "sample_method", method));
      CHECK_OK(job, ahd_sample(job, &places, &array, 1, NULL));
      if (k == 0 && i < 4)
      {
        memcpy(first + method * kPlaces, out, kPlaces * sizeof(double));
      }
      CHECK(memcmp(first + method * kPlaces, out, kPlaces * sizeof(double)) == 0);
      if (strcmp(name, "point_status") == 0 || strcmp(name, "order") == 0 ||
        strcmp(name, "vertex_of_point") == 0 || strcmp(name, "neighbors") == 0)
      {
        free(ahd_read_ids(job, name, &numbers));
        CHECK_OK(job, ahd_array_size(job, name, &rows, &columns));
        CHECK(numbers == rows * columns && numbers >= kCount);
      }
      CHECK_OK(job, ahd_sample(job, &places, &array, 1, NULL));
      CHECK(memcmp(first + method * kPlaces, out, kPlaces * sizeof(double)) == 0);
    }
  }
  free(xy);
  free(at);
  free(out);
  free(first);
  ahd_job_free(job);
}

static void test_refused(void)
{
  static const double xy[] = { 1, 1 };
  ahd_job* job = ahd_job_of(kXy, 5, 2);
  ahd_places places = { 0 }, raster = { NULL, 0, { 0, 0 }, { 1, 1 }, 2, 2 };
  double out[8] = { 7, 7, 7, 7, 7, 7, 7, 7 }, slopes[16];
  ahd_sampled array = { kZ, 2, out, NULL };
  uint64_t bytes = 0;
  places.xy = xy;
  places.count = 1;
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_sample(NULL, &places, &array, 1, NULL));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_sample_estimate(NULL, &places, 1, &bytes));
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_sample_weights(NULL, &places));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_sample(job, &places, &array, 1, NULL));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_sample_weights(job, &places));
  CHECK_OK(job, ahd_run(job));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_sample(job, NULL, &array, 1, NULL));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_sample(job, &places, NULL, 1, NULL));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_sample_weights(job, NULL));
  CHECK_NULL(job, "bytes", ahd_sample_estimate(job, &places, 1, NULL));
  CHECK_NULL(job, "places", ahd_sample_estimate(job, NULL, 1, &bytes));
  array.columns = -1;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_sample(job, &places, &array, 1, NULL));
  array.columns = 2;
  array.out = NULL;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_sample(job, &places, &array, 1, NULL));
  array.out = out;
  array.values = NULL;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_sample(job, &places, &array, 1, NULL));
  array.values = kZ;
  array.columns = 1 << 30;
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_sample(job, &places, &array, 1, NULL));
  CHECK_SAYS(job, "1073741824 columns are too many");
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_sample_estimate(job, &places, UINT64_MAX, &bytes));
  array.columns = 2;
  array.gradients = slopes;
  CHECK_OK(job, ahd_set_int(job, "sample_method", AHD_SAMPLE_LAPLACE));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_sample(job, &places, &array, 1, NULL));
  CHECK_SAYS(job, "gradients");
  array.gradients = NULL;
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_set_int(job, "sample_method", 4));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_set_int(job, "sample_outside", 3));
  places.xy = NULL;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_sample(job, &places, &array, 1, NULL));
  raster.spacing[1] = 0;
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_sample(job, &raster, &array, 1, NULL));
  raster.spacing[1] = (double)INFINITY;
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_sample(job, &raster, &array, 1, NULL));
  raster.spacing[1] = 1;
  raster.origin[0] = (double)NAN;
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_sample(job, &raster, &array, 1, NULL));
  raster.origin[0] = 0;
  raster.columns = raster.rows = UINT64_C(1) << 33;
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_sample(job, &raster, &array, 1, NULL));
  CHECK_SAYS(job, "8589934592 x 8589934592 cells");
  CHECK(out[0] == 7);
  ahd_job_free(job);
}

/* Memory: refused with numbers before anything is written; the estimate suffices. */
static void test_memory(void)
{
  ahd_job* job = square_job();
  ahd_places raster = { NULL, 0, { 0, 0 }, { 1, 1 }, 2, 2 };
  double out[8] = { 7 };
  ahd_sampled array = { kZ, 2, out, NULL };
  uint64_t bytes = 0, more = 0;
  CHECK_OK(job, ahd_sample_estimate(job, &raster, 2, &bytes));
  CHECK_OK(job, ahd_set_int(job, "other_memory", 1000));
  CHECK_OK(job, ahd_sample_estimate(job, &raster, 2, &more));
  CHECK(more == bytes + 1000);
  CHECK_OK(job, ahd_set_int(job, "memory_limit", ahd_counted(job, "memory_estimate") + 500));
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_sample_estimate(job, &raster, 2, &more));
  CHECK(more == bytes + 1000);
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_sample(job, &raster, &array, 1, NULL));
  CHECK_SAYS(job, "\"memory_limit\" leaves 500");
  CHECK(out[0] == 7);
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_sample_weights(job, &raster));
  CHECK_OK(job,
    ahd_set_int(job, "memory_limit", ahd_counted(job, "memory_estimate") + (int64_t)bytes + 1000));
  CHECK_OK(job, ahd_sample(job, &raster, &array, 1, NULL));
  CHECK(ahd_counted(job, "sampling_estimate") == (int64_t)bytes + 1000 && out[0] == 1);
  CHECK_OK(job, ahd_set_int(job, "memory_limit", 0));
  CHECK_OK(job, ahd_set_int(job, "other_memory", INT64_C(1) << 62));
  CHECK_STATUS(job, AHD_MEMORY_LIMIT, ahd_sample(job, &raster, &array, 1, NULL));
  CHECK_SAYS(job, "Values at 4 places may take");
  ahd_job_free(job);
}

/* The same before there is a result; of places only the counts matter. */
static void test_memory_before(void)
{
  ahd_job* job = ahd_job_new();
  ahd_places raster = { NULL, 0, { 0, 0 }, { 1, 1 }, 2, 2 },
             places = { NULL, 100, { 0 }, { 0 }, 0, 0 };
  uint64_t one = 0, two = 0, filled = 0;
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_sample_estimate_before(NULL, 9, &raster, 1, 0, &one));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_sample_estimate_before(job, 9, NULL, 1, 0, &one));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_sample_estimate_before(job, 9, &raster, 1, 0, NULL));
  CHECK_STATUS(
    job, AHD_BAD_VALUE, ahd_sample_estimate_before(job, 9, &raster, UINT64_MAX, 0, &one));
  CHECK_STATUS(
    job, AHD_BAD_VALUE, ahd_sample_estimate_before(job, UINT64_MAX, &raster, 1, 0, &one));
  CHECK_OK(job, ahd_sample_estimate_before(job, 1000, &raster, 1, 0, &one));
  CHECK_OK(job, ahd_sample_estimate_before(job, 1000, &raster, 2, 0, &two));
  CHECK(two >= one + 8 * 1000 && two < one + 8 * 1000 + 1000);
  CHECK_OK(job, ahd_sample_estimate_before(job, 1000, &raster, 1, 1, &filled));
  CHECK(filled > one + 8 * 1000);
  CHECK_OK(job, ahd_sample_estimate_before(job, 1000, &places, 1, 0, &two));
  CHECK(two > one + 16 * 100);
  raster.columns = raster.rows = UINT64_MAX;
  CHECK_OK(job, ahd_sample_estimate_before(job, 1000, &raster, 1, 0, &two));
  CHECK(two > one);
  raster.columns = raster.rows = UINT64_C(1) << 32; /* as many places as 0, in 64 bits */
  CHECK_OK(job, ahd_sample_estimate_before(job, 1000, &raster, 1, 0, &one));
  CHECK_OK(job, ahd_sample_estimate_before(job, 1000, &raster, 1, 1, &filled));
  CHECK(filled > one + 32 * (UINT64_C(1) << 17));
  ahd_job_free(job);
}

/* Points are moved like those of the input, in any rounding mode of the caller. */
static void test_to_plane(void)
{
  static const double wall[] = { 5, 0, 0, 5, 8, 0, 5, 8, 8, 6, 0, 8, 5, 3, 4 };
  static const double turn[] = { 0, 0.7, 0, 0.3, 0, 0, 0.7, 0, 1, 0, 0, 0, 0, 0, 0, 1 };
  const ahd_array matrix = { turn, AHD_FLOAT64, 4, 4, 32, 8 };
  ahd_job* job = ahd_job_of(wall, 5, 3);
  int32_t plane, i;
  double moved[15], there[15], heights[5];
  CHECK_STATUS(NULL, AHD_NO_JOB, ahd_to_plane(NULL, moved, 1));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_to_plane(job, moved, 1));
  CHECK_OK(job, ahd_set_array(job, "matrix", &matrix));
  for (plane = AHD_PLANE_XY; plane <= AHD_PLANE_MATRIX; ++plane)
  {
    memcpy(moved, wall, sizeof(wall));
    CHECK_OK(job, ahd_set_int(job, "plane", plane));
    CHECK_OK(job, ahd_run(job));
    CHECK(fesetround(FE_UPWARD) == 0);
    CHECK_OK(job, ahd_to_plane(job, moved, 5));
    CHECK(fegetround() == FE_UPWARD && fesetround(FE_TONEAREST) == 0);
    CHECK_OK(job, ahd_get_array(job, "plane_points", AHD_FLOAT64, there, 15));
    CHECK_OK(job, ahd_get_array(job, "heights", AHD_FLOAT64, heights, 5));
    CHECK(memcmp(moved, there, sizeof(moved)) == 0);
    CHECK((memcmp(moved, wall, sizeof(moved)) == 0) == (plane == AHD_PLANE_XY));
    for (i = 0; i < 5; ++i)
    {
      CHECK(heights[i] == there[3 * i + 2]);
    }
  }
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_to_plane(job, NULL, 1));
  CHECK_OK(job, ahd_to_plane(job, NULL, 0));
  ahd_job_free(job);
}

typedef struct counter
{
  int calls, last_call;
  double fraction;
} counter;

static int32_t count_calls(void* user, int32_t phase, double fraction)
{
  counter* own = (counter*)user;
  CHECK(phase == AHD_PHASE_OUTPUTS);
  CHECK(fraction >= own->fraction && fraction <= 1.0);
  own->fraction = fraction;
  return ++own->calls == own->last_call;
}

/* The callbacks of one call; cancelled at any of them, it can be repeated with the same bytes, and
 * changes no count. */
static void test_progress(void)
{
  enum
  {
    kBytes = 2 * 500 * 500 * sizeof(double)
  };
  double *xy = ahd_scattered(100000), *out = (double*)malloc(kBytes);
  double* first = (double*)malloc(kBytes);
  ahd_job* job = ahd_job_of(xy, 100000, 2);
  ahd_places raster = { NULL, 0, { -0.5, -0.5 }, { 0.004, 0.004 }, 500, 500 };
  ahd_sampled array = { xy, 2, out, NULL };
  int k, calls;
  CHECK_OK(job, ahd_run(job));
  CHECK_OK(job, ahd_set_int(job, "sample_outside", AHD_OUTSIDE_NEAREST_VERTEX));
  for (k = AHD_SAMPLE_LINEAR; k <= AHD_SAMPLE_NATURAL_NEIGHBOR; ++k)
  {
    counter own = { 0 };
    CHECK_OK(job, ahd_set_int(job, "sample_method", k));
    CHECK_OK(job, ahd_set_progress(job, count_calls, &own));
    CHECK_OK(job, ahd_sample(job, &raster, &array, 1, NULL));
    CHECK(own.calls > 10 && own.fraction == 1.0);
    memcpy(first, out, kBytes);
    calls = own.calls;
    /* the number of callbacks depends on time, too: one after 0.1 s without any */
    for (own.last_call = 1; own.last_call <= calls / 2; own.last_call += 1 + calls / 8)
    {
      const int last = own.last_call;
      CHECK_OK(job, ahd_set_progress(job, NULL, NULL));
      CHECK_OK(job, ahd_run(job)); /* tables are made again */
      memset(out, 7, kBytes);
      CHECK_OK(job, ahd_set_progress(job, count_calls, &own));
      own.calls = 0;
      own.fraction = 0;
      CHECK_STATUS(job, AHD_CANCELLED, ahd_sample(job, &raster, &array, 1, NULL));
      CHECK(own.calls == last);
      CHECK(ahd_counted(job, "sampled_places") == 0 && ahd_counted(job, "sampling_estimate") == 0);
      CHECK_OK(job, ahd_set_progress(job, NULL, NULL));
      CHECK_OK(job, ahd_sample(job, &raster, &array, 1, NULL));
      CHECK(memcmp(out, first, kBytes) == 0);
    }
    CHECK_OK(job, ahd_set_progress(job, NULL, NULL));
    ahd_cancel(job);
    CHECK_STATUS(job, AHD_CANCELLED, ahd_sample_weights(job, &raster));
    CHECK(ahd_counted(job, "sampled_places") == 500 * 500);
    {
      double seconds = -1;
      CHECK_OK(job, ahd_measure(job, "seconds_sample", &seconds));
      CHECK(seconds > 0 && seconds < 600);
    }
  }
  free(xy);
  free(out);
  free(first);
  ahd_job_free(job);
}

/* Any number of threads gives the same bytes. */
static void test_threads(void)
{
  enum
  {
    kBytes = 300 * 300 * 2 * sizeof(double)
  };
  double *xy = ahd_scattered(50000), *out = (double*)malloc(kBytes),
         *first = (double*)malloc(kBytes);
  ahd_job* job = ahd_job_of(xy, 50000, 2);
  ahd_places raster = { NULL, 0, { -0.1, -0.1 }, { 0.004, 0.004 }, 300, 300 };
  ahd_sampled array = { xy, 2, out, NULL };
  int64_t method, threads;
  CHECK_OK(job, ahd_run(job));
  CHECK_OK(job, ahd_set_int(job, "sample_outside", AHD_OUTSIDE_NEAREST_VERTEX));
  for (method = 0; method < 4; ++method)
  {
    CHECK_OK(job, ahd_set_int(job, "sample_method", method));
    for (threads = 1; threads < 4; ++threads)
    {
      CHECK_OK(job, ahd_set_int(job, "threads", threads));
      CHECK_OK(job, ahd_sample(job, &raster, &array, 1, NULL));
      memmove(threads == 1 ? first : out, out, kBytes);
      CHECK(memcmp(first, out, kBytes) == 0);
      memset(out, 0, kBytes);
    }
  }
  free(xy);
  free(out);
  free(first);
  ahd_job_free(job);
}

void test_sample(void)
{
  test_linear_functions();
  test_nearest_and_rasters();
  test_places_at_the_rim();
  test_weights();
  test_surface();
  test_between_arrays();
  test_refused();
  test_memory();
  test_memory_before();
  test_to_plane();
  test_progress();
  test_threads();
}
