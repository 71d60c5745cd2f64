// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SplitDrawings_h
#define ahd_SplitDrawings_h

// Drawings of points and chains for the tests of splitting, and the checks of results.
#include "Crossings/Crossings.h"

#include "Distributions.h"
#include "EngineRun.h"
#include "ExactSigns.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace ahd
{
namespace test
{
namespace
{

using Ids = std::vector<std::int64_t>;

/// Points, and chains of them.
struct Drawing
{
  std::vector<Point> points;
  std::vector<unsigned char> skip; ///< empty: none
  std::vector<Ids> lines;
  std::vector<Ids> loops;

  PointView view() const
  {
    PointView result = viewOf(points);
    result.skip = skip.empty() ? nullptr : skip.data();
    return result;
  }

  void addSegment(const Point& a, const Point& b)
  {
    const auto id = std::int64_t(points.size());
    points.insert(points.end(), { a, b });
    lines.push_back({ id, id + 1 });
  }
};

/// The chains of a drawing as the engine takes them.
struct Chains
{
  explicit Chains(const Drawing& drawing)
    : lines(drawing.lines.size())
  {
    for (const std::vector<Ids>* chains : { &drawing.lines, &drawing.loops })
    {
      for (const Ids& chain : *chains)
      {
        ids.insert(ids.end(), chain.begin(), chain.end());
        offsets.push_back(std::int64_t(ids.size()));
      }
    }
  }
  ConstraintView view() const
  {
    ConstraintView result;
    result.ids = ids.data();
    result.offsets = offsets.data();
    result.chains = offsets.size() - 1;
    result.lines = lines;
    return result;
  }

  Ids ids;
  Ids offsets{ 0 };
  std::size_t lines;
};

SplitConstraints splitOf(const Drawing& drawing)
{
  SplitConstraints split;
  EXPECT_EQ(splitAtCrossings(drawing.view(), Chains(drawing).view(), nullptr, split), Status::Ok);
  return split;
}

/// The points, those added included.
std::vector<Point> allPoints(const Drawing& drawing, const SplitConstraints& split)
{
  std::vector<Point> points = drawing.points;
  for (const CrossingPoint& p : split.points)
  {
    points.push_back(p.at);
  }
  return points;
}

using Ends = std::array<Point, 2>;

bool isBelow(const Ends& a, const Ends& b)
{
  return a[0] == b[0] ? lexicographicallyLess(a[1], b[1]) : lexicographicallyLess(a[0], b[0]);
}

/// The segments of chains with ends that are points, whichever way they run; each once.
std::vector<Ends> segmentsOf(const std::vector<Point>& points,
  const std::vector<unsigned char>& skip, const ConstraintView& chains)
{
  std::vector<Ends> result;
  const auto isPoint = [&](std::int64_t id)
  {
    return id >= 0 && std::size_t(id) < points.size() && isFinite(points[std::size_t(id)]) &&
      (std::size_t(id) >= skip.size() || skip[std::size_t(id)] == 0);
  };
  for (std::size_t chain = 0; chain < chains.chains; ++chain)
  {
    const std::int64_t begin = chains.offsets[chain], end = chains.offsets[chain + 1];
    for (std::int64_t k = begin; k < (chain < chains.lines ? end - 1 : end); ++k)
    {
      const std::int64_t a = chains.ids[k], b = chains.ids[k + 1 == end ? begin : k + 1];
      if (isPoint(a) && isPoint(b))
      {
        Ends ends = { points[std::size_t(a)], points[std::size_t(b)] };
        if (lexicographicallyLess(ends[1], ends[0]))
        {
          std::swap(ends[0], ends[1]);
        }
        if (!(ends[0] == ends[1]))
        {
          result.push_back(ends);
        }
      }
    }
  }
  std::sort(result.begin(), result.end(), isBelow);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<Ends> segmentsOf(const Drawing& drawing, const SplitConstraints& split)
{
  return segmentsOf(allPoints(drawing, split), drawing.skip, split.view());
}

bool cross(const Ends& s, const Ends& t)
{
  return orientSign(s[0], s[1], t[0]) * orientSign(s[0], s[1], t[1]) < 0 &&
    orientSign(t[0], t[1], s[0]) * orientSign(t[0], t[1], s[1]) < 0;
}

std::string textOf(const Ends& s)
{
  return hexText(s[0]) + " to " + hexText(s[1]);
}

std::string textOf(const Drawing& drawing)
{
  const Chains chains(drawing);
  std::string text;
  for (const Ends& s : segmentsOf(drawing.points, drawing.skip, chains.view()))
  {
    text += textOf(s) + "\n";
  }
  return text;
}

double largestCoordinate(const std::vector<Point>& points)
{
  double largest = 0.0;
  for (const Point& p : points)
  {
    largest = isFinite(p) ? std::max({ largest, std::fabs(p.x), std::fabs(p.y) }) : largest;
  }
  return largest;
}

/// Is p in the box of a, b, and within four units from their line, measured along an axis?
bool isNearSegment(const Point& p, const Point& a, const Point& b, const mpq_class& unit)
{
  const mpq_class dx = mpq_class(b.x) - mpq_class(a.x), dy = mpq_class(b.y) - mpq_class(a.y);
  const mpq_class px = mpq_class(p.x) - mpq_class(a.x), py = mpq_class(p.y) - mpq_class(a.y);
  const mpq_class off = abs(mpq_class(dx * py - dy * px));
  const mpq_class longer = std::max(mpq_class(abs(dx)), mpq_class(abs(dy)));
  const auto isBetween = [](double value, double end1, double end2)
  { return std::min(end1, end2) <= value && value <= std::max(end1, end2); };
  return off <= 4 * unit * longer && isBetween(p.x, a.x, b.x) && isBetween(p.y, a.y, b.y);
}

/// Are the chains of the split the given ones but for points that lie on their segments?
std::string faultsOfChains(const Drawing& drawing, const SplitConstraints& split)
{
  const Chains given(drawing);
  const std::vector<Point> points = allPoints(drawing, split);
  const double largest = largestCoordinate(drawing.points);
  const mpq_class unit = mpq_class(
                           std::nextafter(largest, std::numeric_limits<double>::infinity())) -
    mpq_class(largest);
  const ConstraintView chains = split.view();
  if (chains.chains != given.view().chains || chains.lines != given.lines)
  {
    return "not as many chains\n";
  }
  if (split.segments.size() != split.ids.size())
  {
    return "not a segment for each id\n";
  }
  std::string faults;
  std::vector<bool> isUsed(split.points.size());
  for (std::size_t chain = 0; chain < chains.chains; ++chain)
  {
    const std::int64_t begin = given.offsets[chain], end = given.offsets[chain + 1];
    std::int64_t k = begin - 1; // the given point that came last
    for (std::int64_t i = chains.offsets[chain]; i != chains.offsets[chain + 1]; ++i)
    {
      const std::int64_t id = chains.ids[i], segment = split.segments[std::size_t(i)];
      const bool isLastOfLine = chain < chains.lines && k + 2 == end && end - begin > 1;
      const std::int64_t nextGiven = k + 1 < end ? given.ids[std::size_t(k + 1)] : 0;
      const bool isPoint = nextGiven >= 0 && nextGiven < std::int64_t(drawing.points.size());
      if (k + 1 < end && id == (isPoint ? nextGiven : -1) &&
        (segment == k + 1 - begin || (isLastOfLine && segment == k - begin)))
      {
        ++k;
        continue;
      }
      const std::string name = "chain " + std::to_string(chain) + ", place " +
        std::to_string(i - chains.offsets[chain]) + ": point " + std::to_string(id);
      if (k < begin || segment != k - begin)
      {
        faults += name + " belongs to segment " + std::to_string(segment) + "\n";
        continue;
      }
      const std::int64_t next = given.ids[std::size_t(k + 1 == end ? begin : k + 1)];
      const Point from = points[std::size_t(given.ids[std::size_t(k)])],
                  to = points[std::size_t(next)];
      if (!isNearSegment(points[std::size_t(id)], from, to, unit))
      {
        faults += name + " is not on its segment\n";
      }
      if (id >= std::int64_t(drawing.points.size()))
      {
        isUsed[std::size_t(id) - drawing.points.size()] = true;
      }
    }
    faults += k + 1 == end ? "" : "chain " + std::to_string(chain) + " has lost points\n";
  }
  for (std::size_t i = 0; i < isUsed.size(); ++i)
  {
    faults += isUsed[i] ? "" : "added point " + std::to_string(i) + " is in no chain\n";
  }
  return faults;
}

/// Are the added points new, distinct, and at their stated positions on two segments?
std::string faultsOfPoints(const Drawing& drawing, const SplitConstraints& split)
{
  std::string faults;
  const Chains given(drawing);
  std::vector<Point> places;
  for (std::size_t i = 0; i < drawing.points.size(); ++i)
  {
    if (!drawing.view().skipped(i) && isFinite(drawing.points[i]))
    {
      places.push_back(drawing.points[i]);
    }
  }
  std::sort(places.begin(), places.end(), lexicographicallyLess);
  for (const CrossingPoint& p : split.points)
  {
    const auto check = [&](std::size_t chain, std::size_t segment, double along)
    {
      const std::size_t begin = std::size_t(given.offsets[chain]), k = begin + segment;
      const std::size_t next = k + 1 == std::size_t(given.offsets[chain + 1]) ? begin : k + 1;
      const Point a = drawing.points[std::size_t(given.ids[k])];
      const Point b = drawing.points[std::size_t(given.ids[next])];
      // In halves, which do not overflow.
      const double x = 0.5 * a.x + along * (0.5 * b.x - 0.5 * a.x);
      const double y = 0.5 * a.y + along * (0.5 * b.y - 0.5 * a.y);
      const double largest = largestCoordinate({ a, b });
      if (!(along >= 0.0 && along <= 1.0 &&
            std::fabs(x - 0.5 * p.at.x) <= 1e-14 * largest + 1e-322 &&
            std::fabs(y - 0.5 * p.at.y) <= 1e-14 * largest + 1e-322))
      {
        faults += hexText(p.at) + " is not " + std::to_string(along) + " along " +
          textOf(Ends{ a, b }) + "\n";
      }
    };
    check(p.chainA, p.segmentA, p.alongA);
    check(p.chainB, p.segmentB, p.alongB);
    if (!(p.chainA < p.chainB || (p.chainA == p.chainB && p.segmentA < p.segmentB)))
    {
      faults += hexText(p.at) + ": its segments are not in order\n";
    }
    if (std::binary_search(places.begin(), places.end(), p.at, lexicographicallyLess))
    {
      faults += hexText(p.at) + " was there before, or was added twice\n";
    }
    places.insert(
      std::upper_bound(places.begin(), places.end(), p.at, lexicographicallyLess), p.at);
  }
  return faults;
}

/// The same, and by brute force: does nothing cross any more, and has everything that crossed a
/// point in common? Cost: the square of the number of segments.
std::string faultsOf(const Drawing& drawing, const SplitConstraints& split)
{
  std::string faults = faultsOfChains(drawing, split) + faultsOfPoints(drawing, split);
  const std::vector<Ends> pieces = segmentsOf(drawing, split);
  std::size_t crossings = 0;
  for (std::size_t a = 0; a < pieces.size(); ++a)
  {
    for (std::size_t b = a + 1; b < pieces.size(); ++b)
    {
      if (cross(pieces[a], pieces[b]))
      {
        ++crossings;
        faults += textOf(pieces[a]) + " still crosses " + textOf(pieces[b]) + "\n";
      }
    }
  }
  // Pieces may be there several times.
  faults += (split.unresolved != 0) == (crossings != 0) ? "" : "unresolved is wrong\n";
  return faults;
}

/// The same chains, each the other way round, in another order.
Drawing turned(const Drawing& drawing, Random& random)
{
  Drawing result = drawing;
  for (std::vector<Ids>* chains : { &result.lines, &result.loops })
  {
    for (std::size_t i = chains->size(); i > 1; --i)
    {
      std::swap((*chains)[i - 1], (*chains)[random.below(i)]);
    }
    for (Ids& chain : *chains)
    {
      if (random.below(3) != 0)
      {
        std::reverse(chain.begin(), chain.end());
      }
    }
  }
  return result;
}

/// Splits, checks by brute force, and turns it. Returns the number of crossings.
std::size_t expectSplit(const Drawing& drawing, Random& random)
{
  const SplitConstraints split = splitOf(drawing);
  EXPECT_EQ(split.unresolved, 0u) << textOf(drawing);
  EXPECT_EQ(faultsOf(drawing, split), "") << textOf(drawing);
  const Drawing other = turned(drawing, random);
  const SplitConstraints otherSplit = splitOf(other);
  EXPECT_EQ(segmentsOf(other, otherSplit), segmentsOf(drawing, split)) << textOf(drawing);
  EXPECT_EQ(otherSplit.points.size(), split.points.size());
  return split.crossings;
}

} // namespace
} // namespace test
} // namespace ahd

#endif
