// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Rounds_h
#define ahd_Rounds_h

#include "../Points/Points.h"

#include <algorithm>
#include <cstddef>

namespace ahd
{

/// Of an order and of each subset of it, every so many-th point belongs to the next subset.
/// Measured: 8 to 16 are alike (CPU time per point), 4 and less or 32 and more are slower.
constexpr std::size_t kControlStride = 12;

/// Control points at every level: the places 0 to n - 1 of an order in rounds. The first round is
/// the multiples of the highest power of kControlStride below n, each later one the multiples of
/// the next lower power that are not in a round before, the last what remains; ascending in each.
/// A round is known by its stride, that power.
class Rounds
{
public:
  explicit Rounds(std::size_t n)
    : n_(n)
  {
    while (first_ * kControlStride < n)
    {
      first_ *= kControlStride;
    }
  }

  std::size_t firstStride() const { return first_; }

  /// The number of places in the rounds before this one.
  std::size_t before(std::size_t stride) const
  {
    return stride == first_ ? 0 : multiples(stride * kControlStride, n_);
  }
  /// The number of places in this round.
  std::size_t size(std::size_t stride) const { return multiples(stride, n_) - before(stride); }

  /// The k-th place of this round.
  std::size_t place(std::size_t stride, std::size_t k) const
  {
    return stride * (stride == first_ ? k : k + k / (kControlStride - 1) + 1);
  }
  /// The inverse: which place of this round it is, or the next one not below it.
  std::size_t index(std::size_t stride, std::size_t place) const
  {
    const std::size_t multiple = multiples(stride, place);
    return stride == first_ ? multiple : multiple - multiples(kControlStride, multiple);
  }

private:
  /// How many of the numbers 0 to end - 1 are multiples of `stride`.
  static std::size_t multiples(std::size_t stride, std::size_t end)
  {
    return (end + stride - 1) / stride;
  }

  std::size_t n_;
  std::size_t first_ = 1;
};

} // namespace ahd

#endif
