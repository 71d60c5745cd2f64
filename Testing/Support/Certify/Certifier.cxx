// SPDX-License-Identifier: BSD-3-Clause
#include "Certifier.h"

#include "CertifiedMesh.h"

namespace ahd
{
namespace test
{

std::string joined(const Complaints& complaints)
{
  std::string result;
  for (const std::string& complaint : complaints)
  {
    result += complaint + "\n";
  }
  return result;
}

Complaints certify(const PointView& points, const std::vector<std::int32_t>& triples,
  const std::vector<std::int64_t>& pointStatus)
{
  CertifiedMesh mesh(points, triples, pointStatus);
  if (mesh.check())
  {
    mesh.checkDelaunay({});
  }
  return mesh.faults().all();
}

} // namespace test
} // namespace ahd
