/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * An existing surface: its own triangles are written and sampled, however they were made; settings
 * that do not fit it are refused.
 */
#include "Check.h"

#include <math.h>
#include <stdlib.h>

enum
{
  kScattered = 300,
  kPoints = kScattered + 7,
  kSide = 40,
  kPlaces = kSide * kSide
};

static double* points(void)
{
  static const double more[] = { 0.1, 0.1, 0.9, 0.1, 0.9, 0.9, 0.1, 0.9, /* an outline */
    0.4, 0.4, 0.5, 0.7, 0.6, 0.4 };                                      /* and an island */
  double* scattered = ahd_scattered(kScattered);
  double* xy = (double*)malloc(2 * kPoints * sizeof(double));
  memcpy(xy, scattered, 2 * kScattered * sizeof(double));
  memcpy(xy + 2 * kScattered, more, sizeof(more));
  free(scattered);
  return xy;
}

/* Values of points: x x and x y. */
static double* bent(const double* xy)
{
  double* values = (double*)malloc(2 * kPoints * sizeof(double));
  int i;
  for (i = 0; i < 2 * kPoints; ++i)
  {
    values[i] = xy[i] * xy[i - i % 2];
  }
  return values;
}

/* Values at the places, of two columns; NaN where there is none. */
static void sample(ahd_job* job, const double* values, int32_t method, double* out, uint8_t* mask)
{
  const ahd_places raster = { NULL, 0, { 0.01, 0.01 }, { 0.025, 0.025 }, kSide, kSide };
  const ahd_sampled array = { values, 2, out, NULL };
  CHECK_OK(job, ahd_set_int(job, "sample_method", method));
  CHECK_OK(job, ahd_sample(job, &raster, &array, 1, mask));
}

/* The result of a run with these chains, as input. */
typedef struct surface
{
  int64_t* corners;
  uint8_t* edges;
  uint64_t triangles;
  double out[4][2 * kPlaces];
  uint8_t mask[4][kPlaces];
} surface;

static surface* surface_of(const double* xy, const double* values, int has_loops)
{
  static const int64_t outline[] = { kScattered, kScattered + 1, kScattered + 2, kScattered + 3,
    kScattered + 4, kScattered + 5, kScattered + 6 };
  static const int64_t line[] = { 3, 150, 77 };
  static const int64_t starts[] = { 0, 4, 7 };
  const ahd_array loops = ahd_ids(outline, 7, 1), lines = ahd_ids(line, 3, 1);
  const ahd_array offsets = ahd_ids(starts, 3, 1);
  surface* made = (surface*)malloc(sizeof(surface));
  ahd_job* job = ahd_job_of(xy, kPoints, 2);
  uint64_t numbers = 0;
  int32_t method;
  CHECK_OK(job, ahd_set_array(job, "line_ids", &lines));
  CHECK_OK(job, ahd_set_array(job, "loop_ids", has_loops ? &loops : NULL));
  CHECK_OK(job, ahd_set_array(job, "loop_offsets", has_loops ? &offsets : NULL));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "constraint_edges") > 1);
  made->corners = ahd_read_ids(job, "triangles", &numbers);
  made->triangles = numbers / 3;
  made->edges = (uint8_t*)malloc((size_t)made->triangles);
  CHECK_OK(job, ahd_get_array(job, "constraint_edges", AHD_UINT8, made->edges, made->triangles));
  for (method = 0; method < 4; ++method)
  {
    sample(job, values, method, made->out[method], made->mask[method]);
  }
  ahd_job_free(job);
  return made;
}

static void free_surface(surface* made)
{
  free(made->corners);
  free(made->edges);
  free(made);
}

/* A job with it, before its run. */
static ahd_job* job_with(const double* xy, const surface* made)
{
  const ahd_array triangles = ahd_ids(made->corners, (int64_t)made->triangles, 3);
  const ahd_array edges = { made->edges, AHD_UINT8, 1, (int64_t)made->triangles, 1, 1 };
  ahd_job* job = ahd_job_of(xy, kPoints, 2);
  CHECK_OK(job, ahd_set_array(job, "surface", &triangles));
  CHECK_OK(job, ahd_set_array(job, "surface_edges", &edges));
  return job;
}

static void check_triangles(ahd_job* job, const surface* made)
{
  uint64_t numbers = 0;
  int64_t* corners = ahd_read_ids(job, "triangles", &numbers);
  CHECK(numbers == 3 * made->triangles);
  CHECK(memcmp(corners, made->corners, (size_t)numbers * sizeof(int64_t)) == 0);
  CHECK(ahd_counted(job, "folded_triangles") == 0);
  free(corners);
}

static int are_near(const double* a, const double* b)
{
  int i, near = 1;
  for (i = 0; i < 2 * kPlaces; ++i)
  {
    near = near && (isnan(a[i]) ? isnan(b[i]) : fabs(a[i] - b[i]) < 1e-12);
  }
  return near;
}

/* The job samples like the run that made the surface: to the byte if it has all vertices, else up
 * to rounding. */
static void check_samples(
  ahd_job* job, const double* values, const surface* made, int32_t methods, int to_the_byte)
{
  double* out = (double*)malloc(sizeof(made->out[0]));
  uint8_t mask[kPlaces];
  int32_t method;
  for (method = 0; method < methods; ++method)
  {
    sample(job, values, method, out, mask);
    CHECK(memcmp(mask, made->mask[method], sizeof(mask)) == 0);
    CHECK(to_the_byte ? memcmp(out, made->out[method], sizeof(made->out[0])) == 0
                      : are_near(out, made->out[method]));
  }
  free(out);
}

/* Outline and island, or a breakline alone: natural neighbours end where they ended. */
static void test_same_values(void)
{
  double* xy = points();
  double* values = bent(xy);
  int has_loops;
  for (has_loops = 0; has_loops < 2; ++has_loops)
  {
    surface* made = surface_of(xy, values, has_loops);
    ahd_job* job = job_with(xy, made);
    CHECK_OK(job, ahd_run(job));
    check_triangles(job, made);
    check_samples(job, values, made, has_loops ? 3 : 4, !has_loops);
    CHECK(has_loops == (ahd_counted(job, "skipped") > 0));
    ahd_job_free(job);
    free_surface(made);
  }
  free(values);
  free(xy);
}

/* The triangles are found without constraints, and with too few of them; with strides of columns
 * and rows, of 32 bits, and with points skipped. */
static void test_forms(void)
{
  double* xy = points();
  double* values = bent(xy);
  surface* made = surface_of(xy, values, 1);
  const int64_t rows = (int64_t)made->triangles;
  int32_t* apart = (int32_t*)malloc(sizeof(int32_t) * 4 * (size_t)rows);
  uint8_t* all = (uint8_t*)malloc(kPoints);
  const ahd_array triangles = { apart + rows, AHD_INT32, 3, rows, sizeof(int32_t),
    (int64_t)sizeof(int32_t) * rows };
  const ahd_array skip = { all, AHD_UINT8, 1, kPoints, 1, 1 };
  ahd_job* job = job_with(xy, made);
  int64_t i;
  memset(all, 1, kPoints);
  for (i = 0; i < 3 * rows; ++i)
  {
    apart[rows + i % 3 * rows + i / 3] = (int32_t)made->corners[i];
  }
  CHECK_OK(job, ahd_set_array(job, "surface_edges", NULL));
  CHECK_OK(job, ahd_set_array(job, "surface", &triangles));
  CHECK_OK(job, ahd_set_array(job, "skip", &skip));
  CHECK_OK(job, ahd_run(job));
  check_triangles(job, made);
  check_samples(job, values, made, 1, 0);
  ahd_job_free(job);
  memset(made->edges, 0, (size_t)rows);
  made->edges[rows / 2] = 2;
  job = job_with(xy, made);
  CHECK_OK(job, ahd_run(job));
  check_triangles(job, made);
  check_samples(job, values, made, 1, 0);
  ahd_job_free(job);
  free(all);
  free(apart);
  free_surface(made);
  free(values);
  free(xy);
}

/* Cancels at the call of this number. */
static int32_t cancel_at(void* user, int32_t phase, double fraction)
{
  int* left = (int*)user;
  (void)phase;
  (void)fraction;
  return --*left <= 0;
}

/* A run that was cancelled does not report a folded surface. */
static void test_cancel(void)
{
  double* xy = points();
  surface* made = surface_of(xy, xy, 1);
  ahd_job* job = job_with(xy, made);
  ahd_status status = AHD_CANCELLED;
  int calls, left;
  CHECK_OK(job, ahd_set_array(job, "surface_edges", NULL));
  for (calls = 1; status == AHD_CANCELLED; ++calls)
  {
    left = calls;
    CHECK_OK(job, ahd_set_progress(job, cancel_at, &left));
    status = ahd_run(job);
    CHECK(ahd_counted(job, "folded_triangles") == 0);
  }
  CHECK(status == AHD_OK && calls > 10);
  CHECK_OK(job, ahd_set_progress(job, NULL, NULL));
  check_triangles(job, made);
  ahd_job_free(job);
  free_surface(made);
  free(xy);
}

static void test_what_cannot_be(void)
{
  static const int64_t ids[] = { 0, 1 };
  const ahd_array line = ahd_ids(ids, 2, 1);
  const char* const settings[] = { "bounding", "insertion_limit", "maximum_vertices" };
  double* xy = points();
  surface* made = surface_of(xy, xy, 0);
  const ahd_array fewer = { made->edges, AHD_UINT8, 1, 3, 1, 1 };
  const ahd_array pairs = ahd_ids(made->corners, 3, 2);
  ahd_job* job = job_with(xy, made);
  int64_t corner = made->corners[30];
  const char* name;
  double before;
  uint32_t i;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_set_array(job, "surface", &pairs));
  for (i = 0; i < 3; ++i)
  {
    CHECK_OK(job, ahd_set_int(job, settings[i], 1));
    CHECK_STATUS(job, AHD_BAD_VALUE, ahd_run(job));
    CHECK_SAYS(job, settings[i]);
    CHECK_OK(job, ahd_set_int(job, settings[i], 0));
  }
  for (i = 0; (name = ahd_name(AHD_DOUBLE_SETTINGS, i)); ++i) /* limits, which are off at 0 */
  {
    CHECK_OK(job, ahd_get_double(job, name, &before));
    if (before == 0 && strcmp(name, "progress_delay") != 0)
    {
      CHECK_OK(job, ahd_set_double(job, name, 0.1));
      CHECK_STATUS(job, AHD_BAD_VALUE, ahd_run(job));
      CHECK_SAYS(job, name);
      CHECK_OK(job, ahd_set_double(job, name, 0));
    }
  }
  CHECK_OK(job, ahd_set_array(job, "line_ids", &line));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_run(job));
  CHECK_OK(job, ahd_set_array(job, "line_ids", NULL));
  CHECK_OK(job, ahd_set_array(job, "surface_edges", &fewer));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_run(job));
  CHECK_SAYS(job, "surface_edges");
  ahd_job_free(job);
  made->corners[30] = made->corners[31]; /* one is clockwise now */
  made->corners[31] = corner;
  job = job_with(xy, made);
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_run(job));
  CHECK_SAYS(job, "1 of the ");
  CHECK(ahd_counted(job, "folded_triangles") == 1);
  made->corners[31] = made->corners[30];
  made->corners[30] = INT64_MAX; /* and no point */
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_run(job));
  CHECK_SAYS(job, "corners that are no vertices");
  ahd_job_free(job);
  free_surface(made);
  free(xy);
}

/* The plane is fitted to all points but those that were added, corners or not. */
static void test_plane(void)
{
  static const double wall[] = { 5, 0, 0, 5, 8, 0, 5, 8, 8, 6, 0, 8, 5, 3, 4, 90, 3, 4, -7, 1, 2 };
  double expected[16], matrix[16];
  ahd_job *all = ahd_job_of(wall, 6, 3), *job = ahd_job_of(wall, 7, 3);
  uint64_t numbers = 0;
  int64_t* corners;
  ahd_array two;
  CHECK_OK(all, ahd_fit_plane(all, expected));
  CHECK_OK(job, ahd_set_int(job, "unfitted_points", 1));
  CHECK_OK(job, ahd_fit_plane(job, matrix));
  CHECK(memcmp(matrix, expected, sizeof(matrix)) == 0);
  CHECK_OK(job, ahd_set_int(job, "plane", AHD_PLANE_BEST_FIT));
  CHECK_OK(job, ahd_set_int(job, "rim", AHD_RIM_CONVEX_HULL));
  CHECK_OK(job, ahd_run(job));
  CHECK_OK(job, ahd_get_array(job, "plane_matrix", AHD_FLOAT64, matrix, 16));
  CHECK(memcmp(matrix, expected, sizeof(matrix)) == 0);
  corners = ahd_read_ids(job, "triangles", &numbers);
  CHECK(numbers >= 9);
  two = ahd_ids(corners, 2, 3);
  CHECK_OK(job, ahd_set_array(job, "surface", &two));
  CHECK_OK(job, ahd_run(job));
  CHECK(ahd_counted(job, "triangles") == 2 && ahd_counted(job, "skipped") >= 2);
  memset(matrix, 0, sizeof(matrix));
  CHECK_OK(job, ahd_get_array(job, "plane_matrix", AHD_FLOAT64, matrix, 16));
  CHECK(memcmp(matrix, expected, sizeof(matrix)) == 0);
  CHECK_OK(job, ahd_set_int(job, "rim", AHD_RIM_AUTOMATIC));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_run(job));
  CHECK_SAYS(job, "AHD_RIM_CONVEX_HULL");
  CHECK_OK(job, ahd_set_array(job, "surface", NULL));
  CHECK_OK(job, ahd_set_int(job, "unfitted_points", INT64_C(1) << 40)); /* to none at all */
  CHECK_OK(job, ahd_run(job));
  free(corners);
  ahd_job_free(all);
  ahd_job_free(job);
}

void test_given_surface(void)
{
  test_same_values();
  test_forms();
  test_cancel();
  test_what_cannot_be();
  test_plane();
}
