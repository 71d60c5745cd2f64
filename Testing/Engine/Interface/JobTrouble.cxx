// SPDX-License-Identifier: BSD-3-Clause
//
// A job where memory runs out or callbacks throw; memory held and estimated. This program's
// operator new counts, and fails on demand.
#include "ConstraintMakers.h"
#include "FailingJob.h"
#include "Interface/Call.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

struct Case
{
  explicit Case(std::size_t count)
    : given(randomSegments(count, 20))
    , more(makePoints(Distribution::Uniform, 20, 5))
  {
  }

  /// Sets one combination of settings, so that each feature is in one of them.
  void set(JobRun& run, int variant) const
  {
    run.setPoints(given.view());
    run.setConstraints(given.constraints.view());
    run.set("threads", std::int64_t(1));
    run.set("split_crossings", std::int64_t(variant % 2));
    run.set("tolerance", variant % 3 == 0 ? 0.01 : 0.0);
    run.set("plane", std::int64_t(variant % 5 == 1 ? AHD_PLANE_BEST_FIT : AHD_PLANE_XY));
    run.set("duplicates", std::int64_t(variant % 4));
    run.set("want_voronoi", std::int64_t(variant % 2));
    run.set("want_boxes", std::int64_t(variant % 3 == 1));
    run.set("want_curve", std::int64_t(variant % 3 == 1));
    run.set("alpha", variant % 4 == 2 ? 0.1 : 0.0);
    run.set("bounding", std::int64_t(variant == 4));
    for (const char* name :
      { "want_point_status", "want_constraint_edges", "want_regions", "want_neighbors" })
    {
      run.set(name, std::int64_t(1));
    }
    if (variant >= 3)
    {
      const ahd_array source = { more.data(), AHD_FLOAT64, 2, 20, 16, 8 };
      ahd_set_array(run.job(), "source_points", &source);
      run.set("source_heights", std::int64_t(variant % 2));
    }
  }

  ConstraintCase given;
  std::vector<Point> more;
};
constexpr int kVariants = 7;

/// Every available array; the others were not requested.
std::string readAll(JobRun& run)
{
  std::string all;
  for (std::uint32_t i = 0; const char* name = ahd_name(AHD_OUTPUT_ARRAYS, i); ++i)
  {
    std::uint64_t rows = 0, columns = 0;
    if (ahd_array_size(run.job(), name, &rows, &columns) != AHD_OK)
    {
      continue;
    }
    std::vector<unsigned char> bytes(static_cast<std::size_t>(rows * columns * 8));
    for (const std::int32_t type : { AHD_INT64, AHD_FLOAT64, AHD_UINT8, AHD_INT32 })
    {
      const ahd_status status = ahd_get_array(run.job(), name, type, bytes.data(), rows * columns);
      if (status == AHD_OUT_OF_MEMORY)
      {
        return "out of memory";
      }
      if (status == AHD_OK)
      {
        break;
      }
    }
    all.append(bytes.begin(), bytes.end());
  }
  return all;
}

TEST(JobTrouble, AnyAllocationCanFail)
{
  for (int variant = 0; variant < kVariants; ++variant)
  {
    SCOPED_TRACE(variant);
    const Case made(60);
    JobRun run;
    made.set(run, variant);
    ASSERT_EQ(run.status(), AHD_OK) << run.message();
    ASSERT_NO_FATAL_FAILURE(expectAnyAllocationCanFail(run, readAll));
    ASSERT_GT(readAll(run).size(), 1000u);
  }
}

TEST(JobTrouble, AnyAllocationOfAnArrayCanFail)
{
  const Case made(60);
  for (int variant = 0; variant < kVariants; ++variant)
  {
    SCOPED_TRACE(variant);
    JobRun run;
    made.set(run, variant);
    ASSERT_EQ(run.run(), AHD_OK);
    const std::string bytes = readAll(run);
    std::size_t k = 1;
    for (bool isThrough = false; !isThrough; ++k)
    {
      ASSERT_EQ(run.run(), AHD_OK); // tables are made anew
      isThrough = true;
      for (std::uint32_t i = 0; const char* name = ahd_name(AHD_OUTPUT_ARRAYS, i); ++i)
      {
        std::vector<double> room(2000);
        account.allocations = 0;
        account.failAt = k;
        const ahd_status status = ahd_get_array(run.job(), name, AHD_INT32, room.data(), 2000);
        account.failAt = 0;
        isThrough = isThrough && account.allocations < k;
        ASSERT_TRUE(status == AHD_OK || status == AHD_OUT_OF_MEMORY || status == AHD_BAD_ARRAY ||
          status == AHD_NOT_AVAILABLE)
          << name << ": " << ahd_message(run.job());
      }
      ASSERT_EQ(readAll(run), bytes);
    }
    EXPECT_GT(k, 2u);
  }
}

TEST(JobTrouble, AJobThatCannotBeMadeIsNull)
{
  account.allocations = 0;
  account.failAt = 1;
  ahd_job* const job = ahd_job_new();
  account.failAt = 0;
  EXPECT_EQ(job, nullptr);
}

TEST(JobTrouble, NothingIsLeftWhenItIsFreed)
{
  const Case made(500);
  const std::size_t before = account.held;
  for (int variant = 0; variant < kVariants; ++variant)
  {
    JobRun run;
    made.set(run, variant);
    ASSERT_EQ(run.run(), AHD_OK) << run.message();
    EXPECT_FALSE(readAll(run).empty());
  }
  EXPECT_EQ(account.held, before);
}

TEST(JobTrouble, ItTakesNoMoreMemoryThanEstimated)
{
  const Case made(20000);
  for (int variant = 0; variant < kVariants; variant += 2) // without crossings that are split
  {
    SCOPED_TRACE(variant);
    JobRun run;
    made.set(run, variant);
    run.set("source_heights", std::int64_t(AHD_HEIGHTS_OWN));
    std::uint64_t estimate = 0;
    ASSERT_EQ(ahd_estimate(run.job(), &estimate), AHD_OK);
    const std::size_t before = account.held;
    account.peak = before;
    ASSERT_EQ(run.run(), AHD_OK) << ahd_message(run.job());
    EXPECT_FALSE(run.ids("neighbors").empty());
    EXPECT_LE(account.peak - before, estimate + 10000);
    EXPECT_GE((account.peak - before) * 20, estimate) << "it is no estimate but a guess";
  }
}

std::int64_t estimateOf(JobRun& run)
{
  std::uint64_t bytes = 0;
  EXPECT_EQ(ahd_estimate(run.job(), &bytes), AHD_OK) << ahd_message(run.job());
  return std::int64_t(bytes);
}

/// The bytes of these arrays, as they are read: ids and real numbers of 64 bits.
std::int64_t bytesOf(JobRun& run, const std::vector<std::string>& arrays)
{
  std::int64_t bytes = 0;
  for (const std::string& name : arrays)
  {
    std::uint64_t rows = 0, columns = 0;
    EXPECT_EQ(ahd_array_size(run.job(), name.c_str(), &rows, &columns), AHD_OK) << name;
    bytes += std::int64_t(rows * columns * (name == "constraint_edges" ? 1 : 8));
  }
  return bytes;
}

/// An array adds its own bytes to the estimate and little else, as memory of arrays may be rounded
/// up; anything it needs besides (a table, the order) exists for others already.
TEST(JobTrouble, EstimateOfEachArrayIsItsBytes)
{
  constexpr std::int64_t kCount = 20000;
  const Case made(kCount);
  JobRun run;
  run.setPoints(made.given.view());
  run.setConstraints(made.given.constraints.view());
  run.set("want_voronoi", std::int64_t(1)); // has the tables
  run.set("want_order", std::int64_t(1));
  run.set("want_regions", std::int64_t(1));
  run.set("want_constraint_edges", std::int64_t(1));
  run.set("want_neighbors", std::int64_t(1));
  run.set("want_point_status", std::int64_t(1));
  run.set("want_insertion_ranks", std::int64_t(1));
  ASSERT_EQ(run.run(), AHD_OK) << ahd_message(run.job());
  const struct
  {
    const char* setting;
    std::vector<std::string> arrays;
    std::int64_t more;                                ///< bytes a point, at most
  } rows[] = { { "want_regions", { "regions" }, 34 }, // sets, while they are numbered
    { "want_constraint_edges", { "constraint_edges" }, 0 },
    { "want_neighbors", { "neighbors" }, 0 }, { "want_point_status", { "point_status" }, 0 },
    { "want_insertion_ranks", { "insertion_ranks" }, 0 },
    { "want_voronoi", { "voronoi_points", "voronoi_offsets", "voronoi_corners", "voronoi_sites" },
      280 } };
  const std::int64_t all = estimateOf(run);
  for (const auto& row : rows)
  {
    SCOPED_TRACE(row.setting);
    ASSERT_EQ(run.run(), AHD_OK) << ahd_message(run.job());
    const std::int64_t bytes = bytesOf(run, row.arrays);
    EXPECT_GE(bytes, kCount);
    run.set(row.setting, std::int64_t(0));
    const std::int64_t less = all - estimateOf(run);
    EXPECT_GE(less, bytes);
    EXPECT_LE(less, bytes + bytes / 15 + 1000 + row.more * kCount);
    run.set(row.setting, std::int64_t(1));
  }
}

/// The same for settings that take memory in the run, if the peak is then: here, with constraints,
/// while these are inserted.
TEST(JobTrouble, EstimateOfEachSettingIsWhatItTakes)
{
  constexpr std::int64_t kCount = 20000;
  const Case made(kCount);
  const struct
  {
    const char* name;
    std::int64_t value;
    std::int64_t least, most; ///< bytes a point
  } rows[] = {
    { "plane", AHD_PLANE_BEST_FIT, 25, 80 },          // a copy of the places, and its marks
    { "rim", AHD_RIM_TRIMMED, 0, 60 },                // the rim's triangles
    { "duplicates", AHD_DUPLICATES_LOWEST_Z, 0, 32 }, // representatives
    { "duplicates", AHD_DUPLICATES_MEAN_Z, 24, 60 },  // a copy of the points, or the means
    { "bounding", 1, 25, 80 },                        // a copy of the points
    { "want_curve", 1, 24 + 3 * 8, 100 },             // drawn: places, rank, id, count
    { "split_crossings", 1, 0, 20 },                  // of the segments alone
    { "closed_lines", 1, 0, 20 },
  };
  JobRun run;
  run.setPoints(made.given.view());
  run.setConstraints(made.given.constraints.view());
  const std::int64_t plain = estimateOf(run);
  for (const auto& row : rows)
  {
    SCOPED_TRACE(row.name + std::string(" ") + std::to_string(row.value));
    run.set(row.name, row.value);
    const std::int64_t more = estimateOf(run) - plain;
    EXPECT_GE(more, row.least * kCount);
    EXPECT_LE(more, row.most * kCount + 5000);
    run.set(row.name, std::int64_t(0));
  }
  run.set("other_memory", std::int64_t(123456));
  EXPECT_EQ(estimateOf(run), plain + 123456);
}

std::int32_t throwIt(void*, std::int32_t, double)
{
  throw std::runtime_error("from a callback");
}

std::int32_t throwFromProjection(void*, double*, std::uint64_t)
{
  throw std::runtime_error("from a callback");
}

TEST(JobTrouble, WhatCallbacksThrowGoesNoFurther)
{
  const Case made(100);
  JobRun run;
  made.set(run, 0);
  ahd_set_progress(run.job(), throwIt, nullptr);
  EXPECT_EQ(run.run(), AHD_CANCELLED);
  ahd_set_progress(run.job(), nullptr, nullptr);
  ahd_set_projection(run.job(), throwFromProjection, nullptr);
  run.set("plane", std::int64_t(AHD_PLANE_CALLBACK));
  EXPECT_EQ(run.run(), AHD_CANCELLED);
  run.set("plane", std::int64_t(AHD_PLANE_XY));
  EXPECT_EQ(run.run(), AHD_OK);
}

/// Whatever work throws, its call ends with a status and a message, and the next one may begin.
TEST(JobTrouble, EachExceptionIsAStatusAndAMessage)
{
  const struct
  {
    std::function<void()> work;
    ahd_status status;
    const char* message;
  } rows[] = {
    { [] { throw std::bad_alloc(); }, AHD_OUT_OF_MEMORY, "Out of memory." },
    { [] { throw std::length_error("of a vector"); }, AHD_OUT_OF_MEMORY, "Out of memory." },
    { [] { throw std::runtime_error("unforeseen"); }, AHD_FAILED, "A fault of the library." },
    { [] { throw 7; }, AHD_FAILED, "A fault of the library." },
    { [] { refuse(Reason::BadValue, "Why."); }, AHD_BAD_VALUE, "Why." },
  };
  JobRun run;
  for (const auto& row : rows)
  {
    EXPECT_EQ(calls::call(run.job(), [&](Job&) { row.work(); }), row.status);
    EXPECT_STREQ(ahd_message(run.job()), row.message);
    EXPECT_EQ(calls::call(run.job(), [](Job&) {}), AHD_OK);
    EXPECT_STREQ(ahd_message(run.job()), "");
  }
}

/// A raster beyond the points on all sides, sampled by one method, with places outside filled.
struct Sampling
{
  Sampling(JobRun& run, int method, std::size_t side)
    : job(run.job())
    , values(2 * static_cast<std::size_t>(run.count("points")), 3.0)
    , out(2 * side * side)
  {
    run.set("sample_method", std::int64_t(method));
    run.set("sample_outside", std::int64_t(AHD_OUTSIDE_NEAREST_VERTEX));
    const double size = 3.0 / double(side);
    raster = { nullptr, 0, { -1.0, -1.0 }, { size, size }, side, side };
    array = { values.data(), 2, out.data(), nullptr };
  }

  ahd_status sample() { return ahd_sample(job, &raster, &array, 1, nullptr); }
  ahd_status weights() { return ahd_sample_weights(job, &raster); }

  ahd_job* job;
  std::vector<double> values, out;
  ahd_places raster;
  ahd_sampled array;
};
constexpr int kMethods = 4;

TEST(JobTrouble, AnyAllocationOfSamplingCanFail)
{
  const Case made(60);
  for (int variant = 0; variant < kVariants; ++variant)
  {
    SCOPED_TRACE(variant);
    JobRun run;
    made.set(run, variant);
    ASSERT_EQ(run.run(), AHD_OK);
    Sampling sampling(run, variant % kMethods, 9);
    ASSERT_EQ(sampling.sample(), AHD_OK) << ahd_message(run.job());
    const std::vector<double> expected = sampling.out;
    std::size_t k = 1;
    for (bool isThrough = false; !isThrough; ++k)
    {
      ASSERT_EQ(run.run(), AHD_OK); // tables are made anew
      account.allocations = 0;
      account.failAt = k;
      ahd_status status = sampling.weights();
      status = status == AHD_OK ? sampling.sample() : status;
      isThrough = account.allocations < k;
      account.failAt = 0;
      ASSERT_EQ(status, isThrough ? AHD_OK : AHD_OUT_OF_MEMORY) << "allocation " << k;
      ASSERT_EQ(sampling.sample(), AHD_OK) << ahd_message(run.job());
      ASSERT_EQ(std::memcmp(sampling.out.data(), expected.data(), expected.size() * 8), 0);
    }
    EXPECT_GT(k, 10u);
  }
}

TEST(JobTrouble, SamplingTakesNoMoreMemoryThanEstimated)
{
  const Case made(20000);
  for (int method = 0; method < kMethods; ++method)
  {
    SCOPED_TRACE(method);
    JobRun run;
    made.set(run, 2);
    ASSERT_EQ(run.run(), AHD_OK) << ahd_message(run.job());
    Sampling sampling(run, method, 200);
    std::uint64_t estimate = 0;
    ASSERT_EQ(ahd_sample_estimate(run.job(), &sampling.raster, 2, &estimate), AHD_OK);
    const std::size_t before = account.held;
    account.peak = before;
    ASSERT_EQ(sampling.sample(), AHD_OK) << ahd_message(run.job());
    EXPECT_EQ(run.count("sampling_estimate"), std::int64_t(estimate));
    EXPECT_LE(account.peak - before, estimate + 10000);
    EXPECT_GE((account.peak - before) * 20, estimate) << "it is no estimate but a guess";
    // Of weights the arrays that are made, too.
    const std::size_t beforeWeights = account.held;
    account.peak = beforeWeights;
    ASSERT_EQ(sampling.weights(), AHD_OK) << ahd_message(run.job());
    const std::int64_t bytes = bytesOf(run, { "weight_offsets", "weights" }) +
      bytesOf(run, { "weight_points" }) / 2; // ids are kept with 32 bits
    EXPECT_GE(account.peak - beforeWeights, std::size_t(bytes));
    EXPECT_LE(account.peak - beforeWeights, std::size_t(run.count("sampling_estimate")) + 10000);
    EXPECT_GE(run.count("sampling_estimate"), bytes);
  }
}

/// Existing weights stay until the new ones are complete, so both count.
TEST(JobTrouble, FormerWeightsCount)
{
  const Case made(20000);
  JobRun run;
  made.set(run, 2);
  ASSERT_EQ(run.run(), AHD_OK);
  Sampling sampling(run, AHD_SAMPLE_NEAREST, 500);
  ASSERT_EQ(sampling.weights(), AHD_OK); // makes the tables
  ASSERT_EQ(sampling.weights(), AHD_OK);
  const std::int64_t needed = run.count("memory_estimate") + run.count("sampling_estimate");
  const std::int64_t former = bytesOf(run, { "weight_offsets", "weights" }) +
    bytesOf(run, { "weight_points" }) / 2;
  run.set("memory_limit", needed + former - 1);
  EXPECT_EQ(sampling.weights(), AHD_MEMORY_LIMIT);
  EXPECT_EQ(bytesOf(run, { "weights" }), 8 * 500 * 500) << "those before are gone";
  run.set("memory_limit", needed + former);
  const std::size_t before = account.held;
  account.peak = before;
  EXPECT_EQ(sampling.weights(), AHD_OK) << ahd_message(run.job());
  EXPECT_GE(account.peak - before + 10000, std::size_t(former)) << "there are never both";
}

/// Bounds for each part: places, columns, tables, places outside, other memory.
TEST(JobTrouble, EstimateOfSamplingIsThatOfItsParts)
{
  constexpr std::int64_t kSide = 300, kPlaces = kSide * kSide;
  const Case made(20000);
  JobRun run;
  run.setPoints(made.given.view());
  ASSERT_EQ(run.run(), AHD_OK);
  const std::int64_t points = run.count("points");
  std::vector<double> xy(2 * kPlaces, 0.5);
  const ahd_places raster = { nullptr, 0, { 0, 0 }, { 0.001, 0.001 }, kSide, kSide };
  const ahd_places places = { xy.data(), kPlaces, { 0, 0 }, { 0, 0 }, 0, 0 };
  const auto estimate = [&run](const ahd_places& at, std::uint64_t columns)
  {
    std::uint64_t bytes = 0;
    EXPECT_EQ(ahd_sample_estimate(run.job(), &at, columns, &bytes), AHD_OK);
    return std::int64_t(bytes);
  };
  const auto expectBetween = [](std::int64_t least, std::int64_t found, std::int64_t most)
  {
    EXPECT_LE(least, found);
    EXPECT_LE(found, most);
  };
  const std::int64_t plain = estimate(raster, 1);
  // a column: its values in the order of the vertices
  expectBetween(8 * points, estimate(raster, 2) - plain, 8 * points + 1000);
  // places that are on no raster: sorted by keys
  expectBetween(16 * kPlaces, estimate(places, 1) - plain, 40 * kPlaces);
  // places outside: their numbers and places, and the values of the nearest
  run.set("sample_outside", std::int64_t(AHD_OUTSIDE_NEAREST_VERTEX));
  expectBetween(24 * kPlaces, estimate(raster, 1) - plain, 120 * kPlaces + 40 * points);
  run.set("sample_method", std::int64_t(AHD_SAMPLE_NEAREST)); // none is outside
  EXPECT_EQ(estimate(raster, 1), plain);
  run.set("sample_method", std::int64_t(AHD_SAMPLE_LINEAR));
  run.set("sample_outside", std::int64_t(AHD_OUTSIDE_NO_VALUE));
  run.set("other_memory", std::int64_t(777));
  EXPECT_EQ(estimate(raster, 1), plain + 777);
  run.set("other_memory", std::int64_t(0));
  // its tables are made once: corners of two triangles, at least
  std::vector<double> values(static_cast<std::size_t>(points)), out(kPlaces);
  const ahd_sampled array = { values.data(), 1, out.data(), nullptr };
  ASSERT_EQ(ahd_sample(run.job(), &raster, &array, 1, nullptr), AHD_OK);
  expectBetween(24 * points, plain - estimate(raster, 1), 120 * points);
}

} // namespace
} // namespace test
} // namespace ahd
