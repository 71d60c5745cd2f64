// SPDX-License-Identifier: BSD-3-Clause
#include "JobTiles.h"

#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Core/FloatingPoint.h"
#include "../Core/SizeInWords.h"
#include "Arrays.h"
#include "CheckedMemory.h"
#include "Job.h"
#include "Refusal.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <numeric>
#include <string>

namespace ahd
{
namespace
{

constexpr std::uint64_t kUsualMost = 200000;

/// xmin, xmax, ymin, ymax; empty where null.
Bounds boundsOf(const double* given, const char* what)
{
  if (!given)
  {
    return {};
  }
  const bool isBox = std::all_of(given, given + 4, [](double v) { return std::isfinite(v); }) &&
    given[0] <= given[1] && given[2] <= given[3];
  if (!isBox)
  {
    refuse(Reason::BadValue, std::string(what) + " is not xmin, xmax, ymin, ymax.");
  }
  return { given[0] + 0.0, given[1] + 0.0, given[2] + 0.0, given[3] + 0.0 };
}

std::vector<TileView> viewsOf(const std::vector<GivenBytes>& given)
{
  std::vector<TileView> views;
  for (const GivenBytes& bytes : given)
  {
    views.push_back({ static_cast<const unsigned char*>(bytes.data),
      bytes.data ? static_cast<std::size_t>(bytes.size) : 0 });
  }
  return views;
}

} // namespace

const TileVisits& JobTiles::visits() const
{
  if (!visits_)
  {
    refuse(
      Reason::NotAvailable, "There is no plan: ahd_tiles_plan() or ahd_tiles_load() make one.");
  }
  return *visits_;
}

std::size_t JobTiles::checkedLeaf(std::uint64_t leaf) const
{
  if (leaf >= plan().leaves())
  {
    refuse(Reason::BadValue,
      "There is no leaf " + std::to_string(leaf) + " of " + std::to_string(plan().leaves()) + ".");
  }
  return static_cast<std::size_t>(leaf);
}

// ------------------------------------------------------------------------------------ the plan

void JobTiles::begin(const double* bounds)
{
  const ScopedFloatingPoint asAssumed;
  const Bounds guess = boundsOf(bounds, "The guess of the bounds");
  *this = JobTiles();
  counter_ = std::make_unique<TileCounter>(guess);
}

void JobTiles::count(const GivenArray& points, const Context& context)
{
  if (!counter_)
  {
    refuse(Reason::NotAvailable, "No plan was begun: ahd_tiles_begin() does.");
  }
  const OpenPoints opened(points, context);
  check(counter_->count(opened.view, context));
}

bool JobTiles::endPass(std::uint64_t most, const double* extent)
{
  if (!counter_)
  {
    refuse(Reason::NotAvailable, "No plan was begun: ahd_tiles_begin() does.");
  }
  const ScopedFloatingPoint asAssumed;
  const Bounds places = boundsOf(extent, "The extent");
  TileFacts facts;
  const TileCounter::Next next = counter_->endPass(most == 0 ? kUsualMost : most, facts);
  if (next == TileCounter::Next::Again)
  {
    return true;
  }
  counter_.reset();
  if (next == TileCounter::Next::Different)
  {
    refuse(Reason::BadArray, "These are other points than in the pass before: begin anew.");
  }
  facts.extent = joined(facts.bounds, places);
  facts.hasPlaces = isEmpty(places) ? 0 : 1;
  take(std::move(facts));
  return false;
}

namespace
{

TileTables tablesOf(const TilePlan& plan)
{
  TileTables tables;
  tables.plan = plan.write();
  for (std::size_t k = 0; k != plan.leaves(); ++k)
  {
    const Bounds& b = plan.box(k);
    tables.counts.push_back(static_cast<std::int64_t>(plan.leaf(k).count));
    tables.boxes.insert(tables.boxes.end(), { b.xmin, b.xmax, b.ymin, b.ymax });
  }
  for (const std::size_t parent : plan.parents())
  {
    tables.parents.push_back(parent == plan.parts() ? -1 : static_cast<std::int64_t>(parent));
  }
  const Bounds& all = plan.facts().bounds;
  tables.bounds = { all.xmin, all.xmax, all.ymin, all.ymax };
  return tables;
}

} // namespace

void JobTiles::take(TileFacts&& facts)
{
  for (const TileLeaf& leaf : facts.leaves)
  {
    if (leaf.count > kMaximumPoints)
    {
      refuse(Reason::TooManyPoints,
        std::to_string(leaf.count) + " points lie in one of 2^32 x 2^32 cells: at most " +
          std::to_string(kMaximumPoints) + ".");
    }
  }
  auto visits = std::make_unique<TileVisits>(std::move(facts));
  tables_ = tablesOf(visits->plan());
  visits_ = std::move(visits);
  output_ = TileOutput();
}

const TileTables& JobTiles::tables() const
{
  visits();
  return tables_;
}

void JobTiles::load(const GivenBytes& plan)
{
  const ScopedFloatingPoint asAssumed;
  TileFacts facts;
  if (!plan.data ||
    !TilePlan::read(
      static_cast<const unsigned char*>(plan.data), static_cast<std::size_t>(plan.size), facts))
  {
    refuse(Reason::BadArray, "These bytes are no plan.");
  }
  take(std::move(facts));
  counter_.reset();
}

void JobTiles::setLines(TileLines&& lines)
{
  const ScopedFloatingPoint asAssumed;
  TileFacts facts = plan().facts();
  facts.lines = std::move(lines);
  take(std::move(facts));
}

void JobTiles::findLeaves(
  const GivenArray& points, std::int32_t* leaves, const Context& context) const
{
  const TilePlan& plan = this->plan();
  const OpenPoints opened(points, context);
  check(unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, opened.view.count);
      return inChunks(0, opened.view.count, ticker,
        [&](std::size_t begin, std::size_t end)
        { plan.findLeaves(opened.view, begin, end, leaves + begin); });
    }));
}

SampleRaster JobTiles::piece(std::uint64_t leaf, const SampleRaster& whole) const
{
  const ScopedFloatingPoint asAssumed;
  const std::size_t k = checkedLeaf(leaf);
  if (!plan().holds(whole))
  {
    refuse(Reason::BadValue, "A cell of the raster is not in the extent of the plan.");
  }
  return plan().pieceOf(whole, k);
}

// ---------------------------------------------------------------------------------- the visits

void JobTiles::refuseFault(const TilePoints& given, const Context& context) const
{
  const char* fault = nullptr;
  check(visits().findFault(given, context, fault));
  if (fault)
  {
    refuse(Reason::BadArray, fault);
  }
}

void JobTiles::visit(const GivenTile& tile, Representative representative, const Context& context)
{
  const OpenPoints opened(tile.points, context);
  const TilePoints given{ checkedLeaf(tile.leaf), opened.view, tile.ids };
  refuseFault(given, context);
  check(visits().visit(given, representative, context, output_));
}

namespace
{

std::size_t pointsOf(const std::vector<TileBorder>& borders)
{
  return std::accumulate(borders.begin(), borders.end(), std::size_t(0),
    [](std::size_t sum, const TileBorder& border) { return sum + border.border.points.size(); });
}

/// Of what was needed up to here, for borders with so many points.
[[noreturn]] void refuseMemory(const CheckedMemory& checked, std::size_t points)
{
  refuse(Reason::MemoryLimit,
    "Merging borders of " + std::to_string(points) + " points takes " +
      sizeInWords(checked.needed, Rounded::Up) + " of memory or more, and there are " +
      sizeInWords(checked.allowed, Rounded::Down) +
      ". Points along borders of leaves and along lines are at borders, and nearly all of those on "
      "a circle or a straight line, where most leaves need most of each other's points: larger "
      "leaves, or one run, take less.");
}

} // namespace

void JobTiles::merge(std::uint64_t node, const std::vector<GivenBytes>& borders,
  const MergeMemory& memory, const Context& context)
{
  if (node < plan().leaves() || node >= plan().parts())
  {
    refuse(Reason::BadValue,
      "Part " + std::to_string(node) + " is no node: these are " + std::to_string(plan().leaves()) +
        " to " + std::to_string(plan().root()) + ".");
  }
  std::vector<TileBorder> read;
  if (!visits().readBorders(static_cast<std::size_t>(node), viewsOf(borders), read))
  {
    refuse(Reason::BadArray, "These are not the borders of the parts that the node joins.");
  }
  constexpr std::size_t kBytesForEach = 250;
  const std::size_t points = pointsOf(read);
  CheckedMemory checked(memory.limit);
  Status merged = checked.need(kBytesForEach * points);
  if (merged == Status::Ok)
  {
    merged = checked.request(memory.asked,
      [&] { return visits().merge(static_cast<std::size_t>(node), read, context, output_); });
  }
  if (checked.isRefused)
  {
    refuseMemory(checked, points);
  }
  check(merged);
}

void JobTiles::readKept(std::size_t leaf, const TileView* own,
  const std::vector<GivenBytes>& shares, TileKept& kept) const
{
  if (!visits().readKept(leaf, own, viewsOf(shares), kept))
  {
    refuse(Reason::BadArray, "This is not what visits of the leaf and the nodes above it gave.");
  }
}

template <typename Make>
void JobTiles::secondVisit(
  const GivenTile& tile, const GivenKept& bytes, const Context& context, const Make& make)
{
  const OpenPoints opened(tile.points, context);
  const TilePoints given{ checkedLeaf(tile.leaf), opened.view, tile.ids };
  const TileView own = viewsOf({ bytes.own })[0];
  TileKept kept;
  readKept(given.leaf, &own, bytes.shares, kept);
  refuseFault(given, context);
  bool fits = false;
  check(visits().findFits(given, kept, context, fits));
  if (!fits)
  {
    refuse(Reason::BadArray, "This is not what a visit of these points gave.");
  }
  check(make(given, kept));
}

void JobTiles::makeTriangles(const GivenTile& tile, const GivenKept& bytes, const Context& context)
{
  secondVisit(tile, bytes, context,
    [&](const TilePoints& given, const TileKept& kept)
    { return visits().makeTriangles(given, kept, context, output_); });
}

void JobTiles::makeSurface(
  const GivenTile& tile, const GivenKept& bytes, double longest, const Context& context)
{
  secondVisit(tile, bytes, context,
    [&](const TilePoints& given, const TileKept& kept)
    { return visits().makeSurface(given, kept, longest, context, output_); });
}

void JobTiles::makeList(
  std::uint64_t leaf, const std::vector<GivenBytes>& shares, const Context& context)
{
  const std::size_t k = checkedLeaf(leaf);
  TileKept kept;
  readKept(k, nullptr, shares, kept);
  check(visits().makeList(k, kept, context, output_));
}

// ---------------------------------------------------------------------------------- the arrays

namespace
{

template <typename Number>
TileArray arrayOf(const std::vector<Number>& list, NumberType type, std::size_t columns)
{
  return { type, list.size() / columns, columns, list.data() };
}

struct TileRow
{
  const char* name;
  TileArray (*array)(const JobTiles& tiles);
};
constexpr TileRow kTileRows[] = {
  { "tiles_plan", [](const JobTiles& t) { return arrayOf(t.tables().plan, kUint8, 1); } },
  { "tiles_counts", [](const JobTiles& t) { return arrayOf(t.tables().counts, kInt64, 1); } },
  { "tiles_boxes", [](const JobTiles& t) { return arrayOf(t.tables().boxes, kFloat64, 4); } },
  { "tiles_parents", [](const JobTiles& t) { return arrayOf(t.tables().parents, kInt64, 1); } },
  { "tiles_bounds", [](const JobTiles& t) { return arrayOf(t.tables().bounds, kFloat64, 2); } },
  { "tiles_border", [](const JobTiles& t) { return arrayOf(t.output().border, kUint8, 1); } },
  { "tiles_own", [](const JobTiles& t) { return arrayOf(t.output().own, kUint8, 1); } },
  { "tiles_share", [](const JobTiles& t) { return arrayOf(t.output().share, kUint8, 1); } },
  { "tiles_triangles", [](const JobTiles& t) { return arrayOf(t.output().triangles, kInt64, 3); } },
  { "tiles_edges", [](const JobTiles& t) { return arrayOf(t.output().edges, kUint8, 1); } },
  { "tiles_list_points",
    [](const JobTiles& t) { return arrayOf(t.output().listPoints, kFloat64, 2); } },
  { "tiles_list_ids", [](const JobTiles& t) { return arrayOf(t.output().listIds, kInt64, 1); } },
  { "tiles_surface", [](const JobTiles& t) { return arrayOf(t.output().surface, kInt64, 3); } },
  { "tiles_surface_edges",
    [](const JobTiles& t) { return arrayOf(t.output().surfaceEdges, kUint8, 1); } },
  { "tiles_constraints",
    [](const JobTiles& t) { return arrayOf(t.output().constraints, kInt64, 1); } },
};

} // namespace

TileArray tileArray(Job& job, const char* name)
{
  for (const TileRow& row : kTileRows)
  {
    if (name && std::strcmp(row.name, name) == 0)
    {
      job.tiles().plan(); // or it is refused
      return row.array(job.tiles());
    }
  }
  return { kUint8, 0, 0, nullptr };
}

const char* tileArrayName(std::size_t number)
{
  return number < std::size(kTileRows) ? kTileRows[number].name : nullptr;
}

} // namespace ahd
