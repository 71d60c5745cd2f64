// SPDX-License-Identifier: BSD-3-Clause
#include "Run.h"

#include "../Core/Border.h"
#include "../Core/Memory.h"
#include "../Prepare/Stacks.h"
#include "../Voronoi/ConvexPolygon.h"
#include "SpacePoints.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ahd
{

// ------------------------------------------------------------------------------------ the result

Status RunResult::select(
  const RunSettings& settings, const PointView& inSpace, const Context& context)
{
  PointsToMeasure measured;
  measured.inSpace = inSpace;
  measured.merged = &points.merged();
  return selectBySize(triangulation, settings.limits, measured, context, selection);
}

std::size_t RunResult::crossingRows() const
{
  return std::min(
    kMostCrossingRows, points.crossingCells().size() + triangulation.constraints().leftOut.size());
}

std::array<std::int64_t, 2> RunResult::crossingRow(std::size_t row) const
{
  const std::size_t split = points.crossingCells().size();
  if (row < split)
  {
    return points.crossingCells()[row];
  }
  const LeftOut& out = triangulation.constraints().leftOut[row - split];
  return { { points.cellOf(out.chain), points.cellOf(out.otherChain) } };
}

namespace
{

/// Numbers for so many points: first those of the view, then others.
NumbersView copied(
  const NumbersView& view, std::size_t given, double others, std::size_t count, Buffer<double>& to)
{
  to.allocate(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    to[i] = i < given ? view[i] : others;
  }
  NumbersView copy;
  copy.doubles = to.data();
  return copy;
}

} // namespace

void RunResult::completeNumbers()
{
  const std::size_t count = points.points().count, inputs = points.inputCount();
  if (count == inputs)
  {
    return;
  }
  if (numbers.values.isGiven())
  {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const std::size_t given = std::min(numbers.valued, count);
    numbers.values = copied(numbers.values, given, kNone, count, ownValues_);
    interpolateAtSurface(points, ownValues_.data(), 1);
    interpolateAtCrossings(points, ownValues_.data(), 1, 0);
  }
  if (numbers.weights.isGiven())
  {
    numbers.weights = copied(numbers.weights, inputs, 1.0, count, ownWeights_);
  }
  if (numbers.keep)
  {
    ownMarks_.allocate(count);
    std::fill(std::copy_n(numbers.keep, inputs, ownMarks_.data()), ownMarks_.data() + count,
      static_cast<unsigned char>(0));
    numbers.keep = ownMarks_.data();
  }
}

// ------------------------------------------------------------------------------------ the memory

Run::Run(const RunSettings& settings, const InputRequest& counts, const CallersMemory& callers,
  Workspace& workspace, RunReport& report)
  : settings_(settings)
  , counts_(counts)
  , callers_(callers)
  , workspace_(workspace)
  , report_(report)
{
  counts_.fitPlane = settings.isProjected(); // or what takes the same
  counts_.projection = nullptr;
  report_.points = expectedPoints(counts);
  report_.segments = segmentsOf(counts);
}

namespace
{

/// Ok, BadPolygon or OutOfMemory.
Status checkPolygon(const RunSettings& settings, PolygonFault& fault)
{
  return withoutThrowing(
    [&]
    {
      const bool isUsed = settings.clipsAtPolygon();
      fault = isUsed ? ConvexPolygon(settings.voronoiPolygon).fault() : PolygonFault::None;
      return fault == PolygonFault::None ? Status::Ok : Status::BadPolygon;
    });
}

} // namespace

Status Run::check(std::size_t limit, std::size_t held)
{
  const Status status = checkPolygon(settings_, report_.polygonFault);
  if (status != Status::Ok)
  {
    return end(status);
  }
  report_.conflict = settings_.conflict();
  if (report_.conflict != Conflict::None)
  {
    return end(Status::BadSettings);
  }
  report_.isLimited = limit > 0;
  if (report_.points > kMaximumPoints)
  {
    return end(Status::TooManyPoints);
  }
  report_.estimate = estimate();
  // Memory kept for this run is part of the estimate. With a limit, all of it is returned where it
  // might be too much.
  if (limit > 0 && workspace_.bytes() > report_.estimate)
  {
    workspace_.release();
  }
  const bool mayGrow = mayAsk() || settings_.options.keepBoxes;
  const std::size_t available = limit > 0 ? 0
    : mayGrow                             ? availableMemory()
                                          : availableMemoryFor(report_.estimate);
  report_.allowed = limit > 0
    ? limit
    : available + std::min(held + workspace_.bytes(), ~available); // no overflow
  report_.isRefused = report_.estimate > report_.allowed;
  if (report_.isRefused)
  {
    return end(Status::OutOfMemory);
  }
  limitCounts();
  return Status::Ok;
}

/// Finds how many there may be, with all that follows from them, of what the run may make.
void Run::limitCounts()
{
  if (settings_.options.keepBoxes)
  {
    report_.mostBoxes = mostThatFit(kTooManyBoxes,
      [this](std::size_t count)
      {
        report_.boxes = count;
        return fits();
      });
    report_.boxes = 0;
  }
  if (report_.segments > 0)
  {
    const std::size_t points = report_.points;
    report_.mostCrossings = mostThatFit(kMaximumPoints + 1,
      [this, points](std::size_t count)
      {
        report_.crossings = count;
        report_.points = points + count;
        return fits();
      });
    report_.crossings = 0;
    report_.points = points;
  }
}

/// May there be requests for memory while it runs?
bool Run::mayAsk() const
{
  return settings_.tolerance > 0.0 || settings_.simplifies() || report_.segments > 0 ||
    counts_.surface.count > 0 || counts_.sourcePoints.count > 0;
}

/// Calls a function that requests memory while it runs, up to all that is available; the limit ends
/// with it. `asked`: of the report.
Status Run::withAsking(std::size_t& asked, const std::function<Status()>& call)
{
  AskedMemory& memory = progress_->asked();
  const std::size_t most = mostThatFit(kTooMuchAsked,
    [&](std::size_t bytes)
    {
      asked = bytes;
      return fits();
    });
  asked = 0;
  memory.limitTo(most);
  const Status status = call();
  asked = memory.most();
  report_.isRefused = status == Status::OutOfMemory && memory.wasRefused();
  memory.limitTo(std::numeric_limits<std::size_t>::max());
  return status;
}

// ------------------------------------------------------------------------------------ the stages

std::vector<double> Run::firstStages() const
{
  const auto weight = [](bool wanted, double value) { return wanted ? value : 0.0; };
  const bool constrains = report_.segments > 0;
  return {
    0.02 + weight(settings_.isProjected(), 0.5) + weight(settings_.tolerance > 0.0, 1.5) +
      weight(settings_.laysSource(), 1.5) + weight(settings_.split && constrains, 2.0),
    weight(settings_.simplifies(), 3.0),
    1.0,
    weight(settings_.voronoi, 3.0),
    weight(constrains, 0.6) + weight(settings_.mayTrimRim(), 0.05) +
      weight(counts_.surface.count > 0, 1.5),
  };
}

std::vector<double> Run::stages() const
{
  const auto weight = [](bool wanted, double value) { return wanted ? value : 0.0; };
  std::vector<double> stages = firstStages();
  stages.insert(stages.end(),
    {
      0.15 + weight(settings_.limitsSize(), 1.5) + weight(settings_.showsMeans, 0.2),
      settings_.timeOfArrays(),
      weight(settings_.voronoi, 0.5),
      weight(settings_.drawsOrder(), 0.4),
    });
  return stages;
}

/// Adds the known sizes to the estimate from now on.
Status Run::end(Status status)
{
  report_.status = status;
  if (progress_)
  {
    report_.estimate = estimate();
    progress_->finishPhase();
  }
  return status;
}

Status Run::make(
  const Open& open, const Lend& lend, RunProgress& progress, Executor* executor, RunResult& made)
{
  progress_ = &progress;
  context_ = { &progress, executor };
  Status status = prepare(open, made);
  status = status != Status::Ok ? status : simplify(made);
  status = status != Status::Ok ? status : triangulate(made);
  status = status != Status::Ok ? status : makeVoronoi(lend, made);
  status = status != Status::Ok ? status : constrain(made);
  if (status == Status::Ok)
  {
    reportOn(made);
    status = findSurface(made);
  }
  return status;
}

Status Run::prepare(const Open& open, RunResult& made)
{
  progress_->reach(kPreparing);
  InputRequest request = open();
  request.mostCrossings = report_.mostCrossings;
  surface_ = request.surface;
  const auto work = [&]
  {
    const Status status = ahd::prepare(request, context_, made.points);
    return status != Status::Ok ? status
                                : withoutThrowing(
                                    [&]
                                    {
                                      made.completeNumbers();
                                      return Status::Ok;
                                    });
  };
  const Status status = mayAsk() ? withAsking(report_.askedToSplit, work) : work();
  if (status == Status::TooManyCrossings)
  {
    report_.crossings = report_.mostCrossings + 1;
    report_.points += report_.crossings;
  }
  else if (status == Status::Ok)
  {
    report_.points = made.points.points().count;
    report_.crossings = made.points.crossings().size();
    report_.addedToLines = made.points.addedToLines();
    const ConstraintView chains = made.points.constraints();
    const std::size_t ids = chains.chains == 0 ? 0 : std::size_t(chains.offsets[chains.chains]);
    const bool areLaid = settings_.laysSource() || settings_.maximumSegmentLength > 0.0;
    report_.segments = areLaid ? std::max(report_.segments, ids) : report_.segments;
  }
  return end(status);
}

Status Run::simplify(RunResult& made)
{
  progress_->reach(kSimplifying);
  if (!settings_.simplifies())
  {
    return Status::Ok;
  }
  SimplifyRequest request;
  request.points = made.points.points();
  request.constraints = made.points.constraints();
  request.values = made.numbers.values;
  request.weights = made.numbers.weights;
  request.mustStay = made.numbers.keep;
  request.maximumError = std::min(settings_.maximumError, std::numeric_limits<double>::max());
  request.maximumNumberOfVertices = settings_.maximumNumberOfVertices;
  request.secondPass = settings_.secondPass;
  request.representative = settings_.options.representative;
  const Status status = withAsking(
    report_.askedToSimplify, [&] { return ahd::simplify(request, context_, made.simplified); });
  return end(status);
}

Status Run::triangulate(RunResult& made)
{
  progress_->reach(kTriangulating);
  Options options = settings_.options;
  options.mostBoxes = report_.mostBoxes;
  Triangulation& triangulation = made.triangulation;
  const PointView& points = made.points.points();
  const bool isWhole = made.simplified.lots.empty();
  const PointView& chosen = isWhole ? points : made.simplified.without(points);
  Status status = ahd::triangulate(chosen, options, workspace_, context_, triangulation);
  report_.boxes = status == Status::TooManyBoxes ? report_.mostBoxes + 1
                                                 : triangulation.boxes().size();
  if (end(status) != Status::Ok)
  {
    return status;
  }
  status = findOddPoints(points, context_, report_.oddPoints);
  if (status == Status::Ok && triangulation.report().duplicates > 0)
  {
    status = made.points.endCrossingsAtVertices(triangulation, context_);
  }
  report_.delaunayTriangles = triangulation.report().triangles;
  return end(status);
}

Status Run::makeVoronoi(const Lend& lend, RunResult& made)
{
  progress_->reach(kMakingVoronoi);
  if (!settings_.voronoi)
  {
    return Status::Ok;
  }
  if (lend)
  {
    lend(made.triangulation.report(), made.voronoi);
  }
  return end(settings_.clipsAtPolygon()
      ? voronoiCells(
          made.triangulation, ConvexPolygon(settings_.voronoiPolygon), made.voronoi, context_)
      : voronoiCells(made.triangulation, settings_.voronoiClip, made.voronoi, context_));
}

Status Run::constrain(RunResult& made)
{
  progress_->reach(kConstraining);
  Triangulation& triangulation = made.triangulation;
  Status status = Status::Ok;
  if (made.points.hasConstraints())
  {
    status = withAsking(report_.askedToConstrain,
      [&]
      {
        return ahd::constrain(std::move(triangulation), made.points.constraints(),
          settings_.fillRule, context_, triangulation);
      });
    status = status == Status::Ok ? lookForInput(made) : status;
  }
  if (status == Status::Ok && settings_.trimsRim(made.points.plane()))
  {
    status = trim(std::move(triangulation), context_, triangulation);
  }
  return end(status);
}

/// Do loops of a source with points and heights of its own keep any of the input? Where heights are
/// the input's, they are of use without.
Status Run::lookForInput(const RunResult& made)
{
  const ConstraintView constraints = made.points.constraints();
  if (made.points.sourceCount() == 0 || settings_.sourceHeights == SourceHeights::FromSurface ||
    constraints.chains == constraints.lines || made.triangulation.report().triangles == 0)
  {
    return Status::Ok;
  }
  bool isKept = false;
  const std::size_t inputs = made.points.inputCount();
  const Status status = keepsAnyOf(made.triangulation, inputs, context_, isKept);
  const std::vector<MergedPoint>& merged = made.points.merged();
  report_.loopsMissInput = !isKept &&
    std::none_of(merged.begin(), merged.end(), // their places are those of the source
      [&](const MergedPoint& m) { return m.id < inputs && m.keptId >= inputs; });
  return status;
}

Status Run::finish(const RunResult& made, const Context& context)
{
  report_.triangles = made.triangleCount();
  report_.lines = made.selection.lines.size() / 2;
  report_.vertices = made.selection.vertices.size();
  const PointView& points = made.points.points();
  if (!report_.mayBeStacked())
  {
    return Status::Ok;
  }
  if (report_.delaunayTriangles == 0)
  {
    return end(findIfOnOneLine(points, context, report_.areOnOneLine));
  }
  return report_.counts.duplicates > report_.counts.inserted / 2 && settings_.takesFirst()
    ? end(findIfStacked(points, context, report_.areStacked))
    : Status::Ok;
}

void Run::reportOn(const RunResult& made)
{
  const PreparedInput& points = made.points;
  const ConstraintReport& constraints = made.triangulation.constraints();
  report_.splits = settings_.split;
  report_.countsWork = settings_.options.countWork;
  report_.counts = made.triangulation.report();
  report_.constraints = { constraints.segments, constraints.points, constraints.withoutVertex,
    constraints.crossing, constraints.unfilledLoops, constraints.edges, {} };
  report_.inputPoints = points.inputCount();
  report_.sourcePoints = points.sourceCount();
  report_.addedPoints = points.addedCount();
  report_.mergedPoints = points.merged().size();
  report_.withinError = made.simplified.leftOut;
  report_.largestError = made.simplified.largestError;
  if (!constraints.leftOut.empty())
  {
    const LeftOut& first = constraints.leftOut[0];
    report_.firstCrossing = { { points.cellOf(first.chain), points.cellOf(first.otherChain) } };
  }
  report_.bentConstraints = points.bentCount();
  report_.firstBentCell = points.firstBentCell();
  report_.unfitIds = points.unfitIds();
  report_.pointsOffSurface = points.outsideCount();
  report_.sourceBounds = points.sourceBounds();
  report_.areLinesUnclosed = points.areLinesUnclosed();
  report_.isProjected = points.isProjected();
  report_.isSteep = points.plane().stance().isSteep;
  report_.keptEstimate = keptMemoryEstimate(counts_, settings_, report_);
}

} // namespace ahd
