// SPDX-License-Identifier: BSD-3-Clause
//
// After any history a LivingMesh is what triangulate() and constrain() make of its vertices and
// constraints.
#include "ConstraintSets.h"
#include "Distributions.h"
#include "Engine.h"
#include "EngineRun.h"
#include "Living/LivingMesh.h"
#include "Predicates/Predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

namespace ahd
{
namespace test
{
namespace
{

using Corners = std::array<std::pair<double, double>, 3>;

/// Counterclockwise, from the smallest corner.
Corners cornersOf(const Point& a, const Point& b, const Point& c)
{
  // 0.0 for -0.0
  Corners corners = { { { a.x + 0.0, a.y + 0.0 }, { b.x + 0.0, b.y + 0.0 },
    { c.x + 0.0, c.y + 0.0 } } };
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::vector<Corners> trianglesOf(const LivingMesh& mesh)
{
  std::vector<Corners> result;
  for (LivingMesh::Slot s = 0; s < mesh.end(); s += Mesh::kSlotSize)
  {
    if (mesh.isUsed(s) && !mesh.isGhost(s))
    {
      result.push_back(cornersOf(
        mesh.place(mesh.apex(s)), mesh.place(mesh.apex(s + 1)), mesh.place(mesh.apex(s + 2))));
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// One history, over some places.
class History
{
public:
  History(std::vector<Point> places, std::uint64_t seed)
    : places_(std::move(places))
    , vertexOf_(places_.size(), 0)
    , random_(seed)
  {
    for (std::size_t k = 2; k < places_.size() && mesh_.vertexCount() == 0; ++k)
    {
      if (orient2d(places_[0], places_[1], places_[k]) != 0)
      {
        mesh_.begin(places_[0], places_[1], places_[k]);
        const bool isCcw = orient2d(places_[0], places_[1], places_[k]) > 0;
        vertexOf_[0] = 1;
        vertexOf_[1] = isCcw ? 2 : 3;
        vertexOf_[k] = isCcw ? 3 : 2;
      }
    }
  }

  bool hasTriangle() const { return mesh_.vertexCount() > 0; }

  void step()
  {
    const std::size_t k = random_.below(places_.size()), what = random_.below(10);
    if (vertexOf_[k] == 0)
    {
      insert(k);
    }
    else if (what < 5)
    {
      remove(k);
    }
    else
    {
      constrain(k, random_.below(places_.size()));
    }
  }

  void expectFresh()
  {
    std::vector<Point> points;
    std::vector<std::int64_t> idOf(places_.size(), -1);
    for (std::size_t k = 0; k < places_.size(); ++k)
    {
      if (vertexOf_[k] != 0)
      {
        idOf[k] = std::int64_t(points.size());
        points.push_back(places_[k]);
      }
    }
    ConstraintSet constraints;
    for (const auto& segment : segments_)
    {
      constraints.addLine({ idOf[segment.first], idOf[segment.second] });
    }
    Engine engine;
    ASSERT_EQ(engine.run(viewOf(points)), Status::Ok);
    ASSERT_EQ(engine.constrain(constraints.view(), FillRule::EvenOdd), Status::Ok);
    EXPECT_EQ(engine.constraints().crossing, 0u);
    std::vector<std::int32_t> ids(3 * engine.report().triangles);
    ASSERT_EQ(engine.writeTriangles(ids.data()), Status::Ok);
    std::vector<Corners> expected;
    for (std::size_t t = 0; t < ids.size(); t += 3)
    {
      const auto corner = [&](std::size_t c) { return points[std::size_t(ids[t + c])]; };
      expected.push_back(cornersOf(corner(0), corner(1), corner(2)));
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_TRUE(trianglesOf(mesh_) == expected) << points.size() << " points";
  }

  std::size_t removed = 0, constrained = 0, crossed = 0;

private:
  LivingMesh::Slot anySlot()
  {
    const std::size_t k = random_.below(places_.size());
    return vertexOf_[k] == 0 ? Mesh::slotOf(mesh_.leaving(vertexOf_[0]))
                             : Mesh::slotOf(mesh_.leaving(vertexOf_[k]));
  }

  void insert(std::size_t k)
  {
    const LivingMesh::Spot spot = mesh_.locate(places_[k], anySlot());
    ASSERT_NE(spot.kind, LivingMesh::Kind::AtVertex);
    vertexOf_[k] = mesh_.insert(places_[k], spot);
    const LivingMesh::Spot found = mesh_.locate(places_[k], anySlot());
    ASSERT_EQ(found.kind, LivingMesh::Kind::AtVertex);
    EXPECT_EQ(mesh_.apex(found.at), vertexOf_[k]);
  }

  void remove(std::size_t k)
  {
    if (k != 0 && mesh_.isRemovable(vertexOf_[k]))
    {
      EXPECT_TRUE(mesh_.remove(vertexOf_[k]));
      vertexOf_[k] = 0;
      ++removed;
    }
  }

  void constrain(std::size_t a, std::size_t b)
  {
    if (a != b && vertexOf_[b] != 0)
    {
      const bool is = mesh_.constrain(vertexOf_[a], vertexOf_[b]);
      ++(is ? constrained : crossed);
      if (is)
      {
        segments_.push_back({ a, b });
      }
    }
  }

  std::vector<Point> places_;
  std::vector<LivingMesh::Vertex> vertexOf_; ///< 0: none
  std::vector<std::pair<std::size_t, std::size_t>> segments_;
  Random random_;
  LivingMesh mesh_;
};

std::vector<Point> distinct(std::vector<Point> points)
{
  std::sort(points.begin(), points.end(), lexicographicallyLess);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Random random(points.size());
  for (std::size_t i = points.size(); i > 1; --i)
  {
    std::swap(points[i - 1], points[random.below(i)]);
  }
  return points;
}

TEST(LivingHistories, EqualAFreshTriangulation)
{
  std::size_t removed = 0, constrained = 0, crossed = 0;
  for (const Distribution d : { Distribution::Uniform, Distribution::Lattice,
         Distribution::DecimalLattice, Distribution::OnIntegerCircle, Distribution::NearlyCollinear,
         Distribution::Utm, Distribution::Slivers, Distribution::AnyFinite })
  {
    for (std::uint64_t seed = 1; seed <= reduced(40); ++seed)
    {
      History history(distinct(makePoints(d, 5 + seed, seed)), seed);
      for (int k = 0; history.hasTriangle() && k < 120; ++k)
      {
        history.step();
        if (k % 4 == 0)
        {
          history.expectFresh();
        }
        ASSERT_FALSE(::testing::Test::HasFailure()) << nameOf(d) << ", " << seed << ", " << k;
      }
      removed += history.removed;
      constrained += history.constrained;
      crossed += history.crossed;
    }
  }
  EXPECT_GT(removed, 100u);
  EXPECT_GT(constrained, 100u);
  EXPECT_GT(crossed, 100u);
}

/// All neighbours in one row of a lattice, so that vertices lie on diagonals of their neighbours.
TEST(LivingHistories, OfARasterThatIsThinnedAndFilledAgain)
{
  std::vector<Point> places;
  for (int k = 0; k < 144; ++k)
  {
    places.push_back({ double(k % 12), double(k / 12) });
  }
  History history(distinct(places), 7);
  for (std::size_t k = 0; k < reduced(20000); ++k)
  {
    history.step();
    if (k % 100 == 0)
    {
      history.expectFresh();
    }
  }
}

} // namespace
} // namespace test
} // namespace ahd
