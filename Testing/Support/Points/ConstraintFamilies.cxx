// SPDX-License-Identifier: BSD-3-Clause
#include "ConstraintFamilies.h"

#include "Random.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace ahd
{
namespace test
{

namespace
{

using Order = std::vector<std::size_t>;

/// The same lines in another order.
ConstraintCase inOrder(const ConstraintCase& given, const Order& order)
{
  ConstraintCase result = given;
  result.constraints = ConstraintSet();
  for (const std::size_t k : order)
  {
    result.constraints.addLine(given.constraints.chain(k));
  }
  return result;
}

/// The numbers below n, in any order.
Order shuffledNumbers(std::size_t n, Random& random)
{
  Order order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t i = n; i > 1; --i)
  {
    std::swap(order[i - 1], order[random.below(i)]);
  }
  return order;
}

/// The same with one more line, the first or the last.
ConstraintCase withLine(
  const ConstraintCase& given, const Point& from, const Point& to, bool isFirst)
{
  ConstraintCase result = given;
  const auto id = std::int64_t(given.points.size());
  result.points.insert(result.points.end(), { from, to });
  result.constraints.addLine({ id, id + 1 });
  Order order(result.constraints.chains());
  std::iota(order.begin(), order.end(), std::size_t(0));
  if (isFirst)
  {
    std::rotate(order.begin(), order.end() - 1, order.end());
  }
  return inOrder(result, order);
}

/// n points anywhere in a strip about the line y = 0, none on it.
void addCrowd(ConstraintCase& to, std::size_t n, double width)
{
  Random random(1);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double side = random.below(2) == 0 ? 1.0 : -1.0;
    to.points.push_back({ width * random.unit(), side * width * (random.unit() + 0.01) });
  }
}

/// n / 2 segments on one line of n vertices, each within the one before.
ConstraintCase nested(std::size_t n)
{
  ConstraintCase result;
  for (std::size_t i = 0; i < n; ++i)
  {
    result.points.push_back({ double(i), 0.0 });
  }
  addCrowd(result, n, double(n));
  for (std::size_t i = 0; i < n / 2; ++i)
  {
    result.constraints.addLine({ std::int64_t(i), std::int64_t(n - 1 - i) });
  }
  return result;
}

/// The same line; segments that each begin and end one vertex further on.
ConstraintCase staggered(std::size_t n)
{
  ConstraintCase result = nested(n);
  result.constraints = ConstraintSet();
  for (std::size_t i = 0; i < n / 2; ++i)
  {
    result.constraints.addLine({ std::int64_t(i), std::int64_t(n / 2 + i) });
  }
  return result;
}

ConstraintCase repeated(std::size_t n)
{
  ConstraintCase result = nested(n);
  result.constraints = ConstraintSet();
  for (std::size_t i = 0; i < n; ++i)
  {
    result.constraints.addLine({ 0, std::int64_t(n - 1) });
  }
  return result;
}

/// n diagonals in a bundle, and one line across if `cut`.
ConstraintCase hatch(std::size_t n, bool cut)
{
  ConstraintCase result;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double x = double(i) / double(n);
    result.points.push_back({ x, -x });
    result.points.push_back({ x + 100.0, 100.0 - x });
    result.constraints.addLine({ std::int64_t(2 * i), std::int64_t(2 * i + 1) });
  }
  if (cut)
  {
    result.points.push_back({ 47.0, 53.1 });
    result.points.push_back({ 53.0, 46.7 });
    result.constraints.addLine({ std::int64_t(2 * n), std::int64_t(2 * n + 1) });
  }
  return result;
}

/// n cables side by side whose ends are anywhere within 1 % of their length.
ConstraintCase rails(std::size_t n)
{
  ConstraintCase result;
  Random random(2);
  for (std::size_t i = 0; i < n; ++i)
  {
    result.points.push_back({ 100.0 * random.unit(), 0.01 * double(i) });
    result.points.push_back({ 1e4 - 100.0 * random.unit(), 0.01 * double(i) });
    result.constraints.addLine({ std::int64_t(2 * i), std::int64_t(2 * i + 1) });
  }
  return result;
}

/// n cables of one length from one side of a corridor, turned by some angle, to the other, cut by
/// one line.
ConstraintCase corridor(std::size_t n, double length)
{
  ConstraintCase result;
  const auto add = [&](double x, double y) {
    result.points.push_back({ 0.75 * x - 0.66 * y, 0.66 * x + 0.75 * y });
  };
  for (std::size_t i = 0; i < n; ++i)
  {
    const double y = double(i) / double(n);
    add(0.0, y);
    add(length, y);
    result.constraints.addLine({ std::int64_t(2 * i), std::int64_t(2 * i + 1) });
  }
  add(0.5 * length, -0.1);
  add(0.5 * length, 1.1);
  result.constraints.addLine({ std::int64_t(2 * n), std::int64_t(2 * n + 1) });
  return result;
}

/// Segments from a column to a second one and from there to a third, all sheared.
ConstraintCase threeColumns(std::size_t n)
{
  ConstraintCase result;
  for (std::size_t i = 0; i < 3 * n; ++i)
  {
    const double x = 50.0 * double(i / n);
    result.points.push_back({ x, double(i % n) / double(n) - x });
  }
  for (std::size_t k = 0; k < 2; ++k)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      result.constraints.addLine({ std::int64_t(k * n + i), std::int64_t(k * n + n + i) });
    }
  }
  return result;
}

/// One square n times, among points.
ConstraintCase rings(std::size_t n)
{
  ConstraintCase result;
  result.points = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  Random random(3);
  for (std::size_t i = 0; i < n; ++i)
  {
    result.points.push_back({ 3.0 * random.unit() - 1.0, 3.0 * random.unit() - 1.0 });
    result.constraints.addLoop({ 0, 1, 2, 3 });
  }
  return result;
}

/// One segment between teeth of any length.
ConstraintCase comb(std::size_t n)
{
  ConstraintCase result;
  Random random(4);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double side = random.below(2) == 0 ? 1.0 : -1.0;
    result.points.push_back({ double(i) / double(n), side * (1.0 + 1000.0 * random.unit()) });
  }
  result.points.push_back({ -1.0, 0.0 });
  result.points.push_back({ 2.0, 0.0 });
  result.constraints.addLine({ std::int64_t(n), std::int64_t(n + 1) });
  return result;
}

/// Segments out of the middle of a circle of n points to a circle about that, in any order.
ConstraintCase fan(std::size_t n)
{
  ConstraintCase result;
  const std::vector<Point> ring = makePoints(Distribution::OnCircle, n, 5);
  result.points.push_back({ 0.5, 0.5 });
  result.points.insert(result.points.end(), ring.begin(), ring.end());
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point p = ring[i];
    result.points.push_back({ 0.5 + 3.0 * (p.x - 0.5), 0.5 + 3.0 * (p.y - 0.5) });
    result.constraints.addLine({ 0, std::int64_t(n + 1 + i) });
  }
  return result;
}

/// Some order of n segments.
Order someOrder(std::size_t n, Random& random)
{
  const std::size_t kind = random.below(5);
  Order order = shuffledNumbers(n, random);
  for (std::size_t i = 0; i < n && kind < 4; ++i)
  {
    const std::size_t fromBothEnds = i % 2 == 0 ? i / 2 : n - 1 - i / 2;
    const std::size_t kinds[4] = { i, n - 1 - i, fromBothEnds, i * 7919 % n };
    order[i] = kinds[kind];
  }
  return kind == 3 && n % 7919 == 0 ? shuffledNumbers(n, random) : order;
}

/// `count` ascending numbers up to `length`, crowded at some places.
std::vector<double> someNumbers(std::size_t count, double length, Random& random)
{
  std::vector<double> numbers;
  const std::size_t power = 1 + random.below(4);
  for (std::size_t i = 0; i < count; ++i)
  {
    numbers.push_back(length * std::pow(random.unit(), double(power)));
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// Rows of points one above the other; segments from row to row that do not cross.
ConstraintCase rowsOfPoints(std::size_t n, Random& random)
{
  ConstraintCase result;
  const std::size_t rows = 2 + random.below(4), each = n / rows;
  const double length = std::pow(10.0, double(random.below(5)) - 2.0);
  const double slant = random.unit();
  std::int64_t below = 0;
  for (std::size_t row = 0; row < rows; ++row)
  {
    const auto first = std::int64_t(result.points.size());
    for (const double x : someNumbers(each, length, random))
    {
      result.points.push_back({ x + slant * double(row), double(row) });
    }
    const std::size_t stride = 1 + random.below(3), shift = random.below(each / 2);
    for (std::size_t i = 0; row > 0 && i + shift < each; i += stride)
    {
      const std::size_t ends[2] = { i, i + shift };
      const std::size_t turned = row % 2;
      result.constraints.addLine(
        { below + std::int64_t(ends[turned]), first + std::int64_t(ends[1 - turned]) });
    }
    for (std::size_t i = 0; i < each / 4; ++i) // along the row
    {
      result.constraints.addLine(
        { first + std::int64_t(random.below(each)), first + std::int64_t(random.below(each)) });
    }
    below = first;
  }
  return result;
}

/// Bundles of parallel segments, all about one place.
ConstraintCase bundles(std::size_t n, Random& random)
{
  ConstraintCase result;
  const std::size_t count = 2 + random.below(3);
  const std::size_t each = std::size_t(std::sqrt(double(n) / double(count * (count - 1) / 2)));
  for (std::size_t bundle = 0; bundle < count; ++bundle)
  {
    const double x = random.unit() - 0.5, y = random.unit() - 0.5;
    const double gap = std::pow(10.0, -double(1 + random.below(4)));
    for (std::size_t i = 0; i < each; ++i)
    {
      const double aside = gap * (double(i) / double(each) - 0.5);
      const auto id = std::int64_t(result.points.size());
      result.points.push_back({ x - y * aside, y + x * aside });
      result.points.push_back({ -x - y * aside, -y + x * aside });
      result.constraints.addLine({ id, id + 1 });
    }
  }
  return result;
}

} // namespace

ConstraintCase ladder(std::size_t n, double width)
{
  ConstraintCase result;
  const auto half = std::int64_t(n / 2);
  for (std::int64_t i = 0; i < half; ++i)
  {
    result.points.push_back({ 0.0, double(i) });
  }
  for (std::int64_t i = 0; i < half; ++i)
  {
    result.points.push_back({ width, double(i) + 1e-3 });
  }
  for (std::int64_t i = 0; i < half / 2; ++i)
  {
    result.constraints.addLine({ i, half + half / 2 + i });
  }
  return result;
}

ConstraintCase crossedLadder(std::size_t n, std::size_t rungs, bool isFirst)
{
  const double middle = 0.375 * double(n), half = 0.5 * double(rungs) / double(n);
  return withLine(
    ladder(n, 0.25), { 0.125 - half, middle + 0.3 }, { 0.125 + half, middle }, isFirst);
}

ConstraintCase crossedNested(std::size_t n, double part, bool isFirst)
{
  const double x = std::floor(part * double(n)) + 0.5;
  return withLine(nested(n), { x, 1.0 }, { x, -1.0 }, isFirst);
}

ConstraintCase backwards(const ConstraintCase& given)
{
  Order order(given.constraints.chains());
  std::iota(order.rbegin(), order.rend(), std::size_t(0));
  return inOrder(given, order);
}

ConstraintCase shuffled(const ConstraintCase& given, std::uint64_t seed)
{
  Random random(seed);
  return inOrder(given, shuffledNumbers(given.constraints.chains(), random));
}

std::vector<ConstraintFamily> constraintFamilies(std::size_t n)
{
  return {
    { "ladder", ladder(n, 0.25) },
    { "wide ladder", ladder(n, double(n)) },
    { "ladder backwards", backwards(ladder(n, 0.25)) },
    { "nested", nested(n) },
    { "nested backwards", backwards(nested(n)) },
    { "staggered", staggered(n) },
    { "staggered backwards", backwards(staggered(n)) },
    { "repeated", repeated(n) },
    { "hatch", hatch(n / 2, false) },
    { "hatch, cut", hatch(n / 2, true), true },
    { "rails", rails(n / 2) },
    { "corridor", corridor(n / 3, 1.0), true },
    { "long corridor", corridor(n / 3, 100.0), true },
    { "three columns", threeColumns(n / 3) },
    { "rings", rings(n) },
    { "comb", comb(n) },
    { "fan", fan(n / 2) },
  };
}

ConstraintFamily randomFamily(std::uint64_t seed, std::size_t n)
{
  Random random(seed);
  const bool split = random.below(3) == 0;
  ConstraintCase given = split ? bundles(n, random) : rowsOfPoints(n, random);
  const std::size_t again = random.below(given.constraints.chains());
  for (std::size_t k = 0; k < again; ++k)
  {
    given.constraints.addLine(given.constraints.chain(again));
  }
  const Order order = someOrder(given.constraints.chains(), random);
  return { "seed " + std::to_string(seed), inOrder(given, order), split };
}

} // namespace test
} // namespace ahd
