/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef ahd_refine_h
#define ahd_refine_h

/*
 * The part of the C interface that finds points with which triangles have wide angles and wished
 * sizes, after ahd_run(). ahd.h includes it.
 *
 *     ahd_refine_request wished = { 30.0, 0.0, 0.0, NULL, AHD_REFINE_ALL };
 *     ahd_refine_report report;
 *     if (ahd_refine(job, &wished, &report) == AHD_OK)
 *       ahd_refine_write(job, &arrays);   // of the sizes in the report
 *     else
 *       puts(ahd_message(job));
 *
 * What loops keep of the triangles is refined. Segments are the constraint edges and the edges
 * where that ends: split crossings before. A run of the points and the added ones, with the chains
 * written as arrays line_ids and loop_ids and fill_rule AHD_FILL_EVEN_ODD, gives the refined
 * triangles; points skipped or left out must be skipped again, and all if no triangle is kept, as
 * there are no chains then. It is the same for any order of the input. Triangles that do not meet
 * the request are named.
 *
 * Of the settings, memory_limit and other_memory apply.
 */

#include "ahd.h"

#define AHD_REFINE_ALL UINT64_MAX /* most_points: as many as it takes */

/* Why a triangle does not meet the request. */
enum
{
  AHD_REFINE_INPUT_ANGLE = 0, /* it lies in an angle below 60 degrees between two segments */
  AHD_REFINE_BUDGET = 1,      /* most_points was reached */
  AHD_REFINE_RESOLUTION = 2   /* an edge is shorter than 1024 units in the last place */
};

/* What triangles must be like; 0: anything. */
typedef struct ahd_refine_request
{
  double minimum_angle; /* in degrees, up to 34; by theorem it ends up to 20.7 */
  double maximum_area;
  double maximum_length; /* of edges */
  const double* sizes;   /* null, or for each output point the longest edge wished there */
  uint64_t most_points;  /* to add */
} ahd_refine_request;

typedef struct ahd_refine_report
{
  uint64_t points;             /* added */
  uint64_t on_segments;        /* of these */
  uint64_t triangles;          /* refined, and all others that are kept */
  uint64_t ids, chains, lines; /* of the pieces: the first `lines` chains are lines, others loops */
  uint64_t bad;                /* triangles that do not meet the request */
  uint64_t encroached_pieces;  /* pieces of segments that could not be split */
  uint64_t pieces;             /* of segments, that are edges of the triangles, */
  uint64_t inner_pieces;       /* of these, with triangles on both sides: they come first */
  uint64_t memory_needed;      /* bytes, estimated before it, and requested meanwhile */
  uint64_t memory_allowed;     /* bytes, the limit that was compared */
} ahd_refine_report;

/* Where to write; null: not. Point k that is added has the id n + k after n output points. */
typedef struct ahd_refined
{
  double* places;   /* x and y of each added point */
  int64_t* corners; /* three ids each: the output points whose data, */
  double* weights;  /* times these, sum to those of the point. On a segment the third id is -1 */
  int64_t* ids;     /* of chains */
  int64_t* offsets; /* chains + 1 */
  int64_t* bad;     /* three ids of each bad triangle, */
  int32_t* reasons; /* and AHD_REFINE_... */
  /* Of each piece; those that bound the triangles have them on the left: */
  int64_t* pieces;      /* two ids, */
  int64_t* piece_edges; /* those at the ends of the edge before that it lies on, */
  int64_t* piece_cells; /* and the first cell of the source along it, as in crossing_cells; -1 */
} ahd_refined;

/* The triangles of a run with the added points, as above. */
typedef struct ahd_refined_triangles
{
  const int32_t* corners; /* three ids each */
  uint64_t count;
  int64_t* regions;   /* null, or those of that run: they become those of this job */
  int64_t* bad;       /* null, or where to write the numbers of the bad triangles */
  double least_angle; /* written: in degrees, to rounding */
} ahd_refined_triangles;

/* Finds the points; discards those found before. A callback gets the fraction 0 until it ends.
 * The report has what is known where it fails, too.
 * AHD_NOT_AVAILABLE, AHD_BAD_VALUE: what of the request is refused, or insertion_limit is set;
 * AHD_MEMORY_LIMIT, AHD_OUT_OF_MEMORY, AHD_CANCELLED, AHD_TOO_MANY_POINTS. */
AHD_API ahd_status ahd_refine(
  ahd_job* job, const ahd_refine_request* request, ahd_refine_report* report);

/* Writes what was found. AHD_NOT_AVAILABLE. */
AHD_API ahd_status ahd_refine_write(ahd_job* job, const ahd_refined* arrays);

/* Describes these triangles. AHD_NOT_AVAILABLE; AHD_BAD_ARRAY: a number that there is not;
 * AHD_OUT_OF_MEMORY, AHD_CANCELLED. */
AHD_API ahd_status ahd_refine_triangles(ahd_job* job, ahd_refined_triangles* triangles);

#endif
