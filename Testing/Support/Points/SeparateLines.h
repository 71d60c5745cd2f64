// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SeparateLines_h
#define ahd_SeparateLines_h

#include "Constraints.h"
#include "Points/Points.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{
namespace test
{

/// Lines as constraints, each with points of its own.
struct SeparateLines
{
  std::vector<Point> points;
  std::vector<std::int64_t> ids, offsets{ 0 };

  /// A line of one segment.
  void add(const Point& a, const Point& b) { addLine({ a, b }); }

  void addLine(const std::vector<Point>& line)
  {
    for (const Point& p : line)
    {
      ids.push_back(std::int64_t(points.size()));
      points.push_back(p);
    }
    offsets.push_back(std::int64_t(ids.size()));
  }

  std::size_t count() const { return offsets.size() - 1; }
  std::size_t segments() const { return ids.size() - count(); }

  ConstraintView view() const
  {
    ConstraintView chains;
    chains.ids = ids.data();
    chains.offsets = offsets.data();
    chains.chains = chains.lines = count();
    return chains;
  }
};

} // namespace test
} // namespace ahd

#endif
