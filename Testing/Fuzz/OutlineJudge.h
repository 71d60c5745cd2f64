// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_OutlineJudge_h
#define ahd_OutlineJudge_h

#include "FuzzCase.h"
#include "Points/Points.h"

#include <cstdint>
#include <vector>

namespace ahd
{
namespace fuzz
{

/// The outlines of triangles, counterclockwise, with numbers that differ: each edge between
/// triangles that are not joined is in it once, in simple rings, the outer one of a polygon first.
/// Then of cells with any ids of points in space: it has ids of points and cells only. Cancelled
/// and without memory it reports it.
void expectOutlines(
  const FuzzCase& given, const PointView& points, const std::vector<std::int32_t>& triples);

} // namespace fuzz
} // namespace ahd

#endif
