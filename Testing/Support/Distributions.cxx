// SPDX-License-Identifier: BSD-3-Clause
#include "Distributions.h"

#include <cmath>
#include <cstring>

namespace ahd
{
namespace test
{

std::uint64_t Random::bits()
{
  std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

double Random::unit()
{
  return double(bits() >> 11) * 0x1p-53;
}

std::size_t Random::below(std::size_t n)
{
  return std::size_t(bits() % n);
}

double Random::bell()
{
  double sum = -6.0;
  for (int i = 0; i < 12; ++i)
  {
    sum += unit();
  }
  return sum;
}

namespace
{

constexpr double kPi = 3.14159265358979323846;
constexpr double kBand = 0.01;

/// sin(a) for |a| <= pi / 4 by its series: the library's own sine differs between platforms.
double sineSeries(double a)
{
  const double b = -a * a;
  double sum = 0.0;
  for (int k = 19; k > 1; k -= 2)
  {
    sum = (sum + 1.0) * b / double(k * (k - 1));
  }
  return a * (sum + 1.0);
}

double cosineSeries(double a)
{
  const double b = -a * a;
  double sum = 0.0;
  for (int k = 20; k > 1; k -= 2)
  {
    sum = (sum + 1.0) * b / double(k * (k - 1));
  }
  return sum + 1.0;
}

/// The point of the unit circle after `turns` turns (0 to 1) from (1, 0).
Point direction(double turns)
{
  const int eighth = int(turns * 8.0);
  const int quarter = ((eighth + 1) / 2) % 4;
  const double a = (turns - double((eighth + 1) / 2) * 0.25) * (2.0 * kPi);
  const double c = cosineSeries(a);
  const double s = sineSeries(a);
  switch (quarter)
  {
    case 0:
      return { c, s };
    case 1:
      return { -s, c };
    case 2:
      return { -c, -s };
    default:
      return { s, -c };
  }
}

Point onRay(double turns, double radius)
{
  const Point d = direction(turns);
  return { 0.5 + radius * d.x, 0.5 + radius * d.y };
}

Point uniform(Random& random)
{
  const double x = random.unit();
  return { x, random.unit() };
}

Point line(Random& random)
{
  const double along = random.unit();
  return { along, along + kBand * random.bell() };
}

Point cross(Random& random)
{
  const Point p = line(random);
  return (random.bits() >> 63) != 0 ? p : Point{ p.x, 1.0 - p.y };
}

Point circle(Random& random)
{
  const double turns = random.unit();
  return onRay(turns, 0.4 + kBand * random.bell());
}

Point spiral(Random& random)
{
  const double turns = 3.0 * std::sqrt(random.unit());
  const double radius = 0.15 * turns + kBand * random.bell();
  return onRay(turns - std::floor(turns), radius);
}

/// Place k of a fixed random set of places.
Point place(std::uint64_t set, std::uint64_t k)
{
  Random random(set ^ (0x5851F42D4C957F2Dull * (k + 1)));
  return uniform(random);
}

Point mixed(Random& random, std::uint64_t seed)
{
  if ((random.bits() >> 63) != 0)
  {
    return uniform(random);
  }
  const Point c = place(seed, random.below(20));
  const double dx = kBand * random.bell();
  return { c.x + dx, c.y + kBand * random.bell() };
}

Point kuzminDisc(Random& random)
{
  const double m = 1.0 - random.unit();
  const double radius = std::sqrt(1.0 / (m * m) - 1.0);
  const Point d = direction(random.unit());
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
    const Point c = place(seed, path);
    p.x += width * c.x;
    p.y += width * c.y;
    width /= 64.0;
  }
  const Point q = uniform(random);
  return { p.x + width * q.x, p.y + width * q.y };
}

Point crowdedBox(Random& random, std::size_t i)
{
  const Point q = uniform(random);
  const double width = 1.0 / 31623.0;
  return i % 10 == 0 ? q : Point{ (12345.0 + q.x) * width, (23456.0 + q.y) * width };
}

Point onLattice(std::size_t i, std::size_t side)
{
  return { double(i % side), double(i / side) };
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
  const Point q = uniform(random);
  const double east = 50000000.0 + std::floor(q.x * 200000.0);
  const double north = 450000000.0 + std::floor(q.y * 200000.0);
  return { east / 100.0, north / 100.0 };
}

Point onUtmRaster(std::size_t i, std::size_t side)
{
  const Point p = onLattice(i, side);
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
    case Distribution::Line:
      return line(random);
    case Distribution::Cross:
      return cross(random);
    case Distribution::Circle:
      return circle(random);
    case Distribution::Spiral:
      return spiral(random);
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
    case Distribution::TinyAndHuge:
      return extreme(random, true, true);
    default:
      return uniform(random);
  }
}

struct Maker
{
  Distribution d;
  std::uint64_t seed;
  std::size_t side;
  Random random;

  Point make(std::size_t i)
  {
    switch (d)
    {
      case Distribution::Mixed:
        return mixed(random, seed);
      case Distribution::NestedClusters:
        return nestedClusters(random, seed);
      case Distribution::CrowdedBox:
        return crowdedBox(random, i);
      case Distribution::Lattice:
        return onLattice(i, side);
      case Distribution::DecimalLattice:
        return { double(i % side) * 0.1, double(i / side) * 0.1 };
      case Distribution::UtmRaster:
        return onUtmRaster(i, side);
      case Distribution::OnCircle:
        return direction(random.unit());
      case Distribution::OnParabola:
      {
        const double x = 2.0 * random.unit() - 1.0;
        return { x, x * x };
      }
      case Distribution::AllEqual:
        return { 0.1, -0.7 };
      case Distribution::RepeatedDraws:
        return place(seed, random.below(1000));
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
  std::size_t side = std::size_t(std::sqrt(double(n)));
  side += side * side < n ? 1 : 0;
  Maker maker{ d, seed, side, Random(seed) };
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
