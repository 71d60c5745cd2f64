// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ConstraintFamilies_h
#define ahd_ConstraintFamilies_h

#include "ConstraintMakers.h"

#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// Points with constraints for which some order of insertion, or processing each on its own, takes
/// quadratic time. The same on every platform.
struct ConstraintFamily
{
  std::string name;
  ConstraintCase given;
  bool split = false; ///< they cross, and must be split there
};

/// Of about n points each. Only those that must be split cross.
std::vector<ConstraintFamily> constraintFamilies(std::size_t n);

/// About n points in some rows, segments between successive rows and along them in some order, some
/// twice: or bundles of parallel segments that must be split.
ConstraintFamily randomFamily(std::uint64_t seed, std::size_t n);

/// Two columns of n / 2 points, and n / 4 segments from one to the other that climb as far as that.
ConstraintCase ladder(std::size_t n, double width);

/// The ladder, and one segment across so many of its rungs, the first or the last of all.
ConstraintCase crossedLadder(std::size_t n, std::size_t rungs, bool isFirst);

/// n / 2 segments on one line of n vertices, each within the one before; and one segment across the
/// line at a part of it, the first or the last of all.
ConstraintCase crossedNested(std::size_t n, double part, bool isFirst);

/// The chains in another order. @pre lines only.
ConstraintCase backwards(const ConstraintCase& given);
ConstraintCase shuffled(const ConstraintCase& given, std::uint64_t seed);

} // namespace test
} // namespace ahd

#endif
