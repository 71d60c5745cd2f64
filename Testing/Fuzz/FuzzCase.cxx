// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzCase.h"

#include "Executors.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

namespace ahd
{
namespace fuzz
{
namespace
{

constexpr std::size_t kPointBytes = 2 * sizeof(double);

/// The smallest box around the finite points; all zeros if there are none.
Bounds boundsOf(const std::vector<Point>& points)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Bounds b{ kInfinity, -kInfinity, kInfinity, -kInfinity };
  for (const Point& p : points)
  {
    if (isFinite(p))
    {
      b = { std::min(b.xmin, p.x), std::max(b.xmax, p.x), std::min(b.ymin, p.y),
        std::max(b.ymax, p.y) };
    }
  }
  return b.xmin <= b.xmax ? b : Bounds{ 0.0, 0.0, 0.0, 0.0 };
}

} // namespace

FuzzCase FuzzCase::fromBytes(const std::uint8_t* data, std::size_t size)
{
  FuzzCase result;
  const std::uint8_t* const end = data + size;
  const std::size_t headBytes = std::min<std::size_t>(size, kHeadBytes);
  std::copy(data, data + headBytes, result.head.begin());
  data += headBytes;
  const std::size_t points = std::min(
    { std::size_t(result.head[kPoints]), kMostGivenPoints, std::size_t(end - data) / kPointBytes });
  result.points.resize(points);
  if (points > 0)
  {
    std::memcpy(result.points.data(), data, points * kPointBytes);
  }
  result.chains.assign(data + points * kPointBytes, end);
  return result;
}

Bytes FuzzCase::bytes() const
{
  const std::size_t count = std::min(points.size(), kMostGivenPoints);
  Bytes result(kHeadBytes + count * kPointBytes);
  std::copy(head.begin(), head.end(), result.begin());
  result[kPoints] = std::uint8_t(count);
  if (count > 0)
  {
    std::memcpy(result.data() + kHeadBytes, points.data(), count * kPointBytes);
  }
  result.insert(result.end(), chains.begin(), chains.end());
  return result;
}

std::size_t FuzzCase::copies() const
{
  const std::size_t wanted = head[kCopies] < 240 ? 1 : std::size_t(1) << (head[kCopies] - 239);
  return std::min(wanted, kMostPoints / std::max<std::size_t>(1, points.size()));
}

std::vector<Point> FuzzCase::allPoints() const
{
  const Bounds bounds = boundsOf(points);
  const std::size_t side = std::size_t(std::ceil(std::sqrt(double(copies()))));
  std::vector<Point> result;
  for (std::size_t copy = 0; copy < copies(); ++copy)
  {
    const double dx = copy == 0 ? 0.0 : double(copy % side) * (bounds.xmax - bounds.xmin);
    const double dy = copy == 0 ? 0.0 : double(copy / side) * (bounds.ymax - bounds.ymin);
    for (const Point& p : points)
    {
      result.push_back(copy == 0 ? p : Point{ p.x + dx, p.y + dy });
    }
  }
  if (layoutBit(0))
  {
    for (Point& p : result)
    {
      p = { double(float(p.x)), double(float(p.y)) };
    }
  }
  return result;
}

std::vector<unsigned char> FuzzCase::skipMarks(std::size_t count) const
{
  const unsigned marks = head[kSkipMarks];
  std::vector<unsigned char> result(marks == 0 ? 0 : count);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    result[i] = static_cast<unsigned char>(marks << i % 8 | marks >> (8 - i % 8));
  }
  return result;
}

Options FuzzCase::options(std::size_t run) const
{
  const unsigned settings = head[kFirstSettings + run];
  const int nmax = head[kNmax] >> 4 * run & 15;
  Options result;
  result.order = InsertionOrder(settings & 3);
  result.controlPoints = ControlPoints((5 - (settings >> 2 & 3)) % 3);
  result.geneRotation = (settings >> 4 & 1) == 0;
  result.countWork = (settings >> 5 & 1) != 0;
  result.keepOrder = (settings >> 6 & 1) != 0;
  result.keepBoxes = (settings >> 7 & 1) != 0;
  result.nmax = nmax == 0 ? result.nmax : nmax;
  return result;
}

Executor* FuzzCase::executor(std::size_t run) const
{
  static test::ThreadExecutor two(2), three(3), twoOfEight(2, 8);
  static test::LateExecutor late(3);
  static test::BackwardExecutor backTwo(2), backFour(4), backMany(16);
  static test::ElsewhereExecutor elsewhere(2);
  Executor* const all[] = { &two, &three, &twoOfEight, &late, &backTwo, &backFour, &backMany,
    &elsewhere };
  const unsigned kind = head[kExecutors] >> 4 * run & 15;
  return kind < 8 ? nullptr : all[kind - 8];
}

test::ConstraintSet FuzzCase::constraints() const
{
  std::vector<test::Chain> lines, loops(1);
  test::Chain* chain = &loops.back();
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    const std::uint8_t byte = chains[i];
    if (byte == kNewLine || byte == kNewLoop)
    {
      auto& kind = byte == kNewLine ? lines : loops;
      kind.emplace_back();
      chain = &kind.back();
      continue;
    }
    const std::int64_t id = byte < points.size()
      ? std::int64_t(byte + points.size() * (i * 7919 % copies()))
      : std::int64_t(byte);
    chain->push_back(byte == kMinusOne ? -1
        : byte == kFarId               ? std::numeric_limits<std::int64_t>::max()
        : byte == kFarBelow            ? std::numeric_limits<std::int64_t>::min()
                                       : id);
  }
  test::ConstraintSet result;
  std::for_each(lines.begin(), lines.end(), [&](const test::Chain& c) { result.addLine(c); });
  std::for_each(loops.begin(), loops.end(), [&](const test::Chain& c) { result.addLoop(c); });
  return result;
}

std::string FuzzCase::text() const
{
  std::string result = "head";
  char line[100];
  for (const std::uint8_t byte : head)
  {
    std::snprintf(line, sizeof line, " %u", unsigned(byte));
    result += line;
  }
  result += "\n";
  for (const Point& p : points)
  {
    std::snprintf(line, sizeof line, "%a %a\n", p.x, p.y);
    result += line;
  }
  return result + constraints().text() + "\n";
}

} // namespace fuzz
} // namespace ahd
