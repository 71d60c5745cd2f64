/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef ahd_Check_h
#define ahd_Check_h

/*
 * Minimal checks for tests in C: CHECK(condition) prints what failed and where, and continues.
 */

#include "ahd.h"

#include <stdio.h>
#include <string.h>

extern int ahd_failures;

#define CHECK(condition)                                                                           \
  do                                                                                               \
  {                                                                                                \
    if (!(condition))                                                                              \
    {                                                                                              \
      fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);                              \
      ++ahd_failures;                                                                              \
    }                                                                                              \
  } while (0)

/* The call returns this status, and sets a message if and only if it failed. */
#define CHECK_STATUS(job, expected, call)                                                          \
  do                                                                                               \
  {                                                                                                \
    const ahd_status found = (call);                                                               \
    if (found != (expected) || ((found == AHD_OK) != (ahd_message(job)[0] == '\0')))               \
    {                                                                                              \
      fprintf(stderr, "%s:%d: %s: %s \"%s\", not %s\n", __FILE__, __LINE__, #call,                 \
        ahd_status_name(found), ahd_message(job), ahd_status_name(expected));                      \
      ++ahd_failures;                                                                              \
    }                                                                                              \
  } while (0)

#define CHECK_OK(job, call) CHECK_STATUS(job, AHD_OK, call)

/* The call is refused, as this pointer is null. */
#define CHECK_NULL(job, what, call)                                                                \
  do                                                                                               \
  {                                                                                                \
    CHECK_STATUS(job, AHD_BAD_ARRAY, call);                                                        \
    CHECK(strcmp(ahd_message(job), "The pointer to the " what " is null.") == 0);                  \
  } while (0)

/* The message contains this. */
#define CHECK_SAYS(job, text)                                                                      \
  do                                                                                               \
  {                                                                                                \
    if (!strstr(ahd_message(job), text))                                                           \
    {                                                                                              \
      fprintf(                                                                                     \
        stderr, "%s:%d: \"%s\" is not in \"%s\"\n", __FILE__, __LINE__, text, ahd_message(job));   \
      ++ahd_failures;                                                                              \
    }                                                                                              \
  } while (0)

/* A job with these points: `count` times x and y, or x, y and z. */
ahd_job* ahd_job_of(const double* numbers, int64_t count, int32_t columns);

/* A list of 64-bit ids as an array of so many columns. */
ahd_array ahd_ids(const int64_t* ids, int64_t rows, int32_t columns);

/* A count; -7 if it is not available. */
int64_t ahd_counted(ahd_job* job, const char* name);

/* An array of ids as 64-bit numbers, of doubles, of bytes: all of it, to be freed. Its length goes
 * to *numbers. */
int64_t* ahd_read_ids(ahd_job* job, const char* name, uint64_t* numbers);
double* ahd_read_doubles(ahd_job* job, const char* name, uint64_t* numbers);

/* `count` points in the unit square, x and y, the same each time; to be freed. */
double* ahd_scattered(int64_t count);

void test_names(void);
void test_settings(void);
void test_input(void);
void test_results(void);
void test_sample(void);
void test_given_surface(void);
void test_outline(void);
void test_edit(void);
void test_refine(void);
void test_messages(void);
void test_trouble(void);
void test_unchanged(void);
void test_at_once(void);
void test_simplify(void);
void test_tiles(void);

#endif
