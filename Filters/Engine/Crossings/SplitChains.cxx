// SPDX-License-Identifier: BSD-3-Clause
//
// Splitting: pieces and chains with places put into them.
#include "../Core/SortAsking.h"
#include "../Order/RadixSort.h"
#include "../Predicates/Predicates.h"
#include "Splitter.h"

#include <algorithm>
#include <utility>

namespace ahd
{
namespace
{

/// What ids that are those of no point become.
constexpr std::int64_t kNoPoint = -1;

} // namespace

/// Sorts by owners, then along them; equal ones are kept.
bool Splitter::sortAlong(
  const std::vector<OnSegment>& items, const WayOfOwner& wayOfOwner, Buffer<OnSegment>& sorted)
{
  const std::size_t n = items.size();
  sorted.allocate(n);
  const auto copy = [&](std::size_t a, std::size_t b)
  { std::copy(items.data() + a, items.data() + b, sorted.data() + a); };
  return inChunks(0, n, ticker_, copy) && sortPacked(sorted, n, ticker_) &&
    sortGroups(wayOfOwner, sorted);
}

/// The same for what is sorted by owners.
bool Splitter::sortGroups(const WayOfOwner& wayOfOwner, Buffer<OnSegment>& sorted)
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

} // namespace ahd
