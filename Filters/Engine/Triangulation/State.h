// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_State_h
#define ahd_State_h

#include "../Constrain/ConstrainedMesh.h"
#include "../Core/Executor.h"
#include "../Mesh/Mesh.h"
#include "../Order/RankedPoints.h"
#include "Tables.h"
#include "Triangulation.h"

#include <utility>
#include <vector>

namespace ahd
{

/// What a Triangulation is made of.
struct Triangulation::State
{
  PointView points;
  RankedPoints ranked;
  Mesh mesh;              ///< in the memory of ranked.scratch
  Buffer<Index> sequence; ///< of ranks; empty if not needed
  std::vector<GridBox> boxes;
  Report report;
  std::size_t allTriangles = 0; ///< dropped ones included

  bool hasMarks = false; ///< then those of `constrained` say which edges are constraints, and
                         ///< which triangles are dropped
  ConstrainedMesh constrained;
  ConstraintReport constraints;

  /// The place of the triangle in each slot in the canonical order of all, dropped ones included;
  /// kNotExtracted for ghosts. Valid if hasNumbers.
  Buffer<std::uint32_t> numbers;
  bool hasNumbers = false;
  Tables tables;
  bool hasCorners = false;
  bool hasTwins = false;
  bool hasNeighbors = false;
  bool hasPointMap = false;
  bool arePlacesGone = false; ///< ranked.xy served as scratch

  /// Threads are asked for from so many points on: with 10^4 they cost as much as they gave, with
  /// 3 10^4 two were 1.4 times as fast as one.
  static constexpr std::size_t kLeastForThreads = 15000;

  Executor* worthItsWhile(Executor* lent) const
  {
    return points.count < kLeastForThreads ? nullptr : lent;
  }

  /// Flags of the triangle in a slot: see ConstrainedMesh.
  std::uint8_t marksOf(std::size_t slot) const
  {
    return hasMarks ? constrained.marks(Mesh::slotOfTriangle(slot)) : std::uint8_t(0);
  }

  /// Reads the places of the vertices again where they are gone. Returns false if cancelled, as all
  /// below; throws std::bad_alloc.
  bool restorePlaces(Ticker& ticker);
  /// Records that all were read; returns true.
  bool havePlaces();

  enum class PlacesAre
  {
    Needed,
    NotNeeded ///< their memory may be used: restorePlaces() before they are
  };
  bool makeNumbers(Ticker& ticker, PlacesAre places = PlacesAre::Needed);
  /// Corners and flags; they need no places.
  bool makeCorners(Ticker& ticker);
  bool makeFlags(Ticker& ticker);
  /// Corners, flags and neighbours.
  bool makeTwins(Ticker& ticker);
  bool makeNeighbors(Ticker& ticker);
  bool makePointMap(Ticker& ticker);

  void makeScratch(Scratch& scratch);
  bool listCorners(Ticker& ticker);
  bool makeStarts(Ticker& ticker);

  template <typename Id>
  bool writeTriangles(Id* triples, Ticker& ticker);
  template <typename Id>
  bool writeKept(Id* triples, Ticker& ticker) const;
  template <typename Id>
  bool writePointStatus(Id* status, Ticker& ticker) const;
  template <typename Id>
  bool writeOrder(Id* ids, Ticker& ticker) const;
  template <typename Id>
  bool writeInsertionRanks(Id* ranks, Ticker& ticker) const;
};

class Workspace;

/// Access for the engine's own code.
class TriangulationAccess
{
public:
  using State = Triangulation::State;
  using StatePointer = std::unique_ptr<State>;

  static StatePointer& stateOf(Triangulation& triangulation) { return triangulation.state_; }

  /// Null for a triangulation without points.
  static const State* stateOf(const Triangulation& triangulation)
  {
    return triangulation.state_.get();
  }

  /// What a workspace keeps (Triangulate.cxx).
  static void takeMemory(Workspace& from, State& to);
  static void giveMemory(State& from, Workspace& to);
};

} // namespace ahd

#endif
