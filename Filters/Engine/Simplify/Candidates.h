// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Candidates_h
#define ahd_Candidates_h

#include "../Core/Buffer.h"
#include "../Core/Progress.h"
#include "../Order/RankedPoints.h"
#include "Measure.h"
#include "Simplify.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ahd
{

/// The distinct finite points by rank, with their values.
class Candidates
{
public:
  /// The bytes a point for all of it, while it is made and afterwards.
  static constexpr std::size_t kBytesToRead = 20 + 60;
  static constexpr std::size_t kBytes = sizeof(Sample) + 4 + 8;

  /// @return Ok, Cancelled or TooManyPoints. Throws std::bad_alloc.
  Status read(const SimplifyRequest& request, const Context& context);

  Index count() const { return ranked_.count; }
  const Point& place(Index rank) const { return samples_[rank].at; }
  /// The value times scale().
  const Sample& sample(Index rank) const { return samples_[rank]; }
  double weight(Index rank) const { return weights_.empty() ? 1.0 : weights_[rank]; }
  Index id(Index rank) const { return ranked_.id[rank]; }
  /// A power of two that makes all finite values at most 1.
  double scale() const { return scale_; }
  const std::vector<Duplicate>& duplicates() const { return duplicates_; }

  /// Those that stay, ascending: corners of the hull, ends of constraints, marked ones, and those
  /// without a value or weight. Empty if there is no triangle.
  const std::vector<Index>& staying() const { return staying_; }
  /// Three of these, not collinear.
  const std::array<Index, 3>& first() const { return first_; }
  /// Constraints, as pairs of ranks, in their order; without those that have an end without vertex.
  const std::vector<std::array<Index, 2>>& segments() const { return segments_; }

private:
  bool readNumbers(const SimplifyRequest& request, Ticker& ticker);
  bool readValues(const SimplifyRequest& request, Ticker& ticker);
  bool findRanks(const SimplifyRequest& request, Ticker& ticker);
  bool readConstraints(const ConstraintView& constraints, Ticker& ticker);
  bool listStaying(
    const SimplifyRequest& request, const std::vector<Index>& corners, Ticker& ticker);

  RankedPoints ranked_;
  std::vector<Duplicate> duplicates_;
  Buffer<Index> rankOf_; ///< of each id, or kNoIndex
  Buffer<Sample> samples_;
  Buffer<double> weights_;
  double scale_ = 1.0;
  std::vector<Index> staying_;
  std::array<Index, 3> first_{};
  std::vector<std::array<Index, 2>> segments_;
};

} // namespace ahd

#endif
