// SPDX-License-Identifier: BSD-3-Clause
#include "PieceSearch.h"

#include "../Core/AskedMemory.h"
#include "../Core/Chunks.h"
#include "../Core/SortAsking.h"
#include "SplitFind.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace ahd
{
namespace
{

/// An end of a segment: of segment `half` / 2 its first or its second one.
struct SegmentEnd
{
  Point at;
  std::size_t half;
};

/// So many steps take less time than a search by strips; so many crossings are mostly more than
/// there are without hubs, or more than allowed.
BoxSearchLimits limitsFor(std::size_t pieces, std::size_t most)
{
  constexpr std::size_t kCrossings = 64;
  const std::size_t bits = bitLength(pieces);
  return { bits * bits * pieces, std::min(most, kCrossings * pieces) };
}

/// Bytes that a search by strips takes for each part: itself; its two ends, sorted; ends by
/// numbers, twice; places in lists of segments.
constexpr std::size_t kBytesPerPart = 280;

bool rankEnds(const std::vector<Hubs::Part>& parts, Ticker& ticker, RankedSegments& segments)
{
  std::vector<SegmentEnd> ends;
  ends.reserve(2 * parts.size());
  const auto list = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      ends.push_back({ parts[k].segment.left, 2 * k });
      ends.push_back({ parts[k].segment.right, 2 * k + 1 });
    }
  };
  const auto comesBefore = [](const SegmentEnd& a, const SegmentEnd& b)
  { return lexicographicallyLess(a.at, b.at); };
  if (!inChunks(0, parts.size(), ticker, list) || !sortAsking(ends, ticker, comesBefore))
  {
    return false;
  }
  segments.places.reserve(ends.size());
  segments.ends.resize(parts.size());
  const auto rank = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      if (segments.places.empty() || !(segments.places.back() == ends[k].at))
      {
        segments.places.push_back(ends[k].at);
      }
      RankedSegments::Ends& both = segments.ends[ends[k].half / 2];
      (ends[k].half % 2 == 0 ? both.left : both.right) = static_cast<Index>(
        segments.places.size() - 1);
    }
  };
  return inChunks(0, ends.size(), ticker, rank);
}

/// Parts that are one segment, as those of many segments through the same two doubles are: they are
/// searched as one.
class SameParts
{
public:
  SameParts(const std::vector<Hubs::Part>& parts, std::size_t firstNew, Ticker& ticker)
    : parts_(parts)
    , firstNew_(firstNew)
    , ticker_(ticker)
  {
  }

  /// Leaves one segment for those that are the same and both new or both not.
  bool unite(RankedSegments& segments)
  {
    const std::vector<RankedSegments::Ends> ends = std::move(segments.ends);
    segments.ends.clear();
    order_.resize(parts_.size());
    std::iota(order_.begin(), order_.end(), Index(0));
    const auto key = [&](Index k)
    { return std::make_tuple(isNew(k), ends[k].left, ends[k].right); };
    const auto list = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        if (k == 0 || key(order_[k - 1]) != key(order_[k]))
        {
          begins_.push_back(static_cast<Index>(k));
          segments.ends.push_back(ends[order_[k]]);
          segments.firstNew += std::size_t(!isNew(order_[k]));
        }
      }
    };
    segments.firstNew = 0;
    const bool all = sortAsking(
                       order_, ticker_, [&](Index i, Index k) { return key(i) < key(k); }) &&
      inChunks(0, order_.size(), ticker_, list);
    begins_.push_back(static_cast<Index>(order_.size()));
    return all;
  }

  /// Puts for each pair of segments the pairs of their pieces, more than `most` if there are more.
  bool expand(std::vector<Crossing>& crossings, std::size_t most, TakenMemory& taken) const
  {
    const std::vector<Crossing> ofSegments = std::move(crossings);
    crossings.clear();
    crossings.reserve(ofSegments.size());
    for (const Crossing& crossing : ofSegments)
    {
      for (Index i = begins_[crossing.a]; i != begins_[crossing.a + 1]; ++i)
      {
        for (Index k = begins_[crossing.b]; k != begins_[crossing.b + 1]; ++k)
        {
          addCrossing(crossings, { parts_[order_[i]].piece, parts_[order_[k]].piece }, &taken);
          if (!ticker_.step() || crossings.size() > most)
          {
            return !ticker_.cancelled();
          }
        }
      }
    }
    return true;
  }

private:
  bool isNew(Index part) const { return part >= firstNew_; }

  const std::vector<Hubs::Part>& parts_;
  std::size_t firstNew_;
  Ticker& ticker_;
  std::vector<Index> order_;  ///< parts
  std::vector<Index> begins_; ///< of each segment's in it, and the end
};

} // namespace

bool PieceSearch::find(const Pieces& more, Pieces& pieces, std::size_t most, FoundCrossings& found)
{
  const bool goesOn = findAll(more, pieces, most, found);
  listed_.atMost(sizeof(Crossing) * found.listed.capacity());
  return goesOn;
}

bool PieceSearch::findAll(
  const Pieces& more, Pieces& pieces, std::size_t most, FoundCrossings& found)
{
  trees_.emplace_back();
  if (!trees_.back().build(more, pieces, ticker_))
  {
    return false;
  }
  found.unlisted = 0;
  BoxSearchLimits limits = limitsFor(pieces.size(), most);
  BoxSearch::Outcome outcome = searchTrees(pieces, limits, found.listed);
  if (outcome != BoxSearch::Outcome::GivenUp)
  {
    return outcome == BoxSearch::Outcome::Done;
  }
  Hubs hubs(ticker_);
  if (found.listed.size() > limits.crossings)
  {
    if (!findHubs(pieces, found.listed, hubs))
    {
      return false;
    }
    if (hubs.count() == 0 && limits.crossings < most)
    {
      limits.crossings = most;
      outcome = searchTrees(pieces, limits, found.listed);
    }
    if (hubs.count() == 0 && found.listed.size() > most)
    {
      return true;
    }
  }
  return outcome == BoxSearch::Outcome::GivenUp ? findByStrips(pieces, most, hubs, found)
                                                : outcome == BoxSearch::Outcome::Done;
}

/// Looks for hubs from piece to piece, once; then among the crossings, which are some of those
/// there are. Returns false if the work is cancelled.
bool PieceSearch::findHubs(
  const Pieces& pieces, const std::vector<Crossing>& crossings, Hubs& hubs) const
{
  const std::size_t before = hubs.count();
  if (!hubs.hasLooked() && !hubs.look(pieces, trees_))
  {
    return false;
  }
  return hubs.count() != before || hubs.add(pieces, crossings);
}

BoxSearch::Outcome PieceSearch::searchTrees(
  const Pieces& pieces, const BoxSearchLimits& limits, std::vector<Crossing>& crossings)
{
  crossings.clear();
  BoxSearch search(pieces, limits, ticker_, crossings, &listed_);
  const BoxTree& latest = trees_.back();
  BoxSearch::Outcome outcome = search.searchWithin(latest);
  for (std::size_t k = 0; k + 1 < trees_.size() && outcome == BoxSearch::Outcome::Done; ++k)
  {
    if (!trees_[k].fit(pieces, ticker_)) // as some died since
    {
      return BoxSearch::Outcome::Cancelled;
    }
    outcome = search.searchBetween(latest, trees_[k]);
  }
  return outcome;
}

/// Finds what crosses of the parts; stops as soon as there are more than `most` pairs, and lists
/// more. Returns false if the work is cancelled.
bool PieceSearch::findAmongParts(
  const std::vector<Hubs::Part>& parts, std::size_t most, std::vector<Crossing>& crossings)
{
  const auto isOld = [&](const Hubs::Part& part) { return part.piece < trees_.back().begin(); };
  const auto firstNew = std::partition_point(parts.begin(), parts.end(), isOld);
  SameParts same(parts, std::size_t(firstNew - parts.begin()), ticker_);
  RankedSegments segments;
  return rankEnds(parts, ticker_, segments) && same.unite(segments) &&
    findCrossings(segments, ticker_, crossings, most, &listed_) &&
    same.expand(crossings, most, listed_);
}

/// Looks for hubs as long as there are new ones, each time at twice as many crossings.
bool PieceSearch::findByStrips(
  const Pieces& pieces, std::size_t most, Hubs& hubs, FoundCrossings& found)
{
  TakenMemory taken(ticker_);
  std::vector<Hubs::Part> parts;
  std::vector<Crossing>& crossings = found.listed;
  for (std::size_t enough = limitsFor(pieces.size(), most).crossings;;)
  {
    taken.atLeast(kBytesPerPart * hubs.mostParts(pieces));
    if (!hubs.listParts(pieces, parts) || !findAmongParts(parts, enough, crossings))
    {
      return false;
    }
    if (crossings.size() <= enough)
    {
      return hubs.addCrossings(pieces, crossings, found.unlisted);
    }
    const std::size_t before = hubs.count();
    if (!findHubs(pieces, crossings, hubs))
    {
      return false;
    }
    if (hubs.count() == before && enough == most)
    {
      return true;
    }
    enough = hubs.count() == before ? most : std::min(most, 2 * enough);
  }
}

} // namespace ahd
