// SPDX-License-Identifier: BSD-3-Clause
//
// Output arrays that are copies of what the engine has: boxes, Voronoi cells, points that were
// merged or added, segments that cross.
#include "Writers.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace ahd
{
Status writeBoxBounds(JobResult& m, const Target& to)
{
  return forEach(m.triangulation.boxes().size(), to.context,
    [&](std::size_t i)
    {
      const GridBox& box = m.triangulation.boxes()[i];
      const double bounds[] = { box.xmin, box.xmax, box.ymin, box.ymax };
      std::copy(std::begin(bounds), std::end(bounds), to.doubles() + 4 * i);
    });
}

Status writeBoxLevels(JobResult& m, const Target& to)
{
  return fillIds(m.triangulation.boxes().size(), to,
    [&m](std::size_t i) { return m.triangulation.boxes()[i].level; });
}

Status writeBoxCounts(JobResult& m, const Target& to)
{
  return fillIds(m.triangulation.boxes().size(), to,
    [&m](std::size_t i) { return m.triangulation.boxes()[i].count; });
}

Status writeVoronoiPoints(JobResult& m, const Target& to)
{
  return fillDoubles(2 * m.voronoi.points.size(), to,
    [&m](std::size_t i)
    { return i % 2 == 0 ? m.voronoi.points[i / 2].x : m.voronoi.points[i / 2].y; });
}

Status writeVoronoiOffsets(JobResult& m, const Target& to)
{
  const Buffer<std::int32_t>& offsets = m.voronoi.offsets;
  return fillIds(m.voronoi.sites.size() + 1, to,
    [&](std::size_t i) { return offsets.empty() ? 0 : offsets[i]; }); // without cells the first
}

Status writeVoronoiCorners(JobResult& m, const Target& to)
{
  return fillIds(
    m.voronoi.corners.size(), to, [&m](std::size_t i) { return m.voronoi.corners[i]; });
}

Status writeVoronoiSites(JobResult& m, const Target& to)
{
  return fillIds(m.voronoi.sites.size(), to, [&m](std::size_t i) { return m.voronoi.sites[i]; });
}

Status writeMerged(JobResult& m, const Target& to)
{
  return fillIds(2 * m.points.merged().size(), to,
    [&m](std::size_t i)
    {
      const MergedPoint& pair = m.points.merged()[i / 2];
      return i % 2 == 0 ? pair.id : pair.keptId;
    });
}

Status writeSurfaceCorners(JobResult& m, const Target& to)
{
  return fillIds(3 * m.points.surfacePlaces().size(), to,
    [&m](std::size_t i) { return m.points.surfacePlaces()[i / 3].corners[i % 3]; });
}

Status writeSurfaceWeights(JobResult& m, const Target& to)
{
  return fillDoubles(3 * m.points.surfacePlaces().size(), to,
    [&m](std::size_t i) { return m.points.surfacePlaces()[i / 3].weights[i % 3]; });
}

Status writeCrossingEnds(JobResult& m, const Target& to)
{
  return fillIds(4 * m.points.crossings().size(), to,
    [&m](std::size_t i) { return m.points.crossings()[i / 4].ends[i % 4]; });
}

Status writeCrossingFractions(JobResult& m, const Target& to)
{
  return fillDoubles(2 * m.points.crossings().size(), to,
    [&m](std::size_t i) { return m.points.crossings()[i / 2].along[i % 2]; });
}

Status writeCrossingCells(JobResult& m, const Target& to)
{
  return fillIds(
    2 * m.crossingRows(), to, [&m](std::size_t i) { return m.crossingRow(i / 2)[i % 2]; });
}

Status writeLeftOut(JobResult& m, const Target& to)
{
  const std::vector<LeftOut>& all = m.triangulation.constraints().leftOut;
  return fillIds(4 * all.size(), to,
    [&](std::size_t i)
    {
      const LeftOut& out = all[i / 4];
      return i % 4 == 0 ? m.points.cellOf(out.chain)
        : i % 4 == 1    ? std::int64_t(out.segment)
        : i % 4 == 2    ? m.points.cellOf(out.otherChain)
                        : std::int64_t(out.otherSegment);
    });
}

} // namespace ahd
