// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankMemory_h
#define vtkAHDRankMemory_h

#include "Pipeline/vtkAHDSettings.h"
#include "Ranks/vtkAHDRankFacts.h"
#include "Ranks/vtkAHDRanks.h"

#include <cstddef>
#include <string>

/// What takes memory, in the words of its error.
struct vtkAHDRankWork
{
  const char* Doing;      ///< such as "Triangulating"
  std::size_t Points;     ///< of all ranks
  const char* Share = ""; ///< what else there is to say of the rank's share
};

/// Is there memory for what each rank is about to take, `bytes` on this one? Empty if there is;
/// else the error that all ranks say alike: which has too little. Collective; throws vtkAHDStop on
/// all ranks if one cannot go on.
std::string vtkAHDRefuseMemory(const vtkAHDSettings& settings, const vtkAHDAllFacts& facts,
  vtkAHDRanks& ranks, const vtkAHDContext& context, std::size_t bytes, const vtkAHDRankWork& work);

#endif
