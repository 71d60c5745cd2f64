// SPDX-License-Identifier: BSD-3-Clause
#include "MeshWalk.h"

#include "ExactSigns.h"

#include <algorithm>

namespace ahd
{
namespace test
{

/// Does the direction from v to a come before that to b? Two halves, each sorted by turns.
bool MeshWalk::isBefore(std::int32_t v, std::int32_t a, std::int32_t b) const
{
  const Point p = mesh_.at(v);
  const bool aIsRight = lexicographicallyLess(p, mesh_.at(a));
  const bool bIsRight = lexicographicallyLess(p, mesh_.at(b));
  return aIsRight != bIsRight ? aIsRight : orientSign(p, mesh_.at(a), mesh_.at(b)) > 0;
}

const MeshWalk::Ring& MeshWalk::ringOf(std::int32_t v)
{
  Ring& ring = rings_[v];
  if (ring.empty())
  {
    for (const CertifiedMesh::Edge* edge = mesh_.edgesBegin(v); edge != mesh_.edgesEnd(v); ++edge)
    {
      ring.push_back(edge->target);
      const std::int32_t back = CertifiedMesh::previous(edge->halfEdge);
      if (mesh_.twin(back) == CertifiedMesh::kNone)
      {
        ring.push_back(mesh_.origin(back)); // the edge of the hull that arrives
      }
    }
    std::sort(ring.begin(), ring.end(),
      [&](std::int32_t a, std::int32_t b) { return this->isBefore(v, a, b); });
  }
  return ring;
}

std::int32_t MeshWalk::lastNotAfter(std::int32_t from, std::int32_t to)
{
  const Ring& ring = ringOf(from);
  const auto after = std::upper_bound(ring.begin(), ring.end(), to,
    [&](std::int32_t a, std::int32_t b) { return this->isBefore(from, a, b); });
  return after == ring.begin() ? ring.back() : *(after - 1);
}

std::int32_t MeshWalk::neighborTowards(std::int32_t from, std::int32_t to)
{
  if (mesh_.findHalfEdge(from, to) != CertifiedMesh::kNone ||
    mesh_.findHalfEdge(to, from) != CertifiedMesh::kNone)
  {
    return to;
  }
  const std::int32_t found = lastNotAfter(from, to);
  return isBefore(from, found, to) || isBefore(from, to, found) ? CertifiedMesh::kNone : found;
}

bool MeshWalk::crossEdges(
  std::int32_t from, std::int32_t to, const std::function<bool(std::int32_t)>& stop)
{
  for (std::int32_t v = from; v != to;)
  {
    const std::int32_t right = lastNotAfter(v, to);
    if (!isBefore(v, right, to) && !isBefore(v, to, right))
    {
      v = right; // along an edge
      continue;
    }
    std::int32_t h = CertifiedMesh::next(mesh_.findHalfEdge(v, right));
    for (;;)
    {
      if (stop(h))
      {
        return true;
      }
      const std::int32_t twin = mesh_.twin(h);
      const std::int32_t apex = mesh_.apex(twin);
      const int side = orientSign(mesh_.at(from), mesh_.at(to), mesh_.at(apex));
      if (side == 0)
      {
        v = apex;
        break;
      }
      // The twin runs from the left end to the right one; the way leaves beside the apex.
      h = side > 0 ? CertifiedMesh::next(twin) : CertifiedMesh::previous(twin);
    }
  }
  return false;
}

} // namespace test
} // namespace ahd
