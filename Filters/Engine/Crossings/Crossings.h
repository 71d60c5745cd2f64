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

/// A point added where two segments cross, and where that is on them. Segments are those of the
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

  /// Two of them again, for what is interpolated: of the pairs that cross there the first one by
  /// places, left end, then right end. Neither the order of the segments nor their directions have
  /// a say.
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

/// What splitAtCrossings gives.
struct SplitConstraints
{
  /// Added points; their ids go on where those given end: point k has the id points.count + k. In
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

  /// Segments that were led through a vertex that is not exactly on them, and so bend: through an
  /// end of another one, or a point that was there already. Each once, ascending.
  std::vector<SegmentName> bent;

  std::size_t crossings = 0;  ///< pairs of segments that crossed, those of all rounds together
  std::size_t unresolved = 0; ///< pairs that still cross after the last round
  int rounds = 0;             ///< rounds of splitting that were needed

  /// The chains, as constrain() takes them. This object is to outlive the view.
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

/// After so many rounds of splitting no further is begun.
constexpr int kMostSplittingRounds = 16;

/// Splits the segments of the chains where they cross.
///
/// Two segments cross if they have one point in common that is an end of neither. Segments that
/// only touch, share an end or overlap do not cross. This is decided exactly. Segments of no
/// length, and those with an end that is not finite, is left out (PointView::skip) or is no point
/// at all, are kept and cross nothing; so are chains that have no segment. Ids that are no point's
/// become -1, as they might name an added point otherwise.
///
/// A point rounds to the nearest double in each coordinate, ties to even. Where a point of one of
/// the two rounds to an end of the other, the one is led through that end, and no point is needed.
/// Else the point added is the exact crossing, rounded: one point however many segments cross there
/// and whichever way they run. Where it coincides with a point that is given, that one is used: the
/// one of smallest id, but before all others those that are ends of segments. So whatever is put
/// into a segment is a point of it, rounded, and the pieces run within its box, in the same
/// directions as it does.
///
/// The pieces are bent by this and may cross others. So it is repeated until nothing crosses, or
/// until kMostSplittingRounds rounds are over. Without the rule for ends, segments that differ
/// in their last bits only would cross ever more often; with it they still may, tens of copies of
/// one line cross some thousand times.
///
/// The points of the result and the pieces, as a set of pairs of places, are a function of the set
/// of the segments: neither their order nor their directions have a say.
///
/// `progress` may be null; the phase is Phase::Split. Returns Ok, Cancelled, OutOfMemory,
/// TooManyPoints if there are more than kMaximumPoints, the added ones included, or more than
/// 2^31 ids in the chains, or TooManyCrossings as soon as there are more than `mostCrossings`
/// places to lead segments through, or four times as many pairs that cross, those that pass exactly
/// through one place not counted each; unless Ok, `out` is not to be used. Takes
/// splitMemoryEstimate() bytes for no crossings at most, and what it asks for (Progress::take()):
/// for crossings as they are found, and for a search by strips if it comes to that. Cost: for n
/// segments with k crossings n log^2 n + k log n steps a round at most, where k does not count
/// pairs of those that pass exactly through one place; mostly one round splits, and the second
/// finds nothing, quickly.
Status splitAtCrossings(const PointView& points, const ConstraintView& chains, Progress* progress,
  SplitConstraints& out, std::size_t mostCrossings = std::size_t(-1));

/// Upper estimate of the bytes that it takes, `out` included, for so many segments and crossings,
/// but for a search by strips. Segments: a loop has as many as ids, a line one less; of lines
/// without an id, which few have, that may be one less than none.
std::size_t splitMemoryEstimate(std::size_t segments, std::size_t crossings);

} // namespace ahd

#endif
