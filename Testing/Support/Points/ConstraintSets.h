// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ConstraintSets_h
#define ahd_ConstraintSets_h

#include "Constraints.h"
#include "Points/Points.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ahd
{
namespace test
{

using Chain = std::vector<std::int64_t>;

/// Constraints that own their arrays, in the engine's form.
class ConstraintSet
{
public:
  /// @pre no loop was added yet.
  void addLine(const Chain& chain);
  void addLoop(const Chain& chain);

  ConstraintView view() const;
  std::size_t chains() const { return offsets_.size() - 1; }
  std::size_t lines() const { return lines_; }
  Chain chain(std::size_t k) const;

  /// The same segments with the same numbers, but all chains open: nothing is filled.
  ConstraintSet asLines() const;

  /// The same chains of other ids: id i becomes newId[i]; ids that are no point's stay.
  ConstraintSet renamed(const std::vector<std::int64_t>& newId) const;

  /// As text for a test body: "lines {0 1 2} {3 4}; loops {0 1 2}".
  std::string text() const;

private:
  void add(const Chain& chain);

  std::vector<std::int64_t> ids_;
  std::vector<std::int64_t> offsets_{ 0 };
  std::size_t lines_ = 0;
};

/// A segment as the caller gives it.
struct GivenSegment
{
  std::size_t chain, segment;
  std::int64_t from, to;
  bool ofLoop;
};

/// All segments in the order in which they count: a chain of m ids has m - 1, and a loop one more
/// that closes it, unless its last id is its first one.
std::vector<GivenSegment> segmentsOf(const ConstraintView& constraints);

/// By id: the vertex at the place of the point, the smallest id there; -1 for a point that is no
/// vertex.
std::vector<std::int32_t> verticesOf(const PointView& points);

/// The same, but chains of fewer than three vertices are no loops: an id without a vertex counts as
/// one more.
std::vector<GivenSegment> segmentsOf(
  const ConstraintView& constraints, const std::vector<std::int32_t>& vertices);

/// The vertex of any id at all; -1 if there is none.
inline std::int32_t vertexOf(const std::vector<std::int32_t>& vertices, std::int64_t id)
{
  return id >= 0 && std::size_t(id) < vertices.size() ? vertices[std::size_t(id)] : -1;
}

} // namespace test
} // namespace ahd

#endif
