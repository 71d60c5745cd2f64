// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Constrainer_h
#define ahd_Constrainer_h

#include "../Constraints.h"
#include "../Core/AskedMemory.h"
#include "CavityFiller.h"
#include "ConstrainedMesh.h"
#include "EdgeRows.h"
#include "EdgeTable.h"
#include "Regions.h"
#include "SegmentWalk.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace ahd
{

class InCurveOrder;

/// Inserts constraints into a mesh: those that cross no other along the curve, then the rest one
/// after the other, in the order given.
class Constrainer
{
public:
  /// `rankOf` tells the vertex of each of the caller's ids, kNoIndex if it has none.
  /// Throws std::bad_alloc.
  Constrainer(ConstrainedMesh& mesh, const Buffer<Index>& rankOf, Ticker& ticker);

  /// `vertices` of the mesh are expected to have edges, at most. Returns false if cancelled: the
  /// mesh is then unusable. Throws std::bad_alloc.
  bool insertAll(const ConstraintView& constraints, std::size_t vertices, FillRule rule);

  /// The edges of loops; of loops that are whole only, and with FillRule::EvenOdd of one of those
  /// with the same edges.
  const LoopEdges& edges() const { return loopEdges_; }
  bool anyLoop() const { return anyLoop_; }
  ConstraintReport takeReport() { return std::move(report_); }

private:
  enum class Outcome
  {
    IsEdge,  ///< or a row of edges
    IsPoint, ///< of no length
    Missing, ///< left out
    Cancelled
  };

  bool begin(std::size_t vertices);
  bool insertChain(std::size_t chain, const InCurveOrder& curve);
  bool haveThreeVertices(const std::int64_t* ids, std::size_t count) const;
  Outcome useEdge(std::int64_t fromId, std::int64_t toId);
  Outcome insertSegment(const std::int64_t* fromId, std::int64_t toId);
  Outcome leaveOut(Mesh::Halfedge crossed);
  Index vertexOf(std::int64_t id) const;
  bool makeEdges(bool isForward);
  bool markEdge(Mesh::Halfedge h, bool isForward);
  bool isNewLoop(bool& isNew);
  bool useLoop();
  std::pair<std::size_t, std::size_t> find(std::uint64_t segment) const;
  void prefetch(const std::int64_t* ids) const;

  ConstrainedMesh& mesh_;
  const Index* rankOf_;
  std::size_t points_;
  Ticker& ticker_;
  GrowingMemory grown_; ///< for lists of unknown length
  SegmentWalk walk_;
  CavityFiller cavity_;
  EdgeRows rows_;
  EdgeTable<std::uint64_t> users_; ///< of an edge, the first segment in order that uses it; not of
                                   ///< edges that no segment crosses
  LoopEdges loopEdges_;
  std::size_t edges_ = 0; ///< that are constraints
  ConstraintView constraints_;
  FillRule rule_ = FillRule::Orientation;
  std::vector<std::uint64_t> firstSegment_;    ///< of each chain, among all segments
  std::uint64_t segment_ = 0;                  ///< the current one
  std::vector<std::pair<Index, Index>> loop_;  ///< edges of the current chain, in its direction
  std::set<std::vector<std::uint64_t>> loops_; ///< the sorted edges of each, with FillRule::EvenOdd
  bool isLoop_ = false;
  bool anyLoop_ = false;
  ConstraintReport report_;
};

} // namespace ahd

#endif
