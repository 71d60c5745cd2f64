// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleJudge.h"

#include "ExactSigns.h"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace ahd
{
namespace test
{
namespace
{

constexpr std::int32_t kNoPlace = -1;
using Triangle = std::array<std::int32_t, 3>; ///< three places

bool samePlace(const Point& p, const Point& q)
{
  return p.x == q.x && p.y == q.y;
}

/// A sum of areas of parallelograms, exact whatever the exponents.
class AreaSum
{
public:
  /// Adds `times` (1 or more, negative too) the cross product of p and q.
  void add(const Point& p, const Point& q, int times)
  {
    addProduct(p.x, q.y, times);
    addProduct(p.y, q.x, -times);
  }

  /// The sum, as an integer in units of 2^exponent.
  mpz_class inUnitsOf(int exponent) const
  {
    mpz_class total = 0;
    for (const auto& sum : sums_)
    {
      total += sum.second << static_cast<unsigned>(sum.first - exponent);
    }
    return total;
  }

  int smallestExponent() const { return sums_.empty() ? 0 : sums_.begin()->first; }

private:
  void addProduct(double a, double b, int times)
  {
    int ea = 0;
    int eb = 0;
    const double fa = std::ldexp(std::frexp(a, &ea), 53);
    const double fb = std::ldexp(std::frexp(b, &eb), 53);
    if (fa == 0.0 || fb == 0.0)
    {
      return;
    }
    left_ = static_cast<long>(fa);
    right_ = static_cast<long>(fb);
    left_ *= times;
    mpz_addmul(sums_[ea + eb].get_mpz_t(), left_.get_mpz_t(), right_.get_mpz_t());
  }

  std::map<int, mpz_class> sums_; ///< by exponent
  mpz_class left_, right_;
};

/// The distinct points in lexicographic order, and which of them each point is.
class Places
{
public:
  explicit Places(const std::vector<Point>& points)
    : placeOf_(points.size())
  {
    std::vector<std::pair<Point, std::size_t>> sorted(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      sorted[i] = { points[i], i };
    }
    std::sort(sorted.begin(), sorted.end(),
      [](const auto& a, const auto& b) { return lexicographicallyLess(a.first, b.first); });
    for (const auto& entry : sorted)
    {
      if (all.empty() || !samePlace(all.back(), entry.first))
      {
        all.push_back(entry.first);
      }
      placeOf_[entry.second] = static_cast<std::int32_t>(all.size() - 1);
    }
  }

  std::int32_t ofPoint(std::int32_t id) const
  {
    const bool isPoint = id >= 0 && static_cast<std::size_t>(id) < placeOf_.size();
    return isPoint ? placeOf_[static_cast<std::size_t>(id)] : kNoPlace;
  }

  std::int32_t find(const Point& p) const
  {
    const auto found = std::lower_bound(all.begin(), all.end(), p, lexicographicallyLess);
    return found != all.end() && samePlace(*found, p)
      ? static_cast<std::int32_t>(found - all.begin())
      : kNoPlace;
  }

  const Point& operator[](std::int32_t place) const { return all[static_cast<std::size_t>(place)]; }

  std::vector<Point> all;

private:
  std::vector<std::int32_t> placeOf_;
};

/// The places on the boundary of the convex hull, counterclockwise, those on its edges too. All
/// places if they are collinear, there and back.
std::vector<Point> hullOf(const std::vector<Point>& sorted)
{
  std::vector<Point> hull;
  const auto pass = [&](auto first, auto last)
  {
    const std::size_t start = hull.size();
    for (auto p = first; p != last; ++p)
    {
      while (hull.size() >= start + 2 && orientSign(hull[hull.size() - 2], hull.back(), *p) < 0)
      {
        hull.pop_back();
      }
      hull.push_back(*p);
    }
    hull.pop_back(); // the other pass begins with it
  };
  if (sorted.size() < 2)
  {
    return sorted;
  }
  pass(sorted.begin(), sorted.end());
  pass(sorted.rbegin(), sorted.rend());
  return hull;
}

/// One side of an edge, kept with its smaller place.
struct Side
{
  std::int32_t other; ///< the larger place
  std::uint32_t slot; ///< 3 t + k: from corner k of triangle t to the next
};

class Judge
{
public:
  explicit Judge(const Places& places)
    : places_(places)
    , used_(places.all.size(), 0)
  {
    verdict.places = places.all.size();
  }

  /// Takes a triangle, turned counterclockwise, unless it is none.
  void take(Triangle triangle)
  {
    ++verdict.triangles;
    for (const std::int32_t corner : triangle)
    {
      if (corner != kNoPlace)
      {
        used_[static_cast<std::size_t>(corner)] = 1;
      }
    }
    if (std::count(triangle.begin(), triangle.end(), kNoPlace) != 0)
    {
      ++verdict.invented;
      return;
    }
    const int sign = orientSign(places_[triangle[0]], places_[triangle[1]], places_[triangle[2]]);
    if (sign == 0)
    {
      ++verdict.degenerate;
      return;
    }
    if (sign < 0)
    {
      ++verdict.clockwise;
      std::swap(triangle[1], triangle[2]);
    }
    triangles_.push_back(triangle);
  }

  void finish()
  {
    verdict.lost = static_cast<std::size_t>(std::count(used_.begin(), used_.end(), 0));
    gatherSides();
    for (std::size_t place = 0; place + 1 < first_.size(); ++place)
    {
      judgeEdgesOf(place);
    }
    judgeHull();
  }

  Verdict verdict;

private:
  std::int32_t cornerOf(std::uint32_t slot, unsigned ahead) const
  {
    return triangles_[slot / 3][(slot % 3 + ahead) % 3];
  }

  /// The sides of all edges by their smaller place: those of place p from first_[p] on.
  void gatherSides()
  {
    const auto forEach = [&](auto visit)
    {
      for (std::uint32_t slot = 0; slot < 3 * triangles_.size(); ++slot)
      {
        const std::int32_t from = cornerOf(slot, 0);
        const std::int32_t to = cornerOf(slot, 1);
        visit(static_cast<std::size_t>(std::min(from, to)), Side{ std::max(from, to), slot });
      }
    };
    first_.assign(places_.all.size() + 1, 0);
    forEach([&](std::size_t place, const Side&) { ++first_[place + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i)
    {
      first_[i] += first_[i - 1];
    }
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    sides_.resize(first_.back());
    forEach([&](std::size_t place, const Side& side) { sides_[next[place]++] = side; });
  }

  void judgeEdgesOf(std::size_t place)
  {
    const auto begin = sides_.begin() + static_cast<std::ptrdiff_t>(first_[place]);
    const auto end = sides_.begin() + static_cast<std::ptrdiff_t>(first_[place + 1]);
    std::sort(begin, end, [](const Side& a, const Side& b) { return a.other < b.other; });
    for (auto side = begin; side != end;)
    {
      const auto after = std::find_if(
        side, end, [&](const Side& s) { return s.other != side->other; });
      judgeEdge(static_cast<std::int32_t>(place), &*side, static_cast<std::size_t>(after - side));
      side = after;
    }
  }

  /// An edge of which `count` sides are used, from `side` on.
  void judgeEdge(std::int32_t place, const Side* side, std::size_t count)
  {
    const auto leaves = [&](const Side& s) { return cornerOf(s.slot, 0) == place; };
    const auto away = static_cast<std::size_t>(std::count_if(side, side + count, leaves));
    const std::size_t back = count - away;
    verdict.overlaps += (away > 1 ? away - 1 : 0) + (back > 1 ? back - 1 : 0);
    verdict.border += away == 0 || back == 0 ? 1 : 0;
    if (away != back)
    {
      const int times = static_cast<int>(away) - static_cast<int>(back);
      covered_.add(places_[place], places_[side->other], times);
    }
    if (away == 1 && back == 1)
    {
      const Point& opposite = places_[cornerOf(side[1].slot, 2)];
      const int sign = inCircleSign(places_[cornerOf(side[0].slot, 0)],
        places_[cornerOf(side[0].slot, 1)], places_[cornerOf(side[0].slot, 2)], opposite);
      verdict.notDelaunay += sign > 0 ? 1 : 0;
    }
  }

  void judgeHull()
  {
    const std::vector<Point> hull = hullOf(places_.all);
    AreaSum whole;
    for (std::size_t i = 0; i < hull.size(); ++i)
    {
      whole.add(hull[i], hull[i + 1 == hull.size() ? 0 : i + 1], 1);
    }
    const int exponent = std::min(whole.smallestExponent(), covered_.smallestExponent());
    const mpz_class wholeArea = whole.inUnitsOf(exponent);
    const mpz_class coveredArea = covered_.inUnitsOf(exponent);
    verdict.hullComplete = wholeArea == coveredArea;
    verdict.areaShare = wholeArea == 0 ? 1.0 : mpq_class(coveredArea, wholeArea).get_d();
    verdict.expected = wholeArea == 0 ? 0 : 2 * places_.all.size() - 2 - hull.size();
  }

  const Places& places_;
  std::vector<char> used_; ///< by place
  std::vector<Triangle> triangles_;
  std::vector<std::size_t> first_;
  std::vector<Side> sides_;
  AreaSum covered_;
};

template <typename PlaceOf>
Verdict judgeBy(const std::vector<Point>& points, const Places& places,
  const std::vector<std::int32_t>& triples, PlaceOf placeOf)
{
  Judge judge(places);
  judge.verdict.points = points.size();
  for (std::size_t i = 0; i + 2 < triples.size(); i += 3)
  {
    judge.take({ placeOf(triples[i]), placeOf(triples[i + 1]), placeOf(triples[i + 2]) });
  }
  judge.finish();
  return judge.verdict;
}

} // namespace

bool Verdict::isRight() const
{
  const bool oneWay = clockwise == 0 || clockwise == triangles;
  return lost == 0 && invented == 0 && degenerate == 0 && oneWay && overlaps == 0 &&
    notDelaunay == 0 && hullComplete && triangles == expected;
}

std::string Verdict::json() const
{
  std::string text = "{";
  const auto add = [&](const char* name, std::size_t value)
  { text += std::string("\"") + name + "\": " + std::to_string(value) + ", "; };
  add("points", points);
  add("places", places);
  add("triangles", triangles);
  add("expected", expected);
  add("lost", lost);
  add("invented", invented);
  add("degenerate", degenerate);
  add("clockwise", clockwise);
  add("overlaps", overlaps);
  add("notDelaunay", notDelaunay);
  add("border", border);
  char share[40];
  std::snprintf(share, sizeof share, "%.9g", areaShare);
  text += std::string("\"hullComplete\": ") + (hullComplete ? "true" : "false");
  text += std::string(", \"areaShare\": ") + share;
  return text + ", \"right\": " + (isRight() ? "true" : "false") + "}";
}

Verdict judge(const std::vector<Point>& points, const std::vector<std::int32_t>& triples)
{
  const Places places(points);
  return judgeBy(points, places, triples, [&](std::int32_t id) { return places.ofPoint(id); });
}

Verdict judge(const std::vector<Point>& points, const std::vector<Point>& vertices,
  const std::vector<std::int32_t>& triples)
{
  const Places places(points);
  std::vector<std::int32_t> placeOf;
  for (const Point& vertex : vertices)
  {
    placeOf.push_back(places.find(vertex));
  }
  return judgeBy(points, places, triples,
    [&](std::int32_t id)
    {
      const bool isVertex = id >= 0 && static_cast<std::size_t>(id) < placeOf.size();
      return isVertex ? placeOf[static_cast<std::size_t>(id)] : kNoPlace;
    });
}

} // namespace test
} // namespace ahd
