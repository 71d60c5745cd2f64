// SPDX-License-Identifier: BSD-3-Clause
#include "RasterTask.h"

#include "../Core/Chunks.h"
#include "../Predicates/Predicates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace ahd
{

RasterTask::RasterTask(const SampledSurface& surface, const RasterGrid& grid,
  const SampledColumns& columns, unsigned char* mask)
  : surface_(surface)
  , grid_(grid)
  , owner_(surface_)
  , rim_(surface)
  , sink_(columns, surface, mask, false)
  , single_(nullptr)
  , mask_(mask)
{
  const SampledColumn* const first = columns.begin();
  if (columns.end() - first == 1 && first->components == 1 && !first->gradients)
  {
    single_ = first;
  }
}

SampleReport RasterTask::report() const
{
  SampleReport sum = sink_.report();
  addCounts(fast_, sum);
  return sum;
}

void RasterTask::load(std::size_t triangle)
{
  halfEdge_ = static_cast<HalfEdge>(3 * triangle);
  const Index* const v = surface_.tables->corners.data() + halfEdge_;
  for (unsigned k = 0; k != 3; ++k)
  {
    corners_[k] = surface_.at(v[k]);
  }
  // By table: which one is lower is as good as random.
  constexpr std::uint8_t kLow[8] = { 2, 2, 1, 0, 2, 0, 1, 0 };
  constexpr std::uint8_t kHigh[8] = { 0, 1, 0, 1, 0, 1, 2, 2 };
  const double a = corners_[0].y, b = corners_[1].y, c = corners_[2].y;
  const unsigned order = unsigned(a <= b) | unsigned(b <= c) << 1 | unsigned(a <= c) << 2;
  low_ = kLow[order];
  high_ = kHigh[order];
  middle_ = 3 - low_ - high_;
}

/// @pre the first corner is the lower one.
RasterTask::Edge RasterTask::edgeBetween(unsigned from, unsigned to) const
{
  const Point &a = corners_[from], &b = corners_[to];
  const unsigned begin = (from + 1) % 3 == to ? from : to;
  return { a, b, (b.x - a.x) / (b.y - a.y), halfEdge_ + begin };
}

/// Where the edge is at this y, which lies between its ends.
inline double RasterTask::crossingAt(const Edge& edge, double y)
{
  const double up = y - edge.from.y;
  return edge.from.x +
    (std::isfinite(edge.slope) ? up * edge.slope
                               : up / (edge.to.y - edge.from.y) * (edge.to.x - edge.from.x));
}

namespace
{

/// A place in a list of ascending numbers, by one that is as good as right; 0 if it is NaN.
std::size_t placeNear(double guess, std::size_t size)
{
  return static_cast<std::size_t>(
    static_cast<std::int64_t>(std::max(0.0, std::min(guess, static_cast<double>(size)))));
}

/// The first one that is not less, from a guess. Before the first there is minus infinity, behind
/// the last one infinity. @pre no NaN.
std::size_t firstNotLess(const double* numbers, double x, std::size_t guess)
{
  const double* at = numbers + guess;
  for (; at[-1] >= x; --at)
  {
  }
  for (; *at < x; ++at)
  {
  }
  return static_cast<std::size_t>(at - numbers);
}

} // namespace

/// The first row at or above this y.
std::size_t RasterTask::firstRow(double y) const
{
  const double guess = (y - grid_.origin.y) * grid_.perUnit.y;
  return firstNotLess(grid_.y, y, placeNear(guess, grid_.rows));
}

/// The column near this x, or behind it.
std::size_t RasterTask::columnNear(double x) const
{
  const std::size_t column = placeNear((x - grid_.origin.x) * grid_.perUnit.x, grid_.columns);
  return column + (grid_.x[column] < x ? 1 : 0);
}

/// Minus one to the left of an edge, one to the right of it.
int RasterTask::sideOf(const Edge& edge, const Point& place) const
{
  return -orient2d(edge.from, edge.to, place);
}

/// The first column of the row on this side of the edge, or farther to the right.
std::size_t RasterTask::firstBeyond(
  const Edge& edge, std::size_t row, std::size_t guess, int side) const
{
  for (; guess != 0 && sideOf(edge, placeOf(guess - 1, row)) >= side; --guess)
  {
  }
  for (; guess != grid_.columns && sideOf(edge, placeOf(guess, row)) < side; ++guess)
  {
  }
  return guess;
}

/// The columns that are on the edge; those before are to its left, those behind to its right.
/// @pre the row lies between the ends of the edge.
inline RasterTask::Columns RasterTask::crossed(const Edge& edge, std::size_t row) const
{
  const double x = crossingAt(edge, grid_.y[row]);
  const std::size_t column = columnNear(x);
  const double* const at = grid_.x + column;
  if ((*at - x > grid_.error) & (x - at[-1] > grid_.error))
  {
    return { column, column };
  }
  const std::size_t first = firstBeyond(edge, row, column, 0);
  return { first, firstBeyond(edge, row, first, 1) };
}

bool RasterTask::scan(std::size_t triangle, Ticker& ticker)
{
  if (!surface_.isKept(triangle))
  {
    return ticker.step();
  }
  load(triangle);
  const Point &low = corners_[low_], &middle = corners_[middle_], &high = corners_[high_];
  const std::size_t begin = firstRow(low.y);
  if (grid_.y[begin] > high.y)
  {
    return ticker.step();
  }
  const std::size_t behind = firstRow(high.y);
  isEasy_ = isEasy(corners_[0], corners_[1], corners_[2]);
  isFast_ = single_ && isEasy_;
  for (unsigned k = 0; isFast_ && k != 3; ++k)
  {
    values_[k] = single_->at(surface_.tables->corners[halfEdge_ + k], 0);
    isFast_ = std::isfinite(values_[k]);
  }
  const Edge longEdge = edgeBetween(low_, high_);
  std::size_t row = begin;
  return scanCorner(longEdge, low.y, row, ticker) &&
    scanRows(longEdge, low_, middle_, row, firstRow(middle.y), ticker) &&
    scanCorner(longEdge, middle.y, row, ticker) &&
    scanRows(longEdge, middle_, high_, row, behind, ticker) &&
    scanCorner(longEdge, high.y, row, ticker);
}

/// The rows that have a corner at this y.
bool RasterTask::scanCorner(const Edge& longEdge, double y, std::size_t& row, Ticker& ticker)
{
  for (; grid_.y[row] == y; ++row)
  {
    if (!scanRowOfCorner(longEdge, row, ticker))
    {
      return false;
    }
  }
  return true;
}

/// Rows from `row` to `end` that the long edge and the one between two corners cross.
bool RasterTask::scanRows(const Edge& longEdge, unsigned from, unsigned to, std::size_t& row,
  std::size_t end, Ticker& ticker)
{
  if (row >= end)
  {
    return true;
  }
  const Edge shortEdge = edgeBetween(from, to);
  // Corners are counterclockwise: if they follow each other upwards, the middle one is on the
  // right.
  const bool isMiddleRight = (low_ + 1) % 3 == middle_;
  const Edge& left = isMiddleRight ? longEdge : shortEdge;
  const Edge& right = isMiddleRight ? shortEdge : longEdge;
  std::size_t steps = 1;
  for (; row != end; ++row)
  {
    const Columns begin = crossed(left, row), behind = crossed(right, row);
    if ((begin.first != begin.last) | (behind.first != behind.last))
    {
      if (!putOnEdge(left.halfEdge, begin, row, ticker) ||
        !putOnEdge(right.halfEdge, behind, row, ticker))
      {
        return false;
      }
    }
    const Columns inside{ begin.last, behind.first };
    if (isFast_ & (inside.last - inside.first <= kFew))
    {
      putFast(inside, row);
      steps += 1 + inside.last - inside.first;
    }
    else if (!putInside(inside, row, ticker))
    {
      return false;
    }
    if (steps > kFew)
    {
      if (!ticker.step(std::exchange(steps, 0)))
      {
        return false;
      }
    }
  }
  return ticker.step(steps);
}

/// A row through a corner: few have one, but for rasters that are aligned with the points.
bool RasterTask::scanRowOfCorner(const Edge& longEdge, std::size_t row, Ticker& ticker)
{
  const double y = grid_.y[row];
  double first = HUGE_VAL, last = -HUGE_VAL;
  for (const Point& corner : corners_)
  {
    first = corner.y == y ? std::min(first, corner.x) : first;
    last = corner.y == y ? std::max(last, corner.x) : last;
  }
  if (y == corners_[middle_].y && y != corners_[low_].y && y != corners_[high_].y)
  {
    const double x = crossingAt(longEdge, y);
    first = std::min(first, x - 2.0 * grid_.error);
    last = std::max(last, x + 2.0 * grid_.error);
  }
  for (std::size_t k = firstNotLess(grid_.x, first, columnNear(first)); grid_.x[k] <= last; ++k)
  {
    if (!putCell(k, row, ticker))
    {
      return false;
    }
  }
  return ticker.step();
}

/// A cell that lies anywhere.
bool RasterTask::putCell(std::size_t column, std::size_t row, Ticker& ticker)
{
  constexpr std::size_t kStepsOfCell = 4;
  const Point place = placeOf(column, row);
  const HalfEdge end = halfEdge_ + 3;
  HalfEdge on = kNoHalfEdge;
  for (HalfEdge h = halfEdge_; h != end; ++h)
  {
    if (corners_[h - halfEdge_] == place)
    {
      Spot spot;
      if (!owner_.ofVertex(surface_.tables->origin(h), ticker, spot))
      {
        return false;
      }
      return ticker.step(kStepsOfCell) &&
        (spot.halfEdge / 3 != halfEdge_ / 3 ||
          sink_.put(cellOf(column, row), rim_.onVertex(spot.halfEdge), ticker));
    }
  }
  for (HalfEdge h = halfEdge_; h != end; ++h)
  {
    const int side = orient2d(corners_[h - halfEdge_], corners_[(h + 1 - halfEdge_) % 3], place);
    if (side < 0)
    {
      return ticker.step(kStepsOfCell);
    }
    on = side == 0 ? h : on;
  }
  if (on != kNoHalfEdge)
  {
    return ticker.step(kStepsOfCell) && putOnEdge(on, { column, column + 1 }, row, ticker);
  }
  return putInside({ column, column + 1 }, row, ticker);
}

bool RasterTask::putOnEdge(HalfEdge h, Columns columns, std::size_t row, Ticker& ticker)
{
  if (columns.first == columns.last)
  {
    return true;
  }
  const Spot spot = owner_.ofEdge(h);
  if (spot.halfEdge / 3 != halfEdge_ / 3)
  {
    return true;
  }
  for (std::size_t k = columns.first; k != columns.last; ++k)
  {
    if (!sink_.put(cellOf(k, row), rim_.onEdge(spot.halfEdge, placeOf(k, row)), ticker))
    {
      return false;
    }
  }
  return true;
}

bool RasterTask::putInside(Columns columns, std::size_t row, Ticker& ticker)
{
  for (std::size_t first = columns.first; first < columns.last;)
  {
    const std::size_t last = std::min(columns.last, first + kChunk);
    if (isFast_)
    {
      putFast({ first, last }, row);
    }
    else if (!putAny({ first, last }, row, ticker))
    {
      return false;
    }
    if (!ticker.step(last - first))
    {
      return false;
    }
    first = last;
  }
  return ticker.step();
}

bool RasterTask::putAny(Columns columns, std::size_t row, Ticker& ticker)
{
  double weights[3];
  const Weights found{ surface_.tables->corners.data() + halfEdge_, weights, 3, halfEdge_ };
  for (std::size_t k = columns.first; k != columns.last; ++k)
  {
    const Point place = placeOf(k, row);
    isEasy_ ? easyWeights(corners_[0], corners_[1], corners_[2], place, weights)
            : hardWeights(corners_[0], corners_[1], corners_[2], place, weights);
    if (!sink_.put(cellOf(k, row), found, ticker))
    {
      return false;
    }
  }
  return true;
}

/// What the sink does with one component of finite values: the same sums.
inline void RasterTask::putFast(Columns columns, std::size_t row)
{
  const Point a = corners_[0], b = corners_[1], c = corners_[2];
  const double ofA = values_[0], ofB = values_[1], ofC = values_[2];
  double* const out = single_->out + cellOf(0, row);
  unsigned char* const mask = mask_ ? mask_ + cellOf(0, row) : nullptr;
  for (std::size_t k = columns.first; k != columns.last; ++k)
  {
    double weights[3];
    easyWeights(a, b, c, placeOf(k, row), weights);
    out[k] = 0.0 + weights[0] * ofA + weights[1] * ofB + weights[2] * ofC;
    if (mask)
    {
      mask[k] = 1;
    }
  }
  fast_.valued += columns.last - columns.first;
}

} // namespace ahd
