// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BlockTransport_h
#define ahd_BlockTransport_h

#include "../Result.h"
#include "BlockBytes.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// Bytes to one block, or from one.
struct BlockMessage
{
  std::size_t block = 0;
  BlockBytes bytes;
};

/// Communication between blocks: by MPI, sockets or threads, implemented outside the engine. All
/// functions are collective: all blocks call them, in the same order.
///
/// They return Ok or a failure of the transport, the same on all blocks. A failure of one block
/// goes through agree(), which each block calls before it sends: so none waits for a block that has
/// given up.
class BlockTransport
{
public:
  virtual ~BlockTransport() = default;

  /// Ok if all blocks pass Ok; else the status of one of them, the same on all: the largest, say.
  virtual Status agree(Status own) = 0;

  /// all[k] becomes what block k gives as `own`.
  virtual Status gather(const BlockBytes& own, std::vector<BlockBytes>& all) = 0;

  /// `in` becomes the messages that are for this block, with the blocks that they come from, in any
  /// order. One block sends another one at most; it may send one to itself. `out` is used up.
  virtual Status exchange(std::vector<BlockMessage>& out, std::vector<BlockMessage>& in) = 0;
};

} // namespace ahd

#endif
