// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDReport_h
#define vtkAHDReport_h

#include "Engine/Constraints.h"
#include "Engine/Core/Progress.h"
#include "Engine/Prepare/Prepare.h"
#include "Engine/Result.h"
#include "Input/vtkAHDInput.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// What there is to say of one execution; handed back once, at its end.
struct vtkAHDReport
{
  ahd::Status Status = ahd::Status::Cancelled;
  bool IsRefused = false;           ///< the estimate is above the limit
  std::size_t Points = 0;           ///< all, as far as they were known when it ended
  vtkTypeInt64 Estimate = 0;        ///< of memory, KiB
  vtkTypeInt64 Limit = 0;           ///< on memory, KiB
  bool IsLimited = false;           ///< it is MemoryLimit, and not what there is
  std::size_t MostBoxes = 0;        ///< for which there was memory
  std::size_t MostCrossings = 0;    ///< the same
  ahd::BadCell BadCell;             ///< where the status is BadCells
  const char* BadCellsOf = nullptr; ///< what these cells are; null: those of another rank

  // The rest means something if Status is Ok.
  ahd::Report Counts;
  ahd::ConstraintReport Constraints;
  std::size_t DelaunayTriangles = 0; ///< before constraints dropped some
  /// There is no triangle, and it is not known whether there was one before loops dropped all.
  bool MayBeEmptiedByLoops = false;
  std::size_t Triangles = 0; ///< put out
  std::size_t Cells = 0;     ///< put out
  std::size_t InputPoints = 0;
  std::size_t MergedPoints = 0;
  std::size_t AddedPoints = 0;
  std::size_t Crossings = 0;                              ///< that were split
  std::array<std::int64_t, 2> FirstCrossing = {};         ///< cells: left out, crossed
  std::vector<std::array<std::int64_t, 2>> CrossingCells; ///< of all left out, over ranks
  std::size_t BentConstraints = 0;                        ///< led through a vertex beside them
  std::int64_t FirstBentCell = 0;                         ///< of these, if there are any
  ahd::UnfitIds UnfitIds;
  ahd::OddPoints OddPoints;
  bool MarksAreUnfit = false;
  vtkAHDInput::SourceContent Source;
  std::size_t PointsOffSurface = 0; ///< of the source, where it is to be laid on that of the input
  bool AreOnOneLine = true;         ///< found out if there is no triangle
  bool AreStacked = false;          ///< found out if most points are duplicates
  bool IsDiagramInPlane = false;    ///< although the points are not: there is no way back
  std::array<double, ahd::kPhases> Seconds = {};
  int ThreadsUsed = 1;

  /// Wall-clock time of some phases.
  template <typename... Phases>
  double SecondsOf(Phases... phases) const
  {
    return (0.0 + ... + this->Seconds[std::size_t(phases)]);
  }
};

#endif
