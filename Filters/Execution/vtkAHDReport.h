// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDReport_h
#define vtkAHDReport_h

#include "Engine/Job/RunReport.h"
#include "Input/vtkAHDInput.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

/// The report of one execution, returned at its end.
struct vtkAHDReport : ahd::RunReport
{
  ahd::BadCell BadCell;             ///< if the status is BadCells
  const char* BadCellsOf = nullptr; ///< the name of these cells; null: of another rank

  // The rest means something if the status is Ok.
  /// There is no triangle, and it is not known whether there was one before loops dropped all.
  bool MayBeEmptiedByLoops = false;
  std::vector<std::array<std::int64_t, 2>> CrossingCells; ///< of all left out, over ranks
  bool MarksAreUnfit = false;
  std::vector<std::string> UnfitNumbers; ///< names of arrays
  vtkAHDInput::SourceContent Source;
  bool IsDiagramInPlane = false; ///< because the transform has no inverse

  /// The estimated memory, KiB.
  vtkTypeInt64 GetEstimate() const { return static_cast<vtkTypeInt64>(this->estimate / 1024); }
  /// The limit on memory, KiB.
  vtkTypeInt64 GetLimit() const { return static_cast<vtkTypeInt64>(this->allowed / 1024); }

  /// All but BadCell and BadCellsOf.
  auto fields()
  {
    return std::tuple_cat(ahd::RunReport::fields(),
      std::tie(this->MayBeEmptiedByLoops, this->CrossingCells, this->MarksAreUnfit,
        this->UnfitNumbers, this->Source, this->IsDiagramInPlane));
  }
};
static_assert(ahd::countFields<vtkAHDReport>() + 1 + 2 ==
    ahd::countFields<ahd::RunReport>() + ahd::countMembers<vtkAHDReport>(),
  "what fields() leaves out is not sent to other ranks");

#endif
