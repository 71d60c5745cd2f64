// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Bounding_h
#define ahd_Bounding_h

#include "../Surface/Vectors.h"

#include <array>

namespace ahd
{

/// The eight points that vtkDelaunay2D puts around others: on a circle about the centre of their
/// bounding box, from the direction of x counterclockwise in steps of 45 degrees, at the centre's
/// z; the radius is `offset` times the diagonal of the box in space. `low` and `high` are corners
/// of the box. Numbers too large for a double become the largest there is.
std::array<Vector3, 8> boundingPoints(const Vector3& low, const Vector3& high, double offset);

} // namespace ahd

#endif
