// SPDX-License-Identifier: BSD-3-Clause
//
// Points leaf by leaf, with the bytes in memory, beside one run: CPU time of one thread, by step.
//   TileCounts [--points=1e6,1e7] [--leaf=200000]
//   TileCounts --check    few points: the same triangles
#include "Tiles/TileCounter.h"
#include "Tiles/TileVisits.h"
#include "Triangulate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace ahd;

void require(bool isTrue, const char* what)
{
  if (!isTrue)
  {
    std::fprintf(stderr, "%s failed\n", what);
    std::exit(1);
  }
}

double cpuSeconds()
{
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// The time of a step.
class Stopwatch
{
public:
  explicit Stopwatch(double& seconds)
    : seconds_(seconds)
    , begin_(cpuSeconds())
  {
  }
  ~Stopwatch() { seconds_ += cpuSeconds() - begin_; }

private:
  double& seconds_;
  const double begin_;
};

/// Seconds of each step, in all.
struct Times
{
  double plan = 0, deal = 0, visits = 0, nodes = 0, triangles = 0, lists = 0, second = 0;
};

/// The same each time, in strips, as a survey is flown.
std::vector<Point> makePoints(std::size_t count)
{
  constexpr std::size_t kStrips = 64;
  const double side = std::sqrt(double(count));
  std::vector<Point> points;
  std::uint64_t state = 1;
  const auto random = [&state]
  {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return double(state >> 11) * 0x1p-53;
  };
  for (std::size_t i = 0; i != count; ++i)
  {
    const double along = double(i % (count / kStrips + 1)) / double(count / kStrips + 1);
    const double x = (double(i * kStrips / count) + random()) / kStrips;
    const double y = std::min(1.0, along + 1e-3 * random());
    points.push_back(
      { std::round(5e7 + 100 * side * x) / 100, std::round(52e7 + 100 * side * y) / 100 });
  }
  return points;
}

PointView viewOf(const std::vector<Point>& points)
{
  return { points.empty() ? nullptr : &points[0].x, points.size(), 2 };
}

/// All steps, and the triangles' sum of products with their places.
class Run
{
public:
  Run(const std::vector<Point>& points, std::uint64_t most)
  {
    plan(points, most);
    deal(points);
    const TilePlan& plan = visits_->plan();
    std::vector<BlockBytes> borders(plan.parts());
    owns_.resize(plan.leaves());
    shares_.resize(plan.parts());
    for (std::size_t leaf = 0; leaf != plan.leaves(); ++leaf)
    {
      const Stopwatch watch(times.visits);
      TileOutput out;
      require(
        visits_->visit(pointsOf(leaf), Representative::FirstId, {}, out) == Status::Ok, "visit()");
      borders[leaf] = std::move(out.border);
      owns_[leaf] = std::move(out.own);
    }
    for (std::size_t node = plan.leaves(); node != plan.parts(); ++node)
    {
      const Stopwatch watch(times.nodes);
      std::vector<TileView> given;
      for (const std::size_t part : plan.joinedBy(node))
      {
        given.push_back({ borders[part].data(), borders[part].size() });
        bytesOfBorders += borders[part].size();
      }
      std::vector<TileBorder> below;
      require(visits_->readBorders(node, given, below), "readBorders()");
      TileOutput out;
      require(visits_->merge(node, below, {}, out) == Status::Ok, "merge()");
      borders[node] = std::move(out.border);
      shares_[node] = std::move(out.share);
      bytesOfShares += shares_[node].size();
    }
    for (std::size_t leaf = 0; leaf != plan.leaves(); ++leaf)
    {
      again(leaf);
    }
  }

  std::size_t leaves() const { return visits_->plan().leaves(); }

  Times times;
  std::size_t triangles = 0, listed = 0, bytesOfBorders = 0, bytesOfShares = 0;
  std::uint64_t hash = 0;

private:
  void plan(const std::vector<Point>& points, std::uint64_t most)
  {
    const Stopwatch watch(times.plan);
    TileCounter counter{ Bounds() };
    TileFacts facts;
    do
    {
      require(counter.count(viewOf(points), {}) == Status::Ok, "count()");
    } while (counter.endPass(most, facts) == TileCounter::Next::Again);
    facts.extent = facts.bounds;
    facts.hasPlaces = 1;
    visits_ = std::make_unique<TileVisits>(std::move(facts));
  }

  void deal(const std::vector<Point>& points)
  {
    const Stopwatch watch(times.deal);
    places_.resize(visits_->plan().leaves());
    ids_.resize(places_.size());
    std::vector<std::int32_t> leaves(points.size());
    visits_->plan().findLeaves(viewOf(points), 0, points.size(), leaves.data());
    for (std::size_t i = 0; i != points.size(); ++i)
    {
      const auto leaf = std::size_t(leaves[i]);
      places_[leaf].push_back(points[i]);
      ids_[leaf].push_back(std::int64_t(i));
    }
  }

  TilePoints pointsOf(std::size_t leaf) const
  {
    return { leaf, viewOf(places_[leaf]), ids_[leaf].data() };
  }

  void again(std::size_t leaf)
  {
    const TilePlan& plan = visits_->plan();
    std::vector<TileView> shares;
    for (std::size_t node = plan.parents()[leaf]; node != plan.parts(); node = plan.parents()[node])
    {
      shares.push_back({ shares_[node].data(), shares_[node].size() });
    }
    TileKept kept;
    TileOutput made, list;
    {
      const Stopwatch watch(times.triangles);
      const TileView own{ owns_[leaf].data(), owns_[leaf].size() };
      require(visits_->readKept(leaf, &own, shares, kept), "readKept()");
      require(
        visits_->makeTriangles(pointsOf(leaf), kept, {}, made) == Status::Ok, "makeTriangles()");
    }
    for (const std::int64_t id : made.triangles)
    {
      hash = (hash ^ std::uint64_t(id)) * 1099511628211u;
    }
    triangles += made.edges.size();
    {
      const Stopwatch watch(times.lists);
      require(visits_->makeList(leaf, kept, {}, list) == Status::Ok, "makeList()");
    }
    listed += list.listIds.size();
    const Stopwatch watch(times.second);
    std::vector<Point> all = places_[leaf];
    for (std::size_t k = 0; k != list.listIds.size(); ++k)
    {
      all.push_back({ list.listPoints[2 * k], list.listPoints[2 * k + 1] });
    }
    const Bounds& b = plan.facts().bounds;
    Options options;
    options.rankBounds = { b.xmin, b.xmax, b.ymin, b.ymax };
    Triangulation whole;
    require(triangulate(viewOf(all), options, workspace_, {}, whole) == Status::Ok, "second run");
  }

  std::unique_ptr<TileVisits> visits_;
  std::vector<std::vector<Point>> places_;
  std::vector<std::vector<std::int64_t>> ids_;
  std::vector<BlockBytes> owns_, shares_;
  Workspace workspace_;
};

/// Nanoseconds a point; exits if the triangles differ.
void compare(std::size_t count, std::uint64_t most)
{
  const std::vector<Point> points = makePoints(count);
  const Run run(points, most);
  double made = 0, written = 0;
  std::uint64_t hash = 0;
  std::size_t triangles = 0;
  {
    Workspace workspace;
    Triangulation whole;
    {
      const Stopwatch watch(made);
      require(triangulate(viewOf(points), {}, workspace, {}, whole) == Status::Ok, "run");
    }
    triangles = whole.report().triangles;
    std::vector<std::int32_t> triples(3 * triangles);
    const Stopwatch watch(written);
    require(whole.writeTriangles(triples.data(), {}) == Status::Ok, "write");
    for (const std::int32_t id : triples)
    {
      hash = (hash ^ std::uint64_t(std::int64_t(id))) * 1099511628211u;
    }
  }
  require(hash == run.hash && triangles == run.triangles, "comparing triangles");
  const auto each = [count](double seconds) { return 1e9 * seconds / double(count); };
  const Times& t = run.times;
  std::printf("| %zu | %zu | %.0f | %.0f | %.0f | %.0f | %.0f | %.1f | %.0f | %.0f | %.0f | %.1f | "
              "%.1f | %.2f |\n",
    count, run.leaves(), each(t.plan), each(t.deal), each(t.visits), each(t.nodes),
    each(t.triangles), each(t.lists), each(t.second), each(made), each(written),
    double(run.bytesOfBorders) / double(count), double(run.bytesOfShares) / double(count),
    double(run.listed) / double(run.leaves()) / std::sqrt(double(count) / double(run.leaves())));
  std::fflush(stdout);
}

std::vector<double> numbersOf(const std::string& text)
{
  std::vector<double> numbers;
  std::stringstream in(text);
  for (std::string one; std::getline(in, one, ',');)
  {
    numbers.push_back(std::atof(one.c_str()));
  }
  return numbers;
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<double> counts = { 1e6, 1e7 };
  double most = 200000;
  for (int k = 1; k < argc; ++k)
  {
    const std::string argument = argv[k];
    if (argument == "--check")
    {
      counts = { 20000 };
      most = 1000;
    }
    else if (argument.compare(0, 9, "--points=") == 0)
    {
      counts = numbersOf(argument.substr(9));
    }
    else if (argument.compare(0, 7, "--leaf=") == 0)
    {
      most = std::atof(argument.c_str() + 7);
    }
    else
    {
      std::fprintf(stderr, "%s?\n", argv[k]);
      return 2;
    }
  }
  std::puts(
    "| points | leaves | plan | deal | visits | nodes | triangles | lists | second run | one run | "
    "written | borders | shares | listed |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
  for (const double count : counts)
  {
    compare(std::size_t(count), std::uint64_t(most));
  }
  return 0;
}
