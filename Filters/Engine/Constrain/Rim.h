// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Rim_h
#define ahd_Rim_h

#include "ConstrainedMesh.h"

#include <cstddef>

namespace ahd
{

/// Counts of trimming.
struct TrimmedRim
{
  std::size_t triangles = 0;
  std::size_t bareVertices = 0; ///< left in no triangle
  double area = 0.0;            ///< of these triangles, as a part of the convex hull's; rounded
};

/// Marks flat triangles at the rim as dropped: see trim() in Triangulate.h. Returns false if
/// cancelled. Throws std::bad_alloc. @pre a mesh with a triangle.
bool trimRim(ConstrainedMesh& mesh, Ticker& ticker, TrimmedRim& out);

} // namespace ahd

#endif
