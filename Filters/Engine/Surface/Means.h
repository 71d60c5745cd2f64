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

/// The mean of several points at one place, where the vertex is shown.
struct Mean
{
  Index id;         ///< the point that stands for the vertex
  Vector3 position; ///< the mean of all at its place that have a finite z
};

/// The means of all places with several points of which at least one has a finite z, by increasing
/// id. Each coordinate is the double nearest to the exact mean: common values are kept to the last
/// bit, and the order of the points does not matter. Makes the missing tables.
///
/// @param count only points with a smaller number
/// @param inSpace the coordinates to average: the same points in space; z is that of the
///   triangulated points
/// @return Ok, Cancelled or OutOfMemory
Status findMeans(Triangulation& triangulation, std::size_t count, const PointView& inSpace,
  const Context& context, std::vector<Mean>& means);

} // namespace ahd

#endif
