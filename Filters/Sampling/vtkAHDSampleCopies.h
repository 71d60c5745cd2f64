// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSampleCopies_h
#define vtkAHDSampleCopies_h

#include "Engine/Core/Uninitialised.h"
#include "Pipeline/vtkAHDContext.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <cstddef>

class vtkDoubleArray;

/// The numbers of an array as doubles: in place, or in `copy`. Throws vtkAHDStop and
/// std::bad_alloc, like all functions below.
const double* vtkAHDReadNumbers(
  vtkDataArray* array, ahd::UninitialisedVector<double>& copy, const vtkAHDContext& context);

/// Replaces each NaN of an array of doubles by `value`.
void vtkAHDFillNoValue(vtkDataArray* doubles, double value, const vtkAHDContext& context);

/// The same numbers as floats; finite ones that are too large become the largest.
vtkSmartPointer<vtkDataArray> vtkAHDAsFloats(vtkDataArray* doubles, const vtkAHDContext& context);

/// The point whose values each place gets.
struct vtkAHDGathered
{
  const double* Ids; ///< NaN: none
  std::size_t Count;
  double NoValue; ///< in arrays of floating-point numbers, also for NaN; others have 0
};

/// Must an array be copied before gathering, because its numbers are not contiguous?
bool vtkAHDIsCopiedToGather(vtkDataArray* array);

/// An array of the same type. `missing` grows by the values of points that are NaN.
vtkSmartPointer<vtkDataArray> vtkAHDGather(vtkDataArray* from, const vtkAHDGathered& gathered,
  const vtkAHDContext& context, std::size_t& missing);

/// The same for the heights of the points.
vtkSmartPointer<vtkDataArray> vtkAHDGatherHeights(const double* heights,
  const vtkAHDGathered& gathered, const vtkAHDContext& context, std::size_t& missing);

/// Gives the components the names of those of `from`.
void vtkAHDNameComponents(vtkDataArray* from, vtkDataArray* to);

#endif
