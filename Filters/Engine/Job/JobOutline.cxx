// SPDX-License-Identifier: BSD-3-Clause
//
// The outline of the array cells of a job.
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
  return number < std::size(kOutlineRows) ? kOutlineRows[number].name : nullptr;
}

const Outline& Job::outline() const
{
  if (!outline_)
  {
    refuse(Reason::NotAvailable, "There is no outline: ahd_outline() has made none.");
  }
  return *outline_;
}

void Job::makeOutline(OutlineMemory& memory)
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
  memory.limit = static_cast<std::size_t>(settings[IntSetting::MemoryLimit]);
  memory.other = callersMemory().bytes;
  const struct Apart
  {
    JobProgress& progress;
    ~Apart() { progress.endApart(); }
  } apart{ progress };
  progress.beginApart({ 1.0 });
  progress.reach(1);
  auto made = std::make_unique<Outline>();
  OpenInput input;
  const auto open = [&]
  {
    input.openPoints(arrays, { &progress, nullptr });
    input.openPolygons(arrays, { &progress, nullptr });
    request.points = input.points;
    request.cells = input.polygons;
    request.groups = input.groups;
    progress.expectLastPhase();
    return request;
  };
  const Status status = outlineWithin(memory, request, open, progress, *made);
  if (status == Status::OutOfMemory)
  {
    refuse(reasonOf(status, memory.isRefused), memory.facts(status, request));
  }
  ahd::check(status);
  ahd::check(progress.finish() ? Status::Ok : Status::Cancelled);
  outline_ = std::move(made);
}

} // namespace ahd
