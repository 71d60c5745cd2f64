// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Steps_h
#define ahd_Steps_h

#include "../Core/Context.h"
#include "../Core/Progress.h"
#include "Share.h"

#include <type_traits>
#include <vector>

namespace ahd
{

/// Steps that all blocks take together. After one that failed on some block no block takes any:
/// status() has the reason, the same on all. Work on each block returns bool, false if cancelled,
/// or a Status; it may throw std::bad_alloc.
class Steps
{
public:
  /// Borrows both.
  Steps(BlockTransport& transport, const Context& context)
    : transport_(transport)
    , context_(context)
  {
  }

  /// Work of each block alone: work(ticker).
  template <typename Work>
  void each(const Work& work)
  {
    if (status_ == Status::Ok)
    {
      status_ = transport_.agree(withoutThrowing([&] { return run(work); }));
    }
  }

  /// all[k] becomes what make(own, ticker) fills on block k.
  template <typename T, typename Make>
  void share(std::vector<T>& all, const Make& make)
  {
    if (status_ == Status::Ok)
    {
      const auto makeOwn = [&](T& own)
      { return run([&](Ticker& ticker) { return make(own, ticker); }); };
      status_ = ahd::share(transport_, makeOwn, all);
    }
  }

  /// from[k] becomes what block k sends to this one: make(to, ticker) fills a vector for each.
  template <typename T, typename Make>
  void exchange(std::vector<std::vector<T>>& from, const Make& make)
  {
    if (status_ == Status::Ok)
    {
      const auto makeAll = [&](std::vector<std::vector<T>>& to)
      { return run([&](Ticker& ticker) { return make(to, ticker); }); };
      status_ = ahd::exchange(transport_, makeAll, from);
    }
  }

  /// Messages, as the transport has it.
  void exchange(std::vector<BlockMessage>& out, std::vector<BlockMessage>& in)
  {
    if (status_ == Status::Ok)
    {
      status_ = transport_.exchange(out, in);
    }
  }

  Status status() const { return status_; }

private:
  template <typename Work>
  Status run(const Work& work)
  {
    Ticker ticker(context_.progress, Phase::Outputs, 0, context_.executor);
    if (!ticker.ask())
    {
      return Status::Cancelled;
    }
    if constexpr (std::is_same<decltype(work(ticker)), bool>::value)
    {
      return work(ticker) ? Status::Ok : Status::Cancelled;
    }
    else
    {
      return work(ticker);
    }
  }

  BlockTransport& transport_;
  const Context context_;
  Status status_ = Status::Ok;
};

} // namespace ahd

#endif
