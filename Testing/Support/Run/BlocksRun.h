// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlocksRun_h
#define ahd_BlocksRun_h

#include "Distribute/BlockCuts.h"
#include "Distribute/BlockTriangulation.h"
#include "EngineRun.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// Settings of simulated blocks.
struct BlocksWay
{
  std::size_t blocks = 4;
  std::size_t blocksPerNode = 8;
  std::size_t samples = 512; ///< per block
  /// Gathers all borders of this level to one block; none if there is no such level.
  std::size_t gatherLevel = std::size_t(-1);
  std::size_t gatherBlock = 0;
  /// The block that owns a point; null: cut from samples.
  std::function<std::size_t(const Point&)> owner = nullptr;
  Options options;
  Context context;
};

/// The points of one block.
struct OwnPoints
{
  std::vector<double> xyz;
  std::vector<std::int64_t> ids;
  std::vector<unsigned char> skip;

  /// As the input of a block.
  BlockInput input(std::size_t block, std::size_t blocks) const;
};

std::vector<OwnPoints> deal(const PointView& points, const BlocksWay& way);

/// The results of all blocks together.
struct BlocksOutcome
{
  Status status = Status::Ok;
  BlocksReport report;
  std::vector<std::int32_t> triples; ///< of global ids, each from its smallest one, sorted
  std::vector<std::uint8_t> flags;   ///< of these: constraint edges, from the smallest id on
  std::vector<std::int64_t> pointStatus;
  std::vector<std::size_t> border; ///< points that each block sent
  std::vector<std::size_t> own;    ///< points of each block
  std::size_t bytesSent = 0;       ///< in messages to some
  std::string fault;               ///< inconsistencies: owners, numbers, sums
};

/// All blocks in this process, one after the other, step by step.
BlocksOutcome runBlocks(
  const PointView& points, const ConstraintView& constraints, FillRule rule, const BlocksWay& way);

/// The engine's result of one run, in the same form.
BlocksOutcome runWhole(const PointView& points, const ConstraintView& constraints, FillRule rule,
  const Options& options = Options());

/// The first difference, in words; empty if triangles, statuses and reports are the same.
std::string difference(const BlocksOutcome& whole, const BlocksOutcome& blocks);

} // namespace test
} // namespace ahd

#endif
