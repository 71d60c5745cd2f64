// SPDX-License-Identifier: BSD-3-Clause
//
// What living.py measures of Simplify/, Refine/ and Edit/: one line of JSON. Times are the
// processor's, in seconds; with threads, on the wall.
//
//   LivingBenchmark simplify FILE BOUND ROUNDS THREADS   x, y, z as float64; beside a plain run
//   LivingBenchmark greedy FILE BOUND                    points kept one by one, the worst of all
//   LivingBenchmark memory POINTS                        bytes a point, of random hills
//   LivingBenchmark triangles FILE OUT                   ids as int32
//   LivingBenchmark refine FILE ANGLE SECONDS            a .domain file: living.py
//   LivingBenchmark cgalmesh FILE ANGLE
//   LivingBenchmark edit POINTS CHANGES ROUNDS           beside CGAL
#include "Core/Clock.h"
#include "Core/Threads.h"
#include "Distributions.h"
#include "Edit/Edit.h"
#include "Engine.h"
#include "EngineRun.h"
#include "Order/CurveOrder.h"
#include "Refine/Refine.h"
#include "Sample/Sample.h"
#include "Simplify/LivingSurface.h"
#include "Simplify/Simplify.h"

#include "CgalLiving.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <queue>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace ahd;
using namespace ahd::test;
using Words = std::vector<std::string>;

double processorSeconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

void mustBeOk(Status status)
{
  if (status != Status::Ok)
  {
    throw std::runtime_error("a call of the engine failed");
  }
}

std::size_t wholeNumber(const std::string& word)
{
  return static_cast<std::size_t>(std::stod(word));
}

/// Prints members of the object, one after the other.
class Json
{
public:
  Json() { std::printf("{"); }
  ~Json() { std::printf("}\n"); }
  Json(const Json&) = delete;
  void add(const char* name, double value) { print(name, "%.17g", value); }
  void add(const char* name, const std::vector<double>& values)
  {
    print(name, "[", 0.0);
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      std::printf("%s%.9g", k > 0 ? ", " : "", values[k]);
    }
    std::printf("]");
  }

private:
  void print(const char* name, const char* format, double value)
  {
    std::printf("%s\"%s\": ", isFirst_ ? "" : ", ", name);
    std::printf(format, value);
    isFirst_ = false;
  }

  bool isFirst_ = true;
};

std::vector<double> numbersOf(const std::string& file)
{
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const auto bytes = static_cast<std::size_t>(in.tellg());
  std::vector<double> numbers(bytes / sizeof(double));
  in.seekg(0);
  in.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(bytes));
  return numbers;
}

PointView viewIn(const std::vector<double>& xyz)
{
  return PointView(xyz.data(), xyz.size() / 3, 3);
}

// --------------------------------------------------------------------------------------- simplify

/// At how many points the surface of those kept is wrong by more than the bound, by the sampler:
/// but for its rounding, 2^-40 of the bound.
std::size_t countAbove(const std::vector<double>& xyz, const SimplifyResult& result, double bound)
{
  const PointView points = viewIn(xyz);
  Engine engine;
  mustBeOk(engine.run(result.without(points)));
  std::vector<double> heights, values(points.count);
  for (std::size_t i = 0; i < points.count; ++i)
  {
    heights.push_back(xyz[3 * i + 2]);
  }
  std::vector<unsigned char> mask(points.count);
  Sampler sampler;
  mustBeOk(sampler.prepare(engine.made, nullptr, SampleMethod::Linear, {}));
  const SampleArray array{ heights.data(), 1, values.data(), nullptr };
  SampleReport report;
  mustBeOk(sampler.values(SamplePlaces(points), &array, 1, mask.data(), report, Context()));
  std::size_t above = 0;
  for (std::size_t i = 0; i < points.count; ++i)
  {
    above += std::fabs(values[i] - heights[i]) <= bound * (1.0 + 0x1p-40) ? 0 : 1;
  }
  return above;
}

void simplifyFile(const Words& words, Json& out)
{
  const std::vector<double> xyz = numbersOf(words.at(0));
  const auto count = static_cast<unsigned>(wholeNumber(words.at(3)));
  const auto now = count > 1 ? &steadySeconds : &processorSeconds;
  Threads threads(count);
  const Context context{ nullptr, count > 1 ? &threads : nullptr };
  SimplifyRequest request;
  request.points = viewIn(xyz);
  request.maximumError = std::stod(words.at(1));
  SimplifyResult results[2];
  std::vector<double> plain, times[2];
  Workspace workspace;
  for (std::size_t round = 0; round < wholeNumber(words.at(2)); ++round)
  {
    double begin = now();
    Triangulation made;
    mustBeOk(triangulate(request.points, Options(), workspace, context, made));
    plain.push_back(now() - begin);
    workspace.reclaim(std::move(made));
    for (const int pass : { 0, 1 })
    {
      request.secondPass = pass == 1;
      begin = now();
      mustBeOk(simplify(request, context, results[pass]));
      times[pass].push_back(now() - begin);
    }
  }
  out.add("points", double(request.points.count));
  out.add("plain", plain);
  out.add("once", times[0]);
  out.add("twice", times[1]);
  out.add("kept", double(results[0].kept));
  out.add("kept_twice", double(results[1].kept));
  out.add("largest", std::max(results[0].largestError, results[1].largestError));
  out.add("above",
    double(countAbove(xyz, results[0], request.maximumError) +
      countAbove(xyz, results[1], request.maximumError)));
}

/// The error, the rank and the triangle of a point that is the worst of its triangle.
using WorstItem = std::pair<double, std::pair<Index, LivingSurface::Slot>>;
using WorstQueue = std::priority_queue<WorstItem>;

void queueTouched(LivingSurface& surface, WorstQueue& queue)
{
  for (const LivingSurface::Slot s : surface.touched())
  {
    if (!surface.mesh().isGhost(s) && surface.worst(s).rank != kNoIndex)
    {
      queue.push({ surface.worst(s).error, { surface.worst(s).rank, s } });
    }
  }
  surface.clearTouched();
}

/// The worst point of all is kept, one after the other.
void keepGreedily(const Words& words, Json& out)
{
  const std::vector<double> xyz = numbersOf(words.at(0));
  SimplifyRequest request;
  request.points = viewIn(xyz);
  Candidates candidates;
  mustBeOk(candidates.read(request, Context()));
  const double bound = std::stod(words.at(1)) * candidates.scale();
  Ticker ticker(nullptr, Phase::Insert, 1);
  LivingSurface surface(candidates, bound, ticker);
  surface.begin();
  surface.list(1, true);
  WorstQueue queue;
  for (queueTouched(surface, queue); !queue.empty() && queue.top().first > bound;
       queueTouched(surface, queue))
  {
    const auto [error, where] = queue.top();
    const auto [rank, s] = where;
    queue.pop();
    const LivingSurface::Worst& worst = surface.worst(s);
    if (worst.rank == rank && worst.error == error && !surface.isKept(rank))
    {
      surface.expect(1);
      surface.keep(rank, s);
      surface.settle();
    }
  }
  out.add("kept", double(surface.kept()));
}

/// Beside the input; of the simplified surface of hills, of which few points stay.
void measureMemory(const Words& words, Json& out)
{
  std::vector<double> xyz;
  const std::size_t count = wholeNumber(words.at(0));
  xyz.reserve(3 * count);
  for (const Point& p : makePoints(Distribution::Uniform, count, 1))
  {
    xyz.insert(xyz.end(), { p.x, p.y, std::sin(9.0 * p.x) * std::cos(7.0 * p.y) });
  }
  const auto peak = []
  {
    rusage used;
    getrusage(RUSAGE_SELF, &used);
    return 1024.0 * double(used.ru_maxrss);
  };
  SimplifyRequest request;
  request.points = viewIn(xyz);
  request.maximumError = 0.01;
  SimplifyResult result;
  const double held = std::max(peak(), double(40 * count)); // the points were there twice
  mustBeOk(simplify(request, Context(), result));
  out.add("kept", double(result.kept));
  out.add("bytes", (peak() - (held - double(16 * count))) / double(count));
  out.add("estimate", double(simplifyMemoryEstimate(request)) / double(count));
}

void writeTriangles(const Words& words, Json& out)
{
  const std::vector<double> xyz = numbersOf(words.at(0));
  Engine engine;
  mustBeOk(engine.run(viewIn(xyz)));
  std::vector<std::int32_t> ids(3 * engine.report().triangles);
  mustBeOk(engine.writeTriangles(ids.data()));
  std::ofstream(words.at(1), std::ios::binary)
    .write(reinterpret_cast<const char*>(ids.data()), std::streamsize(4 * ids.size()));
  out.add("triangles", double(engine.report().triangles));
}

// ----------------------------------------------------------------------------------------- refine

/// Numbers of points, segments, holes and loops; then x, y of each point; the ends of each segment;
/// x, y in each hole; of each loop the number of ids, and these.
struct DomainFile : MeshInput
{
  explicit DomainFile(const std::string& file)
  {
    std::ifstream in(file);
    std::size_t loops = 0, count[3] = {};
    in >> count[0] >> count[1] >> count[2] >> loops;
    const auto read = [&in](std::vector<Point>& list, std::size_t many)
    {
      list.resize(many);
      for (Point& p : list)
      {
        in >> p.x >> p.y;
      }
    };
    read(points, count[0]);
    segments.resize(count[1]);
    for (auto& segment : segments)
    {
      in >> segment.first >> segment.second;
      ids.insert(ids.end(), { std::int64_t(segment.first), std::int64_t(segment.second) });
      offsets.push_back(std::int64_t(ids.size()));
    }
    read(holes, count[2]);
    for (std::size_t k = 0; k < loops; ++k)
    {
      std::size_t many = 0;
      in >> many;
      std::copy_n(std::istream_iterator<std::int64_t>(in), many, std::back_inserter(ids));
      offsets.push_back(std::int64_t(ids.size()));
    }
  }
  ConstraintView view() const
  {
    return { ids.data(), offsets.data(), offsets.size() - 1, segments.size() };
  }

  std::vector<std::int64_t> ids, offsets = { 0 };
};

/// From points and segments to triangles that are put out.
Refinement refined(const DomainFile& domain, double angle, Engine& engine, double& inRefine)
{
  mustBeOk(engine.run(viewOf(domain.points)));
  mustBeOk(engine.constrain(domain.view(), FillRule::EvenOdd));
  RefineRequest request;
  request.minimumAngle = angle;
  request.mostSteinerPoints = 1000000;
  Refinement made;
  const double begin = processorSeconds();
  mustBeOk(refine(engine.made, request, Context(), made));
  inRefine = processorSeconds() - begin;
  std::vector<Point> points = domain.points;
  for (const SteinerPoint& p : made.points)
  {
    points.push_back({ p.x, p.y });
  }
  engine.reclaim();
  mustBeOk(engine.run(viewOf(points)));
  mustBeOk(engine.constrain(made.constraints(), FillRule::EvenOdd));
  std::vector<std::int32_t> ids(3 * engine.report().triangles);
  mustBeOk(engine.writeTriangles(ids.data()));
  engine.reclaim();
  return made;
}

/// The least time of several calls in so many seconds.
void refineFile(const Words& words, Json& out)
{
  const DomainFile domain(words.at(0));
  double least = 1e9, leastRefine = 1e9, inRefine = 0.0;
  Refinement made;
  Engine engine;
  const double first = processorSeconds();
  do
  {
    const double begin = processorSeconds();
    made = refined(domain, std::stod(words.at(1)), engine, inRefine);
    least = std::min(least, processorSeconds() - begin);
    leastRefine = std::min(leastRefine, inRefine);
  } while (processorSeconds() - first < std::stod(words.at(2)));
  out.add("steiner", double(made.points.size()));
  out.add("triangles", double(made.triangles));
  out.add("bad", double(made.bad.size()));
  out.add("seconds", least);
  out.add("refine", leastRefine);
}

void refineByCgal(const Words& words, Json& out)
{
#ifdef AHD_WITH_CGAL
  const double begin = processorSeconds();
  out.add("steiner", double(cgalMesh(DomainFile(words.at(0)), std::stod(words.at(1)))));
  out.add("seconds", processorSeconds() - begin);
#else
  out.add("missing", double(words.size()));
#endif
}

// ------------------------------------------------------------------------------------------- edit

/// Uniform points along a Hilbert curve.
std::vector<Point> alongCurve(std::size_t count)
{
  const std::vector<Point> points = makePoints(Distribution::Uniform, count, 1);
  CurveOrder order;
  Ticker ticker(nullptr, Phase::Sort, 1);
  order.build(viewOf(points), 0, count, ticker);
  std::vector<Point> sorted;
  for (std::size_t k = 0; k < count; ++k)
  {
    sorted.push_back(points[order[k]]);
  }
  return sorted;
}

EditTimes ownEdits(
  const std::vector<Point>& points, const EditPlan& plan, const std::vector<Point>& steps)
{
  std::vector<std::int64_t> removed, moved;
  std::vector<Point> to;
  for (std::size_t k = 0; k < plan.changes; ++k)
  {
    removed.push_back(std::int64_t(plan.removed(k)));
    moved.push_back(std::int64_t(plan.moved(k)));
    const Point& p = points[plan.moved(k)];
    to.push_back({ p.x + steps[k].x, p.y + steps[k].y });
  }
  std::vector<EditOutcome> outcomes(plan.changes);
  Edit edit;
  std::int64_t first = 0;
  const double begin = processorSeconds();
  mustBeOk(edit.insert(viewOf(points), Context(), first));
  const double inserted = processorSeconds();
  mustBeOk(edit.remove(removed.data(), removed.size(), Context(), outcomes.data()));
  const double done = processorSeconds();
  mustBeOk(edit.move(moved.data(), viewOf(to), Context(), outcomes.data()));
  return { { inserted - begin, done - inserted, processorSeconds() - done } };
}

void editPoints(const Words& words, Json& out)
{
  const EditPlan plan = { wholeNumber(words.at(0)), wholeNumber(words.at(1)) };
  const std::vector<Point> points = alongCurve(plan.points);
  Random random(3);
  std::vector<Point> steps;
  for (std::size_t k = 0; k < plan.changes; ++k)
  {
    const double x = (random.unit() - 0.5) * 1e-3;
    steps.push_back({ x, (random.unit() - 0.5) * 1e-3 });
  }
  const char* const names[] = { "insert", "remove", "move" };
  std::vector<double> own[3], others[3];
  for (std::size_t round = 0; round < wholeNumber(words.at(2)); ++round)
  {
    const EditTimes times = ownEdits(points, plan, steps);
    EditTimes theirs = {};
#ifdef AHD_WITH_CGAL
    theirs = cgalEdits(points, plan, steps);
#endif
    for (std::size_t k = 0; k < 3; ++k)
    {
      own[k].push_back(times[k]);
      others[k].push_back(theirs[k]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    out.add(names[k], own[k]);
    out.add((std::string(names[k]) + "_cgal").c_str(), others[k]);
  }
}

} // namespace

int main(int argc, char** argv)
{
  const std::map<std::string, void (*)(const Words&, Json&)> all = { { "simplify", simplifyFile },
    { "greedy", keepGreedily }, { "memory", measureMemory }, { "triangles", writeTriangles },
    { "refine", refineFile }, { "cgalmesh", refineByCgal }, { "edit", editPoints } };
  const auto found = all.find(argc > 1 ? argv[1] : "");
  if (found == all.end())
  {
    return 2;
  }
  Json out;
  found->second(Words(argv + 2, argv + argc), out);
  return 0;
}
