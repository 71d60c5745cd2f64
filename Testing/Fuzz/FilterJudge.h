// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FilterJudge_h
#define ahd_FilterJudge_h

#include "FilterCase.h"

#include <string>

class vtkAdaptiveHilbertDelaunay2D;

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

} // namespace fuzz
} // namespace ahd

#endif
