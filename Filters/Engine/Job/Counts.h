// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobCounts_h
#define ahd_JobCounts_h

#include "Job.h"
#include "Messages.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

// Counts and measures of a job by name. Unknown names and missing results are refused.
std::int64_t countOf(Job& job, const char* name);
double measureOf(Job& job, const char* name);
// All of them, in the order of their names. A missing result, and too few values, are refused.
void writeCounts(Job& job, std::int64_t* values, std::uint64_t capacity);
void writeMeasures(Job& job, double* values, std::uint64_t capacity);
/// The facts of messages that are not `known`: counts and settings.
Facts factsOf(const Job& job, Facts known);

/// Null past the last.
const char* countName(std::size_t number);
const char* measureName(std::size_t number);

} // namespace ahd

#endif
