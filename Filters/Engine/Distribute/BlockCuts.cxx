// SPDX-License-Identifier: BSD-3-Clause
#include "BlockCuts.h"

#include "../Core/Border.h"
#include "../Core/SortAsking.h"

#include <algorithm>

namespace ahd
{

namespace
{

/// The same points in two orders: a cut at a place splits both into the same two parts.
struct SortedSamples
{
  std::vector<Point> byX, byY;
};

double coordinate(const Point& p, bool isX)
{
  return isX ? p.x : p.y;
}

} // namespace

/// Cuts rows of blocks with their samples, the largest first.
class BlockCutter
{
public:
  BlockCutter(BlockCuts& out, Ticker& ticker)
    : cuts_(out.cuts_)
    , ticker_(ticker)
  {
  }

  bool cutAll(const std::vector<Point>& samples, std::size_t blocks);

private:
  struct Row
  {
    std::size_t beginBlock, endBlock;
    std::size_t begin, end; ///< of its samples, in both orders
  };

  BlockCuts::Cut choose(const Row& row, std::size_t middle) const;
  bool part(const Row& row, const BlockCuts::Cut& cut, std::size_t& below);

  std::vector<BlockCuts::Cut>& cuts_;
  Ticker& ticker_;
  SortedSamples samples_;
  std::vector<Point> above_;
};

bool BlockCutter::cutAll(const std::vector<Point>& samples, std::size_t blocks)
{
  cuts_.assign(blocks, { 0.0, true });
  samples_ = { samples, samples };
  const auto isLower = [](const Point& a, const Point& b)
  { return a.y < b.y || (a.y == b.y && a.x < b.x); };
  if (!sortAsking(samples_.byX, ticker_, lexicographicallyLess) ||
    !sortAsking(samples_.byY, ticker_, isLower))
  {
    return false;
  }
  std::vector<Row> rows{ { 0, blocks, 0, samples.size() } };
  while (!rows.empty())
  {
    const Row row = rows.back();
    rows.pop_back();
    if (row.endBlock - row.beginBlock < 2)
    {
      continue;
    }
    const std::size_t middle = middleBlock(row.beginBlock, row.endBlock);
    cuts_[middle] = choose(row, middle);
    std::size_t below = row.begin;
    if (!part(row, cuts_[middle], below) || !ticker_.step())
    {
      return false;
    }
    rows.push_back({ row.beginBlock, middle, row.begin, below });
    rows.push_back({ middle, row.endBlock, below, row.end });
  }
  return true;
}

/// At a sample, so that the number below is as near to the target as possible.
BlockCuts::Cut BlockCutter::choose(const Row& row, std::size_t middle) const
{
  if (row.begin == row.end)
  {
    return { 0.0, true };
  }
  const Point* const x = samples_.byX.data();
  const Point* const y = samples_.byY.data();
  const double width = 0.5 * x[row.end - 1].x - 0.5 * x[row.begin].x;
  const double height = 0.5 * y[row.end - 1].y - 0.5 * y[row.begin].y;
  const bool isX = width >= height;
  const Point* const first = (isX ? x : y) + row.begin;
  const Point* const last = (isX ? x : y) + row.end;
  const std::size_t wanted = (row.end - row.begin) * (middle - row.beginBlock) /
    (row.endBlock - row.beginBlock);
  const double at = coordinate(first[wanted], isX);
  const auto isBelow = [&](const Point& p, double value) { return coordinate(p, isX) < value; };
  const auto isAbove = [&](double value, const Point& p) { return value < coordinate(p, isX); };
  const Point* const same = std::lower_bound(first, last, at, isBelow);
  const Point* const next = std::upper_bound(first, last, at, isAbove);
  const bool isNextNearer = next != last && next - (first + wanted) < (first + wanted) - same;
  return { isNextNearer ? coordinate(*next, isX) : at, isX };
}

/// Puts the samples below the cut first, in both orders.
bool BlockCutter::part(const Row& row, const BlockCuts::Cut& cut, std::size_t& below)
{
  for (std::vector<Point>* order : { &samples_.byX, &samples_.byY })
  {
    above_.clear();
    std::size_t to = row.begin;
    const auto move = [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        const Point p = (*order)[i];
        if (coordinate(p, cut.isAcrossX) < cut.at)
        {
          (*order)[to++] = p;
        }
        else
        {
          above_.push_back(p);
        }
      }
    };
    if (!inChunks(row.begin, row.end, ticker_, move))
    {
      return false;
    }
    below = to;
    const auto moveBack = [&](std::size_t a, std::size_t b)
    { std::copy(above_.data() + a, above_.data() + b, order->data() + below + a); };
    if (!inChunks(0, above_.size(), ticker_, moveBack))
    {
      return false;
    }
  }
  return true;
}

Status cutIntoBlocks(
  const std::vector<Point>& samples, std::size_t blocks, const Context& context, BlockCuts& out)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      return BlockCutter(out, ticker).cutAll(samples, blocks) && ticker.ask();
    });
}

Status samplePoints(const PointView& points, std::size_t most, std::vector<Point>& out)
{
  return withoutThrowing(
    [&]
    {
      const std::size_t count = std::min(most, points.count);
      out.clear();
      out.reserve(count);
      for (std::size_t k = 0; k != count; ++k)
      {
        // Not k * points.count / count, which may be too large a product.
        const std::size_t i = points.count / count * k + points.count % count * k / count;
        if (isFinite(points[i]) && !points.skipped(i))
        {
          out.push_back(points[i]);
        }
      }
      return Status::Ok;
    });
}

} // namespace ahd
