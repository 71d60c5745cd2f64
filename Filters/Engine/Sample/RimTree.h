// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RimTree_h
#define ahd_RimTree_h

#include "../Points/BoxLevels.h"
#include "../Predicates/Distances.h"
#include "Spots.h"
#include "VertexLine.h"

namespace ahd
{

/// The place of a rim that is nearest to one that is not on the surface.
struct RimPlace
{
  bool is = false;
  HalfEdge edge = kNoHalfEdge; ///< of a kept triangle; of a line the number of a piece
  Segment segment{};           ///< the same
  NearestPart part = NearestPart::Left;
};

/// Edges of a surface, to be looked for around a place.
///
/// The nearest place does not depend on numbers: of edges at the same distance the one counts whose
/// ends come first (comesBefore).
class RimTree
{
public:
  enum Edges
  {
    Rim,  ///< edges with a kept triangle on one side alone; the pieces of a line
    Walls ///< constraint edges with a triangle on either side, one of which is kept
  };

  /// Lists the edges of a surface, or of a line if there are no triangles; borrows both. Time: some
  /// steps for each edge of the hull and each dropped triangle, one for other triangles if some are
  /// dropped. Returns false if cancelled, as all below; throws std::bad_alloc.
  bool build(const SampledSurface& surface, const VertexLine& line, Edges which, Ticker& ticker);

  bool empty() const { return edges_.empty(); }

  // For several threads at once. @pre build(); a finite place.

  /// The place nearest to one that an edge isWithin(roundingAt()) of; else none.
  bool findWithinRounding(const Point& place, Ticker& ticker, RimPlace& found) const;

  /// The nearest place; none without edges. `hint`: an item to begin with, and the one found.
  bool findNearest(const Point& place, std::size_t& hint, Ticker& ticker, RimPlace& found) const;

  /// May findWithinRounding() have any for places in this box? @pre coordinates below 2^1000.
  bool mayBeNear(const Box& box, Ticker& ticker, bool& isNear) const;

  /// A wall that the straight way from one place to another leaves the surface through, whatever it
  /// touches; kNoHalfEdge if there is none.
  bool findWall(const Point& from, const Point& to, Ticker& ticker, HalfEdge& wall) const;

  /// Does that way leave the surface through this wall?
  bool isBehind(const Point& from, HalfEdge wall, const Point& to) const;

private:
  class Search;
  using Levels = BoxLevels<16, 8>;

  template <typename Use>
  bool forEachEdge(Ticker& ticker, const Use& use) const;
  template <typename Use>
  bool forHull(Ticker& ticker, const Use& use) const;
  template <typename Look>
  bool forNear(const Box& box, Ticker& ticker, const Look& look) const;
  Segment segmentOf(HalfEdge edge) const;
  Box boxOf(HalfEdge edge) const;
  static bool isNearer(const RimPlace& one, const RimPlace& other, const Point& place);
  RimPlace placeOn(std::size_t item, const Point& place) const;

  SampledSurface surface_{ nullptr, nullptr, nullptr };
  const VertexLine* line_ = nullptr;
  Edges which_ = Rim;
  Buffer<HalfEdge> edges_;
  Levels levels_;
  double largest_ = 0.0; ///< coordinate
};

} // namespace ahd

#endif
