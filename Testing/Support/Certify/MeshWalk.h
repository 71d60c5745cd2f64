// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_MeshWalk_h
#define ahd_MeshWalk_h

#include "CertifiedMesh.h"

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace ahd
{
namespace test
{

/// Straight walks through a correct mesh.
class MeshWalk
{
public:
  explicit MeshWalk(const CertifiedMesh& mesh)
    : mesh_(mesh)
  {
  }

  /// The neighbour of `from` on the ray towards `to`; kNone if there is none.
  std::int32_t neighborTowards(std::int32_t from, std::int32_t to);

  /// Calls stop(h) with each half-edge that the open way from one vertex to another crosses in no
  /// vertex, in their order, until it returns true. Returns whether it did. Half-edges are seen
  /// from the near side.
  bool crossEdges(
    std::int32_t from, std::int32_t to, const std::function<bool(std::int32_t)>& stop);

private:
  /// The neighbours of a vertex by angle, from straight down, which is not included, to straight
  /// down.
  using Ring = std::vector<std::int32_t>;

  const Ring& ringOf(std::int32_t v);
  bool isBefore(std::int32_t v, std::int32_t a, std::int32_t b) const;
  std::int32_t lastNotAfter(std::int32_t from, std::int32_t to);

  const CertifiedMesh& mesh_;
  std::unordered_map<std::int32_t, Ring> rings_;
};

} // namespace test
} // namespace ahd

#endif
