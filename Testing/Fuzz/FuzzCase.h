// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FuzzCase_h
#define ahd_FuzzCase_h

#include "ConstraintSets.h"
#include "Core/Executor.h"
#include "Options.h"
#include "Points/Points.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ahd
{
namespace fuzz
{

using Bytes = std::vector<std::uint8_t>;

/// The bytes of a case's head. Zero is the plain choice for each.
enum HeadByte : std::size_t
{
  kFirstSettings,  ///< bits 0-1 order; 2-3 control points, the default first; 4 no gene rotation; 5
                   ///< countWork; 6 keepOrder; 7 keepBoxes
  kSecondSettings, ///< likewise, of the second run
  kNmax,           ///< 4 bits for each run: the default, 1, 2, 3, ..., 15
  kExecutors,      ///< 4 bits for each run: see executor()
  kLayout,    ///< bit 0 float; 1-2 numbers per point - 2; 3 representatives by z; 4 even-odd fill
              ///< rule; 5 split the constraints where they cross; 6 merge points; 7 the Voronoi
              ///< diagram too
  kSkipMarks, ///< mark of point i: these bits, turned left by i
  kSkipMask,  ///< PointView::skipMask
  kLimit,     ///< insertionLimit of a further run, 0 for none
  kCopies,    ///< from 240 on: 2, 4, ... 2^16 copies of the points, side by side, but at most
              ///< kMostPoints
  kCancelAt,  ///< a further run is cancelled at this poll, 0 for none
  kFailAt,    ///< a further run has no memory from this allocation on, 0 for none
  kMergeDistance, ///< 2^(value / 2 - 64) of the larger side of the bounds
  kMostBoxes,     ///< mostBoxes of a further run, 0 for none
  kShuffle,       ///< how the ids of the second run are shuffled
  kRefusals,      ///< 0, or request refused things too
  kPoints,        ///< the number of points that follow, as far as there are bytes
  kHeadBytes
};

/// The input of a fuzz target. As bytes: the head; x, y of each point, little-endian doubles; the
/// rest are ids of points, which make chains. Any bytes are legal. The marks among the ids:
enum ChainByte : std::uint8_t
{
  kFarId = 0xFB,    ///< the largest number
  kFarBelow = 0xFC, ///< the smallest
  kNewLine = 0xFD,  ///< a line follows
  kNewLoop = 0xFE,  ///< a loop follows; also at the beginning
  kMinusOne = 0xFF  ///< the id -1
};

constexpr std::size_t kMostGivenPoints = 240;
constexpr std::size_t kMostPoints = 36000; ///< copies included; enough for all phases to be shared

struct FuzzCase
{
  std::array<std::uint8_t, kHeadBytes> head{};
  std::vector<Point> points; ///< at most kMostGivenPoints count
  Bytes chains;

  static FuzzCase fromBytes(const std::uint8_t* data, std::size_t size);
  Bytes bytes() const;

  std::size_t copies() const;
  /// The points and their copies, each rounded to float if the layout says so.
  std::vector<Point> allPoints() const;
  /// One byte per point of allPoints(); empty for none.
  std::vector<unsigned char> skipMarks(std::size_t count) const;

  /// Settings of the first (0) or the second (1) run.
  Options options(std::size_t run) const;
  /// Null in most cases. Executors live as long as the program.
  Executor* executor(std::size_t run) const;

  /// The chains; with copies, of points of all of them.
  test::ConstraintSet constraints() const;

  bool layoutBit(unsigned bit) const { return (head[kLayout] >> bit & 1) != 0; }

  /// All of it, in readable form.
  std::string text() const;
};

} // namespace fuzz
} // namespace ahd

#endif
