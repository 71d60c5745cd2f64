// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Share_h
#define ahd_Share_h

#include "../Core/Border.h"
#include "BlockTransport.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// Gathers on all blocks: `all` becomes what make(own) fills on each, in the order of the blocks.
/// `make` returns Ok, or the failure of this block; it may throw std::bad_alloc. Types that can be
/// sent: BlockBytes.h. Collective, as all here; returns the same on all blocks: Ok, or the failure
/// of one.
template <typename T, typename Make>
Status share(BlockTransport& transport, const Make& make, std::vector<T>& all)
{
  BlockBytes own;
  std::vector<BlockBytes> bytes;
  Status status = transport.agree(withoutThrowing(
    [&]
    {
      T mine{};
      const Status made = make(mine);
      BytesWriter{ own }(mine);
      return made;
    }));
  status = status == Status::Ok ? transport.gather(own, bytes) : status;
  const auto read = [&]
  {
    all = std::vector<T>(bytes.size());
    for (std::size_t k = 0; k != bytes.size(); ++k)
    {
      BytesReader{ bytes[k] }(all[k]);
      bytes[k] = BlockBytes();
    }
    return Status::Ok;
  };
  return status == Status::Ok ? transport.agree(withoutThrowing(read)) : status;
}

/// Sends to[k] to block k, and consumes it; from[k] becomes the data that block k has sent to this
/// one. Nothing is sent of an empty vector. `make` fills `to`, one vector for each block, as above.
template <typename T, typename Make>
Status exchange(BlockTransport& transport, const Make& make, std::vector<std::vector<T>>& from)
{
  std::vector<BlockMessage> out, in;
  std::size_t blocks = 0;
  Status status = transport.agree(withoutThrowing(
    [&]
    {
      std::vector<std::vector<T>> to;
      const Status made = make(to);
      blocks = to.size();
      for (std::size_t k = 0; k != blocks; ++k)
      {
        if (!to[k].empty())
        {
          out.push_back({ k, {} });
          BytesWriter{ out.back().bytes }(to[k]);
          to[k] = std::vector<T>();
        }
      }
      return made;
    }));
  status = status == Status::Ok ? transport.exchange(out, in) : status;
  const auto read = [&]
  {
    from.assign(blocks, std::vector<T>());
    for (BlockMessage& message : in)
    {
      BytesReader{ message.bytes }(from[message.block]);
      message.bytes = BlockBytes();
    }
    return Status::Ok;
  };
  return status == Status::Ok ? transport.agree(withoutThrowing(read)) : status;
}

} // namespace ahd

#endif
