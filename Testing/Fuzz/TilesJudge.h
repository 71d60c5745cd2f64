// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TilesJudge_h
#define ahd_TilesJudge_h

#include "Constraints.h"
#include "FuzzCase.h"
#include "Result.h"

#include <cstdint>
#include <vector>

namespace ahd
{
namespace fuzz
{

/// Leaf by leaf, with leaves by the case's bytes, the triangles are those of one run. Of few
/// points.
void expectTiles(const FuzzCase& given, const std::vector<Point>& points,
  const ConstraintView& chains, FillRule rule, const std::vector<std::int32_t>& triples);

} // namespace fuzz
} // namespace ahd

#endif
