// SPDX-License-Identifier: BSD-3-Clause
#include "ConstrainedMesh.h"

#include "../Core/Chunks.h"

#include <algorithm>

namespace ahd
{

bool ConstrainedMesh::begin(Mesh& mesh, const Point* xy, Ticker& ticker)
{
  data_ = mesh.data();
  xy_ = xy;
  ghost_ = mesh.ghost();
  marks_.allocate(mesh.end() / Mesh::kSlotSize);
  return fillAll(marks_, std::uint8_t(0), ticker);
}

bool ConstrainedMesh::findVertices(Ticker& ticker)
{
  constexpr std::size_t kTrianglesAhead = 32; // fetched
  slotOf_.allocate(std::size_t(ghost_) + 1);
  const auto look = [this](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      prefetchForRead(data_ + Mesh::slotOfTriangle(k + kTrianglesAhead));
      setCorners(Mesh::slotOfTriangle(k));
    }
  };
  return fillAll(slotOf_, kNoIndex, ticker) && inChunks(0, triangles(), ticker, look);
}

} // namespace ahd
