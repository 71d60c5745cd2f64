// SPDX-License-Identifier: BSD-3-Clause
//
// Constraints split where they cross: nothing crosses any more, every crossing has its point, the
// chains are what they were but for it.
#include "Crossings.h"

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

/// Are the added points new, distinct, and where they say on two segments?
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

TEST(Split, NothingToSplit)
{
  SplitConstraints split;
  EXPECT_EQ(splitAtCrossings(PointView(), ConstraintView(), nullptr, split), Status::Ok);
  EXPECT_EQ(split.view().chains, 0u);
  Drawing drawing;
  drawing.points = { { 0, 0 }, { 2, 2 }, { 0, 2 }, { 1, 1 } };
  drawing.lines = { {}, { 0 }, { 0, 1 }, {}, { 2, 3 }, { 3, 3 }, {} };
  drawing.loops = { {}, { 1 }, { 0, 1 }, { 0, 1, 2 }, { 0, 1, 2, 0 }, {} };
  split = splitOf(drawing);
  EXPECT_EQ(split.ids, Chains(drawing).ids);
  EXPECT_EQ(split.offsets, Chains(drawing).offsets);
  EXPECT_EQ(split.lines, 7u);
  EXPECT_EQ(split.rounds, 0);
  EXPECT_EQ(split.crossings, 0u);
  EXPECT_EQ(faultsOf(drawing, split), "");
}

TEST(Split, TwoSegmentsAndTheirFractions)
{
  Drawing drawing;
  drawing.points = { { 0, 0 }, { 4, 4 }, { 0, 2 }, { 8, -2 } };
  drawing.lines = { { 0, 1 } };
  drawing.loops = { { 3, 2 } };
  const SplitConstraints split = splitOf(drawing);
  EXPECT_EQ(split.ids, (Ids{ 0, 4, 1, 3, 4, 2, 4 })) << "the loop is back and forth";
  EXPECT_EQ(split.offsets, (Ids{ 0, 3, 7 }));
  EXPECT_EQ(split.segments, (Ids{ 0, 0, 0, 0, 0, 1, 1 }));
  ASSERT_EQ(split.points.size(), 1u);
  EXPECT_EQ(split.points[0].at, (Point{ 4.0 / 3, 4.0 / 3 }));
  EXPECT_EQ(split.points[0].chainA, 0u);
  EXPECT_EQ(split.points[0].segmentA, 0u);
  EXPECT_DOUBLE_EQ(split.points[0].alongA, 1.0 / 3);
  EXPECT_EQ(split.points[0].chainB, 1u);
  EXPECT_EQ(split.points[0].segmentB, 0u);
  EXPECT_DOUBLE_EQ(split.points[0].alongB, 5.0 / 6);
  EXPECT_EQ(split.crossings, 2u);
  EXPECT_EQ(split.rounds, 1);
}

TEST(Split, APointAtTheCrossingIsUsed)
{
  Drawing drawing;
  drawing.points = { { 0, 0 }, { 2, 2 }, { 0, 2 }, { 2, 0 }, { 1, 1 }, { 1, 1 }, { 1, 9 } };
  drawing.lines = { { 0, 1 }, { 2, 3 } };
  SplitConstraints split = splitOf(drawing);
  EXPECT_EQ(split.ids, (Ids{ 0, 4, 1, 2, 4, 3 })) << "the one of smallest id";
  EXPECT_TRUE(split.points.empty());
  EXPECT_EQ(split.crossings, 1u);
  drawing.lines.push_back({ 5, 6 });
  split = splitOf(drawing);
  EXPECT_EQ(split.ids, (Ids{ 0, 5, 1, 2, 5, 3, 5, 6 })) << "one that is an end";
  drawing.lines.push_back({ 4, 6 });
  split = splitOf(drawing);
  EXPECT_EQ(split.ids, (Ids{ 0, 4, 1, 2, 4, 3, 5, 6, 4, 6 })) << "of two ends the first";
  drawing.skip = { 0, 0, 0, 0, 1, 1, 0 };
  split = splitOf(drawing);
  EXPECT_EQ(split.ids, (Ids{ 0, 7, 1, 2, 7, 3, 5, 6, 4, 6 })) << "those left out are no points";
}

TEST(Split, IdsOfNoPointDoNotBecomeThoseOfAddedOnes)
{
  Drawing drawing;
  drawing.points = { { 0, 0 }, { 2, 2 }, { 0, 2 }, { 2, 0 } };
  drawing.lines = { { 0, 1, 4, 1 }, { 2, 3, -7 } };
  EXPECT_EQ(splitOf(drawing).ids, (Ids{ 0, 4, 1, -1, 1, 2, 4, 3, -1 }));
}

TEST(Split, OnePointForAllThatCrossThere)
{
  Drawing drawing;
  for (int i = -5; i <= 5; ++i)
  {
    for (int k = -5; k <= 5; ++k)
    {
      if (i != 0 || k != 0)
      {
        drawing.addSegment({ 0.25 + i, 0.5 + k }, { 0.25 - i, 0.5 - k });
      }
    }
  }
  const SplitConstraints split = splitOf(drawing);
  ASSERT_EQ(split.points.size(), 1u);
  EXPECT_EQ(split.points[0].at, (Point{ 0.25, 0.5 }));
  EXPECT_EQ(faultsOf(drawing, split), "");
}

TEST(Split, RandomChainsOnSmallLattices)
{
  Random random(1);
  std::size_t crossings = 0;
  for (std::size_t round = 0; round < reduced(4000); ++round)
  {
    Drawing drawing;
    const std::size_t width = 3 + random.below(8), height = 2 + random.below(8);
    for (std::size_t i = 0; i < 30; ++i)
    {
      drawing.points.push_back({ double(random.below(width)), double(random.below(height)) });
    }
    drawing.points.push_back({ std::numeric_limits<double>::quiet_NaN(), 1.0 });
    drawing.skip.assign(drawing.points.size(), 0);
    drawing.skip[7] = 1;
    for (std::size_t chain = 1 + random.below(5); chain != 0; --chain)
    {
      Ids ids;
      for (std::size_t i = random.below(7); i != 0; --i)
      {
        ids.push_back(
          std::int64_t(random.below(drawing.points.size() + 2)) - 1); // -1 to one too many
      }
      (random.below(2) == 0 ? drawing.lines : drawing.loops).push_back(ids);
    }
    crossings += expectSplit(drawing, random);
    ASSERT_FALSE(HasFailure()) << "round " << round;
  }
  EXPECT_GT(crossings, reduced(4000));
}

TEST(Split, RandomSegmentsOfEveryDistribution)
{
  Random random(2);
  for (const Distribution distribution : allDistributions())
  {
    SCOPED_TRACE(nameOf(distribution));
    for (std::uint64_t seed = 0; seed < 8; ++seed)
    {
      Drawing drawing;
      drawing.points = makePoints(distribution, 30, seed);
      drawing.lines.resize(3);
      drawing.loops.resize(2);
      for (std::size_t i = 0; i < drawing.points.size(); ++i)
      {
        (i % 5 < 3 ? drawing.lines[i % 5] : drawing.loops[i % 5 - 3]).push_back(std::int64_t(i));
      }
      expectSplit(drawing, random);
    }
  }
}

TEST(Split, SegmentsThatAreNearlyOne)
{
  // They cross at angles of a few units in the last place, so that pieces bent by rounding cross
  // others.
  Random random(3);
  std::size_t crossings = 0, inLaterRounds = 0;
  for (std::size_t round = 0; round < reduced(500); ++round)
  {
    Drawing drawing;
    const double unit = std::ldexp(1.0, -int(40 + random.below(13)));
    const auto near = [&](double value) { return value + unit * double(random.below(9)); };
    for (int k = 0; k < 12; ++k)
    {
      drawing.addSegment({ near(1.0), near(1.0) }, { near(1.75), near(1.5) });
    }
    crossings += expectSplit(drawing, random);
    inLaterRounds += splitOf(drawing).rounds > 1;
    ASSERT_FALSE(HasFailure()) << "round " << round;
  }
  EXPECT_GT(crossings, reduced(2000));
  EXPECT_GT(inLaterRounds, reduced(500) / 20) << "the drawings no longer do what they are made for";
}

/// What is left to split in a large drawing: nothing.
void expectNothingCrosses(const Drawing& drawing, const SplitConstraints& split)
{
  EXPECT_EQ(split.unresolved, 0u);
  const std::vector<Point> points = allPoints(drawing, split);
  SplitConstraints again;
  EXPECT_EQ(splitAtCrossings(viewOf(points), split.view(), nullptr, again), Status::Ok);
  EXPECT_EQ(again.crossings, 0u);
  EXPECT_EQ(again.ids, split.ids);
  EXPECT_EQ(faultsOfChains(drawing, split), "");
}

TEST(Split, GridOfCrossingLines)
{
  for (const auto& [n, tilt] :
    { std::pair(100, 0.0), std::pair(int(std::sqrt(double(reduced(90000)))), 0.1) })
  {
    Drawing drawing;
    for (int i = 0; i < n; ++i)
    {
      drawing.addSegment({ i - tilt, -1.0 }, { i + tilt, double(n) });
      drawing.addSegment({ -1.5, i + tilt }, { n + 0.5, i - tilt });
    }
    const SplitConstraints split = splitOf(drawing);
    EXPECT_GE(split.points.size(), std::size_t(n * n) * 98 / 100); // some lie beyond an end
    EXPECT_EQ(split.crossings, split.points.size());
    expectNothingCrosses(drawing, split);
  }
}

TEST(Split, StarOfLinesThroughAlmostOnePoint)
{
  const int n = 200;
  Random random(4);
  for (const double blur : { 0.0, 1e-16, 1e-13 })
  {
    Drawing drawing;
    for (int i = 0; i < n; ++i)
    {
      const double angle = 3.14159265358979 * i / n;
      const double x = std::cos(angle), y = std::sin(angle);
      const double dx = blur * random.unit(), dy = blur * random.unit();
      drawing.addSegment({ 0.3 + x + dx, 0.7 + y + dy }, { 0.3 - x + dx, 0.7 - y + dy });
    }
    const SplitConstraints split = splitOf(drawing);
    EXPECT_GT(split.crossings, 15000u);
    expectNothingCrosses(drawing, split);
  }
}

/// Counts the askings, which grow with the work, and cancels at one of them if so told.
class Counter : public Progress
{
public:
  explicit Counter(std::size_t cancelAt = 0)
    : cancelAt_(cancelAt)
  {
  }
  void beginPhase(Phase phase) override { EXPECT_EQ(phase, Phase::Split); }
  bool advance(Phase, double fraction) override
  {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    return ++askings_ != cancelAt_;
  }
  std::size_t askings() const { return askings_; }

private:
  std::size_t cancelAt_;
  std::size_t askings_ = 0;
};

/// The steps it takes to split it, at most.
std::size_t stepsFor(const Drawing& drawing, std::size_t crossings)
{
  SplitConstraints split;
  Counter counter;
  EXPECT_EQ(splitAtCrossings(drawing.view(), Chains(drawing).view(), &counter, split), Status::Ok);
  EXPECT_EQ(split.crossings, crossings);
  expectNothingCrosses(drawing, split);
  return counter.askings() * kStepsPerAsking;
}

// What would be the square of 10^5 otherwise is a small multiple of n log n here.

TEST(Split, LongSegmentAmongManyShortOnes)
{
  const std::size_t n = reduced(100000);
  Random random(5);
  Drawing drawing;
  for (std::size_t i = 0; i < n; ++i)
  {
    // In boxes of their own of a lattice; the diagonals cross nothing but the long one.
    const double x = double(i % 300), y = double(i / 300);
    drawing.addSegment({ x, y }, { x + 0.5 * random.unit(), y + 0.5 * random.unit() });
  }
  drawing.addSegment({ -1.0, -0.875 }, { 301.0, -0.75 });
  EXPECT_LE(stepsFor(drawing, 0), 1000 * n);
  // Straight up through a column of horizontal ones.
  Drawing column;
  for (std::size_t i = 0; i < n / 2; ++i)
  {
    column.addSegment({ 400.0, double(i) }, { 401.0, double(i) });
  }
  column.addSegment({ 400.5, -1.0 }, { 400.5, double(n) });
  EXPECT_LE(stepsFor(column, n / 2), 1000 * n);
}

TEST(Split, ManyLongParallelSegments)
{
  for (const auto& [n, slope] : { std::pair(reduced(20000), 0.0), std::pair(reduced(100000), 0.7) })
  {
    Drawing drawing;
    for (std::size_t i = 0; i < n; ++i)
    {
      const double y = double(i) / double(n);
      drawing.addSegment({ 0.0, y }, { 1e3, y + slope * 1e3 });
    }
    drawing.addSegment({ 0.0, 0.5 }, { 1e3, 0.5 + slope * 1e3 - 10.0 / double(n) });
    EXPECT_LE(stepsFor(drawing, 9), 1000 * n);
  }
}

TEST(Split, ManySegmentsWithOneCommonEnd)
{
  const std::size_t n = reduced(50000);
  Random random(6);
  Drawing drawing;
  drawing.points.push_back({ 0, 0 });
  for (std::size_t i = 0; i < n; ++i)
  {
    drawing.points.push_back({ random.unit() - 0.5, random.unit() - 0.5 });
    drawing.lines.push_back({ 0, std::int64_t(i) + 1 });
  }
  EXPECT_LE(stepsFor(drawing, 0), 1000 * n);
}

TEST(Split, CancelledAtAnyAsking)
{
  Random random(7);
  Drawing drawing;
  for (int i = 0; i < 200; ++i)
  {
    drawing.addSegment({ random.unit(), random.unit() }, { random.unit(), random.unit() });
  }
  const Chains chains(drawing);
  SplitConstraints split;
  Counter whole;
  ASSERT_EQ(splitAtCrossings(drawing.view(), chains.view(), &whole, split), Status::Ok);
  ASSERT_GE(whole.askings(), 20u);
  for (std::size_t k = 1; k <= whole.askings(); k += 1 + whole.askings() / 15)
  {
    Counter counter(k);
    EXPECT_EQ(splitAtCrossings(drawing.view(), chains.view(), &counter, split), Status::Cancelled);
    EXPECT_EQ(counter.askings(), k);
  }
}

TEST(Split, TooManyPointsAreRefusedUnread)
{
  const double one[] = { 0, 0 };
  SplitConstraints split;
  EXPECT_EQ(
    splitAtCrossings(PointView(one, kMaximumPoints + 1, 2), ConstraintView(), nullptr, split),
    Status::TooManyPoints);
}

} // namespace
} // namespace test
} // namespace ahd
