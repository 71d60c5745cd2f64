// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDReport_h
#define vtkAHDReport_h

#include "Engine/Core/Progress.h"
#include "Engine/Job/RunReport.h"
#include "Input/vtkAHDInput.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// The report of one execution, returned at its end.
struct vtkAHDReport : ahd::RunReport
{
  ahd::BadCell BadCell;             ///< if the status is BadCells
  const char* BadCellsOf = nullptr; ///< the name of these cells; null: of another rank

  // The rest means something if the status is Ok.
  /// There is no triangle, and it is not known whether there was one before loops dropped all.
  bool MayBeEmptiedByLoops = false;
  std::size_t Triangles = 0;                              ///< of the output
  std::size_t Cells = 0;                                  ///< of the output
  std::vector<std::array<std::int64_t, 2>> CrossingCells; ///< of all left out, over ranks
  bool MarksAreUnfit = false;
  vtkAHDInput::SourceContent Source;
  bool IsDiagramInPlane = false; ///< because the transform has no inverse
  std::array<double, ahd::kPhases> Seconds = {};

  /// The estimated memory, KiB.
  vtkTypeInt64 GetEstimate() const { return static_cast<vtkTypeInt64>(this->estimate / 1024); }
  /// The limit on memory, KiB.
  vtkTypeInt64 GetLimit() const { return static_cast<vtkTypeInt64>(this->allowed / 1024); }

  /// Wall-clock time of some phases.
  template <typename... Phases>
  double SecondsOf(Phases... phases) const
  {
    return (0.0 + ... + this->Seconds[std::size_t(phases)]);
  }
};

#endif
