// SPDX-License-Identifier: BSD-3-Clause
#include "Hubs.h"

#include "../Arithmetic/Length.h"
#include "../Core/Chunks.h"
#include "../Core/SortAsking.h"
#include "../Predicates/Predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ahd
{
namespace
{

/// Fewer are as well looked at one by one.
constexpr std::size_t kLeastPairs = 64;
constexpr std::size_t kLeastPieces = 16;
/// Each is looked for among all pieces.
constexpr std::size_t kMostHubs = 64;

bool isWithin(const Segment& s, const Point& p)
{
  return lexicographicallyLess(s.left, p) && lexicographicallyLess(p, s.right) &&
    p.y >= std::min(s.left.y, s.right.y) && p.y <= std::max(s.left.y, s.right.y) &&
    orient2d(s.left, s.right, p) == 0;
}

/// The sine of the angle between two segments, wrong by less than 2^-49.
double sineBetween(const Segment& s, const Segment& t)
{
  const double ux = s.right.x - s.left.x, uy = s.right.y - s.left.y;
  const double vx = t.right.x - t.left.x, vy = t.right.y - t.left.y;
  const double u = lengthOf(ux, uy), v = lengthOf(vx, vy);
  return std::fabs((ux / u) * (vy / v) - (uy / u) * (vx / v));
}

} // namespace

bool Hubs::add(const Pieces& pieces, const std::vector<Crossing>& crossings)
{
  std::vector<Point> places;
  if (!listPlaces(pieces, crossings, places))
  {
    return false;
  }
  std::size_t tried = 0;
  for (std::size_t begin = 0, end = 0; begin != places.size() && tried != kMostHubs; begin = end)
  {
    for (; end != places.size() && places[end] == places[begin]; ++end)
    {
      if (!ticker_.step())
      {
        return false;
      }
    }
    if (end - begin >= kLeastPairs)
    {
      ++tried;
      if (!makeHub(pieces, places[begin]))
      {
        return false;
      }
    }
  }
  return true;
}

/// The places where pairs cross, if exactly there; sorted.
bool Hubs::listPlaces(
  const Pieces& pieces, const std::vector<Crossing>& crossings, std::vector<Point>& places)
{
  const auto list = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      const Segment& s = pieces[crossings[k].a].segment;
      const Segment& t = pieces[crossings[k].b].segment;
      const Point p = crossingOf(s, t);
      if (isWithin(s, p) && isWithin(t, p))
      {
        places.push_back(p);
      }
    }
  };
  return inChunks(0, crossings.size(), ticker_, list) &&
    sortAsking(places, ticker_, lexicographicallyLess);
}

/// Returns false if the work is cancelled.
bool Hubs::noteTried(const Point& p)
{
  Index number = kNoIndex;
  return tried_.add(p, number);
}

/// Makes a hub of the place, unless it is one or is not clean.
bool Hubs::makeHub(const Pieces& pieces, const Point& p)
{
  if (isTried(p))
  {
    return true;
  }
  Place place{ p, {}, {} };
  const auto list = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      if (!pieces[k].isDead && isWithin(pieces[k].segment, p))
      {
        place.pieces.push_back(static_cast<Index>(k));
      }
    }
  };
  return noteTried(p) && inChunks(0, pieces.size(), ticker_, list) && keepIfHub(pieces, place);
}

bool Hubs::keepIfHub(const Pieces& pieces, Place& place)
{
  if (place.pieces.size() < kLeastPieces)
  {
    return true;
  }
  if (!sortByDirection(pieces, place))
  {
    return false;
  }
  if (isClean(pieces, place))
  {
    places_.push_back(std::move(place));
  }
  return true;
}

// ---------------------------------------------------------------------- from piece to piece

bool Hubs::look(const Pieces& pieces, const std::vector<BoxTree>& trees)
{
  const BoxTree& latest = trees.back();
  const std::size_t bits = bitLength(pieces.size());
  isIn_.assign(pieces.size(), false);
  stepsLeft_ = bits * bits * pieces.size();
  for (std::size_t k = latest.begin(); k != latest.end(); ++k)
  {
    if (!isIn_[k] && !lookFrom(static_cast<Index>(k), pieces, trees))
    {
      return false;
    }
  }
  return true;
}

/// Tries the places that several of the first pieces that cross this one have.
bool Hubs::lookFrom(Index piece, const Pieces& pieces, const std::vector<BoxTree>& trees)
{
  constexpr std::size_t kMostCrossings = 32, kLeastAtOnePlace = 8;
  const std::size_t bits = bitLength(pieces.size());
  std::size_t steps = bits * bits;
  const Segment& own = pieces[piece].segment;
  std::array<Point, kMostCrossings> places;
  std::size_t crossings = 0, count = 0;
  const auto look = [&](std::size_t other)
  {
    const Segment& s = pieces[other].segment;
    if (!pieces[other].isDead && cross(own, s))
    {
      const Point p = crossingOf(own, s);
      ++crossings;
      if (isWithin(own, p) && isWithin(s, p))
      {
        places[count++] = p;
      }
    }
    return crossings != kMostCrossings;
  };
  for (const BoxTree& tree : trees)
  {
    if (!tree.forMeeting(boxOf(own), steps, ticker_, look))
    {
      break;
    }
  }
  std::sort(places.begin(), places.begin() + std::ptrdiff_t(count), lexicographicallyLess);
  for (std::size_t begin = 0, end = 0; begin != count; begin = end)
  {
    for (; end != count && places[end] == places[begin]; ++end)
    {
    }
    if (end - begin >= kLeastAtOnePlace && !makeHubBy(places[begin], pieces, trees))
    {
      return false;
    }
  }
  return !ticker_.cancelled();
}

/// The same as makeHub(), by the trees; unless too much was done.
bool Hubs::makeHubBy(const Point& p, const Pieces& pieces, const std::vector<BoxTree>& trees)
{
  if (isTried(p))
  {
    return true;
  }
  Place place{ p, {}, {} };
  const auto list = [&](std::size_t k)
  {
    if (!pieces[k].isDead && isWithin(pieces[k].segment, p))
    {
      place.pieces.push_back(static_cast<Index>(k));
    }
    return true;
  };
  const Box box = Box::around(p, p);
  for (const BoxTree& tree : trees)
  {
    if (!tree.forMeeting(box, stepsLeft_, ticker_, list))
    {
      return !ticker_.cancelled();
    }
  }
  for (const Index piece : place.pieces)
  {
    isIn_[piece] = true;
  }
  return noteTried(p) && keepIfHub(pieces, place);
}

bool Hubs::sortByDirection(const Pieces& pieces, Place& place)
{
  // Segments that pass through one place are compared by the side of one on which the right end of
  // the other lies.
  const auto turn = [&](Index s, Index t)
  { return orient2d(pieces[s].segment.left, pieces[s].segment.right, pieces[t].segment.right); };
  if (!sortAsking(place.pieces, ticker_, [&](Index s, Index t) { return turn(s, t) > 0; }))
  {
    return false;
  }
  const auto begin = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      if (k == 0 || turn(place.pieces[k - 1], place.pieces[k]) != 0)
      {
        place.classes.push_back(k);
      }
    }
  };
  const bool all = inChunks(0, place.pieces.size(), ticker_, begin);
  place.classes.push_back(place.pieces.size());
  return all;
}

/// Proof. A piece rounds to an end q of another if it comes as near to it as half a unit in the
/// last place in x and y; `reach` is more than that is for all ends together. At an angle whose
/// sine is s it passes q by at a distance of s |q - p|. In the order of directions, modulo half a
/// turn, the sine between two pieces is at least the smallest one between neighbours.
bool Hubs::isClean(const Pieces& pieces, const Place& place) const
{
  double reach = 0.0, nearest = std::numeric_limits<double>::infinity();
  for (const Index piece : place.pieces)
  {
    for (const Point& q : { pieces[piece].segment.left, pieces[piece].segment.right })
    {
      const double size = std::max(std::fabs(q.x), std::fabs(q.y));
      reach = std::max(reach, 0x1p-50 * size + 0x1p-1000);
      nearest = std::min(
        nearest, std::max(std::fabs(q.x - place.at.x), std::fabs(q.y - place.at.y)));
    }
  }
  const std::size_t directions = place.classes.size() - 1;
  for (std::size_t k = 0; k != directions; ++k)
  {
    const Index s = place.pieces[place.classes[k]];
    const Index t = place.pieces[place.classes[k + 1 == directions ? 0 : k + 1]];
    if (!(sineBetween(pieces[s].segment, pieces[t].segment) > 0x1p-48 + 2.0 * reach / nearest))
    {
      return false;
    }
  }
  return true;
}

std::size_t Hubs::mostParts(const Pieces& pieces) const
{
  std::size_t count = pieces.size();
  for (const Place& place : places_)
  {
    count += place.pieces.size();
  }
  return count;
}

bool Hubs::listParts(const Pieces& pieces, std::vector<Part>& parts)
{
  std::vector<Cut> cuts;
  for (const Place& place : places_)
  {
    const auto list = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        cuts.push_back({ place.pieces[k], place.at });
      }
    };
    if (!inChunks(0, place.pieces.size(), ticker_, list))
    {
      return false;
    }
  }
  const auto comesBefore = [](const Cut& a, const Cut& b)
  { return a.piece != b.piece ? a.piece < b.piece : lexicographicallyLess(a.at, b.at); };
  auto next = std::size_t(0);
  const auto add = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      Part rest{ pieces[k].segment, static_cast<Index>(k) };
      for (; next != cuts.size() && cuts[next].piece == k; ++next)
      {
        parts.push_back({ { rest.segment.left, cuts[next].at }, rest.piece });
        rest.segment.left = cuts[next].at;
      }
      if (!pieces[k].isDead)
      {
        parts.push_back(rest);
      }
    }
  };
  parts.clear();
  parts.reserve(mostParts(pieces));
  return sortAsking(cuts, ticker_, comesBefore) && inChunks(0, pieces.size(), ticker_, add);
}

/// A pair of those that are not collinear, the first one by `before`, an order of pieces. The
/// second is the first one outside of the class of the first.
template <typename Before>
Hubs::Pair Hubs::firstPair(const Place& place, Before before) const
{
  Pair pair{ kNoIndex, kNoIndex, 0, 0 };
  const auto isFirst = [&](Index piece, Index known)
  { return known == kNoIndex || before(piece, known); };
  for (std::size_t k = 0; k + 1 < place.classes.size(); ++k)
  {
    for (std::size_t l = place.classes[k]; l != place.classes[k + 1]; ++l)
    {
      if (isFirst(place.pieces[l], pair.first))
      {
        pair = { place.pieces[l], kNoIndex, place.classes[k], place.classes[k + 1] };
      }
    }
  }
  for (std::size_t l = 0; l != place.pieces.size(); ++l)
  {
    const bool isCollinear = l >= pair.begin && l < pair.end;
    pair.second = !isCollinear && isFirst(place.pieces[l], pair.second) ? place.pieces[l]
                                                                        : pair.second;
  }
  return pair;
}

bool Hubs::addCrossings(
  const Pieces& pieces, std::vector<Crossing>& crossings, std::size_t& unlisted)
{
  for (const Place& place : places_)
  {
    const std::size_t count = place.pieces.size();
    const Pair pair = firstPair(
      place, [&](Index s, Index t) { return pieces[s].position < pieces[t].position; });
    const Pair byPlaces = firstPair(
      place, [&](Index s, Index t) { return comesBefore(pieces[s].segment, pieces[t].segment); });
    const auto add = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        if (place.pieces[k] != pair.first)
        {
          const bool isCollinear = k >= pair.begin && k < pair.end;
          crossings.push_back({ place.pieces[k], isCollinear ? pair.second : pair.first });
        }
      }
    };
    crossings.push_back({ byPlaces.first, byPlaces.second });
    std::size_t pairs = count * (count - 1) / 2;
    for (std::size_t k = 0; k + 1 < place.classes.size(); ++k)
    {
      const std::size_t own = place.classes[k + 1] - place.classes[k];
      pairs -= own * (own - 1) / 2;
    }
    unlisted += pairs - count;
    if (!inChunks(0, count, ticker_, add) || !ticker_.step(2))
    {
      return false;
    }
  }
  return true;
}

} // namespace ahd
