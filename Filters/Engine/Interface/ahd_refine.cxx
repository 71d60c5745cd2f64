// SPDX-License-Identifier: BSD-3-Clause
//
// The part of the C interface that refines.
#include "ahd_refine.h"

#include "Call.h"

#include <algorithm>

using namespace ahd::calls;

namespace
{

/// Copies three numbers of each item; kNoIndex becomes -1.
void writeCorners(const std::array<ahd::Index, 3>& corners, int64_t* to)
{
  std::transform(corners.begin(), corners.end(), to,
    [](ahd::Index id) { return id == ahd::kNoIndex ? -1 : int64_t(id); });
}

void writePoints(const ahd::Refinement& made, const ahd_refined& to)
{
  for (std::size_t k = 0; k < made.points.size(); ++k)
  {
    const ahd::SteinerPoint& p = made.points[k];
    if (to.places)
    {
      to.places[2 * k] = p.x;
      to.places[2 * k + 1] = p.y;
    }
    if (to.corners)
    {
      writeCorners(p.corners, to.corners + 3 * k);
    }
    if (to.weights)
    {
      std::copy(p.weights.begin(), p.weights.end(), to.weights + 3 * k);
    }
  }
}

void writeBad(const ahd::Refinement& made, const ahd_refined& to)
{
  for (std::size_t k = 0; k < made.bad.size(); ++k)
  {
    if (to.bad)
    {
      writeCorners(made.bad[k].corners, to.bad + 3 * k);
    }
    if (to.reasons)
    {
      to.reasons[k] = int32_t(made.bad[k].reason);
    }
  }
}

} // namespace

ahd_status ahd_refine(ahd_job* job, const ahd_refine_request* request, ahd_refine_report* report)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(request, "request");
      mustHave(report, "report");
      const ahd::RefineRequest wished = { request->minimum_angle, request->maximum_area,
        request->maximum_length, request->sizes, std::size_t(request->most_points) };
      const ahd::Refinement& made = own.refine(wished);
      const std::size_t chains = made.constraints().chains;
      *report = { made.points.size(), made.onSegments, made.triangles, made.ids.size(), chains,
        made.lines, made.bad.size(), made.encroachedPieces };
    });
}

ahd_status ahd_refine_write(ahd_job* job, const ahd_refined* arrays)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(arrays, "arrays");
      const ahd::Refinement& made = own.refined();
      writePoints(made, *arrays);
      writeBad(made, *arrays);
      if (arrays->ids)
      {
        std::copy(made.ids.begin(), made.ids.end(), arrays->ids);
      }
      if (arrays->offsets)
      {
        arrays->offsets[0] = 0; // without a triangle there is no chain
        std::copy(made.offsets.begin(), made.offsets.end(), arrays->offsets);
      }
    });
}
