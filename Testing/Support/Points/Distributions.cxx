// SPDX-License-Identifier: BSD-3-Clause
#include "Distributions.h"

#include <cmath>
#include <cstring>

namespace ahd
{
namespace test
{

namespace
{

/// Distributions of vtkPlanarPointSource are made by its makers, Filters/Distributions.
Point at(const Place& p)
{
  return { p.x, p.y };
}

Point kuzminDisc(Random& random)
{
  const double m = 1.0 - random.unit();
  const double radius = std::sqrt(1.0 / (m * m) - 1.0);
  const Place d = onUnitCircle(random.unit());
  return { radius * d.x, radius * d.y };
}

Point nestedClusters(Random& random, std::uint64_t seed)
{
  double width = 1.0;
  Point p{ 0.0, 0.0 };
  std::uint64_t path = 0;
  for (int depth = 0; depth < 6; ++depth)
  {
    path = path * 8 + random.below(8) + 1;
    const Place c = placeOfSet(seed, path);
    p.x += width * c.x;
    p.y += width * c.y;
    width /= 64.0;
  }
  const Place q = inUnitSquare(random);
  return { p.x + width * q.x, p.y + width * q.y };
}

Point crowdedBox(Random& random, std::size_t i)
{
  const Place q = inUnitSquare(random);
  const double width = 1.0 / 31623.0;
  return i % 10 == 0 ? at(q) : Point{ (12345.0 + q.x) * width, (23456.0 + q.y) * width };
}

/// Exactly on the circle of radius 1105 * 29 about the origin. 1105 * 29 = 5 * 13 * 17 * 29 is the
/// norm of a Gaussian integer; the points are products of conjugate pairs of its prime factors.
Point onIntegerCircle(Random& random)
{
  static const long kPrimes[4][2] = { { 2, 1 }, { 3, 2 }, { 4, 1 }, { 5, 2 } };
  long re = 1, im = 0;
  for (const auto& prime : kPrimes)
  {
    const std::size_t conjugated = random.below(3); // of the two factors of this prime
    for (std::size_t k = 0; k < 2; ++k)
    {
      const long a = prime[0];
      const long b = k < conjugated ? -prime[1] : prime[1];
      const long next = re * a - im * b;
      im = re * b + im * a;
      re = next;
    }
  }
  for (std::size_t turn = random.below(4); turn > 0; --turn)
  {
    const long next = -im;
    im = re;
    re = next;
  }
  return { double(re), double(im) };
}

Point collinear(Random& random)
{
  const double x = std::floor(random.unit() * 0x1p40);
  return { x, 2.0 * x };
}

Point utm(Random& random)
{
  const Place q = inUnitSquare(random);
  const double east = 50000000.0 + std::floor(q.x * 200000.0);
  const double north = 450000000.0 + std::floor(q.y * 200000.0);
  return { east / 100.0, north / 100.0 };
}

Point onUtmRaster(std::size_t i, std::size_t side)
{
  const Place p = onLattice(i, side);
  return { (50000000.0 + 25.0 * p.x) / 100.0, (450000000.0 + 25.0 * p.y) / 100.0 };
}

Point nearlyCollinear(Random& random)
{
  const double x = random.unit();
  return { x, x / 3.0 };
}

Point slivers(Random& random)
{
  const double x = random.unit();
  return { x, x + 1e-12 * random.unit() };
}

double ofMagnitude(Random& random, double magnitude)
{
  return magnitude * (2.0 * random.unit() - 1.0);
}

Point extreme(Random& random, bool tiny, bool huge)
{
  double c[2];
  for (double& v : c)
  {
    const bool small = huge ? tiny && (random.bits() >> 63) != 0 : true;
    v = ofMagnitude(random, small ? 1e-300 : 1e300);
  }
  return { c[0], c[1] };
}

double anyFinite(Random& random)
{
  for (;;)
  {
    const std::uint64_t bits = random.bits();
    double v;
    std::memcpy(&v, &bits, sizeof v);
    if (std::isfinite(v))
    {
      return v;
    }
  }
}

Point independentPoint(Distribution d, Random& random)
{
  switch (d)
  {
    case Distribution::KuzminDisc:
      return kuzminDisc(random);
    case Distribution::OnIntegerCircle:
      return onIntegerCircle(random);
    case Distribution::Collinear:
      return collinear(random);
    case Distribution::NearlyCollinear:
      return nearlyCollinear(random);
    case Distribution::Utm:
      return utm(random);
    case Distribution::Slivers:
      return slivers(random);
    case Distribution::Tiny:
      return extreme(random, true, false);
    case Distribution::Huge:
      return extreme(random, false, true);
    default: // TinyAndHuge
      return extreme(random, true, true);
  }
}

static_assert(int(Distribution::Mixed) == int(PlanarDistribution::Mixed),
  "the paper's distributions have the same numbers here and there");

/// The distribution of the source that equals `d`; undefined if there is none.
PlanarDistribution planar(Distribution d)
{
  return d == Distribution::Lattice ? PlanarDistribution::Lattice
    : d <= Distribution::Mixed      ? PlanarDistribution(d)
                                    : PlanarDistribution::Uniform;
}

struct Maker
{
  Distribution d;
  std::uint64_t seed;
  std::size_t side;
  Random random;
  PlanarPoints source;

  Point make(std::size_t i)
  {
    switch (d)
    {
      case Distribution::Uniform:
      case Distribution::Line:
      case Distribution::Cross:
      case Distribution::Circle:
      case Distribution::Spiral:
      case Distribution::Mixed:
      case Distribution::Lattice:
        return at(source.next());
      case Distribution::NestedClusters:
        return nestedClusters(random, seed);
      case Distribution::CrowdedBox:
        return crowdedBox(random, i);
      case Distribution::DecimalLattice:
        return { double(i % side) * 0.1, double(i / side) * 0.1 };
      case Distribution::UtmRaster:
        return onUtmRaster(i, side);
      case Distribution::OnCircle:
        return at(onUnitCircle(random.unit()));
      case Distribution::OnParabola:
      {
        const double x = 2.0 * random.unit() - 1.0;
        return { x, x * x };
      }
      case Distribution::AllEqual:
        return { 0.1, -0.7 };
      case Distribution::RepeatedDraws:
        return at(placeOfSet(seed, random.below(1000)));
      case Distribution::AnyFinite:
      {
        const double x = anyFinite(random);
        return { x, anyFinite(random) };
      }
      default:
        return independentPoint(d, random);
    }
  }
};

struct Named
{
  Distribution d;
  const char* name;
};

constexpr Named kNamed[] = {
  { Distribution::Uniform, "Uniform" },
  { Distribution::Line, "Line" },
  { Distribution::Cross, "Cross" },
  { Distribution::Circle, "Circle" },
  { Distribution::Spiral, "Spiral" },
  { Distribution::Mixed, "Mixed" },
  { Distribution::KuzminDisc, "KuzminDisc" },
  { Distribution::NestedClusters, "NestedClusters" },
  { Distribution::CrowdedBox, "CrowdedBox" },
  { Distribution::Lattice, "Lattice" },
  { Distribution::DecimalLattice, "DecimalLattice" },
  { Distribution::OnCircle, "OnCircle" },
  { Distribution::OnIntegerCircle, "OnIntegerCircle" },
  { Distribution::OnParabola, "OnParabola" },
  { Distribution::Collinear, "Collinear" },
  { Distribution::NearlyCollinear, "NearlyCollinear" },
  { Distribution::AllEqual, "AllEqual" },
  { Distribution::RepeatedDraws, "RepeatedDraws" },
  { Distribution::Utm, "Utm" },
  { Distribution::UtmRaster, "UtmRaster" },
  { Distribution::Slivers, "Slivers" },
  { Distribution::Tiny, "Tiny" },
  { Distribution::Huge, "Huge" },
  { Distribution::TinyAndHuge, "TinyAndHuge" },
  { Distribution::AnyFinite, "AnyFinite" },
};

std::vector<Distribution> firstOf(std::size_t n)
{
  std::vector<Distribution> list;
  for (std::size_t i = 0; i < n; ++i)
  {
    list.push_back(kNamed[i].d);
  }
  return list;
}

} // namespace

std::vector<ahd::Point> makePoints(Distribution d, std::size_t n, std::uint64_t seed)
{
  Maker maker{ d, seed, latticeSide(n), Random(seed), PlanarPoints(planar(d), n, seed) };
  std::vector<Point> points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    points.push_back(maker.make(i));
  }
  return points;
}

const char* nameOf(Distribution d)
{
  for (const Named& n : kNamed)
  {
    if (n.d == d)
    {
      return n.name;
    }
  }
  return "?";
}

const std::vector<Distribution>& allDistributions()
{
  static const std::vector<Distribution> list = firstOf(sizeof kNamed / sizeof kNamed[0]);
  return list;
}

const std::vector<Distribution>& paperDistributions()
{
  static const std::vector<Distribution> list = firstOf(6);
  return list;
}

} // namespace test
} // namespace ahd
