// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Dice_h
#define ahd_Dice_h

#include <cstddef>
#include <cstdint>
#include <random>

namespace ahd
{
namespace fuzz
{

/// The mutator's source of chance.
class Dice
{
public:
  explicit Dice(unsigned seed)
    : engine_(seed)
  {
  }
  /// One of 0 to n - 1. @pre n > 0.
  std::size_t below(std::size_t n) { return std::size_t(engine_() >> 16) % n; }
  std::uint64_t bits() { return engine_(); }

private:
  std::mt19937_64 engine_;
};

} // namespace fuzz
} // namespace ahd

#endif
