// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Job_h
#define ahd_Job_h

#include "../Core/Processors.h"
#include "../Core/Threads.h"
#include "../Edit/Edit.h"
#include "CheckedMemory.h"
#include "InputArrays.h"
#include "JobTiles.h"
#include "OutlineRun.h"
#include "Progress.h"
#include "Projections.h"
#include "RefineRun.h"
#include "Refusal.h"
#include "Run.h"
#include "Sampling.h"
#include "Settings.h"
#include "SpacePoints.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace ahd
{

/// The result of a run.
struct JobResult : RunResult
{
  RunSettings asked;
  std::size_t otherMemory = 0; ///< the caller's, in the estimate
  std::array<double, 16> matrix = {};
  OpenInput input;
  Plane fitted;                     ///< with a surface
  std::vector<std::int32_t> cellOf; ///< of each triangle, or -1; made when first wanted
  JobSampling sampling;
  std::unique_ptr<RefinedMesh> refined; ///< null before refine()

  std::size_t cellCount() const { return ahd::cellCount(triangulation, selection); }
  RefineInput toRefine(RunProgress& progress, const Context& context)
  {
    return { points, asked.options, triangulation, progress, context.executor };
  }
  /// The points in space; `made` holds them if they are not the input's. Refuses if
  /// cancelled.
  PointView spacePoints(SpacePoints& made, const Context& context);
};

/// The matrix, row by row, that moves points to the plane and their height above it.
void writeMatrix(const Plane& plane, double* matrix);

/// The object behind a handle of the C interface: settings and input, a run and its result. Its
/// functions refuse (Refusal.h).
class Job
{
public:
  JobSettings settings;
  InputArrays arrays;
  JobProgress progress;

  void setProjection(ProjectionCallback projection, void* user)
  {
    projection_ = projection;
    projectionUser_ = user;
  }

  std::size_t estimate();
  void run();
  std::size_t keptBytes() const { return workspace_.bytes(); }
  void release(std::size_t most);
  /// Makes it as new, but for at most so many bytes of working memory.
  void reset(std::size_t most);
  void fitPlane(double* matrix);
  /// The fitted plane if the input points stand like a wall in x, y (Stance), else that of x, y.
  PlaneKind choosePlane()
  {
    return fittedPlane().stance().isWall ? PlaneKind::BestFit : PlaneKind::Xy;
  }
  /// Moves points to their position in the plane of the result.
  void toPlane(double* xyz, std::size_t count);

  /// Makes the outline of the array cells, without a run. `isDirected`: see OutlineRequest.
  void makeOutline(CheckedMemory& checked, bool isDirected);
  /// A byte for each of the array cells, triangles: 1 if the radius of its circumcircle in space is
  /// not greater.
  void findWithin(double radius, std::uint8_t* kept);
  /// Refuses if there is none.
  const Outline& outline() const;

  /// Calls work(edit, context) with the points and segments that are edited, apart from input and
  /// result; `more` points may come, else 0. Refuses unless Ok.
  void editWith(std::uint64_t more, const std::function<Status(Edit&, const Context&)>& work);
  const Edit& edited();

  /// Many points leaf by leaf, apart from input and result.
  JobTiles& tiles() { return tiles_; }
  /// Calls work(context) with progress of its own.
  template <typename Work>
  void apart(const Work& work)
  {
    const Apart apart(progress);
    withThreads(work);
    ahd::check(progress.finish() ? Status::Ok : Status::Cancelled);
  }
  /// The same for a visit: one that fails has no output.
  template <typename Work>
  void visitTiles(const Work& work)
  {
    try
    {
      apart(work);
    }
    catch (...)
    {
      tiles_.clearOutput();
      throw;
    }
  }

  /// Refines the result, which keeps it. Refuses what findRefineFault() finds, and more.
  const RefinedMesh& refine(CheckedMemory& checked, const RefineRequest& request);
  /// Refuses if there is none.
  const RefinedMesh& refined();
  /// describeTriangles(). Refuses those that do not fit.
  void describeRefined(MeshTriangles& triangles);

  /// Refuses if there is none.
  JobResult& result();
  /// Null if there is none.
  const JobResult* madeResult() const { return result_.get(); }
  /// Of the last run, whether it succeeded or not.
  const RunReport& report() const { return report_; }

  /// Discards the result, which reads the input.
  void setArray(const char* name, const GivenArray* array)
  {
    arrays.set(name, array);
    release(std::size_t(-1));
  }

  /// Calls work(context), with the number of threads of the settings.
  template <typename Work>
  void withThreads(const Work& work)
  {
    const std::int64_t wished = settings[IntSetting::Threads];
    Threads threads(wished > 0 ? static_cast<unsigned>(wished) : availableProcessors());
    const NoteThreads noted = { threads, report_.threadsUsed };
    work(Context{ &progress, &threads });
  }

private:
  struct NoteThreads
  {
    const Threads& threads;
    unsigned& used;
    ~NoteThreads() { used = std::max(used, threads.used()); }
  };

  /// A call with progress of its own: that of the run is left as it is.
  class Apart
  {
  public:
    explicit Apart(JobProgress& progress)
      : progress_(progress)
    {
      progress.beginApart({ 1.0 });
      progress.reach(1);
    }
    ~Apart() { progress_.endApart(); }

  private:
    JobProgress& progress_;
  };
  RunSettings asked() const;
  void runWith(const Context& context);
  void checkEditMemory(std::size_t more);
  void refuseUsedUp(const RunSettings& asked) const;
  InputRequest request(const RunSettings& asked) const;
  CallersMemory callersMemory() const;
  std::size_t memoryLimit() const
  {
    return static_cast<std::size_t>(settings[IntSetting::MemoryLimit]);
  }
  void open(const Context& context, InputRequest& request);
  Plane fittedPlane();
  void select(const Context& context);
  void check(Status status) const;

  ProjectionCallback projection_ = nullptr;
  void* projectionUser_ = nullptr;
  Workspace workspace_;
  std::unique_ptr<JobResult> result_;
  std::unique_ptr<Outline> outline_;
  std::unique_ptr<Edit> edit_; ///< made when first used
  JobTiles tiles_;
  RunReport report_;
};

} // namespace ahd

#endif
