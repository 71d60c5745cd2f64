// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDBounding_h
#define vtkAHDBounding_h

#include "Input/vtkAHDVectors.h"

/// The eight points that vtkDelaunay2D puts around others: on a circle about the centre of their
/// bounding box, from the direction of x counterclockwise in steps of 45 degrees, at the centre's
/// z; the radius is `offset` times the diagonal of the box in space. `low` and `high` are corners
/// of the box. Numbers too large for a double become the largest there is.
std::array<vtkAHDVector, 8> vtkAHDMakeBounding(
  const vtkAHDVector& low, const vtkAHDVector& high, double offset);

#endif
