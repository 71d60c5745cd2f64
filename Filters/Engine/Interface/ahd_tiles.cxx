// SPDX-License-Identifier: BSD-3-Clause
//
// The part of the C interface for more points than memory holds.
#include "ahd_tiles.h"

#include "Call.h"

#include <algorithm>

using namespace ahd::calls;

namespace
{

std::vector<ahd::GivenBytes> bytesOf(const ahd_bytes* given, uint64_t count)
{
  if (count > 0)
  {
    mustHave(given, "bytes");
  }
  ahd::checkCount(count, "bytes");
  std::vector<ahd::GivenBytes> bytes;
  for (uint64_t k = 0; k < count; ++k)
  {
    bytes.push_back({ given[k].data, given[k].size });
  }
  return bytes;
}

ahd::GivenTile tileOf(uint64_t leaf, const ahd_array* points, const int64_t* ids)
{
  mustHave(points, "points");
  return { leaf, ahd::arrayOf(*points), ids };
}

ahd::GivenKept keptOf(const ahd_bytes* own, const ahd_bytes* shares, uint64_t count)
{
  return { bytesOf(own, 1)[0], bytesOf(shares, count) };
}

struct LineCounts
{
  uint64_t lines, chains;
  int32_t rule;
};

ahd::TileLines linesOf(const double* xy, const int64_t* offsets, const LineCounts& counts)
{
  ahd::TileLines lines;
  if (counts.chains == 0)
  {
    return lines;
  }
  mustHave(offsets, "offsets");
  ahd::checkCount(counts.chains, "chains");
  if (counts.lines > counts.chains || counts.rule < AHD_FILL_ORIENTATION ||
    counts.rule > AHD_FILL_EVEN_ODD)
  {
    ahd::refuse(ahd::Reason::BadValue, "More lines than chains, or no rule to fill by.");
  }
  const uint64_t count = counts.chains + 1;
  if (offsets[0] != 0 || !std::is_sorted(offsets, offsets + count))
  {
    ahd::refuse(ahd::Reason::BadArray, "The offsets of chains do not ascend from 0.");
  }
  const auto corners = uint64_t(offsets[counts.chains]);
  mustHave(corners == 0 ? offsets : static_cast<const void*>(xy), "corners");
  ahd::checkCount(corners, "corners");
  for (uint64_t k = 0; k < corners; ++k)
  {
    lines.corners.push_back({ xy[2 * k], xy[2 * k + 1] });
  }
  lines.offsets.assign(offsets, offsets + count);
  lines.lines = counts.lines;
  lines.rule = uint64_t(counts.rule);
  return lines;
}

ahd::Representative representativeOf(const ahd::Job& own)
{
  const auto wished = ahd::Duplicates(own.settings[ahd::IntSetting::Duplicates]);
  if (wished == ahd::Duplicates::MeanZ)
  {
    ahd::refuse(ahd::Reason::BadValue, "Tiles have no AHD_DUPLICATES_MEAN_Z.");
  }
  return ahd::Representative(wished);
}

} // namespace

ahd_status ahd_tiles_begin(ahd_job* job, const double bounds[4])
{
  return call(job, [=](ahd::Job& own) { own.tiles().begin(bounds); });
}

ahd_status ahd_tiles_count(ahd_job* job, const ahd_array* points)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(points, "points");
      own.apart(
        [&](const ahd::Context& context) { own.tiles().count(ahd::arrayOf(*points), context); });
    });
}

ahd_status ahd_tiles_plan(ahd_job* job, uint64_t most, const double extent[4], int32_t* again)
{
  return give(job, again, "again",
    [=](ahd::Job& own) { return int32_t(own.tiles().endPass(most, extent) ? 1 : 0); });
}

ahd_status ahd_tiles_load(ahd_job* job, const void* plan, uint64_t size)
{
  return call(job, [=](ahd::Job& own) { own.tiles().load({ plan, size }); });
}

ahd_status ahd_tiles_get_facts(ahd_job* job, ahd_tiles_facts* facts)
{
  return give(job, facts, "facts",
    [](ahd::Job& own)
    {
      const ahd::TilePlan& plan = own.tiles().plan();
      uint64_t most = 0;
      for (std::size_t k = 0; k < plan.leaves(); ++k)
      {
        most = std::max<uint64_t>(most, plan.leaf(k).count);
      }
      return ahd_tiles_facts{ plan.facts().points, plan.facts().notFinite, plan.leaves(),
        plan.parts() - plan.leaves(), most };
    });
}

ahd_status ahd_tiles_leaf_of(ahd_job* job, const ahd_array* points, int32_t* leaves)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(points, "points");
      if (points->rows > 0)
      {
        mustHave(leaves, "leaves");
      }
      own.apart([&](const ahd::Context& context)
        { own.tiles().findLeaves(ahd::arrayOf(*points), leaves, context); });
    });
}

ahd_status ahd_tiles_cells(ahd_job* job, uint64_t leaf, const ahd_places* raster, uint64_t piece[4])
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(raster, "raster");
      mustHave(piece, "piece");
      const ahd::SampleRaster found = own.tiles().piece(
        leaf, ahd::wholeRaster(ahd::placesOf(*raster)));
      const std::size_t numbers[] = { found.firstColumn, found.firstRow, found.columns,
        found.rows };
      std::copy(numbers, numbers + 4, piece);
    });
}

ahd_status ahd_tiles_lines(ahd_job* job, const double* xy, const int64_t* offsets, uint64_t lines,
  uint64_t chains, int32_t fill_rule)
{
  return call(job,
    [=](ahd::Job& own) {
      own.tiles().setLines(linesOf(xy, offsets, { lines, chains, fill_rule }));
    });
}

ahd_status ahd_tiles_visit(ahd_job* job, uint64_t leaf, const ahd_array* points, const int64_t* ids)
{
  return call(job,
    [=](ahd::Job& own)
    {
      const ahd::GivenTile tile = tileOf(leaf, points, ids);
      own.visitTiles([&](const ahd::Context& context)
        { own.tiles().visit(tile, representativeOf(own), context); });
    });
}

ahd_status ahd_tiles_merge(ahd_job* job, uint64_t node, const ahd_bytes* borders, uint64_t count)
{
  return call(job,
    [=](ahd::Job& own)
    {
      const auto given = bytesOf(borders, count);
      const auto limit = std::size_t(own.settings[ahd::IntSetting::MemoryLimit]);
      own.visitTiles(
        [&](const ahd::Context& context) {
          own.tiles().merge(node, given, { limit, own.progress.asked() }, context);
        });
    });
}

ahd_status ahd_tiles_triangles(ahd_job* job, uint64_t leaf, const ahd_array* points,
  const int64_t* ids, const ahd_bytes* own_bytes, const ahd_bytes* shares, uint64_t count)
{
  return call(job,
    [=](ahd::Job& own)
    {
      const ahd::GivenTile tile = tileOf(leaf, points, ids);
      const ahd::GivenKept kept = keptOf(own_bytes, shares, count);
      own.visitTiles(
        [&](const ahd::Context& context) { own.tiles().makeTriangles(tile, kept, context); });
    });
}

ahd_status ahd_tiles_list(ahd_job* job, uint64_t leaf, const ahd_bytes* shares, uint64_t count)
{
  return call(job,
    [=](ahd::Job& own)
    {
      const auto given = bytesOf(shares, count);
      own.visitTiles(
        [&](const ahd::Context& context) { own.tiles().makeList(leaf, given, context); });
    });
}

ahd_status ahd_tiles_surface(ahd_job* job, uint64_t leaf, const ahd_array* points,
  const int64_t* ids, const ahd_bytes* own_bytes, const ahd_bytes* shares, uint64_t count)
{
  return call(job,
    [=](ahd::Job& own)
    {
      const ahd::GivenTile tile = tileOf(leaf, points, ids);
      const ahd::GivenKept kept = keptOf(own_bytes, shares, count);
      const double longest = own.settings[ahd::DoubleSetting::MaximumEdgeLength];
      own.visitTiles([&](const ahd::Context& context)
        { own.tiles().makeSurface(tile, kept, longest, context); });
    });
}
