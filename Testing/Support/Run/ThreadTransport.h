// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ThreadTransport_h
#define ahd_ThreadTransport_h

#include "Distribute/BlockRoute.h"
#include "Listeners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace ahd
{
namespace test
{

/// The barrier and exchange of all blocks.
class Hall
{
public:
  explicit Hall(std::size_t blocks)
    : statuses(blocks)
    , bytes(blocks)
    , messages(blocks)
    , pairs_(blocks * blocks)
  {
  }

  /// Waits for all; they meet twice for each step, so that none writes while another one reads.
  void meet()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    const std::size_t round = round_;
    if (++waiting_ == statuses.size())
    {
      waiting_ = 0;
      ++round_;
      all_.notify_all();
      return;
    }
    all_.wait(lock, [&] { return round_ != round; });
  }

  /// A message from one block to another directly.
  void send(std::size_t from, std::size_t to, const void* what, std::size_t count)
  {
    const auto* const first = static_cast<const unsigned char*>(what);
    const std::lock_guard<std::mutex> lock(mutex_);
    pairs_[from * statuses.size() + to].emplace_back(first, first + count);
    all_.notify_all();
  }
  BlockBytes receive(std::size_t from, std::size_t to)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    std::deque<BlockBytes>& sent = pairs_[from * statuses.size() + to];
    all_.wait(lock, [&] { return !sent.empty(); });
    BlockBytes first = std::move(sent.front());
    sent.pop_front();
    return first;
  }

  std::vector<Status> statuses;
  std::vector<BlockBytes> bytes;
  std::vector<std::vector<BlockMessage>> messages;

private:
  std::mutex mutex_;
  std::condition_variable all_;
  std::size_t waiting_ = 0, round_ = 0;
  std::vector<std::deque<BlockBytes>> pairs_; ///< from one block to another
};

class ThreadTransport : public PairTransport
{
public:
  ThreadTransport(Hall& hall, std::size_t own)
    : hall_(hall)
    , own_(own)
  {
  }
  Status agree(Status own) override
  {
    hall_.statuses[own_] = own;
    hall_.meet();
    const Status worst = *std::max_element(hall_.statuses.begin(), hall_.statuses.end());
    hall_.meet();
    return worst;
  }
  Status gather(const BlockBytes& own, std::vector<BlockBytes>& all) override
  {
    hall_.bytes[own_] = own;
    hall_.meet();
    all = hall_.bytes;
    hall_.meet();
    return Status::Ok;
  }
  Status exchange(std::vector<BlockMessage>& out, std::vector<BlockMessage>& in) override
  {
    hall_.messages[own_] = std::move(out);
    hall_.meet();
    in.clear();
    for (std::size_t from = 0; from < hall_.messages.size(); ++from)
    {
      for (const BlockMessage& message : hall_.messages[from])
      {
        if (message.block == own_)
        {
          in.push_back({ from, message.bytes });
        }
      }
    }
    hall_.meet();
    return Status::Ok;
  }

  void swap(std::size_t partner, const void* out, std::size_t outBytes, void* in,
    std::size_t inBytes) override
  {
    if (outBytes > 0)
    {
      hall_.send(own_, partner, out, outBytes);
    }
    if (inBytes > 0)
    {
      const BlockBytes sent = hall_.receive(partner, own_);
      std::copy_n(sent.begin(), std::min(inBytes, sent.size()), static_cast<unsigned char*>(in));
    }
  }

private:
  Hall& hall_;
  std::size_t own_;
};

/// Calls work(block, transport) for each block, in a thread of its own.
template <typename Work>
void onBlocks(std::size_t blocks, const Work& work)
{
  Hall hall(blocks);
  std::vector<std::thread> threads;
  for (std::size_t b = 0; b < blocks; ++b)
  {
    threads.emplace_back(
      [&, b]
      {
        ThreadTransport transport(hall, b);
        work(b, transport);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

/// Of three blocks block `listening` is cancelled, at each of its polls in turn, of which there are
/// `least` or more: all end alike. make() returns the work of one run, which is called as
/// work(block, transport, context) and returns its status.
template <typename Make>
void expectThatOneEndsAll(std::size_t listening, std::size_t least, const Make& make)
{
  constexpr std::size_t kBlocks = 3;
  std::size_t askings = 0;
  for (std::size_t at = 0; at <= askings; ++at)
  {
    std::vector<Status> statuses(kBlocks);
    Listener listener(at);
    const auto work = make();
    onBlocks(kBlocks,
      [&](std::size_t b, ThreadTransport& transport)
      {
        Context context;
        context.progress = b == listening ? &listener : nullptr;
        statuses[b] = work(b, transport, context);
      });
    const Status expected = at == 0 ? Status::Ok : Status::Cancelled;
    EXPECT_EQ(statuses, std::vector<Status>(kBlocks, expected)) << at;
    askings = at == 0 ? listener.askings() : askings;
  }
  EXPECT_GE(askings, least);
}

} // namespace test
} // namespace ahd

#endif
