// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Engine_h
#define ahd_Engine_h

#include "Surface/CellArrays.h"
#include "Triangulate.h"

#include <utility>

namespace ahd
{
namespace test
{

/// A workspace and the triangulation that was made in it last, for tests that make many. Each call
/// is that of the engine with the same name; cell data are those of all kept triangles.
struct Engine
{
  Status run(const PointView& points, const Options& options = Options(),
    Progress* progress = nullptr, Executor* executor = nullptr)
  {
    return ahd::triangulate(points, options, workspace, { progress, executor }, made);
  }
  Status constrain(const ConstraintView& constraints, FillRule rule, Progress* progress = nullptr,
    Executor* executor = nullptr)
  {
    return ahd::constrain(std::move(made), constraints, rule, { progress, executor }, made);
  }

  template <typename Id>
  Status writeTriangles(Id* triples, Progress* progress = nullptr, Executor* executor = nullptr)
  {
    return made.writeTriangles(triples, { progress, executor });
  }
  template <typename Id>
  Status writePointStatus(Id* status, Progress* progress = nullptr, Executor* executor = nullptr)
  {
    return made.writePointStatus(status, { progress, executor });
  }
  template <typename Id>
  Status writeOrder(Id* ids, Progress* progress = nullptr, Executor* executor = nullptr)
  {
    return made.writeOrder(ids, { progress, executor });
  }
  template <typename Id>
  Status writeInsertionRanks(Id* ranks, Progress* progress = nullptr, Executor* executor = nullptr)
  {
    return made.writeInsertionRanks(ranks, { progress, executor });
  }
  template <typename Id>
  Status writeNeighbors(Id* neighbors, Progress* progress = nullptr, Executor* executor = nullptr)
  {
    return ahd::writeNeighbors(made, Selection(), neighbors, { progress, executor });
  }
  Status writeConstraintEdges(
    std::uint8_t* edges, Progress* progress = nullptr, Executor* executor = nullptr)
  {
    return ahd::writeConstraintEdges(made, Selection(), edges, { progress, executor });
  }
  template <typename Id>
  Status writeRegions(Id* regions, Progress* progress = nullptr, Executor* executor = nullptr)
  {
    return ahd::writeRegions(made, Selection(), regions, { progress, executor });
  }

  const Report& report() const { return made.report(); }
  const ConstraintReport& constraints() const { return made.constraints(); }
  const std::vector<GridBox>& boxes() const { return made.boxes(); }

  /// Gives the triangulation's memory to the workspace.
  void reclaim() { workspace.reclaim(std::move(made)); }

  /// Gives all memory back to the system.
  void release()
  {
    made = Triangulation();
    workspace.release();
  }

  Workspace workspace;
  Triangulation made;
};

} // namespace test
} // namespace ahd

#endif
