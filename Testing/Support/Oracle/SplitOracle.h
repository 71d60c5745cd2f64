// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SplitOracle_h
#define ahd_SplitOracle_h

#include "Crossings/Crossings.h"

namespace ahd
{
namespace test
{

/// The expected result of splitAtCrossings(), except SplitConstraints::bent, by the simple
/// algorithm. Each round searches all pieces by strips (Crossings/SplitFind.h) and lists every pair
/// that crosses.
Status splitBySearchingAll(
  const PointView& points, const ConstraintView& chains, SplitConstraints& out);

} // namespace test
} // namespace ahd

#endif
