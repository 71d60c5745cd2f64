// SPDX-License-Identifier: BSD-3-Clause
#include "Job.h"

#include "../Core/Border.h"
#include "../Core/Memory.h"
#include "../Prepare/Stacks.h"
#include "Projections.h"
#include "Refusal.h"

#include <algorithm>
#include <string>
#include <utility>

namespace ahd
{

PointView JobResult::spacePoints(SpacePoints& made, const Context& context)
{
  check(made.make(input.points, input.sourcePoints, points, context));
  if (settings.showsMeans() && triangulation.report().duplicates > 0)
  {
    check(made.showMeans(points, triangulation, context));
  }
  return made.view();
}

JobResult& Job::result()
{
  if (!result_)
  {
    refuse(Reason::NotAvailable, "There is no result: the job has not run, or its run failed.");
  }
  return *result_;
}

void Job::release(std::size_t most)
{
  if (result_)
  {
    workspace_.reclaim(std::move(result_->triangulation));
    result_.reset();
  }
  if (workspace_.bytes() > most)
  {
    workspace_.release();
  }
}

void Job::run()
{
  release(std::size_t(-1));
  sizes_ = JobSizes();
  try
  {
    withThreads([this](const Context& context) { runWith(context); });
  }
  catch (...)
  {
    result_.reset();
    workspace_.release();
    throw;
  }
}

void Job::runWith(const Context& context)
{
  InputRequest asked = request();
  sizes_ = expected(asked);
  checkMemory();
  setStages();
  result_ = std::make_unique<JobResult>();
  JobResult& made = *result_;
  made.settings = settings;
  prepare(made, asked, context);
  triangulate(made, context);
  constrain(made, context);
  select(made, context);
  findStacks(made, context);
}

/// What is asked of the engine: all but the views of arrays.
InputRequest Job::request() const
{
  InputRequest request;
  const PlaneKind plane = settings.plane();
  if (plane == PlaneKind::Matrix && !arrays.has(InputArray::Matrix))
  {
    refuse(Reason::BadValue, "\"plane\" is AHD_PLANE_MATRIX, but there is no array \"matrix\".");
  }
  if (plane == PlaneKind::Callback && !projection_)
  {
    refuse(Reason::BadValue, "\"plane\" is AHD_PLANE_CALLBACK, but ahd_set_projection() set none.");
  }
  arrays.count(request);
  request.firstCell = settings[IntSetting::FirstCell];
  request.idsAreOfInput = !settings.is(IntSetting::CellIds);
  request.closedLinesAreLoops = settings.is(IntSetting::ClosedLines);
  request.heightsFromSurface = settings.is(IntSetting::SourceHeights);
  request.representative = settings.options().representative;
  request.meanHeights = settings.showsMeans();
  request.fitPlane = plane == PlaneKind::BestFit;
  request.tolerance = settings[DoubleSetting::Tolerance];
  request.bounding = settings.addsBounding();
  request.offset = settings[DoubleSetting::Offset];
  request.split = settings.is(IntSetting::SplitCrossings);
  return request;
}

/// What is known before the run.
JobSizes Job::expected(const InputRequest& request) const
{
  JobSizes sizes;
  sizes.points = expectedPoints(request);
  sizes.segments = segmentsOf(request);
  if (sizes.points > kMaximumPoints)
  {
    refuse(Reason::TooManyPoints,
      std::to_string(sizes.points) + " points are too many: at most " +
        std::to_string(kMaximumPoints) + " can be triangulated.");
  }
  sizes.estimate = estimate(sizes);
  return sizes;
}

const char* Job::whoAllows() const
{
  return settings.is(IntSetting::MemoryLimit) ? "\"memory_limit\" allows" : "there are";
}

/// There may not be memory for it all.
void Job::refuseForMemory() const
{
  refuse(Reason::MemoryLimit,
    "Triangulating " + std::to_string(sizes_.points) + " points may take " +
      butAllowed(sizes_.estimate, sizes_.allowed, whoAllows()) +
      ". Take fewer points, ask for fewer arrays, " + orSetLimit(sizes_.estimate));
}

/// Refuses if there may not be memory for it all, as far as that is known before.
void Job::checkMemory()
{
  const auto limit = static_cast<std::size_t>(settings[IntSetting::MemoryLimit]);
  // What was kept for this run is part of the estimate. With a limit, all of it is given back where
  // it might be too much.
  if (limit > 0 && workspace_.bytes() > sizes_.estimate)
  {
    workspace_.release();
  }
  const std::size_t available = limit > 0 ? 0 : availableMemory();
  sizes_.allowed = limit > 0 ? limit
                             : available + std::min(workspace_.bytes(), ~available); // no overflow
  if (sizes_.estimate > sizes_.allowed)
  {
    refuseForMemory();
  }
  sizes_.mostBoxes = mostBoxes();
  sizes_.mostCrossings = mostCrossings();
}

/// Calls what asks for memory while it works, which may be as much as there is, and refuses where
/// it was more. `asked`: of sizes_.
template <typename Call>
Status Job::withAsking(std::size_t& asked, const Call& call)
{
  const std::size_t most = mostThatFit(kTooMuchAsked,
    [&](std::size_t bytes)
    {
      asked = bytes;
      return estimate(sizes_) <= sizes_.allowed;
    });
  asked = 0;
  progress.asked().limitTo(most);
  const Status status = call();
  asked = progress.asked().most();
  sizes_.estimate = estimate(sizes_);
  if (status == Status::OutOfMemory && progress.asked().wasRefused())
  {
    refuseForMemory();
  }
  return status;
}

std::size_t Job::mostBoxes() const
{
  return mostThatFit(kTooManyBoxes,
    [this](std::size_t count)
    {
      JobSizes sizes = sizes_;
      sizes.boxes = count;
      return estimate(sizes) <= sizes_.allowed;
    });
}

/// How many crossings there is memory for, and for all that comes of them.
std::size_t Job::mostCrossings() const
{
  return mostThatFit(kMaximumPoints + 1,
    [this](std::size_t count)
    {
      JobSizes sizes = sizes_;
      sizes.crossings = count;
      sizes.points += count;
      return estimate(sizes) <= sizes_.allowed;
    });
}

/// Their weights are about their times, measured with 10^6 points: that of a plain triangulation is
/// 1. In the order of Stage.
void Job::setStages()
{
  const auto weight = [this](IntSetting wanted, double value)
  { return settings.is(wanted) ? value : 0.0; };
  const bool constrains = sizes_.segments > 0;
  const double arraysWeight = weight(IntSetting::WantPointStatus, 0.1) +
    weight(IntSetting::WantInsertionRanks, 0.1) + weight(IntSetting::WantConstraintEdges, 0.5) +
    weight(IntSetting::WantRegions, 1.0) + weight(IntSetting::WantNeighbors, 0.9);
  progress.beginRun({ //
    0.02 + (settings.isProjected() ? 0.5 : 0.0) +
      (settings[DoubleSetting::Tolerance] > 0.0 ? 1.5 : 0.0) +
      weight(IntSetting::SourceHeights, 1.5) +
      (constrains ? weight(IntSetting::SplitCrossings, 2.0) : 0.0),
    1.0, //
    weight(IntSetting::WantVoronoi, 3.0),
    (constrains ? 0.6 : 0.0) + (settings.mayTrimRim() ? 0.05 : 0.0),
    0.15 + (settings.limitsSize() ? 1.5 : 0.0) + (settings.showsMeans() ? 0.2 : 0.0),
    arraysWeight,                         //
    weight(IntSetting::WantVoronoi, 0.5), //
    settings.drawsOrder() ? 0.4 : 0.0 });
}

void Job::prepare(JobResult& made, InputRequest& request, const Context& context)
{
  progress.reach(Preparing);
  made.input.openPoints(arrays, context);
  made.input.openCells(arrays, context);
  request.points = made.input.points;
  request.points.skipMask = static_cast<unsigned char>(settings[IntSetting::SkipMask]);
  request.sourcePoints = made.input.sourcePoints;
  request.lines = made.input.lines;
  request.polygons = made.input.loops;
  made.matrix = arrays.has(InputArray::Matrix) ? arrays.matrix() : made.matrix;
  const MatrixProjection byMatrix(made.matrix);
  const CallbackProjection byCallback(projection_, projectionUser_);
  const PlaneKind plane = settings.plane();
  request.projection = plane == PlaneKind::Matrix ? static_cast<const Projection*>(&byMatrix)
    : plane == PlaneKind::Callback                ? &byCallback
                                                  : nullptr;
  request.mostCrossings = sizes_.mostCrossings;
  const Status status = withAsking(
    sizes_.askedToSplit, [&] { return ahd::prepare(request, context, made.points); });
  if (status == Status::TooManyCrossings)
  {
    sizes_.crossings = sizes_.mostCrossings + 1;
    sizes_.points += sizes_.crossings;
    sizes_.estimate = estimate(sizes_);
    refuse(Reason::TooManyCrossings,
      "Segments cross in more than " + std::to_string(sizes_.mostCrossings) +
        " places. Splitting them there and triangulating may take more than " +
        butAllowed(sizes_.estimate, sizes_.allowed, whoAllows()) +
        ". Take fewer segments, leave out those that cross, " + orSetLimit(sizes_.estimate));
  }
  check(status);
  sizes_.points = made.points.points().count;
  sizes_.crossings = made.points.crossings().size();
  sizes_.estimate = estimate(sizes_);
}

void Job::triangulate(JobResult& made, const Context& context)
{
  progress.reach(Triangulating);
  Options options = settings.options();
  options.mostBoxes = sizes_.mostBoxes;
  Triangulation& triangulation = made.triangulation;
  const PointView& points = made.points.points();
  const Status status = ahd::triangulate(points, options, workspace_, context, triangulation);
  sizes_.boxes = status == Status::TooManyBoxes ? sizes_.mostBoxes + 1
                                                : triangulation.boxes().size();
  sizes_.estimate = estimate(sizes_);
  if (status == Status::TooManyBoxes)
  {
    refuse(Reason::TooManyBoxes,
      "The grid has more than " + std::to_string(sizes_.mostBoxes) +
        " boxes. Keeping more may take more than " +
        butAllowed(sizes_.estimate, sizes_.allowed, whoAllows()) +
        ". Ask for no boxes, take fewer points or a larger \"nmax\", " +
        orSetLimit(sizes_.estimate));
  }
  check(status);
  check(findOddPoints(points, context, made.oddPoints));
  if (!made.points.crossings().empty() && triangulation.report().duplicates > 0)
  {
    check(made.points.endCrossingsAtVertices(triangulation, context));
  }
  made.delaunayTriangles = triangulation.report().triangles;
  progress.reach(MakingVoronoi);
  if (settings.is(IntSetting::WantVoronoi))
  {
    check(voronoiCells(triangulation, settings.voronoiClip(), made.voronoi, context));
  }
}

void Job::constrain(JobResult& made, const Context& context)
{
  progress.reach(Constraining);
  Triangulation& triangulation = made.triangulation;
  if (made.points.hasConstraints())
  {
    check(withAsking(sizes_.askedToConstrain,
      [&]
      {
        return ahd::constrain(std::move(triangulation), made.points.constraints(),
          settings.fillRule(), context, triangulation);
      }));
  }
  if (settings.trimsRim(made.points.plane()))
  {
    check(trim(std::move(triangulation), context, triangulation));
  }
}

/// What the limits on the size of triangles leave of them.
void Job::select(JobResult& made, const Context& context)
{
  progress.reach(WritingCells);
  if (!settings.limitsSize() || made.points.points().count == 0)
  {
    return;
  }
  SpacePoints space;
  PointsToMeasure measured;
  measured.inSpace = made.spacePoints(space, context);
  measured.merged = &made.points.merged();
  check(selectBySize(made.triangulation, settings.limits(), measured, context, made.selection));
  made.isSelected = true;
}

/// Looks whether x and y tell the points apart, where the triangles give cause for it.
void Job::findStacks(JobResult& made, const Context& context)
{
  const PointView& points = made.points.points();
  const Report& counts = made.triangulation.report();
  if (settings.isProjected() || counts.beyondLimit > 0)
  {
    return;
  }
  if (made.delaunayTriangles == 0)
  {
    check(findIfOnOneLine(points, context, made.areOnOneLine));
  }
  else if (counts.duplicates > counts.inserted / 2 &&
    settings.duplicates() == Duplicates::First) // else they were thought of
  {
    check(findIfStacked(points, context, made.areStacked));
  }
}

void Job::fitPlane(double* matrix)
{
  Plane plane;
  InputRequest counts;
  arrays.count(counts);
  withThreads(
    [&](const Context& context)
    {
      OpenInput input;
      input.openPoints(arrays, context);
      input.points.skipMask = static_cast<unsigned char>(settings[IntSetting::SkipMask]);
      check(plane.fit(input.points, context));
    });
  writeMatrix(plane, matrix);
}

void Job::toPlane(double* xyz, std::size_t count)
{
  JobResult& made = result();
  const PlaneKind plane = made.settings.plane();
  const ScopedFloatingPoint asAssumed;
  if (plane == PlaneKind::Callback)
  {
    refuse(Reason::NotAvailable, "With AHD_PLANE_CALLBACK it is for the caller to move points.");
  }
  if (plane == PlaneKind::Matrix)
  {
    const PointView points(static_cast<const double*>(xyz), count, 3);
    MatrixProjection(made.matrix).project(points, xyz, Context());
  }
  for (std::size_t i = 0; plane == PlaneKind::BestFit && i < count; ++i)
  {
    const double* const p = xyz + 3 * i;
    const Vector3 moved = made.points.plane().project({ { p[0], p[1], p[2] } });
    std::copy(moved.begin(), moved.end(), xyz + 3 * i);
  }
}

void writeMatrix(const Plane& plane, double* matrix)
{
  const ScopedFloatingPoint asAssumed;
  const Vector3* const axes[] = { &plane.firstAxis(), &plane.secondAxis(), &plane.normal() };
  const Vector3 origin = plane.project({ { 0, 0, 0 } });
  for (std::size_t row = 0; row < 3; ++row)
  {
    std::copy(axes[row]->begin(), axes[row]->end(), matrix + 4 * row);
    matrix[4 * row + 3] = origin[row];
    matrix[12 + row] = 0.0;
  }
  matrix[15] = 1.0;
}

} // namespace ahd
