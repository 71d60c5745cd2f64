// SPDX-License-Identifier: BSD-3-Clause
//
// The part of the C interface for points that come, go and move.
#include "ahd_edit.h"

#include "../Job/Arrays.h"
#include "Call.h"

#include <algorithm>

using namespace ahd::calls;

namespace
{

using ahd::Context;
using ahd::Edit;
using ahd::EditOutcome;
using ahd::Status;

ahd::PointView viewOf(const double* xy, uint64_t count)
{
  return ahd::PointView(xy, static_cast<std::size_t>(count), 2);
}

/// Calls work(edit, context, outcomes) for so many requests, which lie at `given`.
template <typename Work>
ahd_status request(
  ahd_job* job, const void* given, uint64_t count, uint8_t* outcomes, const Work& work)
{
  static_assert(sizeof(EditOutcome) == sizeof(*outcomes), "one is written as the other");
  return call(job,
    [&](ahd::Job& own)
    {
      if (count > 0)
      {
        mustHave(given, "requests");
        mustHave(outcomes, "outcomes");
      }
      ahd::checkCount(count, "requests");
      std::fill_n(outcomes, count, uint8_t(AHD_EDIT_NOT_TRIED));
      own.editWith(0,
        [&](Edit& edit, const Context& context)
        { return work(edit, context, reinterpret_cast<EditOutcome*>(outcomes)); });
    });
}

} // namespace

ahd_status ahd_edit_insert(ahd_job* job, const double* xy, uint64_t count, int64_t* first)
{
  return call(job,
    [=](ahd::Job& own)
    {
      if (count > 0)
      {
        mustHave(xy, "points");
      }
      mustHave(first, "first id");
      own.editWith(count,
        [&](Edit& edit, const Context& context)
        { return edit.insert(viewOf(xy, count), context, *first); });
    });
}

ahd_status ahd_edit_remove(ahd_job* job, const int64_t* ids, uint64_t count, uint8_t* outcomes)
{
  return request(job, ids, count, outcomes,
    [=](Edit& edit, const Context& context, EditOutcome* out)
    { return edit.remove(ids, static_cast<std::size_t>(count), context, out); });
}

ahd_status ahd_edit_move(
  ahd_job* job, const int64_t* ids, const double* xy, uint64_t count, uint8_t* outcomes)
{
  return request(job, xy ? ids : nullptr, count, outcomes,
    [=](Edit& edit, const Context& context, EditOutcome* out)
    { return edit.move(ids, viewOf(xy, count), context, out); });
}

ahd_status ahd_edit_constrain(ahd_job* job, const int64_t* ends, uint64_t count, uint8_t* outcomes)
{
  return request(job, ends, count, outcomes,
    [=](Edit& edit, const Context& context, EditOutcome* out)
    { return edit.constrain(ends, static_cast<std::size_t>(count), context, out); });
}

ahd_status ahd_edit_release(ahd_job* job, const int64_t* ends, uint64_t count, uint8_t* outcomes)
{
  return request(job, ends, count, outcomes,
    [=](Edit& edit, const Context& context, EditOutcome* out)
    { return edit.release(ends, static_cast<std::size_t>(count), context, out); });
}

ahd_status ahd_edit_locate(
  ahd_job* job, const double* xy, uint64_t count, int32_t* kinds, int64_t* ids)
{
  return call(job,
    [=](ahd::Job& own)
    {
      if (count > 0)
      {
        mustHave(xy, "places");
        mustHave(kinds, "kinds");
        mustHave(ids, "ids");
      }
      ahd::checkCount(count, "places");
      std::vector<ahd::EditPlace> found(static_cast<std::size_t>(count));
      own.editWith(0,
        [&](Edit& edit, const Context& context)
        { return edit.locate(viewOf(xy, count), context, found.data()); });
      for (std::size_t k = 0; k < found.size(); ++k)
      {
        kinds[k] = static_cast<int32_t>(ahd::kindOf(found[k].kind));
        std::copy(found[k].ids.begin(), found[k].ids.end(), ids + 3 * k);
      }
    });
}

ahd_status ahd_edit_size(ahd_job* job, uint64_t* points, uint64_t* segments)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(points, "points");
      mustHave(segments, "segments");
      *points = own.edited().pointCount();
      *segments = own.edited().segmentCount();
    });
}

ahd_status ahd_edit_ready(ahd_job* job, int32_t* ready)
{
  return give(job, ready, "ready", [](ahd::Job& own) { return int32_t(own.edited().isReady()); });
}

ahd_status ahd_edit_write(ahd_job* job, int64_t* ids, double* xy, int64_t* pairs)
{
  return call(job,
    [=](ahd::Job& own)
    {
      ahd::EditedInput left;
      own.editWith(
        0, [&](Edit& edit, const Context& context) { return edit.write(left, context); });
      mustHave(left.ids.empty() || ids ? "" : nullptr, "ids");
      mustHave(left.ids.empty() || xy ? "" : nullptr, "points");
      mustHave(left.segments.empty() || pairs ? "" : nullptr, "segments");
      std::copy(left.ids.begin(), left.ids.end(), ids);
      for (std::size_t k = 0; k < left.places.size(); ++k)
      {
        xy[2 * k] = left.places[k].x;
        xy[2 * k + 1] = left.places[k].y;
      }
      std::copy(left.segments.begin(), left.segments.end(), pairs);
    });
}
