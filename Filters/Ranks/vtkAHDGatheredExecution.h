// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDGatheredExecution_h
#define vtkAHDGatheredExecution_h

#include "Execution/vtkAHDExecution.h"
#include "Ranks/vtkAHDRankGather.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

/**
 * An execution for all ranks on one of them, for settings that ranks have no method for: it gathers
 * what all have, and puts out what one rank would that had it all. The others put out the same
 * arrays with nothing in them, and tell the same of it.
 */
class vtkAHDGatheredExecution
{
public:
  /// Borrows all of them. `setting`: the one that asks for it.
  vtkAHDGatheredExecution(const vtkAHDSettings& settings, vtkAHDRanks& ranks,
    const vtkAHDAllFacts& facts, const vtkAHDContext& context, const char* setting);

  /// Finds the rank that is to do it: the first if there is room on it, else the one with most.
  /// Returns why none can, in a sentence, or nothing. Fills Estimate and Limit of the report.
  /// Collective, as Run(); both throw vtkAHDStop on all ranks if one cannot go on.
  std::string FindHost(const vtkAHDDataSets& data, ahd::Workspace& workspace, vtkAHDReport& report);

  /// REQUIRES: FindHost() found one. The report is that of the one rank, on all of them.
  void Run(const vtkAHDDataSets& data, ahd::Workspace& workspace, vtkAHDReport& report);

  /// What there is to be said of it.
  std::string GetWarning() const;

private:
  struct Room // on one rank
  {
    std::int64_t Needed = 0; // KiB, as this rank estimates it: it is the first whose word counts
    std::int64_t Limit = 0;  // KiB
    bool IsByUser = false;
    std::int64_t Share = 0; // of the limit, where other ranks work on the same machine

    auto fields() { return std::tie(this->Needed, this->Limit, this->IsByUser, this->Share); }
  };

  std::size_t EstimateBytes(ahd::Workspace& workspace) const;
  Room FindRoom(ahd::Workspace& workspace) const;
  std::string Refuse(std::size_t rank, std::int64_t needed, const Room& room) const;
  void Execute(const vtkAHDOutputs& outputs, ahd::Workspace& workspace, vtkAHDReport& report);
  void ShareReport(vtkAHDReport& report);
  void ShareOutputs(const vtkAHDOutputs& outputs);

  const vtkAHDSettings& Settings;
  vtkAHDRanks& Ranks;
  const vtkAHDAllFacts& Facts;
  const vtkAHDContext& Context;
  const char* const Setting;
  vtkAHDRankGather Gather;
  std::size_t Host = 0;
};

#endif
