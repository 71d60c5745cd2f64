// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankPart_h
#define vtkAHDRankPart_h

#include "Engine/Constraints.h"
#include "Engine/Points/Points.h"
#include "Engine/Sample/BoxNeighbors.h"
#include "Engine/Triangulate.h"
#include "Engine/Triangulation/Triangulation.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Ranks/vtkAHDRankChains.h"
#include "Ranks/vtkAHDRankPoints.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// A point, for all ranks.
struct vtkAHDRankPlace
{
  std::int64_t Id; ///< by which all know it
  ahd::Point At;

  bool operator<(const vtkAHDRankPlace& other) const { return this->Id < other.Id; }
};

/**
 * The triangulation of one rank's own points and a few of others, which all have: so it can tell
 * which of its points another rank needs. Nothing here is collective; all throws vtkAHDStop and
 * std::bad_alloc, as vtkAHDRanks::Together() wants it.
 */
class vtkAHDRankPart
{
public:
  /// Borrows both. REQUIRES: the points are with their owners.
  vtkAHDRankPart(const vtkAHDRankPoints& points, const vtkAHDContext& context)
    : Points(points)
    , Context(context)
  {
  }

  /// Own points that all are to have: those that the bounds of own points go through, with
  /// `allOfHull` the vertices of their hull; those that chains name.
  void ListShared(
    const vtkAHDRankChains& chains, bool allOfHull, std::vector<vtkAHDRankPlace>& shared);

  /// Triangulates. `shared`: of all ranks, by id, each once. `asksForNearest`: the nearest vertices
  /// are wanted, too, which constraints may hide.
  void Make(const vtkAHDSettings& settings, const vtkAHDRankChains& chains,
    const std::vector<vtkAHDRankPlace>& shared, bool asksForNearest);

  // --- After Make() ---

  /// Of all ranks' points, as the shared ones have it.
  ahd::Bounds GetBounds() const { return ahd::boundsOf(this->Made); }
  /// Of own points; empty without any.
  const ahd::Bounds& GetOwnBounds() const { return this->OwnBounds; }
  std::size_t FindCrowd();
  bool HasCrossings() const { return this->Made.constraints().crossing > 0; }

  /// Numbers of own points that others need for places in these boxes, ascending, with all that
  /// coincide with one of these. None where there is no place.
  void List(const std::vector<ahd::Bounds>& boxes, std::vector<ahd::Index>& numbers);
  /// All that are vertices, likewise.
  void ListAll(std::vector<ahd::Index>& numbers);

  /// Upper estimate of the bytes that this takes for so many own and shared points.
  static std::size_t EstimateBytes(std::size_t points, std::size_t ids, bool asksForNearest);

private:
  using Pair = std::pair<ahd::Index, ahd::Index>;

  void ReadOwn();
  std::int64_t NumberOf(std::int64_t id) const;
  void Constrain(const vtkAHDSettings& settings, const vtkAHDRankChains& chains);
  void ListCoincident();
  void AddCoincident(std::vector<ahd::Index>& numbers) const;
  static void SortOnce(std::vector<ahd::Index>& numbers);

  const vtkAHDRankPoints& Points;
  const vtkAHDContext& Context;
  std::vector<double> Places;      // x, y: of own points, then of shared ones of others
  std::vector<ahd::Index> Numbers; // of own points: skipped ones and not finite ones have none
  std::vector<std::int64_t> Ids;   // of all: own ones ascend, and so do the others behind
  std::size_t Own = 0;
  ahd::Bounds OwnBounds;
  std::vector<ahd::Index> Shared; // own ones, as numbers
  std::vector<Pair> Coincident;   // who stands for a vertex, and who else is there; ascending
  ahd::Workspace Workspace;
  ahd::Triangulation Plain, Made; // without constraints, if need be; as all is
};

#endif
