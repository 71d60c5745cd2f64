// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Stages_h
#define ahd_Stages_h

#include "Predicates.h"

#include <optional>

/// The stages of the predicates, cheapest first. Each answers with the exact sign or not at all;
/// the last one always answers. For Predicates.cxx and its tests only.
///
/// - Filter: double arithmetic with an error bound (Filters.h). Nearly all calls end here.
/// - Grid: the vectors to the last point are multiples of one power of two and fit into 61 bits
///   then. They become 64-bit integers and the determinant one of 128 or 256 bits. Lattices,
///   decimals, map coordinates and float data end here, and neighbours in most other data.
/// - Unbounded: integers as long as the exponents require, up to the whole range of double.
///
/// Filter and Grid assume rounding to nearest and subnormal numbers kept (no flush to zero);
/// Unbounded works on the bits of the numbers and assumes nothing. Fused multiply-adds harm none of
/// them: the filters are proven with and without, and Grid multiplies only by powers of two.
namespace ahd::stages
{

std::optional<int> orient2dByFilter(const Point& a, const Point& b, const Point& c);
std::optional<int> orient2dOnGrid(const Point& a, const Point& b, const Point& c);
int orient2dUnbounded(const Point& a, const Point& b, const Point& c);

std::optional<int> inCircleByFilter(const Point& a, const Point& b, const Point& c, const Point& d);
std::optional<int> inCircleOnGrid(const Point& a, const Point& b, const Point& c, const Point& d);
int inCircleUnbounded(const Point& a, const Point& b, const Point& c, const Point& d);

/// The sign of 2 (A x B) + A . B, where A, B run from c to a, b: -1 if a, b, c is flat there.
std::optional<int> flatnessByFilter(const Point& a, const Point& b, const Point& c);
std::optional<int> flatnessOnGrid(const Point& a, const Point& b, const Point& c);
int flatnessUnbounded(const Point& a, const Point& b, const Point& c);

/// Is d in conflict with the counterclockwise triangle a, b, c on whose circle it lies?
bool conflictOnCircle(const Point& a, const Point& b, const Point& c, const Point& d);

} // namespace ahd::stages

#endif
