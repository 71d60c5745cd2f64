// SPDX-License-Identifier: BSD-3-Clause
#include "GridBoxes.h"

#include "../Core/Chunks.h"
#include "HilbertCurve.h"
#include "Quantise.h"
#include "Sequence.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace ahd
{

namespace
{

/// A box: the places that agree with `column` and `row`, its numbers among the boxes of its size,
/// above `below` levels of the finest grid.
struct Piece
{
  std::uint64_t column, row;
  unsigned below;
  int level;              ///< divisions that made it
  std::size_t begin, end; ///< its points, by rank
};

class BoxLister
{
public:
  BoxLister(
    const RankedPoints& points, const Options& options, Ticker& ticker, std::vector<GridBox>& boxes)
    : points_(points)
    , options_(options)
    , ticker_(ticker)
    , boxes_(boxes)
    , grid_(points.whole)
  {
  }

  Status list()
  {
    const Piece whole{ 0, 0, 32, 0, 0, points_.count };
    const unsigned levels = levelsOfFirstDivision(points_.count, options_);
    if (levels == 0)
    {
      leave(whole);
      return Status::Ok;
    }
    open_[depth_++] = { whole, levels, 0, 0 };
    while (depth_ > 0)
    {
      Division& division = open_[depth_ - 1];
      if (division.next == std::uint64_t(1) << (2 * division.levels))
      {
        --depth_;
        continue;
      }
      const Piece box = quarter(division, division.next++);
      if ((depth_ == 1 && !findControlPoint(box)) || !ticker_.step())
      {
        return Status::Cancelled;
      }
      if (divideOrLeave(box) && boxes_.size() > options_.mostBoxes)
      {
        return Status::TooManyBoxes;
      }
    }
    return Status::Ok;
  }

private:
  struct Division
  {
    Piece box;
    unsigned levels;
    std::uint64_t next;  ///< the box to visit next
    std::uint64_t first; ///< the smallest key of the box
  };

  /// The visit-th box of a division.
  Piece quarter(const Division& division, std::uint64_t visit)
  {
    const unsigned levels = division.levels;
    const Piece& whole = division.box;
    Piece box{ whole.column << levels, whole.row << levels, whole.below - levels, whole.level + 1,
      0, 0 };
    if (options_.order != InsertionOrder::AdaptiveHilbert)
    {
      box.column |= visit & ((std::uint64_t(1) << levels) - 1);
      box.row |= visit >> levels;
    }
    else if (!options_.geneRotation)
    {
      const GridPlace place = placeOfKey(visit << (64 - 2 * levels));
      box.column |= place.column >> (32 - levels);
      box.row |= place.row >> (32 - levels);
    }
    else
    {
      const std::uint64_t first = division.first | visit << (2 * box.below);
      const GridPlace place = placeOfKey(first);
      box.column = place.column >> box.below;
      box.row = place.row >> box.below;
      findPoints(whole, first, box);
      return box;
    }
    findPoints(whole, beginKey(box), box);
    return box;
  }

  /// The smallest key of a box.
  static std::uint64_t beginKey(const Piece& box)
  {
    if (box.below == 32)
    {
      return 0;
    }
    const std::uint64_t key = hilbertKey(static_cast<std::uint32_t>(box.column << box.below),
      static_cast<std::uint32_t>(box.row << box.below));
    return key >> (2 * box.below) << (2 * box.below);
  }

  /// `first`: the smallest key of the box. Along the curve a box begins where the one visited
  /// before it has ended; in other orders its points are searched for.
  void findPoints(const Piece& whole, std::uint64_t first, Piece& box)
  {
    const std::uint64_t last = first | ((std::uint64_t(1) << (2 * box.below)) - 1);
    const std::uint64_t* const keys = points_.key.data();
    const bool follows = whole.begin <= past_ && past_ <= whole.end &&
      (past_ == whole.begin || keys[past_ - 1] < first) &&
      (past_ == whole.end || keys[past_] >= first);
    const std::uint64_t* const begin = follows
      ? keys + past_
      : std::lower_bound(keys + whole.begin, keys + whole.end, first);
    box.begin = std::size_t(begin - keys);
    box.end = past_ = std::size_t(endOf(begin, keys + whole.end, last) - keys);
  }

  /// The first key from `begin` on that is greater than `last`: a few steps of growing length find
  /// it, as most boxes have few points.
  static const std::uint64_t* endOf(
    const std::uint64_t* begin, const std::uint64_t* end, std::uint64_t last)
  {
    for (std::ptrdiff_t step = 8; step < end - begin; step *= 2)
    {
      if (begin[step] > last)
      {
        return std::upper_bound(begin, begin + step, last);
      }
      begin += step;
    }
    return std::upper_bound(begin, end, last);
  }

  /// The control point of a box of the first division, which does not count where it is decided
  /// whether boxes are divided. Returns false if the work is cancelled.
  bool findControlPoint(const Piece& box)
  {
    control_ = points_.count;
    return options_.controlPoints != ControlPoints::SingleLevel ||
      inChunks(box.begin, box.end, ticker_,
        [&](std::size_t a, std::size_t b)
        {
          for (std::size_t i = a; i < b; ++i)
          {
            control_ = control_ == points_.count || points_.id[i] < points_.id[control_] ? i
                                                                                         : control_;
          }
        });
  }

  /// Returns true if the box was left undivided.
  bool divideOrLeave(const Piece& box)
  {
    const bool holdsControl = box.begin <= control_ && control_ < box.end;
    const std::size_t count = box.end - box.begin - (holdsControl ? 1 : 0);
    const unsigned levels = levelsOfDivision(count);
    const bool isDivided = isDividedAgain(count, options_) && levels <= box.below;
    if (isDivided)
    {
      open_[depth_++] = { box, levels, 0, beginKey(box) };
    }
    else
    {
      leave(box);
    }
    return !isDivided;
  }

  void leave(const Piece& box)
  {
    const auto edge = [&box](const Quantiser& axis, std::uint64_t place)
    { return axis.begin(place << box.below); };
    boxes_.push_back({ edge(grid_.column, box.column), edge(grid_.column, box.column + 1),
      edge(grid_.row, box.row), edge(grid_.row, box.row + 1), box.level, box.end - box.begin });
  }

  const RankedPoints& points_;
  const Options& options_;
  Ticker& ticker_;
  std::vector<GridBox>& boxes_;
  const Grid grid_;
  std::array<Division, 33> open_; ///< each division halves its boxes at least once
  std::size_t depth_ = 0;
  std::size_t control_ = 0;
  std::size_t past_ = 0; ///< behind the points of the box visited last
};

} // namespace

Status listBoxes(
  const RankedPoints& points, const Options& options, Ticker& ticker, std::vector<GridBox>& boxes)
{
  boxes.clear();
  if (points.count == 0 || options.order == InsertionOrder::AsGiven)
  {
    return Status::Ok;
  }
  return BoxLister(points, options, ticker, boxes).list();
}

} // namespace ahd
