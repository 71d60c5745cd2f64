// SPDX-License-Identifier: BSD-3-Clause
#include "JobArrays.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "../Surface/CellArrays.h"
#include "Refusal.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>

namespace ahd
{
namespace
{

/// Where an array is to be written, and as what.
struct Target
{
  std::int32_t type;
  void* out;
  const Context& context;

  double* doubles() const { return static_cast<double*>(out); }
};

constexpr unsigned bitOf(std::int32_t type)
{
  return 1u << type;
}
constexpr unsigned kId = bitOf(AHD_INT32) | bitOf(AHD_INT64);
constexpr unsigned kReal = bitOf(AHD_FLOAT32) | bitOf(AHD_FLOAT64);
constexpr unsigned kDouble = bitOf(AHD_FLOAT64);
constexpr std::size_t kMostCrossingRows = 1000;

/// Calls work(pointer to ids of the type).
template <typename Work>
Status withIds(const Target& to, const Work& work)
{
  return to.type == AHD_INT32 ? work(static_cast<std::int32_t*>(to.out))
                              : work(static_cast<std::int64_t*>(to.out));
}

/// Calls write(i) for all i in [0, count), on the threads there are.
template <typename Write>
Status forEach(std::size_t count, const Context& context, const Write& write)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      return inChunksOf(count, ticker,
        [&write](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            write(i);
          }
        });
    });
}

/// Writes value(i) to place i, for all i in [0, count).
template <typename Value>
Status fillIds(std::size_t count, const Target& to, const Value& value)
{
  return withIds(to,
    [&](auto* ids)
    {
      using Id = std::remove_pointer_t<decltype(ids)>;
      return forEach(count, to.context, [&](std::size_t i) { ids[i] = static_cast<Id>(value(i)); });
    });
}

template <typename Value>
Status fillDoubles(std::size_t count, const Target& to, const Value& value)
{
  return forEach(count, to.context, [&](std::size_t i) { to.doubles()[i] = value(i); });
}

// --- What each array is ---

Status writeTriangles(JobResult& m, const Target& to)
{
  return withIds(to,
    [&](auto* ids)
    {
      return m.isSelected ? writeSelected(m.triangulation, m.selection, ids, to.context)
                          : m.triangulation.writeTriangles(ids, to.context);
    });
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
  const PointView& points = m.spacePoints(to.context);
  const auto write = [&points](auto* xyz, std::size_t i)
  {
    using Number = std::remove_pointer_t<decltype(xyz)>;
    const std::array<double, 3> p = points.place(i);
    for (std::size_t k = 0; k < 3; ++k)
    {
      xyz[3 * i + k] = static_cast<Number>(p[k]);
    }
  };
  auto* const floats = static_cast<float*>(to.out);
  return forEach(points.count, to.context,
    [&](std::size_t i) { to.type == AHD_FLOAT32 ? write(floats, i) : write(to.doubles(), i); });
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

Status writePlaneMatrix(JobResult& m, const Target& to)
{
  const std::int64_t plane = m.settings[IntSetting::Plane];
  if (plane == AHD_PLANE_MATRIX)
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
  return withIds(to,
    [&](auto* ids)
    {
      const Status status = m.triangulation.writePointStatus(ids, to.context);
      if (status == Status::Ok)
      {
        for (const MergedPoint& merged : m.points.merged())
        {
          ids[merged.id] = ids[merged.keptId];
        }
      }
      return status;
    });
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
                                     for (const MergedPoint& merged : m.points.merged())
                                     {
                                       ids[merged.id] = ids[merged.keptId];
                                     }
                                     return Status::Ok;
                                   });
}

Status writePointOfVertex(JobResult& m, const Target& to)
{
  return fillIds(m.triangulation.vertexCount(), to,
    [&m](std::size_t i) { return m.triangulation.pointOf(static_cast<Index>(i)); });
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

template <std::vector<std::int32_t> VoronoiCells::*part>
Status writeVoronoiPart(JobResult& m, const Target& to)
{
  const std::vector<std::int32_t>& numbers = m.voronoi.*part;
  // without cells there is not even the first offset
  const bool lacksFirst = numbers.empty() && part == &VoronoiCells::offsets;
  return fillIds(lacksFirst ? 1 : numbers.size(), to,
    [&](std::size_t i) { return lacksFirst ? 0 : numbers[i]; });
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

std::size_t crossingRows(const JobResult& m)
{
  return std::min(kMostCrossingRows,
    m.points.crossingCells().size() + m.triangulation.constraints().leftOut.size());
}

Status writeCrossingCells(JobResult& m, const Target& to)
{
  const std::size_t split = m.points.crossingCells().size();
  return fillIds(2 * crossingRows(m), to,
    [&](std::size_t i)
    {
      if (i / 2 < split)
      {
        return m.points.crossingCells()[i / 2][i % 2];
      }
      const LeftOut& out = m.triangulation.constraints().leftOut[i / 2 - split];
      return m.points.cellOf(i % 2 == 0 ? out.chain : out.otherChain);
    });
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

// --- The table ---

/// What is to be asked for before the run; empty if it was or need not be.
using Lack = std::string;

Lack lacksNothing(const JobResult&)
{
  return Lack();
}

Lack lacksOrder(const JobResult& m)
{
  return m.settings.options().keepOrder ? Lack() : "\"want_order\"";
}

Lack lacksBoxes(const JobResult& m)
{
  return m.settings.is(IntSetting::WantBoxes) ? Lack() : "\"want_boxes\"";
}

Lack lacksVoronoi(const JobResult& m)
{
  return m.settings.is(IntSetting::WantVoronoi) ? Lack() : "\"want_voronoi\"";
}

Lack lacksMatrix(const JobResult& m)
{
  return m.settings[IntSetting::Plane] == AHD_PLANE_CALLBACK ? "another \"plane\"" : Lack();
}

struct Row
{
  const char* name;
  unsigned types;
  std::size_t columns;
  std::size_t (*rows)(const JobResult&);
  Status (*write)(JobResult&, const Target&);
  Job::Stage stage;
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

constexpr auto kCells = Job::WritingCells;
constexpr auto kArrays = Job::WritingArrays;
constexpr auto kVoronoi = Job::WritingVoronoi;

constexpr Row kRows[] = {
  { "triangles", kId, 3, [](const JobResult& m) { return m.triangleCount(); }, writeTriangles,
    kCells, lacksNothing },
  { "lines", kId, 2, [](const JobResult& m) { return m.selection.lines.size() / 2; }, writeLines,
    kCells, lacksNothing },
  { "vertices", kId, 1, [](const JobResult& m) { return m.selection.vertices.size(); },
    writeVertices, kCells, lacksNothing },
  { "neighbors", kId, 3, cellCount, writeNeighborIds, kArrays, lacksNothing },
  { "constraint_edges", bitOf(AHD_UINT8), 1, cellCount, writeConstraintBits, kArrays,
    lacksNothing },
  { "regions", kId, 1, cellCount, writeRegionIds, kArrays, lacksNothing },
  { "points", kReal, 3, pointCount, writePoints, kCells, lacksNothing },
  { "plane_points", kDouble, 3, pointCount, writePlanePoints, kCells, lacksNothing },
  { "plane_matrix", kDouble, 4, [](const JobResult&) { return std::size_t(4); }, writePlaneMatrix,
    kCells, lacksMatrix },
  { "point_status", kId, 1, pointCount, writeStatus, kArrays, lacksNothing },
  { "vertex_of_point", kId, 1, pointCount, writeVertexOfPoint, kArrays, lacksNothing },
  { "point_of_vertex", kId, 1, [](const JobResult& m) { return m.triangulation.vertexCount(); },
    writePointOfVertex, kArrays, lacksNothing },
  { "order", kId, 1, [](const JobResult& m) { return m.triangulation.report().inserted; },
    writeOrder, kArrays, lacksOrder },
  { "insertion_ranks", kId, 1, pointCount, writeRanks, kArrays, lacksOrder },
  { "box_bounds", kDouble, 4, boxCount, writeBoxBounds, kArrays, lacksBoxes },
  { "box_levels", bitOf(AHD_INT32), 1, boxCount, writeBoxLevels, kArrays, lacksBoxes },
  { "box_counts", kId, 1, boxCount, writeBoxCounts, kArrays, lacksBoxes },
  { "voronoi_points", kDouble, 2, [](const JobResult& m) { return m.voronoi.points.size(); },
    writeVoronoiPoints, kVoronoi, lacksVoronoi },
  { "voronoi_offsets", kId, 1, [](const JobResult& m) { return m.voronoi.sites.size() + 1; },
    writeVoronoiPart<&VoronoiCells::offsets>, kVoronoi, lacksVoronoi },
  { "voronoi_corners", kId, 1, [](const JobResult& m) { return m.voronoi.corners.size(); },
    writeVoronoiPart<&VoronoiCells::corners>, kVoronoi, lacksVoronoi },
  { "voronoi_sites", kId, 1, [](const JobResult& m) { return m.voronoi.sites.size(); },
    writeVoronoiPart<&VoronoiCells::sites>, kVoronoi, lacksVoronoi },
  { "merged", kId, 2, [](const JobResult& m) { return m.points.merged().size(); }, writeMerged,
    kArrays, lacksNothing },
  { "surface_corners", kId, 3, placeCount, writeSurfaceCorners, kArrays, lacksNothing },
  { "surface_weights", kDouble, 3, placeCount, writeSurfaceWeights, kArrays, lacksNothing },
  { "crossing_ends", kId, 4, crossingCount, writeCrossingEnds, kArrays, lacksNothing },
  { "crossing_fractions", kDouble, 2, crossingCount, writeCrossingFractions, kArrays,
    lacksNothing },
  { "crossing_cells", kId, 2, crossingRows, writeCrossingCells, kArrays, lacksNothing },
  { "left_out", kId, 4,
    [](const JobResult& m) { return m.triangulation.constraints().leftOut.size(); }, writeLeftOut,
    kArrays, lacksNothing },
};

const Row& rowOf(Job& job, const char* name)
{
  const Row* const row = std::find_if(std::begin(kRows), std::end(kRows),
    [name](const Row& r) { return name && std::strcmp(r.name, name) == 0; });
  if (row == std::end(kRows))
  {
    refuse(AHD_UNKNOWN_NAME,
      "There is no output array \"" + std::string(name ? name : "(null)") + "\".");
  }
  const Lack lack = row->lacks(job.result());
  if (!lack.empty())
  {
    refuse(AHD_NOT_AVAILABLE,
      "There is no \"" + std::string(name) + "\" without " + lack + " before the run.");
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
  if (type < AHD_FLOAT32 || type > AHD_UINT8 || (bitOf(type) & row.types) == 0)
  {
    refuse(AHD_BAD_ARRAY,
      "\"" + std::string(name) + "\" cannot be written as type " + std::to_string(type) + ".");
  }
  if (capacity < numbers || (numbers > 0 && !out))
  {
    refuse(AHD_BAD_ARRAY,
      "\"" + std::string(name) + "\" has " + std::to_string(numbers) +
        " numbers, and there is room for " + std::to_string(out ? capacity : 0) + ".");
  }
  if (numbers == 0)
  {
    return;
  }
  job.progress.reach(row.stage);
  job.withThreads([&](const Context& context) { check(row.write(made, { type, out, context })); });
}

const char* outputArrayName(std::size_t number)
{
  return number < std::size(kRows) ? kRows[number].name : nullptr;
}

} // namespace ahd
