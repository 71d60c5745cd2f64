// SPDX-License-Identifier: BSD-3-Clause
#include "PieceSearch.h"

#include "../Core/Chunks.h"
#include "../Core/SortAsking.h"
#include "SplitFind.h"

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

/// As many steps among boxes as take about the time of a search by strips.
std::size_t mostSteps(std::size_t pieces)
{
  const std::size_t bits = bitLength(pieces);
  return 16 * bits * bits * pieces;
}

/// The pieces that are not dead, and which these are.
bool rankEnds(
  const Pieces& pieces, Ticker& ticker, RankedSegments& segments, std::vector<Index>& living)
{
  std::vector<SegmentEnd> ends;
  const auto list = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      if (!pieces[k].isDead)
      {
        ends.push_back({ pieces[k].segment.left, 2 * living.size() });
        ends.push_back({ pieces[k].segment.right, 2 * living.size() + 1 });
        living.push_back(static_cast<Index>(k));
      }
    }
  };
  const auto comesBefore = [](const SegmentEnd& a, const SegmentEnd& b)
  { return lexicographicallyLess(a.at, b.at); };
  if (!inChunks(0, pieces.size(), ticker, list) || !sortAsking(ends, ticker, comesBefore))
  {
    return false;
  }
  segments.ends.resize(living.size());
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

bool PieceSearch::find(const Pieces& more, Pieces& pieces, std::vector<Crossing>& crossings)
{
  crossings.clear();
  trees_.emplace_back();
  const BoxTree& latest = trees_.back();
  if (!trees_.back().build(more, pieces, ticker_))
  {
    return false;
  }
  BoxSearch search(pieces, mostSteps(pieces.size()), ticker_, crossings);
  BoxSearch::Outcome outcome = search.searchWithin(latest);
  for (std::size_t k = 0; k + 1 < trees_.size() && outcome == BoxSearch::Outcome::Done; ++k)
  {
    if (!trees_[k].fit(pieces, ticker_)) // as some died since
    {
      return false;
    }
    outcome = search.searchBetween(latest, trees_[k]);
  }
  return outcome == BoxSearch::Outcome::GivenUp ? findByStrips(pieces, crossings)
                                                : outcome == BoxSearch::Outcome::Done;
}

bool PieceSearch::findByStrips(const Pieces& pieces, std::vector<Crossing>& crossings)
{
  crossings.clear();
  RankedSegments segments;
  std::vector<Index> living;
  const auto rename = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      crossings[k] = { living[crossings[k].a], living[crossings[k].b] };
    }
  };
  return rankEnds(pieces, ticker_, segments, living) &&
    findCrossings(segments, ticker_, crossings) &&
    inChunks(0, crossings.size(), ticker_, rename);
}

} // namespace ahd
