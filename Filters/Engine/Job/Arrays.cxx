// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"
#include "Refusal.h"
#include "WantedArrays.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

namespace ahd
{
namespace
{

using Made = JobResult;

constexpr unsigned kDouble = bitOf(kFloat64);

// --- Writing ---

struct Target : ArrayTarget
{
  std::size_t numbers;
};

/// Calls write(i) for all i in [0, count), on all threads.
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

/// Writes value(i) to place i, for all numbers.
template <typename Value>
Status fillIds(const Target& to, const Value& value)
{
  return withIds(to,
    [&](auto* ids)
    {
      using Id = std::remove_pointer_t<decltype(ids)>;
      return forEach(
        to.numbers, to.context, [&](std::size_t i) { ids[i] = static_cast<Id>(value(i)); });
    });
}

template <typename Value>
Status fillDoubles(const Target& to, const Value& value)
{
  return forEach(to.numbers, to.context, [&](std::size_t i) { to.doubles()[i] = value(i); });
}

/// A list as it is.
template <typename List>
Status copyIds(const Target& to, const List& list)
{
  return fillIds(to, [&list](std::size_t i) { return list[i]; });
}

// --- Rows of more than one line ---

Status writePoints(Made& m, const Target& to)
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

Status writePlanePoints(Made& m, const Target& to)
{
  const PointView& points = m.points.points();
  return forEach(points.count, to.context,
    [&](std::size_t i)
    {
      const std::array<double, 3> p = points.place(i);
      std::copy(p.begin(), p.end(), to.doubles() + 3 * i);
    });
}

Status writeVertexOfPoint(Made& m, const Target& to)
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
  const Status written = fillIds(to, vertexOf);
  return written != Status::Ok ? written
                               : withIds(to,
                                   [&m](auto* ids)
                                   {
                                     m.followMerged(ids);
                                     return Status::Ok;
                                   });
}

Status writeVertexBounds(Made& m, const Target& to)
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

Status writePlaneMatrix(Made& m, const Target& to)
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

std::int64_t leftOutNumber(const Made& m, std::size_t i)
{
  const LeftOut& out = m.triangulation.constraints().leftOut[i / 4];
  return i % 4 == 0 ? m.points.cellOf(out.chain)
    : i % 4 == 1    ? std::int64_t(out.segment)
    : i % 4 == 2    ? m.points.cellOf(out.otherChain)
                    : std::int64_t(out.otherSegment);
}

double boxNumber(const Made& m, std::size_t i)
{
  const GridBox& box = m.triangulation.boxes()[i / 4];
  return i % 4 == 0 ? box.xmin : i % 4 == 1 ? box.xmax : i % 4 == 2 ? box.ymin : box.ymax;
}

// --- The table ---

/// The setting that an array requires before the run.
struct Need
{
  const char* what; ///< null: nothing
  bool (*isThere)(const Made&);
};
constexpr Need kNothing = { nullptr, nullptr };
constexpr Need kOrder = { "\"want_order\" before the run",
  [](const Made& m) { return m.asked.options.keepOrder; } };
constexpr Need kBoxes = { "\"want_boxes\" before the run",
  [](const Made& m) { return m.asked.options.keepBoxes; } };
constexpr Need kCells = { "\"want_voronoi\" before the run",
  [](const Made& m) { return m.asked.voronoi; } };
constexpr Need kMatrix = { "another \"plane\" before the run",
  [](const Made& m) { return m.asked.plane != PlaneKind::Callback; } };
constexpr Need kWeights = { "ahd_sample_weights()",
  [](const Made& m) { return m.sampling.hasWeights; } };

struct OutputRow
{
  const char* name;
  unsigned types;
  std::size_t columns;
  std::size_t (*rows)(const Made&);
  Status (*write)(Made&, const Target&);
  RunStage stage;
  Need need = kNothing;
};

std::size_t pointCount(const Made& m)
{
  return m.points.points().count;
}
std::size_t boxCount(const Made& m)
{
  return m.triangulation.boxes().size();
}
std::size_t crossingCount(const Made& m)
{
  return m.points.crossings().size();
}
std::size_t placeCount(const Made& m)
{
  return m.points.surfacePlaces().size();
}

constexpr OutputRow kOutputRows[] = {
  { "triangles", kIntegerTypes, 3, [](const Made& m) { return m.triangleCount(); },
    [](Made& m, const Target& to)
    { return withIds(to, [&](auto* ids) { return m.writeTriangles(ids, to.context); }); },
    kWritingCells },
  { "lines", kIntegerTypes, 2, [](const Made& m) { return m.selection.lines.size() / 2; },
    [](Made& m, const Target& to) { return copyIds(to, m.selection.lines); }, kWritingCells },
  { "vertices", kIntegerTypes, 1, [](const Made& m) { return m.selection.vertices.size(); },
    [](Made& m, const Target& to) { return copyIds(to, m.selection.vertices); }, kWritingCells },
  { "points", kRealTypes, 3, pointCount, writePoints, kWritingCells },
  { "plane_points", kDouble, 3, pointCount, writePlanePoints, kWritingCells },
  { "heights", kDouble, 1, pointCount,
    [](Made& m, const Target& to) {
      return findHeights(m.points, m.triangulation, m.asked.showsMeans, to.context, to.doubles());
    },
    kWritingCells },
  { "plane_matrix", kDouble, 4, [](const Made&) { return std::size_t(4); }, writePlaneMatrix,
    kWritingCells, kMatrix },
  { "vertex_of_point", kIntegerTypes, 1, pointCount, writeVertexOfPoint, kWritingArrays },
  { "point_of_vertex", kIntegerTypes, 1,
    [](const Made& m) { return m.triangulation.vertexCount(); },
    [](Made& m, const Target& to)
    {
      return fillIds(
        to, [&m](std::size_t i) { return m.triangulation.pointOf(static_cast<Index>(i)); });
    },
    kWritingArrays },
  { "vertex_bounds", kDouble, 2, [](const Made&) { return std::size_t(2); }, writeVertexBounds,
    kWritingArrays },
  { "order", kIntegerTypes, 1, [](const Made& m) { return m.triangulation.report().inserted; },
    [](Made& m, const Target& to)
    { return withIds(to, [&](auto* ids) { return m.triangulation.writeOrder(ids, to.context); }); },
    kWritingArrays, kOrder },
  { "box_bounds", kDouble, 4, boxCount,
    [](Made& m, const Target& to)
    { return fillDoubles(to, [&m](std::size_t i) { return boxNumber(m, i); }); },
    kWritingArrays, kBoxes },
  { "box_levels", bitOf(kInt32), 1, boxCount,
    [](Made& m, const Target& to)
    { return fillIds(to, [&m](std::size_t i) { return m.triangulation.boxes()[i].level; }); },
    kWritingArrays, kBoxes },
  { "box_counts", kIntegerTypes, 1, boxCount,
    [](Made& m, const Target& to)
    { return fillIds(to, [&m](std::size_t i) { return m.triangulation.boxes()[i].count; }); },
    kWritingArrays, kBoxes },
  { "voronoi_points", kDouble, 2, [](const Made& m) { return m.voronoi.points.size(); },
    [](Made& m, const Target& to)
    {
      return fillDoubles(to,
        [&m](std::size_t i)
        { return i % 2 == 0 ? m.voronoi.points[i / 2].x : m.voronoi.points[i / 2].y; });
    },
    kWritingVoronoi, kCells },
  { "voronoi_offsets", kIntegerTypes, 1, [](const Made& m) { return m.voronoi.sites.size() + 1; },
    [](Made& m, const Target& to)
    {
      return fillIds(
        to, [&m](std::size_t i) { return m.voronoi.offsets.empty() ? 0 : m.voronoi.offsets[i]; });
    },
    kWritingVoronoi, kCells },
  { "voronoi_corners", kIntegerTypes, 1, [](const Made& m) { return m.voronoi.corners.size(); },
    [](Made& m, const Target& to) { return copyIds(to, m.voronoi.corners); }, kWritingVoronoi,
    kCells },
  { "voronoi_sites", kIntegerTypes, 1, [](const Made& m) { return m.voronoi.sites.size(); },
    [](Made& m, const Target& to) { return copyIds(to, m.voronoi.sites); }, kWritingVoronoi,
    kCells },
  { "merged", kIntegerTypes, 2, [](const Made& m) { return m.points.merged().size(); },
    [](Made& m, const Target& to)
    {
      return fillIds(to,
        [&m](std::size_t i)
        { return i % 2 == 0 ? m.points.merged()[i / 2].id : m.points.merged()[i / 2].keptId; });
    },
    kWritingArrays },
  { "surface_corners", kIntegerTypes, 3, placeCount,
    [](Made& m, const Target& to)
    {
      return fillIds(
        to, [&m](std::size_t i) { return m.points.surfacePlaces()[i / 3].corners[i % 3]; });
    },
    kWritingArrays },
  { "surface_weights", kDouble, 3, placeCount,
    [](Made& m, const Target& to)
    {
      return fillDoubles(
        to, [&m](std::size_t i) { return m.points.surfacePlaces()[i / 3].weights[i % 3]; });
    },
    kWritingArrays },
  { "crossing_ends", kIntegerTypes, 4, crossingCount,
    [](Made& m, const Target& to) {
      return fillIds(to, [&m](std::size_t i) { return m.points.crossings()[i / 4].ends[i % 4]; });
    },
    kWritingArrays },
  { "crossing_fractions", kDouble, 2, crossingCount,
    [](Made& m, const Target& to)
    {
      return fillDoubles(
        to, [&m](std::size_t i) { return m.points.crossings()[i / 2].along[i % 2]; });
    },
    kWritingArrays },
  { "crossing_cells", kIntegerTypes, 2, [](const Made& m) { return m.crossingRows(); },
    [](Made& m, const Target& to)
    { return fillIds(to, [&m](std::size_t i) { return m.crossingRow(i / 2)[i % 2]; }); },
    kWritingArrays },
  { "left_out", kIntegerTypes, 4,
    [](const Made& m) { return m.triangulation.constraints().leftOut.size(); },
    [](Made& m, const Target& to)
    { return fillIds(to, [&m](std::size_t i) { return leftOutNumber(m, i); }); },
    kWritingArrays },
  { "weight_offsets", bitOf(kInt64), 1,
    [](const Made& m) { return m.sampling.weights.offsets.size(); },
    [](Made& m, const Target& to) { return copyIds(to, m.sampling.weights.offsets); },
    kWritingArrays, kWeights },
  { "weight_points", kIntegerTypes, 1,
    [](const Made& m) { return m.sampling.weights.points.size(); },
    [](Made& m, const Target& to) { return copyIds(to, m.sampling.weights.points); },
    kWritingArrays, kWeights },
  { "weights", kDouble, 1, [](const Made& m) { return m.sampling.weights.weights.size(); },
    [](Made& m, const Target& to)
    { return fillDoubles(to, [&m](std::size_t i) { return m.sampling.weights.weights[i]; }); },
    kWritingArrays, kWeights },
};

template <std::size_t number>
constexpr OutputRow wantedRow()
{
  constexpr WantedArray kArray = WantedArray(number);
  constexpr const WantedRow& kRow = kWantedRows[number];
  return { kRow.name, kRow.type == kInt64 ? kIntegerTypes : bitOf(kRow.type), kRow.columns,
    [](const Made& m) { return rowsOf(kArray, m); },
    [](Made& m, const Target& to) { return ahd::writeArray(kArray, m, to); }, kWritingArrays,
    needsOrder(kArray) ? kOrder : kNothing };
}

template <std::size_t... numbers>
constexpr std::array<OutputRow, kWantedArrays> wantedRows(std::index_sequence<numbers...>)
{
  return { { wantedRow<numbers>()... } };
}

constexpr auto kRowsOfWanted = wantedRows(std::make_index_sequence<kWantedArrays>());

/// Null after the last.
const OutputRow* rowAt(std::size_t number)
{
  const std::size_t others = std::size(kOutputRows);
  return number < others              ? &kOutputRows[number]
    : number - others < kWantedArrays ? &kRowsOfWanted[number - others]
                                      : nullptr;
}

const OutputRow& rowOf(Job& job, const char* name)
{
  const OutputRow* row = nullptr;
  for (std::size_t i = 0; (row = rowAt(i)) && !(name && std::strcmp(row->name, name) == 0); ++i)
  {
  }
  if (!row)
  {
    refuse(Reason::UnknownName,
      "There is no output array \"" + std::string(name ? name : "(null)") + "\".");
  }
  const JobResult& made = job.result();
  if (row->need.what && !row->need.isThere(made))
  {
    refuse(Reason::NotAvailable,
      "There is no \"" + std::string(name) + "\" without " + row->need.what + ".");
  }
  return *row;
}

} // namespace

ArrayShape shapeOf(Job& job, const char* name)
{
  if (const std::vector<Index>* list = outlineList(job, name))
  {
    return { list->size(), 1 };
  }
  if (const TileArray array = tileArray(job, name); array.columns != 0)
  {
    return { array.rows, array.columns };
  }
  const OutputRow& row = rowOf(job, name);
  return { row.rows(job.result()), row.columns };
}

void writeArray(Job& job, const char* name, std::int32_t type, void* out, std::uint64_t capacity)
{
  const std::vector<Index>* const list = outlineList(job, name);
  const TileArray tiles = list ? TileArray{} : tileArray(job, name);
  const bool isTiles = tiles.columns != 0;
  const OutputRow* const row = list || isTiles ? nullptr : &rowOf(job, name);
  const std::size_t numbers = list ? list->size()
    : isTiles                      ? tiles.rows * tiles.columns
                                   : row->rows(job.result()) * row->columns;
  const unsigned types = list ? kIntegerTypes : isTiles ? bitOf(tiles.type) : row->types;
  if ((bitOf(type) & types) == 0)
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
  if (isTiles)
  {
    std::memcpy(out, tiles.data, numbers * (tiles.type == kUint8 ? 1 : 8));
    return;
  }
  if (list)
  {
    check(copyIds({ { type, out, Context() }, numbers }, *list));
    return;
  }
  JobResult& made = job.result();
  made.sampling.forget();
  job.progress.reach(row->stage);
  job.withThreads(
    [&](const Context& context) {
      check(row->write(made, { { type, out, context }, numbers }));
    });
}

const char* outputArrayName(std::size_t number)
{
  const OutputRow* const row = rowAt(number);
  const std::size_t others = row ? 0 : number - std::size(kOutputRows) - kWantedArrays;
  return row                  ? row->name
    : others < kOutlineArrays ? outlineArrayName(others)
                              : tileArrayName(others - kOutlineArrays);
}

} // namespace ahd
