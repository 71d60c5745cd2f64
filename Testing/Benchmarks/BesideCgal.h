// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BesideCgal_h
#define ahd_BesideCgal_h

#include "ConstraintMakers.h"
#include "Triangulate.h"
#ifdef AHD_WITH_CGAL
#include "CgalConstrained.h"
#endif

#include <ctime>

// Shared by the benchmarks of constraints: makers of them, the engine, CGAL where it is found, and
// the clock.

namespace ahd
{
namespace test
{

/// CPU time of this thread.
inline double seconds()
{
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

} // namespace test
} // namespace ahd

#endif
