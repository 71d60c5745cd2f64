// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling.h"

#include "../Core/Memory.h"
#include "../Sample/Outside.h"
#include "Job.h"
#include "Refusal.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace ahd
{

SampleRaster wholeRaster(const GivenPlaces& given)
{
  for (std::size_t k = 0; k < 2; ++k)
  {
    if (!std::isfinite(given.origin[k]) || !std::isfinite(given.spacing[k]) ||
      given.spacing[k] == 0.0)
    {
      refuse(Reason::BadValue,
        "A raster must have a finite origin, and a spacing that is finite and not 0.");
    }
  }
  if (given.rows > 0 && given.columns > kMostNumbers / given.rows)
  {
    refuse(Reason::MemoryLimit,
      "A raster of " + std::to_string(given.columns) + " x " + std::to_string(given.rows) +
        " cells does not fit in any memory.");
  }
  SampleRaster raster;
  raster.origin = { given.origin[0], given.origin[1] };
  raster.spacing = { given.spacing[0], given.spacing[1] };
  raster.columns = static_cast<std::size_t>(given.columns);
  raster.rows = static_cast<std::size_t>(given.rows);
  return raster;
}

namespace
{

SamplePlaces placesOf(const GivenPlaces& given, const JobSettings& settings)
{
  if (given.xy || given.count > 0)
  {
    if (!given.xy)
    {
      refuse(
        Reason::BadArray, "There are " + std::to_string(given.count) + " places, but xy is null.");
    }
    checkCount(given.count, "places");
    return SamplePlaces(PointView(given.xy, static_cast<std::size_t>(given.count), 2));
  }
  SampleRaster raster = wholeRaster(given);
  raster.firstColumn = static_cast<std::size_t>(settings[IntSetting::SampleFirstColumn]);
  raster.firstRow = static_cast<std::size_t>(settings[IntSetting::SampleFirstRow]);
  return SamplePlaces(raster);
}

std::size_t estimateOf(
  std::size_t points, const SamplePlaces& places, std::size_t components, bool fills)
{
  return sampleMemoryEstimate(points, places, components) +
    (fills ? fillOutsideMemoryEstimate(points, places, components) : 0);
}

} // namespace

Sampling::Sampling(Job& job, const GivenPlaces& places)
  : job_(job)
  , made_(job.result())
  , kept_(made_.sampling)
  , places_(placesOf(places, job.settings))
  , method_(SampleMethod(job.settings[IntSetting::SampleMethod]))
  , outside_(method_ == SampleMethod::Nearest
        ? OutsideValues::None
        : OutsideValues(job.settings[IntSetting::SampleOutside]))
{
}

std::size_t Sampling::bytesFor(std::size_t components, bool hasMask) const
{
  const std::size_t points = made_.points.points().count, places = places_.count();
  return static_cast<std::size_t>(job_.settings[IntSetting::OtherMemory]) +
    (kept_.hasTables ? 0 : tableMemoryEstimate(points)) +
    estimateOf(points, places_, components, fills()) + (fills() && !hasMask ? places : 0);
}

void Sampling::estimate(std::uint64_t columns, std::uint64_t& bytes) const
{
  checkColumns(columns, "columns");
  const std::size_t estimated = bytesFor(static_cast<std::size_t>(columns), false);
  bytes = estimated;
  checkMemory(estimated);
}

/// With a limit, the memory of the run counts, too.
void Sampling::checkMemory(std::size_t bytes) const
{
  const auto limit = static_cast<std::size_t>(job_.settings[IntSetting::MemoryLimit]);
  const SampleWeights& before = kept_.weights; // stay until others are there
  const std::size_t held = job_.report().estimate - made_.otherMemory + before.offsets.bytes() +
    before.points.bytes() + before.weights.bytes();
  const std::size_t allowed = limit > 0 ? limit - std::min(limit, held) : availableMemoryFor(bytes);
  if (bytes > allowed)
  {
    refuse(Reason::MemoryLimit,
      { { "doing", "sampling" }, { "places", places_.count() }, { "memory_limit", limit },
        { "memory_needed", bytes }, { "memory_allowed", allowed },
        { "memory_estimate", held + bytes } });
  }
}

/// About their seconds, with a million points: tables and places to be looked for among; values;
/// those outside.
std::vector<double> Sampling::stageWeights() const
{
  constexpr double kMakeTables = 2e-7, kMakeTree = 3e-7; // a point
  const auto points = static_cast<double>(made_.points.points().count);
  const auto places = static_cast<double>(places_.count());
  const double perPlace = method_ == SampleMethod::Linear ? places_.isRaster() ? 3e-8 : 3e-7
    : method_ == SampleMethod::Nearest                    ? 6e-7
                                                          : 1e-6;
  const double tree = kept_.nearest.is || outside_ == OutsideValues::Boundary ? 0.0 : kMakeTree;
  return { points *
      ((kept_.hasTables ? 0.0 : kMakeTables) +
        (method_ == SampleMethod::Nearest ? kMakeTree : 0.0)),
    places * perPlace, fills() ? points * tree + places * 1e-7 : 0.0 };
}

template <typename Work>
void Sampling::run(std::size_t bytes, const Work& work)
{
  checkMemory(bytes);
  const struct Apart
  {
    JobProgress& progress;
    ~Apart() { progress.endApart(); }
  } apart{ job_.progress };
  const double begun = job_.progress.now();
  SampleReport report;
  job_.progress.beginApart(stageWeights());
  job_.withThreads(
    [&](const Context& context)
    {
      job_.progress.reach(1);
      const Sampler& sampler = prepare(kept_.byMethod, method_, context);
      job_.progress.reach(2);
      job_.progress.expectLastPhase();
      work(sampler, report, context);
      check(job_.progress.finish() ? Status::Ok : Status::Cancelled);
    });
  kept_.report = report;
  kept_.estimate = bytes;
  kept_.seconds = job_.progress.now() - begun;
}

const Sampler& Sampling::prepare(
  JobSampling::Ready& ready, SampleMethod method, const Context& context)
{
  if (!ready.is || ready.method != method)
  {
    ready.is = false;
    const unsigned char* const kept = made_.isSelected() ? made_.selection.kept.data() : nullptr;
    // In one go, before the caller, who may change its memory then, hears of progress.
    check(made_.triangulation.makeNumbersAndCorners({ nullptr, context.executor }));
    check(ready.sampler.prepare(made_.triangulation, kept, method, context));
    ready.is = kept_.hasTables = true;
    ready.method = method;
  }
  return ready.sampler;
}

std::vector<SampleArray> Sampling::arraysOf(const std::vector<GivenSamples>& given) const
{
  const bool hasPoints = made_.points.points().count > 0;
  std::vector<SampleArray> arrays(given.size());
  for (std::size_t k = 0; k < arrays.size(); ++k)
  {
    const GivenSamples& array = given[k];
    const std::string name = "Array " + std::to_string(k) + " of those to interpolate ";
    if (array.columns < 0)
    {
      refuse(Reason::BadArray, name + "has " + std::to_string(array.columns) + " columns.");
    }
    if (array.columns > 0 && ((hasPoints && !array.values) || (places_.count() > 0 && !array.out)))
    {
      refuse(Reason::BadArray, name + "has no values or no output: a pointer is null.");
    }
    if (array.gradients && method_ != SampleMethod::Linear)
    {
      refuse(Reason::BadValue,
        name +
          "has an output for gradients, which only \"sample_method\" "
          "AHD_SAMPLE_LINEAR computes.");
    }
    arrays[k] = { array.values, static_cast<std::size_t>(array.columns), array.out,
      array.gradients };
  }
  return arrays;
}

void Sampling::values(const std::vector<GivenSamples>& given, std::uint8_t* mask)
{
  const std::vector<SampleArray> arrays = arraysOf(given);
  std::size_t components = 0;
  for (const SampleArray& array : arrays)
  {
    components += array.components;
    checkColumns(components, "columns");
  }
  run(bytesFor(components, mask != nullptr),
    [&](const Sampler& sampler, SampleReport& report, const Context& context)
    {
      Buffer<unsigned char> ownMask;
      if (fills() && !mask)
      {
        ownMask.allocate(places_.count());
        mask = ownMask.data();
      }
      check(sampler.values(places_, arrays.data(), arrays.size(), mask, report, context));
      if (fills() && report.outside > 0)
      {
        job_.progress.reach(3);
        const Sampler& filler = outside_ == OutsideValues::Boundary
          ? sampler
          : prepare(kept_.nearest, SampleMethod::Nearest, context);
        check(fillOutside(filler, places_, arrays.data(), arrays.size(), mask, context));
      }
    });
}

void Sampling::weights()
{
  // A place mostly has six natural neighbours; their number is not known before.
  const std::size_t perPlace = method_ == SampleMethod::Nearest ? 1
    : method_ == SampleMethod::Linear                           ? 3
                                                                : 7;
  const std::size_t bytes = (places_.count() + 1) * sizeof(std::uint64_t) +
    places_.count() * perPlace * (sizeof(std::int32_t) + sizeof(double));
  outside_ = OutsideValues::None;
  SampleWeights made; // those before stay until these are there
  run(bytesFor(0, true) + bytes,
    [&](const Sampler& sampler, SampleReport& report, const Context& context)
    { check(sampler.weights(places_, made, report, context)); });
  kept_.weights = std::move(made);
  kept_.hasWeights = true;
}

std::uint64_t samplingEstimate(
  std::uint64_t points, const GivenPlaces& places, std::uint64_t columns, bool fills)
{
  checkColumns(columns, "columns");
  if (points > kMaximumPoints)
  {
    refuse(Reason::BadValue, std::to_string(points) + " points are more than can be triangulated.");
  }
  const auto most = [](std::uint64_t count)
  { return static_cast<std::size_t>(std::min<std::uint64_t>(count, kMostNumbers)); };
  const auto count = static_cast<std::size_t>(points),
             components = static_cast<std::size_t>(columns);
  if (places.count > 0)
  {
    const PointView given(static_cast<const double*>(nullptr), most(places.count), 2);
    return estimateOf(count, SamplePlaces(given), components, fills);
  }
  SampleRaster raster;
  raster.columns = most(places.columns);
  raster.rows = most(places.rows);
  return estimateOf(count, SamplePlaces(raster), components, fills);
}

} // namespace ahd
