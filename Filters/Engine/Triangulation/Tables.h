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

/// The tables of a Triangulation, for loops that read much of them. Tables not made are empty.
struct Tables
{
  /// A flag of a triangle; bits 0 to 2 say which of its edges are constraints.
  static constexpr std::uint8_t kDroppedTriangle = 8;

  /// The flag of a triangle with these marks (ConstrainedMesh.h), the lowest of whose corners is
  /// the one with that number in its slot.
  static std::uint8_t flagOf(std::uint8_t marks, unsigned lowest)
  {
    constexpr std::uint8_t kFromLowest[3][8] = { { 0, 2, 4, 6, 1, 3, 5, 7 },
      { 0, 1, 2, 3, 4, 5, 6, 7 }, { 0, 4, 1, 5, 2, 6, 3, 7 } };
    return static_cast<std::uint8_t>(kFromLowest[lowest][marks & 7u] | (marks & 8u));
  }

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

} // namespace ahd

#endif
