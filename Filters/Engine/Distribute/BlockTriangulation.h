// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockTriangulation_h
#define ahd_BlockTriangulation_h

#include "../Constraints.h"
#include "../Core/Context.h"
#include "../Options.h"
#include "../Points/Points.h"
#include "../Result.h"
#include "BlockTransport.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ahd
{

class Triangulation;

/// The input of one block. All but its points and their ids is the same for all blocks.
struct BlockInput
{
  std::size_t block = 0, blocks = 1;

  /// The block's own points; points at one place are all on one block. For little to be sent the
  /// blocks' bounds should hardly overlap (BlockCuts.h); the result does not depend on it.
  PointView points;
  /// The global ids of the points: not negative, ascending, unique over all blocks.
  const std::int64_t* ids = nullptr;

  ConstraintView constraints; ///< of all blocks, in global ids
  FillRule rule = FillRule::Orientation;

  /// How a block's own points are triangulated; it changes no triangle. insertionLimit must be 0.
  Options options;
  /// So many blocks, or parts made of them, send their border sets to one: a power of two, else the
  /// next smaller one; 2 at least.
  std::size_t blocksPerNode = 8;
};

/// A vertex of another block.
struct ForeignPoint
{
  std::int64_t id;
  std::size_t block; ///< that owns it
  Point at;

  bool operator<(const ForeignPoint& other) const { return id < other.id; }
  bool operator==(const ForeignPoint& other) const { return id == other.id; }
};

/// The amount of data that some blocks send so that their triangulations become one, counted
/// before.
struct BorderCount
{
  std::size_t host;       ///< the block that it is sent from
  std::size_t points = 0; ///< 32 bytes each
  std::size_t edges = 0;  ///< 8 bytes each
  std::size_t to = 0;     ///< the block that it is sent to, unless all is gathered
};

/// Counts of all blocks together, the same on each, when all is done.
struct BlocksReport
{
  Report counts;                ///< summed
  std::size_t ownTriangles = 0; ///< of them, those found by one block alone
  std::size_t borderPoints = 0; ///< that blocks sent, those of higher levels not counted
  ConstraintReport constraints;
};

/// One block's part in the triangulation of the points of all blocks: exact, canonical, the same
/// triangles as if one block had all points, constraints included (README.md has the proof). Each
/// triangle is on one block: the one that owns its lexicographically lowest corner.
///
/// Goes step by step, all blocks alike, and never waits: the caller transports the messages, as
/// distribute() does.
///
///     begin()
///     while waiting() is ForAll or ForSome:
///       ForAll:   toAll() of each block -> takeAll() of each block
///       ForSome:  giveSome() -> takeSome()
///
/// begin(), giveSome(), takeAll() and takeSome() are one block's own work and can fail on one block
/// alone (Ok, Cancelled, TooManyPoints, OutOfMemory): so blocks must agree on the outcome before
/// they go on. After anything but Ok no other function may be called. How many steps there are
/// depends on the number of blocks, blocksPerNode and gatherTo() alone.
///
/// Each time borders() is new and not empty, giveSome() has not been called yet: nothing that grows
/// with the border has been sent, and the caller may refuse to go on, or have all that remains
/// gathered to one block. For the memory there: borderMemoryEstimate().
///
/// Borrows points, ids and constraints. Phases of the Context's Progress: those of triangulate(),
/// on some blocks several times, and Phase::Outputs.
class BlockTriangulation
{
public:
  BlockTriangulation();
  ~BlockTriangulation();
  BlockTriangulation(BlockTriangulation&&) noexcept;
  BlockTriangulation& operator=(BlockTriangulation&&) noexcept;

  enum class Waiting
  {
    ForAll,    ///< for messages from each block to all
    ForSome,   ///< for messages from some blocks to some
    ForNothing ///< the result is there
  };

  /// Triangulates the block's own points.
  Status begin(const BlockInput& input, const Context& context);
  Waiting waiting() const;

  /// This block's message to all. @pre waiting ForAll; as takeAll().
  const BlockBytes& toAll() const;
  Status takeAll(const std::vector<BlockBytes>& all, const Context& context);

  /// This block's messages to some. @pre waiting ForSome; as takeSome().
  Status giveSome(std::vector<BlockMessage>& out, const Context& context);
  Status takeSome(const std::vector<BlockMessage>& in, const Context& context);

  /// The data that will be sent next to become one triangulation, in the order of the blocks: the
  /// same on all blocks. Empty before it is known and after it was sent.
  const std::vector<BorderCount>& borders() const;
  /// Sends all of it to this block at once, rather than up a tree. Must be called on all blocks
  /// with the same block. @pre borders() is not empty.
  void gatherTo(std::size_t block);

  // --- When nothing is awaited ---

  const BlocksReport& report() const;
  /// How many of the triangles are on this block.
  std::size_t triangles() const;
  /// How many of them, the first ones, have own corners only, as no other block took part in them.
  std::size_t insideTriangles() const;
  /// How many triangles of other blocks have a corner that is this one's. With them each of its
  /// vertices has all its triangles.
  std::size_t ghostTriangles() const;
  /// Corners of all of these that others own, by id. Each such corner has a number:
  /// points.count + its place here.
  const std::vector<ForeignPoint>& foreignPoints() const;
  /// triangles() triples of the block's own points, by their numbers in its points, and foreign
  /// ones. First triangles that only have own corners, in canonical order; then those that other
  /// blocks took part in, by the coordinates of their corners, from the lowest corner on. So it is
  /// a function of all points and of where they are. May be called again after any outcome.
  template <typename Id>
  Status writeTriangles(Id* triples, const Context& context);
  /// The triangles of other blocks, likewise: those of one block in the order in which it has them,
  /// with the same corners first.
  template <typename Id>
  Status writeGhostTriangles(Id* triples, const Context& context) const;
  /// A byte for each of triangles(): bit e is set if its edge from corner e on is a constraint.
  Status writeConstraintEdges(std::uint8_t* edges, const Context& context) const;
  /// The same for ghostTriangles().
  Status writeGhostConstraintEdges(std::uint8_t* edges, const Context& context) const;
  /// The triangulation of the block's own points, to look up which of them are at one place: those
  /// are all there are. Its triangles are none of the result.
  Triangulation& ownPoints();
  /// The status of each of the block's points (Result.h), in global ids.
  Status writePointStatus(std::int64_t* status, const Context& context);

private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The next step, over a transport. Must be called by all blocks; returns the same on all. @pre
/// it waits.
Status takeStep(BlockTriangulation& block, BlockTransport& transport, const Context& context);

/// All of it, over a transport. Must be called by all blocks; returns the same on all.
Status distribute(const BlockInput& input, BlockTransport& transport, const Context& context,
  BlockTriangulation& out);

/// Upper estimate of the bytes that a block takes for so many points of its own and ids of
/// constraints, without input, output and data received from others.
std::size_t blockMemoryEstimate(
  std::size_t pointCount, std::size_t constraintIds, const Options& options);

/// Upper estimate of the bytes that the host of a node takes in addition to make one triangulation
/// of so many points and edges received.
std::size_t borderMemoryEstimate(
  std::size_t pointCount, std::size_t edgeCount, std::size_t constraintIds);

} // namespace ahd

#endif
