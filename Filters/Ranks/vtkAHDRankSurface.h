// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankSurface_h
#define vtkAHDRankSurface_h

#include "Engine/Distribute/BlockTriangulation.h"
#include "Ranks/vtkAHDRankGhosts.h"
#include "Ranks/vtkAHDRankPoints.h"
#include "Ranks/vtkAHDRankRim.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

namespace ahd
{
struct Mean;
}
class vtkAbstractArray;
class vtkDataArray;
class vtkPolyData;

/**
 * One rank's share of the surface: the triangles that it owns and, behind them, the layers of
 * ghosts that are asked for; its points, and behind them those of other ranks that are corners of
 * these triangles; the data of both.
 *
 * Collective; throws vtkAHDStop on all ranks if one cannot go on.
 */
class vtkAHDRankSurface
{
public:
  /// Borrows all of them.
  vtkAHDRankSurface(const vtkAHDSettings& settings, vtkAHDRanks& ranks, const vtkAHDAllFacts& facts,
    const vtkAHDContext& context, vtkAHDRankPoints& points, ahd::BlockTriangulation& triangulation);

  /// Finds out which of the triangles are put out: those that MaximumEdgeLength leaves, or
  /// trimming.
  void Select();
  /// How many these are, ghosts not counted.
  std::size_t GetCellCount() const { return this->Cells.GetCount(); }

  /// What trimming took away. REQUIRES: Select().
  const vtkAHDRankRim& GetRim() const { return this->Rim; }

  /// The layers of ghosts. REQUIRES: Select(), and GhostLevels.
  vtkAHDRankGhosts& GetGhosts() { return this->Ghosts; }

  /// Fills the output, with the ghosts that were taken. REQUIRES: Select(). `firstCell`: how many
  /// triangles the ranks before this one have.
  void Write(vtkPolyData* output, std::size_t firstCell);

  /// Upper estimate of the bytes that so many points take here.
  static std::size_t EstimateBytes(
    std::size_t pointCount, const vtkAHDSettings& settings, const vtkAHDAllFacts& facts);
  /// Of the bytes that so many ghosts take.
  static std::size_t EstimateGhostBytes(
    std::size_t cellCount, const vtkAHDSettings& settings, const vtkAHDAllFacts& facts);

private:
  void AskForForeign();
  void WritePlaces(vtkPolyData* output);
  void FindMeans(std::vector<ahd::Mean>& means);
  void WriteData(vtkPolyData* output);
  void MoveData(const vtkAHDArrayFacts& facts, vtkPolyData* output);
  void WriteMarks(vtkPolyData* output);
  void WriteIds(vtkPolyData* output);
  void ReadTriangles();
  void MakeStatus();
  void ReadAround();
  void ListPlaces();
  void KeepShort(vtkAHDRankTriangles& cells) const;
  void ListOthers();
  vtkTypeInt32 NumberOf(const vtkAHDRankGhosts::Corner& corner) const;
  void WriteCorners(vtkPolyData* output);
  void WriteCells(vtkPolyData* output, std::size_t firstCell);

  const vtkAHDSettings& Settings;
  vtkAHDRanks& Ranks;
  const vtkAHDAllFacts& Facts;
  const vtkAHDContext& Context;
  vtkAHDRankPoints& Points;
  ahd::BlockTriangulation& Triangulation;
  vtkAHDRoute Foreign; // the way of the other ranks' points
  const std::size_t Own;
  std::size_t All; // points, with those of others
  vtkAHDRankTriangles Cells, Around;
  std::vector<ahd::Point> Places; // of own points, then foreign ones, as they are triangulated
  vtkAHDRankRim Rim;
  vtkAHDRankGhosts Ghosts;
  vtkSmartPointer<vtkAbstractArray> Status;
  std::vector<vtkAHDRankGhosts::Corner> Others; // points of others that are corners here, by id
};

#endif
