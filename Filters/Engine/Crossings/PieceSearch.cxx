// SPDX-License-Identifier: BSD-3-Clause
#include "PieceSearch.h"

#include "../Core/Chunks.h"
#include "../Core/SortAsking.h"
#include "SplitFind.h"

#include <algorithm>

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

/// Steps that take less time than a search by strips; and more crossings than there are without
/// hubs, mostly, or the most there may be.
BoxSearchLimits limitsFor(std::size_t pieces, std::size_t most)
{
  constexpr std::size_t kCrossings = 64;
  const std::size_t bits = bitLength(pieces);
  return { bits * bits * pieces, std::min(most, kCrossings * pieces) };
}

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
  segments.places.clear();
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

} // namespace

bool PieceSearch::find(const Pieces& more, Pieces& pieces, std::size_t most, FoundCrossings& found)
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
    if (!hubs.add(pieces, found.listed))
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

BoxSearch::Outcome PieceSearch::searchTrees(
  const Pieces& pieces, const BoxSearchLimits& limits, std::vector<Crossing>& crossings)
{
  crossings.clear();
  BoxSearch search(pieces, limits, ticker_, crossings);
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

/// Looks for hubs as long as there are new ones, each time at twice as many crossings.
bool PieceSearch::findByStrips(
  const Pieces& pieces, std::size_t most, Hubs& hubs, FoundCrossings& found)
{
  RankedSegments segments;
  std::vector<Hubs::Part> parts;
  std::vector<Crossing>& crossings = found.listed;
  const auto rename = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      crossings[k] = { parts[crossings[k].a].piece, parts[crossings[k].b].piece };
    }
  };
  for (std::size_t enough = limitsFor(pieces.size(), most).crossings;;)
  {
    if (!hubs.listParts(pieces, parts) || !rankEnds(parts, ticker_, segments) ||
      !findCrossings(segments, ticker_, crossings, enough) ||
      !inChunks(0, crossings.size(), ticker_, rename))
    {
      return false;
    }
    if (crossings.size() <= enough)
    {
      return hubs.addCrossings(pieces, crossings, found.unlisted);
    }
    const std::size_t before = hubs.count();
    if (!hubs.add(pieces, crossings))
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
