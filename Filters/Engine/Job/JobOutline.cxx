// SPDX-License-Identifier: BSD-3-Clause
//
// Of the array cells of a job: the outline, and which are small.
#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Surface/Circumradius.h"
#include "Arrays.h"
#include "Job.h"
#include "Refusal.h"

#include <cstring>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

namespace ahd
{
namespace
{

struct OutlineRow
{
  const char* name;
  std::vector<Index> Outline::*list;
};
constexpr OutlineRow kOutlineRows[] = { { "outline_points", &Outline::corners },
  { "outline_rings", &Outline::rings }, { "outline_polygons", &Outline::polygons },
  { "outline_cells", &Outline::cells } };

} // namespace

const std::vector<Index>* outlineList(const Job& job, const char* name)
{
  for (const OutlineRow& row : kOutlineRows)
  {
    if (name && std::strcmp(row.name, name) == 0)
    {
      return &(job.outline().*row.list);
    }
  }
  return nullptr;
}

const char* outlineArrayName(std::size_t number)
{
  static_assert(std::size(kOutlineRows) == kOutlineArrays, "a row for each");
  return number < kOutlineArrays ? kOutlineRows[number].name : nullptr;
}

const Outline& Job::outline() const
{
  if (!outline_)
  {
    refuse(Reason::NotAvailable, "There is no outline: ahd_outline() has made none.");
  }
  return *outline_;
}

void Job::makeOutline(CheckedMemory& checked, bool isDirected)
{
  outline_.reset();
  OutlineRequest request;
  request.cells = arrays.countCells(InputArray::Cells, InputArray::CellOffsets);
  request.points.count = static_cast<std::size_t>(arrays[InputArray::Points].rows);
  const GivenArray& groups = arrays[InputArray::CellGroups];
  const bool hasGroups = arrays.has(InputArray::CellGroups);
  if (hasGroups && static_cast<std::size_t>(groups.rows) != request.cells.cells)
  {
    refuse(Reason::BadArray,
      "\"cell_groups\" has " + std::to_string(groups.rows) + " rows, and there are " +
        std::to_string(request.cells.cells) + " cells.");
  }
  const CallersMemory callers = callersMemory();
  const Apart apart(progress);
  auto made = std::make_unique<Outline>();
  OpenInput input;
  const auto open = [&]
  {
    input.openPoints(arrays, { &progress, nullptr });
    input.openPolygons(arrays, { &progress, nullptr });
    request.points = input.points;
    request.cells = input.polygons;
    request.groups = input.groups;
    request.isDirected = isDirected;
    progress.expectLastPhase();
    return request;
  };
  const Status status = outlineWithin(checked,
    { memoryLimit(), callers.bytes, callers.perAddedPoint }, request, open, progress, *made);
  if (status == Status::OutOfMemory)
  {
    refuse(reasonOf(status, checked.isRefused), factsOf(checked, status, request));
  }
  ahd::check(status);
  ahd::check(progress.finish() ? Status::Ok : Status::Cancelled);
  outline_ = std::move(made);
}

void Job::findWithin(double radius, std::uint8_t* kept)
{
  if (!(radius > 0.0))
  {
    refuse(Reason::BadValue, "The radius is not greater than 0.");
  }
  if (arrays.has(InputArray::CellOffsets) || arrays[InputArray::Cells].columns != 3)
  {
    refuse(Reason::BadArray, "\"cells\" are no triangles, with three columns.");
  }
  const Apart apart(progress);
  const Context context{ &progress, nullptr };
  OpenInput input;
  input.openPoints(arrays, context);
  input.openPolygons(arrays, context);
  progress.expectLastPhase();
  const PointView& points = input.points;
  const CellsView& cells = input.polygons;
  const RadiusLimit limit(radius);
  const auto corner = [&](std::size_t k)
  { return cells.ids32 ? std::int64_t(cells.ids32[k]) : cells.ids64[k]; };
  const auto look = [&](std::size_t cell)
  {
    std::array<Vector3, 3> places;
    bool arePoints = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto id = static_cast<std::uint64_t>(corner(3 * cell + k));
      arePoints = arePoints && id < points.count;
      places[k] = arePoints ? points.place(static_cast<std::size_t>(id)) : Vector3{};
    }
    kept[cell] = arePoints && !limit.isExceeded(places[0], places[1], places[2]) ? 1 : 0;
  };
  ahd::check(unlessCancelled(
    [&]
    {
      Ticker ticker(&progress, Phase::Outputs, cells.cells);
      return inSteps(0, cells.cells, ticker, look) && ticker.ask();
    }));
  ahd::check(progress.finish() ? Status::Ok : Status::Cancelled);
}

} // namespace ahd
