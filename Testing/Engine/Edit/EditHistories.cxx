// SPDX-License-Identifier: BSD-3-Clause
//
// After any history the living triangles are those of a fresh run of what is left; and every
// request is accepted or refused as a fresh run has it.
#include "Distributions.h"
#include "EditCase.h"

#include <limits>
#include <set>

namespace ahd
{
namespace test
{
namespace
{

/// A history over some places, which come more than once.
class History
{
public:
  History(std::vector<Point> places, std::uint64_t seed)
    : places_(std::move(places))
    , random_(seed)
  {
    places_.push_back({ std::numeric_limits<double>::quiet_NaN(), 1.0 });
  }

  void step()
  {
    const std::size_t what = random_.below(100);
    what < 40     ? insert()
      : what < 62 ? remove()
      : what < 76 ? move()
      : what < 93 ? constrain()
                  : release();
  }

  void expectAsFresh()
  {
    const EditedInput input = inputOf(edit_);
    std::vector<Point> left;
    std::vector<std::int64_t> ids;
    for (std::size_t k = 0; k < points_.size(); ++k)
    {
      if (there_[k])
      {
        left.push_back(points_[k]);
        ids.push_back(std::int64_t(k));
      }
    }
    ASSERT_EQ(input.ids, ids);
    ASSERT_EQ(input.places.size(), left.size());
    EXPECT_TRUE(left.empty() ||
      std::memcmp(left.data(), input.places.data(), left.size() * sizeof(Point)) == 0);
    EXPECT_EQ(input.segments.size(), 2 * segments_.size());
    EXPECT_EQ(edit_.segmentCount(), segments_.size());
    EXPECT_EQ(edit_.pointCount(), ids.size());
    expectFresh(edit_);
    expectPlaces(input);
  }

  std::size_t count[9] = {}; ///< of each outcome

private:
  using Ends = std::pair<std::int64_t, std::int64_t>;

  const Point& anyPlace() { return places_[random_.below(places_.size())]; }
  /// Mostly that of a point.
  std::int64_t anyId()
  {
    std::size_t k = random_.below(points_.size() + 1);
    for (int tries = 0; tries < 3 && (k == points_.size() || !there_[k]); ++tries)
    {
      k = random_.below(points_.size() + 1);
    }
    return std::int64_t(k) - (random_.below(50) == 0 ? 1 : 0);
  }
  bool has(std::int64_t id) const
  {
    return id >= 0 && std::size_t(id) < points_.size() && there_[std::size_t(id)];
  }
  bool isEnd(std::int64_t id) const
  {
    return std::any_of(segments_.begin(), segments_.end(),
      [&](const Ends& s) { return s.first == id || s.second == id; });
  }
  const Point& at(std::int64_t id) const { return points_[std::size_t(id)]; }

  void insert()
  {
    const bool isBulk = random_.below(60) == 0;
    std::vector<Point> added(isBulk ? 260 : 1 + random_.below(3));
    for (Point& p : added)
    {
      p = anyPlace();
    }
    std::int64_t first = -1;
    ASSERT_EQ(edit_.insert(viewOf(added), Context(), first), Status::Ok);
    EXPECT_EQ(first, std::int64_t(points_.size()));
    points_.insert(points_.end(), added.begin(), added.end());
    there_.resize(points_.size(), true);
  }

  /// Do the segments cross without this point?
  bool crossWithout(std::int64_t id) const
  {
    EditedInput input = inputOf(edit_);
    const auto k = std::lower_bound(input.ids.begin(), input.ids.end(), id) - input.ids.begin();
    input.places[std::size_t(k)].x = std::numeric_limits<double>::quiet_NaN();
    return FreshRun(input).engine.constraints().crossing > 0;
  }

  void expectRemoval(std::int64_t id, EditOutcome outcome, bool crosses)
  {
    const EditOutcome expected = !has(id) ? EditOutcome::NoPoint
      : isEnd(id)                         ? EditOutcome::EndOfSegment
      : crosses                           ? EditOutcome::SegmentsMeet
                                          : EditOutcome::Done;
    EXPECT_EQ(outcome, expected) << id;
    ++count[int(outcome)];
  }

  void remove()
  {
    const std::int64_t id = anyId();
    const bool crosses = has(id) && crossWithout(id);
    const EditOutcome outcome = removeOne(edit_, id);
    expectRemoval(id, outcome, crosses);
    if (outcome == EditOutcome::Done)
    {
      there_[std::size_t(id)] = false;
    }
  }

  void move()
  {
    const std::int64_t id = anyId();
    const Point to = anyPlace();
    const bool crosses = has(id) && crossWithout(id);
    const EditOutcome outcome = moveOne(edit_, id, to);
    expectRemoval(id, outcome, crosses);
    if (outcome == EditOutcome::Done)
    {
      points_[std::size_t(id)] = to;
    }
  }

  /// Does it cross others?
  bool crosses(const Ends& ends) const
  {
    EditedInput input = inputOf(edit_);
    for (const std::int64_t id : { ends.first, ends.second })
    {
      input.segments.push_back(
        std::lower_bound(input.ids.begin(), input.ids.end(), id) - input.ids.begin());
    }
    input.offsets.push_back(std::int64_t(input.segments.size()));
    return FreshRun(input).engine.constraints().crossing > 0;
  }

  void constrain()
  {
    const Ends ends(anyId(), anyId());
    const bool areThere = has(ends.first) && has(ends.second);
    const EditOutcome expected = !areThere                      ? EditOutcome::NoPoint
      : !isFinite(at(ends.first)) || !isFinite(at(ends.second)) ? EditOutcome::NotFinite
      : at(ends.first) == at(ends.second)                       ? EditOutcome::NoLength
      : crosses(ends)                                           ? EditOutcome::Crosses
                                                                : EditOutcome::Done;
    const EditOutcome outcome = constrainOne(edit_, ends.first, ends.second);
    EXPECT_EQ(outcome, expected) << ends.first << " " << ends.second;
    ++count[int(outcome)];
    if (outcome == EditOutcome::Done)
    {
      segments_.insert(std::minmax(ends.first, ends.second));
    }
  }

  void release()
  {
    Ends ends(anyId(), anyId());
    if (!segments_.empty() && random_.below(5) != 0)
    {
      auto k = segments_.begin();
      std::advance(k, random_.below(segments_.size()));
      ends = { k->second, k->first };
    }
    const bool is = segments_.erase(std::minmax(ends.first, ends.second)) > 0;
    const EditOutcome expected = is         ? EditOutcome::Done
      : has(ends.first) && has(ends.second) ? EditOutcome::NoSegment
                                            : EditOutcome::NoPoint;
    EXPECT_EQ(releaseOne(edit_, ends.first, ends.second), expected);
    ++count[int(expected)];
  }

  /// Some places lie where a Triangulation has them.
  void expectPlaces(const EditedInput& input)
  {
    FreshRun fresh(input);
    Triangulation& made = fresh.engine.made;
    const bool isThere = made.report().triangles > 0;
    ASSERT_EQ(isThere ? made.makeNeighbors(Context()) : Status::Ok, Status::Ok);
    for (int k = 0; k < 4; ++k)
    {
      const Point &p = anyPlace(), &q = anyPlace();
      const Point place = { p.x + (q.x - p.x) / 2.0, p.y };
      EditPlace found;
      ASSERT_EQ(edit_.locate(PointView(&place.x, 1, 2), Context(), &found), Status::Ok);
      const Location expected = isThere ? made.locate(place) : Location();
      ASSERT_EQ(found.kind, expected.kind);
      std::vector<std::int64_t> ids;
      const int corners = expected.kind == Location::InTriangle ? 3
        : expected.kind == Location::OnEdge                     ? 2
        : expected.kind == Location::OnVertex                   ? 1
                                                                : 0;
      for (int c = 0; c < corners; ++c)
      {
        const HalfEdge h = expected.halfEdge;
        const Index v = made.origin(c == 0 ? h
            : c == 1                       ? nextInTriangle(h)
                                           : previousInTriangle(h));
        ids.push_back(input.ids[made.pointOf(v)]);
      }
      if (corners > 0)
      {
        std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
      }
      ids.resize(3, -1);
      EXPECT_TRUE(std::equal(ids.begin(), ids.end(), found.ids.begin()));
    }
  }

  Edit edit_;
  std::vector<Point> places_, points_;
  std::vector<bool> there_;
  std::set<Ends> segments_;
  Random random_;
};

/// Places far from the origin, one unit in the last place and more apart.
std::vector<Point> farLattice()
{
  std::vector<Point> places;
  for (int k = 0; k < 49; ++k)
  {
    places.push_back({ 1e14 + double(k % 7) / 64.0, -1e14 + double(k / 7) / 64.0 });
  }
  return places;
}

void expectHistories(
  const std::vector<Point>& places, std::uint64_t seed, std::size_t steps, std::size_t* counts)
{
  History history(places, seed);
  for (std::size_t k = 0; k < steps; ++k)
  {
    history.step();
    if (k % 5 == 0)
    {
      history.expectAsFresh();
    }
    ASSERT_FALSE(::testing::Test::HasFailure()) << "seed " << seed << ", step " << k;
  }
  for (int k = 0; k < 9; ++k)
  {
    counts[k] += history.count[k];
  }
}

void expectAllKinds(std::uint64_t histories)
{
  std::size_t counts[9] = {};
  for (const Distribution d : { Distribution::Uniform, Distribution::Lattice,
         Distribution::DecimalLattice, Distribution::OnIntegerCircle, Distribution::Collinear,
         Distribution::NearlyCollinear, Distribution::Utm, Distribution::Slivers,
         Distribution::RepeatedDraws, Distribution::AnyFinite })
  {
    for (std::uint64_t seed = 1; seed <= histories; ++seed)
    {
      ASSERT_NO_FATAL_FAILURE(expectHistories(makePoints(d, 2 + seed % 37, seed), seed, 80, counts))
        << nameOf(d);
      ASSERT_FALSE(::testing::Test::HasFailure()) << nameOf(d);
    }
  }
  for (std::uint64_t seed = 1; seed <= histories; ++seed)
  {
    ASSERT_NO_FATAL_FAILURE(expectHistories(farLattice(), seed, 100, counts));
    ASSERT_FALSE(::testing::Test::HasFailure());
  }
  counts[int(EditOutcome::SegmentsMeet)] = 1; // rare; below
  for (int k = 0; k < 9; ++k)
  {
    EXPECT_EQ(counts[k] > 0, EditOutcome(k) != EditOutcome::NotTried) << "outcome " << k;
  }
}

TEST(EditHistories, EqualAFreshRun)
{
  expectAllKinds(reduced(40));
}

TEST(LongEditHistories, EqualAFreshRun)
{
  expectAllKinds(2000);
}

/// Two segments that meet at a vertex inside of both would cross without it.
TEST(EditHistories, AVertexStaysWhereSegmentsMeet)
{
  Edit edit;
  const std::int64_t middle = insertOne(edit, { 1.0, 1.0 });
  for (const Point& p : { Point{ 0.0, 0.0 }, { 2.0, 2.0 }, { 0.0, 2.0 }, { 2.0, 0.0 } })
  {
    insertOne(edit, p);
  }
  EXPECT_EQ(constrainOne(edit, middle + 1, middle + 2), EditOutcome::Done);
  EXPECT_EQ(constrainOne(edit, middle + 3, middle + 4), EditOutcome::Done);
  EXPECT_EQ(removeOne(edit, middle), EditOutcome::SegmentsMeet);
  EXPECT_EQ(moveOne(edit, middle, { 1.0, 1.5 }), EditOutcome::SegmentsMeet);
  expectFresh(edit);
  EXPECT_EQ(releaseOne(edit, middle + 4, middle + 3), EditOutcome::Done);
  EXPECT_EQ(moveOne(edit, middle, { 1.0, 1.5 }), EditOutcome::Done);
  EXPECT_EQ(constrainOne(edit, middle + 3, middle + 4), EditOutcome::Crosses);
  expectFresh(edit);
}

/// Points on a line and one beside it, which comes and goes.
TEST(EditHistories, TrianglesBeginAndEnd)
{
  Edit edit;
  std::vector<std::int64_t> ids;
  for (int k = 0; k < 20; ++k)
  {
    ids.push_back(insertOne(edit, { double(k), 2.0 * double(k) }));
  }
  EXPECT_EQ(constrainOne(edit, ids[2], ids[9]), EditOutcome::Done);
  EXPECT_EQ(constrainOne(edit, ids[5], ids[15]), EditOutcome::Done);
  for (int round = 0; round < 3; ++round)
  {
    expectFresh(edit);
    EXPECT_EQ(edit.mesh().vertexCount(), 0u);
    const std::int64_t apex = insertOne(edit, { 3.0, 1.0 + double(round) });
    const std::int64_t same = insertOne(edit, { 3.0, 1.0 + double(round) });
    EXPECT_GT(edit.mesh().vertexCount(), 0u);
    expectFresh(edit);
    EXPECT_EQ(removeOne(edit, ids[std::size_t(6 + round)]), EditOutcome::Done);
    expectFresh(edit);
    EXPECT_EQ(removeOne(edit, apex), EditOutcome::Done);
    expectFresh(edit);
    EXPECT_GT(edit.mesh().vertexCount(), 0u) << "its duplicate takes its place";
    EXPECT_EQ(moveOne(edit, same, { 30.0, 60.0 }), EditOutcome::Done);
    expectFresh(edit);
  }
  const EditedInput left = inputOf(edit);
  for (const std::int64_t id : left.ids)
  {
    const bool isEnd = id == ids[2] || id == ids[9] || id == ids[5] || id == ids[15];
    EXPECT_EQ(removeOne(edit, id), isEnd ? EditOutcome::EndOfSegment : EditOutcome::Done);
  }
  EXPECT_EQ(releaseOne(edit, ids[9], ids[2]), EditOutcome::Done);
  EXPECT_EQ(releaseOne(edit, ids[5], ids[15]), EditOutcome::Done);
  for (const std::size_t k : { 2, 5, 9, 15 })
  {
    EXPECT_EQ(removeOne(edit, ids[k]), EditOutcome::Done);
    EXPECT_EQ(removeOne(edit, ids[k]), EditOutcome::NoPoint);
  }
  EXPECT_EQ(edit.pointCount(), 0u);
  expectFresh(edit);
}

/// A vertex of many neighbours: in time that is not their number squared.
TEST(EditHistories, TheMiddleOfACircleComesAndGoes)
{
  Edit edit;
  const std::vector<Point> circle = makePoints(Distribution::OnCircle, reduced(50000), 1);
  std::int64_t first = -1;
  ASSERT_EQ(edit.insert(viewOf(circle), Context(), first), Status::Ok);
  for (int round = 0; round < 2; ++round)
  {
    const std::int64_t middle = insertOne(edit, { 0.0, 0.0 });
    expectFresh(edit);
    EXPECT_EQ(removeOne(edit, middle), EditOutcome::Done);
    expectFresh(edit);
  }
}

} // namespace
} // namespace test
} // namespace ahd
