/* SPDX-License-Identifier: BSD-3-Clause */
/* The example at the top of ahd.h. */
#include <ahd.h>

#include <stdio.h>
#include <stdlib.h>

int main(void)
{
  static const double xy[] = { 0, 0, 1, 0, 1, 1, 0, 1, 0.25, 0.5 };
  const ahd_array points = { xy, AHD_FLOAT64, 2, 5, 2 * sizeof(double), sizeof(double) };
  uint64_t triangles = 0, three = 0;
  int32_t* ids = NULL;
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
  ahd_job_free(job);
  return triangles == 4 && three == 3 ? 0 : 1;
}
