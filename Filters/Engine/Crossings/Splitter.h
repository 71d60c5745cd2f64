// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Splitter_h
#define ahd_Splitter_h

#include "../Core/AskedMemory.h"
#include "../Core/Buffer.h"
#include "Crossings.h"
#include "PieceSearch.h"
#include "PlaceTable.h"
#include "Way.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// A place on a segment or a piece: the numbers of both. Sorted as packed numbers.
using OnSegment = std::uint64_t;
inline Index ownerOf(OnSegment item)
{
  return static_cast<Index>(item >> 32);
}
inline Index placeOf(OnSegment item)
{
  return static_cast<Index>(item);
}

/// The range of one piece in a list sorted by pieces.
struct OnPiece
{
  Index position; ///< of its segment
  std::size_t begin, end;
};

/// One of them, in the order along a piece or segment.
struct PlaceAlong
{
  Point at;
  Index place;
};

/// A point that a segment is led through.
struct Inserted
{
  Index position; ///< of the segment
  Index place;
  Index id;
};

/// One call of splitAtCrossings().
class Splitter
{
public:
  Splitter(const PointView& points, const ConstraintView& chains, Ticker& ticker,
    SplitConstraints& out, std::size_t mostCrossings)
    : points_(points)
    , chains_(chains)
    , ticker_(ticker)
    , out_(out)
    , first_(chains.chains == 0 ? 0 : std::size_t(chains.offsets[0]))
    , ids_(chains.chains == 0 ? 0 : std::size_t(chains.offsets[chains.chains]) - first_)
    , most_(mostCrossings)
    , taken_(ticker)
    , emptyLines_(ticker)
    , search_(ticker)
    , places_(ticker)
  {
  }

  Status run();

private:
  /// Where two pieces are led through: a place, or ends of theirs.
  struct Meeting
  {
    bool isAtEnds;
    Point at;
  };
  struct Named;

  void makeRoom();
  bool listPieces();
  bool split();
  void takeFor(std::size_t places);
  Meeting meetingOf(Crossing crossing) const;
  bool meet(Crossing crossing, const Meeting& meeting);
  void nameSegments(PlaceTable::Place& place, Index a, Index b) const;
  bool comesBeforeByPlaces(std::array<Index, 2> pair, std::array<Index, 2> other) const;
  bool takeEnds(Index piece, Index other);
  bool findIds();
  bool findEnds();
  bool findPoints();
  bool sortInsertions();
  bool listOnPieces();
  bool reserveForPieces();
  bool splitPieces();
  bool splitPiece(const OnPiece& on);
  void addPointsOn(Index position);
  bool makeChains();
  bool nameBent();

  void addPiece(Piece piece);
  bool isBeside(Index position, const Point& p) const;

  bool sortInserted();
  bool sortAlong(const Way& way, const OnSegment* items, std::size_t count);

  std::int64_t given(std::size_t position) const { return chains_.ids[first_ + position]; }
  bool isUsable(std::int64_t id) const;
  Named named(Index position) const;
  CrossingPoint described(const PlaceTable::Place& place, const Named& first) const;
  Point at(std::int64_t id) const;
  Way wayOf(const SegmentName& name) const;
  SegmentName nameOf(Index position) const;

  const PointView& points_;
  const ConstraintView& chains_;
  Ticker& ticker_;
  SplitConstraints& out_;
  std::size_t first_;           ///< where the ids of the chains begin
  std::size_t ids_;             ///< how many there are; positions are counted from first_
  std::size_t most_;            ///< places that there may be
  TakenMemory taken_;           ///< for places and pairs
  TakenMemory emptyLines_;      ///< which the estimate takes for lines of one id
  std::size_t pairsBefore_ = 0; ///< that were listed in the rounds before
  PieceSearch search_;
  Pieces pieces_;
  std::size_t segments_ = 0; ///< so many pieces, the first, are the segments given
  Pieces more_;              ///< not searched yet
  FoundCrossings found_;
  PlaceTable places_;
  std::size_t named_ = 0;             ///< so many places, the first, have ids
  std::size_t addedBefore_ = 0;       ///< points added in the rounds before
  std::vector<OnSegment> insertions_; ///< this round's: by pieces
  Buffer<OnSegment> sorted_;          ///< these, sorted
  std::vector<OnPiece> onPieces_;     ///< in the order of the segments, then along them
  std::vector<PlaceAlong> along_;     ///< on one of them
  std::vector<Inserted> inserted_;    ///< in all rounds, those of one as in onPieces_
  std::vector<Index> bent_;           ///< positions
};

} // namespace ahd

#endif
