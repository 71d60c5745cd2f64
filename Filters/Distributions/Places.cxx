// SPDX-License-Identifier: BSD-3-Clause
#include "Places.h"

#include <cmath>

namespace ahd
{

namespace
{

constexpr double kPi = 3.14159265358979323846;

/// sin(a) for |a| <= pi / 4.
double sineSeries(double a)
{
  const double b = -a * a;
  double sum = 0.0;
  for (int k = 19; k > 1; k -= 2)
  {
    sum = (sum + 1.0) * b / double(k * (k - 1));
  }
  return a * (sum + 1.0);
}

double cosineSeries(double a)
{
  const double b = -a * a;
  double sum = 0.0;
  for (int k = 20; k > 1; k -= 2)
  {
    sum = (sum + 1.0) * b / double(k * (k - 1));
  }
  return sum + 1.0;
}

} // namespace

Place inUnitSquare(Random& random)
{
  const double x = random.unit();
  return { x, random.unit() };
}

Place onUnitCircle(double turns)
{
  const int eighth = int(turns * 8.0);
  const int quarter = ((eighth + 1) / 2) % 4;
  const double a = (turns - double((eighth + 1) / 2) * 0.25) * (2.0 * kPi);
  const double c = cosineSeries(a);
  const double s = sineSeries(a);
  switch (quarter)
  {
    case 0:
      return { c, s };
    case 1:
      return { -s, c };
    case 2:
      return { -c, -s };
    default:
      return { s, -c };
  }
}

Place placeOfSet(std::uint64_t set, std::uint64_t k)
{
  Random random(set ^ (0x5851F42D4C957F2Dull * (k + 1)));
  return inUnitSquare(random);
}

Place onLattice(std::size_t i, std::size_t side)
{
  return { double(i % side), double(i / side) };
}

std::size_t latticeSide(std::size_t n)
{
  const std::size_t side = std::size_t(std::sqrt(double(n)));
  return side * side < n ? side + 1 : side;
}

} // namespace ahd
