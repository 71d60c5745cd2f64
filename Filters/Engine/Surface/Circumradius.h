// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Circumradius_h
#define ahd_Circumradius_h

#include "Vectors.h"

namespace ahd
{

/// The length of a vector. Neither overflows nor underflows before it has to.
double lengthOf(const Vector3& v);

/// The radius of the circle through three points in space; 1e299 if it is larger or there is none,
/// as they are collinear. Neither overflows nor underflows before that.
double circumradius(const Vector3& a, const Vector3& b, const Vector3& c);

} // namespace ahd

#endif
