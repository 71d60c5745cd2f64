// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Moves_h
#define ahd_Moves_h

#include "FuzzCase.h"

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
  /// One of 0 to n - 1. REQUIRES: n > 0.
  std::size_t below(std::size_t n) { return std::size_t(engine_() >> 16) % n; }
  std::uint64_t bits() { return engine_(); }

private:
  std::mt19937_64 engine_;
};

/// Adds, removes or moves points: one unit in the last place, onto a line or circle of others, into
/// their rows and columns, to other exponents, all of them onto a lattice, mirrored, turned.
void movePoints(FuzzCase& mutated, Dice& dice);

/// Adds, removes or moves chains: through points, over others, across them, back and forth, loops
/// within loops.
void moveChains(FuzzCase& mutated, Dice& dice);

} // namespace fuzz
} // namespace ahd

#endif
