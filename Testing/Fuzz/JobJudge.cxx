// SPDX-License-Identifier: BSD-3-Clause
#include "JobJudge.h"

#include "Dice.h"
#include "JobRun.h"
#include "Judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace ahd
{
namespace fuzz
{
namespace
{

using test::JobRun;

constexpr std::size_t kMostForAnything = 1000; // points

/// The settings of an Options, by name.
void setOptions(JobRun& run, const Options& options)
{
  run.set("insertion_order", std::int64_t(options.order));
  run.set("control_points", std::int64_t(options.controlPoints));
  run.set("gene_rotation", std::int64_t(options.geneRotation));
  run.set("nmax", std::int64_t(options.nmax));
  run.set("count_work", std::int64_t(options.countWork));
  run.set("want_order", std::int64_t(options.keepOrder));
  run.set("want_boxes", std::int64_t(options.keepBoxes));
}

/// One for each bit.
void setFlags(JobRun& run, unsigned bits)
{
  for (const char* name : { "alpha_triangles", "alpha_lines", "alpha_vertices", "voronoi_clip",
         "want_constraint_edges", "want_insertion_ranks", "want_neighbors", "want_point_status",
         "want_regions", "want_errors" })
  {
    run.set(name, std::int64_t(bits & 1u));
    bits >>= 1;
  }
}

/// How lines get points. Segments are divided into some 20 parts at most.
void setLines(JobRun& run, unsigned bits, const std::vector<double>& xyz)
{
  double largest = 0.0;
  for (const double number : xyz)
  {
    largest = std::isfinite(number) ? std::max(largest, std::abs(number)) : largest;
  }
  run.set("zero_is_missing", std::int64_t(bits & 1u));
  run.set("lines_on_surface", std::int64_t(1u - (bits >> 1 & 1u)));
  run.set("maximum_segment_length", (bits & 4u) != 0 ? largest / 8.0 : 0.0);
}

/// Coordinates as values and weights, and points that stay.
void setNumbers(JobRun& run, const FuzzCase& given, const std::vector<double>& xyz)
{
  const auto rows = static_cast<std::int64_t>(xyz.size() / 3);
  const double* const numbers = xyz.data();
  const ahd_array arrays[] = { { numbers, AHD_FLOAT64, 1, rows, 3 * sizeof(double), 8 },
    { numbers + (rows > 0 ? 1 : 0), AHD_FLOAT64, 1, rows, 3 * sizeof(double), 8 },
    { given.head.data(), AHD_UINT8, 1, rows, 0, 1 } };
  const char* const names[] = { "values", "weights", "keep" };
  for (std::size_t k = 0; k < 3; ++k)
  {
    ahd_set_array(
      run.job(), names[k], (given.head[kRefusals] >> k & 1) != 0 ? &arrays[k] : nullptr);
  }
}

/// A surface of fewer points, in one case of two, without what excludes it.
void setSimplified(JobRun& run, const FuzzCase& given)
{
  const std::uint8_t bits = given.head[kShuffle], chosen = given.head[kMostBoxes];
  const bool isOn = (chosen & 2u) != 0 && bits >> 6 != AHD_DUPLICATES_MEAN_Z;
  run.set("maximum_error", isOn ? double(given.head[kMergeDistance]) : 0.0);
  run.set("maximum_vertices", isOn ? std::int64_t(chosen >> 4) : std::int64_t(0));
  run.set("second_pass", std::int64_t(chosen >> 2 & 1u));
  const bool limits = (bits >> 3 & 1u) != 0 && !isOn;
  run.set("alpha", limits ? double(given.head[kMergeDistance]) : 0.0);
  run.set("insertion_limit", std::int64_t(isOn ? 0 : given.head[kLimit]));
}

/// All other features, by the case's bytes.
void setAnything(JobRun& run, const FuzzCase& given, const std::vector<double>& xyz)
{
  const std::uint8_t bits = given.head[kShuffle], more = given.head[kRefusals];
  const auto bit = [](std::uint8_t byte, int k) { return std::int64_t(byte >> k & 1); };
  setFlags(run, given.head[kSkipMarks] | unsigned(given.head[kSkipMask]) << 8);
  if (bit(more, 0) != 0)
  {
    static const double boxes[][4] = { { 0, 0, 1, 1 }, { 3, -1e9, -2, 7 }, { 1e5, 1e5, 1e6, 0 } };
    const ahd_array corners = { boxes[bits % 3], AHD_FLOAT64, 2, 2, 2 * sizeof(double),
      sizeof(double) };
    ahd_set_array(run.job(), "voronoi_polygon", &corners);
    run.set("voronoi_clip", std::int64_t(AHD_CLIP_POLYGON));
  }
  run.set("plane", bit(bits, 0) * (1 + bit(more, 7)));
  run.set("bounding", bit(bits, 1));
  run.set("tolerance", bit(bits, 2) != 0 ? 1.0 / (1.0 + given.head[kMergeDistance]) : 0.0);
  run.set("maximum_edge_length", bit(more, 1) != 0 ? double(given.head[kMergeDistance]) : 0.0);
  setSimplified(run, given);
  setNumbers(run, given, xyz);
  run.set("split_crossings", bit(bits, 4));
  run.set("closed_lines", bit(bits, 5));
  run.set("points_as_line", bit(given.head[kMostBoxes], 0));
  run.set("duplicates", std::int64_t(bits >> 6));
  run.set("rim", std::int64_t(more % 3));
  run.set("want_voronoi", bit(more, 2));
  run.set("want_curve", bit(more, 3));
  run.set("source_heights", bit(more, 4) * (1 + bit(more, 7)));
  setLines(run, given.head[kLimit] >> 5, xyz);
  run.set("cell_ids", bit(more, 5));
  run.set("unfitted_points", std::int64_t(given.head[kMostBoxes]));
  run.set("first_cell", std::int64_t(given.head[kMostBoxes]));
  run.set("offset", 1.0 + given.head[kMostBoxes]);
  static const double turned[] = { 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1 };
  const ahd_array matrix = { turned, AHD_FLOAT64, 4, 4, 4 * sizeof(double), sizeof(double) };
  ahd_set_array(run.job(), "matrix", &matrix);
  if (bit(given.head[kMostBoxes], 3) != 0) // of more points than these
  {
    static const double all[] = { -1e3, 2e3, -1e9, 7e9 };
    const ahd_array bounds = { all, AHD_FLOAT64, 2, 2, 2 * sizeof(double), sizeof(double) };
    ahd_set_array(run.job(), "rank_bounds", &bounds);
  }
  if (bit(more, 6) != 0) // points once more, as those of the source
  {
    const ahd_array source = { xyz.data(), AHD_FLOAT64, 2,
      std::int64_t(std::min<std::size_t>(xyz.size() / 3, 20)), 3 * sizeof(double), sizeof(double) };
    ahd_set_array(run.job(), "source_points", &source);
  }
}

/// Are ids of this array numbers of cells?
bool areCells(const std::string& name)
{
  return name == "neighbors" || name == "regions";
}

/// The largest id that an array can have.
std::int64_t mostOf(JobRun& run, const std::string& name)
{
  if (areCells(name))
  {
    return run.count("cells") - 1;
  }
  const bool areNumbers = name == "voronoi_offsets" || name == "voronoi_corners" ||
    name == "box_counts" || name == "weight_offsets" || name == "left_out" ||
    name == "crossing_cells";
  return areNumbers ? INT64_MAX : run.count("points") - 1;
}

/// Every array is available, and its ids name existing points and cells.
void expectArrays(const FuzzCase& given, JobRun& run)
{
  for (std::uint32_t i = 0; const char* name = ahd_name(AHD_OUTPUT_ARRAYS, i); ++i)
  {
    std::uint64_t rows = 0, columns = 0;
    if (ahd_array_size(run.job(), name, &rows, &columns) != AHD_OK)
    {
      continue; // not requested
    }
    std::vector<double> room(static_cast<std::size_t>(rows * columns));
    const std::uint64_t size = room.size();
    ahd_status status = ahd_get_array(run.job(), name, AHD_FLOAT64, room.data(), size);
    if (status == AHD_BAD_ARRAY)
    {
      status = ahd_get_array(run.job(), name, AHD_UINT8, room.data(), size);
    }
    if (status == AHD_BAD_ARRAY && std::string(name) != "box_levels")
    {
      const std::vector<std::int64_t> ids = run.ids(name);
      const std::int64_t most = mostOf(run, name);
      expect(std::all_of(
               ids.begin(), ids.end(), [most](std::int64_t id) { return id >= -3 && id <= most; }),
        name, given);
      continue;
    }
    expect(status == AHD_OK || std::string(name) == "box_levels", name, given);
  }
}

/// Values between the points, whatever the surface: a place of the surface has a mask, any finite
/// one a value if places outside have that of the nearest vertex, unless no triangle is left of
/// some; weights are available afterwards.
void expectSampled(const FuzzCase& given, JobRun& run, const PointView& points)
{
  constexpr std::size_t kSide = 5;
  const std::int64_t method = given.head[kMergeDistance] % 4, outside = given.head[kShuffle] % 2;
  run.set("sample_method", method);
  run.set("sample_outside", outside);
  run.set("sample_first_column", std::int64_t(given.head[kMostBoxes] >> 6));
  run.set("sample_first_row", std::int64_t(given.head[kMostBoxes] >> 5 & 1));
  const Point first = points.count > 0 ? points[0] : Point{ 0, 0 };
  const Point last = points.count > 0 ? points[points.count - 1] : Point{ 0, 0 };
  const auto part = [](double a, double b)
  {
    const double third = b / 3 - a / 3;
    return std::isfinite(third) && third != 0.0 ? third : 1.0;
  };
  const ahd_places raster = { nullptr, 0,
    { isFinite(first) ? first.x : 0.0, isFinite(first) ? first.y : 0.0 },
    { part(first.x, last.x), part(first.y, last.y) }, kSide, kSide };
  const std::vector<double> values(static_cast<std::size_t>(run.count("points")), 3.0);
  std::vector<double> out(kSide * kSide, -7.0);
  std::vector<std::uint8_t> mask(kSide * kSide, 77);
  const ahd_sampled array = { values.data(), 1, out.data(), nullptr };
  ahd_status status = ahd_sample(run.job(), &raster, &array, 1, mask.data());
  expect(status == AHD_OK, ahd_message(run.job()), given);
  const std::int64_t valued = run.count("sampled_valued"), beyond = run.count("sampled_outside");
  std::int64_t numbers = 0;
  for (std::size_t k = 0; k < out.size(); ++k)
  {
    expect(
      std::isnan(out[k]) ? mask[k] == 0 : std::fabs(out[k] - 3.0) < 1e-9, "3 everywhere", given);
    numbers += std::isnan(out[k]) ? 0 : 1;
  }
  expect(std::count(mask.begin(), mask.end(), 1) == valued, "the mask is counted", given);
  const bool isGone = run.count("delaunay_triangles") > 0 && run.count("kept_triangles") == 0;
  const bool fills = outside != 0 && !isGone &&
    run.count("inserted") + run.count("beyond_limit") > 0;
  expect(numbers == valued + (fills ? beyond : 0), "what is outside is filled", given);
  status = ahd_sample_weights(run.job(), &raster);
  expect(status == AHD_OK, ahd_message(run.job()), given);
}

struct Countdown
{
  std::size_t left; ///< calls until it cancels; 0: never
};

std::int32_t countDown(void* user, std::int32_t, double)
{
  auto* const own = static_cast<Countdown*>(user);
  return own->left > 0 && --own->left == 0 ? 1 : 0;
}

/// Cancelled or without memory it reports it, or is Ok; afterwards it runs unaffected.
void expectTrouble(const FuzzCase& given, JobRun& run)
{
  Countdown countdown = { given.head[kCancelAt] };
  ahd_set_progress(run.job(), countDown, &countdown);
  const bool isToCancel = countdown.left > 0;
  ahd_status status = run.run();
  expect(status == AHD_OK || (isToCancel && status == AHD_CANCELLED && countdown.left == 0),
    "a job is cancelled if told to", given);
  countdown.left = 0;
  if (given.head[kFailAt] != 0)
  {
    {
      const NoMemory none(given.head[kFailAt]);
      status = run.run();
    }
    expect(status == AHD_OK || status == AHD_OUT_OF_MEMORY, "a job without memory", given);
    expect((status == AHD_OK) == (ahd_message(run.job())[0] == '\0'), "it says so", given);
  }
  ahd_set_progress(run.job(), nullptr, nullptr);
  status = run.run();
  expect(status == AHD_OK, ahd_message(run.job()), given);
}

/// Triangles with their smallest corner first, in ascending order.
using Triangles = std::vector<std::array<std::int32_t, 3>>;

Triangles trianglesOf(const std::vector<std::int32_t>& triples)
{
  Triangles triangles(triples.size() / 3);
  for (std::size_t k = 0; k < triangles.size(); ++k)
  {
    std::array<std::int32_t, 3>& corners = triangles[k];
    std::copy_n(triples.begin() + std::ptrdiff_t(3 * k), 3, corners.begin());
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Borrows the triangles, and the edges unless they are null.
void setSurface(JobRun& run, const Triangles& triangles, const std::uint8_t* edges)
{
  const auto rows = std::int64_t(triangles.size());
  const ahd_array corners = { triangles.data(), AHD_INT32, 3, rows, 3 * sizeof(std::int32_t),
    sizeof(std::int32_t) };
  const ahd_array constraints = { edges, AHD_UINT8, 1, rows, 1, 1 };
  ahd_set_array(run.job(), "surface", &corners);
  ahd_set_array(run.job(), "surface_edges", edges ? &constraints : nullptr);
}

/// Triangles of a triangulation can be restored, all or some of them, with any of their edges
/// marked as constraints. If a corner is changed they are restored, or refused.
void expectSurface(const FuzzCase& given, const JobCase& made, const PointView& points)
{
  Dice dice(given.head[kShuffle]);
  Triangles triangles = trianglesOf(made.triples);
  const std::size_t most = given.head[kMergeDistance] / 64u; // of four
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                    [&](const auto&) { return dice.below(4) < most; }),
    triangles.end());
  if (triangles.empty())
  {
    return;
  }
  std::vector<std::uint8_t> edges;
  for (std::size_t k = 0; k < triangles.size(); ++k)
  {
    edges.push_back(std::uint8_t(dice.bits() & dice.bits() & 7u));
  }
  const std::uint8_t* const named = given.head[kRefusals] % 4 == 3 ? nullptr : edges.data();
  JobRun run;
  run.set("threads", std::int64_t(1 + given.head[kExecutors] % 3));
  setOptions(run, given.options(1));
  run.setPoints(points);
  setSurface(run, triangles, named);
  expectTrouble(given, run);
  expect(trianglesOf(run.shortIds("triangles")) == triangles, "a surface is as given", given);
  expectSampled(given, run, points);
  triangles[dice.below(triangles.size())][dice.below(3)] = std::int32_t(dice.below(points.count));
  setSurface(run, triangles, named);
  const ahd_status status = run.run();
  expect(status == AHD_OK || status == AHD_BAD_VALUE, ahd_message(run.job()), given);
  expect(status != AHD_OK || run.count("folded_triangles") == 0, "none is folded", given);
  expect(run.status() == AHD_OK, run.message().c_str(), given);
}

} // namespace

void expectSameThroughC(const FuzzCase& given, const JobCase& made)
{
  JobRun run;
  run.set("threads", std::int64_t(1 + given.head[kExecutors] % 3));
  run.set("fill_rule", std::int64_t(made.rule));
  setOptions(run, given.options(1));
  PointView flat = made.points;
  flat.isFlat = true; // after x and y of the last the memory may end
  run.setPoints(flat);
  run.setConstraints(made.chains);
  expect(run.run() == AHD_OK, ahd_message(run.job()), given);
  expect(run.shortIds("triangles") == made.triples, "a job gives the same triangles", given);
  if (made.points.count > kMostForAnything)
  {
    return;
  }
  std::vector<double> xyz;
  for (std::size_t i = 0; i < flat.count; ++i)
  {
    const double z = given.head[kShuffle] * i % 5 == 4 ? std::nan("") : double(i * 7 % 4);
    xyz.insert(xyz.end(), { flat[i].x, flat[i].y, z });
  }
  PointView points(xyz.data(), flat.count, 3);
  points.skip = flat.skip;
  points.skipMask = flat.skipMask;
  run.setPoints(points);
  setAnything(run, given, xyz);
  expectTrouble(given, run);
  expectSampled(given, run, points);
  expectArrays(given, run);
  expect(run.status() == AHD_OK, run.message().c_str(), given);
  expectSurface(given, made, flat);
}

} // namespace fuzz
} // namespace ahd
