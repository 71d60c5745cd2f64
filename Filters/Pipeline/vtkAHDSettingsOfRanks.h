// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSettingsOfRanks_h
#define vtkAHDSettingsOfRanks_h

#include <string>
#include <utility>
#include <vector>

/// A filter's settings that must be the same on all ranks. Empty on a single rank. Names of
/// settings are literals.
struct vtkAHDSettingsOfRanks
{
  std::vector<std::pair<const char*, double>> Numbers; ///< by name; of a list each
  std::vector<std::string> Texts;                      ///< names of arrays
  std::vector<const char*> OnOneRank; ///< those set with which one rank works for all
};

#endif
