// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDMessages_h
#define vtkAHDMessages_h

#include <cstddef>

class vtkAlgorithm;
struct vtkAHDReport;
struct vtkAHDSettings;
namespace ahd
{
struct BadCell;
}

/// Says that so many points are more than the engine takes.
void vtkAHDSayTooManyPoints(vtkAlgorithm* filter, std::size_t count);

/// Says that offsets of cells lie. `what` these are: null for a source on some rank.
void vtkAHDSayBadCells(vtkAlgorithm* filter, const char* what, const ahd::BadCell& bad);

/// Says in one error why an execution came to nothing, unless it was the user who cancelled.
void vtkAHDSayError(vtkAlgorithm* filter, const vtkAHDReport& report);

/// Warns of what there is to be warned of after an execution, each at most once.
void vtkAHDSayWarnings(
  vtkAlgorithm* filter, const vtkAHDSettings& settings, const vtkAHDReport& report);

#endif
