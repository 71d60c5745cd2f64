// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankGhosts_h
#define vtkAHDRankGhosts_h

#include "Engine/Distribute/BlockTriangulation.h"
#include "Pipeline/vtkAHDArray.h"
#include "Ranks/vtkAHDRankPoints.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkTypeInt32Array.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// Triangles of one rank: their corners by number, the lowest first. Numbers are those of
/// ahd::BlockTriangulation: own points, behind them its foreign ones.
struct vtkAHDRankTriangles
{
  vtkSmartPointer<vtkTypeInt32Array> Corners; ///< three of each; null where there are none
  std::vector<std::uint8_t> Edges;            ///< of each, those that are constraints; if asked for
  std::size_t Inside = 0; ///< so many, the first ones, have no point of other ranks

  std::size_t GetCount() const
  {
    return this->Corners ? static_cast<std::size_t>(this->Corners->GetNumberOfValues()) / 3 : 0;
  }
  /// The three corners of a triangle, and those of all behind it.
  vtkTypeInt32* At(std::size_t triangle) const
  {
    return this->Corners->GetPointer(0) + 3 * triangle;
  }
  /// Keeps what there is. Throws std::bad_alloc.
  void Resize(std::size_t count)
  {
    const auto numbers = static_cast<vtkIdType>(3 * count);
    if (this->Corners)
    {
      vtkAHDResizeArray(this->Corners.Get(), numbers);
    }
    else
    {
      this->Corners = vtkAHDNewArray<vtkTypeInt32Array>(numbers);
    }
  }
  /// Keeps those whose byte is not 0, in order.
  void Keep(const unsigned char* kept);
};

/**
 * Triangles of other ranks around those of this one, in layers. The first: all that share a point
 * with a triangle of this rank, or have one that it owns; each further one: all that share a point
 * with the one before.
 *
 * The owner of a point knows all triangles around it: so a layer is one question to the owners of
 * the points at its inside. Collective; throws vtkAHDStop on all ranks if one cannot go on.
 */
class vtkAHDRankGhosts
{
public:
  /// Borrows all of them. `own`: the triangles of this rank. `around`: those of others that have a
  /// point of its own. Both in the engine's order, the same ones left out on all ranks.
  vtkAHDRankGhosts(vtkAHDRanks& ranks, const vtkAHDContext& context, const vtkAHDRankPoints& points,
    const ahd::BlockTriangulation& triangulation, const vtkAHDRankTriangles& own,
    const vtkAHDRankTriangles& around);

  struct Corner
  {
    std::int64_t Id; ///< by which all ranks know the point
    std::uint64_t Rank;
  };
  struct Cell
  {
    Corner Corners[3];
    std::int64_t Id; ///< of the cell, on all ranks
    std::uint64_t Edges;
  };

  /// Learns the ids of the cells around. `firstCell`: that of this rank's first triangle.
  void Begin(std::size_t firstCell);
  /// Asks for the next layer, and learns how many cells will come. REQUIRES: Begin().
  void Ask();
  /// How many ghosts there are, and are to come or to go, at most.
  std::size_t CountAll() const { return this->Cells.size() + this->Coming + this->Going; }
  /// Takes the layer. REQUIRES: Ask().
  void Take();

  /// What was taken, by ascending id.
  const std::vector<Cell>& GetCells() const { return this->Cells; }
  /// Adds the corners of these that others own to points of others; those then are by id, each
  /// once. Not collective; throws as vtkAHDRanks::Together() wants it.
  void AddForeign(std::vector<Corner>& points) const;

  static bool IsBefore(const Corner& p, const Corner& q) { return p.Id < q.Id; }

private:
  using Messages = std::vector<ahd::BlockMessage>;
  using Numbers = std::vector<std::int64_t>;

  void StopIfAborted(std::size_t step) const;
  template <typename Item, typename Less, typename Same>
  void SortOnce(std::vector<Item>& items, const Less& isLess, const Same& isSame) const;
  Corner CornerOf(vtkTypeInt32 number) const;
  const vtkTypeInt32* CornersOf(std::size_t place) const;
  Cell CellOf(std::size_t place) const;
  bool HasPointOf(std::size_t rank, std::size_t place) const;
  void Exchange(std::vector<Numbers>& to, std::vector<Numbers>& from);
  void ListIds(std::vector<Numbers>& to) const;
  void ListNew(std::vector<Corner>& corners) const;
  void FindAnswers(const std::vector<Numbers>& asked);

  vtkAHDRanks& Ranks;
  const vtkAHDContext& Context;
  const vtkAHDRankPoints& Points;
  const std::vector<ahd::ForeignPoint>& Foreign;
  const vtkAHDRankTriangles& Own;
  const vtkAHDRankTriangles& Around;
  const std::size_t OwnPoints;

  std::int64_t FirstCell = 0;
  Numbers AroundIds; // of the cells
  std::vector<Cell> Cells;
  std::vector<Corner> Known; // points of others whose triangles came, by id
  bool HasLayer = false;
  std::vector<std::vector<std::size_t>> Answers; // for each rank, triangles by place
  std::size_t Coming = 0, Going = 0;
};

#endif
