// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSampleCopies_h
#define vtkAHDSampleCopies_h

#include "Engine/Core/Uninitialised.h"
#include "Pipeline/vtkAHDContext.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <cstddef>

class vtkDoubleArray;

/// The numbers of an array as doubles: where they lie, or in `copy`. Throws vtkAHDStop and
/// std::bad_alloc, as all below.
const double* vtkAHDReadNumbers(
  vtkDataArray* array, ahd::UninitialisedVector<double>& copy, const vtkAHDContext& context);

/// Puts `value` in place of each NaN of an array of doubles.
void vtkAHDFillNoValue(vtkDataArray* doubles, double value, const vtkAHDContext& context);

/// The same numbers as floats; those that are too large become the largest, but infinite ones.
vtkSmartPointer<vtkDataArray> vtkAHDAsFloats(vtkDataArray* doubles, const vtkAHDContext& context);

/// Which point's values each place is to have.
struct vtkAHDGathered
{
  const double* Ids; ///< NaN: none
  std::size_t Count;
  double NoValue; ///< in arrays of floating-point numbers, also for NaN; others have 0
};

/// Is an array that is gathered copied before, as its numbers do not lie one after the other?
bool vtkAHDIsCopiedToGather(vtkDataArray* array);

/// An array of the same type. `missing` grows by the values of points that are NaN.
vtkSmartPointer<vtkDataArray> vtkAHDGather(vtkDataArray* from, const vtkAHDGathered& gathered,
  const vtkAHDContext& context, std::size_t& missing);

/// The same of the heights of the points.
vtkSmartPointer<vtkDataArray> vtkAHDGatherHeights(const double* heights,
  const vtkAHDGathered& gathered, const vtkAHDContext& context, std::size_t& missing);

/// Names the components as those of `from` are.
void vtkAHDNameComponents(vtkDataArray* from, vtkDataArray* to);

#endif
