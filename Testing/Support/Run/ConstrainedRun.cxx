// SPDX-License-Identifier: BSD-3-Clause
#include "ConstrainedRun.h"

#include <algorithm>

namespace ahd
{
namespace test
{
namespace
{

/// Calls everything in the engine, as long as it returns Ok.
void writeAll(
  Engine& engine, std::size_t points, const Helpers& helpers, ConstrainedOutcome& outcome)
{
  const std::size_t triangles = engine.report().triangles;
  outcome.triples.resize(3 * triangles, -7);
  outcome.pointStatus.resize(points, -7);
  outcome.neighbors.resize(3 * triangles, -7);
  outcome.constraintEdges.resize(triangles, 77);
  outcome.regions.resize(triangles, -7);
  Status& status = outcome.status;
  Progress* const progress = helpers.progress;
  status = engine.writeTriangles(outcome.triples.data(), progress, helpers.executor);
  status = status != Status::Ok
    ? status
    : engine.writePointStatus(outcome.pointStatus.data(), progress, helpers.executor);
  status = status != Status::Ok ? status
                                : engine.writeNeighbors(outcome.neighbors.data(), progress);
  status = status != Status::Ok
    ? status
    : engine.writeConstraintEdges(outcome.constraintEdges.data(), progress);
  status = status != Status::Ok ? status : engine.writeRegions(outcome.regions.data(), progress);
}

std::string firstDifference(const char* what, const void* a, const void* b, std::size_t bytes)
{
  const auto* const p = static_cast<const unsigned char*>(a);
  const auto* const q = static_cast<const unsigned char*>(b);
  const auto at = std::mismatch(p, p + bytes, q).first - p;
  return std::size_t(at) == bytes ? ""
                                  : std::string(what) + " differ at byte " + std::to_string(at);
}

template <typename Value>
std::string differenceOf(const char* what, const std::vector<Value>& a, const std::vector<Value>& b)
{
  return a.size() != b.size()
    ? std::to_string(a.size()) + " and " + std::to_string(b.size()) + " " + what
    : firstDifference(what, a.data(), b.data(), a.size() * sizeof(Value));
}

} // namespace

ConstrainedOutcome constrain(Engine& engine, const PointView& points,
  const ConstraintView& constraints, FillRule rule, const Options& options, const Helpers& helpers)
{
  ConstrainedOutcome outcome;
  outcome.status = engine.run(points, options, helpers.progress, helpers.executor);
  if (outcome.status == Status::Ok)
  {
    outcome.status = engine.constrain(constraints, rule, helpers.progress, helpers.executor);
  }
  outcome.report = engine.report();
  if (outcome.status != Status::Ok)
  {
    return outcome;
  }
  outcome.constraints = engine.constraints();
  writeAll(engine, points.count, helpers, outcome);
  return outcome;
}

ConstrainedOutcome constrain(const ConstraintCase& given, FillRule rule)
{
  Engine engine;
  return constrain(engine, given.view(), given.constraints.view(), rule);
}

std::string faultsOfConstraining(const ConstraintCase& given, FillRule rule)
{
  Engine engine;
  const PointView points = given.view();
  const ConstraintSet open = given.constraints.asLines();
  const ConstrainedOutcome whole = constrain(engine, points, open.view(), rule);
  const ConstrainedOutcome filled = constrain(engine, points, given.constraints.view(), rule);
  if (whole.status != Status::Ok || filled.status != Status::Ok)
  {
    return "status " + std::to_string(int(whole.status)) + ", filled " +
      std::to_string(int(filled.status)) + " instead of Ok";
  }
  return joined(certifyConstrained(points, given.constraints.view(), rule, whole, filled));
}

std::string difference(const ConstrainedOutcome& a, const ConstrainedOutcome& b)
{
  const auto numbers = [](const ConstraintReport& r)
  {
    std::vector<std::size_t> result = { r.segments, r.points, r.withoutVertex, r.crossing,
      r.unfilledLoops, r.edges };
    for (const LeftOut& left : r.leftOut)
    {
      result.insert(result.end(), { left.chain, left.segment, left.otherChain, left.otherSegment });
    }
    return result;
  };
  const std::string all[] = {
    a.status == b.status ? "" : "one failed",
    differenceOf("triples", a.triples, b.triples),
    differenceOf("pointStatus", a.pointStatus, b.pointStatus),
    differenceOf("neighbors", a.neighbors, b.neighbors),
    differenceOf("constraint edges", a.constraintEdges, b.constraintEdges),
    differenceOf("regions", a.regions, b.regions),
    differenceOf("counts of constraints", numbers(a.constraints), numbers(b.constraints)),
  };
  const auto first = std::find_if(
    std::begin(all), std::end(all), [](const std::string& s) { return !s.empty(); });
  return first == std::end(all) ? "" : *first;
}

std::string differenceByThreads(const ConstraintCase& given, FillRule rule,
  const ConstrainedOutcome& expected, Executor& executor)
{
  Helpers helpers;
  helpers.executor = &executor;
  Engine engine;
  return difference(
    expected, constrain(engine, given.view(), given.constraints.view(), rule, Options(), helpers));
}

const char* nameOf(FillRule rule)
{
  return rule == FillRule::Orientation ? "by orientation" : "even-odd";
}

} // namespace test
} // namespace ahd
