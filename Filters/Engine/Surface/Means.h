// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Means_h
#define ahd_Means_h

#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Result.h"
#include "Vectors.h"

#include <vector>

namespace ahd
{

class Triangulation;

/// Where the vertex of several points at one place is shown at their mean.
struct Mean
{
  Index id;         ///< the point that stands for the vertex
  Vector3 position; ///< the mean of all at its place that have a finite z
};

/// The means of all places with several points of which one at least has a finite z, by increasing
/// id. Of the points with a number below `count` only. `inSpace`: what is averaged, the same points
/// in space; z: that of the triangulated points. Each coordinate is the double
/// nearest to the exact mean: what all have in common is kept to the last bit, and the order of the
/// points has no say. Makes the tables it needs. Returns Ok, Cancelled or OutOfMemory.
Status findMeans(Triangulation& triangulation, std::size_t count, const PointView& inSpace,
  const Context& context, std::vector<Mean>& means);

} // namespace ahd

#endif
