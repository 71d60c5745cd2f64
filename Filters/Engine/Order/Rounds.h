// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Rounds_h
#define ahd_Rounds_h

#include "../Points/Points.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ahd
{

/// Of an order and of each subset of it, one of every so many successive points belongs to the next
/// subset. Measured: 8 to 16 are alike (CPU time per point), 4 and less or 32 and more are slower.
constexpr std::size_t kControlStride = 12;

/// Control points at every level: the places 0 to n - 1 of an order in rounds. The order is cut
/// into blocks of kControlStride places, kControlStride blocks form a larger one, and so on, as
/// long as there are two blocks; the last of each size may have fewer. One of the blocks in a
/// larger one provides its control point, chosen by a hash of the number of the larger one: chosen
/// by its place, the first say, all would be alike where the order repeats itself (teeth of two
/// lengths, two rows of points), and not represent the points between them. The first round are the
/// control points of the largest blocks, each later one those of the next smaller blocks that are
/// not in a round before, ascending in each. A round is known by its stride, the size of its
/// blocks.
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
    return stride == first_ ? 0 : blocks(stride * kControlStride);
  }
  /// The number of places in this round.
  std::size_t size(std::size_t stride) const { return blocks(stride) - before(stride); }

  /// The k-th place of this round.
  std::size_t place(std::size_t stride, std::size_t k) const
  {
    if (stride == first_)
    {
      return controlPoint(stride, k);
    }
    const std::size_t parent = k / (kControlStride - 1);
    const std::size_t nth = k % (kControlStride - 1);
    const std::size_t skipped = nth >= lender(stride, parent) ? 1 : 0;
    return controlPoint(stride, parent * kControlStride + nth + skipped);
  }

  /// Writes `count` places of the last round, from its k-th on: as place() gives them, but each
  /// block's control point is looked up once. @pre there is a round before it.
  template <typename Out>
  void lastPlaces(std::size_t k, std::size_t count, Out* out) const
  {
    const Out* const end = out + count;
    std::size_t parent = k / (kControlStride - 1);
    std::size_t nth = k % (kControlStride - 1);
    while (out != end)
    {
      const std::size_t skipped = lender(1, parent);
      const std::size_t first = parent * kControlStride;
      for (; nth != kControlStride - 1 && out != end; ++nth)
      {
        *out++ = static_cast<Out>(first + nth + (nth >= skipped ? 1 : 0));
      }
      nth = 0;
      ++parent;
    }
  }

  static constexpr std::size_t kListed = 256;

  /// Lists places of this round, at most kListed, from its k-th on and before its end-th, and the
  /// one after them; where there is none, the last once more. Returns how many, that one not
  /// counted. @pre k < end <= size(stride); room for kListed + 1.
  template <typename Out>
  std::size_t list(std::size_t stride, std::size_t k, std::size_t end, Out* out) const
  {
    const std::size_t count = std::min(kListed, end - k);
    const std::size_t listed = std::min(count + 1, end - k);
    if (stride == 1 && stride != first_)
    {
      lastPlaces(k, listed, out);
    }
    else
    {
      for (std::size_t i = 0; i < listed; ++i)
      {
        out[i] = static_cast<Out>(place(stride, k + i));
      }
    }
    if (listed == count)
    {
      out[count] = out[count - 1];
    }
    return count;
  }

  /// How many places of this round are in the blocks before the one that `place` is in: the inverse
  /// of place(), if it is of this round. For n, how many there are.
  std::size_t index(std::size_t stride, std::size_t place) const
  {
    if (place == n_)
    {
      return size(stride);
    }
    const std::size_t block = place / stride;
    if (stride == first_)
    {
      return block;
    }
    const std::size_t parent = block / kControlStride;
    return block - parent - (block % kControlStride > lender(stride, parent) ? 1 : 0);
  }

private:
  /// How many blocks of this size there are.
  std::size_t blocks(std::size_t stride) const { return (n_ + stride - 1) / stride; }

  /// Which of the blocks of this size in the larger block `parent` provides the control point of
  /// that.
  std::size_t lender(std::size_t stride, std::size_t parent) const
  {
    constexpr std::uint64_t kMix = 0x9E3779B97F4A7C15u;
    std::uint64_t hash = (parent + stride) * kMix;
    hash = (hash ^ hash >> 32) * kMix >> 32;
    const std::size_t chosen = std::size_t(hash * kControlStride >> 32);
    return (parent * kControlStride + chosen) * stride < n_ ? chosen : 0;
  }

  std::size_t controlPoint(std::size_t stride, std::size_t block) const
  {
    while (stride > 1)
    {
      stride /= kControlStride;
      block = block * kControlStride + lender(stride, block);
    }
    return block;
  }

  std::size_t n_;
  std::size_t first_ = 1;
};

} // namespace ahd

#endif
