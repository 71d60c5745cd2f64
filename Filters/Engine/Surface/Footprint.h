// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Footprint_h
#define ahd_Footprint_h

#include "Vectors.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace ahd
{

// Do points stand like a wall, so that x and y are no plane for their surface?

/// Where points lie in x, y, and how high. In one unit, from their mean; lengths are standard
/// deviations.
struct Footprint
{
  /// The footprint is divided into 2^kBits cells, squares as far as powers of two allow.
  static constexpr int kBits = 10;

  Vector3 along = { { 1, 0, 0 } }, across = { { 0, 1, 0 } };
  double length = 0.0, width = 0.0, height = 0.0; ///< width 0: it is a line, but for rounding

  /// How many of the bits are across.
  int bitsAcross() const;
  /// Of the point at `d` from the mean; those more than two deviations away are in the last cells.
  std::size_t cell(const Vector3& d, int bitsAcross) const;
  /// Its height in 2^-13 deviations, within four of them; from 0 on.
  std::uint64_t level(const Vector3& d) const;
};

/// Of the points of each cell: how many, and the sums of their levels and of the squares. Exact, so
/// neither order nor parts have a say.
struct CellLevels
{
  std::array<std::uint64_t, std::size_t(1) << Footprint::kBits> count = {}, sum = {}, squares = {};

  /// At most 2^28 points.
  void add(std::size_t cell, std::uint64_t level);
  void merge(const CellLevels& other);
};

/// The spread of heights within cells beside that of all, as variances: about 0 where z is a
/// function of x, y, and 1 where x and y say nothing about z. Of the smallest cells of which at
/// least half of the points share one.
double spreadWithin(CellLevels levels, int bitsAcross);

/// How points lie.
struct Stance
{
  /// Planes are steep whose normal points up less: those above 45 degrees.
  static constexpr double kSteep = 0.70710678118654752;

  /// Is their plane the fitted one rather than x, y? The plane is steeper than 45 degrees, and:
  /// - the footprint is a line, or narrower than a quarter of its length;
  /// - z is no function of x, y: within cells it spreads by more than a quarter of its variance;
  /// - they fit the plane: they are less than half as thick as the plane is wide;
  /// - they are no higher than 16 times the length. Degrees beside metres are higher.
  /// - Few cells do not hold most of the points, as of a cluster and points far away.
  bool isWall = false;
  /// Else: is the fitted plane steeper than 80 degrees, where x and y tell points apart? Then z is
  /// a function of them, in a narrow footprint of the place along it, or higher than 16 times the
  /// length. (Along a smooth wall that leans, z is a function of the place across alone.)
  bool isSteep = false;
};

/// `upright`: how far the plane's normal points up, from 0 to 1; `flatness`: the thickness of the
/// points beside the width of the plane, 1 for points on a line.
Stance stanceOf(
  const Footprint& footprint, const CellLevels& levels, double upright, double flatness);

} // namespace ahd

#endif
