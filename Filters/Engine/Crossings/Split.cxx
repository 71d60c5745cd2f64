// SPDX-License-Identifier: BSD-3-Clause
#include "Crossings.h"

#include "../Core/Border.h"
#include "../Core/SortAsking.h"
#include "../Order/RadixSort.h"
#include "../Predicates/Predicates.h"
#include "PieceSearch.h"
#include "PlaceTable.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace ahd
{
namespace
{

/// What ids that are those of no point become.
constexpr std::int64_t kNoPoint = -1;

/// Most ids in the chains. Tests of what is refused are compiled with fewer.
#ifndef AHD_MOST_CHAIN_IDS
#define AHD_MOST_CHAIN_IDS (std::size_t(1) << 31)
#endif
constexpr std::size_t kMostIds = AHD_MOST_CHAIN_IDS;

/// From where to where a segment runs.
struct Way
{
  Point from;
  Point to;

  Segment leftToRight() const
  {
    return lexicographicallyLess(from, to) ? Segment{ from, to } : Segment{ to, from };
  }

  /// Does it pass a before b? REQUIRES: both are points on it, rounded, which is monotone in each
  /// coordinate; so they are in the order of both.
  bool isBefore(const Point& a, const Point& b) const
  {
    return a.x != b.x ? (a.x < b.x) == (from.x < to.x)
                      : a.y != b.y && (a.y < b.y) == (from.y < to.y);
  }
};

/// What lies on a segment or a piece: the number of that, and of a place. Sorted as packed numbers.
using OnSegment = std::uint64_t;
Index ownerOf(OnSegment item)
{
  return static_cast<Index>(item >> 32);
}
Index placeOf(OnSegment item)
{
  return static_cast<Index>(item);
}

/// A point that a segment is led through.
struct Inserted
{
  Index position; ///< of the segment
  Index place;
  Index id;
};

class Splitter
{
public:
  Splitter(
    const PointView& points, const ConstraintView& chains, Ticker& ticker, SplitConstraints& out)
    : points_(points)
    , chains_(chains)
    , ticker_(ticker)
    , out_(out)
    , first_(chains.chains == 0 ? 0 : std::size_t(chains.offsets[0]))
    , ids_(chains.chains == 0 ? 0 : std::size_t(chains.offsets[chains.chains]) - first_)
    , search_(ticker)
    , places_(ticker)
  {
  }

  Status run();

private:
  bool listPieces();
  bool split();
  bool meet(Crossing crossing);
  void nameSegments(PlaceTable::Place& place, Index a, Index b) const;
  bool comesBeforeByPlaces(std::array<Index, 2> pair, std::array<Index, 2> other) const;
  bool takeEnds(Index piece, Index other, bool& takesOne);
  bool findIds();
  bool findEnds();
  bool findPoints();
  bool addPoints();
  bool splitPieces();
  bool splitPiece(Index piece, const OnSegment* begin, const OnSegment* end);
  bool makeChains();
  bool nameBent();

  void addPiece(Piece piece);
  bool isBeside(Index position, const Point& p) const;

  template <typename WayOfOwner>
  bool sortGroups(WayOfOwner wayOfOwner, Buffer<OnSegment>& sorted);
  bool sortInserted(Buffer<OnSegment>& sorted);
  bool sortOn(const Way& way, OnSegment* items, std::size_t count);
  template <typename WayOfOwner>
  bool sortAlong(
    const std::vector<OnSegment>& items, WayOfOwner wayOfOwner, Buffer<OnSegment>& sorted);

  std::int64_t given(std::size_t position) const { return chains_.ids[first_ + position]; }
  bool isUsable(std::int64_t id) const;
  CrossingPoint described(const PlaceTable::Place& place) const;
  Point at(std::int64_t id) const;
  Way wayOf(const SegmentName& name) const;
  SegmentName nameOf(Index position) const;

  const PointView& points_;
  const ConstraintView& chains_;
  Ticker& ticker_;
  SplitConstraints& out_;
  std::size_t first_; ///< where the ids of the chains begin
  std::size_t ids_;   ///< how many there are; positions are counted from first_
  PieceSearch search_;
  Pieces pieces_;
  std::size_t segments_ = 0; ///< so many pieces, the first, are the segments given
  Pieces more_;              ///< not searched yet
  FoundCrossings found_;
  PlaceTable places_;
  std::size_t named_ = 0;             ///< so many places, the first, have ids
  std::size_t addedBefore_ = 0;       ///< points added in the rounds before
  std::vector<OnSegment> insertions_; ///< this round's: by pieces
  std::vector<Inserted> inserted_;    ///< in all rounds
  std::vector<Index> bent_;           ///< positions
};

Status Splitter::run()
{
  if (points_.count > kMaximumPoints)
  {
    return Status::TooManyPoints;
  }
  out_ = SplitConstraints();
  if (ids_ <= kMostIds && !listPieces())
  {
    return Status::Cancelled;
  }
  for (;; ++out_.rounds)
  {
    if (ids_ + inserted_.size() > kMostIds || pieces_.size() + more_.size() >= kNoIndex ||
      points_.count + out_.points.size() > kMaximumPoints)
    {
      return Status::TooManyPoints;
    }
    if (!search_.find(more_, pieces_, found_))
    {
      return Status::Cancelled;
    }
    if (found_.count() == 0 || out_.rounds == kMostSplittingRounds)
    {
      out_.unresolved = found_.count();
      return makeChains() && nameBent() && ticker_.ask() ? Status::Ok : Status::Cancelled;
    }
    more_.clear();
    out_.crossings += found_.count();
    if (!split())
    {
      return Status::Cancelled;
    }
  }
}

/// The segments that are not said to cross nothing.
bool Splitter::listPieces()
{
  more_.reserve(ids_);
  for (std::size_t chain = 0; chain < chains_.chains; ++chain)
  {
    const std::size_t begin = std::size_t(chains_.offsets[chain]) - first_;
    const std::size_t end = std::size_t(chains_.offsets[chain + 1]) - first_;
    const auto list = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        const std::int64_t from = given(k), to = given(k + 1 == end ? begin : k + 1);
        if (!isUsable(from) || !isUsable(to))
        {
          continue;
        }
        const Point p = at(from), q = at(to);
        const auto i = static_cast<Index>(from), j = static_cast<Index>(to);
        const auto position = static_cast<Index>(k);
        if (lexicographicallyLess(p, q))
        {
          more_.push_back({ { p, q }, i, j, position, true, false });
        }
        else if (!(p == q))
        {
          more_.push_back({ { q, p }, j, i, position, false, false });
        }
      }
    };
    const std::size_t closing = chain < chains_.lines && begin != end ? 1 : 0;
    if (!inChunks(begin, end - closing, ticker_, list) || !ticker_.step())
    {
      return false;
    }
  }
  segments_ = more_.size();
  return true;
}

// --------------------------------------------------------------------------- splitting, one round

bool Splitter::split()
{
  insertions_.clear();
  if (!places_.reserve(places_.size() + found_.listed.size()))
  {
    return false;
  }
  for (const Crossing& crossing : found_.listed)
  {
    if (!meet(crossing) || !ticker_.step())
    {
      return false;
    }
  }
  return findIds() && addPoints() && splitPieces();
}

/// Leads one of two pieces through an end of the other, or both through where they cross.
bool Splitter::meet(Crossing crossing)
{
  bool isEndOfA = false, isEndOfB = false;
  if (!takeEnds(crossing.a, crossing.b, isEndOfB) || !takeEnds(crossing.b, crossing.a, isEndOfA))
  {
    return false;
  }
  if (isEndOfA || isEndOfB)
  {
    return true;
  }
  const Piece &a = pieces_[crossing.a], &b = pieces_[crossing.b];
  const Point p = crossingOf(a.segment, b.segment);
  Index number = kNoIndex;
  if (!places_.add(p, number))
  {
    return false;
  }
  nameSegments(places_[number], a.position, b.position);
  for (const Index piece : { crossing.a, crossing.b })
  {
    const Segment& segment = pieces_[piece].segment;
    if (!(p == segment.left || p == segment.right))
    {
      insertions_.push_back(packed(piece, number));
    }
  }
  return true;
}

/// Two segments cross at the place: they may be the first ones.
void Splitter::nameSegments(PlaceTable::Place& place, Index a, Index b) const
{
  const bool isOnly = place.first == kNoIndex;
  const std::pair<Index, Index> pair = std::minmax({ a, b });
  if (pair < std::make_pair(place.first, place.second))
  {
    place.first = pair.first;
    place.second = pair.second;
  }
  if (isOnly || comesBeforeByPlaces({ a, b }, { place.lower, place.upper }))
  {
    place.lower = a;
    place.upper = b;
  }
}

/// Does a pair of segments come before another one, by the places of their ends alone?
bool Splitter::comesBeforeByPlaces(std::array<Index, 2> pair, std::array<Index, 2> other) const
{
  const auto endsOf = [&](const std::array<Index, 2>& positions)
  {
    std::array<Segment, 2> ends = { { wayOf(nameOf(positions[0])).leftToRight(),
      wayOf(nameOf(positions[1])).leftToRight() } };
    if (comesBefore(ends[1], ends[0]))
    {
      std::swap(ends[0], ends[1]);
    }
    return ends;
  };
  const auto ends = endsOf(pair), others = endsOf(other);
  return comesBefore(ends[0], others[0]) ||
    (!comesBefore(others[0], ends[0]) && comesBefore(ends[1], others[1]));
}

/// Lets a piece go through those ends of another one to which it rounds.
bool Splitter::takeEnds(Index piece, Index other, bool& takesOne)
{
  const Segment& segment = pieces_[piece].segment;
  for (const Point& end : { pieces_[other].segment.left, pieces_[other].segment.right })
  {
    if (roundsTo(segment, end))
    {
      Index number = kNoIndex;
      if (!places_.add(end, number))
      {
        return false;
      }
      insertions_.push_back(packed(piece, number));
      takesOne = true;
    }
  }
  return true;
}

/// The ids of points that are at the places that are new.
bool Splitter::findIds()
{
  if (named_ == places_.size())
  {
    return true;
  }
  const auto choose = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      PlaceTable::Place& place = places_[static_cast<Index>(k)];
      place.id = place.endId != kNoIndex ? place.endId : place.pointId;
    }
  };
  return findEnds() && findPoints() && inChunks(named_, places_.size(), ticker_, choose);
}

/// Ends are those of the segments given: all others are in the table, as pieces are led through
/// them.
bool Splitter::findEnds()
{
  const auto look = [&](const Point& p, Index id)
  {
    const Index number = places_.find(p);
    if (number != kNoIndex && number >= named_)
    {
      places_[number].endId = std::min(places_[number].endId, id);
    }
  };
  return inChunks(0, segments_, ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        look(pieces_[k].segment.left, pieces_[k].leftId);
        look(pieces_[k].segment.right, pieces_[k].rightId);
      }
    });
}

bool Splitter::findPoints()
{
  return inChunks(0, points_.count, ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t id = a; id != b; ++id)
      {
        const Index number = places_.find(points_[id]);
        if (number != kNoIndex && number >= named_ && isUsable(std::int64_t(id)))
        {
          places_[number].pointId = std::min(places_[number].pointId, static_cast<Index>(id));
        }
      }
    });
}

/// Adds a point for each new place without one: in the order of the first segments there, then
/// along them.
bool Splitter::addPoints()
{
  std::vector<OnSegment> news;
  const auto list = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      const auto number = static_cast<Index>(k);
      if (places_[number].id == kNoIndex)
      {
        news.push_back(packed(places_[number].first, number));
      }
    }
  };
  addedBefore_ = out_.points.size();
  Buffer<OnSegment> sorted;
  const auto wayOfOwner = [&](Index position) { return wayOf(nameOf(position)); };
  const auto add = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      PlaceTable::Place& place = places_[placeOf(sorted[k])];
      place.id = static_cast<Index>(points_.count + out_.points.size());
      out_.points.push_back(described(place));
    }
  };
  return inChunks(named_, places_.size(), ticker_, list) && sortAlong(news, wayOfOwner, sorted) &&
    inChunks(0, sorted.size(), ticker_, add);
}

CrossingPoint Splitter::described(const PlaceTable::Place& place) const
{
  struct Named
  {
    SegmentName name;
    Way way;
  };
  const auto named = [&](Index position)
  {
    const SegmentName name = nameOf(position);
    return Named{ name, wayOf(name) };
  };
  const Named a = named(place.first), b = named(place.second);
  const auto again = [&](Index position) {
    return position == place.first ? a : position == place.second ? b : named(position);
  };
  const Named lower = again(place.lower), upper = again(place.upper);
  const auto along = [&](const Point& from, const Point& to)
  { return fractionOfWay(from, to, place.at); };
  const auto side = [&](const Named& n)
  {
    const Segment s = n.way.leftToRight();
    return CrossingPoint::Side{ n.name.chain, n.name.segment, along(s.left, s.right) };
  };
  const bool inOrder = !comesBefore(upper.way.leftToRight(), lower.way.leftToRight());
  return { place.at, a.name.chain, a.name.segment, along(a.way.from, a.way.to), b.name.chain,
    b.name.segment, along(b.way.from, b.way.to), side(inOrder ? lower : upper),
    side(inOrder ? upper : lower) };
}

/// Sorts by owners, then along them; equal ones are kept.
template <typename WayOfOwner>
bool Splitter::sortAlong(
  const std::vector<OnSegment>& items, WayOfOwner wayOfOwner, Buffer<OnSegment>& sorted)
{
  const std::size_t n = items.size();
  sorted.allocate(n);
  const auto copy = [&](std::size_t a, std::size_t b)
  { std::copy(items.data() + a, items.data() + b, sorted.data() + a); };
  return inChunks(0, n, ticker_, copy) && sortPacked(sorted, n, ticker_) &&
    sortGroups(wayOfOwner, sorted);
}

/// The same for what is sorted by owners.
template <typename WayOfOwner>
bool Splitter::sortGroups(WayOfOwner wayOfOwner, Buffer<OnSegment>& sorted)
{
  const std::size_t n = sorted.size();
  for (std::size_t begin = 0, end = 0; begin != n; begin = end)
  {
    while (end != n && ownerOf(sorted[end]) == ownerOf(sorted[begin]))
    {
      ++end;
      if (!ticker_.step())
      {
        return false;
      }
    }
    if (end - begin > 1 && !sortOn(wayOfOwner(ownerOf(sorted[begin])), &sorted[begin], end - begin))
    {
      return false;
    }
  }
  return true;
}

/// Sorts what is on one segment.
bool Splitter::sortOn(const Way& way, OnSegment* items, std::size_t count)
{
  struct Item
  {
    Point at;
    OnSegment item;
  };
  const auto comesBefore = [&](const Item& i, const Item& k) { return way.isBefore(i.at, k.at); };
  std::vector<Item> sorted;
  sorted.reserve(count);
  for (std::size_t k = 0; k != count; ++k)
  {
    sorted.push_back({ places_[placeOf(items[k])].at, items[k] });
    if (!ticker_.step())
    {
      return false;
    }
  }
  return sortAsking(sorted, ticker_, comesBefore) &&
    inChunks(0, count, ticker_,
      [&](std::size_t a, std::size_t b)
      {
        for (std::size_t k = a; k != b; ++k)
        {
          items[k] = sorted[k].item;
        }
      });
}

/// Replaces the pieces that are led through places.
bool Splitter::splitPieces()
{
  Buffer<OnSegment> sorted;
  const auto wayOfOwner = [&](Index piece)
  {
    const Segment& s = pieces_[piece].segment;
    return pieces_[piece].isForward ? Way{ s.left, s.right } : Way{ s.right, s.left };
  };
  if (!sortAlong(insertions_, wayOfOwner, sorted))
  {
    return false;
  }
  more_.reserve(2 * sorted.size()); // at most
  inserted_.reserve(inserted_.size() + sorted.size());
  for (std::size_t begin = 0, end = 0; begin != sorted.size(); begin = end)
  {
    while (end != sorted.size() && ownerOf(sorted[end]) == ownerOf(sorted[begin]))
    {
      ++end;
    }
    if (!splitPiece(ownerOf(sorted[begin]), &sorted[begin], &sorted[begin] + (end - begin)))
    {
      return false;
    }
  }
  named_ = places_.size();
  return true;
}

/// The places are in order along the piece; one may come several times in a row.
bool Splitter::splitPiece(Index piece, const OnSegment* begin, const OnSegment* end)
{
  pieces_[piece].isDead = true;
  const Piece whole = pieces_[piece];
  Piece rest = whole;
  rest.isDead = false;
  for (const OnSegment* item = begin; item != end; ++item)
  {
    if (!ticker_.step())
    {
      return false;
    }
    if (item != begin && placeOf(*item) == placeOf(item[-1]))
    {
      continue; // several pieces may cross this one there
    }
    const PlaceTable::Place& place = places_[placeOf(*item)];
    Piece next = rest;
    (whole.isForward ? next.segment.right : next.segment.left) = place.at;
    (whole.isForward ? next.rightId : next.leftId) = place.id;
    (whole.isForward ? rest.segment.left : rest.segment.right) = place.at;
    (whole.isForward ? rest.leftId : rest.rightId) = place.id;
    addPiece(next);
    inserted_.push_back({ whole.position, placeOf(*item), place.id });
    if (place.id < points_.count + addedBefore_ && isBeside(whole.position, place.at))
    {
      bent_.push_back(whole.position);
    }
  }
  addPiece(rest);
  return true;
}

/// Where a piece is vertical, as others of its segment need not be, its left end may be another.
void Splitter::addPiece(Piece piece)
{
  if (lexicographicallyLess(piece.segment.right, piece.segment.left))
  {
    std::swap(piece.segment.left, piece.segment.right);
    std::swap(piece.leftId, piece.rightId);
    piece.isForward = !piece.isForward;
  }
  more_.push_back(piece);
}

/// Is the place not exactly on the segment?
bool Splitter::isBeside(Index position, const Point& p) const
{
  const Way way = wayOf(nameOf(position));
  return orient2d(way.from, way.to, p) != 0;
}

// ------------------------------------------------------------------------------------- the result

/// Sorts what was inserted by segments, then along them. What one round inserted into one segment
/// comes in a row, in order; a later round may have gone on between.
bool Splitter::sortInserted(Buffer<OnSegment>& sorted)
{
  const std::size_t n = inserted_.size();
  std::vector<OnSegment> items;
  sorted.allocate(n);
  const auto list = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      sorted[k] = packed(inserted_[k].position, static_cast<Index>(k));
    }
  };
  const auto name = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      const Inserted& inserted = inserted_[static_cast<Index>(sorted[k])];
      sorted[k] = packed(inserted.position, inserted.place);
    }
  };
  const auto wayOfOwner = [&](Index position) { return wayOf(nameOf(position)); };
  return inChunks(0, n, ticker_, list) && sortPacked(sorted, n, ticker_) &&
    inChunks(0, n, ticker_, name) && (out_.rounds < 2 || sortGroups(wayOfOwner, sorted));
}

bool Splitter::makeChains()
{
  Buffer<OnSegment> sorted;
  if (!sortInserted(sorted))
  {
    return false;
  }
  out_.lines = chains_.lines;
  out_.ids.reserve(ids_ + sorted.size());
  out_.segments.reserve(ids_ + sorted.size());
  out_.offsets.reserve(chains_.chains + 1);
  out_.offsets.push_back(0);
  std::size_t next = 0;
  for (std::size_t chain = 0; chain < chains_.chains; ++chain)
  {
    const std::size_t begin = std::size_t(chains_.offsets[chain]) - first_;
    const std::size_t end = std::size_t(chains_.offsets[chain + 1]) - first_;
    const std::size_t last = end - begin - (chain < chains_.lines && end - begin > 1 ? 2 : 1);
    for (std::size_t k = begin; k != end; ++k)
    {
      const auto segment = std::int64_t(std::min(k - begin, last));
      out_.ids.push_back(std::size_t(given(k)) < points_.count ? given(k) : kNoPoint);
      out_.segments.push_back(segment);
      for (; next != sorted.size() && ownerOf(sorted[next]) == k; ++next)
      {
        out_.ids.push_back(places_[placeOf(sorted[next])].id);
        out_.segments.push_back(segment);
        if (!ticker_.step())
        {
          return false;
        }
      }
      if (!ticker_.step())
      {
        return false;
      }
    }
    out_.offsets.push_back(std::int64_t(out_.ids.size()));
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

bool Splitter::nameBent()
{
  const auto list = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      if (k == 0 || bent_[k - 1] != bent_[k])
      {
        out_.bent.push_back(nameOf(bent_[k]));
      }
    }
  };
  return sortAsking(bent_, ticker_, std::less<>()) && inChunks(0, bent_.size(), ticker_, list);
}

// ---------------------------------------------------------------------------------- what is where

bool Splitter::isUsable(std::int64_t id) const
{
  const auto k = static_cast<std::size_t>(id);
  return id >= 0 && k < points_.count && !points_.skipped(k) && isFinite(points_[k]);
}

Point Splitter::at(std::int64_t id) const
{
  return points_[static_cast<std::size_t>(id)];
}

SegmentName Splitter::nameOf(Index position) const
{
  const auto place = static_cast<std::int64_t>(first_ + position);
  const std::int64_t* const offsets = chains_.offsets;
  std::size_t chain = std::size_t(position) * chains_.chains / ids_; // if all are of one length
  if (!(offsets[chain] <= place && place < offsets[chain + 1]))
  {
    const std::int64_t* const end = offsets + chains_.chains + 1;
    chain = std::size_t(std::upper_bound(offsets, end, place) - offsets) - 1;
  }
  return { chain, first_ + position - std::size_t(chains_.offsets[chain]) };
}

/// REQUIRES: a segment of a piece.
Way Splitter::wayOf(const SegmentName& name) const
{
  const auto begin = std::size_t(chains_.offsets[name.chain]);
  const std::size_t k = begin + name.segment;
  const bool closes = k + 1 == std::size_t(chains_.offsets[name.chain + 1]);
  return { at(chains_.ids[k]), at(chains_.ids[closes ? begin : k + 1]) };
}

} // namespace

Status splitAtCrossings(
  const PointView& points, const ConstraintView& chains, Progress* progress, SplitConstraints& out)
{
  return withoutThrowing(
    [&]
    {
      Ticker ticker(progress, Phase::Split, 0);
      return Splitter(points, chains, ticker, out).run();
    });
}

} // namespace ahd
