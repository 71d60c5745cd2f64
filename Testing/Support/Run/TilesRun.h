// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_TilesRun_h
#define ahd_TilesRun_h

#include "EngineRun.h"
#include "Tiles/TileCounter.h"
#include "Tiles/TileVisits.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// How points are divided into leaves and visited.
struct TilesWay
{
  std::uint64_t most = 100; ///< points of a leaf
  Bounds extent;            ///< of places; empty: none
  Bounds guess;             ///< of the points' bounds
  TileLines lines;
  Representative representative = Representative::FirstId;
  std::size_t threads = 1; ///< that visit leaves at once
  Context context;
  std::function<Status(const std::function<Status()>&)> call = nullptr; ///< calls its argument
};

/// Chains by places; where an id is no point's, by none.
TileLines linesOf(const std::vector<Point>& points, const ConstraintView& chains, FillRule rule);

/// The points of a leaf with those of its list, as one run sees them.
struct SecondVisit
{
  std::vector<std::int64_t> ids; ///< first the leaf's
  std::vector<double> xyz;
  std::size_t own = 0;
  std::size_t listed = 0;
  Options options;

  PointView view() const { return { xyz.data(), ids.size(), 3 }; }
};

/// Many points leaf by leaf: all steps that a caller takes, with the bytes in memory.
class TilesRun
{
public:
  /// Counts, divides, visits all leaves and merges.
  TilesRun(const PointView& points, const TilesWay& way);

  Status status = Status::Ok;
  std::string fault;            ///< refused by a check
  std::size_t borderPoints = 0; ///< of all leaves
  /// TileConstraints, as the root tells them; visits that tell others are a fault.
  std::vector<std::int64_t> constraints;
  bool isFine() const
  {
    const std::lock_guard<std::mutex> lock(telling_);
    return status == Status::Ok && fault.empty();
  }

  const TileVisits& visits() const { return *visits_; }
  const TilePlan& plan() const { return visits_->plan(); }

  /// The stream of all leaves: ids, and edges.
  std::vector<std::int64_t> triangles(std::vector<std::uint8_t>* edges = nullptr);
  SecondVisit second(std::size_t leaf);
  /// With lines: the triangles that values at its places need.
  TileOutput surface(std::size_t leaf, double longest = 0.0);
  /// The same stream by second visits alone.
  std::vector<std::int64_t> trianglesOfSecondVisits();

  TilePoints pointsOf(std::size_t leaf) const;
  const std::vector<BlockBytes>& borders() const { return borders_; }
  const std::vector<BlockBytes>& owns() const { return owns_; }
  const std::vector<BlockBytes>& shares() const { return shares_; }
  /// Of the nodes above a leaf.
  std::vector<TileView> sharesFor(std::size_t leaf) const;

private:
  bool call(const std::function<Status()>& work);
  bool count(const PointView& points, TileFacts& facts);
  void deal(const PointView& points);
  void visitAll();
  bool fits(const TilePoints& given);
  bool read(std::size_t leaf, TileKept& kept);
  void visit(std::size_t leaf);
  void merge(std::size_t node);
  void compare(const TileOutput& made);

  TilesWay way_;
  std::unique_ptr<TileVisits> visits_;
  std::vector<std::vector<double>> xyz_;            ///< of each leaf
  std::vector<std::vector<std::int64_t>> ids_;      ///< the same
  std::vector<BlockBytes> borders_, owns_, shares_; ///< of parts
  mutable std::mutex telling_;
};

/// A raster of so many cells along a side around the points, with some beyond, its rows from above;
/// without cells if there is no width.
SampleRaster rasterAround(const Bounds& bounds, std::size_t side);
/// Of its cells' centres.
Bounds boundsOf(const SampleRaster& raster);

inline TileView viewOf(const BlockBytes& bytes)
{
  return { bytes.data(), bytes.size() };
}

/// The triangles of one run.
std::vector<std::int64_t> trianglesOfOneRun(
  const PointView& points, Representative representative = Representative::FirstId);

} // namespace test
} // namespace ahd

#endif
