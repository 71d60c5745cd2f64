// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentTree.h"

#include "../Core/SortAsking.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ahd
{

namespace
{

Bounds boxOf(const Point& p, const Point& q)
{
  return { std::min(p.x, q.x), std::max(p.x, q.x), std::min(p.y, q.y), std::max(p.y, q.y) };
}

bool meet(const Bounds& a, const Bounds& b)
{
  return a.xmin <= b.xmax && b.xmin <= a.xmax && a.ymin <= b.ymax && b.ymin <= a.ymax;
}

void add(Bounds& box, const Bounds& more)
{
  box = { std::min(box.xmin, more.xmin), std::max(box.xmax, more.xmax),
    std::min(box.ymin, more.ymin), std::max(box.ymax, more.ymax) };
}

/// How long a side of its box is, at most.
double lengthOf(const EndPair& s)
{
  return std::max(std::fabs(s.to.x - s.from.x), std::fabs(s.to.y - s.from.y));
}

/// All values from p + (q - p) * low to p + (q - p) * high, and a few more, between p and q.
/// REQUIRES: q - p does not overflow; 0 <= low <= high <= 1.
///
/// Proof. q - p, its product with low, and the sum have a relative error of 2^-53 each, and low is
/// known to as much: less than 2^-50 (|p| + |q|) in all, and 2^-1074 where the product underflows.
/// The rounding of the bounds is 2^-52 (|p| + |q|). Slack that overflows bounds nothing, and then p
/// and q do.
void partBetween(double p, double q, double low, double high, double& least, double& most)
{
  const double a = p + (q - p) * low, b = p + (q - p) * high;
  const double slack = 0x1p-48 * (std::fabs(p) + std::fabs(q)) + 0x1p-1060;
  least = std::max(std::min(p, q), std::min(a, b) - slack);
  most = std::min(std::max(p, q), std::max(a, b) + slack);
}

} // namespace

bool SegmentTree::reaches(const EndPair& segment, const Bounds& region)
{
  return meet(boxOf(segment.from, segment.to), region);
}

bool SegmentTree::build(
  std::vector<EndPair> segments, const Bounds& region, std::size_t extra, Ticker& ticker)
{
  segments_ = std::move(segments);
  parts_.clear();
  levels_.clear();
  return segments_.empty() || (cut(region, extra, ticker) && sort(ticker) && stack(ticker));
}

/// Into parts of about half of the average length, or less where there are extra ones.
bool SegmentTree::cut(const Bounds& region, std::size_t extra, Ticker& ticker)
{
  double sum = 0.0;
  for (const EndPair& s : segments_)
  {
    sum += lengthOf(s);
    if (!ticker.step())
    {
      return false;
    }
  }
  const double parts = 2.0 * double(segments_.size()) + double(extra);
  parts_.reserve(segments_.size());
  for (std::size_t i = 0; i != segments_.size(); ++i)
  {
    const EndPair& s = segments_[i];
    const double wanted = lengthOf(s) / sum * parts; // 0 or NaN if the sum overflows
    const std::size_t count = wanted >= 1.0 ? std::size_t(wanted) + 1 : 1;
    for (std::size_t k = 0; k != count; ++k)
    {
      Bounds box = boxOf(s.from, s.to);
      if (count > 1)
      {
        const double low = double(k) / double(count), high = double(k + 1) / double(count);
        partBetween(s.from.x, s.to.x, low, high, box.xmin, box.xmax);
        partBetween(s.from.y, s.to.y, low, high, box.ymin, box.ymax);
      }
      if (meet(box, region))
      {
        parts_.push_back({ box, static_cast<Index>(i), 0 });
      }
      if (!ticker.step())
      {
        return false;
      }
    }
  }
  return true;
}

/// Columns of equally many, each by rows.
bool SegmentTree::sort(Ticker& ticker)
{
  const auto isBefore = [](const Part& a, const Part& b)
  { return 0.5 * a.box.xmin + 0.5 * a.box.xmax < 0.5 * b.box.xmin + 0.5 * b.box.xmax; };
  const auto isBelow = [](const Part& a, const Part& b)
  {
    return a.column < b.column ||
      (a.column == b.column &&
        0.5 * a.box.ymin + 0.5 * a.box.ymax < 0.5 * b.box.ymin + 0.5 * b.box.ymax);
  };
  if (!sortAsking(parts_, ticker, isBefore))
  {
    return false;
  }
  const std::size_t n = parts_.size();
  const auto inColumn = std::max<std::size_t>(1, std::size_t(std::sqrt(double(kInBox * n))));
  const auto number = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t i = a; i != b; ++i)
    {
      parts_[i].column = static_cast<Index>(i / inColumn);
    }
  };
  return inChunks(0, n, ticker, number) && sortAsking(parts_, ticker, isBelow);
}

bool SegmentTree::stack(Ticker& ticker)
{
  const auto boxAt = [&](std::size_t level, std::size_t i) -> const Bounds&
  { return level == 0 ? parts_[i].box : levels_[level - 1][i]; };
  std::size_t count = parts_.size();
  while (levels_.empty() || count > 1)
  {
    const std::size_t level = levels_.size();
    std::vector<Bounds> boxes((count + kInBox - 1) / kInBox);
    const auto fit = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        if (i % kInBox == 0)
        {
          boxes[i / kInBox] = boxAt(level, i);
        }
        add(boxes[i / kInBox], boxAt(level, i));
      }
    };
    if (!inChunks(0, count, ticker, fit))
    {
      return false;
    }
    count = boxes.size();
    levels_.push_back(std::move(boxes));
  }
  return true;
}

SegmentTree::Answer SegmentTree::ask(const Corners& triangle, Ticker& ticker) const
{
  struct Place
  {
    std::size_t level, number; ///< level 0: a part
  };
  Bounds around = boxOf(triangle.a, triangle.b);
  add(around, boxOf(triangle.c, triangle.c));
  std::array<Place, kInBox * 22 + 1> open; // 8^22 parts are more than there can be
  std::size_t count = 0;
  if (!parts_.empty())
  {
    open[count++] = { levels_.size(), 0 };
  }
  while (count > 0)
  {
    const Place place = open[--count];
    const bool isPart = place.level == 0;
    if (!ticker.step())
    {
      return Answer::Cancelled;
    }
    if (!meet(around, isPart ? parts_[place.number].box : levels_[place.level - 1][place.number]))
    {
      continue;
    }
    if (isPart)
    {
      const EndPair& s = segments_[parts_[place.number].segment];
      if (touches(triangle, s.from, s.to))
      {
        return Answer::Touched;
      }
      continue;
    }
    const std::size_t below = place.level == 1 ? parts_.size() : levels_[place.level - 2].size();
    const std::size_t end = std::min((place.number + 1) * kInBox, below);
    for (std::size_t k = place.number * kInBox; k != end; ++k)
    {
      open[count++] = { place.level - 1, k };
    }
  }
  return Answer::Untouched;
}

} // namespace ahd
