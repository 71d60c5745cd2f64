// SPDX-License-Identifier: BSD-3-Clause
#include "Moves.h"

#include <algorithm>

namespace ahd
{
namespace fuzz
{
namespace
{

/// Room for the head, all points and some chains in libFuzzer's 4096 bytes.
constexpr std::size_t kMostChainBytes = 240;

std::uint8_t someId(const FuzzCase& mutated, Dice& dice)
{
  return mutated.points.empty() || dice.below(40) == 0
    ? std::uint8_t(dice.below(256))
    : std::uint8_t(dice.below(mutated.points.size()));
}

void append(FuzzCase& mutated, std::initializer_list<std::uint8_t> bytes)
{
  mutated.chains.insert(mutated.chains.end(), bytes);
}

std::uint8_t addPoint(FuzzCase& mutated, const Point& p)
{
  const std::size_t id = std::min(mutated.points.size(), kMostGivenPoints - 1);
  mutated.points.resize(id);
  mutated.points.push_back(p);
  return std::uint8_t(id);
}

Point pointOf(const FuzzCase& mutated, std::uint8_t id)
{
  return id < mutated.points.size() ? mutated.points[id] : Point{ 0.0, 0.0 };
}

/// A segment with a new point on it, rounded.
void addSegmentThrough(FuzzCase& mutated, Dice& dice)
{
  const std::uint8_t a = someId(mutated, dice), b = someId(mutated, dice);
  const Point p = pointOf(mutated, a), q = pointOf(mutated, b);
  const double t = double(1 + dice.below(7)) / 8;
  const std::uint8_t on = addPoint(mutated, { p.x + t * (q.x - p.x), p.y + t * (q.y - p.y) });
  append(mutated, { kNewLine, a, b, kNewLine, on, dice.below(2) == 0 ? a : someId(mutated, dice) });
}

/// Two segments that cross in a square of new points, or the bend of one around the other.
void addCross(FuzzCase& mutated, Dice& dice)
{
  const Point p = pointOf(mutated, someId(mutated, dice)),
              q = pointOf(mutated, someId(mutated, dice));
  const std::uint8_t a = addPoint(mutated, p), b = addPoint(mutated, q);
  const std::uint8_t c = addPoint(mutated, { p.x, q.y }), d = addPoint(mutated, { q.x, p.y });
  append(mutated, { dice.below(3) == 0 ? kNewLoop : kNewLine, a, b });
  append(mutated, { dice.below(3) == 0 ? std::uint8_t(a) : std::uint8_t(kNewLine), c, d });
}

/// Two squares, one within the other, the inner one either way round.
void addNest(FuzzCase& mutated, Dice& dice)
{
  const Point p = pointOf(mutated, someId(mutated, dice));
  for (const double size : { 8.0, dice.below(3) == 0 ? 8.0 : 3.0 })
  {
    const std::uint8_t a = addPoint(mutated, { p.x - size, p.y - size });
    const std::uint8_t b = addPoint(mutated, { p.x + size, p.y - size });
    const std::uint8_t c = addPoint(mutated, { p.x + size, p.y + size });
    const std::uint8_t d = addPoint(mutated, { p.x - size, p.y + size });
    append(mutated, { kNewLoop, a, b, c, d });
    if (dice.below(2) == 0)
    {
      std::reverse(mutated.chains.end() - 4, mutated.chains.end());
    }
  }
}

void addChain(FuzzCase& mutated, Dice& dice)
{
  append(mutated, { dice.below(2) == 0 ? kNewLine : kNewLoop });
  for (std::size_t count = dice.below(dice.below(4) == 0 ? 30 : 6); count > 0; --count)
  {
    append(mutated, { someId(mutated, dice) });
  }
}

/// Bytes once more, as they are or turned round: overlaps, and ways back and forth.
void repeat(Bytes& chains, Dice& dice)
{
  const std::size_t from = dice.below(chains.size());
  const std::size_t count = std::min(chains.size() - from, 1 + dice.below(8));
  const Bytes part(
    chains.begin() + std::ptrdiff_t(from), chains.begin() + std::ptrdiff_t(from + count));
  chains.insert(chains.end(), part.begin(), part.end());
  if (dice.below(2) == 0)
  {
    std::reverse(chains.end() - std::ptrdiff_t(count), chains.end());
  }
}

void erase(Bytes& chains, Dice& dice)
{
  const std::size_t from = dice.below(chains.size());
  const std::size_t count = std::min(chains.size() - from, 1 + dice.below(6));
  chains.erase(
    chains.begin() + std::ptrdiff_t(from), chains.begin() + std::ptrdiff_t(from + count));
}

} // namespace

void moveChains(FuzzCase& mutated, Dice& dice)
{
  Bytes& chains = mutated.chains;
  switch (dice.below(chains.empty() ? 4 : 10))
  {
    case 0:
      addChain(mutated, dice);
      break;
    case 1:
      addSegmentThrough(mutated, dice);
      break;
    case 2:
      addCross(mutated, dice);
      break;
    case 3:
      addNest(mutated, dice);
      break;
    case 4:
      repeat(chains, dice);
      break;
    case 5:
      erase(chains, dice);
      break;
    case 6:
      chains[dice.below(chains.size())] = dice.below(2) == 0 ? kNewLine : kNewLoop;
      break;
    case 7: // of no length
      chains.insert(chains.begin() + std::ptrdiff_t(dice.below(chains.size())), chains.back());
      break;
    default:
      chains[dice.below(chains.size())] = someId(mutated, dice);
  }
  chains.resize(std::min(chains.size(), kMostChainBytes));
}

} // namespace fuzz
} // namespace ahd
