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
 * An execution for all ranks on one of them, for settings without a method for several ranks: it
 * gathers all inputs and outputs the result of a single rank. The others output the same
 * arrays without values, and report the same.
 */
class vtkAHDGatheredExecution
{
public:
  /// Borrows all of them. `setting`: the one that requires it.
  vtkAHDGatheredExecution(const vtkAHDSettings& settings, vtkAHDRanks& ranks,
    const vtkAHDAllFacts& facts, const vtkAHDContext& context, const char* setting);

  /// Chooses the rank: the first if it has the memory, else the one with most. Returns an error if
  /// none can, or nothing. Fills Estimate and Limit of the report.
  /// Collective, like Run(); both throw vtkAHDStop on all ranks if one fails.
  std::string FindHost(const vtkAHDDataSets& data, ahd::Workspace& workspace, vtkAHDReport& report);

  /// @pre FindHost() found one. The report is that of the one rank, on all of them.
  void Run(const vtkAHDDataSets& data, ahd::Workspace& workspace, vtkAHDReport& report);

  /// The warning about it.
  std::string GetWarning() const;

private:
  struct Room // on one rank
  {
    std::int64_t Needed = 0; // KiB, this rank's estimate: that of the first counts
    std::int64_t Limit = 0;  // KiB
    bool IsByUser = false;
    std::int64_t Share = 0; // of the limit, if other ranks run on the same machine

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
