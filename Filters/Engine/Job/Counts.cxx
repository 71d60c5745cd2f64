// SPDX-License-Identifier: BSD-3-Clause
#include "Counts.h"

#include "../Surface/OrderDrawing.h"
#include "Refusal.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>

namespace ahd
{
namespace
{

using Made = JobResult;

DrawnOrder drawnOrderOf(const Made& m)
{
  return drawnOrder(m.triangulation, m.asked.curve);
}

/// A count besides those of the report.
struct CountRow
{
  const char* name;
  std::uint64_t (*get)(const Made&);
};
constexpr CountRow kCounts[] = {
  { "triangles", [](const Made& m) { return std::uint64_t(m.triangleCount()); } },
  { "lines", [](const Made& m) { return std::uint64_t(m.selection.lines.size() / 2); } },
  { "vertices", [](const Made& m) { return std::uint64_t(m.selection.vertices.size()); } },
  { "cells", [](const Made& m) { return std::uint64_t(m.cellCount()); } },
  { "drawn_points", [](const Made& m) { return std::uint64_t(drawnOrderOf(m).points()); } },
  { "drawn_cells", [](const Made& m) { return std::uint64_t(drawnOrderOf(m).cells()); } },
  { "sampled_places", [](const Made& m) { return std::uint64_t(m.sampling.places); } },
  { "sampled_valued", [](const Made& m) { return std::uint64_t(m.sampling.report.valued); } },
  { "sampled_outside", [](const Made& m) { return std::uint64_t(m.sampling.report.outside); } },
  { "sampled_not_finite",
    [](const Made& m) { return std::uint64_t(m.sampling.report.notFinite); } },
  { "sampled_without_value",
    [](const Made& m) { return std::uint64_t(m.sampling.report.withoutValue); } },
  { "sampled_left_out", [](const Made& m) { return std::uint64_t(m.sampling.report.leftOut); } },
  { "sampling_estimate", [](const Made& m) { return std::uint64_t(m.sampling.estimate); } },
};

const Report& countsOf(const Made& m)
{
  return m.triangulation.report();
}

double ifCounted(const Made& m, double mean)
{
  return m.asked.options.countWork ? mean : -1.0;
}

struct MeasureRow
{
  const char* name;
  double (*get)(const Made&, const JobProgress&);
};

template <Phase phase>
double secondsOf(const Made&, const JobProgress& progress)
{
  return progress.seconds(phase);
}

constexpr MeasureRow kMeasures[] = {
  { "np", [](const Made& m, const JobProgress&) { return ifCounted(m, countsOf(m).np()); } },
  { "nr", [](const Made& m, const JobProgress&) { return ifCounted(m, countsOf(m).nr()); } },
  { "trimmed_area", [](const Made& m, const JobProgress&) { return countsOf(m).trimmedArea; } },
  { "seconds_merge", secondsOf<Phase::Merge> },
  { "seconds_split", secondsOf<Phase::Split> },
  { "seconds_read", secondsOf<Phase::Read> },
  { "seconds_sort", secondsOf<Phase::Sort> },
  { "seconds_insert", secondsOf<Phase::Insert> },
  { "seconds_constrain", secondsOf<Phase::Constrain> },
  { "seconds_extract", secondsOf<Phase::Extract> },
  { "seconds_outputs", secondsOf<Phase::Outputs> },
  { "seconds_sample", [](const Made& m, const JobProgress&) { return m.sampling.seconds; } },
};

/// The row of that name; null if there is none.
template <typename Row, std::size_t count>
const Row* find(const Row (&rows)[count], const char* name)
{
  const Row* const row = std::find_if(std::begin(rows), std::end(rows),
    [name](const Row& r) { return name && std::strcmp(r.name, name) == 0; });
  return row == std::end(rows) ? nullptr : row;
}

[[noreturn]] void refuseName(const char* kind, const char* name)
{
  refuse(Reason::UnknownName,
    "There is no " + std::string(kind) + " \"" + std::string(name ? name : "(null)") + "\".");
}

} // namespace

std::int64_t countOf(Job& job, const char* name)
{
  for (std::size_t i = 0; const ReportRow* row = reportRow(i); ++i)
  {
    if (name && std::strcmp(row->name, name) == 0)
    {
      if (row->isOfResult)
      {
        job.result(); // or refuses
      }
      return static_cast<std::int64_t>(row->get(job.report()));
    }
  }
  if (const CountRow* const row = find(kCounts, name))
  {
    return static_cast<std::int64_t>(row->get(job.result()));
  }
  refuseName("count", name);
}

double measureOf(Job& job, const char* name)
{
  if (const MeasureRow* const row = find(kMeasures, name))
  {
    return row->get(job.result(), job.progress);
  }
  refuseName("measure", name);
}

Facts factsOf(const Job& job, Facts known)
{
  const std::size_t given = known.count();
  if (const JobResult* const made = job.madeResult())
  {
    for (const CountRow& row : kCounts)
    {
      known.addMissing({ row.name, row.get(*made) }, given);
    }
    known.addMissing({ "splits", made->asked.split }, given);
    known.addMissing({ "cell_ids", !made->asked.idsAreOfInput }, given);
  }
  const bool isKnown = job.madeResult() || job.report().status != Status::Ok;
  return isKnown ? factsOf(job.report(), std::move(known)) : known;
}

const char* countName(std::size_t number)
{
  std::size_t i = 0;
  while (const ReportRow* const row = reportRow(i))
  {
    if (i++ == number)
    {
      return row->name;
    }
  }
  number -= i;
  return number < std::size(kCounts) ? kCounts[number].name : nullptr;
}

const char* measureName(std::size_t number)
{
  return number < std::size(kMeasures) ? kMeasures[number].name : nullptr;
}

} // namespace ahd
