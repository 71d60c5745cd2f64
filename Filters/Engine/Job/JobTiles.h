// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobTiles_h
#define ahd_JobTiles_h

#include "../Core/AskedMemory.h"
#include "../Tiles/TileCounter.h"
#include "../Tiles/TileVisits.h"
#include "InputArrays.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ahd
{

/// Bytes that a caller kept.
struct GivenBytes
{
  const void* data;
  std::uint64_t size;
};

/// A leaf's points as the caller gives them.
struct GivenTile
{
  std::uint64_t leaf;
  GivenArray points;
  const std::int64_t* ids; ///< null: none
};

/// What a caller kept for the second visit of a leaf.
struct GivenKept
{
  GivenBytes own;
  std::vector<GivenBytes> shares;
};

struct MergeMemory
{
  std::size_t limit;  ///< in bytes; 0: what the process can get
  AskedMemory& asked; ///< what the context's progress is asked for
};

/// The plan as arrays.
struct TileTables
{
  BlockBytes plan;
  std::vector<std::int64_t> counts, parents;
  std::vector<double> boxes, bounds;
};

/// Many points leaf by leaf, for a job: the plan, and what the last visit gave. Its functions
/// refuse (Refusal.h) what is unfit, and where they are cancelled.
class JobTiles
{
public:
  /// `bounds`: xmin, xmax, ymin, ymax; null: none.
  void begin(const double* bounds);
  void count(const GivenArray& points, const Context& context);
  /// Is another pass needed?
  bool endPass(std::uint64_t most, const double* extent);
  void load(const GivenBytes& plan);
  /// Replaces those of the plan.
  void setLines(TileLines&& lines);

  const TilePlan& plan() const { return visits().plan(); }
  const TileOutput& output() const { return output_; }
  void clearOutput() { output_ = TileOutput(); }
  const TileTables& tables() const;

  void findLeaves(const GivenArray& points, std::int32_t* leaves, const Context& context) const;
  /// The cells of the raster that belong to the leaf.
  SampleRaster piece(std::uint64_t leaf, const SampleRaster& whole) const;

  void visit(const GivenTile& tile, Representative representative, const Context& context);
  void merge(std::uint64_t node, const std::vector<GivenBytes>& borders, const MergeMemory& memory,
    const Context& context);
  void makeTriangles(const GivenTile& tile, const GivenKept& bytes, const Context& context);
  void makeSurface(
    const GivenTile& tile, const GivenKept& bytes, double longest, const Context& context);
  void makeList(std::uint64_t leaf, const std::vector<GivenBytes>& shares, const Context& context);

private:
  const TileVisits& visits() const;
  std::size_t checkedLeaf(std::uint64_t leaf) const;
  void take(TileFacts&& facts);
  void refuseFault(const TilePoints& given, const Context& context) const;
  void readKept(std::size_t leaf, const TileView* own, const std::vector<GivenBytes>& shares,
    TileKept& kept) const;
  template <typename Make>
  void secondVisit(
    const GivenTile& tile, const GivenKept& bytes, const Context& context, const Make& make);

  std::unique_ptr<TileCounter> counter_; ///< between begin() and the end of the last pass
  std::unique_ptr<TileVisits> visits_;   ///< null: there is no plan
  TileTables tables_;
  TileOutput output_;
};

} // namespace ahd

#endif
