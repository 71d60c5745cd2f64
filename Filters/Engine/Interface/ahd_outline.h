/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef ahd_outline_h
#define ahd_outline_h

/*
 * The part of the C interface that makes the outline of a surface of polygons, as polygons with
 * holes; without ahd_run(). ahd.h includes it.
 *
 *     ahd_set_array(job, "points", &points);
 *     ahd_set_array(job, "cells", &triangles);
 *     if (ahd_outline(job, NULL) == AHD_OK)
 *       ahd_array_size(job, "outline_points", &corners, &one);
 *     else
 *       puts(ahd_message(job));
 *
 * Input arrays, besides points:
 *   cells            integer  (k) or (c, w)  corners of polygons, in either direction. With several
 *                                            columns each row is a polygon
 *   cell_offsets     integer  (c + 1)        with one column: polygon i has the ids from offset i
 *                                            to offset i + 1, which is not in it; ascending
 *   cell_groups      float64  (c)            polygons of the outline are of cells with equal
 *                                            numbers; NaN: the cell is left out. Without it all
 *                                            are alike
 * Output arrays:
 *   outline_points   id       (k)            ids of points, ring after ring; the first of a ring
 *                                            is not repeated
 *   outline_rings    id       (r + 1)        ring i has the points from offset i to offset i + 1
 *   outline_polygons id       (p + 1)        polygon i has the rings from offset i to offset i + 1
 *   outline_cells    id       (p)            the first cell of each polygon
 *
 * Two cells are joined where they share an edge (by places: points at one place count as that of
 * smallest id), and a polygon is a largest set of joined cells with equal numbers. The first ring
 * of a polygon is the outer one, counterclockwise; the others are its holes, clockwise. Rings are
 * simple, and touch at vertices only: polygons that share no edge stay apart, and a ring that would
 * touch itself is several. A ring begins at its smallest vertex, by x, then y; polygons are in
 * ascending order of their numbers, then of the first corners of their outer rings, and the holes
 * of a polygon likewise. So cells may come in any order and direction. Which ring is outer is
 * exact.
 *
 * All this is in x, y, unless the surface folds over itself there (more than a tenth of its area
 * turns the other way): then in y, z or z, x, whichever the surface is more parallel to. For a
 * surface of another plane give plane_points.
 *
 * Of the settings, memory_limit, other_memory and other_memory_per_point apply. The last one, if
 * not 0, is that of arrays the caller writes for each point of the outline; then 24 bytes a corner
 * and 33 a ring count, too.
 */

#include "ahd.h"

/* What became of it. */
typedef struct ahd_outline_report
{
  uint64_t unfit_cells;   /* left out: with an id of no point, a corner that is not finite, or fewer
                             than three corners at different places */
  uint64_t unfit_edges;   /* that cannot join cells, and are in the outline: of more than two cells
                             with equal numbers, or where a one-sided surface closes */
  uint64_t memory_needed; /* bytes, estimated before it, and requested meanwhile */
  uint64_t memory_allowed; /* bytes, the limit that was compared */
  int32_t plane;           /* 0: y, z; 1: z, x; 2: x, y */
} ahd_outline_report;

/* Makes the outline of the array cells; discards the one before, not the result of a run. A
 * callback gets the fraction of this call. `report`: may be null; written on failure, too.
 * AHD_MEMORY_LIMIT, AHD_OUT_OF_MEMORY, AHD_CANCELLED, AHD_BAD_ARRAY, AHD_TOO_MANY_POINTS: 2^32 - 4
 * points or corners of cells. */
AHD_API ahd_status ahd_outline(ahd_job* job, ahd_outline_report* report);

/* The same of cells that are all counterclockwise in x, y, such as triangles and parts of them.
 * They are joined by the ids of their corners: points at one place are as many. Nothing is turned
 * over, so rounding of places, by which parts of triangles may lose their width, changes no ring.
 */
AHD_API ahd_status ahd_outline_directed(ahd_job* job, ahd_outline_report* report);

/* Which triangles make an alpha shape: for each row of the array cells, which has three columns, 1
 * if the radius of its circumcircle is not greater than `radius`, in space where points have three
 * coordinates, as the setting alpha decides; else 0, also with an id of no point. No result is
 * needed. AHD_BAD_VALUE: `radius` is not greater than 0. AHD_BAD_ARRAY, AHD_CANCELLED,
 * AHD_OUT_OF_MEMORY. */
AHD_API ahd_status ahd_within_radius(ahd_job* job, double radius, uint8_t* kept);

#endif
