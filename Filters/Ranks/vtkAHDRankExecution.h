// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankExecution_h
#define vtkAHDRankExecution_h

#include "Engine/Distribute/BlockChains.h"
#include "Engine/Distribute/BlockRim.h"
#include "Execution/vtkAHDExecution.h"
#include "Execution/vtkAHDReport.h"
#include "Ranks/vtkAHDRankFacts.h"
#include "Ranks/vtkAHDRankPoints.h"
#include "Ranks/vtkAHDRanks.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkAHDRankSurface;

/// The result of an execution on several ranks: the same on all except times and the estimate.
struct vtkAHDRankResult
{
  vtkAHDReport Report;
  std::string Error;                 ///< reported by all, instead of the error of the status
  std::vector<std::string> Warnings; ///< reported by one rank
  std::string OneRank;               ///< the same, if one rank did all the work; else empty
};

/**
 * One execution on all ranks of a controller: each rank gives its points and constraints, and
 * gets its share of the triangulation of all (vtkAHDRankSurface). With settings that have no
 * method for several ranks, one of them gets all: vtkAHDGatheredExecution.
 */
class vtkAHDRankExecution
{
public:
  /// Borrows all of them.
  vtkAHDRankExecution(const vtkAHDSettings& settings, vtkAHDRanks& ranks,
    const vtkAHDContext& context, vtkAHDRankResult& result);

  /// Triangulates, and fills the surface. Collective: must be called by all ranks, also by those
  /// without data (Input may be null), or whose input failed (`before` is not Ok).
  /// The workspace is used if one rank does all the work. Throws vtkAHDStop and std::bad_alloc,
  /// on one rank or on all. @pre called within vtkAHDRanks::Execute().
  void Run(const vtkAHDDataSets& data, ahd::Status before, ahd::Workspace& workspace);

private:
  void Meet(const vtkAHDDataSets& data);
  void TriangulateOnOne(const vtkAHDDataSets& data, const char* setting, ahd::Workspace& workspace);
  [[noreturn]] void StopAll(ahd::Status reason, const std::string& error);
  void Triangulate(const vtkAHDDataSets& data);
  void CheckMemory(std::size_t bytes, const char* what);
  void CheckPoints(const vtkAHDRankPoints& points, const ahd::BlockChains& chains);
  void CheckBorder(ahd::BlockTriangulation& blocks, const ahd::BlockChains& chains);
  void MakeBlock(
    const vtkAHDRankPoints& points, const ahd::BlockChains& chains, ahd::BlockTriangulation& block);
  void CheckGhosts(std::size_t cells);
  void TakeGhosts(vtkAHDRankSurface& surface, std::size_t firstCell);
  void LookForInput(const ahd::BlockChains& chains, const vtkAHDRankSurface& surface);
  void FindStacks(const vtkAHDRankPoints& points, const ahd::BlocksReport& counts, bool& areStacked,
    bool& areOnLine);
  std::size_t ShareOdds(
    const vtkAHDRankPoints& points, const ahd::BlocksReport& counts, std::size_t triangles);
  void ReportOn(const ahd::BlockRim& rim);
  void ReportOn(const ahd::BlocksReport& counts, const ahd::BlockChains& chains);
  void WarnOfArrays();

  const vtkAHDSettings& Settings;
  vtkAHDRanks& Ranks;
  const vtkAHDContext& Context;
  vtkAHDRankResult& Made;
  vtkAHDReport& Report; // in it
  vtkAHDAllFacts Facts;
  std::size_t Estimate = 0;      // bytes, of this rank, as far as known
  std::size_t BlockEstimate = 0; // without ghosts
};

#endif
