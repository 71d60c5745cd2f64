// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDFit_h
#define vtkAHDFit_h

#include "Engine/Core/Executor.h"
#include "Engine/Points/Points.h"
#include "Input/vtkAHDVectors.h"

class vtkAHDProgress;

/**
 * The plane with the least sum of squared distances from points (total least squares), not yet
 * turned to a side. A function of the points alone: neither their order nor the number of threads
 * changes a bit. Points that are skipped or have a coordinate that is not finite do not count.
 */
struct vtkAHDFit
{
  /// About one long; z if all points coincide or there is none. Of points on a line (up to the
  /// precision of their numbers) the one closest to z, or to y where the line's largest component
  /// is z.
  vtkAHDVector Normal = { { 0, 0, 1 } };

  /// A point close by from which the distance of every point is exact, along each coordinate.
  vtkAHDVector Origin = { { 0, 0, 0 } };

  /// Of the plane above Origin, along the normal.
  double Height = 0.0;

  /// A power of two; what has been multiplied with it can be added up.
  double Shrink = 1.0;

  /// Returns false if the filter is to abort. REQUIRES: points.stride is 3, the third number of
  /// each point is its z.
  bool Run(const ahd::PointView& points, ahd::Executor& executor, vtkAHDProgress& progress);
};

#endif
