// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Spots_h
#define ahd_Spots_h

#include "../Core/Progress.h"
#include "../Triangulation/Locate.h"
#include "../Triangulation/Tables.h"

#include <cstddef>

namespace ahd
{

/// The triangulation as it is sampled.
struct SampledSurface
{
  bool isKept(std::size_t triangle) const
  {
    return kept ? kept[triangle] != 0 : tables->isKept(triangle);
  }
  Point at(Index vertex) const { return places[vertex]; }

  const Tables* tables;
  const Point* places;       ///< of the vertices
  const unsigned char* kept; ///< of each triangle; null: see isKept() of the tables
};

/// Where a place lies on the surface.
struct Spot
{
  enum Kind
  {
    Outside,    ///< in no kept triangle
    InTriangle, ///< inside of triangle halfEdge / 3
    OnEdge,     ///< between the ends of halfEdge
    OnVertex    ///< where halfEdge begins
  };
  Kind kind = Outside;
  /// Of a kept triangle: the same one for all callers.
  HalfEdge halfEdge = kNoHalfEdge;
};

/// Of the kept triangles at an edge or vertex, the one that answers for it. Nobody asks twice, and
/// it does not depend on how a place was found.
class SpotOwner
{
public:
  explicit SpotOwner(const SampledSurface& surface)
    : surface_(surface)
  {
  }

  /// @pre the place lies on the edge, between its ends.
  Spot ofEdge(HalfEdge h) const;
  /// Returns false if cancelled.
  bool ofVertex(Index vertex, Ticker& ticker, Spot& spot) const;

private:
  const SampledSurface& surface_;
};

/// Finds places one after the other, each from where the last one was.
class SpotFinder
{
public:
  explicit SpotFinder(const SampledSurface& surface)
    : surface_(surface)
  {
  }

  /// Returns false if cancelled. @pre triangles; a finite place.
  bool find(const Point& place, Ticker& ticker, Spot& spot);

private:
  SampledSurface surface_;
  std::size_t hint_ = 0; ///< triangle
};

} // namespace ahd

#endif
