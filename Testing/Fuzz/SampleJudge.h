// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SampleJudge_h
#define ahd_SampleJudge_h

#include "FuzzCase.h"
#include "Triangulation/Triangulation.h"

#include <cstdint>
#include <vector>

namespace ahd
{
namespace fuzz
{

/// A triangulation to sample, and its outputs.
struct ToSample
{
  Triangulation& made;
  const PointView& points;
  const std::vector<std::int32_t>& triples; ///< the kept triangles
  Executor* executor = nullptr;
};

/// Values between the points, by every method, at places on points, on edges, anywhere and on a
/// raster. They are the sums of their weights times values; weights are none below 0 and sum to 1;
/// there are some where locate() finds a kept triangle and none outside; a raster gives what its
/// places give. Few points go through the oracle too: linear and nearest always, natural neighbours
/// where coordinates are small integers. Cancelled and without memory it reports it.
void expectSamples(const FuzzCase& given, const ToSample& surface);

} // namespace fuzz
} // namespace ahd

#endif
