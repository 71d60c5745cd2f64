// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_MeshOrder_h
#define ahd_MeshOrder_h

#include "../Core/Buffer.h"
#include "../Core/Chunks.h"
#include "../Core/Loops.h"
#include "../Extract/Extractor.h"
#include "../Mesh/Mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ahd
{

/// A triangle of a mesh, counterclockwise from its lowest corner as triangles are in canonical
/// order: corner 0 is the lowest, edge k runs from corner k to the next one.
class OrderedTriangle
{
public:
  /// `number`: see numberCanonical(); not kNotExtracted. `slot`: counted from 0.
  OrderedTriangle(const std::uint32_t* mesh, std::size_t slot, std::uint32_t number)
    : data_(mesh + slot * Mesh::kSlotSize)
    , place_(kPlace + (number & 3u))
  {
  }

  std::uint32_t corner(unsigned k) const { return data_[place_[k]]; }
  /// The half-edge of the mesh that is the twin of edge k.
  Mesh::Halfedge twin(unsigned k) const { return data_[Mesh::kTwin + place_[k + 2]]; }
  /// The place of its lowest corner in its slot.
  unsigned lowest() const { return place_[0]; }

private:
  static constexpr unsigned kPlace[7] = { 0, 1, 2, 0, 1, 2, 0 };

  const std::uint32_t* data_;
  const unsigned* place_;
};

/// The place in the canonical order that a number stands for.
inline std::size_t triangleOf(std::uint32_t number)
{
  return number >> 2;
}

/// What half-edge `h` of the mesh is in the tables, if the triangle in its slot has this number.
/// There it is opposite to a corner, here it begins at one.
inline std::uint32_t halfEdgeOf(std::uint32_t number, Mesh::Halfedge h)
{
  constexpr std::uint8_t kEdge[3][4] = { { 1, 2, 0, 0 }, { 0, 1, 2, 0 }, { 2, 0, 1, 0 } };
  return 3 * (number >> 2) + kEdge[number & 3u][h & 3u];
}

/// An array with so many bytes for each triangle.
struct TriangleArray
{
  template <typename T>
  TriangleArray(const T* begin, std::size_t perTriangle)
    : first(reinterpret_cast<std::uintptr_t>(begin))
    , bytes(perTriangle * sizeof(T))
  {
  }
  /// Before fetch().
  void prepare(std::uint32_t) const {}
  /// Prefetches the entry of the triangle of this number, if it is one, for writing.
  void fetch(std::uint32_t number) const
  {
    prefetchForWrite(reinterpret_cast<const void*>(first + triangleOf(number) * bytes));
  }
  std::uintptr_t first;
  std::size_t bytes;
};

/// Two such arrays.
struct TwoTriangleArrays
{
  void prepare(std::uint32_t) const {}
  void fetch(std::uint32_t number) const
  {
    first.fetch(number);
    second.fetch(number);
  }
  TriangleArray first;
  TriangleArray second;
};

/// Calls visit(triangle, its slot, OrderedTriangle) for all triangles that have numbers, in the
/// order of the slots, in which neighbours are near to each other, on all threads lent. It writes
/// to `array`, one or two. Returns false if cancelled.
template <typename Arrays, typename Visit>
bool inMeshOrder(const Mesh& mesh, const Buffer<std::uint32_t>& numbers, const Arrays& array,
  Ticker& ticker, const Visit& visit)
{
  constexpr std::size_t kSlotsAhead = 16;
  return inShares(numbers.size(), ticker, 4, kChunk,
    [data = mesh.data(), &numbers, &visit, array](std::size_t a, std::size_t b)
    {
      const std::size_t last = numbers.size() - 1;
      for (std::size_t slot = a; slot != b; ++slot)
      {
        array.prepare(numbers[std::min(slot + 2 * kSlotsAhead, last)]);
        array.fetch(numbers[std::min(slot + kSlotsAhead, last)]);
        prefetchForRead(data + (slot + 2 * kSlotsAhead) * Mesh::kSlotSize);
        if (const std::uint32_t number = numbers[slot]; number != kNotExtracted)
        {
          visit(triangleOf(number), slot, OrderedTriangle(data, slot, number));
        }
      }
    });
}

} // namespace ahd

#endif
