/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * ahd_say(): with a job, with the caller's facts, with and without room.
 * Testing/Package/Arrays/Messages.json has the texts for all facts.
 */
#include "Check.h"

#include <math.h>

static char said[4096];

/* The number of bytes for these facts in a buffer of this size, filled with marks before. */
static uint64_t say(
  ahd_job* job, int32_t words, const ahd_fact* facts, uint64_t count, uint64_t room)
{
  memset(said, '?', sizeof said);
  return ahd_say(job, AHD_SAY_TRIANGULATION, words, facts, count, said, room);
}

/* The text of the message of this name; empty if there is none. */
static const char* text_of(const char* name)
{
  const char* each = said;
  while (*each)
  {
    const char* const text = each + strlen(each) + 1;
    if (strcmp(each, name) == 0)
    {
      return text;
    }
    each = text + strlen(text) + 1;
  }
  return each;
}

static void test_room(void)
{
  const ahd_fact odd[] = { { "odd_z", NULL, 2, 0.0 }, { "points", NULL, 3, 0.0 } };
  const uint64_t needed = say(NULL, AHD_WORDS_OF_C, odd, 2, sizeof said);
  CHECK(strcmp(said, "odd z") == 0 && text_of("odd z") == said + 6);
  CHECK(strncmp(said + 6, "2 of 3 points have a z ", 23) == 0);
  CHECK(needed == 6 + strlen(said + 6) + 2 && said[needed - 1] == '\0' && said[needed] == '?');
  CHECK(say(NULL, AHD_WORDS_OF_C, odd, 2, needed) == needed && said[0] == 'o');
  CHECK(say(NULL, AHD_WORDS_OF_C, odd, 2, needed - 1) == needed);
  CHECK(said[0] == '\0' && said[1] == '?');
  CHECK(say(NULL, AHD_WORDS_OF_C, odd, 2, 0) == needed && said[0] == '?');
  CHECK(ahd_say(NULL, AHD_SAY_TRIANGULATION, AHD_WORDS_OF_C, odd, 2, NULL, 0) == needed);
  CHECK(say(NULL, AHD_WORDS_OF_C, NULL, 0, sizeof said) == 1 && said[0] == '\0');
}

static void test_wrong_calls(void)
{
  const ahd_fact none = { NULL, NULL, 1, 0.0 };
  const ahd_fact twice[] = { { "odd_z", NULL, 1, 0.0 }, { "points", NULL, 2, 0.0 },
    { "points", NULL, 3, 0.0 } };
  CHECK(say(NULL, AHD_WORDS_OF_C, &none, 1, sizeof said) == 0 && said[0] == '?');
  CHECK(say(NULL, AHD_WORDS_OF_C, NULL, 1, sizeof said) == 0);
  CHECK(say(NULL, -1, NULL, 0, sizeof said) == 0);
  CHECK(say(NULL, AHD_WORDS_OF_NUMPY + 1, NULL, 0, sizeof said) == 0);
  CHECK(ahd_say(NULL, 99, AHD_WORDS_OF_C, NULL, 0, said, sizeof said) == 1);
  CHECK(say(NULL, AHD_WORDS_OF_C, twice, 3, sizeof said) > 1);
  CHECK(strncmp(text_of("odd z"), "1 of 2, 3 points have a z ", 26) == 0);
}

/* A count that no memory has, as a caller's -1: no fact is read. */
static void test_absurd_counts(void)
{
  const ahd_fact odd = { "odd_z", NULL, 1, 0.0 };
  ahd_job* job = ahd_job_new();
  CHECK(say(job, AHD_WORDS_OF_C, &odd, UINT64_MAX, sizeof said) == 0 && said[0] == '?');
  CHECK_SAYS(job, "facts do not fit in any memory");
  ahd_job_free(job);
}

static void test_job(void)
{
  const double xyz[] = { 0, 0, 0, 1, 0, 0, NAN, 1, 0, 0, 1, 0, 2, 2, 0 };
  const int64_t lines[] = { 0, 4, 1, 3 };
  const ahd_fact first = { "first_not_finite", NULL, 9, 0.0 };
  ahd_job* job = ahd_job_of(xyz, 5, 3);
  ahd_array ids = ahd_ids(lines, 2, 2);
  CHECK(say(job, AHD_WORDS_OF_C, NULL, 0, sizeof said) == 1);
  CHECK_OK(job, ahd_set_array(job, "line_ids", &ids));
  CHECK_OK(job, ahd_run(job));
  CHECK(say(job, AHD_WORDS_OF_C, NULL, 0, sizeof said) > 100);
  CHECK(strcmp(text_of("not finite"),
          "1 of 5 points were rejected, because their x or y is NaN or infinite; the first is point "
          "2.") == 0);
  CHECK(strncmp(text_of("crossing"), "1 of 2 segments were left out", 29) == 0);
  CHECK(say(job, AHD_WORDS_OF_CLASS, &first, 1, sizeof said) > 100);
  CHECK(strstr(text_of("not finite"), "point 9.") != NULL);
  CHECK(strncmp(text_of("crossing"), "1 of 2 segments of the source", 29) == 0);
  CHECK_OK(job, ahd_set_int(job, "split_crossings", 1));
  CHECK_OK(job, ahd_run(job));
  say(job, AHD_WORDS_OF_C, NULL, 0, sizeof said);
  CHECK(*text_of("crossing") == '\0' && *text_of("not finite") == '1');
  ahd_job_free(job);
}

static int32_t stop_late(void* user, int32_t phase, double fraction)
{
  (void)user;
  (void)fraction;
  return phase == AHD_PHASE_EXTRACT;
}

/* After a run that failed its counts are partial, and not in messages. */
static void test_run_that_ended(void)
{
  const double xy[] = { 0, 0, 1, 0, 1, 1, 0, 1 };
  const int64_t line[] = { -1, 2 };
  ahd_job* job = ahd_job_of(xy, 4, 2);
  ahd_array ids = ahd_ids(line, 1, 2);
  CHECK_OK(job, ahd_set_array(job, "line_ids", &ids));
  CHECK_OK(job, ahd_run(job));
  CHECK(say(job, AHD_WORDS_OF_C, NULL, 0, sizeof said) > 1);
  CHECK(strstr(text_of("unfit ids"), "not ids of points; the first is -1 in cell 0.") != NULL);
  CHECK_OK(job, ahd_set_progress(job, stop_late, NULL));
  CHECK_STATUS(job, AHD_CANCELLED, ahd_run(job));
  CHECK(say(job, AHD_WORDS_OF_C, NULL, 0, sizeof said) == 1);
  ahd_job_free(job);
}

void test_messages(void)
{
  test_run_that_ended();
  test_room();
  test_wrong_calls();
  test_absurd_counts();
  test_job();
}
