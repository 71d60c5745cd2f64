// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankSurface_h
#define vtkAHDRankSurface_h

#include "Engine/Distribute/BlockGhosts.h"
#include "Engine/Distribute/BlockRim.h"
#include "Ranks/vtkAHDRankPoints.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt32Array.h"

#include <cstddef>
#include <cstdint>
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
  std::size_t GetCellCount() const { return this->Stars.own.count; }

  /// What trimming took away. REQUIRES: Select().
  const ahd::BlockRim& GetRim() const { return this->Rim; }

  /// The layers of ghosts. REQUIRES: Select(), and GhostLevels.
  ahd::BlockGhosts& GetGhosts() { return this->Ghosts; }

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
  /// Triangles of one kind.
  struct Triangles
  {
    vtkSmartPointer<vtkTypeInt32Array> Corners;
    std::vector<std::uint8_t> Edges;
  };

  void WritePlaces(vtkPolyData* output);
  void FindMeans(std::vector<ahd::Mean>& means);
  void WriteData(vtkPolyData* output);
  void MoveData(const vtkAHDArrayFacts& facts, vtkPolyData* output);
  void WriteMarks(vtkPolyData* output);
  void WriteIds(vtkPolyData* output);
  void Open(std::size_t count, Triangles& triangles, ahd::BlockTriangles& view) const;
  void ReadTriangles();
  void MakeStatus();
  void ReadAround();
  void ListPlaces();
  void KeepShort(ahd::BlockTriangles& triangles) const;
  void ListOthers();
  vtkTypeInt32 NumberOf(const ahd::BlockPoint& corner) const;
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
  Triangles Cells, Around;
  ahd::BlockStars Stars;          // of these
  std::vector<ahd::Point> Places; // of own points, then foreign ones, as they are triangulated
  ahd::BlockRim Rim;
  ahd::BlockGhosts Ghosts;
  vtkSmartPointer<vtkAbstractArray> Status;
  std::vector<ahd::BlockPoint> Others; // points of others that are corners here, by id
};

#endif
