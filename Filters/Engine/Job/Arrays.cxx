// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"

#include "../Surface/CellArrays.h"
#include "Refusal.h"
#include "Writers.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <string>

namespace ahd
{
namespace
{

constexpr unsigned bitOf(std::int32_t type)
{
  return 1u << type;
}
constexpr unsigned kId = bitOf(kInt32) | bitOf(kInt64);
constexpr unsigned kReal = bitOf(kFloat32) | bitOf(kFloat64);
constexpr unsigned kDouble = bitOf(kFloat64);

// --- What each array is ---

Status writeTriangles(JobResult& m, const Target& to)
{
  return withIds(to, [&](auto* ids) { return m.writeTriangles(ids, to.context); });
}

Status writeLines(JobResult& m, const Target& to)
{
  return fillIds(
    m.selection.lines.size(), to, [&m](std::size_t i) { return m.selection.lines[i]; });
}

Status writeVertices(JobResult& m, const Target& to)
{
  return fillIds(
    m.selection.vertices.size(), to, [&m](std::size_t i) { return m.selection.vertices[i]; });
}

Status writeNeighborIds(JobResult& m, const Target& to)
{
  return withIds(
    to, [&](auto* ids) { return writeNeighbors(m.triangulation, m.selection, ids, to.context); });
}

Status writeConstraintBits(JobResult& m, const Target& to)
{
  return writeConstraintEdges(
    m.triangulation, m.selection, static_cast<std::uint8_t*>(to.out), to.context);
}

Status writeRegionIds(JobResult& m, const Target& to)
{
  return withIds(
    to, [&](auto* ids) { return writeRegions(m.triangulation, m.selection, ids, to.context); });
}

Status writePoints(JobResult& m, const Target& to)
{
  auto* const floats = static_cast<float*>(to.out);
  const bool asFloats = to.type == kFloat32;
  SpacePoints::Lend<double> lendDoubles;
  SpacePoints::Lend<float> lendFloats;
  if (asFloats)
  {
    lendFloats = [floats](std::size_t) { return floats; };
  }
  else
  {
    lendDoubles = [&to](std::size_t) { return to.doubles(); };
  }
  SpacePoints space(lendDoubles, lendFloats);
  const PointView points = m.spacePoints(space, to.context);
  if (asFloats ? points.floats == floats : points.doubles == to.doubles())
  {
    return Status::Ok; // they were made there
  }
  const auto write = [&points](auto* xyz, std::size_t i)
  {
    using Number = std::remove_pointer_t<decltype(xyz)>;
    const std::array<double, 3> p = points.place(i);
    for (std::size_t k = 0; k < 3; ++k)
    {
      xyz[3 * i + k] = static_cast<Number>(p[k]);
    }
  };
  const Status status = forEach(points.count, to.context,
    [&](std::size_t i) { asFloats ? write(floats, i) : write(to.doubles(), i); });
  if (status == Status::Ok && !asFloats)
  {
    space.writeMeans(to.doubles());
  }
  return status;
}

Status writePlanePoints(JobResult& m, const Target& to)
{
  const PointView& points = m.points.points();
  return forEach(points.count, to.context,
    [&](std::size_t i)
    {
      const std::array<double, 3> p = points.place(i);
      std::copy(p.begin(), p.end(), to.doubles() + 3 * i);
    });
}

Status writeHeights(JobResult& m, const Target& to)
{
  return findHeights(m.points, m.triangulation, m.asked.showsMeans, to.context, to.doubles());
}

Status writePlaneMatrix(JobResult& m, const Target& to)
{
  if (m.asked.plane == PlaneKind::Matrix)
  {
    std::copy(m.matrix.begin(), m.matrix.end(), to.doubles());
  }
  else
  {
    writeMatrix(m.points.plane(), to.doubles()); // x, y where none was fitted
  }
  return Status::Ok;
}

Status writeStatus(JobResult& m, const Target& to)
{
  return withIds(to, [&](auto* ids) { return m.writeStatus(ids, to.context); });
}

Status writeVertexOfPoint(JobResult& m, const Target& to)
{
  const Status status = m.triangulation.makePointMap(to.context);
  if (status != Status::Ok)
  {
    return status;
  }
  const auto vertexOf = [&m](std::size_t i)
  {
    const Index vertex = m.triangulation.vertexOf(i);
    return vertex == kNoIndex ? std::int64_t(-1) : std::int64_t(vertex);
  };
  const Status written = fillIds(m.points.points().count, to, vertexOf);
  return written != Status::Ok ? written
                               : withIds(to,
                                   [&m](auto* ids)
                                   {
                                     m.followMerged(ids);
                                     return Status::Ok;
                                   });
}

Status writePointOfVertex(JobResult& m, const Target& to)
{
  return fillIds(m.triangulation.vertexCount(), to,
    [&m](std::size_t i) { return m.triangulation.pointOf(static_cast<Index>(i)); });
}

Status writeVertexBounds(JobResult& m, const Target& to)
{
  const PointView& points = m.points.points();
  const std::size_t count = m.triangulation.vertexCount();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Bounds box{ kInfinity, -kInfinity, kInfinity, -kInfinity };
  const Status status = unlessCancelled(
    [&]
    {
      Ticker ticker(to.context.progress, Phase::Outputs, 0);
      return inChunks(0, count, ticker,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            const Point p = points[m.triangulation.pointOf(static_cast<Index>(i))];
            box = { std::min(box.xmin, p.x), std::max(box.xmax, p.x), std::min(box.ymin, p.y),
              std::max(box.ymax, p.y) };
          }
        });
    });
  const double bounds[] = { box.xmin, box.xmax, box.ymin, box.ymax };
  std::fill_n(to.doubles(), 4, std::numeric_limits<double>::quiet_NaN());
  std::copy_n(bounds, count > 0 ? 4 : 0, to.doubles());
  return status;
}

Status writeOrder(JobResult& m, const Target& to)
{
  return withIds(to, [&](auto* ids) { return m.triangulation.writeOrder(ids, to.context); });
}

Status writeRanks(JobResult& m, const Target& to)
{
  return withIds(
    to, [&](auto* ids) { return m.triangulation.writeInsertionRanks(ids, to.context); });
}

Status writeWeightOffsets(JobResult& m, const Target& to)
{
  const Buffer<std::uint64_t>& offsets = m.sampling.weights.offsets;
  return fillIds(offsets.size(), to, [&offsets](std::size_t i) { return offsets[i]; });
}

Status writeWeightPoints(JobResult& m, const Target& to)
{
  const Buffer<std::int32_t>& points = m.sampling.weights.points;
  return fillIds(points.size(), to, [&points](std::size_t i) { return points[i]; });
}

Status writeWeights(JobResult& m, const Target& to)
{
  const Buffer<double>& weights = m.sampling.weights.weights;
  return fillDoubles(weights.size(), to, [&weights](std::size_t i) { return weights[i]; });
}

// --- The table ---

/// What is to be done first; empty if it was or need not be.
using Lack = std::string;

Lack lacksNothing(const JobResult&)
{
  return Lack();
}

Lack lacksOrder(const JobResult& m)
{
  return m.asked.options.keepOrder ? Lack() : "\"want_order\" before the run";
}

Lack lacksBoxes(const JobResult& m)
{
  return m.asked.options.keepBoxes ? Lack() : "\"want_boxes\" before the run";
}

Lack lacksVoronoi(const JobResult& m)
{
  return m.asked.voronoi ? Lack() : "\"want_voronoi\" before the run";
}

Lack lacksMatrix(const JobResult& m)
{
  return m.asked.plane == PlaneKind::Callback ? "another \"plane\" before the run" : Lack();
}

Lack lacksWeights(const JobResult& m)
{
  return m.sampling.hasWeights ? Lack() : "ahd_sample_weights()";
}

struct Row
{
  const char* name;
  unsigned types;
  std::size_t columns;
  std::size_t (*rows)(const JobResult&);
  Status (*write)(JobResult&, const Target&);
  RunStage stage;
  Lack (*lacks)(const JobResult&);
};

std::size_t pointCount(const JobResult& m)
{
  return m.points.points().count;
}

std::size_t boxCount(const JobResult& m)
{
  return m.triangulation.boxes().size();
}

std::size_t cellCount(const JobResult& m)
{
  return m.cellCount();
}

std::size_t crossingCount(const JobResult& m)
{
  return m.points.crossings().size();
}

std::size_t placeCount(const JobResult& m)
{
  return m.points.surfacePlaces().size();
}

constexpr auto kCells = kWritingCells;
constexpr auto kArrays = kWritingArrays;
constexpr auto kVoronoi = kWritingVoronoi;

constexpr Row kRows[] = {
  { "triangles", kId, 3, [](const JobResult& m) { return m.triangleCount(); }, writeTriangles,
    kCells, lacksNothing },
  { "lines", kId, 2, [](const JobResult& m) { return m.selection.lines.size() / 2; }, writeLines,
    kCells, lacksNothing },
  { "vertices", kId, 1, [](const JobResult& m) { return m.selection.vertices.size(); },
    writeVertices, kCells, lacksNothing },
  { "neighbors", kId, 3, cellCount, writeNeighborIds, kArrays, lacksNothing },
  { "constraint_edges", bitOf(kUint8), 1, cellCount, writeConstraintBits, kArrays, lacksNothing },
  { "regions", kId, 1, cellCount, writeRegionIds, kArrays, lacksNothing },
  { "points", kReal, 3, pointCount, writePoints, kCells, lacksNothing },
  { "plane_points", kDouble, 3, pointCount, writePlanePoints, kCells, lacksNothing },
  { "heights", kDouble, 1, pointCount, writeHeights, kCells, lacksNothing },
  { "plane_matrix", kDouble, 4, [](const JobResult&) { return std::size_t(4); }, writePlaneMatrix,
    kCells, lacksMatrix },
  { "point_status", kId, 1, pointCount, writeStatus, kArrays, lacksNothing },
  { "vertex_of_point", kId, 1, pointCount, writeVertexOfPoint, kArrays, lacksNothing },
  { "point_of_vertex", kId, 1, [](const JobResult& m) { return m.triangulation.vertexCount(); },
    writePointOfVertex, kArrays, lacksNothing },
  { "vertex_bounds", kDouble, 2, [](const JobResult&) { return std::size_t(2); }, writeVertexBounds,
    kArrays, lacksNothing },
  { "order", kId, 1, [](const JobResult& m) { return m.triangulation.report().inserted; },
    writeOrder, kArrays, lacksOrder },
  { "insertion_ranks", kId, 1, pointCount, writeRanks, kArrays, lacksOrder },
  { "box_bounds", kDouble, 4, boxCount, writeBoxBounds, kArrays, lacksBoxes },
  { "box_levels", bitOf(kInt32), 1, boxCount, writeBoxLevels, kArrays, lacksBoxes },
  { "box_counts", kId, 1, boxCount, writeBoxCounts, kArrays, lacksBoxes },
  { "voronoi_points", kDouble, 2, [](const JobResult& m) { return m.voronoi.points.size(); },
    writeVoronoiPoints, kVoronoi, lacksVoronoi },
  { "voronoi_offsets", kId, 1, [](const JobResult& m) { return m.voronoi.sites.size() + 1; },
    writeVoronoiOffsets, kVoronoi, lacksVoronoi },
  { "voronoi_corners", kId, 1, [](const JobResult& m) { return m.voronoi.corners.size(); },
    writeVoronoiCorners, kVoronoi, lacksVoronoi },
  { "voronoi_sites", kId, 1, [](const JobResult& m) { return m.voronoi.sites.size(); },
    writeVoronoiSites, kVoronoi, lacksVoronoi },
  { "merged", kId, 2, [](const JobResult& m) { return m.points.merged().size(); }, writeMerged,
    kArrays, lacksNothing },
  { "surface_corners", kId, 3, placeCount, writeSurfaceCorners, kArrays, lacksNothing },
  { "surface_weights", kDouble, 3, placeCount, writeSurfaceWeights, kArrays, lacksNothing },
  { "crossing_ends", kId, 4, crossingCount, writeCrossingEnds, kArrays, lacksNothing },
  { "crossing_fractions", kDouble, 2, crossingCount, writeCrossingFractions, kArrays,
    lacksNothing },
  { "crossing_cells", kId, 2, [](const JobResult& m) { return m.crossingRows(); },
    writeCrossingCells, kArrays, lacksNothing },
  { "left_out", kId, 4,
    [](const JobResult& m) { return m.triangulation.constraints().leftOut.size(); }, writeLeftOut,
    kArrays, lacksNothing },
  { "weight_offsets", bitOf(kInt64), 1,
    [](const JobResult& m) { return m.sampling.weights.offsets.size(); }, writeWeightOffsets,
    kArrays, lacksWeights },
  { "weight_points", kId, 1, [](const JobResult& m) { return m.sampling.weights.points.size(); },
    writeWeightPoints, kArrays, lacksWeights },
  { "weights", kDouble, 1, [](const JobResult& m) { return m.sampling.weights.weights.size(); },
    writeWeights, kArrays, lacksWeights },
};

const Row& rowOf(Job& job, const char* name)
{
  const Row* const row = std::find_if(std::begin(kRows), std::end(kRows),
    [name](const Row& r) { return name && std::strcmp(r.name, name) == 0; });
  if (row == std::end(kRows))
  {
    refuse(Reason::UnknownName,
      "There is no output array \"" + std::string(name ? name : "(null)") + "\".");
  }
  const Lack lack = row->lacks(job.result());
  if (!lack.empty())
  {
    refuse(Reason::NotAvailable, "There is no \"" + std::string(name) + "\" without " + lack + ".");
  }
  return *row;
}

} // namespace

ArrayShape shapeOf(Job& job, const char* name)
{
  const Row& row = rowOf(job, name);
  return { row.rows(job.result()), row.columns };
}

void writeArray(Job& job, const char* name, std::int32_t type, void* out, std::uint64_t capacity)
{
  const Row& row = rowOf(job, name);
  JobResult& made = job.result();
  const std::size_t numbers = row.rows(made) * row.columns;
  if (type < kFloat32 || type > kUint8 || (bitOf(type) & row.types) == 0)
  {
    refuse(Reason::BadArray,
      "\"" + std::string(name) + "\" cannot be written as type " + std::to_string(type) + ".");
  }
  if (capacity < numbers || (numbers > 0 && !out))
  {
    refuse(Reason::BadArray,
      "\"" + std::string(name) + "\" has " + std::to_string(numbers) +
        " numbers, and there is room for " + std::to_string(out ? capacity : 0) + ".");
  }
  if (numbers == 0)
  {
    return;
  }
  made.sampling.forget();
  job.progress.reach(row.stage);
  job.withThreads([&](const Context& context) { check(row.write(made, { type, out, context })); });
}

const char* outputArrayName(std::size_t number)
{
  return number < std::size(kRows) ? kRows[number].name : nullptr;
}

} // namespace ahd
