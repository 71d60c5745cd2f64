// SPDX-License-Identifier: BSD-3-Clause
#include "HashedResults.h"

#include "Corpus.h"
#include "Crossings/Crossings.h"
#include "Hash.h"
#include "ListOf.h"
#include "Merge/Merge.h"
#include "Voronoi/Voronoi.h"

#include <algorithm>
#include <cmath>

namespace ahd
{
namespace test
{
namespace
{

constexpr std::size_t kPoints = 10000;
constexpr std::size_t kFewPoints = 2000; ///< of results made in many ways
constexpr std::size_t kWidePoints = 200; ///< where predicates need thousands of bits
constexpr std::size_t kManyPoints = 34000;
constexpr std::uint64_t kSmallCases = 200;
const char* const kRules[] = { "Orientation", "EvenOdd" };

PointView viewOf(const std::vector<Point>& points)
{
  return points.empty() ? PointView(static_cast<const double*>(nullptr), 0, 2)
                        : PointView(&points[0].x, points.size(), 2);
}

bool isWide(Distribution distribution)
{
  return distribution == Distribution::TinyAndHuge || distribution == Distribution::AnyFinite;
}

Status called(const Way& way, const std::function<Status()>& work)
{
  return way.call ? way.call(work) : work();
}

/// An engine that has run, and the arrays it writes.
class Run
{
public:
  Run(const PointView& points, const Way& way)
    : points_(points)
    , way_(way)
    , engine_(way.engine ? *way.engine : own_)
  {
  }

  /// Calls the engine and hashes the status.
  template <typename Work>
  void call(Work work)
  {
    const Status status = called(way_, work);
    isOk = isOk && status == Status::Ok;
    hash.add(status);
  }

  void run(const Options& options)
  {
    call([&] { return engine_.run(points_, options, way_.progress, way_.executor); });
  }

  void constrain(const ConstraintView& constraints, FillRule rule)
  {
    call([&] { return engine_.constrain(constraints, rule, way_.progress); });
    addConstraintReport();
  }

  void write()
  {
    triples.assign(3 * report().triangles, -7);
    neighbors.assign(3 * report().triangles, -7);
    pointStatus.assign(points_.count, -7);
    call([&] { return engine_.writeTriangles(triples.data(), way_.progress, way_.executor); });
    call(
      [&] { return engine_.writePointStatus(pointStatus.data(), way_.progress, way_.executor); });
    call([&] { return engine_.writeNeighbors(neighbors.data(), way_.progress); });
  }

  void addReport()
  {
    for (const std::size_t count : { report().inserted, report().beyondLimit, report().duplicates,
           report().notFinite, report().skipped, report().triangles })
    {
      hash.add(count);
    }
  }

  void addWritten()
  {
    addReport();
    hash.add(triples);
    hash.add(pointStatus);
    hash.add(neighbors);
  }

  void addPlaces()
  {
    addReport();
    for (const std::int32_t id : triples)
    {
      const Point p = points_[static_cast<std::size_t>(id)];
      hash.add(Point{ p.x + 0.0, p.y + 0.0 });
    }
    hash.add(neighbors);
  }

  void addCellData()
  {
    std::vector<std::uint8_t> edges(report().triangles, 77);
    std::vector<std::int64_t> regions(report().triangles, -7);
    call([&] { return engine_.writeConstraintEdges(edges.data(), way_.progress); });
    call([&] { return engine_.writeRegions(regions.data(), way_.progress); });
    hash.add(edges);
    hash.add(regions);
  }

  void addOrder()
  {
    std::vector<std::int64_t> order(report().inserted, -7);
    std::vector<std::int64_t> ranks(points_.count, -7);
    call([&] { return engine_.writeOrder(order.data(), way_.progress, way_.executor); });
    call([&] { return engine_.writeInsertionRanks(ranks.data(), way_.progress, way_.executor); });
    hash.add(order);
    hash.add(ranks);
    for (const GridBox& box : engine_.boxes())
    {
      hash.add(Point{ box.xmin, box.ymin });
      hash.add(Point{ box.xmax, box.ymax });
      hash.add(box.level);
      hash.add(box.count);
    }
  }

  const Report& report() const { return engine_.report(); }
  Triangulation& made() { return engine_.made; }

  Hash hash;
  bool isOk = true; ///< were all calls?
  std::vector<std::int32_t> triples;
  std::vector<std::int64_t> pointStatus, neighbors;

private:
  void addConstraintReport()
  {
    const ConstraintReport& r = engine_.constraints();
    for (const std::size_t count :
      { r.segments, r.points, r.withoutVertex, r.crossing, r.unfilledLoops, r.edges })
    {
      hash.add(count);
    }
    for (const LeftOut& left : r.leftOut)
    {
      for (const std::size_t number :
        { left.chain, left.segment, left.otherChain, left.otherSegment })
      {
        hash.add(number);
      }
    }
  }

  PointView points_;
  const Way& way_;
  Engine own_;
  Engine& engine_;
};

/// Numbers as they are hashed.
std::vector<std::int64_t> wide(const std::vector<std::int32_t>& numbers)
{
  return std::vector<std::int64_t>(numbers.begin(), numbers.end());
}

double widthOf(const PointView& points)
{
  double least = INFINITY, most = -INFINITY;
  for (std::size_t i = 0; i < points.count; ++i)
  {
    const double x = points[i].x;
    least = std::isfinite(x) ? std::min(least, x) : least;
    most = std::isfinite(x) ? std::max(most, x) : most;
  }
  return most / 2 - least / 2; // half of it: the whole may overflow
}

NamedHash named(const std::string& family, const std::string& name, const std::string& hash)
{
  return { family + "/" + name, hash };
}

/// Each order with the paper's settings, and ours.
std::vector<std::pair<std::string, Options>> orders()
{
  Options best, curve, everyBox, lines, grid, given;
  curve.controlPoints = ControlPoints::SingleLevel;
  everyBox.controlPoints = ControlPoints::Off;
  everyBox.geneRotation = false;
  everyBox.nmax = 1;
  lines.order = InsertionOrder::MultiGrid;
  lines.controlPoints = ControlPoints::SingleLevel;
  grid.order = InsertionOrder::RegularGrid;
  given.order = InsertionOrder::AsGiven;
  return { { "default", best }, { "HG", curve }, { "HG,nmax=1,genes=off,control=off", everyBox },
    { "MG", lines }, { "RG", grid }, { "AsGiven", given } };
}

std::string hashOfSmallCases(FillRule rule, const Way& way)
{
  Hash hash;
  for (std::uint64_t seed = 0; seed < kSmallCases; ++seed)
  {
    for (const char digit : hashOfConstrained(smallConstraintCase(seed), rule, way))
    {
      hash.add(digit);
    }
  }
  return hash.text();
}

} // namespace

std::vector<NamedPoints> pointsOfDistributions(std::size_t most)
{
  std::vector<NamedPoints> result;
  for (const Distribution d : allDistributions())
  {
    result.push_back(
      { nameOf(d), makePoints(d, isWide(d) ? std::min(most, kWidePoints) : most, 7) });
  }
  return result;
}

std::vector<NamedPoints> manyPoints()
{
  std::vector<NamedPoints> result;
  for (const Distribution d : { Distribution::Uniform, Distribution::Mixed,
         Distribution::NestedClusters, Distribution::Lattice, Distribution::Utm })
  {
    result.push_back({ nameOf(d), makePoints(d, kManyPoints, 8) });
  }
  return result;
}

std::vector<NamedPoints> pointsOfCorpus(const std::string& folder)
{
  std::vector<NamedPoints> result;
  for (CorpusFile& file : readCorpus(folder))
  {
    result.push_back({ file.name, std::move(file.points) });
  }
  return result;
}

std::vector<NamedCase> constraintCases()
{
  std::vector<NamedCase> result = { { "starPolygon", starPolygon(1000) },
    { "shortSegments", shortSegments(5000, 1000) }, { "edgesOfOthers", edgesOfOthers(5000, 2000) },
    { "randomSegments", randomSegments(2000, 300) }, { "segmentAcross", segmentAcross(5000) },
    { "segmentAcrossParabolas", segmentAcrossParabolas(1000) },
    { "segmentAcrossBulges", segmentAcrossBulges(1000) },
    { "segmentAcrossCombs", segmentAcrossCombs(1000) }, { "spiralLine", spiralLine(1000, 40) },
    { "nearlyCollinearLines", nearlyCollinearLines(1000) },
    { "latticeSegments", latticeSegments(40, 800) }, { "nestedLoops", nestedLoops(10) } };
  for (const Distribution d : allDistributions())
  {
    const std::size_t n = isWide(d) ? kWidePoints : 1000;
    result.push_back({ std::string("chainsThrough") + nameOf(d), chainsThrough(d, n, 40, 9) });
  }
  return result;
}

std::string hashOfTriangles(const PointView& points, const Way& way)
{
  Run run(points, way);
  run.run(way.options);
  run.write();
  run.addWritten();
  return run.hash.text();
}

std::string hashOfPlaces(const PointView& points, const Way& way)
{
  Run run(points, way);
  run.run(way.options);
  run.write();
  run.addPlaces();
  return run.hash.text();
}

std::string hashOfConstrained(const ConstraintCase& given, FillRule rule, const Way& way)
{
  Run run(given.view(), way);
  run.run(way.options);
  run.constrain(given.constraints.view(), rule);
  run.write();
  run.addWritten();
  run.addCellData();
  return run.hash.text();
}

std::string hashOfOrder(const PointView& points, const Options& order, const Way& way)
{
  Options options = order;
  options.keepOrder = true;
  options.keepBoxes = true;
  Run run(points, way);
  run.run(options);
  run.addOrder();
  options.insertionLimit = points.count / 2 + 1;
  run.run(options);
  run.write();
  run.addWritten();
  return run.hash.text();
}

std::string hashOfMerged(const PointView& points, const Way& way)
{
  Hash hash;
  MergedPoints merged;
  const double distance = widthOf(points) / 50.0;
  hash.add(called(way, [&] { return mergeWithin(points, distance, way.progress, merged); }));
  hash.add(merged.pairs.size());
  for (const MergedPoint& pair : merged.pairs)
  {
    hash.add(pair.id);
    hash.add(pair.keptId);
  }
  hash.add(merged.skip);
  return hash.text();
}

std::string hashOfVoronoi(const PointView& points, const Way& way)
{
  Run run(points, way);
  run.run(Options());
  run.write();
  if (!run.isOk)
  {
    return run.hash.text(); // cancelled: there are no triangles to take
  }
  for (const VoronoiClip clip : { VoronoiClip::Hull, VoronoiClip::Bounds })
  {
    VoronoiCells cells;
    run.call([&] { return voronoiCells(run.made(), clip, cells, { way.progress, way.executor }); });
    run.hash.add(listOf(cells.points));
    run.hash.add(wide(listOf(cells.offsets)));
    run.hash.add(wide(listOf(cells.corners)));
    run.hash.add(wide(listOf(cells.sites)));
  }
  return run.hash.text();
}

std::string hashOfSplit(const ConstraintCase& given, const Way& way)
{
  Hash hash;
  SplitConstraints split;
  const auto work = [&]
  { return splitAtCrossings(given.view(), given.constraints.view(), way.progress, split); };
  hash.add(called(way, work));
  for (const CrossingPoint& point : split.points)
  {
    hash.add(point.at);
    hash.add(Point{ point.alongA, point.alongB });
    for (const std::size_t number : { point.chainA, point.segmentA, point.chainB, point.segmentB })
    {
      hash.add(number);
    }
  }
  hash.add(split.ids);
  hash.add(split.offsets);
  hash.add(split.segments);
  for (const std::size_t number : { split.lines, split.crossings, split.unresolved })
  {
    hash.add(number);
  }
  hash.add(split.rounds);
  return hash.text();
}

Hashes hashesOfTriangles(const std::string& corpus, const Way& way)
{
  Hashes result;
  const auto add = [&](const std::string& family, const std::vector<NamedPoints>& all)
  {
    for (const NamedPoints& given : all)
    {
      result.push_back(named(family, given.name, hashOfTriangles(viewOf(given.points), way)));
    }
  };
  add("corpus", pointsOfCorpus(corpus));
  add("points", pointsOfDistributions(kPoints));
  return result;
}

Hashes hashesOfConstrained(const Way& way)
{
  Hashes result;
  for (const FillRule rule : { FillRule::Orientation, FillRule::EvenOdd })
  {
    const std::string family = std::string("constrained/") + kRules[int(rule)];
    for (const NamedCase& made : constraintCases())
    {
      result.push_back(named(family, made.name, hashOfConstrained(made.given, rule, way)));
    }
    result.push_back(named(family, "smallCases", hashOfSmallCases(rule, way)));
  }
  return result;
}

Hashes hashesOfTheRest(const Way& way)
{
  Hashes result;
  for (const NamedCase& made : constraintCases())
  {
    result.push_back(named("split", made.name, hashOfSplit(made.given, way)));
  }
  const std::vector<NamedPoints> distributions = pointsOfDistributions(kFewPoints);
  for (const NamedPoints& given : distributions)
  {
    const PointView points = viewOf(given.points);
    result.push_back(named("merged", given.name, hashOfMerged(points, way)));
    result.push_back(named("voronoi", given.name, hashOfVoronoi(points, way)));
    for (const auto& order : orders())
    {
      result.push_back(
        named("order/" + order.first, given.name, hashOfOrder(points, order.second, way)));
    }
  }
  return result;
}

Hashes hashesOfMany(const Way& way)
{
  Hashes result;
  for (const NamedPoints& given : manyPoints())
  {
    const PointView points = viewOf(given.points);
    result.push_back(named("many", given.name, hashOfTriangles(points, way)));
    result.push_back(named("order/many", given.name, hashOfOrder(points, Options(), way)));
    result.push_back(named("voronoi/many", given.name, hashOfVoronoi(points, way)));
  }
  return result;
}

} // namespace test
} // namespace ahd
