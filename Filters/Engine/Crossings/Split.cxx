// SPDX-License-Identifier: BSD-3-Clause
#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Order/RadixSort.h"
#include "Splitter.h"

#include <algorithm>
#include <array>

namespace ahd
{
namespace
{

/// Most ids in the chains. Tests of refusals are compiled with fewer.
#ifndef AHD_MOST_CHAIN_IDS
#define AHD_MOST_CHAIN_IDS (std::size_t(1) << 31)
#endif
constexpr std::size_t kMostIds = AHD_MOST_CHAIN_IDS;

/// Bytes of a segment: a piece, twice, while they are sorted and while the array grows; its share
/// of a tree, which is 16 bytes in a leaf and 5 1/3 in boxes around these.
constexpr std::size_t kPerSegment = 2 * sizeof(Piece) + 16 + 8;

/// Bytes that a place takes, and a pair that crosses there, in all.
constexpr std::size_t kBytesPerPlace = 480, kBytesPerPair = 190;

/// Pairs that are allowed for each place that is.
constexpr std::size_t kPairsPerPlace = 4;

} // namespace

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
  std::size_t mostPairs = most_ > std::size_t(-1) / kPairsPerPlace ? std::size_t(-1)
                                                                   : kPairsPerPlace * most_;
  for (;; ++out_.rounds)
  {
    if (ids_ + inserted_.size() > kMostIds || pieces_.size() + more_.size() >= kNoIndex ||
      points_.count + out_.points.size() > kMaximumPoints)
    {
      return Status::TooManyPoints;
    }
    if (!search_.find(more_, pieces_, mostPairs, found_))
    {
      return Status::Cancelled;
    }
    more_ = Pieces();
    if (found_.listed.size() > mostPairs)
    {
      return Status::TooManyCrossings;
    }
    if (found_.count() == 0 || out_.rounds == kMostSplittingRounds)
    {
      out_.unresolved = found_.count();
      return makeChains() && nameBent() && ticker_.ask() ? Status::Ok : Status::Cancelled;
    }
    mostPairs -= found_.listed.size();
    out_.crossings += found_.count();
    const bool goesOn = split();
    pairsBefore_ += found_.listed.size();
    if (!goesOn)
    {
      return places_.size() > most_ ? Status::TooManyCrossings : Status::Cancelled;
    }
  }
}

/// Room for as many pieces as there may be: a line has one less than ids, and a loop too, if it
/// ends where it begins. The estimate counts no lines without an id.
void Splitter::makeRoom()
{
  std::size_t most = ids_;
  for (std::size_t chain = 0; chain < chains_.chains; ++chain)
  {
    const std::int64_t begin = chains_.offsets[chain], end = chains_.offsets[chain + 1];
    if (begin != end)
    {
      const std::int64_t first = chains_.ids[begin], last = chains_.ids[end - 1];
      const bool endsThere = first == last ||
        (isUsable(first) && isUsable(last) && at(first) == at(last));
      most -= chain < chains_.lines || endsThere ? 1 : 0;
    }
  }
  const std::size_t known = ids_ - std::min(ids_, chains_.lines);
  emptyLines_.atLeast(most > known ? kPerSegment * (most - known) : 0);
  more_.reserve(most);
}

/// The segments that may cross others.
bool Splitter::listPieces()
{
  makeRoom();
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
      ticker_.finished(SplitUnits::kListed * (b - a));
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

/// Returns false if the work is cancelled, or if there are too many places.
bool Splitter::split()
{
  constexpr std::size_t kBlock = 64; // whose slots in the table are fetched while it is worked on
  std::array<Meeting, kBlock> meetings;
  const std::vector<Crossing>& listed = found_.listed;
  takeFor(places_.size());
  insertions_.clear();
  insertions_.reserve(2 * listed.size()); // mostly
  if (!places_.reserve(places_.size() + listed.size()))
  {
    return false;
  }
  for (std::size_t begin = 0; begin != listed.size();)
  {
    const std::size_t end = std::min(listed.size(), begin + kBlock);
    for (std::size_t k = begin; k != end; ++k)
    {
      meetings[k - begin] = meetingOf(listed[k]);
      places_.prefetch(meetings[k - begin].at);
    }
    for (std::size_t k = begin; k != end; ++k)
    {
      if (!meet(listed[k], meetings[k - begin]) || !ticker_.step())
      {
        return false;
      }
    }
    if (places_.size() > most_)
    {
      return false;
    }
    takeFor(places_.size());
    begin = end;
  }
  return findIds() && sortInsertions() && splitPieces();
}

/// Requests memory for so many places and for the listed pairs. Throws std::bad_alloc if it is
/// refused.
void Splitter::takeFor(std::size_t places)
{
  taken_.atLeast(kBytesPerPair * (pairsBefore_ + found_.listed.size()) + kBytesPerPlace * places);
}

Splitter::Meeting Splitter::meetingOf(Crossing crossing) const
{
  const Segment &a = pieces_[crossing.a].segment, &b = pieces_[crossing.b].segment;
  const bool isAtEnds = roundsTo(a, b.left) || roundsTo(a, b.right) || roundsTo(b, a.left) ||
    roundsTo(b, a.right);
  return { isAtEnds, isAtEnds ? Point() : crossingOf(a, b) };
}

/// Leads one of two pieces through an end of the other, or both through where they cross.
bool Splitter::meet(Crossing crossing, const Meeting& meeting)
{
  if (meeting.isAtEnds)
  {
    return takeEnds(crossing.a, crossing.b) && takeEnds(crossing.b, crossing.a);
  }
  const Point& p = meeting.at;
  Index number = kNoIndex;
  if (!places_.add(p, number))
  {
    return false;
  }
  nameSegments(places_[number], pieces_[crossing.a].position, pieces_[crossing.b].position);
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

/// Lets a piece go through those ends of another one to which it rounds.
bool Splitter::takeEnds(Index piece, Index other)
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
    }
  }
  return true;
}

Status splitAtCrossings(const PointView& points, const ConstraintView& chains, Progress* progress,
  SplitConstraints& out, std::size_t mostCrossings)
{
  return withoutThrowing(
    [&]
    {
      const std::size_t ids = chains.chains == 0
        ? 0
        : std::size_t(chains.offsets[chains.chains] - chains.offsets[0]);
      Ticker ticker(progress, Phase::Split, SplitUnits::kAll * ids);
      return Splitter(points, chains, ticker, out, mostCrossings).run();
    });
}

std::size_t splitMemoryEstimate(std::size_t segments, std::size_t crossings)
{
  return kPerSegment * segments + (kBytesPerPlace + kPairsPerPlace * kBytesPerPair) * crossings +
    4096;
}

} // namespace ahd
