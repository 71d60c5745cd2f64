// SPDX-License-Identifier: BSD-3-Clause
//
// Splitting: places are inserted into pieces and chains.
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

/// Replaces ids that are no point's.
constexpr std::int64_t kNoPoint = -1;

} // namespace

/// Sorts the insertions by pieces.
bool Splitter::sortInsertions()
{
  const std::size_t n = insertions_.size();
  sorted_.allocate(n);
  const auto copy = [&](std::size_t a, std::size_t b)
  { std::copy(insertions_.data() + a, insertions_.data() + b, sorted_.data() + a); };
  return inChunks(0, n, ticker_, copy) && sortPacked(sorted_, n, ticker_) && listOnPieces();
}

/// Lists the pieces with insertions in the order of the segments, then along them.
bool Splitter::listOnPieces()
{
  onPieces_.clear();
  for (std::size_t begin = 0, end = 0; begin != sorted_.size(); begin = end)
  {
    while (end != sorted_.size() && ownerOf(sorted_[end]) == ownerOf(sorted_[begin]))
    {
      ++end;
      if (!ticker_.step())
      {
        return false;
      }
    }
    onPieces_.push_back({ pieces_[ownerOf(sorted_[begin])].position, begin, end });
  }
  // Pieces of one segment have nothing in common but ends, where nothing is inserted.
  const auto comesBefore = [&](const OnPiece& s, const OnPiece& t)
  {
    return s.position != t.position
      ? s.position < t.position
      : wayOf(nameOf(s.position))
          .isBefore(places_[placeOf(sorted_[s.begin])].at, places_[placeOf(sorted_[t.begin])].at);
  };
  return sortAsking(onPieces_, ticker_, comesBefore);
}

/// Lists in along_ the points on a piece or segment, in their order along it.
bool Splitter::sortAlong(const Way& way, const OnSegment* items, std::size_t count)
{
  const auto comesBefore = [&](const PlaceAlong& i, const PlaceAlong& k)
  { return way.isBefore(i.at, k.at); };
  along_.clear();
  const auto list = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      along_.push_back({ places_[placeOf(items[k])].at, placeOf(items[k]) });
    }
  };
  return inChunks(0, count, ticker_, list) && sortAsking(along_, ticker_, comesBefore);
}

/// Replaces the pieces that are led through places, and adds the points there.
bool Splitter::splitPieces()
{
  addedBefore_ = out_.points.size();
  if (!reserveForPieces())
  {
    return false;
  }
  const std::size_t units = SplitUnits::kSplit * ids_ / std::max<std::size_t>(1, onPieces_.size());
  for (const OnPiece& on : onPieces_)
  {
    ticker_.finished(units);
    constexpr std::size_t kMostFetched = 64;
    if (&on != &onPieces_.back())
    {
      const OnPiece& next = (&on)[1];
      for (std::size_t k = next.begin; k != std::min(next.end, next.begin + kMostFetched); ++k)
      {
        prefetchForRead(&places_[placeOf(sorted_[k])]);
      }
    }
    const Piece& piece = pieces_[ownerOf(sorted_[on.begin])];
    const Segment& s = piece.segment;
    const Way way = piece.isForward ? Way{ s.left, s.right } : Way{ s.right, s.left };
    if (!sortAlong(way, &sorted_[on.begin], on.end - on.begin))
    {
      return false;
    }
    addPointsOn(on.position);
    if (!splitPiece(on))
    {
      return false;
    }
  }
  named_ = places_.size();
  return true;
}

/// Makes room for all that this round adds.
bool Splitter::reserveForPieces()
{
  std::size_t added = 0;
  const auto look = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      added += std::size_t(places_[static_cast<Index>(k)].id == kNoIndex);
    }
  };
  if (!inChunks(named_, places_.size(), ticker_, look))
  {
    return false;
  }
  out_.points.reserve(addedBefore_ + added);
  more_.reserve(sorted_.size() + onPieces_.size());
  inserted_.reserve(inserted_.size() + sorted_.size());
  return true;
}

/// Puts the places of along_ into their piece; one may come several times in a row.
bool Splitter::splitPiece(const OnPiece& on)
{
  Piece& piece = pieces_[ownerOf(sorted_[on.begin])];
  piece.isDead = true;
  const Piece whole = piece;
  Piece rest = whole;
  rest.isDead = false;
  Index last = kNoIndex;
  for (const PlaceAlong& item : along_)
  {
    if (!ticker_.step())
    {
      return false;
    }
    if (item.place == last)
    {
      continue; // several pieces may cross this one there
    }
    last = item.place;
    const Index id = places_[last].id;
    Piece next = rest;
    (whole.isForward ? next.segment.right : next.segment.left) = item.at;
    (whole.isForward ? next.rightId : next.leftId) = id;
    (whole.isForward ? rest.segment.left : rest.segment.right) = item.at;
    (whole.isForward ? rest.leftId : rest.rightId) = id;
    addPiece(next);
    inserted_.push_back({ whole.position, last, id });
    if (id < points_.count + addedBefore_ && isBeside(whole.position, item.at))
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

/// Sorts what was inserted by segments, then along them: as one round leaves it. What one inserted
/// into one segment comes in a row; a later one may have gone on between.
bool Splitter::sortInserted()
{
  const std::size_t n = inserted_.size();
  if (out_.rounds < 2)
  {
    return true;
  }
  const auto list = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      sorted_[k] = packed(inserted_[k].position, inserted_[k].place);
    }
  };
  sorted_.allocate(n);
  if (!inChunks(0, n, ticker_, list) || !sortPacked(sorted_, n, ticker_))
  {
    return false;
  }
  for (std::size_t begin = 0, end = 0; begin != n; begin = end)
  {
    const Index position = ownerOf(sorted_[begin]);
    while (end != n && ownerOf(sorted_[end]) == position)
    {
      ++end;
      if (!ticker_.step())
      {
        return false;
      }
    }
    if (!sortAlong(wayOf(nameOf(position)), &sorted_[begin], end - begin))
    {
      return false;
    }
    for (std::size_t k = begin; k != end; ++k)
    {
      const Index place = along_[k - begin].place;
      inserted_[k] = { position, place, places_[place].id };
    }
  }
  return true;
}

bool Splitter::makeChains()
{
  if (!sortInserted())
  {
    return false;
  }
  out_.lines = chains_.lines;
  out_.ids.reserve(ids_ + inserted_.size());
  out_.segments.reserve(ids_ + inserted_.size());
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
      for (; next != inserted_.size() && inserted_[next].position == k; ++next)
      {
        out_.ids.push_back(inserted_[next].id);
        out_.segments.push_back(segment);
        if (!ticker_.step())
        {
          return false;
        }
      }
      ticker_.finished(SplitUnits::kWritten);
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
