/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef ahd_edit_h
#define ahd_edit_h

/*
 * The part of the C interface for points that come, go and move; without ahd_run(). ahd.h includes
 * it.
 *
 *     int64_t first, ends[2] = { 0, 1 };
 *     uint8_t outcome;
 *     ahd_edit_insert(job, xy, count, &first);
 *     ahd_edit_constrain(job, ends, 1, &outcome);
 *     ahd_edit_size(job, &points, &segments);
 *     ahd_edit_write(job, ids, left, pairs);
 *
 * After any history, a run of what ahd_edit_write() writes, with `pairs` as the array line_ids of
 * two columns, gives what a run of the points and segments that are left gives, byte for byte: the
 * triangles are known all the time, decide which segments are accepted, and are not put out.
 *
 * The id of a point is the number of points that came before it; ids are not used again. A point at
 * the place of others is a duplicate of that of smallest id; when that goes, the next takes its
 * place. One with a coordinate that is not finite has no vertex. A segment through vertices is a
 * row of edges. Segments have no direction; one that is there is accepted and changes nothing.
 *
 * Each function takes many requests at once, in order, and reports each. Where a call fails, the
 * requests done before stay done, but ahd_edit_insert() does all or nothing. The points belong to
 * the job, apart from its input and result: ahd_run() and ahd_release() leave them, ahd_reset()
 * discards them. A callback gets the fraction of each call.
 *
 * Of the settings, memory_limit, other_memory and threads apply.
 */

#include "ahd.h"

/* What became of a request. */
enum
{
  AHD_EDIT_DONE = 0,           /* or accepted; all below refuse the request */
  AHD_EDIT_NOT_TRIED = 1,      /* the call ended before */
  AHD_EDIT_NO_POINT = 2,       /* no point has the id, or has it any more */
  AHD_EDIT_END_OF_SEGMENT = 3, /* the point stays as long as the segment that ends at it */
  AHD_EDIT_SEGMENTS_MEET = 4,  /* two segments pass the vertex, which would cross without it */
  AHD_EDIT_NOT_FINITE = 5,     /* an end of the segment has a coordinate that is not finite */
  AHD_EDIT_NO_LENGTH = 6,      /* both ends of the segment are at one place */
  AHD_EDIT_CROSSES = 7,        /* the segment crosses an accepted one */
  AHD_EDIT_NO_SEGMENT = 8      /* there is no such segment */
};

/* Inserts points: x and y of each. *first: the id of the first; the others follow.
 * AHD_MEMORY_LIMIT, AHD_OUT_OF_MEMORY, AHD_CANCELLED, AHD_TOO_MANY_POINTS: 2^28 - 2 in all, those
 * included that are gone. AHD_BAD_ARRAY for null pointers, as below. */
AHD_API ahd_status ahd_edit_insert(ahd_job* job, const double* xy, uint64_t count, int64_t* first);

/* `outcomes`: one of AHD_EDIT_... for each request. AHD_OK though some were refused;
 * AHD_OUT_OF_MEMORY, AHD_CANCELLED. */
AHD_API ahd_status ahd_edit_remove(
  ahd_job* job, const int64_t* ids, uint64_t count, uint8_t* outcomes);
AHD_API ahd_status ahd_edit_move(
  ahd_job* job, const int64_t* ids, const double* xy, uint64_t count, uint8_t* outcomes);

/* Segments between points: two ids each. The same. */
AHD_API ahd_status ahd_edit_constrain(
  ahd_job* job, const int64_t* ends, uint64_t count, uint8_t* outcomes);
AHD_API ahd_status ahd_edit_release(
  ahd_job* job, const int64_t* ends, uint64_t count, uint8_t* outcomes);

/* Where places lie. kinds: AHD_IN_TRIANGLE, ... for each. ids: three for each: the corners of the
 * triangle counterclockwise from the smallest id, the ends of the edge, the smaller first, or the
 * point; else -1. AHD_OUT_OF_MEMORY, AHD_CANCELLED. */
AHD_API ahd_status ahd_edit_locate(
  ahd_job* job, const double* xy, uint64_t count, int32_t* kinds, int64_t* ids);

/* How many there are. */
AHD_API ahd_status ahd_edit_size(ahd_job* job, uint64_t* points, uint64_t* segments);
/* *ready: 1 if there are triangles, so that few requests take little time; 0 if the next call may
 * take a pass over all points: there are none, or the last call failed. */
AHD_API ahd_status ahd_edit_ready(ahd_job* job, int32_t* ready);
/* Writes the ids of the points, ascending, their x and y, and for each segment the positions of its
 * ends among them, in ascending order. */
AHD_API ahd_status ahd_edit_write(ahd_job* job, int64_t* ids, double* xy, int64_t* pairs);

#endif
