// SPDX-License-Identifier: BSD-3-Clause
#include "Counts.h"

#include "../Surface/OrderDrawing.h"
#include "Refusal.h"
#include "ReportRows.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace ahd
{
namespace
{

using Made = JobResult;

DrawnOrder drawnOrderOf(const Made& m)
{
  return drawnOrder(m.triangulation, m.asked.curve);
}

/// A number besides those of the reports.
template <typename Number>
struct ResultRow
{
  const char* name;
  Number (*get)(const Made&);
};
constexpr ResultRow<std::uint64_t> kCounts[] = {
  { "drawn_points", [](const Made& m) { return std::uint64_t(drawnOrderOf(m).points()); } },
  { "drawn_cells", [](const Made& m) { return std::uint64_t(drawnOrderOf(m).cells()); } },
  { "sampling_estimate", [](const Made& m) { return std::uint64_t(m.sampling.estimate); } },
};
constexpr ResultRow<double> kMeasures[] = {
  { "seconds_sample", [](const Made& m) { return m.sampling.seconds; } },
};

[[noreturn]] void refuseName(const char* kind, const char* name)
{
  refuse(Reason::UnknownName,
    "There is no " + std::string(kind) + " \"" + std::string(name ? name : "(null)") + "\".");
}

/// With the seconds of later calls, too.
RunReport reportNow(const Job& job)
{
  RunReport report = job.report();
  report.seconds = job.progress.seconds();
  return report;
}

void checkRoom(std::size_t needed, std::uint64_t capacity)
{
  if (capacity < needed)
  {
    refuse(Reason::BadArray,
      "There are " + std::to_string(needed) + " numbers, and room for " + std::to_string(capacity) +
        ".");
  }
}

/// The numbers of all rows; returns the end of what is written.
template <typename Rows, typename Report, typename Number>
Number* writeRows(const Rows& rows, const Report& report, Number* values)
{
  return std::transform(std::begin(rows), std::end(rows), values,
    [&](const auto& row) { return static_cast<Number>(row.get(report)); });
}

/// The name of row `number` of all these tables, one after the other; null past the last.
template <typename... Rows>
const char* nameOf(std::size_t number, const Rows&... tables)
{
  const char* name = nullptr;
  const auto look = [&](const auto& rows)
  {
    name = number < std::size(rows) ? rows[number].name : name;
    number -= std::size(rows); // beyond all others
  };
  (look(tables), ...);
  return name;
}

} // namespace

std::int64_t countOf(Job& job, const char* name)
{
  const std::string_view wanted = name ? name : "";
  if (const auto* const row = findRow(kCountRows, wanted))
  {
    if (row->isOfResult)
    {
      job.result(); // or refuses
    }
    return static_cast<std::int64_t>(row->get(job.report()));
  }
  if (const auto* const row = findRow(kCounts, wanted))
  {
    return static_cast<std::int64_t>(row->get(job.result()));
  }
  if (const auto* const row = findRow(kSampleRows, wanted))
  {
    return static_cast<std::int64_t>(row->get(job.result().sampling.report));
  }
  refuseName("count", name);
}

double measureOf(Job& job, const char* name)
{
  const std::string_view wanted = name ? name : "";
  if (const auto* const row = findRow(kMeasureRows, wanted))
  {
    job.result(); // or refuses
    return row->get(reportNow(job));
  }
  if (const auto* const row = findRow(kMeasures, wanted))
  {
    return row->get(job.result());
  }
  refuseName("measure", name);
}

void writeCounts(Job& job, std::int64_t* values, std::uint64_t capacity)
{
  const JobResult& made = job.result();
  checkRoom(std::size(kCountRows) + std::size(kCounts) + std::size(kSampleRows), capacity);
  values = writeRows(kCountRows, job.report(), values);
  values = writeRows(kCounts, made, values);
  writeRows(kSampleRows, made.sampling.report, values);
}

void writeMeasures(Job& job, double* values, std::uint64_t capacity)
{
  const JobResult& made = job.result();
  checkRoom(std::size(kMeasureRows) + std::size(kMeasures), capacity);
  values = writeRows(kMeasureRows, reportNow(job), values);
  writeRows(kMeasures, made, values);
}

Facts factsOf(const Job& job, Facts known)
{
  const std::size_t given = known.count();
  if (const JobResult* const made = job.madeResult())
  {
    for (const auto& row : kCounts)
    {
      known.addNonzero(row.name, row.get(*made), given);
    }
    known = factsOf(made->sampling.report, std::move(known));
    known.addNonzero("splits", made->asked.split || made->points.addedToLines() > 0, given);
    known.addNonzero("cell_ids", !made->asked.idsAreOfInput, given);
    const bool areMixed = made->asked.sourceHeights == SourceHeights::Mixed;
    known.addNonzero("heights_are_mixed", areMixed, given);
  }
  const bool isKnown = job.madeResult() || job.report().status != Status::Ok;
  return isKnown ? factsOf(job.report(), std::move(known)) : known;
}

const char* countName(std::size_t number)
{
  return nameOf(number, kCountRows, kCounts, kSampleRows);
}

const char* measureName(std::size_t number)
{
  return nameOf(number, kMeasureRows, kMeasures);
}

} // namespace ahd
