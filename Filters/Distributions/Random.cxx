// SPDX-License-Identifier: BSD-3-Clause
#include "Random.h"

namespace ahd
{

std::uint64_t Random::bits()
{
  std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

double Random::unit()
{
  return double(bits() >> 11) * 0x1p-53;
}

std::size_t Random::below(std::size_t n)
{
  return std::size_t(bits() % n);
}

double Random::bell()
{
  double sum = -6.0;
  for (int i = 0; i < 12; ++i)
  {
    sum += unit();
  }
  return sum;
}

} // namespace ahd
