// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Oracle_h
#define ahd_Oracle_h

#include "Points/Points.h"

#include <array>
#include <cstdint>
#include <set>
#include <vector>

namespace ahd
{
namespace test
{

/// The ids of a triangle's corners, counterclockwise, the smallest first.
using Triple = std::array<std::int32_t, 3>;

/// The same triangle, its smallest id first.
Triple smallestFirst(const Triple& triple);

/// The flat array `triples` as a set.
std::set<Triple> asSet(const std::vector<std::int32_t>& triples);

/// The engine's contract by brute force: all counterclockwise triples of the distinct finite points
/// whose circle contains no other point, decided in rational arithmetic. The points are lifted to
/// heights x^2 + y^2 + eps_k, the eps_k being infinitesimals, each infinitely smaller than that of
/// the next point in lexicographic order. Coincident points go by their smallest id.
/// Cost: n^4. @pre n small (up to a few dozen).
std::set<Triple> delaunayByDefinition(const std::vector<Point>& points);

} // namespace test
} // namespace ahd

#endif
