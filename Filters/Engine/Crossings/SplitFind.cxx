// SPDX-License-Identifier: BSD-3-Clause
#include "SplitFind.h"

#include "../Core/SortAsking.h"
#include "../Predicates/Predicates.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace ahd
{
namespace
{

using Segments = std::vector<Index>;

/// Between the lines (SplitGeometry.h) of two ends: just after that of `begin`, just after that of
/// `end`. So a crossing at an end belongs to the strip that the end closes.
struct Strip
{
  Index begin;
  Index end;
};

class Finder
{
public:
  Finder(const RankedSegments& segments, Ticker& ticker, std::vector<Crossing>& crossings,
    std::size_t most, TakenMemory* taken)
    : segments_(segments)
    , ticker_(ticker)
    , crossings_(crossings)
    , most_(most)
    , taken_(taken)
  {
  }

  bool search(Segments inside, const Strip& strip);

private:
  bool searchHalves(const Segments& inside, const Strip& strip);
  template <typename Wanted>
  bool choose(const Segments& from, Wanted wanted, Segments& chosen);
  bool climb(const Segments& ladder, Index s, const Strip& strip);
  bool makeLadder(Segments& spanning, Segments& others, const Strip& strip);
  bool report(Index s, Index t);

  bool spans(Index s, const Strip& strip) const
  {
    return segments_.ends[s].left <= strip.begin && segments_.ends[s].right >= strip.end;
  }
  bool endsAfter(Index s, Index end) const { return segments_.ends[s].right > end; }
  int sideOf(Index end, Index s) const;
  int steepnessOf(Index s, Index t) const;
  int orderAtEnd(Index s, Index t, Index end) const;
  int orderAfter(Index s, Index t, Index end) const;
  int orderLeaving(Index s, Index t, Index end) const;

  const RankedSegments& segments_;
  Ticker& ticker_;
  std::vector<Crossing>& crossings_;
  std::size_t most_;
  TakenMemory* taken_;
};

/// On which side of s the end lies.
int Finder::sideOf(Index end, Index s) const
{
  const RankedSegments::Ends& ends = segments_.ends[s];
  return end == ends.left || end == ends.right
    ? 0
    : orient2d(segments_.places[ends.left], segments_.places[ends.right], segments_.places[end]);
}

/// +1 if s is steeper than t. @pre they have a point in common.
int Finder::steepnessOf(Index s, Index t) const
{
  const RankedSegments::Ends& ends = segments_.ends[s];
  const int right = sideOf(ends.right, t);
  return steepness(right == 0 ? sideOf(ends.left, t) : 0, right);
}

/// +1 if s is above t at the line of this end. @pre it meets both.
int Finder::orderAtEnd(Index s, Index t, Index end) const
{
  return orderAt(segments_[s], sideOf(end, s), segments_[t], sideOf(end, t), segments_.places[end]);
}

/// The same just after that line; 0 only if they are collinear. @pre both go on after it.
int Finder::orderAfter(Index s, Index t, Index end) const
{
  const int order = orderAtEnd(s, t, end);
  return order != 0 ? order : steepnessOf(s, t);
}

/// Just after that line if both go on after it, else at it.
int Finder::orderLeaving(Index s, Index t, Index end) const
{
  return endsAfter(s, end) && endsAfter(t, end) ? orderAfter(s, t, end) : orderAtEnd(s, t, end);
}

/// Copies those for which `wanted` holds. Returns false if the work is cancelled.
template <typename Wanted>
bool Finder::choose(const Segments& from, Wanted wanted, Segments& chosen)
{
  chosen.clear();
  return inChunks(0, from.size(), ticker_,
    [&](std::size_t a, std::size_t b)
    { std::copy_if(from.data() + a, from.data() + b, std::back_inserter(chosen), wanted); });
}

/// All crossings within the strip. @pre each segment has a part of some length in it.
bool Finder::search(Segments inside, const Strip& strip)
{
  const auto isNew = [&](Index s) { return s >= segments_.firstNew; };
  while (inside.size() > 1 && std::any_of(inside.begin(), inside.end(), isNew))
  {
    Segments ladder, others;
    if (!choose(
          inside, [&](Index s) { return spans(s, strip); }, ladder) ||
      !choose(
        inside, [&](Index s) { return !spans(s, strip); }, others))
    {
      return false;
    }
    const bool allSpan = others.empty();
    if (!makeLadder(ladder, others, strip))
    {
      return false;
    }
    for (const Index s : others)
    {
      if (!climb(ladder, s, strip))
      {
        return false;
      }
    }
    inside.swap(others);
    if (!allSpan)
    {
      return searchHalves(inside, strip);
    }
  }
  return true;
}

/// The halves. @pre an end lies within the strip.
bool Finder::searchHalves(const Segments& inside, const Strip& strip)
{
  const Index middle = strip.begin + (strip.end - strip.begin) / 2;
  Segments half;
  const auto inLeft = [&](Index s) { return segments_.ends[s].left < middle; };
  const auto inRight = [&](Index s) { return segments_.ends[s].right > middle; };
  return choose(inside, inLeft, half) && search(std::move(half), { strip.begin, middle }) &&
    choose(inside, inRight, half) && search(std::move(half), { middle, strip.end });
}

/// Of `spanning`, leaves those that follow one another upwards without crossing; adds the others to
/// `others`: each of them crosses one of those left.
bool Finder::makeLadder(Segments& spanning, Segments& others, const Strip& strip)
{
  const auto isBelow = [&](Index s, Index t)
  {
    const int order = orderAfter(s, t, strip.begin);
    return order != 0 ? order < 0 : s < t;
  };
  if (!sortAsking(spanning, ticker_, isBelow))
  {
    return false;
  }
  Segments ladder;
  Index top = kNoIndex;     // the last of the ladder
  Index goingOn = kNoIndex; // the last of the ladder that goes on after the strip
  const auto isAbove = [&](Index s, Index rung)
  { return rung == kNoIndex || orderLeaving(s, rung, strip.end) >= 0; };
  for (const Index s : spanning)
  {
    const bool fits = isAbove(s, top) && isAbove(s, goingOn);
    (fits ? ladder : others).push_back(s);
    top = fits ? s : top;
    goingOn = fits && endsAfter(s, strip.end) ? s : goingOn;
    if (!ticker_.step())
    {
      return false;
    }
  }
  spanning.swap(ladder);
  return true;
}

/// Reports the rungs that s crosses within the strip. They follow one another from where s enters,
/// upwards or downwards, but for rungs that end at the strip's end where s goes through: these
/// are passed.
bool Finder::climb(const Segments& ladder, Index s, const Strip& strip)
{
  const Index enter = std::max(strip.begin, segments_.ends[s].left);
  const Index leave = std::min(strip.end, segments_.ends[s].right);
  const bool passes = endsAfter(s, strip.end);
  const auto firstAbove = std::partition_point(
    ladder.begin(), ladder.end(), [&](Index rung) { return orderAfter(rung, s, enter) < 0; });
  const auto leavesAbove = [&](Index rung) { return orderLeaving(s, rung, leave); };
  for (auto rung = firstAbove; rung != ladder.end(); ++rung)
  {
    const int order = leavesAbove(*rung);
    if (order < 0 || (order == 0 && !passes))
    {
      break;
    }
    if (!(order > 0 ? report(s, *rung) : ticker_.step()))
    {
      return false;
    }
  }
  for (auto rung = firstAbove; rung != ladder.begin(); --rung)
  {
    const int order = leavesAbove(*std::prev(rung));
    if (order > 0 || (order == 0 && !passes))
    {
      break;
    }
    if (!(order < 0 ? report(s, *std::prev(rung)) : ticker_.step()))
    {
      return false;
    }
  }
  return ticker_.step();
}

bool Finder::report(Index s, Index t)
{
  addCrossing(crossings_, { std::min(s, t), std::max(s, t) }, taken_);
  return ticker_.step() && crossings_.size() <= most_;
}

} // namespace

bool findCrossings(const RankedSegments& segments, Ticker& ticker, std::vector<Crossing>& crossings,
  std::size_t most, TakenMemory* taken)
{
  crossings.clear();
  Segments all(segments.ends.size());
  std::iota(all.begin(), all.end(), Index(0));
  return all.empty() ||
    Finder(segments, ticker, crossings, most, taken)
      .search(std::move(all), { 0, static_cast<Index>(segments.places.size() - 1) }) ||
    crossings.size() > most;
}

} // namespace ahd
