// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDPointOutput_h
#define vtkAHDPointOutput_h

#include "Engine/Core/Executor.h"
#include "Engine/Result.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkAbstractArray;
class vtkAHDProgress;
class vtkAHDWorkingPoints;
class vtkDataArray;
class vtkPointData;
class vtkPointSet;
class vtkPolyData;

/// Where a point that was added at the crossing of two segments comes from.
struct vtkAHDCrossing
{
  std::array<vtkIdType, 4> Ends; ///< the first and the second end of either segment
  std::array<double, 2> Along;   ///< the fraction of the way from the first end to the second
};

/**
 * The points and point data of the surface where points were added: a copy of the input's, in
 * double precision, with the added points behind them, and their values in all arrays.
 *
 * Added points have the values of the source's array of the same name and number of components if
 * they are points of the source, and what linear interpolation gives, as a mean over both segments,
 * if they are crossings; where there is no such value, NaN in arrays of floating point numbers, and
 * 0 or nothing in others. Ghost marks (vtkGhostType) are 0. Global and pedigree ids are -1, or 0 or
 * nothing where that cannot be had; they become arrays like others.
 */
class vtkAHDPointOutput
{
public:
  /// Borrows all of them. `source`: whose points were added first, or null. `crossings`: of those
  /// added last. `projected`: are the places of `points` others than the points' coordinates?
  vtkAHDPointOutput(vtkPointSet* input, vtkPointSet* source, const vtkAHDWorkingPoints& points,
    bool projected, const std::vector<vtkAHDCrossing>& crossings);

  /// Fills the points and point data of `output`. Returns Cancelled if the filter is to abort, else
  /// Ok. Throws std::bad_alloc if there is no room.
  ahd::Status Write(vtkPolyData* output, ahd::Executor& executor, vtkAHDProgress& progress) const;

  /// Upper estimate of the bytes that Write() allocates for so many points.
  static std::size_t EstimateBytes(vtkPointSet* input, std::size_t pointCount);

private:
  bool WritePoints(vtkPolyData* output, ahd::Executor& executor, vtkAHDProgress& progress) const;
  bool WriteData(vtkPointData* output, vtkAHDProgress& progress) const;
  bool WriteArray(vtkAbstractArray* array, vtkAbstractArray* from, vtkAHDProgress& progress) const;
  bool Interpolate(vtkDataArray* array, vtkAHDProgress& progress) const;

  vtkPointSet* const Input;
  vtkPointSet* const Source;
  const vtkAHDWorkingPoints& Points;
  const bool Projected;
  const std::vector<vtkAHDCrossing>& Crossings;
  const vtkIdType SourceCount;
  const vtkIdType FirstCrossing; // the id of the first of them
};

/// What linear interpolation gives at a crossing, as a mean over both segments; `value(id)` is the
/// value at a point.
template <typename Value>
double vtkAHDInterpolate(const vtkAHDCrossing& crossing, const Value& value)
{
  const auto along = [&](std::size_t k)
  {
    const double t = crossing.Along[k];
    return (1.0 - t) * value(crossing.Ends[2 * k]) + t * value(crossing.Ends[2 * k + 1]);
  };
  return 0.5 * along(0) + 0.5 * along(1);
}

#endif
