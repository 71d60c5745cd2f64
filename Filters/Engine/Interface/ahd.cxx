// SPDX-License-Identifier: BSD-3-Clause
//
// The C interface.
#include "ahd.h"

#include "../Core/Fingerprint.h"
#include "../Core/Memory.h"
#include "../Job/Arrays.h"
#include "../Job/Counts.h"
#include "Call.h"
#include "Translate.h"

#include <algorithm>
#include <string>

#ifndef AHD_VERSION
#error "AHD_VERSION, the version of the project, is defined by Sources.cmake"
#endif

using namespace ahd::calls;

namespace
{

ahd_status outlineOf(ahd_job* job, bool isDirected, ahd_outline_report* report)
{
  ahd::CheckedMemory checked;
  const ahd::Outline* made = nullptr;
  const ahd_status status = call(job,
    [&](ahd::Job& own)
    {
      own.makeOutline(checked, isDirected);
      made = &own.outline();
    });
  if (report)
  {
    *report = { made ? made->unfitCells : 0, made ? made->unfitEdges : 0, checked.needed,
      checked.allowed, int32_t(made ? made->plane : ahd::OutlinePlane::Xy) };
  }
  return status;
}

} // namespace

uint32_t ahd_abi_version(void)
{
  return AHD_ABI_VERSION;
}

const char* ahd_version(void)
{
  return AHD_VERSION;
}

ahd_job* ahd_job_new(void)
{
  try
  {
    return new ahd_job;
  }
  catch (const std::bad_alloc&)
  {
    return nullptr;
  }
}

void ahd_job_free(ahd_job* job)
{
  delete job;
}

const char* ahd_message(const ahd_job* job)
{
  return job ? job->said.load() : "The job is a null pointer.";
}

ahd_status ahd_set_int(ahd_job* job, const char* name, int64_t value)
{
  return call(job, [=](ahd::Job& own) { own.settings.set(name, value); });
}

ahd_status ahd_set_double(ahd_job* job, const char* name, double value)
{
  return call(job, [=](ahd::Job& own) { own.settings.set(name, value); });
}

ahd_status ahd_get_int(ahd_job* job, const char* name, int64_t* value)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(value, "value");
      own.settings.get(name, *value);
    });
}

ahd_status ahd_get_double(ahd_job* job, const char* name, double* value)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(value, "value");
      own.settings.get(name, *value);
    });
}

ahd_status ahd_set_array(ahd_job* job, const char* name, const ahd_array* array)
{
  return call(job,
    [=](ahd::Job& own)
    {
      const ahd::GivenArray given = array ? ahd::arrayOf(*array) : ahd::GivenArray();
      own.setArray(name, array ? &given : nullptr);
    });
}

ahd_status ahd_set_projection(ahd_job* job, ahd_projection projection, void* user)
{
  return call(job, [=](ahd::Job& own) { own.setProjection(projection, user); });
}

ahd_status ahd_set_progress(ahd_job* job, ahd_progress progress, void* user)
{
  return call(job, [=](ahd::Job& own) { own.progress.setCallback(progress, user); });
}

ahd_status ahd_estimate(ahd_job* job, uint64_t* bytes)
{
  return give(job, bytes, "bytes", [=](ahd::Job& own) { return own.estimate(); });
}

ahd_status ahd_run(ahd_job* job)
{
  return call(job, [](ahd::Job& own) { own.run(); });
}

void ahd_cancel(ahd_job* job)
{
  if (job)
  {
    job->job.progress.cancel();
  }
}

uint64_t ahd_kept_bytes(ahd_job* job)
{
  uint64_t bytes = 0;
  call(job, [&bytes](ahd::Job& own) { bytes = own.keptBytes(); });
  return bytes;
}

ahd_status ahd_release(ahd_job* job, uint64_t most)
{
  return call(job, [=](ahd::Job& own) { own.release(static_cast<std::size_t>(most)); });
}

ahd_status ahd_reset(ahd_job* job, uint64_t most)
{
  return call(job, [=](ahd::Job& own) { own.reset(static_cast<std::size_t>(most)); });
}

ahd_status ahd_to_plane(ahd_job* job, double* xyz, uint64_t count)
{
  return call(job,
    [=](ahd::Job& own)
    {
      if (count > 0)
      {
        mustHave(xyz, "xyz");
      }
      ahd::checkCount(count, "points");
      own.toPlane(xyz, static_cast<std::size_t>(count));
    });
}

ahd_status ahd_fit_plane(ahd_job* job, double matrix[16])
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(matrix, "matrix");
      own.fitPlane(matrix);
    });
}

ahd_status ahd_choose_plane(ahd_job* job, int64_t* plane)
{
  return give(job, plane, "plane", [](ahd::Job& own) { return std::int64_t(own.choosePlane()); });
}

ahd_status ahd_count(ahd_job* job, const char* name, int64_t* value)
{
  return give(job, value, "value", [=](ahd::Job& own) { return ahd::countOf(own, name); });
}

ahd_status ahd_measure(ahd_job* job, const char* name, double* value)
{
  return give(job, value, "value", [=](ahd::Job& own) { return ahd::measureOf(own, name); });
}

ahd_status ahd_counts(ahd_job* job, int64_t* values, uint64_t capacity)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(values, "values");
      ahd::writeCounts(own, values, capacity);
    });
}

ahd_status ahd_measures(ahd_job* job, double* values, uint64_t capacity)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(values, "values");
      ahd::writeMeasures(own, values, capacity);
    });
}

ahd_status ahd_array_size(ahd_job* job, const char* name, uint64_t* rows, uint64_t* columns)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(rows, "rows");
      mustHave(columns, "columns");
      const ahd::ArrayShape shape = ahd::shapeOf(own, name);
      *rows = shape.rows;
      *columns = shape.columns;
    });
}

ahd_status ahd_get_array(ahd_job* job, const char* name, int32_t type, void* out, uint64_t capacity)
{
  return call(job, [=](ahd::Job& own) { ahd::writeArray(own, name, type, out, capacity); });
}

ahd_status ahd_draw_order(ahd_job* job, int32_t type, const ahd_drawing* drawing)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(drawing, "drawing");
      ahd::drawOrder(own, type,
        { drawing->xyz, drawing->ranks, drawing->ids, drawing->levels, drawing->counts });
    });
}

ahd_status ahd_interpolate(ahd_job* job, int32_t where, double* values, int32_t columns)
{
  return call(job, [=](ahd::Job& own) { ahd::interpolate(own, where, values, columns); });
}

ahd_status ahd_locate(
  ahd_job* job, const double* xy, uint64_t count, int32_t* kinds, int64_t* ids, int64_t* cells)
{
  return call(job, [=](ahd::Job& own) { ahd::locate(own, xy, count, { kinds, ids, cells }); });
}

ahd_status ahd_sample(
  ahd_job* job, const ahd_places* places, const ahd_sampled* arrays, uint64_t count, uint8_t* mask)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(places, "places");
      ahd::Sampling sampling(own, ahd::placesOf(*places));
      sampling.values(ahd::samplesOf(arrays, count), mask);
    });
}

ahd_status ahd_sample_estimate(
  ahd_job* job, const ahd_places* places, uint64_t columns, uint64_t* bytes)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(places, "places");
      mustHave(bytes, "bytes");
      ahd::Sampling(own, ahd::placesOf(*places)).estimate(columns, *bytes);
    });
}

ahd_status ahd_sample_estimate_before(ahd_job* job, uint64_t points, const ahd_places* places,
  uint64_t columns, int32_t fills, uint64_t* bytes)
{
  return call(job,
    [=](ahd::Job&)
    {
      mustHave(places, "places");
      mustHave(bytes, "bytes");
      *bytes = ahd::samplingEstimate(points, ahd::placesOf(*places), columns, fills != 0);
    });
}

ahd_status ahd_sample_weights(ahd_job* job, const ahd_places* places)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(places, "places");
      ahd::Sampling(own, ahd::placesOf(*places)).weights();
    });
}

ahd_status ahd_outline(ahd_job* job, ahd_outline_report* report)
{
  return outlineOf(job, false, report);
}

ahd_status ahd_outline_directed(ahd_job* job, ahd_outline_report* report)
{
  return outlineOf(job, true, report);
}

ahd_status ahd_within_radius(ahd_job* job, double radius, uint8_t* kept)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(kept, "kept");
      own.findWithin(radius, kept);
    });
}

uint64_t ahd_say(ahd_job* job, int32_t topic, int32_t words, const ahd_fact* facts, uint64_t count,
  char* out, uint64_t capacity)
{
  if (!job)
  {
    ahd_job none;
    return ahd_say(&none, topic, words, facts, count, out, capacity);
  }
  std::string said;
  const auto say = [&](ahd::Job& own)
  {
    const ahd::Wording wording = ahd::wordingOf(words);
    ahd::Facts known = ahd::factsOf(own, ahd::factsOf(facts, count));
    for (const ahd::Message& one : ahd::messages(ahd::Topic(topic), wording, std::move(known)))
    {
      said += one.name + std::string(1, '\0') + one.text + '\0';
    }
    said += '\0';
  };
  if (call(job, say) != AHD_OK)
  {
    return 0;
  }
  const bool fits = said.size() <= capacity;
  if (out && capacity > 0)
  {
    std::copy_n(fits ? said.data() : "", fits ? said.size() : 1, out);
  }
  return said.size();
}

const char* ahd_name(int32_t kind, uint32_t number)
{
  switch (kind)
  {
    case AHD_INT_SETTINGS:
      return ahd::JobSettings::intName(number);
    case AHD_DOUBLE_SETTINGS:
      return ahd::JobSettings::doubleName(number);
    case AHD_INPUT_ARRAYS:
      return ahd::InputArrays::name(number);
    case AHD_COUNTS:
      return ahd::countName(number);
    case AHD_MEASURES:
      return ahd::measureName(number);
    case AHD_OUTPUT_ARRAYS:
      return ahd::outputArrayName(number);
    default:
      return nullptr;
  }
}

const char* ahd_status_name(ahd_status status)
{
  static const char* const kNames[] = { "AHD_OK", "AHD_CANCELLED", "AHD_TOO_MANY_POINTS",
    "AHD_TOO_MANY_BOXES", "AHD_OUT_OF_MEMORY", "AHD_MEMORY_LIMIT", "AHD_TOO_MANY_CROSSINGS",
    "AHD_UNKNOWN_NAME", "AHD_BAD_VALUE", "AHD_BAD_ARRAY", "AHD_NOT_AVAILABLE", "AHD_BUSY",
    "AHD_NO_JOB", "AHD_FAILED" };
  return status >= AHD_OK && status <= AHD_FAILED ? kNames[status] : "?";
}

uint32_t ahd_processors(void)
{
  return ahd::availableProcessors();
}

uint64_t ahd_available_memory(void)
{
  return ahd::availableMemory();
}

void ahd_fingerprint(const void* bytes, uint64_t count, uint64_t kind, uint64_t out[2])
{
  out[0] = out[1] = 0;
  if (count > ahd::kMostNumbers || (count > 0 && !bytes))
  {
    return;
  }
  const auto* const begin = static_cast<const unsigned char*>(bytes);
  const std::size_t words = static_cast<std::size_t>(count) / ahd::FingerprintSum::kWord;
  ahd::FingerprintSum sum;
  sum.add(begin, 0, words, words);
  const ahd::Fingerprint found = sum.finish(begin, static_cast<std::size_t>(count), kind);
  out[0] = found[0];
  out[1] = found[1];
}
