// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Extractor_h
#define ahd_Extractor_h

#include "../Core/Buffer.h"
#include "../Core/Progress.h"
#include "../Mesh/Mesh.h"

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// Number of vertices on the hull, collinear ones included: the ghost's neighbours.
/// @pre a mesh with a triangle. Returns 0 if cancelled. Throws
/// std::bad_alloc.
std::size_t countHullVertices(const Mesh& mesh, Ticker& ticker);

/// A mesh, and which of its triangles to leave out.
struct ExtractedMesh
{
  ExtractedMesh(const Mesh& all)
    : mesh(all)
  {
  }
  ExtractedMesh(const Mesh& some, const std::uint8_t* theirMarks, std::uint8_t leftOut)
    : mesh(some)
    , marks(theirMarks)
    , leaveOut(leftOut)
  {
  }

  const Mesh& mesh;
  const std::uint8_t* marks = nullptr; ///< null, or one per triangle
  std::uint8_t leaveOut = 0;           ///< triangles with this bit in their mark are left out
};

/// Bytes of scratch that writeCanonical needs per vertex: a key for each of two triangles.
constexpr std::size_t kExtractScratchPerPoint = 2 * sizeof(std::uint64_t);
/// Bytes that it allocates per vertex, at most: 4 for pieces of keys that are not full, 1 for the
/// ends of their chains, 1.25 for their links. With one thread, 0.7.
constexpr std::size_t kExtractBytesPerPoint = 7;

/// Writes the finite triangles of a mesh, but those to be left out, in canonical order: each starts
/// at its lowest vertex, and they are sorted by their three vertices. As vertices are numbered by
/// canonical rank, the order depends on the point set alone. Vertex v is written as ids[v], or as v
/// if `ids` is null; `triples` has room for a triple for each of these. On all threads lent; each
/// allocates 70 KB, and all together kExtractBytesPerPoint. @pre kExtractScratchPerPoint bytes
/// of scratch for each vertex. Returns false if cancelled. Throws std::bad_alloc.
template <typename Id>
bool writeCanonical(const ExtractedMesh& from, const std::uint32_t* ids, Id* triples,
  Scratch& scratch, Ticker& ticker);

constexpr std::uint32_t kNotExtracted = 0xFFFFFFFFu;

/// Of each slot, counted from 0, the place of its triangle in the canonical order, times 4, plus
/// the place of the triangle's lowest corner in the slot; kNotExtracted for ghosts. Like
/// writeCanonical, and where thousands of triangles have their lowest corners near to each other, 8
/// bytes more for each of these.
bool numberCanonical(const Mesh& mesh, std::uint32_t* numbers, Scratch& scratch, Ticker& ticker);

} // namespace ahd

#endif
