// SPDX-License-Identifier: BSD-3-Clause
#include "Selection.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "Circumradius.h"

namespace ahd
{

Status findShort(const std::int32_t* triples, std::size_t triangles, const PointView& places,
  double length, const Context& context, std::vector<unsigned char>& kept)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      const LengthLimit limit(length);
      kept.assign(triangles, 0);
      const auto find = [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t t = begin; t < end; ++t)
        {
          const auto corner = [&](std::size_t k)
          { return places[static_cast<std::size_t>(triples[3 * t + k])]; };
          const Point a = corner(0), b = corner(1), c = corner(2);
          kept[t] = !limit.isExceeded(a, b, c);
        }
      };
      return inChunks(0, triangles, ticker, find) && ticker.ask();
    });
}

} // namespace ahd
