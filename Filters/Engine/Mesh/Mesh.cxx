// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh.h"

namespace ahd
{

void Mesh::begin(std::uint32_t vertexCount, void* memory)
{
  data_ = static_cast<std::uint32_t*>(memory);
  ghost_ = vertexCount;
  insertions_ = vertexCount;
}

//            ghost                the ghosts g0, g1, g2 lie across the edges opposite to a, b, c:
//          g1      g0             g0 = (ghost, c, b)   g1 = (ghost, a, c)   g2 = (ghost, b, a)
//             c                   their edge 0 is the hull edge; two neighbouring ghosts share an
//           /   \                 edge from a hull vertex to infinity
//          a --- b
//             g2
void Mesh::makeFirstTriangle(Vertex a, Vertex b, Vertex c)
{
  const Slot t = 0, g0 = 8, g1 = 16, g2 = 24;
  const auto set = [this](Slot slot, Vertex v0, Vertex v1, Vertex v2)
  {
    data_[slot] = v0;
    data_[slot + 1] = v1;
    data_[slot + 2] = v2;
  };
  set(t, a, b, c);
  set(g0, ghost_, c, b);
  set(g1, ghost_, a, c);
  set(g2, ghost_, b, a);
  link(t, g0);
  link(t + 1, g1);
  link(t + 2, g2);
  link(g0 + 1, g2 + 2); // at b
  link(g1 + 1, g0 + 2); // at c
  link(g2 + 1, g1 + 2); // at a
}

} // namespace ahd
