// SPDX-License-Identifier: BSD-3-Clause
#include "WantedArrays.h"

#include "../Surface/CellArrays.h"
#include "Errors.h"

namespace ahd
{

std::size_t rowsOf(WantedArray array, const RunResult& made)
{
  return kWantedRows[std::size_t(array)].isOfCells ? cellCount(made.triangulation, made.selection)
                                                   : made.points.points().count;
}

Status writeArray(WantedArray array, RunResult& made, const ArrayTarget& to)
{
  Triangulation& triangulation = made.triangulation;
  const Selection& selection = made.selection;
  switch (array)
  {
    case WantedArray::PointStatus:
      return withIds(to, [&](auto* ids) { return made.writeStatus(ids, to.context); });
    case WantedArray::Errors:
      return writeErrors(made, to.doubles(), to.context);
    case WantedArray::InsertionRanks:
      return withIds(
        to, [&](auto* ids) { return triangulation.writeInsertionRanks(ids, to.context); });
    case WantedArray::ConstraintEdges:
      return writeConstraintEdges(
        triangulation, selection, static_cast<std::uint8_t*>(to.out), to.context);
    case WantedArray::Regions:
      return withIds(
        to, [&](auto* ids) { return writeRegions(triangulation, selection, ids, to.context); });
    case WantedArray::Neighbors:
      return withIds(
        to, [&](auto* ids) { return writeNeighbors(triangulation, selection, ids, to.context); });
  }
  return Status::Ok;
}

} // namespace ahd
