/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef ahd_messages_h
#define ahd_messages_h

/*
 * The messages of the C interface about a run: points that were rejected, constraints that were
 * left out, the reason why there is no triangle. ahd.h includes it.
 *
 *     char said[4096];
 *     ahd_say(job, AHD_SAY_TRIANGULATION, AHD_WORDS_OF_C, NULL, 0, said, sizeof said);
 *     for (const char* each = said; *each; each += strlen(each) + 1)
 *     {
 *       printf("(%s) ", each);           the name of the message, which stays
 *       each += strlen(each) + 1;
 *       puts(each);                      its text, which may change
 *     }
 */

#include "ahd.h"

/* The names of settings and arrays in the texts. */
enum
{
  AHD_WORDS_OF_C = 0,     /* names of ahd.h; memory in bytes */
  AHD_WORDS_OF_CLASS = 1, /* names of the classes for VTK; memory in KiB */
  AHD_WORDS_OF_NUMPY = 2  /* names of the package for NumPy; memory in bytes */
};

enum
{
  AHD_SAY_REFUSAL = 0, /* the reason of no result, by the fact "reason": at most one message */
  AHD_SAY_TRIANGULATION = 1, /* after ahd_run() */
  AHD_SAY_COLUMNS = 2,       /* about arrays to interpolate */
  AHD_SAY_PLACES = 3,        /* after ahd_sample() */
  AHD_SAY_BLOCKS = 4,        /* about blocks of VTK's data sets that are ignored */
  AHD_SAY_OUTLINE = 5        /* after ahd_outline() */
};

/* Facts that the job does not know, or that replace its own: counts by their names, and others
 * named in Job/Catalogue.h. A list is several facts of one name. */
typedef struct ahd_fact
{
  const char* name;
  const char* text; /* null: a number */
  int64_t number;
  double real; /* 0: the number */
} ahd_fact;

/* Writes all messages in their order: the name and the text of each, each with a 0 at the end; then
 * one more 0. Returns the number of bytes, and writes only a 0 if `capacity` is less. On an error
 * returns 0; ahd_message() then has it. `job`: null, or the source of facts that are not given. */
AHD_API uint64_t ahd_say(ahd_job* job, int32_t topic, int32_t words, const ahd_fact* facts,
  uint64_t count, char* out, uint64_t capacity);

#endif
