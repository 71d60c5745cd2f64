// SPDX-License-Identifier: BSD-3-Clause
#include "Footprint.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ahd
{
namespace
{

/// The part of 2^bits equal ones in which a number lies, from -reach to reach.
std::size_t partOf(double number, double reach, int bits)
{
  const double parts = double(std::size_t(1) << bits);
  const double at = (number / reach + 1.0) / 2.0 * parts;
  return static_cast<std::size_t>(std::min(std::max(at, 0.0), parts - 1.0));
}

/// With cells that have so many bits less.
CellLevels merged(const CellLevels& levels, int bitsAcross, int lessAlong, int lessAcross)
{
  CellLevels larger;
  for (std::size_t cell = 0; cell < levels.count.size(); ++cell)
  {
    const std::size_t along = cell >> bitsAcross;
    const std::size_t across = cell - (along << bitsAcross);
    const std::size_t to = (along >> lessAlong << (bitsAcross - lessAcross)) +
      (across >> lessAcross);
    larger.count[to] += levels.count[cell];
    larger.sum[to] += levels.sum[cell];
    larger.squares[to] += levels.squares[cell];
  }
  return larger;
}

double total(const std::array<std::uint64_t, std::size_t(1) << Footprint::kBits>& numbers)
{
  return double(std::accumulate(numbers.begin(), numbers.end(), std::uint64_t(0)));
}

/// How many points have others in their cell.
double sharing(const CellLevels& levels)
{
  return total(levels.count) -
    double(std::count(levels.count.begin(), levels.count.end(), std::uint64_t(1)));
}

/// The sum of squared distances from the mean.
double squaresAround(double count, double sum, double squares)
{
  return count > 0.0 ? squares - sum * (sum / count) : 0.0;
}

/// Do few cells hold most points? Less than four do if all points are spread over them evenly.
bool isCluster(const CellLevels& levels)
{
  double squares = 0.0;
  for (const std::uint64_t count : levels.count)
  {
    squares += double(count) * double(count);
  }
  const double all = total(levels.count);
  return 4.0 * squares > all * all;
}

} // namespace

int Footprint::bitsAcross() const
{
  int bits = 0;
  while (bits < kBits / 2 && std::ldexp(width, kBits - 2 * bits - 2) >= length)
  {
    ++bits;
  }
  return bits;
}

std::size_t Footprint::cell(const Vector3& d, int bitsAcross) const
{
  const std::size_t row = partOf(dot(d, along), 2.0 * length, kBits - bitsAcross);
  return (row << bitsAcross) +
    (bitsAcross > 0 ? partOf(dot(d, across), 2.0 * width, bitsAcross) : 0);
}

std::uint64_t Footprint::level(const Vector3& d) const
{
  return partOf(d[2], 4.0 * height, 16);
}

void CellLevels::add(std::size_t cell, std::uint64_t level)
{
  ++count[cell];
  sum[cell] += level;
  squares[cell] += level * level;
}

void CellLevels::merge(const CellLevels& other)
{
  for (std::size_t cell = 0; cell < count.size(); ++cell)
  {
    count[cell] += other.count[cell];
    sum[cell] += other.sum[cell];
    squares[cell] += other.squares[cell];
  }
}

double spreadWithin(CellLevels levels, int bitsAcross)
{
  const double count = total(levels.count);
  const double all = squaresAround(count, total(levels.sum), total(levels.squares));
  if (!(all > 0.0))
  {
    return 0.0;
  }
  while (2.0 * sharing(levels) < count)
  {
    const int less = std::min(bitsAcross, 1);
    levels = merged(levels, bitsAcross, 1, less);
    bitsAcross -= less;
  }
  double within = 0.0, free = 0.0;
  for (std::size_t cell = 0; cell < levels.count.size(); ++cell)
  {
    const double own = double(levels.count[cell]);
    within += squaresAround(own, double(levels.sum[cell]), double(levels.squares[cell]));
    free += own > 0.0 ? own - 1.0 : 0.0;
  }
  return within / free / (all / (count - 1.0));
}

Stance stanceOf(
  const Footprint& footprint, const CellLevels& levels, double upright, double flatness)
{
  constexpr double kVerySteep = 0.17364817766693035; // the sine of ten degrees
  const bool isLine = footprint.width == 0.0;
  const bool isNarrow = 4.0 * footprint.width < footprint.length;
  const int bits = footprint.bitsAcross();
  const bool isFunction = spreadWithin(levels, bits) <= 0.25;
  const bool isProfile = spreadWithin(merged(levels, bits, 0, bits), 0) <= 0.25;
  const bool isTall = footprint.height > 16.0 * footprint.length;
  Stance stance;
  stance.isWall = upright < Stance::kSteep && isNarrow && !isFunction && 2.0 * flatness < 1.0 &&
    !isTall && (isLine || !isCluster(levels));
  stance.isSteep = upright < kVerySteep && !stance.isWall && !isLine &&
    (isTall || (isNarrow ? isProfile : isFunction));
  return stance;
}

} // namespace ahd
