// SPDX-License-Identifier: BSD-3-Clause
//
// The part of the C interface that refines.
#include "ahd_refine.h"

#include "Call.h"

#include <algorithm>

using namespace ahd::calls;

namespace
{

/// Copies the ids of an item; kNoIndex becomes -1.
template <std::size_t N>
void writeIds(const std::array<ahd::Index, N>& ids, int64_t* to)
{
  std::transform(ids.begin(), ids.end(), to,
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
      writeIds(p.corners, to.corners + 3 * k);
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
      writeIds(made.bad[k].corners, to.bad + 3 * k);
    }
    if (to.reasons)
    {
      to.reasons[k] = int32_t(made.bad[k].reason);
    }
  }
}

void writePieces(const ahd::RefinedMesh& made, const ahd_refined& to)
{
  for (std::size_t k = 0; k < made.pieces.size(); ++k)
  {
    const ahd::MeshPiece& piece = made.pieces[k];
    if (to.pieces)
    {
      writeIds(piece.ids, to.pieces + 2 * k);
    }
    if (to.piece_edges)
    {
      writeIds(piece.edge, to.piece_edges + 2 * k);
    }
    if (to.piece_cells)
    {
      to.piece_cells[k] = piece.cell;
    }
  }
}

} // namespace

ahd_status ahd_refine(ahd_job* job, const ahd_refine_request* request, ahd_refine_report* report)
{
  ahd::CheckedMemory checked;
  const auto refine = [&](ahd::Job& own)
  {
    mustHave(request, "request");
    mustHave(report, "report");
    *report = {};
    const ahd::RefineRequest wished = { request->minimum_angle, request->maximum_area,
      request->maximum_length, request->sizes, std::size_t(request->most_points) };
    const ahd::RefinedMesh& mesh = own.refine(checked, wished);
    const ahd::Refinement& made = mesh.found;
    const std::size_t chains = made.constraints().chains;
    *report = { made.points.size(), made.onSegments, made.triangles, made.ids.size(), chains,
      made.lines, made.bad.size(), made.encroachedPieces, mesh.pieces.size(), mesh.innerPieces, 0,
      0 };
  };
  const ahd_status status = call(job, refine);
  if (report)
  {
    report->memory_needed = checked.needed;
    report->memory_allowed = checked.allowed;
  }
  return status;
}

ahd_status ahd_refine_write(ahd_job* job, const ahd_refined* arrays)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(arrays, "arrays");
      const ahd::Refinement& made = own.refined().found;
      writePoints(made, *arrays);
      writeBad(made, *arrays);
      writePieces(own.refined(), *arrays);
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

ahd_status ahd_refine_triangles(ahd_job* job, ahd_refined_triangles* triangles)
{
  return call(job,
    [=](ahd::Job& own)
    {
      mustHave(triangles, "triangles");
      if (triangles->count > 0)
      {
        mustHave(triangles->corners, "corners");
      }
      ahd::MeshTriangles to = { triangles->corners, std::size_t(triangles->count),
        triangles->regions, triangles->bad, 0.0 };
      own.describeRefined(to);
      triangles->least_angle = to.leastAngle;
    });
}
