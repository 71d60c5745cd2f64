// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Tables_h
#define ahd_Tables_h

#include "../Core/Buffer.h"
#include "../Core/Progress.h"
#include "Triangulation.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// The tables of a Triangulation, for loops that read much of them. What has not been made is
/// empty.
struct Tables
{
  /// A flag of a triangle; bits 0 to 2 say which of its edges are constraints.
  static constexpr std::uint8_t kDroppedTriangle = 8;

  Buffer<Index> corners;      ///< the vertex where each half-edge begins
  Buffer<std::uint8_t> flags; ///< of each triangle; empty without constraints
  Buffer<HalfEdge> twins;     ///< of each half-edge
  Buffer<HalfEdge> starts;    ///< of each vertex
  Buffer<Index> vertexOf;     ///< of each point

  Index origin(HalfEdge h) const { return corners[h]; }
  Index target(HalfEdge h) const { return corners[nextInTriangle(h)]; }
  bool isKept(std::size_t triangle) const
  {
    return flags.empty() || (flags[triangle] & kDroppedTriangle) == 0;
  }
  bool isConstrained(HalfEdge h) const
  {
    return !flags.empty() && (unsigned(flags[h / 3]) >> h % 3 & 1u) != 0;
  }
  std::size_t triangles() const { return corners.size() / 3; }
  std::size_t bytes() const
  {
    return corners.bytes() + flags.bytes() + twins.bytes() + starts.bytes() + vertexOf.bytes();
  }
};

/// Fills `twins` and `starts` from the corners. Returns false if cancelled; throws std::bad_alloc.
/// Takes 28 bytes a vertex while it works.
bool findNeighbors(Tables& tables, std::size_t vertices, Ticker& ticker);

} // namespace ahd

#endif
