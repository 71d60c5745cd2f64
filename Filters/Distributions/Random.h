// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Random_h
#define ahd_Random_h

#include <cstddef>
#include <cstdint>

namespace ahd
{

/// Small generator of random numbers (splitmix64): the same sequence on every platform.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : state_(seed)
  {
  }
  std::uint64_t bits();
  double unit();                    ///< in [0, 1), multiples of 2^-53
  std::size_t below(std::size_t n); ///< in [0, n), n > 0
  double bell();                    ///< mean 0, deviation 1, within 6 (sum of 12 units, less 6)

private:
  std::uint64_t state_;
};

} // namespace ahd

#endif
