// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankSurface_h
#define vtkAHDRankSurface_h

#include "Engine/Distribute/BlockTriangulation.h"
#include "Ranks/vtkAHDRankPoints.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkAbstractArray;
class vtkPolyData;

/**
 * One rank's share of the surface: the triangles that it owns; its points, and behind them those of
 * other ranks that are corners of these triangles; the data of both.
 *
 * Collective; throws vtkAHDStop on all ranks if one cannot go on.
 */
class vtkAHDRankSurface
{
public:
  /// Borrows all of them.
  vtkAHDRankSurface(const vtkAHDSettings& settings, vtkAHDRanks& ranks, const vtkAHDAllFacts& facts,
    const vtkAHDContext& context, vtkAHDRankPoints& points, ahd::BlockTriangulation& triangulation);

  /// Finds out which of the triangles are put out: those that MaximumEdgeLength leaves. Not
  /// collective; throws as vtkAHDRanks::Together() wants it.
  void Select();
  /// How many these are.
  std::size_t GetCellCount() const { return this->Corners.size() / 3; }

  /// Fills the output. REQUIRES: Select(). `firstCell`: how many triangles the ranks before this
  /// one have.
  void Write(vtkPolyData* output, std::size_t firstCell);

  /// Upper estimate of the bytes that so many points take here.
  static std::size_t EstimateBytes(
    std::size_t pointCount, const vtkAHDSettings& settings, const vtkAHDAllFacts& facts);

private:
  void AskForForeign();
  void WritePlaces(vtkPolyData* output);
  void WriteData(vtkPolyData* output);
  void MoveData(const vtkAHDArrayFacts& facts, vtkPolyData* output);
  void WriteMarks(vtkPolyData* output);
  void WriteIds(vtkPolyData* output);
  void WriteStatus(vtkPolyData* output);
  void KeepShort();
  void KeepUsed();
  void WriteCells(vtkPolyData* output, std::size_t firstCell);

  const vtkAHDSettings& Settings;
  vtkAHDRanks& Ranks;
  const vtkAHDAllFacts& Facts;
  const vtkAHDContext& Context;
  vtkAHDRankPoints& Points;
  ahd::BlockTriangulation& Triangulation;
  vtkAHDRoute Foreign; // the way of the other ranks' points
  const std::size_t Own;
  std::size_t All;                       // points, with those of others
  std::vector<ahd::ForeignPoint> Others; // those of others, by id
  std::vector<vtkTypeInt32> Corners;
  std::vector<std::uint8_t> Edges; // of each triangle, those that are constraints; if asked for
};

#endif
