// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RefineRun_h
#define ahd_RefineRun_h

#include "../Prepare/Prepare.h"
#include "../Refine/RefinedMesh.h"
#include "CheckedMemory.h"
#include "Messages.h"
#include "RunProgress.h"

#include <cstddef>
#include <string>

namespace ahd
{

/// The caller's part of the memory of a refinement, in bytes.
struct RefineMemory
{
  std::size_t limit = 0; ///< 0: what the process can get
  std::size_t other = 0; ///< what the caller holds
};

/// What was triangulated, and who does the work.
struct RefineInput
{
  const PreparedInput& points;
  const Options& options;
  Triangulation& made;
  RunProgress& progress;
  Executor* executor;

  Context context() const { return { &progress, executor }; }
};

/// refine(), unless it takes more memory than allowed, and its pieces. `checked` has what was
/// needed. Refinement::fault as there.
Status refineWithin(CheckedMemory& checked, const RefineMemory& memory, const RefineInput& input,
  const RefineRequest& request, RefinedMesh& out);

/// The facts of a refused refinement, or of one that ran out of memory.
inline Facts factsOf(const CheckedMemory& checked, Status status, const RefineInput& input)
{
  return checked.facts(status, "refining", { "points", input.points.points().count });
}

/// The text of a refusal; empty for none.
std::string refineFaultText(const RefineRequest& request, RefineFault fault, std::size_t at);

/// describeTriangles(), from the triangulation that was refined. @pre fit()
Status describeRefined(const RefineInput& input, const RefinedMesh& mesh, MeshTriangles& triangles);

} // namespace ahd

#endif
