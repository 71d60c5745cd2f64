// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ExactSigns_h
#define ahd_ExactSigns_h

#include "Points/Points.h"

#include <string>

namespace ahd
{
namespace test
{

/// The tests' own exact predicates. They share no line with the engine's: a filter in double, then
/// 128-bit integers where the differences allow it, then GMP integers for the rest.
/// Every finite double is legal.

/// Sign of the area of a, b, c: +1 counterclockwise, -1 clockwise, 0 collinear.
int orientSign(const Point& a, const Point& b, const Point& c);

/// +1 if d lies strictly inside the circle through a, b, c, -1 strictly outside, 0 on it.
/// @pre a, b, c counterclockwise.
int inCircleSign(const Point& a, const Point& b, const Point& c, const Point& d);

/// inCircleSign with ties broken as the engine promises: point k is lifted to x^2 + y^2 + eps_k,
/// where the eps_k are positive infinitesimals and that of a lexicographically larger point is
/// infinitely larger. +1 or -1, never 0. @pre a, b, c counterclockwise, d different from each.
int perturbedInCircleSign(const Point& a, const Point& b, const Point& c, const Point& d);

/// A point in hexadecimal, every bit of it: "(0x1p+0, -0x1.8p-3)".
std::string hexText(const Point& p);

} // namespace test
} // namespace ahd

#endif
