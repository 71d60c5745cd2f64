// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_InCurveOrder_h
#define ahd_InCurveOrder_h

#include "../Constraints.h"
#include "../Core/AskedMemory.h"
#include "../Core/Buffer.h"
#include "CavityFiller.h"
#include "ConstrainedMesh.h"
#include "EdgeRows.h"
#include "EdgeTable.h"

#include "SegmentWalk.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

struct Share;

/// Makes all segments edges that cross no other; their order does not matter. Crossing segments are
/// left for insertion in the given order.
///
/// Segments that cross few edges come along the curve on which vertices are numbered: they are then
/// close in memory, and threads can share them. Long ones come afterwards, in rounds: half of them
/// in the last one, drawn at random, a quarter in the one before, and so on, each along the curve.
/// In order they might each undo what the one before made; at random, n vertices and k segments
/// take n log n + n log^2 k steps, expected (P. K. Agarwal, L. Arge, K. Yi, "I/O-efficient
/// construction of constrained Delaunay triangulations", 2005; rounds: N. Amenta, S. Choi, G. Rote,
/// "Incremental constructions con BRIO", 2003).
///
/// Crossings are detected afterwards: the segment that came first is an edge then, one that crosses
/// it is not. The latter are walked once more, and the segments of the edges that they cross are
/// taken out again.
///
/// Each task has a territory, some successive vertices, and inserts the segments of which all
/// vertices of all crossed triangles lie there. It changes triangles with three vertices of its
/// own, links across edges with two, and marks of triangles with two; it reads triangles
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
    , grown_(ticker)
  {
  }

  /// Returns false if cancelled: the mesh is then unusable. Throws std::bad_alloc.
  /// @pre the Delaunay triangulation, no constraints; offsets ascend.
  bool insertAll(const ConstraintView& constraints);

  /// Is the segment that begins at this place among the ids one edge, and a constraint that no
  /// other segment crosses?
  bool isEdge(std::size_t place) const { return !became_.empty() && became_[place] == kEdge; }
  /// Or a row of such edges? If neither, it must still be inserted.
  bool isRow(std::size_t place) const { return !became_.empty() && became_[place] == kRow; }

  /// How many edges are constraints now.
  std::size_t edges() const { return edges_; }

  /// Bytes for each segment, at most. Lists of segments and of edges grow by doubling; all are
  /// given back but for a byte for each id.
  static constexpr std::size_t bytesPerSegment()
  {
    constexpr std::size_t kGrown = 3; // while it is copied
    return sizeof(Segment) + 2 + kGrown * (4 * sizeof(Segment) + 2 * sizeof(Made)) +
      8 * 2 * sizeof(Edges::Edge) * 2 / kMostCrossing;
  }
  /// Of these, the part not requested from Progress::take().
  static constexpr std::size_t knownBytesPerSegment() { return sizeof(Segment) + 1 + sizeof(Made); }
  /// And for few of them.
  static constexpr std::size_t bytesAtLeast()
  {
    return 16 * sizeof(Edges::Edge) * kCrossingAtLeast;
  }

private:
  /// A segment that crosses more edges is long.
  static constexpr std::size_t kMostInOrder = 32;
  static constexpr std::size_t kLeastInTerritory = std::size_t(1) << 10; ///< segments
  static constexpr unsigned kRounds = 24;

  /// One of so many segments may cross others or be crossed, plus so many: with more this order is
  /// given up, as too many would be left to the end.
  static constexpr std::size_t kMostCrossing = 8, kCrossingAtLeast = 64;

  /// The outcome of a segment, by its place.
  enum : std::uint8_t
  {
    kNothing,
    kEdge,
    kRow ///< of edges, as vertices lie on it
  };
  /// The state of an edge.
  enum : std::uint8_t
  {
    kFound,
    kListed, ///< to be taken out
    kShared  ///< but other segments use it
  };
  using Edges = EdgeTable<std::uint8_t>;

  struct Segment
  {
    Index from, to;
    std::uint32_t place; ///< among all ids
  };

  /// An edge that was made a constraint, or a row of them. Not those that were edges before any
  /// long one came: there are many, and few triangles hang on them.
  struct Made
  {
    Index from, to;
  };

  /// Some successive vertices, and the segments that begin there.
  struct Territory
  {
    Index firstVertex = 0;
    std::size_t begin = 0;         ///< its first segment
    std::size_t edges = 0;         ///< that became constraints
    std::vector<Segment> left;     ///< as they leave it
    std::vector<Segment> late;     ///< as they are long
    std::vector<Segment> crossing; ///< edges when they came
    std::vector<Made> made;        ///< in this order
  };

  /// Tools to insert the segments of a territory.
  struct Work
  {
    Work(ConstrainedMesh& mesh, Ticker& ticker)
      : walk(mesh, ticker)
      , cavity(mesh, ticker)
      , rows(mesh, ticker)
    {
      walk.passRows(&rows);
    }
    SegmentWalk walk;
    CavityFiller cavity;
    EdgeRows rows;
    bool isLate = false; ///< long ones come
  };

  /// Tools to look for edges in rows of edges.
  struct Uses
  {
    Uses(ConstrainedMesh& mesh, Ticker& ticker)
      : walk(mesh, ticker)
      , without(mesh, ticker)
    {
      walk.passRows(&without);
    }
    SegmentWalk walk;
    EdgeRows without; ///< those without any
  };

  enum class Outcome
  {
    Done,
    Beyond,  ///< it leaves the territory
    Long,    ///< for later
    Crosses, ///< another segment
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
  bool insertLeft();
  bool insertLate();
  static unsigned roundOf(const Segment& segment);
  bool inRounds(std::vector<Segment>& segments);
  bool gather(std::vector<Segment> Territory::*kind, std::vector<Segment>& all);
  bool insert(
    const Segment* begin, const Segment* end, Work& work, Territory& territory, Ticker& ticker);
  Outcome insert(const Segment& segment, Work& work, Territory& territory);
  bool makeEdges(Work& work, Territory& territory);

  // Those that cross (InCurveOrderCrossed.cxx).
  bool takeOutCrossed();
  bool findCrossedEdges(const std::vector<Segment>& crossing, Edges& edges);
  template <typename Visit>
  bool eachEdge(const Segment& segment, SegmentWalk& walk, Visit visit) const;
  template <typename Visit>
  bool eachOf(const Edges& edges, const Segment& segment, Uses& uses, Visit visit) const;
  bool findUsers(const Edges& edges, std::vector<Segment>& users);
  bool findEdges(const std::vector<Segment>& segments, Edges& edges, std::vector<Made>& list);
  bool findShared(Edges& edges);
  bool release(const std::vector<Made>& list, const Edges* edges);
  void takeMark(Mesh::Halfedge edge);
  bool releaseRest();
  bool makeDelaunay(CavityFiller& cavity);
  bool takeOut(std::vector<Segment>& crossed);
  bool undo();
  std::size_t mostCrossed() const
  {
    return kCrossingAtLeast + 2 * segments_.size() / kMostCrossing;
  }

  ConstrainedMesh& mesh_;
  const Index* rankOf_;
  std::size_t points_;
  Ticker& ticker_;
  GrowingMemory grown_; ///< for lists of unknown length
  ConstraintView constraints_;
  Buffer<std::uint8_t> became_;          ///< by place; empty if nothing became an edge
  Buffer<Segment> segments_;             ///< along the curve
  std::vector<Territory> territories_;   ///< and two more, for segments left over and late ones
  std::vector<Mesh::Halfedge> suspects_; ///< edges that need not be locally Delaunay
  std::atomic<bool> gaveUp_{ false };
  std::size_t edges_ = 0;
};

} // namespace ahd

#endif
