/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef ahd_messages_h
#define ahd_messages_h

/*
 * The part of the C interface that says what there is to say of a run: points that were left out,
 * constraints that could not be kept, why there is no triangle. ahd.h includes it.
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

/* Whose names of settings and arrays texts have. */
enum
{
  AHD_WORDS_OF_C = 0,     /* those of ahd.h; memory in bytes */
  AHD_WORDS_OF_CLASS = 1, /* those of the classes for VTK; memory in KiB */
  AHD_WORDS_OF_NUMPY = 2  /* those of the package for NumPy; memory in bytes */
};

enum
{
  AHD_SAY_REFUSAL = 0,       /* why there is no result, by the fact "reason": one message at most */
  AHD_SAY_TRIANGULATION = 1, /* after ahd_run() */
  AHD_SAY_COLUMNS = 2,       /* of arrays to interpolate */
  AHD_SAY_PLACES = 3,        /* after ahd_sample() */
  AHD_SAY_BLOCKS = 4         /* of blocks of VTK's data sets that are passed over */
};

/* What the caller knows and the job does not, or knows better: counts by their names, and those
 * that Job/Catalogue.h asks for besides. A list is several facts of one name. */
typedef struct ahd_fact
{
  const char* name;
  const char* text; /* null: a number */
  int64_t number;
  double real; /* 0: the number */
} ahd_fact;

/* Writes all that there is to say, in its order: of each message its name and its text, each with a
 * 0 at the end; then one more 0. Returns how many bytes that takes, and writes no more than a 0 if
 * `capacity` is less; 0 if it cannot be said: ahd_message() has the reason. `job`: null, or what
 * knows facts that are not given. */
AHD_API uint64_t ahd_say(ahd_job* job, int32_t topic, int32_t words, const ahd_fact* facts,
  uint64_t count, char* out, uint64_t capacity);

#endif
