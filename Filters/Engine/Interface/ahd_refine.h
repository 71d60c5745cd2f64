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
 * triangles; points skipped or left out must be skipped again. It is the same for any order of the
 * input. Triangles that do not meet the request are named.
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
} ahd_refined;

/* Finds the points; discards those found before. A callback gets the fraction 0 until it ends.
 * AHD_NOT_AVAILABLE, AHD_BAD_VALUE: what of the request is refused, or insertion_limit is set;
 * AHD_MEMORY_LIMIT, AHD_OUT_OF_MEMORY, AHD_CANCELLED, AHD_TOO_MANY_POINTS. */
AHD_API ahd_status ahd_refine(
  ahd_job* job, const ahd_refine_request* request, ahd_refine_report* report);

/* Writes what was found. AHD_NOT_AVAILABLE. */
AHD_API ahd_status ahd_refine_write(ahd_job* job, const ahd_refined* arrays);

#endif
