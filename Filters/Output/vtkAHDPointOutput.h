// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDPointOutput_h
#define vtkAHDPointOutput_h

#include "Engine/Job/Run.h"
#include "Engine/Refine/Refine.h"
#include "vtkType.h"

#include <cstddef>
#include <vector>

class vtkAbstractArray;
class vtkAHDContext;
class vtkAHDInput;
class vtkDataArray;
class vtkPointData;
class vtkPointSet;
class vtkPolyData;

/**
 * The points and point data of the surface: the input's, or, if points were added, a copy followed
 * by these, in double precision, and with their values in all arrays.
 *
 * Added points have the values of the source's array of the same name and number of components if
 * they are points of the source (or linearly interpolated values if these are laid on the
 * surface of the input), and the mean of the values interpolated linearly along both segments
 * if they are crossings; without such a value, NaN in arrays of floating-point numbers, and
 * 0 or empty in others. Ghost marks (vtkGhostType) are 0. Global and pedigree ids are -1, or 0 or
 * empty if the type has no -1; they become ordinary arrays.
 */
class vtkAHDPointOutput
{
public:
  /// Borrows all. `data`: null, or the input's points with other data in place of its own.
  /// @pre the input is open.
  vtkAHDPointOutput(
    const vtkAHDInput& input, const ahd::PreparedInput& points, vtkPointSet* data = nullptr);

  // Both throw vtkAHDStop on an abort, and std::bad_alloc.

  /// `means`: null, or the prepared points: then coinciding points are at their mean.
  void WritePlaces(ahd::RunResult* means, vtkPolyData* output, const vtkAHDContext& context) const;
  void WriteData(vtkPointData* output, const vtkAHDContext& context) const;

  /// The data of so many points, and after them those of points that refine() added: their values
  /// in between, as above.
  static void AddRefined(vtkPointData* given, vtkIdType count,
    const std::vector<ahd::SteinerPoint>& added, vtkPointData* output,
    const vtkAHDContext& context);

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
