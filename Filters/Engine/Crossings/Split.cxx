// SPDX-License-Identifier: BSD-3-Clause
#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Order/RadixSort.h"
#include "Splitter.h"

#include <algorithm>

namespace ahd
{
namespace
{

/// Most ids in the chains. Tests of what is refused are compiled with fewer.
#ifndef AHD_MOST_CHAIN_IDS
#define AHD_MOST_CHAIN_IDS (std::size_t(1) << 31)
#endif
constexpr std::size_t kMostIds = AHD_MOST_CHAIN_IDS;

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
