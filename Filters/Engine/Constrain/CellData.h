// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CellData_h
#define ahd_CellData_h

#include "ConstrainedMesh.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// What is known of each triangle of the result, in the order of the output. A triangle's edge 0
/// runs from its first corner to its second, edge 1 from there to its third, edge 2 back.
/// All return false if the caller wants to cancel.
class CellData
{
public:
  /// Finds the triangles' places in the mesh. Throws std::bad_alloc.
  /// REQUIRES: so many triangles are finite and not dropped.
  bool begin(const ConstrainedMesh& mesh, std::size_t triangles, Ticker& ticker);

  /// Three numbers per triangle: the triangle on the other side of each edge, -1 if there is none.
  bool writeNeighbors(const ConstrainedMesh& mesh, std::int64_t* out, Ticker& ticker) const;

  /// One number per triangle: bit e is set if edge e is a constraint.
  bool writeConstraintEdges(const ConstrainedMesh& mesh, std::uint8_t* out, Ticker& ticker) const;

  /// One number per triangle: regions that constraints separate, in the order of their first
  /// triangle, from 0. Throws std::bad_alloc.
  bool writeRegions(const ConstrainedMesh& mesh, std::int64_t* out, Ticker& ticker) const;

  std::size_t bytes() const { return first_.bytes() + number_.bytes(); }

private:
  template <typename Visit>
  bool eachTriangle(Ticker& ticker, Visit visit) const;

  Buffer<Mesh::Halfedge> first_; ///< edge 0 of each triangle of the output
  Buffer<std::uint32_t> number_; ///< slot -> place in the output; kNoIndex if it has none
};

} // namespace ahd

#endif
