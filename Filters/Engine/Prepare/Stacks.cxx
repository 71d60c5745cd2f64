// SPDX-License-Identifier: BSD-3-Clause
#include "Stacks.h"

#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Surface/Vectors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace ahd
{
namespace
{

/// Calls work(p) for each point that counts. Returns false if cancelled.
template <typename Work>
bool forEach(const PointView& points, Ticker& ticker, const Work& work)
{
  return inChunks(0, points.count, ticker,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Vector3 p = points.place(i);
        if (!points.skipped(i) && p[0] * 0 + p[1] * 0 + p[2] * 0 == 0)
        {
          work(p);
        }
      }
    });
}

/// Half of b - a, which itself may overflow.
Vector3 halfWay(const Vector3& a, const Vector3& b)
{
  return { { b[0] / 2 - a[0] / 2, b[1] / 2 - a[1] / 2, b[2] / 2 - a[2] / 2 } };
}

double lengthOf(const Vector3& v)
{
  return std::max({ std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) });
}

/// The distance of `v` from the line along `line`, as a part of that line's length.
double distanceFrom(const Vector3& line, const Vector3& v)
{
  const double length = lengthOf(line);
  Vector3 a, b;
  for (std::size_t k = 0; k < 3; ++k)
  {
    a[k] = line[k] / length;
    b[k] = v[k] / length;
  }
  const Vector3 cross = { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0] } };
  return lengthOf(cross);
}

/// Points of the sample with one x and y, and the lowest and highest z of all points there.
struct Stack
{
  double x, y, low, high;
  std::size_t samples;
};

bool isBefore(const Stack& a, const Stack& b)
{
  return std::tie(a.x, a.y) < std::tie(b.x, b.y);
}

/// Samples one of every so many points, and groups those of one x and y.
bool takeSample(const PointView& points, Ticker& ticker, std::vector<Stack>& stacks)
{
  constexpr std::size_t kSamples = 256;
  const std::size_t stride = points.count / kSamples + 1;
  std::size_t i = 0;
  const bool all = forEach(points, ticker,
    [&](const Vector3& p)
    {
      if (i++ % stride == 0)
      {
        stacks.push_back({ p[0], p[1], p[2], p[2], 1 });
      }
    });
  std::sort(stacks.begin(), stacks.end(), isBefore);
  std::vector<Stack> distinct;
  for (const Stack& stack : stacks)
  {
    if (distinct.empty() || isBefore(distinct.back(), stack))
    {
      distinct.push_back(stack);
    }
    else
    {
      ++distinct.back().samples;
    }
  }
  stacks.swap(distinct);
  return all;
}

} // namespace

Status findIfOnOneLine(const PointView& points, const Context& context, bool& isSo)
{
  isSo = true;
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Extract, 0);
      bool isFirst = true;
      Vector3 first = {}, line = {};
      const bool all = forEach(points, ticker,
        [&](const Vector3& p)
        {
          first = isFirst ? p : first;
          isFirst = false;
          const Vector3 way = halfWay(first, p);
          line = lengthOf(way) > lengthOf(line) ? way : line;
        });
      return all &&
        (lengthOf(line) == 0.0 ||
          forEach(points, ticker,
            [&](const Vector3& p)
            { isSo = isSo && distanceFrom(line, halfWay(first, p)) < 1e-6; }));
    });
}

Status findIfStacked(const PointView& points, const Context& context, bool& isSo)
{
  isSo = false;
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Extract, 0);
      std::vector<Stack> stacks;
      const bool all = takeSample(points, ticker, stacks) &&
        forEach(points, ticker,
          [&](const Vector3& p)
          {
            const Stack at = { p[0], p[1], p[2], p[2], 0 };
            const auto found = std::lower_bound(stacks.begin(), stacks.end(), at, isBefore);
            if (found != stacks.end() && !isBefore(at, *found))
            {
              found->low = std::min(found->low, p[2]);
              found->high = std::max(found->high, p[2]);
            }
          });
      std::size_t samples = 0, stacked = 0;
      for (const Stack& stack : stacks)
      {
        samples += stack.samples;
        stacked += stack.low < stack.high ? stack.samples : 0;
      }
      isSo = 2 * stacked > samples;
      return all;
    });
}

} // namespace ahd
