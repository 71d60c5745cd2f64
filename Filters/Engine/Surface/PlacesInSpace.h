// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_PlacesInSpace_h
#define ahd_PlacesInSpace_h

#include "../Core/Buffer.h"
#include "../Core/Loops.h"
#include "../Triangulation/State.h"
#include "Vectors.h"

#include <algorithm>

namespace ahd
{

/// The vertices in the user's space, read in their order.
class PlacesInSpace
{
public:
  using State = TriangulationAccess::State;

  /// Puts the places of the triangulation back as well, if they are gone. Returns false if
  /// cancelled; throws std::bad_alloc.
  bool read(State& state, const PointView& inSpace, Ticker& ticker)
  {
    const PointView& points = state.points;
    xy_ = state.ranked.xy.data();
    isUpright_ = points.doubles == inSpace.doubles && points.floats == inSpace.floats &&
      points.stride == inSpace.stride;
    isUpright_ ? z_.allocate(state.ranked.count) : places_.allocate(state.ranked.count);
    const bool isGone = state.arePlacesGone;
    const auto work = [&, isGone](std::size_t a, std::size_t b)
    {
      const std::uint32_t* const id = state.ranked.id.data();
      for (std::size_t v = a; v != b; ++v)
      {
        inSpace.prefetch(id[std::min(v + kPointsAhead, b - 1)]);
        isUpright_ ? void(z_[v] = inSpace.z(id[v])) : void(places_[v] = inSpace.place(id[v]));
        if (isGone)
        {
          state.ranked.xy[v] = points[id[v]];
        }
      }
    };
    return inShares(state.ranked.count, ticker, 4, kChunk, work) && state.havePlaces();
  }

  /// Prefetches the place of the vertex.
  void fetch(Index vertex) const
  {
    isUpright_ ? prefetchForRead(z_.data() + vertex) : prefetchForRead(places_.data() + vertex);
  }

  Vector3 operator()(Index vertex) const
  {
    return isUpright_ ? Vector3{ { xy_[vertex].x, xy_[vertex].y, z_[vertex] } } : places_[vertex];
  }

private:
  static constexpr std::size_t kPointsAhead = 24;

  const Point* xy_ = nullptr;
  bool isUpright_ = false; ///< x and y are those of the triangulation
  Buffer<double> z_;
  Buffer<Vector3> places_; ///< if not isUpright_
};

} // namespace ahd

#endif
