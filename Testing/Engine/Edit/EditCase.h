// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_EditCase_h
#define ahd_EditCase_h

#include "ConstraintSets.h"
#include "Edit/Edit.h"
#include "Engine.h"
#include "EngineRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

namespace ahd
{
namespace test
{

using Corners = std::array<std::int64_t, 3>;

/// From the smallest id, in ascending order.
inline std::vector<Corners> sorted(std::vector<Corners> triangles)
{
  for (Corners& c : triangles)
  {
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// What a fresh run makes of points and segments.
struct FreshRun
{
  explicit FreshRun(const EditedInput& given)
    : input(given)
  {
    EXPECT_EQ(engine.run(input.points()), Status::Ok);
    EXPECT_EQ(engine.constrain(input.constraints(), FillRule::EvenOdd), Status::Ok);
    ids.resize(3 * engine.report().triangles);
    EXPECT_EQ(engine.writeTriangles(ids.data()), Status::Ok);
  }

  /// By the ids of the Edit.
  std::vector<Corners> triangles() const
  {
    std::vector<Corners> found;
    for (std::size_t t = 0; t < ids.size(); t += 3)
    {
      found.push_back({ { input.ids[std::size_t(ids[t])], input.ids[std::size_t(ids[t + 1])],
        input.ids[std::size_t(ids[t + 2])] } });
    }
    return sorted(found);
  }

  EditedInput input;
  Engine engine;
  std::vector<std::int64_t> ids;
};

/// The living triangles.
inline std::vector<Corners> trianglesOf(Edit& edit)
{
  EXPECT_EQ(edit.locate(PointView(), Context(), nullptr), Status::Ok);
  const LivingMesh& mesh = edit.mesh();
  std::vector<Corners> found;
  std::vector<EditPlace> at(1);
  for (LivingMesh::Slot s = 0; mesh.vertexCount() > 0 && s < mesh.end(); s += Mesh::kSlotSize)
  {
    if (mesh.isUsed(s) && !mesh.isGhost(s))
    {
      Corners corners;
      for (Index e = 0; e < 3; ++e)
      {
        const Point& p = mesh.place(mesh.apex(s + e));
        EXPECT_EQ(edit.locate(viewOf(std::vector<Point>{ p }), Context(), at.data()), Status::Ok);
        EXPECT_EQ(at[0].kind, Location::OnVertex);
        corners[e] = at[0].ids[0];
      }
      found.push_back(corners);
    }
  }
  return sorted(found);
}

inline EditedInput inputOf(const Edit& edit)
{
  EditedInput input;
  EXPECT_EQ(edit.write(input, Context()), Status::Ok);
  return input;
}

inline void expectFresh(Edit& edit)
{
  const FreshRun fresh(inputOf(edit));
  EXPECT_EQ(fresh.engine.constraints().crossing, 0u);
  EXPECT_TRUE(trianglesOf(edit) == fresh.triangles()) << edit.pointCount() << " points";
}

// One request.
inline std::int64_t insertOne(Edit& edit, const Point& p)
{
  std::int64_t id = -1;
  EXPECT_EQ(edit.insert(PointView(&p.x, 1, 2), Context(), id), Status::Ok);
  return id;
}
inline EditOutcome removeOne(Edit& edit, std::int64_t id)
{
  EditOutcome outcome = EditOutcome::NotTried;
  EXPECT_EQ(edit.remove(&id, 1, Context(), &outcome), Status::Ok);
  return outcome;
}
inline EditOutcome moveOne(Edit& edit, std::int64_t id, const Point& p)
{
  EditOutcome outcome = EditOutcome::NotTried;
  EXPECT_EQ(edit.move(&id, PointView(&p.x, 1, 2), Context(), &outcome), Status::Ok);
  return outcome;
}
inline EditOutcome constrainOne(Edit& edit, std::int64_t a, std::int64_t b)
{
  const std::int64_t ends[] = { a, b };
  EditOutcome outcome = EditOutcome::NotTried;
  EXPECT_EQ(edit.constrain(ends, 1, Context(), &outcome), Status::Ok);
  return outcome;
}
inline EditOutcome releaseOne(Edit& edit, std::int64_t a, std::int64_t b)
{
  const std::int64_t ends[] = { a, b };
  EditOutcome outcome = EditOutcome::NotTried;
  EXPECT_EQ(edit.release(ends, 1, Context(), &outcome), Status::Ok);
  return outcome;
}

} // namespace test
} // namespace ahd

#endif
