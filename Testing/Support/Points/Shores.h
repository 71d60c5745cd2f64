// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Shores_h
#define ahd_Shores_h

#include "Points/Points.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace ahd
{
namespace test
{

/// Adds 2^depth points from a to b, b excepted: middles that are moved aside, again and again.
inline void addFractal(
  std::vector<Point>& line, const Point& a, const Point& b, int depth, std::mt19937_64& random)
{
  if (depth == 0)
  {
    line.push_back(a);
    return;
  }
  const double t = 0.5 * (double(random() >> 11) * 0x1p-53 - 0.5);
  const Point middle{ 0.5 * (a.x + b.x) - t * (b.y - a.y), 0.5 * (a.y + b.y) + t * (b.x - a.x) };
  addFractal(line, a, middle, depth - 1, random);
  addFractal(line, middle, b, depth - 1, random);
}

/// Closed lines like those of shores, of 2^5 to 2^13 points, the last one the first again; then two
/// families of open lines across them.
inline std::vector<std::vector<Point>> shoreLines(std::size_t islands, std::size_t rivers)
{
  std::mt19937_64 random(1);
  const auto fraction = [&random] { return double(random() >> 11) * 0x1p-53; };
  std::vector<std::vector<Point>> lines(islands + 2 * rivers);
  for (std::size_t k = 0; k != islands; ++k)
  {
    const int depth = 3 + int(8.0 * fraction());
    const double x = 2.0 * fraction(), y = fraction(), r = std::ldexp(4e-4, depth / 2);
    const Point corners[] = { { x + r, y }, { x, y + r }, { x - r, y }, { x, y - r },
      { x + r, y } };
    for (std::size_t c = 0; c != 4; ++c)
    {
      addFractal(lines[k], corners[c], corners[c + 1], depth, random);
    }
    lines[k].push_back(corners[4]);
  }
  for (std::size_t k = islands; k != lines.size(); ++k)
  {
    const double t = fraction(), u = fraction();
    const bool isAcross = k % 2 == 0;
    addFractal(lines[k], isAcross ? Point{ 0.0, t } : Point{ 2.0 * t, 0.0 },
      isAcross ? Point{ 2.0, u } : Point{ 2.0 * u, 1.0 }, 10, random);
  }
  return lines;
}

} // namespace test
} // namespace ahd

#endif
