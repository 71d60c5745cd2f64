// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PrepareCase_h
#define ahd_PrepareCase_h

// Shared by the tests of prepare(): an input with a source, in memory of its own.
#include "Prepare/Prepare.h"

#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace ahd
{
namespace test
{

using Xyz = Vector3;
using Cells = std::vector<std::vector<std::int64_t>>;

inline PointView viewOf(const std::vector<Xyz>& points)
{
  return PointView(points.empty() ? nullptr : points[0].data(), points.size(), 3);
}

/// Cells in two arrays, of 64 bits or of 32.
struct CellStore
{
  explicit CellStore(const Cells& cells)
  {
    for (const auto& cell : cells)
    {
      ids64.insert(ids64.end(), cell.begin(), cell.end());
      offsets64.push_back(std::int64_t(ids64.size()));
    }
    ids32.assign(ids64.begin(), ids64.end());
    offsets32.assign(offsets64.begin(), offsets64.end());
  }

  CellsView view(bool wide = true) const
  {
    CellsView result;
    result.cells = offsets64.size() - 1;
    result.ids = ids64.size();
    if (wide)
    {
      result.offsets64 = offsets64.data();
      result.ids64 = ids64.data();
    }
    else
    {
      result.offsets32 = offsets32.data();
      result.ids32 = ids32.data();
    }
    return result;
  }

  std::vector<std::int64_t> ids64, offsets64 = { 0 };
  std::vector<std::int32_t> ids32, offsets32;
};

/// Owns the data of a request.
class PrepareCase
{
public:
  PrepareCase(std::vector<Xyz> input, std::vector<Xyz> source, const Cells& lines = {},
    const Cells& polygons = {})
    : input_(std::move(input))
    , source_(std::move(source))
    , lines_(lines)
    , polygons_(polygons)
  {
    request.points = viewOf(input_);
    request.sourcePoints = viewOf(source_);
    setWide(true);
  }
  PrepareCase(const PrepareCase&) = delete;
  PrepareCase& operator=(const PrepareCase&) = delete;

  void setWide(bool wide)
  {
    request.lines = lines_.view(wide);
    request.polygons = polygons_.view(wide);
  }

  const std::vector<Xyz>& input() const { return input_; }
  const std::vector<Xyz>& source() const { return source_; }

  InputRequest request;

private:
  std::vector<Xyz> input_, source_;
  CellStore lines_, polygons_;
};

/// All results of prepare() as a string.
inline std::string bytesOf(const PreparedInput& prepared)
{
  std::string all;
  const auto add = [&all](const void* from, std::size_t bytes)
  {
    all += std::to_string(bytes) + ":";
    all.append(static_cast<const char*>(from), bytes);
  };
  const PointView& points = prepared.points();
  points.doubles ? add(points.doubles, 3 * points.count * sizeof(double))
                 : add(points.floats, 3 * points.count * sizeof(float));
  std::vector<char> skipped(points.count);
  for (std::size_t i = 0; i < points.count; ++i)
  {
    skipped[i] = points.skipped(i);
  }
  add(skipped.data(), skipped.size());
  const ConstraintView chains = prepared.constraints();
  for (std::size_t k = 0; k < chains.chains; ++k)
  {
    const std::size_t size = std::size_t(chains.offsets[k + 1] - chains.offsets[k]);
    add(chains.ids + chains.offsets[k], size * sizeof(std::int64_t));
  }
  for (const CrossingOrigin& crossing : prepared.crossings())
  {
    add(crossing.ends.data(), sizeof crossing.ends);
    add(crossing.along.data(), sizeof crossing.along);
  }
  for (const SurfacePlace& place : prepared.surfacePlaces())
  {
    add(place.corners.data(), sizeof place.corners);
    add(place.weights.data(), sizeof place.weights);
  }
  for (const MergedPoint& merged : prepared.merged())
  {
    add(&merged.id, sizeof merged.id);
    add(&merged.keptId, sizeof merged.keptId);
  }
  return all + std::to_string(prepared.unfitIds().count);
}

/// Points in a unit cube, every tenth of them special.
inline std::vector<Xyz> oddPoints(std::size_t count, unsigned seed)
{
  std::mt19937_64 random(seed); // its sequence is fixed by the standard
  const auto fraction = [&random] { return double(random() >> 11) * 0x1p-53; };
  std::vector<Xyz> points(count);
  for (Xyz& p : points)
  {
    const double x = fraction(), y = fraction();
    p = { { x, y, fraction() } };
    const auto odd = random() % 60;
    if (odd < 6)
    {
      p[odd % 3] = odd < 3 ? std::numeric_limits<double>::quiet_NaN()
                           : -std::numeric_limits<double>::infinity();
    }
  }
  return points;
}

/// Lines, each between two of `count` points.
inline Cells linesBetween(std::size_t lines, std::size_t count, unsigned seed)
{
  std::mt19937_64 random(seed);
  Cells cells(lines);
  for (auto& cell : cells)
  {
    cell = { std::int64_t(random() % count), std::int64_t(random() % count) };
  }
  return cells;
}

} // namespace test
} // namespace ahd

#endif
