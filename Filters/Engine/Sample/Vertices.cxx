// SPDX-License-Identifier: BSD-3-Clause
#include "Vertices.h"

#include "../Core/Chunks.h"
#include "../Core/Loops.h"

namespace ahd
{

bool listInserted(const TriangulationAccess::State& state, Buffer<Index>& vertices, Ticker& ticker)
{
  const std::size_t all = state.ranked.count, inserted = state.report.inserted;
  Buffer<unsigned char> isLeftOut;
  isLeftOut.allocate(state.report.beyondLimit == 0 ? 0 : all);
  vertices.allocate(all - state.report.beyondLimit);
  const auto leaveOut = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      isLeftOut[state.sequence[i]] = 1;
    }
  };
  std::size_t count = 0;
  const auto list = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t v = a; v != b; ++v)
    {
      if (isLeftOut.empty() || isLeftOut[v] == 0)
      {
        vertices[count++] = static_cast<Index>(v);
      }
    }
  };
  return ticker.ask() && fillAll(isLeftOut, 0, ticker) &&
    inChunks(inserted, inserted + state.report.beyondLimit, ticker, leaveOut) &&
    inChunks(0, all, ticker, list);
}

} // namespace ahd
