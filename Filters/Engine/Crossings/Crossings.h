// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Crossings_h
#define ahd_Crossings_h

#include "../Constraints.h"
#include "../Core/Progress.h"
#include "../Points/Points.h"
#include "../Result.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// A point added where two segments cross, and its position on them. Segments are those of the
/// input: segment k of a chain runs from its point k to the next, the last one of a loop to point
/// 0.
struct CrossingPoint
{
  Point at;
  std::size_t chainA, segmentA; ///< the first segment on which it lies, in the order of the chains
  double alongA; ///< 0 to 1: the fraction of the way from its first end to its second
  std::size_t chainB,
    segmentB; ///< the next one; a point on more than two names the first two found
  double alongB;

  /// Two of them again, for interpolation: of the pairs that cross there the first one by places,
  /// left end, then right end, whatever the order and directions of the segments.
  struct Side
  {
    std::size_t chain, segment;
    double along; ///< from the lexicographically smaller end to the other
  };
  Side lower, upper;
};

/// A segment of the input.
struct SegmentName
{
  std::size_t chain, segment;
};

/// The result of splitAtCrossings().
struct SplitConstraints
{
  /// Added points; their ids follow the given ones: point k has the id points.count + k. In
  /// the order of the segments, then along them; those of a later round come after.
  std::vector<CrossingPoint> points;

  /// The chains with the added points in them: as many as before, of the same kinds and in the same
  /// order; see view().
  std::vector<std::int64_t> ids;
  std::vector<std::int64_t> offsets;
  std::size_t lines = 0;
  /// For each entry of `ids` the number, within its chain, of the input's segment that leads on
  /// from there; the last point of a line repeats that of the segment before it.
  std::vector<std::int64_t> segments;

  /// Segments that bend because they were led through a vertex not exactly on them: an end of
  /// another one, or an existing point. Each once, ascending.
  std::vector<SegmentName> bent;

  std::size_t crossings = 0;  ///< pairs of segments that crossed, those of all rounds together
  std::size_t unresolved = 0; ///< pairs that still cross after the last round
  int rounds = 0;             ///< rounds of splitting that were needed

  /// The chains, as constrain() takes them. The view borrows this object.
  ConstraintView view() const
  {
    ConstraintView result;
    result.ids = ids.data();
    result.offsets = offsets.data();
    result.chains = offsets.empty() ? 0 : offsets.size() - 1;
    result.lines = lines;
    return result;
  }
};

/// The most rounds of splitting.
constexpr int kMostSplittingRounds = 16;

/// Splits the segments of the chains where they cross.
///
/// Two segments cross if they have one point in common that is an end of neither; touching, shared
/// ends and overlaps are no crossings. This is decided exactly. Segments of no length, and those
/// with an end that is not finite, left out (PointView::skip) or no point at all, are kept and
/// cross nothing; so are chains without a segment. Ids that are no point's become -1, since they
/// might otherwise name an added point.
///
/// A point rounds to the nearest double in each coordinate, ties to even. Where a point of one of
/// the two rounds to an end of the other, the one is led through that end, and no point is added.
/// Otherwise the added point is the exact crossing, rounded: one point however many segments cross
/// there and whatever their directions. If it coincides with a given point, that one is used: the
/// one of smallest id, ends of segments before all others. So every point put into a segment is a
/// point of it, rounded, and the pieces run within its box, in its direction.
///
/// Rounding bends the pieces, which may cross others. So splitting is repeated until nothing
/// crosses, or for kMostSplittingRounds rounds. Without the rule for ends, segments that differ in
/// their last bits only would cross ever more often; with it tens of copies of one line cross some
/// thousand times.
///
/// The added points and the pieces, as a set of pairs of places, are a function of the set of the
/// segments, whatever their order and directions.
///
/// The phase is Phase::Split. Takes at most splitMemoryEstimate() bytes for no crossings, and
/// requests (Progress::take()) for crossings as they are found, and for a search by strips if
/// needed. Cost: for n segments with k crossings at most n log^2 n + k log n steps a round, where k
/// does not count pairs exactly through one place; usually one round splits, and the second finds
/// nothing, quickly.
///
/// @param progress may be null
/// @param out undefined unless the result is Ok
/// @param mostCrossings limit on the places to lead segments through; the search stops at four
///   times as many crossing pairs, without counting each of those exactly through one place
/// @return Ok, Cancelled, OutOfMemory, TooManyCrossings, or TooManyPoints: more than
///   kMaximumPoints, added ones included, or more than 2^31 ids in the chains
Status splitAtCrossings(const PointView& points, const ConstraintView& chains, Progress* progress,
  SplitConstraints& out, std::size_t mostCrossings = std::size_t(-1));

/// Upper bound of the bytes that it takes, `out` included, except for a search by strips. Segments:
/// a loop has as many as ids, a line one less (so a line without an id may count as minus one).
std::size_t splitMemoryEstimate(std::size_t segments, std::size_t crossings);

} // namespace ahd

#endif
