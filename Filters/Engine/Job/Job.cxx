// SPDX-License-Identifier: BSD-3-Clause
#include "Job.h"

#include "../Core/FloatingPoint.h"
#include "Refusal.h"

#include <algorithm>
#include <string>
#include <utility>

namespace ahd
{
PointView JobResult::spacePoints(SpacePoints& made, const Context& context)
{
  ahd::check(made.make(input.points, input.sourcePoints, points, context));
  if (asked.showsMeans)
  {
    ahd::check(made.showMeans(*this, context));
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
  outline_.reset();
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

void Job::reset(std::size_t most)
{
  release(most);
  settings = JobSettings();
  arrays = InputArrays();
  setProjection(nullptr, nullptr);
  progress.setCallback(nullptr, nullptr);
  edit_.reset();
  tiles_ = JobTiles();
  report_ = RunReport();
}

void Job::run()
{
  release(std::size_t(-1));
  report_ = RunReport();
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

RunSettings Job::asked() const
{
  RunSettings asked = settings.run();
  asked.options.rankBounds = arrays.rankBounds();
  asked.voronoiPolygon = asked.clipsAtPolygon() ? arrays.voronoiPolygon() : asked.voronoiPolygon;
  asked.hasValues = arrays.has(InputArray::Values);
  asked.hasWeights = arrays.has(InputArray::Weights);
  asked.hasMarks = arrays.has(InputArray::Keep);
  return asked;
}

void Job::runWith(const Context& context)
{
  const RunSettings asked = this->asked();
  InputRequest request = this->request(asked);
  Run run(asked, request, callersMemory(), workspace_, report_);
  check(run.check(memoryLimit(), 0));
  progress.beginRun(run.stages());
  result_ = std::make_unique<JobResult>();
  JobResult& made = *result_;
  made.asked = asked;
  made.otherMemory = static_cast<std::size_t>(settings[IntSetting::OtherMemory]);
  made.matrix = arrays.has(InputArray::Matrix) ? arrays.matrix() : made.matrix;
  const MatrixProjection byMatrix(made.matrix);
  const CallbackProjection byCallback(projection_, projectionUser_);
  request.projection = asked.plane == PlaneKind::Matrix ? static_cast<const Projection*>(&byMatrix)
    : asked.plane == PlaneKind::Callback                ? &byCallback
                                                        : nullptr;
  const auto open = [&]
  {
    this->open(context, request);
    return request;
  };
  check(run.make(open, {}, progress, context.executor, made));
  if (report_.foldedTriangles > 0)
  {
    refuse(Reason::BadValue,
      std::to_string(report_.foldedTriangles) + " of the " +
        std::to_string(made.input.surface.count) +
        " triangles of \"surface\" cross others in the plane, are clockwise there, or have corners "
        "that are no vertices.");
  }
  select(context);
  check(run.finish(made, context));
}

/// Refuses what a surface has used up, if it would change that.
void Job::refuseUsedUp(const RunSettings& asked) const
{
  std::string names = "\"bounding\", \"insertion_limit\", \"maximum_vertices\"";
  bool isUsed = asked.addsBounding() || asked.options.insertionLimit > 0 ||
    asked.maximumNumberOfVertices > 0 || asked.mayTrimRim();
  for (const auto& used : kDoublesOnSurface)
  {
    names += ", \"" + std::string(kDoubleRows[std::size_t(used.setting)].name) + "\"";
    isUsed = isUsed || settings[used.setting] != used.value;
  }
  if (isUsed)
  {
    refuse(Reason::BadValue,
      "With \"surface\" there is no " + names + ", and \"rim\" is AHD_RIM_CONVEX_HULL.");
  }
}

/// The engine's request, without the views of arrays.
InputRequest Job::request(const RunSettings& asked) const
{
  InputRequest request;
  if (asked.plane == PlaneKind::Matrix && !arrays.has(InputArray::Matrix))
  {
    refuse(Reason::BadValue, "\"plane\" is AHD_PLANE_MATRIX, but there is no array \"matrix\".");
  }
  if (asked.plane == PlaneKind::Callback && !projection_)
  {
    refuse(Reason::BadValue, "\"plane\" is AHD_PLANE_CALLBACK, but ahd_set_projection() set none.");
  }
  arrays.count(request);
  if (request.surface.count > 0)
  {
    refuseUsedUp(asked);
  }
  request.firstCell = settings[IntSetting::FirstCell];
  asked.ask(request);
  return request;
}

CallersMemory Job::callersMemory() const
{
  return { static_cast<std::size_t>(settings[IntSetting::OtherMemory]) + arrays.copiedBytes(),
    static_cast<std::size_t>(settings[IntSetting::OtherMemoryPerPoint]) };
}

std::size_t Job::estimate()
{
  const RunSettings asked = this->asked();
  RunReport report;
  const Run run(asked, request(asked), callersMemory(), workspace_, report);
  if (report.points > kMaximumPoints)
  {
    refuse(Reason::TooManyPoints, factsOf(report));
  }
  return run.estimate();
}

void Job::open(const Context& context, InputRequest& request)
{
  OpenInput& input = result_->input;
  input.openPoints(arrays, context);
  input.openCells(arrays, context);
  input.points.skipMask = static_cast<unsigned char>(settings[IntSetting::SkipMask]);
  request.points = input.points;
  if (request.fitPlane && request.surface.count > 0) // also to points that are no corner
  {
    check(fitPlaneOf(request, context, result_->fitted));
    request.plane = &result_->fitted;
  }
  input.openSurface(arrays, context);
  request.surface = input.surface;
  request.points = input.points;
  request.sourcePoints = input.sourcePoints;
  result_->numbers = input.numbers;
  request.lines = input.lines;
  request.polygons = input.loops;
}

void Job::select(const Context& context)
{
  JobResult& made = *result_;
  progress.reach(kWritingCells);
  if (made.asked.limitsSize() && made.points.points().count > 0)
  {
    SpacePoints space;
    check(made.select(made.asked, made.spacePoints(space, context), context));
  }
}

/// Refuses unless Ok, with the numbers of the report.
void Job::check(Status status) const
{
  const bool isOfSize = status == Status::TooManyPoints || status == Status::TooManyBoxes ||
    status == Status::TooManyCrossings || status == Status::BadPolygon ||
    status == Status::BadSettings || (status == Status::OutOfMemory && report_.isRefused);
  if (isOfSize)
  {
    refuse(reasonOf(status, report_.isRefused), factsOf(report_));
  }
  ahd::check(status);
}

void Job::fitPlane(double* matrix)
{
  writeMatrix(fittedPlane(), matrix);
}

Plane Job::fittedPlane()
{
  Plane plane;
  InputRequest request;
  arrays.count(request);
  settings.run().ask(request);
  withThreads(
    [&](const Context& context)
    {
      OpenInput input;
      input.openPoints(arrays, context);
      input.points.skipMask = static_cast<unsigned char>(settings[IntSetting::SkipMask]);
      request.points = input.points;
      ahd::check(fitPlaneOf(request, context, plane));
    });
  return plane;
}

void Job::toPlane(double* xyz, std::size_t count)
{
  JobResult& made = result();
  const PlaneKind plane = made.asked.plane;
  const ScopedFloatingPoint asAssumed;
  if (plane == PlaneKind::Callback)
  {
    refuse(Reason::NotAvailable, "With AHD_PLANE_CALLBACK the caller projects the points.");
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
