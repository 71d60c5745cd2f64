/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef ahd_tiles_h
#define ahd_tiles_h

/*
 * The part of the C interface for more points than memory holds: triangles and rasters of all
 * points, leaf by leaf, with the bytes of one run. ahd.h includes it. The engine opens no file:
 * the caller keeps points and bytes wherever it likes.
 *
 *     int32_t again = 1;
 *     ahd_tiles_begin(job, NULL);
 *     while (again)
 *     {
 *       for each chunk of all points:
 *         ahd_tiles_count(job, &chunk);
 *       ahd_tiles_plan(job, 0, extent, &again);
 *     }
 *     for each chunk of all points:       ahd_tiles_leaf_of(job, &chunk, leaf_of_each);
 *     for each leaf k, ascending:         ahd_tiles_visit(job, k, &points_of_k, NULL);
 *       keep its tiles_border and tiles_own; then, for each node whose parts are all done:
 *                                         ahd_tiles_merge(job, node, borders_of_its_parts, count);
 *       keep its tiles_border and tiles_share; the borders of its parts are of no more use
 *     for each leaf k:                    ahd_tiles_triangles(job, k, ...);  its triangles
 *                                         ahd_tiles_list(job, k, ...);       for its raster
 *
 * *Leaves* are boxes of the grid that ranks points along a Hilbert curve, in the order of the
 * curve. Each has at most so many points as the plan says, except those that cannot be divided: so
 * many at one place, or in one of 2^32 x 2^32 cells. Leaves may have no point. *Nodes* join
 * leaves, or nodes, to larger boxes; the root has all. *Parts* are both: the leaves are the parts 0
 * to leaves - 1, the nodes those from leaves on, each behind the parts that it joins; the last is
 * the root, which is there with one leaf, too. Let leaves be visited in ascending order, and nodes
 * merged as soon as they can be: then few borders are open at a time. Any other order, and several
 * jobs in several threads, processes or on several machines give the same bytes: what a call gives
 * depends on the plan, its arguments and the setting duplicates alone. So each may be repeated, and
 * work that ended anywhere goes on from what was kept.
 *
 * The triangles of all leaves, one leaf after the other, are the array triangles of one run with
 * all points, byte for byte (ids apart, where these are the caller's). Those of leaf k are those
 * whose lowest corner lies in it.
 *
 * Rasters: ahd_tiles_cells() says which cells are whose. For these an ordinary run of the leaf's
 * points, followed by those of its list, gives the bytes of one run with all points: with the
 * input array rank_bounds, and a raster that is a piece of the whole one:
 *
 *   rank_bounds        float64  (2, 2)   input array: xmin, xmax, ymin, ymax. Ranks (the order of
 *                                        triangles and sums) refer to these bounds, grown to hold
 *                                        the points, in place of those of the points alone
 *   sample_first_column  0               setting, int, 0 to 2^52: the place row * columns + column
 *   sample_first_row     0               of a raster lies at origin + (first column + column,
 *                                        first row + row) * spacing
 *
 * Its triangles whose first corner is one of the leaf's points are the leaf's, in their order; so
 * who needs this run anyway can do without ahd_tiles_triangles(). The others may be wrong. Limits
 * on size concern each triangle alone and may be set. Values: those of the list's points are the
 * caller's to find, by their ids. With lines or loops give the run ahd_tiles_surface(), too. For
 * AHD_OUTSIDE_BOUNDARY, for a trimmed rim, and, with lines or loops, for the nearest vertex, no
 * list is enough. (Lines do not change which vertex is nearest: a plan without them has the same.)
 *
 * Of the settings, duplicates (not AHD_DUPLICATES_MEAN_Z) and threads apply to visits; each takes
 * about as much memory as ahd_estimate() says for a run of as many points. Merging takes some 250
 * bytes for each point in the borders: those along borders of leaves and segments, and nearly all
 * that lie on a circle or a line. A callback gets the fraction of each call.
 *
 * The plan belongs to the job, apart from its input and result: ahd_run() and ahd_release() leave
 * it, ahd_reset() discards it. The output arrays of a call below stay until the next of these
 * calls, and are empty when it fails; all have names for ahd_array_size() and ahd_get_array().
 */

#include "ahd.h"

/* Bytes that the caller kept. They are of one version of the library and of one kind of processor.
 * Those that are cut off, changed or of another plan or part are refused: they have fingerprints.
 * They are read in place, and only where they are needed: they may be a file in memory (mmap). */
typedef struct ahd_bytes
{
  const void* data;
  uint64_t size;
} ahd_bytes;

/* --- The plan --------------------------------------------------------------------------------
 *
 * Output arrays:
 *   tiles_plan      uint8    (bytes)          for ahd_tiles_load(), in this or another job
 *   tiles_counts    int64    (leaves)         points of each leaf, duplicates included
 *   tiles_boxes     float64  (leaves, 4)      xmin, xmax, ymin, ymax: each holds the points and
 *                                             the cells of its leaf. No two have a place in common,
 *                                             and no number lies between two that are neighbours
 *   tiles_parents   int64    (leaves + nodes) the node that joins the part; -1 for the root
 *   tiles_bounds    float64  (2, 2)           xmin, xmax, ymin, ymax of all points: for
 *                                             rank_bounds. Without a point empty: xmin > xmax
 */

typedef struct ahd_tiles_facts
{
  uint64_t points;     /* finite ones, duplicates included */
  uint64_t not_finite; /* that have no leaf */
  uint64_t leaves, nodes;
  uint64_t most_points; /* of a leaf */
} ahd_tiles_facts;

/* Begins a plan; discards the one before. `bounds`: a guess of xmin, xmax, ymin, ymax of all
 * points, or null. One that is exact, as those in the headers of files may be, saves one pass over
 * the points; one that is wrong does no harm. AHD_BAD_VALUE: not finite, or xmin > xmax. */
AHD_API ahd_status ahd_tiles_begin(ahd_job* job, const double bounds[4]);

/* Counts more points: (n, 2 or more) real numbers. Those that are not finite are counted apart. In
 * each pass the same points, in any order and in any chunks. Takes some 8 MB in all, more where
 * points crowd. AHD_NOT_AVAILABLE: there is no plan that was begun and is not made. */
AHD_API ahd_status ahd_tiles_count(ahd_job* job, const ahd_array* points);

/* Ends a pass. *again: 1 if another one is needed: after the first the bounds are known, if the
 * guess was not exact; further ones count where more than `most` points lie close together. 0: the
 * plan is made. A function of the points, of `most` and `extent` alone.
 * `most`: points of a leaf; 0: 200,000. `extent`: xmin, xmax, ymin, ymax of the centres of all
 * cells of the rasters that are wanted, or null if none is. Places beyond the points' bounds belong
 * to the leaves along them. AHD_BAD_VALUE: extent is not finite, or xmin > xmax.
 * AHD_TOO_MANY_POINTS: a leaf that cannot be divided has more than 2^28 - 2. AHD_NOT_AVAILABLE. */
AHD_API ahd_status ahd_tiles_plan(
  ahd_job* job, uint64_t most, const double extent[4], int32_t* again);

/* Takes the plan that tiles_plan had; discards the one before. AHD_BAD_ARRAY: it is none. */
AHD_API ahd_status ahd_tiles_load(ahd_job* job, const void* plan, uint64_t size);

/* AHD_NOT_AVAILABLE: there is no plan; the same below. */
AHD_API ahd_status ahd_tiles_get_facts(ahd_job* job, ahd_tiles_facts* facts);

/* The leaf of each point (n, 2 or more); -1: not finite. Each has to be one of those counted:
 * others get the leaf that is nearest on the grid. */
AHD_API ahd_status ahd_tiles_leaf_of(ahd_job* job, const ahd_array* points, int32_t* leaves);

/* The cells of a raster (not `xy`) whose centres belong to the leaf, a rectangle: its first column,
 * first row, columns and rows; no columns and rows if there is none. Each cell of the raster
 * belongs to one leaf. AHD_BAD_VALUE: a cell is not in the plan's extent, or there is no such leaf,
 * as below. */
AHD_API ahd_status ahd_tiles_cells(
  ahd_job* job, uint64_t leaf, const ahd_places* raster, uint64_t piece[4]);

/* Lines and loops, after the plan and before all visits; they become part of tiles_plan. `xy`: the
 * corners of chains, x and y each; chain i has those from offsets[i] to offsets[i + 1], which is
 * not in it. The first `lines` of the `chains` are open, the others loops, which are closed. Each
 * corner has to be the place of a point that was counted; a segment with another one is left out,
 * as are those that cross an earlier one. `fill_rule`: AHD_FILL_.... Replaces those before; no
 * chains: none. AHD_BAD_VALUE, AHD_BAD_ARRAY. */
AHD_API ahd_status ahd_tiles_lines(ahd_job* job, const double* xy, const int64_t* offsets,
  uint64_t lines, uint64_t chains, int32_t fill_rule);

/* --- First visits ----------------------------------------------------------------------------
 *
 * Output arrays:
 *   tiles_border    uint8    (bytes)   for the node that joins the part; of the root 0 bytes
 *   tiles_own       uint8    (bytes)   of a leaf, for its triangles and its surface: 12 bytes for
 *                                      each triangle that is known to be in the result
 *   tiles_share     uint8    (bytes)   of a node, for the leaves that it joins: triangles at their
 *                                      borders, and points for their lists
 *   tiles_constraints  int64  (6)      with lines or loops, of the root, and of each second visit:
 *                                      the counts segments, segments_of_no_length,
 *                                      segments_without_vertex, segments_crossing, unfilled_loops
 *                                      and constraint_edges of one run
 */

/* Visits a leaf. `points`: all of it, (n, 2 or 3) real numbers, the third for the setting
 * duplicates; n as it was counted. `ids`: of each, ascending, of all leaves different; 0 or more.
 * Null: the number of the point in the order of all leaves, so those of leaf k begin at the sum of
 * tiles_counts before it. AHD_BAD_ARRAY: another number of points than was counted, a point that is
 * not in the leaf, ids that do not ascend. AHD_CANCELLED, AHD_OUT_OF_MEMORY, as below. */
AHD_API ahd_status ahd_tiles_visit(
  ahd_job* job, uint64_t leaf, const ahd_array* points, const int64_t* ids);

/* Merges what borders the parts that the node joins, in ascending order of their numbers.
 * AHD_BAD_ARRAY: bytes that are not those; the same below. AHD_MEMORY_LIMIT: it takes more than
 * the setting memory_limit allows. So it may where most leaves need most of each other's points, as
 * on a circle or a line: the shares are points times leaves then, and larger leaves, or one run,
 * take less. */
AHD_API ahd_status ahd_tiles_merge(
  ahd_job* job, uint64_t node, const ahd_bytes* borders, uint64_t count);

/* --- Second visits ---------------------------------------------------------------------------
 *
 * When the root is merged. `shares`: tiles_share of the nodes above the leaf, from the one that
 * joins it to the root.
 *
 * Output arrays:
 *   tiles_triangles    int64    (t, 3)   of the leaf, ids, as ahd_run() has them
 *   tiles_edges        uint8    (t)      bit e is set if edge e is a constraint
 *   tiles_list_points  float64  (k, 2)   points of other leaves, x and y each
 *   tiles_list_ids     int64    (k)
 *   tiles_surface      int64    (s, 3)   triangles: places among the leaf's points, then its list
 *   tiles_surface_edges  uint8  (s)      bit e is set if edge e is a constraint, or ends it
 */

/* Makes tiles_triangles and tiles_edges. `points`, `ids`: as in the visit; `own`: its tiles_own. */
AHD_API ahd_status ahd_tiles_triangles(ahd_job* job, uint64_t leaf, const ahd_array* points,
  const int64_t* ids, const ahd_bytes* own, const ahd_bytes* shares, uint64_t count);

/* Makes tiles_list_...: the points of other leaves that its cells need. Each is a vertex: of
 * several points at one place the one that represents it. */
AHD_API ahd_status ahd_tiles_list(
  ahd_job* job, uint64_t leaf, const ahd_bytes* shares, uint64_t count);

/* With lines or loops: makes tiles_surface..., the triangles that the leaf's cells need, and
 * tiles_list_.... For the run of the leaf's points and its list give them as the input arrays
 * surface and surface_edges; no cell has a value if there is none. (But if all points are on one
 * line, constraints do nothing: leave it out.) The setting maximum_edge_length of this job leaves
 * triangles out; the run itself has no limits on size. */
AHD_API ahd_status ahd_tiles_surface(ahd_job* job, uint64_t leaf, const ahd_array* points,
  const int64_t* ids, const ahd_bytes* own, const ahd_bytes* shares, uint64_t count);

#endif
