// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ConstraintFill_h
#define ahd_ConstraintFill_h

#include "CertifiedMesh.h"
#include "Constraints.h"

#include <cstdint>
#include <vector>

namespace ahd
{
namespace test
{

/// How often loops pass along a half-edge, and how often against it.
struct LoopUses
{
  int along = 0;
  int against = 0;
};

/// By triangle of the whole hull: does the rule keep it? `uses`: by half-edge; those of loops that
/// are filled. Uses that are not those of closed loops are a fault of the mesh.
std::vector<char> keptByRule(CertifiedMesh& mesh, FillRule rule, const std::vector<LoopUses>& uses);

/// By triangle: the number of its region, in the order of their first triangles; -1 if it is not
/// kept. `border`: by half-edge, does it separate regions?
std::vector<std::int64_t> regionsOf(
  const CertifiedMesh& mesh, const std::vector<char>& kept, const std::vector<char>& border);

} // namespace test
} // namespace ahd

#endif
