// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_EditHistory_h
#define ahd_EditHistory_h

// A random history of an Edit, judged by fresh runs: for the tests of Edit/ and the fuzzer.
#include "Distributions.h"
#include "EditCase.h"

#include <limits>
#include <set>

namespace ahd
{
namespace test
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

} // namespace test
} // namespace ahd

#endif
