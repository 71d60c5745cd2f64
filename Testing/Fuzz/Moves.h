// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Moves_h
#define ahd_Moves_h

#include "Dice.h"
#include "FuzzCase.h"

#include <cstddef>
#include <cstdint>
#include <random>

namespace ahd
{
namespace fuzz
{

/// Adds, removes or moves points: one unit in the last place, onto a line or circle of others, into
/// their rows and columns, to other exponents, all of them onto a lattice, mirrored, turned.
void movePoints(FuzzCase& mutated, Dice& dice);

/// Adds, removes or moves chains: through points, over others, across them, back and forth, loops
/// within loops.
void moveChains(FuzzCase& mutated, Dice& dice);

} // namespace fuzz
} // namespace ahd

#endif
