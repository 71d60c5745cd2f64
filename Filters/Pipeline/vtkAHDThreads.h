// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDThreads_h
#define vtkAHDThreads_h

/**
 * The number of threads to use for the setting `wished`.
 *
 * More than 0: exactly so many, 1024 at most. 0: one for each processor that this process may run
 * on, but not more than vtkSMPTools would take, or would take if its backend were not Sequential:
 * vtkSMPTools::Initialize(n) limits them, else the environment variable VTK_SMP_MAX_THREADS does.
 * One only, if called within vtkSMPTools without nested parallelism.
 */
unsigned vtkAHDThreadsToUse(int wished);

#endif
