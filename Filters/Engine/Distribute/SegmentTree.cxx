// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentTree.h"

#include "../Core/Chunks.h"
#include "../Order/CurveKeys.h"

#include <algorithm>
#include <cmath>

namespace ahd
{

namespace
{

Box boxOf(const EndPair& s)
{
  return Box::around(s.from, s.to);
}

Box boxOf(const Bounds& b)
{
  return Box::around({ b.xmin, b.ymin }, { b.xmax, b.ymax });
}

/// How long a side of its box is, at most.
double lengthOf(const EndPair& s)
{
  return std::max(std::fabs(s.to.x - s.from.x), std::fabs(s.to.y - s.from.y));
}

/// All values from p + (q - p) * low to p + (q - p) * high, and a few more, between p and q.
/// @pre q - p does not overflow; 0 <= low <= high <= 1.
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
  return boxOf(segment).meets(boxOf(region));
}

bool SegmentTree::build(
  std::vector<EndPair> segments, const Bounds& region, std::size_t extra, Ticker& ticker)
{
  segments_ = std::move(segments);
  parts_.clear();
  levels_.allocate(0);
  return segments_.empty() || (cut(boxOf(region), extra, ticker) && sort(ticker));
}

/// Into parts of about half of the average length, or less where there are extra ones.
bool SegmentTree::cut(const Box& region, std::size_t extra, Ticker& ticker)
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
      Box box = boxOf(s);
      if (count > 1)
      {
        const double low = double(k) / double(count), high = double(k + 1) / double(count);
        partBetween(s.from.x, s.to.x, low, high, box.xmin, box.xmax);
        partBetween(s.from.y, s.to.y, low, high, box.ymin, box.ymax);
      }
      if (box.meets(region))
      {
        parts_.push_back({ box, static_cast<Index>(i) });
      }
      if (!ticker.step())
      {
        return false;
      }
    }
  }
  return true;
}

/// Along the curve, and boxes around them.
bool SegmentTree::sort(Ticker& ticker)
{
  const std::size_t n = parts_.size();
  const auto boxOf = [&](std::size_t k) -> const Box& { return parts_[k].box; };
  Box all;
  Buffer<std::uint64_t> keys;
  if (!sortAlongCurve(n, boxOf, keys, all, ticker))
  {
    return false;
  }
  std::vector<Part> sorted(n);
  const auto take = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      sorted[k] = parts_[static_cast<Index>(keys[k])];
    }
  };
  if (!inChunks(0, n, ticker, take))
  {
    return false;
  }
  parts_ = std::move(sorted);
  levels_.allocate(n);
  return levels_.fitItems(boxOf, ticker);
}

SegmentTree::Answer SegmentTree::ask(const Corners& triangle, Ticker& ticker) const
{
  Box around = Box::around(triangle.a, triangle.b);
  around.add(Box::around(triangle.c, triangle.c));
  Answer answer = Answer::Untouched;
  const auto enter = [&](const Box& box)
  {
    if (!ticker.step())
    {
      answer = Answer::Cancelled;
      return Levels::Way::Stop;
    }
    return box.meets(around) ? Levels::Way::In : Levels::Way::Past;
  };
  const auto look = [&](std::size_t leaf)
  {
    for (std::size_t k = levels_.childrenBegin(0, leaf); k != levels_.childrenEnd(0, leaf); ++k)
    {
      const EndPair& s = segments_[parts_[k].segment];
      if (parts_[k].box.meets(around) && touches(triangle, s.from, s.to))
      {
        answer = Answer::Touched;
        return false;
      }
    }
    return true;
  };
  levels_.visit(enter, look);
  return answer;
}

} // namespace ahd
