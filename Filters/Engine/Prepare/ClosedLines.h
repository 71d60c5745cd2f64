// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ClosedLines_h
#define ahd_ClosedLines_h

#include "../Core/Progress.h"
#include "../Points/Points.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace ahd
{

/// Where a line begins and ends in the plane; NaN where its id is no point's.
struct LineEnds
{
  Point first, last;
  bool areOne = false; ///< one point, or at one place

  auto fields() { return std::tie(first, last, areOne); }
};

/// Chains of ids: chain k is ids[offsets[k]] to ids[offsets[k + 1] - 1], made of the cell cells[k].
struct Chains
{
  std::vector<std::int64_t> ids, offsets, cells;
  std::size_t lines = 0; ///< they come first

  /// Has a line one?
  bool haveSegments() const
  {
    const auto behind = offsets.begin() + static_cast<std::ptrdiff_t>(lines + 1);
    return std::adjacent_find(offsets.begin(), behind,
             [](std::int64_t a, std::int64_t b) { return b - a > 1; }) != behind;
  }
};

/// Puts closed lines behind the open ones, as loops. Closed are
///
/// - lines whose ends are one;
/// - of the other lines, those that join to one that is closed. Two lines are joined where they end
///   at one place and no third does. So a place where three end, or more, ends those lines; a
///   joined line that begins and ends at the same such place is closed;
///
/// both with three segments or more. All else stays as it is. A loop has the cell of the first of
/// its lines, and the loops are in the order of their cells. It runs as that of its lines does
/// whose first place, then whose last place is lexicographically the least, or which comes first.
/// So which loops there are does not depend on the order and the directions of the lines.
///
/// @param ends of each line
/// @param chains have cells, ascending
/// @param found whether there is a loop; if not, nothing has changed
/// @return false if cancelled; throws std::bad_alloc
bool closeLines(const std::vector<LineEnds>& ends, Chains& chains, Ticker& ticker, bool& found);

/// Upper bound of the bytes for so many lines, without the chains.
std::size_t closingMemoryEstimate(std::size_t lines);

} // namespace ahd

#endif
