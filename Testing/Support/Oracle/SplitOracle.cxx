// SPDX-License-Identifier: BSD-3-Clause
#include "SplitOracle.h"

#include "Core/Border.h"
#include "Core/SortAsking.h"
#include "Crossings/SplitFind.h"

#include <algorithm>
#include <iterator>

namespace ahd
{
namespace test
{
namespace
{
/// Replaces ids that are no point's.
constexpr std::int64_t kNoPoint = -1;
/// Most ids in the chains. Tests of refusals are compiled with fewer.
#ifndef AHD_MOST_CHAIN_IDS
#define AHD_MOST_CHAIN_IDS (std::size_t(1) << 31)
#endif
constexpr std::size_t kMostIds = AHD_MOST_CHAIN_IDS;

/// A segment of the chains as they are now. Those that cross nothing by definition are not listed.
struct Piece
{
  std::int64_t from, to; ///< ids of points at different places
  std::size_t position;  ///< of `from` in the ids of the chains
};

/// An end of a piece: of piece `half` / 2 its first or its second one.
struct PieceEnd
{
  Point at;
  std::int64_t id;
  std::size_t half;
};

/// Where two pieces cross.
struct Meeting
{
  Point at; ///< rounded
  Crossing pieces;
  std::int64_t id; ///< of the point there; kUnnamed if there is none yet
};
constexpr std::int64_t kUnnamed = -1;

/// A point to be put into a piece.
struct Insertion
{
  Index piece;
  Point at;
  std::int64_t id;
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
  {
  }

  Status run();

private:
  bool copyChains();
  bool find();
  bool listPieces();
  bool rankEnds();
  bool split();
  bool takeEnds(Index piece, Index other);
  bool locateMeetings();
  bool nameMeetings();
  bool addPoints();
  bool useOtherPoints(std::vector<std::size_t>& firsts);
  bool listInsertions();
  bool rebuildChains();

  bool isUsable(std::int64_t id) const;
  Point at(std::int64_t id) const;
  bool isBefore(Index piece, const Point& a, const Point& b) const;
  CrossingPoint described(const Meeting& meeting) const;
  double along(std::size_t chain, std::size_t segment, const Point& p) const;
  std::size_t chainOf(Index piece) const;

  const PointView& points_;
  const ConstraintView& chains_;
  Ticker& ticker_;
  SplitConstraints& out_;
  std::vector<Piece> pieces_;      ///< in the order of the chains
  RankedSegments segments_;        ///< the pieces
  std::vector<std::int64_t> idAt_; ///< of the places of their ends, the smallest there
  std::vector<Crossing> crossings_;
  std::vector<Meeting> meetings_;
  std::vector<Insertion> insertions_;
};

Status Splitter::run()
{
  if (points_.count > kMaximumPoints)
  {
    return Status::TooManyPoints;
  }
  if (!copyChains())
  {
    return Status::Cancelled;
  }
  for (;; ++out_.rounds)
  {
    if (out_.ids.size() > kMostIds || points_.count + out_.points.size() > kMaximumPoints)
    {
      return Status::TooManyPoints;
    }
    if (!find())
    {
      return Status::Cancelled;
    }
    if (crossings_.empty() || out_.rounds == kMostSplittingRounds)
    {
      out_.unresolved = crossings_.size();
      return ticker_.ask() ? Status::Ok : Status::Cancelled;
    }
    out_.crossings += crossings_.size();
    if (!split())
    {
      return Status::Cancelled;
    }
  }
}

bool Splitter::copyChains()
{
  const std::size_t begin = chains_.chains == 0 ? 0 : std::size_t(chains_.offsets[0]);
  out_ = SplitConstraints();
  out_.lines = chains_.lines;
  out_.offsets.reserve(chains_.chains + 1);
  out_.offsets.push_back(0);
  for (std::size_t chain = 0; chain < chains_.chains; ++chain)
  {
    const std::size_t first = std::size_t(chains_.offsets[chain]);
    const std::size_t count = std::size_t(chains_.offsets[chain + 1]) - first;
    const std::size_t lastSegment = count - (chain < chains_.lines && count > 1 ? 2 : 1);
    const auto copy = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        const std::int64_t id = chains_.ids[first + k];
        out_.ids.push_back(std::size_t(id) < points_.count ? id : kNoPoint);
        out_.segments.push_back(std::int64_t(std::min(k, lastSegment)));
      }
    };
    if (!inChunks(0, count, ticker_, copy) || !ticker_.step())
    {
      return false;
    }
    out_.offsets.push_back(std::int64_t(first + count - begin));
  }
  return true;
}

// ------------------------------------------------------------------------------- current crossings

bool Splitter::find()
{
  return listPieces() && rankEnds() && findCrossings(segments_, ticker_, crossings_);
}

bool Splitter::listPieces()
{
  pieces_.clear();
  for (std::size_t chain = 0; chain + 1 < out_.offsets.size(); ++chain)
  {
    const std::size_t begin = std::size_t(out_.offsets[chain]);
    const std::size_t end = std::size_t(out_.offsets[chain + 1]);
    const auto list = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        const std::int64_t from = out_.ids[k], to = out_.ids[k + 1 == end ? begin : k + 1];
        if (isUsable(from) && isUsable(to) && !(at(from) == at(to)))
        {
          pieces_.push_back({ from, to, k });
        }
      }
    };
    const std::size_t closing = chain < out_.lines && begin != end ? 1 : 0;
    if (!inChunks(begin, end - closing, ticker_, list) || !ticker_.step())
    {
      return false;
    }
  }
  return true;
}

bool Splitter::rankEnds()
{
  std::vector<PieceEnd> ends;
  ends.reserve(2 * pieces_.size());
  for (std::size_t k = 0; k != pieces_.size(); ++k)
  {
    ends.push_back({ at(pieces_[k].from), pieces_[k].from, 2 * k });
    ends.push_back({ at(pieces_[k].to), pieces_[k].to, 2 * k + 1 });
    if (!ticker_.step())
    {
      return false;
    }
  }
  const auto comesBefore = [](const PieceEnd& a, const PieceEnd& b)
  { return a.at == b.at ? a.id < b.id : lexicographicallyLess(a.at, b.at); };
  if (!sortAsking(ends, ticker_, comesBefore))
  {
    return false;
  }
  segments_.places.clear();
  segments_.ends.assign(pieces_.size(), { kNoIndex, kNoIndex });
  idAt_.clear();
  for (const PieceEnd& end : ends)
  {
    if (idAt_.empty() || !(segments_.places.back() == end.at))
    {
      segments_.places.push_back(end.at);
      idAt_.push_back(end.id);
    }
    // Of the two ends of a piece the left one comes first.
    RankedSegments::Ends& both = segments_.ends[end.half / 2];
    (both.left == kNoIndex ? both.left : both.right) = static_cast<Index>(idAt_.size() - 1);
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

// --------------------------------------------------------------------------- splitting, one round

bool Splitter::split()
{
  return locateMeetings() && nameMeetings() && listInsertions() && rebuildChains();
}

/// Lets a piece go through those ends of another one to which it rounds. Is there one?
bool Splitter::takeEnds(Index piece, Index other)
{
  const RankedSegments::Ends& ends = segments_.ends[other];
  bool takesOne = false;
  for (const Index end : { ends.left, ends.right })
  {
    const Point p = segments_.places[end];
    if (roundsTo(segments_[piece], p))
    {
      insertions_.push_back({ piece, p, idAt_[end] });
      takesOne = true;
    }
  }
  return takesOne;
}

/// Where neither piece takes an end of the other, a point is needed.
bool Splitter::locateMeetings()
{
  insertions_.clear();
  meetings_.clear();
  const std::vector<Point>& places = segments_.places;
  for (const Crossing& crossing : crossings_)
  {
    const bool isEndOfB = takeEnds(crossing.a, crossing.b);
    const bool isEndOfA = takeEnds(crossing.b, crossing.a);
    if (!isEndOfA && !isEndOfB)
    {
      const Point p = crossingOf(segments_[crossing.a], segments_[crossing.b]);
      const auto place = std::lower_bound(places.begin(), places.end(), p, lexicographicallyLess);
      const bool isEnd = place != places.end() && *place == p;
      meetings_.push_back(
        { p, crossing, isEnd ? idAt_[std::size_t(place - places.begin())] : kUnnamed });
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

/// Adds the new points, and sets their ids in all meetings.
bool Splitter::nameMeetings()
{
  const auto comesBefore = [](const Meeting& m, const Meeting& n)
  {
    return !(m.at == n.at)       ? lexicographicallyLess(m.at, n.at)
      : m.pieces.a != n.pieces.a ? m.pieces.a < n.pieces.a
                                 : m.pieces.b < n.pieces.b;
  };
  const auto copyNames = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      meetings_[k].id = meetings_[k].id == kUnnamed ? meetings_[k - 1].id : meetings_[k].id;
    }
  };
  return sortAsking(meetings_, ticker_, comesBefore) && addPoints() &&
    inChunks(0, meetings_.size(), ticker_, copyNames);
}

/// Adds a point for each place that is new, and names the first meeting there.
/// @pre the meetings are sorted by places.
bool Splitter::addPoints()
{
  std::vector<std::size_t> firsts; // at each new place
  const auto list = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      if (meetings_[k].id == kUnnamed && (k == 0 || !(meetings_[k - 1].at == meetings_[k].at)))
      {
        firsts.push_back(k);
      }
    }
  };
  const auto comesBefore = [&](std::size_t k, std::size_t l)
  {
    const Meeting &m = meetings_[k], &n = meetings_[l];
    return m.pieces.a != n.pieces.a ? m.pieces.a < n.pieces.a : isBefore(m.pieces.a, m.at, n.at);
  };
  const auto add = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      meetings_[firsts[k]].id = std::int64_t(points_.count + out_.points.size());
      out_.points.push_back(described(meetings_[firsts[k]]));
    }
  };
  return inChunks(0, meetings_.size(), ticker_, list) && useOtherPoints(firsts) &&
    sortAsking(firsts, ticker_, comesBefore) && inChunks(0, firsts.size(), ticker_, add);
}

/// Names the meetings at the places of points that are no ends, and takes them from `firsts`.
bool Splitter::useOtherPoints(std::vector<std::size_t>& firsts)
{
  const auto isBelow = [&](std::size_t first, const Point& p)
  { return lexicographicallyLess(meetings_[first].at, p); };
  const auto use = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t id = a; id != b; ++id)
    {
      const Point p = points_[id];
      const auto found = isUsable(std::int64_t(id))
        ? std::lower_bound(firsts.begin(), firsts.end(), p, isBelow)
        : firsts.end();
      if (found != firsts.end() && meetings_[*found].at == p && meetings_[*found].id == kUnnamed)
      {
        meetings_[*found].id = std::int64_t(id);
      }
    }
  };
  std::vector<std::size_t> unnamed;
  const auto keep = [&](std::size_t a, std::size_t b)
  {
    std::copy_if(firsts.data() + a, firsts.data() + b, std::back_inserter(unnamed),
      [&](std::size_t first) { return meetings_[first].id == kUnnamed; });
  };
  const bool done = firsts.empty() ||
    (inChunks(0, points_.count, ticker_, use) && inChunks(0, firsts.size(), ticker_, keep));
  firsts.swap(unnamed);
  return done;
}

bool Splitter::listInsertions()
{
  for (const Meeting& meeting : meetings_)
  {
    for (const Index piece : { meeting.pieces.a, meeting.pieces.b })
    {
      const Segment segment = segments_[piece];
      if (!(meeting.at == segment.left || meeting.at == segment.right))
      {
        insertions_.push_back({ piece, meeting.at, meeting.id });
      }
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  const auto comesBefore = [&](const Insertion& i, const Insertion& k)
  { return i.piece != k.piece ? i.piece < k.piece : isBefore(i.piece, i.at, k.at); };
  return sortAsking(insertions_, ticker_, comesBefore);
}

bool Splitter::rebuildChains()
{
  std::vector<std::int64_t> ids, segments;
  ids.reserve(out_.ids.size() + insertions_.size());
  segments.reserve(ids.capacity());
  auto next = insertions_.begin();
  std::size_t chain = 0;
  for (std::size_t k = 0; k != out_.ids.size(); ++k)
  {
    for (; std::size_t(out_.offsets[chain]) == k; ++chain)
    {
      out_.offsets[chain] = std::int64_t(ids.size());
    }
    ids.push_back(out_.ids[k]);
    segments.push_back(out_.segments[k]);
    for (; next != insertions_.end() && pieces_[next->piece].position == k; ++next)
    {
      if (ids.back() != next->id) // several pieces may cross this one there
      {
        ids.push_back(next->id);
        segments.push_back(out_.segments[k]);
      }
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
  std::fill(
    out_.offsets.begin() + std::ptrdiff_t(chain), out_.offsets.end(), std::int64_t(ids.size()));
  out_.ids.swap(ids);
  out_.segments.swap(segments);
  return true;
}

// ---------------------------------------------------------------------------------- positions

bool Splitter::isUsable(std::int64_t id) const
{
  const auto k = static_cast<std::size_t>(id);
  return id >= 0 && k < points_.count + out_.points.size() &&
    (k >= points_.count || (!points_.skipped(k) && isFinite(points_[k])));
}

Point Splitter::at(std::int64_t id) const
{
  const auto k = static_cast<std::size_t>(id);
  return k < points_.count ? points_[k] : out_.points[k - points_.count].at;
}

/// Does the piece pass a before b? Both are points on it, rounded, which is monotone in each
/// coordinate; so they are in the order of both.
bool Splitter::isBefore(Index piece, const Point& a, const Point& b) const
{
  const Point from = at(pieces_[piece].from), to = at(pieces_[piece].to);
  return a.x != b.x ? (a.x < b.x) == (from.x < to.x) : a.y != b.y && (a.y < b.y) == (from.y < to.y);
}

CrossingPoint Splitter::described(const Meeting& meeting) const
{
  CrossingPoint result;
  result.at = meeting.at;
  result.chainA = chainOf(meeting.pieces.a);
  result.chainB = chainOf(meeting.pieces.b);
  result.segmentA = std::size_t(out_.segments[pieces_[meeting.pieces.a].position]);
  result.segmentB = std::size_t(out_.segments[pieces_[meeting.pieces.b].position]);
  result.alongA = along(result.chainA, result.segmentA, meeting.at);
  result.alongB = along(result.chainB, result.segmentB, meeting.at);
  return result;
}

std::size_t Splitter::chainOf(Index piece) const
{
  const auto position = static_cast<std::int64_t>(pieces_[piece].position);
  const auto after = std::upper_bound(out_.offsets.begin(), out_.offsets.end(), position);
  return std::size_t(after - out_.offsets.begin()) - 1;
}

/// The fraction of the input's segment at p.
double Splitter::along(std::size_t chain, std::size_t segment, const Point& p) const
{
  const std::size_t begin = std::size_t(chains_.offsets[chain]), k = begin + segment;
  const bool closes = k + 1 == std::size_t(chains_.offsets[chain + 1]);
  return fractionOfWay(at(chains_.ids[k]), at(chains_.ids[closes ? begin : k + 1]), p);
}

} // namespace

Status splitBySearchingAll(
  const PointView& points, const ConstraintView& chains, SplitConstraints& out)
{
  return withoutThrowing(
    [&]
    {
      Ticker ticker(nullptr, Phase::Split, 0);
      return Splitter(points, chains, ticker, out).run();
    });
}

} // namespace test
} // namespace ahd
