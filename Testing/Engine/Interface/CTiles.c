/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * ahd_tiles_...(): points leaf by leaf, from a plan to triangles and a raster; arrays, refusals,
 * cancelling.
 */
#include "Check.h"

#include <math.h>
#include <stdlib.h>

enum
{
  kPoints = 3000,
  kMost = 200,
  kSide = 40,
  kFew = 64 /* leaves and nodes at most */
};

/* All points, the leaf of each, and what visits gave. */
typedef struct tiles
{
  ahd_job* job;
  double* xy;
  int32_t leaf_of[kPoints];
  ahd_tiles_facts facts;
  int64_t* parents;
  ahd_bytes borders[kFew], owns[kFew], shares[kFew];
} tiles;

static ahd_array places(const double* xy, int64_t count)
{
  const ahd_array points = { xy, AHD_FLOAT64, 2, count, 2 * sizeof(double), sizeof(double) };
  return points;
}

static ahd_bytes kept(ahd_job* job, const char* name)
{
  ahd_bytes bytes = { NULL, 0 };
  uint64_t rows = 0, columns = 0;
  void* data;
  CHECK_OK(job, ahd_array_size(job, name, &rows, &columns));
  CHECK(columns == 1);
  data = malloc(rows + 1);
  CHECK_OK(job, ahd_get_array(job, name, AHD_UINT8, data, rows));
  bytes.data = data;
  bytes.size = rows;
  return bytes;
}

static void make_plan(tiles* all)
{
  const double extent[] = { -0.25, 1.25, -0.25, 1.25 };
  const ahd_array points = places(all->xy, kPoints);
  int32_t again = 1, passes = 0;
  uint64_t numbers;
  all->job = ahd_job_new();
  CHECK_OK(all->job, ahd_tiles_begin(all->job, NULL));
  for (; again == 1; ++passes)
  {
    CHECK_OK(all->job, ahd_tiles_count(all->job, &points));
    CHECK_OK(all->job, ahd_tiles_plan(all->job, kMost, extent, &again));
  }
  CHECK(again == 0 && passes == 2);
  CHECK_OK(all->job, ahd_tiles_get_facts(all->job, &all->facts));
  CHECK(all->facts.points == kPoints && all->facts.not_finite == 0);
  CHECK(all->facts.most_points <= kMost && all->facts.leaves > 15);
  CHECK(all->facts.leaves + all->facts.nodes < kFew);
  CHECK_OK(all->job, ahd_tiles_leaf_of(all->job, &points, all->leaf_of));
  all->parents = ahd_read_ids(all->job, "tiles_parents", &numbers);
  CHECK(numbers == all->facts.leaves + all->facts.nodes && all->parents[numbers - 1] == -1);
}

/* The points of a leaf, to be freed, and their ids. */
static double* points_of(const tiles* all, uint64_t leaf, int64_t* ids, int64_t* count)
{
  double* xy = malloc(2 * kPoints * sizeof(double));
  int64_t i;
  *count = 0;
  for (i = 0; i < kPoints; ++i)
  {
    if ((uint64_t)all->leaf_of[i] == leaf)
    {
      xy[2 * *count] = all->xy[2 * i];
      xy[2 * *count + 1] = all->xy[2 * i + 1];
      ids[(*count)++] = i;
    }
  }
  return xy;
}

static void free_bytes(tiles* all)
{
  uint64_t part;
  for (part = 0; part < kFew; ++part)
  {
    free((void*)all->borders[part].data);
    free((void*)all->owns[part].data);
    free((void*)all->shares[part].data);
  }
}

static void visit_all(tiles* all)
{
  int64_t ids[kPoints], count;
  uint64_t part, child, numbers, most = 0;
  int64_t* counts = ahd_read_ids(all->job, "tiles_counts", &numbers);
  for (part = 0; part < all->facts.leaves; ++part)
  {
    double* xy = points_of(all, part, ids, &count);
    const ahd_array points = places(xy, count);
    CHECK(counts[part] == count);
    most = (uint64_t)count > most ? (uint64_t)count : most;
    CHECK_OK(all->job, ahd_tiles_visit(all->job, part, &points, ids));
    all->borders[part] = kept(all->job, "tiles_border");
    all->owns[part] = kept(all->job, "tiles_own");
    free(xy);
  }
  CHECK(all->facts.most_points == most);
  for (; part < all->facts.leaves + all->facts.nodes; ++part)
  {
    ahd_bytes below[4];
    uint64_t number = 0;
    for (child = 0; child < part; ++child)
    {
      if (all->parents[child] == (int64_t)part)
      {
        below[number++] = all->borders[child];
      }
    }
    CHECK_OK(all->job, ahd_tiles_merge(all->job, part, below, number));
    all->borders[part] = kept(all->job, "tiles_border");
    all->shares[part] = kept(all->job, "tiles_share");
    CHECK((all->parents[part] == -1) == (all->borders[part].size == 0));
  }
  free(counts);
}

static uint64_t shares_for(const tiles* all, uint64_t leaf, ahd_bytes* shares)
{
  uint64_t count = 0;
  int64_t part = all->parents[leaf];
  for (; part != -1; part = all->parents[part])
  {
    shares[count++] = all->shares[part];
  }
  return count;
}

static ahd_job* run_of(const double* xy, int64_t count)
{
  ahd_job* job = ahd_job_of(xy, count, 2);
  CHECK_OK(job, ahd_set_int(job, "sample_method", AHD_SAMPLE_NATURAL_NEIGHBOR));
  return job;
}

static void expect_triangles(const tiles* all, const int64_t* whole, uint64_t numbers)
{
  int64_t ids[kPoints], count;
  uint64_t leaf, at = 0, some, edges, columns;
  for (leaf = 0; leaf < all->facts.leaves; ++leaf)
  {
    ahd_bytes shares[kFew];
    const uint64_t above = shares_for(all, leaf, shares);
    double* xy = points_of(all, leaf, ids, &count);
    const ahd_array points = places(xy, count);
    int64_t* triangles;
    CHECK_OK(
      all->job, ahd_tiles_triangles(all->job, leaf, &points, ids, &all->owns[leaf], shares, above));
    triangles = ahd_read_ids(all->job, "tiles_triangles", &some);
    CHECK_OK(all->job, ahd_array_size(all->job, "tiles_edges", &edges, &columns));
    CHECK(3 * edges == some && at + some <= numbers);
    CHECK(at + some <= numbers && memcmp(triangles, whole + at, some * sizeof(int64_t)) == 0);
    at += some;
    free(triangles);
    free(xy);
  }
  CHECK(at == numbers);
}

/* The cells of one leaf in the raster of all. */
static void sample_leaf(const tiles* all, uint64_t leaf, const ahd_places* raster, double* values)
{
  ahd_bytes shares[kFew];
  int64_t ids[kPoints], count, i;
  uint64_t piece[4], listed, some, k;
  double *xy = points_of(all, leaf, ids, &count), *bounds, *more, *z, *out;
  int64_t* list;
  ahd_places cells = *raster;
  ahd_array whole;
  ahd_job* job;
  CHECK_OK(all->job, ahd_tiles_list(all->job, leaf, shares, shares_for(all, leaf, shares)));
  more = ahd_read_doubles(all->job, "tiles_list_points", &some);
  list = ahd_read_ids(all->job, "tiles_list_ids", &listed);
  CHECK(some == 2 * listed && count + (int64_t)listed <= kPoints);
  memcpy(xy + 2 * count, more, some * sizeof(double));
  memcpy(ids + count, list, listed * sizeof(int64_t));
  CHECK_OK(all->job, ahd_tiles_cells(all->job, leaf, raster, piece));
  cells.columns = piece[2];
  cells.rows = piece[3];
  job = run_of(xy, count + (int64_t)listed);
  bounds = ahd_read_doubles(all->job, "tiles_bounds", &some);
  whole = places(bounds, 2);
  CHECK_OK(job, ahd_set_array(job, "rank_bounds", &whole));
  CHECK_OK(job, ahd_set_int(job, "sample_first_column", (int64_t)piece[0]));
  CHECK_OK(job, ahd_set_int(job, "sample_first_row", (int64_t)piece[1]));
  CHECK_OK(job, ahd_run(job));
  z = malloc((size_t)(count + (int64_t)listed + 1) * sizeof(double));
  out = malloc((kSide * kSide + 1) * sizeof(double));
  for (i = 0; i < count + (int64_t)listed; ++i)
  {
    z[i] = sin((double)ids[i]);
  }
  {
    const ahd_sampled array = { z, 1, out, NULL };
    CHECK_OK(job, ahd_sample(job, &cells, &array, 1, NULL));
  }
  for (k = 0; k < piece[2] * piece[3]; ++k)
  {
    values[(piece[1] + k / piece[2]) * raster->columns + piece[0] + k % piece[2]] = out[k];
  }
  ahd_job_free(job);
  free(out);
  free(z);
  free(bounds);
  free(list);
  free(more);
  free(xy);
}

static void expect_raster(const tiles* all, ahd_job* whole)
{
  const ahd_places raster = { NULL, 0, { -0.1, 1.1 }, { 0.03, -0.03 }, kSide, kSide };
  double z[kPoints], values[kSide * kSide], expected[kSide * kSide];
  const ahd_sampled array = { z, 1, expected, NULL };
  uint64_t leaf;
  int64_t i;
  for (i = 0; i < kPoints; ++i)
  {
    z[i] = sin((double)i);
  }
  CHECK_OK(whole, ahd_sample(whole, &raster, &array, 1, NULL));
  memset(values, 0, sizeof values);
  for (leaf = 0; leaf < all->facts.leaves; ++leaf)
  {
    sample_leaf(all, leaf, &raster, values);
  }
  CHECK(memcmp(values, expected, sizeof values) == 0);
}

static void expect_refusals(tiles* all)
{
  int64_t ids[kPoints], count;
  double* xy = points_of(all, 3, ids, &count);
  const ahd_array points = places(xy, count), fewer = places(xy, count - 1);
  const ahd_places raster = { NULL, 0, { -1, 1.1 }, { 0.03, -0.03 }, kSide, kSide };
  ahd_bytes shares[kFew], none = { NULL, 0 };
  const uint64_t above = shares_for(all, 3, shares);
  uint64_t piece[4];
  ahd_job* job = all->job;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_tiles_visit(job, 3, &fewer, ids));
  CHECK_SAYS(job, "than were counted");
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_tiles_visit(job, all->facts.leaves, &points, ids));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_tiles_merge(job, 3, &all->borders[0], 1));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_tiles_merge(job, all->facts.leaves, &all->borders[0], 1));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_tiles_list(job, 3, shares, above - 1));
  CHECK_NULL(job, "bytes", ahd_tiles_list(job, 3, NULL, 1));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_tiles_list(job, 3, NULL, 0));
  CHECK_SAYS(job, "what visits of the leaf and the nodes above it gave");
  CHECK_STATUS(
    job, AHD_BAD_ARRAY, ahd_tiles_triangles(job, 3, &points, ids, &all->owns[2], shares, above));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_tiles_triangles(job, 3, &points, ids, &none, shares, above));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_tiles_cells(job, 3, &raster, piece));
  CHECK_SAYS(job, "extent");
  CHECK_NULL(job, "raster", ahd_tiles_cells(job, 3, NULL, piece));
  CHECK_NULL(job, "piece", ahd_tiles_cells(job, 3, &raster, NULL));
  CHECK_NULL(job, "points", ahd_tiles_visit(job, 3, NULL, ids));
  CHECK_NULL(job, "points", ahd_tiles_count(job, NULL));
  CHECK_NULL(job, "points", ahd_tiles_leaf_of(job, NULL, all->leaf_of));
  CHECK_NULL(job, "leaves", ahd_tiles_leaf_of(job, &points, NULL));
  ids[1] = ids[0];
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_tiles_visit(job, 3, &points, ids));
  CHECK_SAYS(job, "ascend");
  xy[0] = 2.0;
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_tiles_visit(job, 3, &points, NULL));
  CHECK_SAYS(job, "not in the leaf");
  CHECK_OK(job, ahd_set_int(job, "duplicates", AHD_DUPLICATES_MEAN_Z));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_tiles_visit(job, 3, &points, NULL));
  CHECK_OK(job, ahd_set_int(job, "duplicates", AHD_DUPLICATES_FIRST));
  free(xy);
}

/* Counts that no memory has, as a caller's -1: nothing is read. */
static void test_absurd_counts(void)
{
  const double corner[] = { 0, 0 };
  const int64_t offsets[] = { 0, ((int64_t)1 << 48) + 1 };
  const ahd_bytes none = { NULL, 0 };
  ahd_job* job = ahd_job_new();
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_tiles_merge(job, 1, &none, UINT64_MAX));
  CHECK_SAYS(job, "bytes do not fit in any memory");
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_tiles_lines(job, corner, offsets, 1, UINT64_MAX, 0));
  CHECK_SAYS(job, "chains do not fit in any memory");
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_tiles_lines(job, corner, offsets, 1, 1, 0));
  CHECK_SAYS(job, "corners do not fit in any memory");
  ahd_job_free(job);
}

static void expect_plans(tiles* all)
{
  ahd_bytes plan = kept(all->job, "tiles_plan");
  const double turned[] = { 1, 0, 0, 1 };
  const ahd_array points = places(all->xy, kPoints), fewer = places(all->xy, kPoints - 1);
  int32_t again = 1;
  uint8_t byte = 0;
  ahd_tiles_facts facts;
  ahd_job* job = ahd_job_new();
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_tiles_get_facts(job, &facts));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_get_array(job, "tiles_own", AHD_UINT8, &byte, 1));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_tiles_count(job, &points));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_tiles_plan(job, 0, NULL, &again));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_tiles_load(job, plan.data, plan.size - 1));
  CHECK_OK(job, ahd_tiles_load(job, plan.data, plan.size));
  CHECK_OK(job, ahd_tiles_get_facts(job, &facts));
  CHECK(memcmp(&facts, &all->facts, sizeof facts) == 0);
  CHECK_OK(job, ahd_release(job, 0));
  CHECK_OK(job, ahd_tiles_get_facts(job, &facts));
  CHECK_STATUS(job, AHD_BAD_VALUE, ahd_tiles_begin(job, turned));
  CHECK_OK(job, ahd_tiles_begin(job, NULL));
  CHECK_OK(job, ahd_tiles_count(job, &points));
  CHECK_OK(job, ahd_tiles_plan(job, 0, NULL, &again));
  CHECK_OK(job, ahd_tiles_count(job, &fewer));
  CHECK_STATUS(job, AHD_BAD_ARRAY, ahd_tiles_plan(job, 0, NULL, &again));
  CHECK_SAYS(job, "other points");
  CHECK_OK(job, ahd_reset(job, 0));
  CHECK_STATUS(job, AHD_NOT_AVAILABLE, ahd_tiles_get_facts(job, &facts));
  free((void*)plan.data);
  ahd_job_free(job);
}

/* What became of lines and loops is what one run says. */
static void expect_constraints(const tiles* all, ahd_job* whole)
{
  const char* const names[] = { "segments", "segments_of_no_length", "segments_without_vertex",
    "segments_crossing", "unfilled_loops", "constraint_edges" };
  uint64_t numbers, k;
  int64_t* counts = ahd_read_ids(all->job, "tiles_constraints", &numbers);
  CHECK(numbers == 6);
  for (k = 0; k < numbers; ++k)
  {
    CHECK(counts[k] == ahd_counted(whole, names[k]));
  }
  free(counts);
}

/* Borders of so many points do not fit into 1000 bytes. */
static void expect_memory_limit(tiles* all)
{
  ahd_bytes below[4];
  uint64_t child, number = 0, root = all->facts.leaves + all->facts.nodes - 1;
  for (child = 0; child < root; ++child)
  {
    if (all->parents[child] == (int64_t)root)
    {
      below[number++] = all->borders[child];
    }
  }
  CHECK_OK(all->job, ahd_set_int(all->job, "memory_limit", 1000));
  CHECK_STATUS(all->job, AHD_MEMORY_LIMIT, ahd_tiles_merge(all->job, root, below, number));
  CHECK_SAYS(all->job, "Merging borders");
  CHECK_OK(all->job, ahd_set_int(all->job, "memory_limit", 0));
  CHECK_OK(all->job, ahd_tiles_merge(all->job, root, below, number));
}

/* No chains take those before away: the plan is as it was without. */
static void expect_no_lines(tiles* all, const double* corners, const int64_t* offsets)
{
  ahd_bytes plans[3];
  int k;
  plans[0] = kept(all->job, "tiles_plan");
  CHECK_OK(all->job, ahd_tiles_lines(all->job, corners, offsets, 1, 2, AHD_FILL_EVEN_ODD));
  plans[1] = kept(all->job, "tiles_plan");
  CHECK_OK(all->job, ahd_tiles_lines(all->job, NULL, NULL, 0, 0, AHD_FILL_ORIENTATION));
  plans[2] = kept(all->job, "tiles_plan");
  CHECK(plans[1].size > plans[0].size && plans[2].size == plans[0].size);
  CHECK(memcmp(plans[2].data, plans[0].data, plans[0].size) == 0);
  for (k = 0; k < 3; ++k)
  {
    free((void*)plans[k].data);
  }
}

/* A line and a loop, of places of points: triangles, and the surface of each leaf. */
static void expect_lines(tiles* all)
{
  const double* p = all->xy;
  const double corners[] = { p[0], p[1], p[2], p[3], p[40], p[41], p[60], p[61], p[80], p[81] };
  const int64_t offsets[] = { 0, 2, 5 }, bad[] = { 0, 3, 2 };
  const int64_t line[] = { 0, 1 }, loop[] = { 20, 30, 40 };
  const ahd_array lines = ahd_ids(line, 1, 2), loops = ahd_ids(loop, 1, 3);
  uint64_t numbers, leaf, some, edges, part;
  int64_t *whole, ids[kPoints], count;
  ahd_job* job = run_of(all->xy, kPoints);
  expect_no_lines(all, corners, offsets);
  CHECK_STATUS(
    all->job, AHD_BAD_ARRAY, ahd_tiles_lines(all->job, corners, bad, 1, 2, AHD_FILL_ORIENTATION));
  CHECK_STATUS(
    all->job, AHD_BAD_ARRAY, ahd_tiles_lines(all->job, NULL, offsets, 1, 2, AHD_FILL_ORIENTATION));
  CHECK_STATUS(all->job, AHD_BAD_VALUE,
    ahd_tiles_lines(all->job, corners, offsets, 3, 2, AHD_FILL_ORIENTATION));
  CHECK_OK(all->job, ahd_tiles_lines(all->job, corners, offsets, 1, 2, AHD_FILL_EVEN_ODD));
  free_bytes(all);
  visit_all(all);
  CHECK_OK(job, ahd_set_array(job, "line_ids", &lines));
  CHECK_OK(job, ahd_set_array(job, "loop_ids", &loops));
  CHECK_OK(job, ahd_set_int(job, "fill_rule", AHD_FILL_EVEN_ODD));
  CHECK_OK(job, ahd_run(job));
  expect_constraints(all, job);
  expect_memory_limit(all);
  whole = ahd_read_ids(job, "triangles", &numbers);
  CHECK(numbers > 0 && ahd_counted(job, "kept_triangles") < ahd_counted(job, "delaunay_triangles"));
  expect_triangles(all, whole, numbers);
  for (leaf = 0, part = 0; leaf < all->facts.leaves; ++leaf)
  {
    ahd_bytes shares[kFew];
    const uint64_t above = shares_for(all, leaf, shares);
    double* xy = points_of(all, leaf, ids, &count);
    const ahd_array points = places(xy, count);
    uint64_t columns;
    CHECK_OK(
      all->job, ahd_tiles_surface(all->job, leaf, &points, ids, &all->owns[leaf], shares, above));
    free(ahd_read_ids(all->job, "tiles_surface", &some));
    expect_constraints(all, job);
    CHECK_OK(all->job, ahd_array_size(all->job, "tiles_surface_edges", &edges, &columns));
    CHECK(3 * edges == some);
    part += some;
    free(xy);
  }
  CHECK(part >= numbers);
  free(whole);
  ahd_job_free(job);
}

static int32_t cancel(void* user, int32_t phase, double fraction)
{
  (void)user;
  (void)phase;
  (void)fraction;
  return 1;
}

static void expect_cancelling(tiles* all)
{
  int64_t ids[kPoints], count;
  double* xy = points_of(all, 0, ids, &count);
  const ahd_array points = places(xy, count);
  ahd_bytes again;
  CHECK_OK(all->job, ahd_set_progress(all->job, cancel, NULL));
  CHECK_STATUS(all->job, AHD_CANCELLED, ahd_tiles_visit(all->job, 0, &points, ids));
  again = kept(all->job, "tiles_border");
  CHECK(again.size == 0);
  free((void*)again.data);
  CHECK_OK(all->job, ahd_set_progress(all->job, NULL, NULL));
  CHECK_OK(all->job, ahd_tiles_visit(all->job, 0, &points, ids));
  again = kept(all->job, "tiles_border");
  CHECK(again.size == all->borders[0].size &&
    memcmp(again.data, all->borders[0].data, again.size) == 0);
  free((void*)again.data);
  free(xy);
}

void test_tiles(void)
{
  tiles all;
  uint64_t numbers;
  int64_t* whole;
  ahd_job* job;
  test_absurd_counts();
  memset(&all, 0, sizeof all);
  all.xy = ahd_scattered(kPoints);
  job = run_of(all.xy, kPoints);
  make_plan(&all);
  visit_all(&all);
  CHECK_OK(job, ahd_run(job));
  whole = ahd_read_ids(job, "triangles", &numbers);
  expect_triangles(&all, whole, numbers);
  expect_raster(&all, job);
  expect_plans(&all);
  expect_cancelling(&all);
  expect_refusals(&all);
  expect_lines(&all);
  free_bytes(&all);
  free(whole);
  free(all.parents);
  free(all.xy);
  ahd_job_free(job);
  ahd_job_free(all.job);
}
