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

/// The error that there are too many points.
void vtkAHDSayTooManyPoints(vtkAlgorithm* filter, std::size_t count);

/// The error about invalid offsets of cells. `what`: their name; null for a source on some rank.
void vtkAHDSayBadCells(vtkAlgorithm* filter, const char* what, const ahd::BadCell& bad);

/// The error of a failed execution; none if the user cancelled.
void vtkAHDSayError(vtkAlgorithm* filter, const vtkAHDReport& report);

/// The warnings of an execution, each at most once. `limitIsTold`: not that InsertionLimit leaves
/// out segments.
void vtkAHDSayWarnings(vtkAlgorithm* filter, const vtkAHDSettings& settings,
  const vtkAHDReport& report, bool limitIsTold = false);

#endif
