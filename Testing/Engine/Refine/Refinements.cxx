// SPDX-License-Identifier: BSD-3-Clause
//
// refine() against its contract: the result is the fresh triangulation of its points and pieces,
// what is not bad meets the request, and none of it depends on the order of the input.
#include "Hash.h"
#include "RefineCase.h"
#include "Shores.h"

#include <gtest/gtest.h>

#include <memory>

namespace ahd
{
namespace test
{
namespace
{

/// Points and loops, drawn one after the other.
struct Drawing
{
  std::vector<Point> points;
  std::vector<Chain> lines, loops;

  void add(const std::vector<Point>& corners, bool isLoop)
  {
    Chain chain;
    for (const Point& p : corners)
    {
      chain.push_back(std::int64_t(points.size()));
      points.push_back(p);
    }
    (isLoop ? loops : lines).push_back(chain);
  }
  void addSquare(double x, double y, double side)
  {
    add({ { x, y }, { x + side, y }, { x + side, y + side }, { x, y + side } }, true);
  }
  ConstraintCase made() const
  {
    ConstraintCase made;
    made.points = points;
    ConstraintSet& set = made.constraints;
    for (const Chain& chain : lines)
    {
      set.addLine(chain);
    }
    for (const Chain& chain : loops)
    {
      set.addLoop(chain);
    }
    return made;
  }
  /// Moved and scaled; places that become one are one point.
  Drawing at(double scale, double x, double y) const
  {
    Drawing moved = *this;
    for (Point& p : moved.points)
    {
      p = { p.x * scale + x, p.y * scale + y };
    }
    return moved;
  }
};

/// Squares in squares: inside, hole, inside.
Drawing nested()
{
  Drawing drawing;
  drawing.addSquare(0.0, 0.0, 16.0);
  drawing.addSquare(1.0, 1.0, 13.0);
  drawing.addSquare(4.0, 3.0, 5.0);
  drawing.addSquare(5.0, 4.0, 0.125);
  return drawing;
}

/// Segments from one point, a degree apart, in a box.
Drawing fan()
{
  Drawing drawing;
  drawing.addSquare(-1.0, -1.0, 3.0);
  drawing.points.push_back({ 0.0, 0.0 });
  for (int k = 0; k <= 30; ++k)
  {
    const double angle = k * 0.0175, length = 1.0 + 0.1 * (k % 3);
    drawing.points.push_back({ length * std::cos(angle), length * std::sin(angle) });
    drawing.lines.push_back({ 4, 5 + k });
  }
  return drawing;
}

/// Two segments so near each other that the least distance is a thousandth of their length.
Drawing slit()
{
  Drawing drawing;
  drawing.addSquare(0.0, 0.0, 10.0);
  drawing.add({ { 1.0, 5.0 }, { 9.0, 5.0 } }, false);
  drawing.add({ { 1.0, 5.02 }, { 9.0, 5.01 } }, false);
  return drawing;
}

/// An island with a lake, and points in it.
Drawing island(int depth, std::size_t points)
{
  std::mt19937_64 random(5);
  Drawing drawing;
  const Point corners[] = { { 8.0, 0.0 }, { 0.0, 6.0 }, { -7.0, 0.0 }, { 0.0, -6.0 } };
  for (const double scale : { 1.0, 0.3 })
  {
    std::vector<Point> shore;
    for (std::size_t c = 0; c < 4; ++c)
    {
      const Point &a = corners[c], &b = corners[(c + 1) % 4];
      addFractal(shore, { scale * a.x, scale * a.y }, { scale * b.x, scale * b.y }, depth, random);
    }
    drawing.add(shore, true);
  }
  for (const Point& p : makePoints(Distribution::Uniform, points, 3))
  {
    drawing.points.push_back({ p.x * 10.0 - 5.0, p.y * 10.0 - 5.0 });
  }
  return drawing;
}

TEST(Refinements, MeetTheRequest)
{
  for (const Drawing& drawing : { nested(), island(6, 100), fan(), slit() })
  {
    for (const double angle : { 0.0, 20.0, 28.0, 33.0 })
    {
      RefineCase given(drawing.made());
      given.request.minimumAngle = angle;
      EXPECT_EQ(given.faults(), "") << angle;
      EXPECT_EQ(given.count(RefineReason::Resolution), 0u) << angle;
      EXPECT_EQ(given.count(RefineReason::Budget), 0u);
      EXPECT_EQ(given.made.encroachedPieces, 0u);
      EXPECT_GE(given.made.triangles, given.givenTriangles());
    }
  }
}

/// Where all input angles are wide, no triangle is bad.
TEST(Refinements, LeaveNothingBadWithoutSmallAngles)
{
  RefineCase given(nested().made());
  given.request.minimumAngle = RefineRequest::kLargestAngle;
  EXPECT_EQ(given.faults(), "");
  EXPECT_TRUE(given.made.bad.empty());
  RefineCase sharp(fan().made());
  EXPECT_EQ(sharp.faults(), "");
  EXPECT_EQ(sharp.count(RefineReason::InputAngle), sharp.made.bad.size());
  EXPECT_GE(sharp.made.bad.size(), 30u);
  EXPECT_LE(sharp.made.bad.size(), 300u);
  EXPECT_LE(sharp.made.points.size(), 1000u);
}

TEST(Refinements, AreFine)
{
  for (const Drawing& drawing : { nested(), island(4, 50), fan() })
  {
    RefineCase area(drawing.made());
    area.request.maximumArea = 0.05;
    EXPECT_EQ(area.faults(), "");
    RefineCase length(drawing.made());
    length.request.maximumLength = 0.4;
    length.request.minimumAngle = 25.0;
    EXPECT_EQ(length.faults(), "");
    EXPECT_EQ(length.count(RefineReason::Resolution), 0u);
    EXPECT_GT(length.made.triangles, 2u * drawing.points.size());
  }
}

/// A size at each point, small at some.
TEST(Refinements, FollowSizes)
{
  const Drawing drawing = island(4, 200);
  std::vector<double> sizes;
  for (const Point& p : drawing.points)
  {
    sizes.push_back(p.x > 0.0 ? 0.2 + 0.2 * p.x : 0.2 - p.x);
  }
  RefineCase given(drawing.made());
  given.request.sizes = sizes.data();
  EXPECT_EQ(given.faults(), "");
  EXPECT_EQ(given.count(RefineReason::Resolution), 0u);
  RefineCase without(drawing.made());
  EXPECT_EQ(without.faults(), "");
  EXPECT_GT(given.made.points.size(), 2 * without.made.points.size());
}

/// Lines and loops that touch, repeat each other, pass through points, name duplicates: of those
/// that cross, the first.
TEST(Refinements, OfAnyConstraints)
{
  std::size_t refined = 0, bad = 0;
  for (std::uint64_t seed = 1; seed <= reduced(600); ++seed)
  {
    RefineCase given(
      smallConstraintCase(seed), seed % 2 == 0 ? FillRule::EvenOdd : FillRule::Orientation);
    given.request.minimumAngle = double(seed % 3) * 13.0;
    given.request.mostSteinerPoints = 500;
    ASSERT_EQ(given.run(), Status::Ok);
    if (given.made.fault == RefineFault::None)
    {
      ASSERT_EQ(given.faults(), "") << "seed " << seed;
      refined += given.made.points.empty() ? 0 : 1;
      bad += given.made.bad.empty() ? 0 : 1;
    }
    else
    {
      EXPECT_EQ(given.made.fault, RefineFault::Range);
    }
  }
  EXPECT_GT(refined, reduced(120));
  EXPECT_GT(bad, reduced(20));
}

TEST(Refinements, OfLargerOnes)
{
  for (const ConstraintCase& from :
    { starPolygon(40), shortSegments(300, 100), edgesOfOthers(300, 200), randomSegments(100, 60) })
  {
    RefineCase given(from);
    given.request.minimumAngle = 30.0;
    given.request.mostSteinerPoints = 30000;
    EXPECT_EQ(given.faults(), "");
    EXPECT_GT(given.made.points.size(), 0u);
  }
}

// --- Canonical ---

using Places = std::vector<std::pair<double, double>>;

Places placesOf(const Refinement& made)
{
  Places places;
  for (const SteinerPoint& p : made.points)
  {
    places.push_back({ p.x, p.y });
  }
  return places;
}

/// The chains as places, which are the same whatever the ids.
Places chainsOf(const RefineCase& given)
{
  Places places;
  for (const std::int64_t id : given.made.ids)
  {
    places.push_back({ given.place(std::size_t(id)).x, given.place(std::size_t(id)).y });
  }
  return places;
}

TEST(Refinements, AreTheSameInAnyOrder)
{
  for (const Drawing& drawing : { nested(), island(5, 300), fan(), slit() })
  {
    const ConstraintCase original = drawing.made();
    RefineCase first(original);
    first.request.minimumAngle = 30.0;
    ASSERT_EQ(first.run(), Status::Ok);
    for (std::uint64_t seed = 1; seed <= 6; ++seed)
    {
      RefineCase other(shuffledCase(original, seed));
      other.request = first.request;
      ASSERT_EQ(other.run(), Status::Ok);
      EXPECT_TRUE(placesOf(other.made) == placesOf(first.made)) << seed;
      EXPECT_TRUE(chainsOf(other) == chainsOf(first)) << seed;
      EXPECT_EQ(other.made.offsets, first.made.offsets);
      EXPECT_EQ(other.made.bad.size(), first.made.bad.size());
    }
  }
}

/// Which points they are: pieces before triangles, short before long, then by places.
TEST(Refinements, AreThese)
{
  struct Row
  {
    Drawing drawing;
    RefineRequest request;
    std::size_t points;
    const char* hash;
  };
  const Row rows[] = {
    { nested(), { 30.0, 0.0, 0.0, nullptr, 100000 }, 90, "b491e9f625cdb5f4" },
    { island(5, 100), { 33.0, 0.0, 0.0, nullptr, 100000 }, 548, "f7a7a4bd2b2424cb" },
    { island(3, 100), { 20.0, 0.02, 0.5, nullptr, 100000 }, 3015, "73394c3a53174f99" },
    { slit(), { 25.0, 0.0, 0.0, nullptr, 100000 }, 2186, "f23311d6d8dd54ff" },
  };
  for (const Row& row : rows)
  {
    RefineCase given(row.drawing.made());
    given.request = row.request;
    ASSERT_EQ(given.run(), Status::Ok);
    Hash hash;
    for (const SteinerPoint& p : given.made.points)
    {
      hash.add(Point{ p.x, p.y });
      for (const double weight : p.weights)
      {
        hash.add(weight);
      }
    }
    EXPECT_EQ(given.made.points.size(), row.points);
    EXPECT_EQ(hash.text(), row.hash);
  }
}

/// Times a power of two, all is.
TEST(Refinements, AreTheSameInAnyUnit)
{
  const Drawing drawing = island(4, 50);
  RefineCase first(drawing.made());
  ASSERT_EQ(first.run(), Status::Ok);
  for (const int power : { -900, -300, -1, 5, 600, 890 })
  {
    const double scale = std::ldexp(1.0, power);
    const Drawing scaled = drawing.at(scale, 0.0, 0.0);
    RefineCase given(scaled.made());
    ASSERT_EQ(given.run(), Status::Ok);
    Places places = placesOf(first.made);
    for (auto& p : places)
    {
      p = { p.first * scale, p.second * scale };
    }
    EXPECT_EQ(given.made.fault, RefineFault::None) << power;
    EXPECT_TRUE(placesOf(given.made) == places) << power;
  }
}

/// The first so many of the same points, and what is not done is said.
TEST(Refinements, StopAtTheBudget)
{
  const Drawing drawing = island(5, 100);
  RefineCase whole(drawing.made());
  ASSERT_EQ(whole.faults(), "");
  const Places all = placesOf(whole.made);
  for (const std::size_t most : { std::size_t(0), std::size_t(1), std::size_t(57), all.size() })
  {
    RefineCase given(drawing.made());
    given.request.mostSteinerPoints = most;
    EXPECT_EQ(given.faults(), "") << most;
    EXPECT_TRUE(placesOf(given.made) == Places(all.begin(), all.begin() + std::ptrdiff_t(most)));
    EXPECT_EQ(given.count(RefineReason::Budget) > 0, most < all.size());
  }
}

// --- Where numbers end ---

TEST(Refinements, EndFarFromTheOrigin)
{
  std::size_t beyond = 0;
  for (const Drawing& drawing : { fan(), slit(), nested(), island(3, 20) })
  {
    for (const double far : { 1e8, 1e11, 1e12, 1e13, 1e14, 1e15, 1e17 })
    {
      const Drawing moved = drawing.at(1.0, far, 0.7 * far);
      RefineCase given(moved.made());
      given.request.minimumAngle = 25.0;
      EXPECT_EQ(given.faults(), "") << far;
      EXPECT_LT(given.made.points.size(), 20000u) << far;
      EXPECT_EQ(given.count(RefineReason::Budget), 0u);
      const std::size_t left = given.count(RefineReason::Resolution);
      EXPECT_TRUE(left == 0 || far > 1e10) << far;
      beyond += left;
    }
  }
  EXPECT_GT(beyond, 500u);
}

/// Where squares of areas, or of lengths, in units of the mesh are no numbers above 0.
TEST(Refinements, NameBadTrianglesOfAnySize)
{
  for (const int power : { -150, -300, -500 })
  {
    Drawing drawing = fan().at(std::ldexp(1.0, power), 0.0, 0.0);
    drawing.addSquare(-0x1p400, -0x1p400, 0x1p401);
    drawing.addSquare(-0x1p399, -0x1p399, 0x1p400); // a hole, around the fan
    RefineCase given(drawing.made());
    given.request.mostSteinerPoints = 100;
    EXPECT_EQ(given.faults(), "") << power;
    EXPECT_GT(given.made.bad.size(), 30u) << power;
  }
}

TEST(Refinements, OfFewPoints)
{
  for (const std::vector<Point>& points :
    { std::vector<Point>(), std::vector<Point>{ { 1.0, 2.0 } },
      std::vector<Point>{ { 1.0, 2.0 }, { 1.0, 2.0 }, { 3.0, 4.0 } },
      std::vector<Point>{ { 0.0, 0.0 }, { 1.0, 1.0 }, { 2.0, 2.0 }, { 4.0, 4.0 } } })
  {
    ConstraintCase none;
    none.points = points;
    RefineCase given(none);
    ASSERT_EQ(given.run(), Status::Ok);
    EXPECT_TRUE(given.made.points.empty());
    EXPECT_EQ(given.made.triangles, 0u);
    EXPECT_EQ(given.made.constraints().chains, 0u);
  }
}

TEST(Refinements, OfDuplicatesAndPointsThatAreNone)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Drawing drawing = nested();
  const std::vector<Point> once = drawing.points;
  std::vector<Point>& points = drawing.points;
  points.insert(points.end(), once.begin(), once.end());
  points.push_back({ nan, 1.0 });
  points.push_back({ -0.0, 0.0 });
  RefineCase with(drawing.made());
  std::vector<double> sizes(points.size(), 3.0);
  sizes[points.size() - 2] = nan; // of the point that is none
  with.request.sizes = sizes.data();
  ASSERT_EQ(with.run(), Status::Ok);
  RefineCase without(nested().made());
  without.request.maximumLength = 3.0;
  ASSERT_EQ(without.run(), Status::Ok);
  EXPECT_GT(without.made.points.size(), 50u);
  EXPECT_TRUE(placesOf(with.made) == placesOf(without.made));
}

// --- Refused ---

TEST(Refinements, RefuseWhatIsNoRequest)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const Drawing drawing = nested();
  RefineCase given(drawing.made());
  const auto expect = [&](const RefineRequest& request, RefineFault fault, std::size_t at)
  {
    given.request = request;
    EXPECT_EQ(given.run(), Status::Ok);
    EXPECT_EQ(given.made.fault, fault);
    EXPECT_EQ(given.made.faultAt, at);
    EXPECT_TRUE(given.made.points.empty());
  };
  for (const double angle : { -1.0, 34.0001, nan })
  {
    expect({ angle, 0.0, 0.0, nullptr, 5 }, RefineFault::Angle, 0);
  }
  for (const double limit : { -1.0, nan, infinite })
  {
    expect({ 20.0, limit, 0.0, nullptr, 5 }, RefineFault::Area, 0);
    expect({ 20.0, 0.0, limit, nullptr, 5 }, RefineFault::Length, 0);
  }
  for (const double size : { 0.0, -1.0, nan, infinite })
  {
    std::vector<double> sizes(drawing.points.size(), 1.0);
    sizes[7] = sizes[9] = size;
    expect({ 20.0, 0.0, 0.0, sizes.data(), 5 }, RefineFault::Size, 7);
  }
  const Drawing large = drawing.at(0x1p897, 0.0, 0.0);
  RefineCase beyond(large.made());
  EXPECT_EQ(beyond.run(), Status::Ok);
  EXPECT_EQ(beyond.made.fault, RefineFault::Range);
  EXPECT_EQ(beyond.made.faultAt, 1u);
}

} // namespace
} // namespace test
} // namespace ahd
