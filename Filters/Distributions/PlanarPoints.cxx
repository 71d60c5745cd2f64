// SPDX-License-Identifier: BSD-3-Clause
#include "PlanarPoints.h"

#include <cmath>

namespace ahd
{

namespace
{

constexpr double kBand = 0.01; // deviation of bands and clusters
constexpr double kCircleRadius = 0.4;
constexpr double kSpiralTurns = 3.0;
constexpr double kSpiralPitch = 0.15; // from one turn to the next
constexpr std::size_t kClusters = 20;

/// One of two outcomes, equally likely.
bool toss(Random& random)
{
  return (random.bits() >> 63) != 0;
}

Place onRay(double turns, double radius)
{
  const Place d = onUnitCircle(turns);
  return { 0.5 + radius * d.x, 0.5 + radius * d.y };
}

Place line(Random& random)
{
  const double along = random.unit();
  return { along, along + kBand * random.bell() };
}

Place cross(Random& random)
{
  const Place p = line(random);
  return toss(random) ? p : Place{ p.x, 1.0 - p.y };
}

Place circle(Random& random)
{
  const double turns = random.unit();
  return onRay(turns, kCircleRadius + kBand * random.bell());
}

/// The root spreads the points evenly along the curve, whose length grows as the turns squared.
Place spiral(Random& random)
{
  const double turns = kSpiralTurns * std::sqrt(random.unit());
  const double radius = kSpiralPitch * turns + kBand * random.bell();
  return onRay(turns - std::floor(turns), radius);
}

Place mixed(Random& random, std::uint64_t seed)
{
  if (toss(random))
  {
    return inUnitSquare(random);
  }
  const Place c = placeOfSet(seed, random.below(kClusters));
  const double dx = kBand * random.bell();
  return { c.x + dx, c.y + kBand * random.bell() };
}

} // namespace

PlanarPoints::PlanarPoints(PlanarDistribution distribution, std::size_t count, std::uint64_t seed)
  : distribution_(distribution)
  , seed_(seed)
  , side_(latticeSide(count))
  , random_(seed)
{
}

double PlanarPoints::hillAt(const Place& p) const
{
  const double width = distribution_ == PlanarDistribution::Lattice ? double(side_) : 1.0;
  const double u = p.x / width, v = p.y / width;
  const auto at = [](double turns) { return onUnitCircle(turns - std::floor(turns)); };
  return width * (0.5 + 0.3 * (at(0.8 * u).y * at(0.65 * v).x) + 0.2 * at(1.3 * u - 0.9 * v).x);
}

Place PlanarPoints::next()
{
  const std::size_t i = made_++;
  switch (distribution_)
  {
    case PlanarDistribution::Line:
      return line(random_);
    case PlanarDistribution::Cross:
      return cross(random_);
    case PlanarDistribution::Circle:
      return circle(random_);
    case PlanarDistribution::Spiral:
      return spiral(random_);
    case PlanarDistribution::Mixed:
      return mixed(random_, seed_);
    case PlanarDistribution::Lattice:
      return onLattice(i, side_);
    default:
      return inUnitSquare(random_);
  }
}

} // namespace ahd
