// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobJudge_h
#define ahd_JobJudge_h

#include "ConstraintSets.h"
#include "FuzzCase.h"

#include <cstdint>
#include <vector>

namespace ahd
{
namespace fuzz
{

/// Points, with chains or without, and the triangles that the engine makes of them.
struct JobCase
{
  PointView points;
  ConstraintView chains;
  FillRule rule = FillRule::Orientation;
  const std::vector<std::int32_t>& triples;
};

/// The same triangles come through the C interface. Then the case's bytes switch on its other
/// features, alone or together, with memory that may run out and a callback that may cancel: the
/// status reports it, and arrays have numbers of existing points and cells.
void expectSameThroughC(const FuzzCase& given, const JobCase& made);

} // namespace fuzz
} // namespace ahd

#endif
