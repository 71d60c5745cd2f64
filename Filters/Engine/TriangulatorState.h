// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TriangulatorState_h
#define ahd_TriangulatorState_h

#include "Triangulate.h"

#include "Constrain/CellData.h"
#include "Constrain/ConstrainedMesh.h"
#include "Insert/Insert.h"
#include "Mesh/Mesh.h"
#include "Order/RankedPoints.h"

#include <vector>

namespace ahd
{

/// What a Triangulator keeps between its calls.
struct Triangulator::State
{
  PointView points;
  RankedPoints ranked;
  Mesh mesh;
  Buffer<Index> sequence; ///< of ranks; empty if nobody needs it
  std::vector<GridBox> boxes;
  Report report;
  bool keepLocations = false;

  // Once there are constraints, or cell data are asked for.
  ConstrainedMesh constrained;
  bool isLookedUp = false; ///< `constrained` is at hand
  CellData cells;
  bool areCellsAtHand = false;
  ConstraintReport constraints;

  /// Threads are asked for from so many points on: with 10^4 they cost as much as they gave, with
  /// 3 10^4 two were 1.4 times as fast as one.
  static constexpr std::size_t kLeastForThreads = 15000;

  Executor* worthItsWhile(Executor* lent) const
  {
    return points.count < kLeastForThreads ? nullptr : lent;
  }
  Status sortAndInsert(const Options& options, Progress* progress, Executor* executor);
  Status order(const Options& options, Ticker& sorting);
  void count(const Options& options);
  Status insert(const Options& options, Progress* progress, Executor* executor);
  InsertionEnd insertInOrder(
    const Options& options, Ticker& ticker, InsertionWork* work, SharedWork& shared);
  template <typename Id>
  Status write(Id* triples, Progress* progress, Executor* executor);
  bool writeFates(std::int64_t* fates, Progress* progress, Executor* executor) const;
  bool writeOrder(std::int64_t* ids, Progress* progress, Executor* executor) const;
  bool writeInsertionRanks(std::int64_t* ranks, Progress* progress, Executor* executor) const;

  Status constrain(const ConstraintView& given, FillRule rule, Progress* progress);
  bool insertConstraints(const ConstraintView& given, FillRule rule, Ticker& ticker);
  bool countMissing(const ConstraintView& given, Ticker& ticker);
  bool rankIds(Buffer<Index>& rankOf, Ticker& ticker) const;
  bool lookUp(Ticker& ticker);
  bool findCells(Ticker& ticker);
};

} // namespace ahd

#endif
