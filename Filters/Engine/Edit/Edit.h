// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Edit_h
#define ahd_Edit_h

#include "../Constraints.h"
#include "../Core/Context.h"
#include "../Core/Progress.h"
#include "../Living/LivingMesh.h"
#include "../Points/Points.h"
#include "../Result.h"
#include "../Triangulation/Triangulation.h"
#include "Hints.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ahd
{

/// What became of a request to change one point or segment. All but Done and NotTried refuse it.
enum class EditOutcome : std::uint8_t
{
  Done = 0,
  NotTried = 1,     ///< the call ended before
  NoPoint = 2,      ///< no point has the id, or has it any more
  EndOfSegment = 3, ///< the point stays as long as the segment that ends at it
  SegmentsMeet = 4, ///< two segments that go different ways pass the vertex: without it they cross
  NotFinite = 5,    ///< an end of the segment has a coordinate that is not finite
  NoLength = 6,     ///< both ends of the segment are at one place
  Crosses = 7,      ///< the segment crosses an accepted one
  NoSegment = 8     ///< there is no such segment
};

/// Where a place lies: as in Location, with ids of points for vertices.
struct EditPlace
{
  Location::Kind kind = Location::Nowhere;
  /// InTriangle: its corners counterclockwise, from that of smallest id; OnEdge: the ends, the
  /// smaller id first; OnVertex: the representative. The rest are -1.
  std::array<std::int64_t, 3> ids{ { -1, -1, -1 } };
};

/// Points and segments as input of triangulate() and constrain().
struct EditedInput
{
  std::vector<Point> places;
  std::vector<std::int64_t> ids;      ///< of the points, ascending
  std::vector<std::int64_t> segments; ///< two positions in `places` each, ascending
  std::vector<std::int64_t> offsets;  ///< of the segments, for a ConstraintView

  PointView points() const
  {
    return places.empty() ? PointView() : PointView(&places[0].x, places.size(), 2);
  }
  ConstraintView constraints() const
  {
    return { segments.data(), offsets.data(), segments.size() / 2, segments.size() / 2 };
  }
};

/// Points and segments that come, go and move, with their constrained Delaunay triangulation always
/// known.
///
/// - After any history, triangulate() and constrain() make of write() what they make of the points
///   and segments that are left, byte for byte: the living triangles decide what is accepted and
///   where a place lies, the engine builds what is put out. Which of two crossing segments was
///   accepted is history: the first.
/// - A point's id is the number of points that came before it; ids are not used again. A point at
///   the place of others is a duplicate of that of smallest id, which represents the vertex; when
///   that goes, the next one does. A point with a coordinate that is not finite has no vertex.
/// - A segment through vertices is a row of edges, and one again where a vertex on it goes.
/// - Segments have no direction; one that is there already is accepted and changes nothing.
/// - Fewer than three points, or all on a line, have no triangles; segments are kept for later.
///
/// Calls take many requests at once, in order. Statuses: Ok, Cancelled, OutOfMemory; requests done
/// before the end stay done, but an insertion is done as a whole or not at all. After any status
/// the object is usable. One thread at a time.
///
/// Example:
///
///     ahd::Edit edit;
///     edit.insert(points, context, first);
///     edit.remove(&id, 1, context, &outcome);
///     edit.write(input, context);
///     ahd::triangulate(input.points(), {}, workspace, context, made);
///
/// Cost: a request takes a walk from a vertex nearby and the change of the triangles around; one
/// that begins or ends the triangles, a pass over all points.
class Edit
{
public:
  using Outcome = EditOutcome;

  /// The id of the first is `first`, the others follow. Also TooManyPoints: more than
  /// kMaximumPoints ever.
  Status insert(const PointView& points, const Context& context, std::int64_t& first);
  /// `outcomes`: `count`, as below.
  Status remove(
    const std::int64_t* ids, std::size_t count, const Context& context, Outcome* outcomes);
  /// Moves points.count points; each keeps its id.
  Status move(
    const std::int64_t* ids, const PointView& to, const Context& context, Outcome* outcomes);
  /// Segments between points; `ends`: 2 * count ids.
  Status constrain(
    const std::int64_t* ends, std::size_t count, const Context& context, Outcome* outcomes);
  Status release(
    const std::int64_t* ends, std::size_t count, const Context& context, Outcome* outcomes);
  Status locate(const PointView& places, const Context& context, EditPlace* found);

  /// What is left.
  Status write(EditedInput& out, const Context& context) const;
  std::size_t pointCount() const { return present_; }
  /// Points that came; the next one's id.
  std::size_t idCount() const { return places_.size(); }
  std::size_t segmentCount() const { return ends_.size() / 2; }
  /// Are there triangles, as the points are? Else the next call may take a pass over all points.
  bool isReady() const { return isReady_ && mesh_.vertexCount() > 0; }
  /// Is there a point with this id?
  bool has(std::int64_t id) const
  {
    return id >= 0 && static_cast<std::size_t>(id) < places_.size() && gone_[Index(id)] == 0;
  }

  /// Lower estimate of the bytes that it takes.
  std::size_t heldMemory() const;
  /// Upper estimate of the bytes that it takes, and needs meanwhile, with `more` points. Segments:
  /// 250 bytes for each, and each edge of one.
  std::size_t memoryEstimate(std::size_t more) const;

  /// The triangles as of the last locate(); no vertices if there are none.
  const LivingMesh& mesh() const { return mesh_; }

private:
  using Vertex = LivingMesh::Vertex;
  using Segment = std::pair<Index, Index>;
  struct Less
  {
    bool operator()(const Point& a, const Point& b) const { return lexicographicallyLess(a, b); }
  };

  // Edit.cxx
  template <typename Step>
  Status each(std::size_t count, const Context& context, Outcome* outcomes, const Step& step);
  bool isBulk(std::size_t more) const;

  // EditPoints.cxx
  Status makeReady(const Context& context);
  Status build(const Context& context);
  void forgetMesh();
  void nameVertices(const Triangulation& made);
  void fillLine();
  bool isOffLine(const Point& p) const;
  void append(const PointView& points);
  Status insertEach(std::size_t first, const Context& context);
  void takeBack(std::size_t first);
  void attach(Index id);
  void join(Index id, Vertex v);
  Outcome detach(Index id);
  Outcome removeVertex(Vertex v);
  LivingMesh::Slot hint(const Point& p) const;
  void renewHints();

  // EditSegments.cxx
  bool isEnd(Index id) const;
  Outcome ends(const std::int64_t* given, Segment& segment) const;
  Outcome constrainOne(const std::int64_t* given);
  Outcome releaseOne(const std::int64_t* given);
  void usePieces(Vertex a, Vertex b);
  std::vector<Vertex> constraintsAt(Vertex v) const;
  void splitPiece(Vertex a, Vertex b, Vertex v);
  EditPlace locateOne(const Point& p) const;
  static std::uint64_t key(Vertex a, Vertex b)
  {
    return std::uint64_t(a < b ? a : b) << 32 | (a < b ? b : a);
  }

  // By id.
  std::vector<Point> places_;
  std::vector<Index> vertexOf_;     ///< the ghost: none
  std::vector<unsigned char> gone_; ///< no point has the id any more
  std::size_t present_ = 0;
  std::set<Segment> ends_; ///< of the segments, both ways

  // Made of these by build(), unless they are as the flag says.
  bool isReady_ = true;     ///< false: a change was left in the middle, or they are to be made anew
  bool isOver_ = false;     ///< the change at work leaves that to build()
  LivingMesh mesh_;         ///< without vertices as long as there is no triangle
  std::vector<Index> idOf_; ///< by vertex: of its points the smallest
  std::unordered_map<Index, std::set<Index>> stacks_; ///< vertices of several points: all of them
  std::unordered_map<std::uint64_t, Index> uses_;     ///< segments along each constraint edge
  std::map<Point, std::set<Index>, Less> line_;       ///< the points, where there is no triangle
  Hints hints_;
  Vertex last_ = LivingMesh::kGhost;     ///< inserted; it may be gone
  std::vector<LivingMesh::Edge> pieces_; ///< scratch
};

} // namespace ahd

#endif
