// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SegmentTree_h
#define ahd_SegmentTree_h

#include "../Core/Progress.h"
#include "../Points/BoxLevels.h"
#include "../Predicates/Discs.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// The ends of a segment.
struct EndPair
{
  Point from, to;
};

/// Tests whether a triangle is touched by one of many segments. Long segments lie in boxes of parts
/// of them, which follow each other along a Hilbert curve.
class SegmentTree
{
public:
  enum class Answer
  {
    Touched,
    Untouched,
    Cancelled
  };

  /// Queries will be limited to `region`. Cuts the segments into three times as many
  /// parts at most, and `extra` more. Returns false if the work is cancelled. Throws
  /// std::bad_alloc.
  bool build(
    std::vector<EndPair> segments, const Bounds& region, std::size_t extra, Ticker& ticker);

  /// May the segment touch the region?
  static bool reaches(const EndPair& segment, const Bounds& region);

  bool empty() const { return segments_.empty(); }

  /// Exact; both are closed.
  Answer ask(const Corners& triangle, Ticker& ticker) const;

private:
  struct Part
  {
    Box box;
    Index segment;
  };
  using Levels = BoxLevels<8, 8>;

  bool cut(const Box& region, std::size_t extra, Ticker& ticker);
  bool sort(Ticker& ticker);

  std::vector<EndPair> segments_;
  std::vector<Part> parts_;
  Levels levels_; ///< of parts
};

} // namespace ahd

#endif
