// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Frame_h
#define ahd_Frame_h

#include "../Core/Progress.h"
#include "../Order/RankedPoints.h"

#include <cstddef>

namespace ahd
{

/// The points as an insertion sees them, with properties common to all.
struct Frame
{
  const RankedPoints& points;
  double guard;        ///< of the in-circle filter (Filters.h): enough for all triangles
  double squaredGuard; ///< of that for two triangles at once (FilterPairs.h)
  double exactBelow;   ///< error bounds below this are 0 (exactErrorBound() in Filters.h)

  double perturbation; ///< for perturbedDeterminant() (Filters.h)

  /// Are there errors that are 0: are the coordinates multiples, not too large, of some unit?
  bool isOnGrid() const { return exactBelow > 0.0; }
};

/// Puts points into the frame of an insertion, and takes them out again:
/// - Where coordinates are so small or so large that squares of determinants would underflow or
///   overflow, all are multiplied by one power of two, if that is exact for each. In-circle and
///   orientation determinants keep their signs, and so does the order of locations.
/// - The ghost gets a location far away, so that the filters answer for it, too (kGhostDistance in
///   Filters.h).
/// The frame is a function of the set of points.
class Framing
{
public:
  explicit Framing(RankedPoints& points)
    : points_(points)
  {
  }

  /// Cost: nothing, or one pass over coordinates that have few bits or need scaling.
  /// Returns false if cancelled; then the locations are of no use.
  bool begin(Ticker& ticker);
  /// Restores the points, the ghost included.
  bool end(Ticker& ticker);

  Frame frame() const { return { points_, guard_, squaredGuard_, exactBelow_, perturbation_ }; }

private:
  bool multiplyBy(double factor, Ticker& ticker);
  bool scalesExactly(double factor, Ticker& ticker, bool& isExact) const;
  bool findUnit(Ticker& ticker);

  RankedPoints& points_;
  int exponent_ = 0; ///< all coordinates are below 2 to this power
  double scale_ = 1.0;
  double guard_ = 0.0;
  double squaredGuard_ = 0.0;
  double exactBelow_ = -1.0;
  double perturbation_ = 0.0;
};

} // namespace ahd

#endif
