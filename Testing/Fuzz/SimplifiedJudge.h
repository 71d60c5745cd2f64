// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SimplifiedJudge_h
#define ahd_SimplifiedJudge_h

#include "FilterCase.h"

#include <string>

namespace ahd
{
namespace fuzz
{

/// Has the surface only the points of its cells?
bool hasPointsOfCellsOnly(vtkAdaptiveHilbertDelaunay2D* filter);

/// Of such a surface, of `count` points with those that are left out: their ids, and that each has
/// a cell.
std::string faultOfPointsOfCells(vtkPolyData* surface, vtkIdType count);

/// Of a surface of one data set in the plane of x and y: a point of the input that is no corner,
/// yet has to stay, or lies farther from its triangle than allowed, or not as far as Error says.
/// Thin triangles, whose planes rounding decides, and points at one place are not looked at.
/// Measured in long double.
std::string faultOfSimplified(vtkAdaptiveHilbertDelaunay2D* filter, vtkPolyData* surface);

} // namespace fuzz
} // namespace ahd

#endif
