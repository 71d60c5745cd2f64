// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Errors_h
#define ahd_Errors_h

#include "Run.h"

#include <cstddef>

namespace ahd
{

/// For each point how far the surface is from it: |value - linear interpolation|, with some 100
/// bits where that decides whether it is within the bound. 0 for the vertices; NaN where there is
/// no surface or no value, and for points that were rejected or skipped. Makes all tables. Returns
/// Ok, Cancelled or OutOfMemory.
Status writeErrors(RunResult& made, double* errors, const Context& context);

/// Bytes that writeErrors() takes beside the tables.
std::size_t errorMemoryEstimate(std::size_t pointCount);

} // namespace ahd

#endif
