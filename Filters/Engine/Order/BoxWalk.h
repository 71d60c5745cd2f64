// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BoxWalk_h
#define ahd_BoxWalk_h

#include "../Core/Buffer.h"
#include "../Core/Progress.h"
#include "../Options.h"
#include "RankedPoints.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// Points sorted by rank: the input of a walk over the boxes.
struct WalkPoints
{
  const std::uint64_t* key; ///< Hilbert keys, ascending
  const Index* rank;        ///< rank of each point; null if point i has rank i
  std::size_t count;
};

/// Points that share a box; the box comprises all keys that agree with theirs above `bits` bits.
struct WalkBox
{
  std::size_t begin, end;
  unsigned bits;
};

/// Divides boxes.
class Divider
{
public:
  Divider(const Options& options, Ticker& ticker)
    : options_(options)
    , ticker_(ticker)
  {
  }

  /// The boxes of one division that are not empty, in the order in which `options` visit them.
  /// Returns false if cancelled. @pre 2 * levels <= box.bits.
  bool divide(const WalkPoints& points, const WalkBox& box, unsigned levels,
    std::vector<WalkBox>& boxes) const;

private:
  bool reorder(const WalkPoints& points, unsigned levels, std::vector<WalkBox>& boxes) const;

  const Options& options_;
  Ticker& ticker_;
};

/// Writes the ranks of all points to `to`, box by box as makeSequence says, and advances it.
/// `levels` is the first division's, 0 for none. Returns false if cancelled.
class BoxWalk
{
public:
  BoxWalk(const RankedPoints& ranked, const Options& options, Ticker& ticker);

  bool walk(const WalkPoints& points, unsigned levels, Index* to);

private:
  static constexpr std::size_t kFew = 64;

  bool walkAlongKeys(const WalkBox& whole, unsigned levels);
  bool walkReordered(const WalkBox& whole, unsigned levels);
  bool isDivided(const WalkBox& box) const;
  bool leave(const WalkBox& box);
  bool leaveByRank(const WalkBox& box);
  bool leaveFewById(const WalkBox& box);
  bool leaveManyById(const WalkBox& box);
  Index rankOf(std::size_t i) const { return points_.rank ? points_.rank[i] : Index(i); }

  const RankedPoints& ranked_;
  const Options& options_;
  Ticker& ticker_;
  WalkPoints points_{};
  Index* to_ = nullptr;
};

} // namespace ahd

#endif
