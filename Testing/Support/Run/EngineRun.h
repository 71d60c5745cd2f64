// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_EngineRun_h
#define ahd_EngineRun_h

#include "Certifier.h"
#include "Distributions.h"
#include "Engine.h"
#include "Oracle.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// All results of one run of the engine.
struct Outcome
{
  Status status = Status::Ok;
  Report report;
  std::vector<std::int32_t> triples;     ///< three ids per triangle
  std::vector<std::int64_t> pointStatus; ///< one per point
};

/// run(), writeTriangles() and writePointStatus() in one call. `status` is that of the first call
/// that was not Ok; outputs not written by then stay empty.
Outcome triangulate(Engine& engine, const PointView& points, const Options& options = Options(),
  Progress* progress = nullptr);
Outcome triangulate(const PointView& points, const Options& options = Options());
Outcome triangulate(const std::vector<Point>& points, const Options& options = Options());

PointView viewOf(const std::vector<Point>& points);

/// Is the run Ok, its result correct (certify) and its Report consistent with it? Empty if so.
std::string faultsOf(const PointView& points, const Outcome& outcome);
std::string faultsOf(const std::vector<Point>& points, const Outcome& outcome);

/// Every combination of order, control points and gene rotation with each of these Nmax.
std::vector<Options> everySetting(const std::vector<int>& nmax = { 1, 2, 50, 1000 });

/// The same without those that differ only in options that their order ignores (Options.h).
std::vector<Options> everyDistinctSetting(const std::vector<int>& nmax = { 1, 2, 50, 1000 });

/// "HG, control points 2, genes on, Nmax 50".
std::string describe(const Options& options);

/// The number of points for a test planned with `n`: fewer under sanitizers.
std::size_t reduced(std::size_t n);

/// reduced(n), and fewer still for distributions whose every predicate takes numbers of thousands
/// of bits.
std::size_t affordable(Distribution distribution, std::size_t n);

} // namespace test
} // namespace ahd

#endif
