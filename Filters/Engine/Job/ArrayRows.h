// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
#ifndef ahd_JobArrayRows_h
#define ahd_JobArrayRows_h

#include "SettingRows.h"
#include "Words.h"

#include <cstddef>
#include <iterator>

namespace ahd
{

/// The output arrays that a setting asks for.
enum class WantedArray : std::size_t
{
  PointStatus,
  Errors,
  InsertionRanks,
  ConstraintEdges,
  Regions,
  Neighbors
};

struct WantedRow
{
  const char* name; ///< in ahd.h
  IntSetting setting;
  bool isOfCells; ///< else of points
  NumberType type;
  std::size_t columns;
  std::size_t bytes; ///< of all columns, ids with 64 bits
  double time;       ///< to write it; that of a plain triangulation is 1
};

constexpr WantedRow kWantedRows[] = {
  { "point_status", IntSetting::WantPointStatus, false, kInt64, 1, 8, 0.1 },
  { "errors", IntSetting::WantErrors, false, kFloat64, 1, 8, 0.6 },
  { "insertion_ranks", IntSetting::WantInsertionRanks, false, kInt64, 1, 8, 0.1 },
  { "constraint_edges", IntSetting::WantConstraintEdges, true, kUint8, 1, 1, 0.5 },
  { "regions", IntSetting::WantRegions, true, kInt64, 1, 8, 1.0 },
  { "neighbors", IntSetting::WantNeighbors, true, kInt64, 3, 24, 0.9 },
};

constexpr std::size_t kWantedArrays = std::size(kWantedRows);

} // namespace ahd

#endif
