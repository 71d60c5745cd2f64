// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Run_h
#define ahd_Run_h

#include "../Core/Context.h"
#include "../Prepare/Prepare.h"
#include "../Simplify/Simplify.h"
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

/// The most rows of crossing cells in the output.
constexpr std::size_t kMostCrossingRows = 1000;

/// Numbers of the points that are given with them, borrowed. Added points have none; then values
/// are interpolated as heights are, or NaN.
struct PointNumbers
{
  NumbersView values;                  ///< of the surface, in place of z
  std::size_t valued = 0;              ///< so many: for the points of the input, or the source, too
  NumbersView weights;                 ///< of the points of the input; others have 1
  const unsigned char* keep = nullptr; ///< marks of these: see SimplifyRequest::mustStay
};

/// The result of a run. Each part depends on those before it; the triangulation borrows the
/// points.
struct RunResult
{
  PreparedInput points;
  PointNumbers numbers;      ///< of all these, once they are prepared
  SimplifyResult simplified; ///< empty: all points
  Triangulation triangulation;
  VoronoiCells voronoi;
  Selection selection; ///< empty: all triangles

  /// That of the surface at a point, were it a vertex.
  double valueOf(std::size_t point) const
  {
    return numbers.values.isGiven() ? numbers.values[point] : points.points().z(point);
  }

  /// Selects the triangles within the limits of size, if there are any. `inSpace`: the points in
  /// space. Returns Ok, Cancelled or OutOfMemory.
  Status select(const RunSettings& settings, const PointView& inSpace, const Context& context);

  bool isSelected() const { return !selection.kept.empty(); }
  std::size_t triangleCount() const
  {
    return isSelected() ? selection.keptCount : triangulation.report().triangles;
  }

  /// The output triangles.
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
      for (std::size_t i = 0; i < simplified.lots.size(); ++i)
      {
        to[i] = simplified.lots[i] == PointLot::WithinError ? Id(kStatusWithinError) : to[i];
      }
      followMerged(to);
    }
    return status;
  }
  /// Merged points get the value of the point they were merged into.
  template <typename Value>
  void followMerged(Value* values) const
  {
    for (const MergedPoint& merged : points.merged())
    {
      values[merged.id] = values[merged.keptId];
    }
  }

  /// The number of pairs of crossing cells, up to kMostCrossingRows: first those split, then those
  /// left out.
  std::size_t crossingRows() const;
  /// The later cell and the earlier one.
  std::array<std::int64_t, 2> crossingRow(std::size_t row) const;

  /// Makes the numbers those of all prepared points.
  void completeNumbers();

private:
  Buffer<double> ownValues_, ownWeights_;
  Buffer<unsigned char> ownMarks_;
};

/// One run: the engine's calls in their order, their memory and their stages. Borrows all
/// arguments. The outcome is in the report.
class Run
{
public:
  /// `counts`: of the input; no value is read. `report`: a new one.
  Run(const RunSettings& settings, const InputRequest& counts, const CallersMemory& callers,
    Workspace& workspace, RunReport& report);

  /// Upper estimate of the peak memory in bytes, from the known sizes.
  std::size_t estimate() const { return runMemoryEstimate(counts_, settings_, report_, callers_); }

  /// Checks the number of points, the polygon to clip at, and the memory as far as it is known
  /// before the run.
  /// `limit`: bytes; 0: available memory. `held`: the part of the estimate that the caller holds
  /// already, besides the workspace, which is released if it may be too large. Returns Ok,
  /// TooManyPoints, BadPolygon, BadSettings or OutOfMemory.
  Status check(std::size_t limit, std::size_t held);

  /// The weights of the stages of make(). They are about times, measured with 10^6 points: that of
  /// a plain triangulation is 1.
  std::vector<double> firstStages() const;
  /// Those of all of RunStage.
  std::vector<double> stages() const;

  /// Opens the input: the request with views in place of counts, and RunResult::numbers.
  using Open = std::function<InputRequest()>;
  /// Lends memory to the cells of the Voronoi diagram.
  using Lend = std::function<void(const Report&, VoronoiCells&)>;

  /// Opens the input, prepares, simplifies, triangulates and constrains, finds the triangles of a
  /// surface that is given, and fills in the report. Returns what the engine's calls do; throws
  /// what `open` and `lend` throw. @pre check(), and stages that begin with firstStages(); with a
  /// surface no constraints, and nothing that drops triangles.
  Status make(
    const Open& open, const Lend& lend, RunProgress& progress, Executor* executor, RunResult& made);

  /// After make() and the selection of triangles: reports on the output, and checks whether x and y
  /// distinguish the points, if the triangles suggest that they do not. Returns Ok, Cancelled or
  /// OutOfMemory.
  Status finish(const RunResult& made, const Context& context);

private:
  bool fits() const { return estimate() <= report_.allowed; }
  Status end(Status status);
  Status withAsking(std::size_t& asked, const std::function<Status()>& call);
  void limitCounts();
  bool mayAsk() const;
  Status prepare(const Open& open, RunResult& made);
  Status simplify(RunResult& made);
  Status triangulate(RunResult& made);
  Status makeVoronoi(const Lend& lend, RunResult& made);
  Status constrain(RunResult& made);
  Status lookForInput(const RunResult& made);
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
