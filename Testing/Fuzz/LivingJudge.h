// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_LivingJudge_h
#define ahd_LivingJudge_h

#include "ConstraintMakers.h"
#include "FuzzCase.h"
#include "Result.h"

namespace ahd
{
namespace fuzz
{

/// Refines the triangulation by the case's bytes: the result is the fresh constrained triangulation
/// of its points and pieces, what is not named as bad meets the request, and no piece is encroached
/// that is not counted (RefineCase.h). Then a history of edits over the places, each outcome and
/// the last state beside a fresh run (EditHistory.h). Of few points; the first breach ends the
/// program.
void expectLiving(const FuzzCase& given, const test::ConstraintCase& from, FillRule rule);

} // namespace fuzz
} // namespace ahd

#endif
