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
 * One rank's share of the surface: the triangles that it owns, followed by the requested layers of
 * ghosts; its points, followed by those of other ranks that are corners of
 * these triangles; the data of both.
 *
 * Collective; throws vtkAHDStop on all ranks if one fails.
 */
class vtkAHDRankSurface
{
public:
  /// Borrows all of them.
  vtkAHDRankSurface(const vtkAHDSettings& settings, vtkAHDRanks& ranks, const vtkAHDAllFacts& facts,
    const vtkAHDContext& context, vtkAHDRankPoints& points, ahd::BlockTriangulation& triangulation);

  /// Selects the output triangles: those within MaximumEdgeLength, or not removed by
  /// trimming.
  void Select();
  /// The number of these, without ghosts.
  std::size_t GetCellCount() const { return this->Stars.own.count; }

  /// Is a point of any rank's input a corner of these? @pre Select(), not yet Write().
  bool HasPointOfInput() const;

  /// The triangles removed by trimming. @pre Select().
  const ahd::BlockRim& GetRim() const { return this->Rim; }

  /// The layers of ghosts. @pre Select(), and GhostLevels.
  ahd::BlockGhosts& GetGhosts() { return this->Ghosts; }

  /// Fills the output, with the ghosts. @pre Select(). `firstCell`: the number of
  /// triangles of the ranks before this one.
  void Write(vtkPolyData* output, std::size_t firstCell);

  /// Upper estimate of the bytes for so many points.
  static std::size_t EstimateBytes(
    std::size_t pointCount, const vtkAHDSettings& settings, const vtkAHDAllFacts& facts);
  /// The same for so many ghosts.
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
  vtkAHDRoute Foreign; // the route of the other ranks' points
  const std::size_t Own;
  std::size_t All; // points, with those of others
  Triangles Cells, Around;
  ahd::BlockStars Stars;          // of these
  std::vector<ahd::Point> Places; // of own points, then foreign ones, in the plane
  ahd::BlockRim Rim;
  ahd::BlockGhosts Ghosts;
  vtkSmartPointer<vtkAbstractArray> Status;
  std::vector<ahd::BlockPoint> Others; // points of others that are corners here, by id
};

#endif
