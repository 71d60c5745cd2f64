// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_InCurveOrder_h
#define ahd_InCurveOrder_h

#include "../Constraints.h"
#include "../Core/Buffer.h"
#include "CavityFiller.h"
#include "ConstrainedMesh.h"
#include "EdgeTable.h"
#include "SegmentWalk.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

struct Share;

/// Makes all segments edges that cross no other, along the curve on which vertices are numbered:
/// they are then close in memory, and threads can share them. Of these the order does not matter.
/// Of those that cross one another it does: they are left to be inserted in the order given.
///
/// Which ones these are is seen at the end. Whatever came first along the curve is an edge then,
/// and what crosses that is not. So the latter are walked once more, and the segments of the edges
/// that they cross taken out again.
///
/// Each task has a territory, some successive vertices, and inserts the segments of which all
/// vertices of all crossed triangles lie there. What it changes are triangles with three vertices
/// of its own, links across edges with two, and marks of triangles with two; it reads triangles
/// with one, links across edges with one, and marks of triangles with two: nothing that another
/// task changes. The other segments come afterwards, on one thread.
class InCurveOrder
{
public:
  /// `rankOf` tells the vertex of each of the caller's ids below `points`, kNoIndex if it has none.
  InCurveOrder(ConstrainedMesh& mesh, const Index* rankOf, std::size_t points, Ticker& ticker)
    : mesh_(mesh)
    , rankOf_(rankOf)
    , points_(points)
    , ticker_(ticker)
  {
  }

  /// Returns false if the caller wants to cancel: the mesh is then unusable. Throws std::bad_alloc.
  /// REQUIRES: the Delaunay triangulation, no constraints; offsets ascend.
  bool insertAll(const ConstraintView& constraints);

  /// Is the segment that begins at this place among the ids one edge, and a constraint that no
  /// other segment crosses? Otherwise it is still to be looked at.
  bool isEdge(std::size_t place) const { return !became_.empty() && became_[place] == kEdge; }

  /// How many edges are constraints now.
  std::size_t edges() const { return edges_; }

  /// Bytes for each segment, at most. What is to be undone grows by doubling, and so do lists of
  /// those that cross, and of edges; all is given back but for a byte for each id.
  static constexpr std::size_t bytesPerSegment()
  {
    constexpr std::size_t kGrown = 3; // while it is copied
    constexpr std::size_t kReplaced = kMostReplaced + kReplacedAtLeast / kLeastInTerritory;
    return sizeof(Segment) + 2 + kGrown * (4 * sizeof(Segment) + sizeof(Replaced) * kReplaced) +
      8 * 2 * sizeof(Edges::Edge) * 2 / kMostCrossing;
  }
  /// And for few of them.
  static constexpr std::size_t bytesAtLeast()
  {
    return 3 * sizeof(Replaced) * kReplacedAtLeast + 16 * sizeof(Edges::Edge) * kCrossingAtLeast;
  }

private:
  /// So many triangles may be replaced, or edges flipped, for each segment so far, and so many more
  /// in each territory: where there are more, segments are long, and it is given up.
  static constexpr std::size_t kMostReplaced = 6, kReplacedAtLeast = std::size_t(1) << 10;
  static constexpr std::size_t kLeastInTerritory = std::size_t(1) << 10; ///< segments

  /// One of so many segments may cross others, or be crossed, and so many more: else it is given
  /// up, as too many are left to the end.
  static constexpr std::size_t kMostCrossing = 8, kCrossingAtLeast = 64;

  /// What a segment became, by its place.
  enum : std::uint8_t
  {
    kNothing,
    kEdge,
    kRow ///< of edges, as vertices lie on it
  };
  using Edges = EdgeTable<std::uint8_t>;

  struct Segment
  {
    Index from, to;
    std::uint32_t place; ///< among all ids
  };

  /// A triangle as it was.
  struct Replaced
  {
    Mesh::Slot slot;
    std::uint32_t corners[3];
    Mesh::Halfedge twins[3];
  };

  /// Some successive vertices, and the segments that begin there.
  struct Territory
  {
    Index firstVertex = 0;
    std::size_t begin = 0;          ///< its first segment
    std::size_t edges = 0;          ///< that became constraints
    std::vector<Segment> left;      ///< to the end
    std::vector<Segment> crossing;  ///< what was an edge when they came
    std::vector<Replaced> replaced; ///< in this order
  };

  /// What inserts the segments of a territory.
  struct Work
  {
    Work(ConstrainedMesh& mesh, Ticker& ticker)
      : walk(mesh, ticker)
      , cavity(mesh, ticker)
    {
    }
    SegmentWalk walk;
    CavityFiller cavity;
    std::size_t budget = 0; ///< so many triangles may still be replaced
  };

  enum class Outcome
  {
    Done,
    Beyond,  ///< it leaves the territory
    Crosses, ///< another segment
    GaveUp,
    Cancelled
  };

  Index vertexOf(std::int64_t id) const
  {
    return std::uint64_t(id) < points_ ? rankOf_[id] : kNoIndex;
  }
  bool areInMesh(const Segment& s) const { return mesh_.isInMesh(s.from) && mesh_.isInMesh(s.to); }

  template <typename Visit>
  bool eachSegment(const Share& places, Ticker& ticker, Visit visit) const;
  bool sort(std::size_t places);
  void divide(const std::uint32_t* blockEnds, std::size_t blocks, unsigned shift);
  void prefetch(const Segment* segment, const Segment* end) const;
  bool insertSorted();
  bool gather(std::vector<Segment> Territory::*kind, std::vector<Segment>& all);
  bool insert(
    const Segment* begin, const Segment* end, Work& work, Territory& territory, Ticker& ticker);
  Outcome insert(const Segment& segment, Work& work, Territory& territory);
  bool makeEdges(Work& work, Territory& territory);
  void remember(Mesh::Halfedge h, Territory& territory) const;
  bool undo();

  // Those that cross (InCurveOrderCrossed.cxx).
  bool takeOutCrossed();
  bool findCrossedEdges(const std::vector<Segment>& crossing, Edges& edges);
  template <typename Visit>
  bool eachEdge(const Segment& segment, SegmentWalk& walk, Visit visit) const;
  bool findUsers(const Edges& edges, std::vector<Segment>& users);
  bool setConstraint(
    Index u, Index v, bool isOn, SegmentWalk& walk, std::vector<Mesh::Halfedge>& suspects);
  bool makeDelaunay(std::vector<Mesh::Halfedge>& suspects);
  bool takeOut(const std::vector<Segment>& crossed);
  std::size_t mostCrossed() const
  {
    return kCrossingAtLeast + 2 * segments_.size() / kMostCrossing;
  }

  ConstrainedMesh& mesh_;
  const Index* rankOf_;
  std::size_t points_;
  Ticker& ticker_;
  ConstraintView constraints_;
  Buffer<std::uint8_t> became_;        ///< by place; empty if nothing became an edge
  Buffer<Segment> segments_;           ///< along the curve
  std::vector<Territory> territories_; ///< and one more, for what is left to the end
  std::atomic<bool> gaveUp_{ false };
  std::size_t edges_ = 0;
};

} // namespace ahd

#endif
