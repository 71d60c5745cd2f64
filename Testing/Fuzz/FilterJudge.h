// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FilterJudge_h
#define ahd_FilterJudge_h

#include "FilterCase.h"

#include <string>

class vtkAdaptiveHilbertDelaunay2D;
class vtkCellArray;
class vtkDataSetAttributes;
class vtkFieldData;
class vtkIdTypeArray;

namespace ahd
{
namespace fuzz
{

/// All of a data set or of its blocks, as text to be compared: cells, points, arrays.
std::string textOf(vtkDataObject* data);

/// All outputs of the filter.
std::string outputsOf(vtkAdaptiveHilbertDelaunay2D* filter);

/// The faults of the outputs, by the filter's documentation; empty if none. `said`: the filter
/// ended in an error.
std::string faultOf(vtkAdaptiveHilbertDelaunay2D* filter, bool said);

// Parts of it, empty as well if there is no fault.

/// Cells of fewer or more points, or with ids of no point.
std::string faultOfCells(vtkCellArray* cells, vtkIdType points, vtkIdType least, vtkIdType most);

/// Arrays that are not of `count` tuples.
std::string faultOfArrays(vtkDataSetAttributes* data, vtkIdType count);

/// Their number, and `inPlane` their orientation.
std::string faultOfTriangles(vtkPolyData* surface, bool inPlane);

const vtkIdTypeArray* idsOf(vtkFieldData* data, const char* name);

/// A count in the field data; -1 if there is none.
vtkIdType countOf(vtkPolyData* surface, const char* what);

} // namespace fuzz
} // namespace ahd

#endif
