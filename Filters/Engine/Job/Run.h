// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Run_h
#define ahd_Run_h

#include "../Core/Context.h"
#include "../Prepare/Prepare.h"
#include "../Surface/CellArrays.h"
#include "../Surface/FindTriangles.h"
#include "../Surface/Selection.h"
#include "../Triangulate.h"
#include "../Voronoi/Voronoi.h"
#include "RunMemory.h"
#include "RunProgress.h"
#include "RunReport.h"
#include "RunSettings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ahd
{

/// Rows that are put out of cells that cross.
constexpr std::size_t kMostCrossingRows = 1000;

/// What a run makes. Each part is a function of those before it; the triangulation borrows the
/// points.
struct RunResult
{
  PreparedInput points;
  Triangulation triangulation;
  VoronoiCells voronoi;
  Selection selection; ///< empty: all triangles

  /// What the limits on the size of triangles leave of them, if there are any. `inSpace`: where the
  /// user sees the points. Returns Ok, Cancelled or OutOfMemory.
  Status select(const RunSettings& settings, const PointView& inSpace, const Context& context);

  bool isSelected() const { return !selection.kept.empty(); }
  std::size_t triangleCount() const
  {
    return isSelected() ? selection.keptCount : triangulation.report().triangles;
  }

  /// The triangles that are put out.
  template <typename Id>
  Status writeTriangles(Id* corners, const Context& context)
  {
    return isSelected() ? writeSelected(triangulation, selection, corners, context)
                        : triangulation.writeTriangles(corners, context);
  }

  /// The status of each point, merged ones included.
  template <typename Id>
  Status writeStatus(Id* to, const Context& context)
  {
    const Status status = triangulation.writePointStatus(to, context);
    if (status == Status::Ok)
    {
      followMerged(to);
    }
    return status;
  }
  /// Points that were merged have the value of those that they were merged into.
  template <typename Value>
  void followMerged(Value* values) const
  {
    for (const MergedPoint& merged : points.merged())
    {
      values[merged.id] = values[merged.keptId];
    }
  }

  /// How many pairs of cells cross, up to kMostCrossingRows: first those split, then those left
  /// out.
  std::size_t crossingRows() const;
  /// The later cell and the earlier one.
  std::array<std::int64_t, 2> crossingRow(std::size_t row) const;
};

/// One run: the engine's calls in their order, the memory that they take, the stages that they are.
/// Borrows all that it is given. What becomes of it is in the report.
class Run
{
public:
  /// `counts`: of the input; no value is looked at. `report`: a new one.
  Run(const RunSettings& settings, const InputRequest& counts, const CallersMemory& callers,
    Workspace& workspace, RunReport& report);

  /// Upper estimate of all bytes that are held at a time, for what is known of sizes.
  std::size_t estimate() const { return runMemoryEstimate(counts_, settings_, report_, callers_); }

  /// Is the input not too large, and is there memory for it all, as far as that is known before?
  /// `limit`: bytes; 0: what there is. `held`: what the caller has already of the estimate, besides
  /// the workspace, which is released where it might be too much. Returns Ok, or TooManyPoints or
  /// OutOfMemory.
  Status checkMemory(std::size_t limit, std::size_t held);

  /// The weights of the stages of make(). They are about times, measured with 10^6 points: that of
  /// a plain triangulation is 1.
  std::vector<double> firstStages() const;
  /// Those of all of RunStage.
  std::vector<double> stages() const;

  /// Opens the input: the request with views in place of counts.
  using Open = std::function<InputRequest()>;
  /// Lends memory to the cells of the Voronoi diagram.
  using Lend = std::function<void(const Report&, VoronoiCells&)>;

  /// Opens the input, prepares, triangulates and constrains, finds the triangles of a surface that
  /// is given, and fills in the report. Returns what the engine's calls do; throws what `open` and
  /// `lend` throw. REQUIRES: checkMemory(), and stages that begin with firstStages(); with a
  /// surface no constraints, and nothing that drops triangles.
  Status make(
    const Open& open, const Lend& lend, RunProgress& progress, Executor* executor, RunResult& made);

  /// Looks whether x and y tell the points apart, where the triangles give cause for it. After
  /// make(). Returns Ok, Cancelled or OutOfMemory.
  Status findStacks(const RunResult& made, const Context& context);

private:
  bool fits() const { return estimate() <= report_.allowed; }
  Status end(Status status);
  Status withAsking(std::size_t& asked, const std::function<Status()>& call);
  Status prepare(const Open& open, RunResult& made);
  Status triangulate(RunResult& made);
  Status makeVoronoi(const Lend& lend, RunResult& made);
  Status constrain(RunResult& made);
  Status findSurface(RunResult& made);
  Status constrainEdges(const std::vector<std::size_t>& missing, RunResult& made);
  void reportOn(const RunResult& made);

  const RunSettings& settings_;
  InputRequest counts_;
  const CallersMemory callers_;
  Workspace& workspace_;
  RunReport& report_;
  RunProgress* progress_ = nullptr; ///< during make()
  GivenTriangles surface_;          ///< the same
  Context context_;
};

} // namespace ahd

#endif
