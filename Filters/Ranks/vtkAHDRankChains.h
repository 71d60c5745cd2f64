// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankChains_h
#define vtkAHDRankChains_h

#include "Engine/Constraints.h"
#include "Engine/Distribute/BlockBytes.h"
#include "Execution/vtkAHDReport.h"
#include "Ranks/vtkAHDRankPoints.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * The constraints of all ranks, as if their sources were appended: open lines, closed lines that
 * are loops, polygons; of each kind those of rank 0 first.
 */
class vtkAHDRankChains
{
public:
  /// Gathers them. Collective; throws vtkAHDStop on all ranks.
  void Gather(const vtkAHDRankPoints& points, vtkAHDRanks& ranks, const vtkAHDContext& context);

  /// In the ids that all ranks know.
  ahd::ConstraintView GetView() const;
  bool HaveLoops() const { return this->Offsets.size() > this->Lines + 1; }
  /// How many ids they have.
  std::size_t GetIdCount() const { return this->Ids.size(); }

  /// The cell of the appended source that a chain is made of.
  std::int64_t CellOf(std::size_t chain) const { return this->Cells[chain]; }
  /// What was found in all sources.
  const ahd::UnfitIds& GetUnfitIds() const { return this->Unfit; }
  const vtkAHDInput::SourceContent& GetContent() const { return this->Content; }

private:
  enum Kind : std::size_t
  {
    Open,
    Closed,
    Polygon,
    Kinds
  };
  struct Part // what one rank has
  {
    std::vector<std::int64_t> Ids[Kinds];
    std::vector<std::int64_t> Sizes[Kinds]; // of the chains
    std::vector<std::int64_t> Cells[Kinds]; // of the chains, from 0 for lines and for polygons
    std::int64_t LineCells = 0, PolygonCells = 0;
    vtkAHDInput::SourceContent Content;
    ahd::UnfitIds Unfit;
  };

  static void ReadOwn(const vtkAHDRankPoints& points, Part& own);
  static void Write(const Part& own, ahd::BlockBytes& bytes);
  static void Read(const ahd::BlockBytes& bytes, Part& part);
  void Append(const std::vector<Part>& parts);

  std::vector<std::int64_t> Ids;
  std::vector<std::int64_t> Offsets;
  std::vector<std::int64_t> Cells;
  std::size_t Lines = 0;
  ahd::UnfitIds Unfit;
  vtkAHDInput::SourceContent Content;
};

#endif
