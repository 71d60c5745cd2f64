// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_LineLayer_h
#define ahd_LineLayer_h

#include "../Constraints.h"
#include "../Core/AskedMemory.h"
#include "../Crossings/PlaceTable.h"
#include "../Crossings/Way.h"
#include "../Points/Points.h"
#include "../Triangulation/Path.h"
#include "HeightSurface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace ahd
{

/// The chains to add points to, and how.
struct LinesToLay
{
  PointView points; ///< with z
  ConstraintView chains;
  const HeightSurface* surface = nullptr; ///< null: segments cross nothing
  std::size_t firstOfSource = 0;          ///< its points have triangles there
  /// Does the segment between two points lie on the surface? Others are straight.
  std::function<bool(Index, Index)> isOnSurface;
  double maximumLength = 0.0; ///< of a piece; 0: none is divided
  std::size_t mostPoints = std::size_t(-1);
};

/// Adds points to chains: where segments cross edges of the surface, then where pieces are too
/// long.
///
/// A place is the exact crossing, rounded to the nearest double in each coordinate. Where a point
/// of the segment rounds to an end of the edge, it is led through that vertex, and where a point of
/// the edge rounds to an end of the segment, nothing is added. Vertices on the segment become
/// points of it. A piece longer than the maximum is divided into the fewest equal parts that are
/// not, but for rounding. One point is added at each place, however many segments pass there. So
/// the places are a function of the set of the segments, whatever their order and directions, and
/// so are the heights of points on the surface. Of segments that are divided elsewhere at the same
/// place, the first one decides on the height.
///
/// A segment that does not lie on the surface, but is a row of its edges, is led through the points
/// that others get on these.
class LineLayer
{
public:
  LineLayer(const LinesToLay& lines, Ticker& ticker)
    : lines_(lines)
    , ticker_(ticker)
    , table_(ticker)
    , taken_(ticker)
  {
  }

  /// @return Ok, Cancelled, TooManyPoints or TooManyCrossings: more than mostPoints. Throws
  ///   std::bad_alloc
  Status run();

  // The chains with the added points in them, as many as before. Point k added has the id
  // points.count + k; its origins are points with smaller ids. In the order of the segments; of
  // each, or of all where segments are part of the surface, those on edges come first.
  std::vector<std::int64_t> ids, offsets;
  std::vector<SurfacePlace> origins;
  std::vector<std::array<double, 3>> places;
  /// Of each of `ids`: does the piece to the next one lie on the surface?
  std::vector<unsigned char> areOnSurface;

private:
  struct Stop
  {
    Point at;
    Index id;
  };

  /// A stop on an edge of the surface, by the numbers of the edge's vertices.
  struct OnEdge
  {
    std::uint64_t edge;
    Stop stop;
  };

  template <typename Work>
  bool forSegments(const Work& work);
  bool isUsable(std::int64_t id) const;
  bool findShared();
  bool lay(Index from, Index to);
  std::size_t triangleNear(Index id) const;
  bool findStops(const Way& way, Index from, bool isOnSurface);
  bool findStopsOnSurface(const Way& way, Index from);
  bool findStopsOfOthers(const Way& way, Index from);
  bool cross(const Way& way, HalfEdge h);
  void stopAtVertex(Index vertex);
  bool divide(const Way& way, const Stop& from, const Stop& to, bool isOnSurface);
  bool pointAt(const Point& place, bool isOnSurface, const SurfacePlace& otherwise, Index& id);
  double heightAt(const SurfacePlace& origin) const;
  void add(Index id, bool isOnSurface);
  void takeMemory();

  const LinesToLay& lines_;
  Ticker& ticker_;
  PlaceTable table_;
  TakenMemory taken_;
  std::optional<SurfacePlacer> placer_; ///< with a surface
  std::optional<SegmentPath> path_;     ///< the same
  std::vector<Stop> stops_;             ///< of one segment
  std::vector<OnEdge> shared_;          ///< on edges that are segments, by edges
  bool findsShared_ = false;            ///< they are still being found
  bool areTooMany_ = false;
};

} // namespace ahd

#endif
