// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankMemory_h
#define vtkAHDRankMemory_h

#include "Pipeline/vtkAHDSettings.h"
#include "Ranks/vtkAHDRankFacts.h"
#include "Ranks/vtkAHDRanks.h"

#include <cstddef>
#include <string>

/// The use of memory, for the error.
struct vtkAHDRankWork
{
  const char* Doing;      ///< such as "Triangulating"
  std::size_t Points;     ///< of all ranks
  const char* Share = ""; ///< a remark on the rank's share
};

/// Checks whether each rank has memory for its next allocation, `bytes` on this one. Empty if so;
/// else the error that all ranks report, which names the rank. Collective; throws vtkAHDStop on
/// all ranks if one fails.
std::string vtkAHDRefuseMemory(const vtkAHDSettings& settings, const vtkAHDAllFacts& facts,
  vtkAHDRanks& ranks, const vtkAHDContext& context, std::size_t bytes, const vtkAHDRankWork& work);

#endif
