/* SPDX-License-Identifier: BSD-3-Clause */
/* The examples at the top of ahd.h, ahd_messages.h and ahd_sample.h. */
#include <ahd.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* x + y at the centres of 3 x 2 cells of the job's points. */
static int sample(ahd_job* job)
{
  static const double z[] = { 0, 1, 2, 1, 0.75, 9 };
  ahd_places cells = { NULL, 0, { 0.125, 0.25 }, { 0.25, 0.5 }, 3, 2 };
  double heights[6] = { 0 };
  uint8_t mask[6] = { 0 };
  ahd_sampled array = { z, 1, heights, NULL };
  if (ahd_set_int(job, "sample_method", AHD_SAMPLE_NATURAL_NEIGHBOR) != AHD_OK ||
    ahd_sample(job, &cells, &array, 1, mask) != AHD_OK)
  {
    puts(ahd_message(job));
    return 0;
  }
  printf("the first cell has %g, the last %g\n", heights[0], heights[5]);
  return mask[0] == 1 && mask[5] == 1 && heights[0] > 0.374 && heights[0] < 0.376 &&
    heights[5] > 1.374 && heights[5] < 1.376;
}

/* How many messages there are. */
static int say(ahd_job* job)
{
  char said[4096];
  int count = 0;
  ahd_say(job, AHD_SAY_TRIANGULATION, AHD_WORDS_OF_C, NULL, 0, said, sizeof said);
  for (const char* each = said; *each; each += strlen(each) + 1)
  {
    printf("(%s) ", each);
    each += strlen(each) + 1;
    puts(each);
    ++count;
  }
  return count;
}

int main(void)
{
  static const double xy[] = { 0, 0, 1, 0, 1, 1, 0, 1, 0.25, 0.5, NAN, 2 };
  const ahd_array points = { xy, AHD_FLOAT64, 2, 6, 2 * sizeof(double), sizeof(double) };
  uint64_t triangles = 0, three = 0;
  int32_t* ids = NULL;
  int is_sampled, messages;
  ahd_job* job = ahd_job_new();
  if (ahd_abi_version() != AHD_ABI_VERSION || ahd_set_array(job, "points", &points) != AHD_OK ||
    ahd_run(job) != AHD_OK || ahd_array_size(job, "triangles", &triangles, &three) != AHD_OK)
  {
    puts(ahd_message(job));
    return 1;
  }
  ids = (int32_t*)malloc(triangles * three * sizeof(int32_t));
  if (ahd_get_array(job, "triangles", AHD_INT32, ids, triangles * three) != AHD_OK)
  {
    puts(ahd_message(job));
    return 1;
  }
  printf("%d triangles of %s, the first has the points %d %d %d\n", (int)triangles, ahd_version(),
    (int)ids[0], (int)ids[1], (int)ids[2]);
  free(ids);
  is_sampled = sample(job);
  messages = say(job);
  ahd_job_free(job);
  return triangles == 4 && three == 3 && is_sampled && messages == 1 ? 0 : 1;
}
