// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Job_h
#define ahd_Job_h

#include "../Core/Threads.h"
#include "../Prepare/Prepare.h"
#include "../RunMemory.h"
#include "../Surface/Selection.h"
#include "../Triangulate.h"
#include "../Voronoi/Voronoi.h"
#include "InputArrays.h"
#include "Progress.h"
#include "Projections.h"
#include "Sampling.h"
#include "Settings.h"
#include "SpacePoints.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ahd
{

/// What a run made. Each part is a function of those before it.
struct JobResult
{
  JobSettings settings; ///< as they were
  std::array<double, 16> matrix = {};
  OpenInput input;
  PreparedInput points;
  Triangulation triangulation;
  VoronoiCells voronoi;
  bool isSelected = false; ///< else `selection` stands for all triangles
  Selection selection;
  std::vector<std::int32_t> cellOf; ///< of each triangle, or -1; made when first wanted
  std::size_t delaunayTriangles = 0;
  OddPoints oddPoints;
  bool areOnOneLine = false;
  bool areStacked = false;
  JobSampling sampling;

  std::size_t triangleCount() const
  {
    return isSelected ? selection.keptCount : triangulation.report().triangles;
  }
  std::size_t cellCount() const
  {
    return selection.vertices.size() + selection.lines.size() / 2 + triangleCount();
  }
  /// Where the points are in space; `made` has them if they are not the input's. Refuses if that is
  /// cancelled.
  PointView spacePoints(SpacePoints& made, const Context& context);
};

/// What is known of a run, whether it succeeds or not.
struct JobSizes : RunSizes
{
  std::size_t estimate = 0; ///< bytes
  std::size_t allowed = 0;  ///< bytes
  std::size_t mostBoxes = 0;
  std::size_t mostCrossings = 0;
  unsigned threadsUsed = 0;
};

/// Row by row, what takes points to the plane and their height above it.
void writeMatrix(const Plane& plane, double* matrix);

/// All that is behind a handle of the C interface: settings and input; the run, which is the
/// engine's calls in their order; the result. What cannot be done is refused (Refusal.h).
class Job
{
public:
  // The stages of a run and of what is written afterwards, for JobProgress::reach.
  enum Stage : std::size_t
  {
    Preparing = 1,
    Triangulating,
    MakingVoronoi,
    Constraining,
    WritingCells,
    WritingArrays,
    WritingVoronoi,
    DrawingOrder
  };

  JobSettings settings;
  InputArrays arrays;
  JobProgress progress;

  explicit Job(Clock clock)
    : progress(clock)
  {
  }

  void setProjection(ProjectionCallback projection, void* user)
  {
    projection_ = projection;
    projectionUser_ = user;
  }

  std::size_t estimate() const;
  void run();
  std::size_t keptBytes() const { return workspace_.bytes(); }
  void release(std::size_t most);
  void fitPlane(double* matrix);
  /// Moves points to where they lie in the plane of the result.
  void toPlane(double* xyz, std::size_t count);

  /// Refuses if there is none.
  JobResult& result();
  const JobSizes& sizes() const { return sizes_; }

  /// What was made of the input before is gone with it, as it looks at it.
  void setArray(const char* name, const GivenArray* array)
  {
    arrays.set(name, array);
    release(std::size_t(-1));
  }

  /// Calls work(context), with the threads that the settings ask for.
  template <typename Work>
  void withThreads(const Work& work)
  {
    const std::int64_t wished = settings[IntSetting::Threads];
    Threads threads(wished > 0 ? static_cast<unsigned>(wished) : availableProcessors());
    const NoteThreads noted = { threads, sizes_ };
    work(Context{ &progress, &threads });
  }

private:
  struct NoteThreads
  {
    const Threads& threads;
    JobSizes& sizes;
    ~NoteThreads() { sizes.threadsUsed = std::max(sizes.threadsUsed, threads.used()); }
  };

  void runWith(const Context& context);
  InputRequest request() const;
  JobSizes expected(const InputRequest& request) const;
  void checkMemory();
  std::size_t mostBoxes() const;
  std::size_t mostCrossings() const;
  void setStages();
  void prepare(JobResult& made, InputRequest& request, const Context& context);
  void triangulate(JobResult& made, const Context& context);
  void constrain(JobResult& made, const Context& context);
  void select(JobResult& made, const Context& context);
  void findStacks(JobResult& made, const Context& context);
  [[noreturn]] void refuseForMemory() const;
  template <typename Call>
  Status withAsking(std::size_t& asked, const Call& call);
  std::size_t estimate(const JobSizes& sizes) const;
  RunWishes wishes() const;
  const char* whoAllows() const;

  ProjectionCallback projection_ = nullptr;
  void* projectionUser_ = nullptr;
  Workspace workspace_;
  std::unique_ptr<JobResult> result_;
  JobSizes sizes_;
};

} // namespace ahd

#endif
