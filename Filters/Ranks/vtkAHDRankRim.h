// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankRim_h
#define vtkAHDRankRim_h

#include "Ranks/vtkAHDRankGhosts.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * Takes flat triangles at the rim away, as ahd::trim() does in a triangulation without constraints.
 *
 * A triangle is flat over one edge at most, its longest. It goes if nothing is beyond that edge, or
 * a triangle that goes: so each flat triangle follows another one, or the hull, and as longest
 * edges grow on the way, none follows itself. Where the way leads over a triangle of which this
 * rank knows no corner, all ranks are asked for the half-edge there, once.
 */
class vtkAHDRankRim
{
public:
  /// Borrows all of them. `places`: of own points, then of foreign ones.
  vtkAHDRankRim(vtkAHDRanks& ranks, const vtkAHDContext& context, const vtkAHDRankPoints& points,
    const ahd::BlockTriangulation& triangulation, const std::vector<ahd::Point>& places);

  /// For each own point, at most: marks; two triangles, which may be flat.
  static constexpr std::size_t kBytesPerPoint = 2 + 2 * 2 + 2 * 44;

  /// Takes them out of both. `around`: all triangles of others that have an own point. Collective;
  /// throws vtkAHDStop on all ranks.
  void Trim(vtkAHDRankTriangles& own, vtkAHDRankTriangles& around);

  /// Of all ranks: triangles that were taken away, vertices that are in no triangle any more, the
  /// area of those triangles as a part of all.
  std::size_t GetTriangles() const { return this->Triangles; }
  std::size_t GetBareVertices() const { return this->BareVertices; }
  double GetArea() const { return this->Area; }

private:
  using HalfEdge = std::array<std::int64_t, 2>; // of ids, from and to
  enum : vtkTypeInt32                           // what becomes of a triangle
  {
    Unknown = -3,
    Dropped = -2,
    Kept = -1
    // from 0 on: what becomes of another one
  };
  struct Flat
  {
    ahd::Index Triangle;
    vtkTypeInt32 From, To; // the longest edge, with the triangle on its left
    ahd::Index Beyond;     // the triangle there, if it is here
    vtkTypeInt32 Fate;     // from 0 on: as beyond this flat triangle
    vtkTypeInt32 Root;     // the place of the half-edge there among those that were asked for
  };
  static constexpr ahd::Index None = ahd::kNoIndex;

  static constexpr std::size_t kPiece = std::size_t(1) << 14; // steps between two askings

  void StopIfAborted(std::size_t step) const;
  const vtkTypeInt32* CornersOf(std::size_t triangle) const;
  std::int64_t IdOf(vtkTypeInt32 number) const;
  bool IsOwn(vtkTypeInt32 number) const;
  void FindFlat();
  template <typename Visit>
  void ForHalfEdges(
    std::size_t triangles, const std::vector<unsigned char>& isFrom, const Visit& visit) const;
  void FindBeyond();
  double DoubledArea(std::size_t triangle) const;
  int FlatEdgeOf(std::size_t triangle) const;
  Flat* FlatOf(ahd::Index triangle);
  void Follow();
  void ShareAsked();
  void Answer(ahd::BlockBytes& bytes);
  void HearAnswers(const std::vector<ahd::BlockBytes>& all);
  void Count(const std::vector<unsigned char>& kept, ahd::BlockBytes& bytes) const;

  vtkAHDRanks& Ranks;
  const vtkAHDContext& Context;
  const vtkAHDRankPoints& Points;
  const std::vector<ahd::ForeignPoint>& Foreign;
  const std::vector<ahd::Point>& Places;
  const vtkAHDRankTriangles* Own = nullptr;
  const vtkAHDRankTriangles* Around = nullptr;
  std::vector<Flat> Flats;         // by triangle
  std::vector<HalfEdge> Asked;     // of all ranks, sorted
  std::vector<vtkTypeInt32> Fates; // beyond these; from 0 on: as beyond this one
  double Whole = 0.0;              // twice the area of own triangles
  std::size_t Triangles = 0;
  std::size_t BareVertices = 0;
  double Area = 0.0;
};

#endif
