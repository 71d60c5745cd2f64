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
  const std::size_t triangles = mesh.end() / Mesh::kSlotSize;
  marks_.allocate(triangles);
  slotOf_.allocate(std::size_t(ghost_) + 1);
  const auto clear = [this](std::size_t a, std::size_t b)
  { std::fill(slotOf_.data() + a, slotOf_.data() + b, kNoIndex); };
  const auto look = [this](std::size_t a, std::size_t b)
  {
    std::fill(marks_.data() + a, marks_.data() + b, std::uint8_t(0));
    for (std::size_t k = a; k != b; ++k)
    {
      setCorners(Mesh::slotOfTriangle(k));
    }
  };
  return inChunks(0, slotOf_.size(), ticker, clear) && inChunks(0, triangles, ticker, look);
}

} // namespace ahd
