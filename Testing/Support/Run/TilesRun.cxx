// SPDX-License-Identifier: BSD-3-Clause
#include "TilesRun.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

namespace ahd
{
namespace test
{

TileLines linesOf(const std::vector<Point>& points, const ConstraintView& chains, FillRule rule)
{
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  TileLines lines;
  lines.lines = chains.lines;
  lines.rule = std::uint64_t(rule);
  for (std::size_t chain = 0; chain <= chains.chains && chains.chains != 0; ++chain)
  {
    lines.offsets.push_back(chains.offsets[chain]);
  }
  for (std::int64_t k = 0; k != (chains.chains == 0 ? 0 : lines.offsets.back()); ++k)
  {
    const std::int64_t id = chains.ids[k];
    const bool isPoint = id >= 0 && id < std::int64_t(points.size());
    lines.corners.push_back(isPoint ? points[std::size_t(id)] : Point{ kNaN, kNaN });
  }
  return lines;
}

TilesRun::TilesRun(const PointView& points, const TilesWay& way)
  : way_(way)
{
  TileFacts facts;
  if (!count(points, facts))
  {
    return;
  }
  facts.extent = joined(facts.bounds, way.extent);
  facts.hasPlaces = isEmpty(way.extent) ? 0 : 1;
  facts.lines = way.lines;
  visits_ = std::make_unique<TileVisits>(std::move(facts));
  deal(points);
  visitAll();
  for (std::size_t node = plan().leaves(); node != plan().parts() && isFine(); ++node)
  {
    merge(node);
  }
}

/// Does it return Ok?
bool TilesRun::call(const std::function<Status()>& work)
{
  const Status done = way_.call ? way_.call(work) : work();
  const std::lock_guard<std::mutex> lock(telling_);
  status = done == Status::Ok ? status : done;
  return done == Status::Ok;
}

bool TilesRun::count(const PointView& points, TileFacts& facts)
{
  constexpr std::size_t kChunk = 777;
  TileCounter counter(way_.guess);
  TileCounter::Next next = TileCounter::Next::Again;
  while (next == TileCounter::Next::Again)
  {
    for (std::size_t begin = 0; begin < points.count; begin += kChunk)
    {
      PointView chunk = points;
      chunk.doubles += begin * chunk.stride;
      chunk.count = std::min(kChunk, points.count - begin);
      if (!call([&] { return counter.count(chunk, way_.context); }))
      {
        return false;
      }
    }
    next = counter.endPass(way_.most, facts);
  }
  fault = next == TileCounter::Next::Different ? "other points" : "";
  return fault.empty();
}

void TilesRun::deal(const PointView& points)
{
  xyz_.resize(plan().leaves());
  ids_.resize(plan().leaves());
  std::vector<std::int32_t> leaves(points.count);
  plan().findLeaves(points, 0, points.count, leaves.data());
  for (std::size_t i = 0; i != points.count; ++i)
  {
    const std::int32_t leaf = leaves[i];
    if (leaf >= 0)
    {
      const std::array<double, 3> p = points.place(i);
      xyz_[std::size_t(leaf)].insert(xyz_[std::size_t(leaf)].end(), p.begin(), p.end());
      ids_[std::size_t(leaf)].push_back(std::int64_t(i));
    }
  }
  borders_.resize(plan().parts());
  owns_.resize(plan().parts());
  shares_.resize(plan().parts());
}

TilePoints TilesRun::pointsOf(std::size_t leaf) const
{
  return { leaf, PointView(xyz_[leaf].data(), ids_[leaf].size(), 3), ids_[leaf].data() };
}

void TilesRun::visitAll()
{
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t != way_.threads; ++t)
  {
    const auto work = [this, t]
    {
      for (std::size_t leaf = t; leaf < plan().leaves() && isFine(); leaf += way_.threads)
      {
        visit(leaf);
      }
    };
    if (way_.threads == 1)
    {
      work();
    }
    else
    {
      threads.emplace_back(work);
    }
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

bool TilesRun::fits(const TilePoints& given)
{
  const char* wrong = nullptr;
  const bool goesOn = call([&] { return visits_->findFault(given, way_.context, wrong); });
  const std::lock_guard<std::mutex> lock(telling_);
  fault = wrong ? wrong : fault;
  return !wrong && goesOn;
}

bool TilesRun::read(std::size_t leaf, TileKept& kept)
{
  const TileView own = viewOf(owns_[leaf]);
  bool fits = false;
  if (!visits_->readKept(leaf, &own, sharesFor(leaf), kept))
  {
    fault = "these are other bytes";
    return false;
  }
  const bool goesOn = call(
    [&] { return visits_->findFits(pointsOf(leaf), kept, way_.context, fits); });
  fault = goesOn && !fits ? "it does not fit" : fault;
  return goesOn && fits;
}

void TilesRun::visit(std::size_t leaf)
{
  const TilePoints given = pointsOf(leaf);
  if (!fits(given))
  {
    return;
  }
  TileOutput out;
  call([&] { return visits_->visit(given, way_.representative, way_.context, out); });
  borders_[leaf] = std::move(out.border);
  owns_[leaf] = std::move(out.own);
}

void TilesRun::merge(std::size_t node)
{
  std::vector<TileView> given;
  for (const std::size_t part : plan().joinedBy(node))
  {
    given.push_back(viewOf(borders_[part]));
  }
  std::vector<TileBorder> borders;
  if (!visits_->readBorders(node, given, borders))
  {
    fault = "no borders";
    return;
  }
  for (std::size_t k = 0; k != borders.size(); ++k)
  {
    const bool isLeaf = plan().joinedBy(node)[k] < plan().leaves();
    borderPoints += isLeaf ? borders[k].border.points.size() : 0;
  }
  TileOutput out;
  call([&] { return visits_->merge(node, borders, way_.context, out); });
  borders_[node] = std::move(out.border);
  shares_[node] = std::move(out.share);
  constraints = out.constraints;
}

void TilesRun::compare(const TileOutput& made)
{
  fault = isFine() && made.constraints != constraints ? "other constraints" : fault;
}

std::vector<TileView> TilesRun::sharesFor(std::size_t leaf) const
{
  std::vector<TileView> views;
  for (std::size_t node = plan().parents()[leaf]; node != plan().parts();
       node = plan().parents()[node])
  {
    views.push_back(viewOf(shares_[node]));
  }
  return views;
}

std::vector<std::int64_t> TilesRun::triangles(std::vector<std::uint8_t>* edges)
{
  std::vector<std::int64_t> all;
  for (std::size_t leaf = 0; leaf != plan().leaves() && isFine(); ++leaf)
  {
    TileKept kept;
    if (!read(leaf, kept))
    {
      break;
    }
    TileOutput out;
    call([&] { return visits_->makeTriangles(pointsOf(leaf), kept, way_.context, out); });
    compare(out);
    all.insert(all.end(), out.triangles.begin(), out.triangles.end());
    if (edges)
    {
      edges->insert(edges->end(), out.edges.begin(), out.edges.end());
    }
  }
  return all;
}

SecondVisit TilesRun::second(std::size_t leaf)
{
  SecondVisit visit;
  TileKept kept;
  TileOutput out;
  if (!read(leaf, kept))
  {
    return visit;
  }
  call([&] { return visits_->makeList(leaf, kept, way_.context, out); });
  compare(out);
  visit.ids = ids_[leaf];
  visit.xyz = xyz_[leaf];
  visit.own = visit.ids.size();
  visit.listed = out.listIds.size();
  visit.ids.insert(visit.ids.end(), out.listIds.begin(), out.listIds.end());
  for (std::size_t k = 0; k != out.listIds.size(); ++k)
  {
    visit.xyz.insert(visit.xyz.end(), { out.listPoints[2 * k], out.listPoints[2 * k + 1], 0.0 });
  }
  const Bounds& b = plan().facts().bounds;
  visit.options.rankBounds = { b.xmin, b.xmax, b.ymin, b.ymax };
  visit.options.representative = way_.representative;
  return visit;
}

TileOutput TilesRun::surface(std::size_t leaf, double longest)
{
  TileKept kept;
  TileOutput out;
  if (read(leaf, kept))
  {
    call([&] { return visits_->makeSurface(pointsOf(leaf), kept, longest, way_.context, out); });
    compare(out);
  }
  return out;
}

std::vector<std::int64_t> TilesRun::trianglesOfSecondVisits()
{
  std::vector<std::int64_t> all;
  for (std::size_t leaf = 0; leaf != plan().leaves() && isFine(); ++leaf)
  {
    const SecondVisit visit = second(leaf);
    const Outcome made = triangulate(visit.view(), visit.options);
    status = made.status == Status::Ok ? status : made.status;
    for (std::size_t t = 0; t != made.triples.size(); ++t)
    {
      const std::size_t first = std::size_t(made.triples[t - t % 3]);
      if (first < visit.own)
      {
        all.push_back(visit.ids[std::size_t(made.triples[t])]);
      }
    }
  }
  return all;
}

SampleRaster rasterAround(const Bounds& b, std::size_t side)
{
  SampleRaster raster;
  const double width = isEmpty(b) ? 0.0 : std::max(b.xmax - b.xmin, b.ymax - b.ymin);
  const double pitch = width / double(side - 4) * 1.13;
  if (pitch > 0.0 && std::fabs(b.xmin) < 1e300 && std::fabs(b.ymax) < 1e300 && width < 1e300)
  {
    raster.spacing = { pitch, -pitch };
    raster.origin = { b.xmin - 2.1 * pitch, b.ymax + 1.7 * pitch };
    raster.columns = raster.rows = side;
  }
  return raster;
}

Bounds boundsOf(const SampleRaster& raster)
{
  const Point a = raster.at(0, 0), b = raster.at(raster.columns - 1, raster.rows - 1);
  return { std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y) };
}

std::vector<std::int64_t> trianglesOfOneRun(const PointView& points, Representative representative)
{
  Options options;
  options.representative = representative;
  Engine engine;
  const Outcome made = triangulate(engine, points, options);
  return { made.triples.begin(), made.triples.end() };
}

} // namespace test
} // namespace ahd
