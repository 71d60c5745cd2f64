// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Hubs_h
#define ahd_Hubs_h

#include "../Core/Progress.h"
#include "BoxTree.h"
#include "Pieces.h"
#include "PlaceTable.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// Places where many pieces cross exactly, such as the middle of a star of diameters: m of them
/// have m (m - 1) / 2 pairs, which need not be looked at one by one.
///
/// A hub is a place with pieces that all pass exactly through it, and so cleanly that none of them
/// rounds to an end of another (roundsTo()). So any two of them that are not collinear cross there
/// and need a point there; a few pairs that name all pieces suffice. A piece cut at its hubs is the
/// same segment in parts: nothing crosses it elsewhere than before, and nothing crosses at the hub
/// any more.
class Hubs
{
public:
  /// A piece, or its part between two hubs.
  struct Part
  {
    Segment segment;
    Index piece;
  };

  explicit Hubs(Ticker& ticker)
    : ticker_(ticker)
    , tried_(ticker)
  {
  }

  /// Was look() called?
  bool hasLooked() const { return !isIn_.empty(); }

  /// Looks for each piece of the last tree where the first few that cross it do, and makes hubs of
  /// places that several of them have. Takes at most L^2 steps for a piece and L^2 for each piece
  /// of a hub, L = log2 of their number; so it may miss some. Returns false if cancelled. Throws
  /// std::bad_alloc.
  bool look(const Pieces& pieces, const std::vector<BoxTree>& trees);

  /// Looks where the crossings lie, which are some of those there are, and makes hubs of places
  /// with many of them. Returns false if cancelled. Throws std::bad_alloc.
  bool add(const Pieces& pieces, const std::vector<Crossing>& crossings);

  std::size_t count() const { return places_.size(); }

  /// The largest number of parts.
  std::size_t mostParts(const Pieces& pieces) const;

  /// Lists all pieces that are not dead, cut at the hubs.
  bool listParts(const Pieces& pieces, std::vector<Part>& parts);

  /// Adds crossings so that each piece is in one at each of its hubs, and that the first pair by
  /// positions and the first one by places are there. Adds to `unlisted` how many more pairs cross
  /// at the hubs: less than nothing, modulo 2^64, where one is listed twice.
  bool addCrossings(const Pieces& pieces, std::vector<Crossing>& crossings, std::size_t& unlisted);

private:
  struct Cut
  {
    Index piece;
    Point at;
  };
  struct Place
  {
    Point at;
    std::vector<Index> pieces;        ///< by directions
    std::vector<std::size_t> classes; ///< where those of one direction begin, and the end
  };

  struct Pair
  {
    Index first, second;
    std::size_t begin, end; ///< the class of the first
  };

  template <typename Before>
  Pair firstPair(const Place& place, Before before) const;
  bool listPlaces(
    const Pieces& pieces, const std::vector<Crossing>& crossings, std::vector<Point>& places);
  bool lookFrom(Index piece, const Pieces& pieces, const std::vector<BoxTree>& trees);
  bool makeHubBy(const Point& p, const Pieces& pieces, const std::vector<BoxTree>& trees);
  bool isTried(const Point& p) const { return tried_.find(p) != kNoIndex; }
  bool noteTried(const Point& p);
  bool makeHub(const Pieces& pieces, const Point& p);
  bool keepIfHub(const Pieces& pieces, Place& place);
  bool sortByDirection(const Pieces& pieces, Place& place);
  bool isClean(const Pieces& pieces, const Place& place) const;

  Ticker& ticker_;
  std::vector<Place> places_;
  PlaceTable tried_;          ///< hubs, and places that are none
  std::vector<bool> isIn_;    ///< of each piece: is it in a hub that look() found?
  std::size_t stepsLeft_ = 0; ///< of look()
};

} // namespace ahd

#endif
