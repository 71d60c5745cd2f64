// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDPointOutput_h
#define vtkAHDPointOutput_h

#include "Engine/Job/Run.h"
#include "vtkType.h"

#include <cstddef>

class vtkAbstractArray;
class vtkAHDContext;
class vtkAHDInput;
class vtkDataArray;
class vtkPointData;
class vtkPointSet;
class vtkPolyData;

/**
 * The points and point data of the surface: the input's, or, where points were added, a copy with
 * these behind, in double precision, and with their values in all arrays.
 *
 * Added points have the values of the source's array of the same name and number of components if
 * they are points of the source (or what linear interpolation gives where these are laid on the
 * surface of the input), and what linear interpolation gives, as a mean over both segments,
 * if they are crossings; where there is no such value, NaN in arrays of floating point numbers, and
 * 0 or nothing in others. Ghost marks (vtkGhostType) are 0. Global and pedigree ids are -1, or 0 or
 * nothing where that cannot be had; they become arrays like others.
 */
class vtkAHDPointOutput
{
public:
  /// Borrows all. `data`: null, or the input's points with other data in place of its own.
  /// REQUIRES: the input is open.
  vtkAHDPointOutput(
    const vtkAHDInput& input, const ahd::PreparedInput& points, vtkPointSet* data = nullptr);

  // Both throw vtkAHDStop if the filter is to abort, and std::bad_alloc if there is no room.

  /// `means`: null, or what was made of the points: then each place of several is at their mean.
  void WritePlaces(ahd::RunResult* means, vtkPolyData* output, const vtkAHDContext& context) const;
  void WriteData(vtkPointData* output, const vtkAHDContext& context) const;

  /// Upper estimate of the bytes that they allocate for so many points.
  static std::size_t EstimateBytes(vtkPointSet* input, std::size_t pointCount);

  /// Of these, those of the point data of one point.
  static std::size_t EstimateBytesPerPoint(vtkPointSet* input);

private:
  void WriteArray(
    vtkAbstractArray* array, vtkAbstractArray* from, const vtkAHDContext& context) const;

  const ahd::InputRequest& Opened;
  vtkPointSet* const Input;
  vtkPointSet* const Source;
  const ahd::PreparedInput& Points;
  const vtkIdType InputCount;
  const vtkIdType SourceCount;
  const vtkIdType Count; // of all points
};

#endif
