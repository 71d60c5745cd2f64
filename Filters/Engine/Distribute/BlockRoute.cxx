// SPDX-License-Identifier: BSD-3-Clause
#include "BlockRoute.h"

#include "../Core/Buffer.h"
#include "../Core/Loops.h"

#include <algorithm>
#include <type_traits>

namespace ahd
{

namespace
{

using Byte = unsigned char;

/// Calls work(width), for usual widths with a constant, so that a tuple is copied by one or two
/// instructions.
template <typename Work>
void withWidth(std::size_t width, const Work& work)
{
  using std::integral_constant;
  switch (width)
  {
    case 1:
      return work(integral_constant<std::size_t, 1>());
    case 2:
      return work(integral_constant<std::size_t, 2>());
    case 4:
      return work(integral_constant<std::size_t, 4>());
    case 8:
      return work(integral_constant<std::size_t, 8>());
    case 12:
      return work(integral_constant<std::size_t, 12>());
    case 16:
      return work(integral_constant<std::size_t, 16>());
    case 24:
      return work(integral_constant<std::size_t, 24>());
    default:
      return work(width);
  }
}

/// Tuple numbers[k] of `from` becomes tuple k of `to`.
void pack(const void* from, const Index* numbers, std::size_t count, std::size_t width, Byte* to)
{
  const auto* const tuples = static_cast<const Byte*>(from);
  const auto isGap = [](Index a, Index b) { return b != a + 1; };
  if (count > 0 && std::adjacent_find(numbers, numbers + count, isGap) == numbers + count)
  {
    std::memcpy(to, tuples + numbers[0] * width, count * width);
    return;
  }
  withWidth(width,
    [&](auto known)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        std::memcpy(to + k * known, tuples + numbers[k] * known, known);
      }
    });
}

/// Tuple k of `from` becomes tuple numbers[k] of `to`.
void scatter(const Byte* from, const Index* numbers, std::size_t count, std::size_t width, void* to)
{
  auto* const tuples = static_cast<Byte*>(to);
  withWidth(width,
    [&](auto known)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        std::memcpy(tuples + numbers[k] * known, from + k * known, known);
      }
    });
}

/// Calls work(begin, end) for stretches of [0, count) while `status` is Ok; it has the reason if
/// the rest is left out.
template <typename Work>
void unlessStopped(std::size_t count, Status& status, Ticker& ticker, const Work& work)
{
  if (status == Status::Ok)
  {
    status = unlessCancelled([&] { return inChunks(0, count, ticker, work); });
  }
}

} // namespace

/// Tuple i goes to block owner(i), which several threads call.
template <typename Owner>
Status BlockRoute::toOwnersOf(std::size_t count, const Owner& owner)
{
  Steps steps(transport_, context_);
  steps.each(
    [&](Ticker& ticker)
    {
      Buffer<std::uint32_t> owners;
      owners.allocate(count);
      std::vector<std::size_t> counts(blocks_);
      out_.assign(blocks_, Tuples());
      const auto ask = [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i != end; ++i)
        {
          owners[i] = static_cast<std::uint32_t>(owner(i));
        }
      };
      if (!inChunksOf(count, ticker, ask) ||
        !inSteps(0, count, ticker, [&](std::size_t i) { ++counts[owners[i]]; }))
      {
        return false;
      }
      for (std::size_t block = 0; block != blocks_; ++block)
      {
        out_[block].reserve(counts[block]);
      }
      return inSteps(
        0, count, ticker, [&](std::size_t i) { out_[owners[i]].push_back(static_cast<Index>(i)); });
    });
  return steps.status() == Status::Ok ? tellCounts() : steps.status();
}

Status BlockRoute::toOwners(const PointView& points, const BlockCuts& cuts)
{
  return toOwnersOf(points.count, [&](std::size_t i) { return cuts.ownerOf(points[i]); });
}

Status BlockRoute::toOne(std::size_t count, std::size_t block)
{
  return toOwnersOf(count, [block](std::size_t) { return block; });
}

/// Sends each block the number of tuples it gets from this one.
Status BlockRoute::tellCounts()
{
  std::vector<std::vector<std::uint64_t>> counts;
  Steps steps(transport_, context_);
  steps.exchange(counts,
    [&](std::vector<std::vector<std::uint64_t>>& to, Ticker&)
    {
      for (const Tuples& tuples : out_)
      {
        to.emplace_back(std::size_t(tuples.empty() ? 0 : 1), tuples.size());
      }
      return true;
    });
  steps.each(
    [&](Ticker&)
    {
      firstOf_.clear();
      arrivals_ = 0;
      for (const std::vector<std::uint64_t>& some : counts)
      {
        firstOf_.push_back(arrivals_);
        arrivals_ += some.empty() ? 0 : static_cast<std::size_t>(some[0]);
      }
      return true;
    });
  return steps.status();
}

Status BlockRoute::ask(
  const std::vector<BlockPoint>& wanted, const std::vector<std::int64_t>& names)
{
  std::vector<std::vector<std::int64_t>> asked;
  Steps steps(transport_, context_);
  steps.exchange(asked,
    [&](std::vector<std::vector<std::int64_t>>& to, Ticker& ticker)
    {
      to.resize(blocks_);
      std::vector<Tuples> places(blocks_);
      const auto list = [&](std::size_t k)
      {
        to[wanted[k].block].push_back(wanted[k].id);
        places[wanted[k].block].push_back(static_cast<Index>(k));
      };
      places_.clear();
      places_.reserve(wanted.size());
      const bool isDone = inSteps(0, wanted.size(), ticker, list);
      for (const Tuples& some : places)
      {
        places_.insert(places_.end(), some.begin(), some.end());
      }
      return isDone;
    });
  steps.each(
    [&](Ticker& ticker)
    {
      out_.assign(blocks_, Tuples());
      const auto find = [&](std::int64_t id)
      { return std::lower_bound(names.begin(), names.end(), id) - names.begin(); };
      return eachBlock(
        [&](std::size_t block)
        {
          return inSteps(0, asked[block].size(), ticker,
            [&](std::size_t k)
            { out_[block].push_back(static_cast<Index>(find(asked[block][k]))); });
        });
    });
  return steps.status() == Status::Ok ? tellCounts() : steps.status();
}

/// How many tuples come from a block.
std::size_t BlockRoute::countFrom(std::size_t block) const
{
  return (block + 1 < firstOf_.size() ? firstOf_[block + 1] : arrivals_) - firstOf_[block];
}

/// Moves tuples, packed by pack(), to `to`. A block that fails goes on sending, as others wait for
/// it: the blocks agree on the failure at the end.
Status BlockRoute::carry(std::size_t width, void* to, const Pack& pack)
{
  Buffer<Byte> out, in;
  const std::size_t most = std::max<std::size_t>(1, kPiece / width);
  Steps steps(transport_, context_);
  steps.each(
    [&](Ticker&)
    {
      out.allocate(most * width);
      in.allocate(most * width);
      return true;
    });
  if (steps.status() != Status::Ok)
  {
    return steps.status();
  }
  Status status = Status::Ok;
  Ticker ticker(context_.progress, Phase::Outputs, 0);
  for (std::size_t round = 0; round != blocks_; ++round)
  {
    const std::size_t partner = partnerOf(block_, blocks_, round);
    const Tuples& tuples = out_[partner];
    const std::size_t count = tuples.size(), coming = countFrom(partner);
    for (std::size_t done = 0; done < std::max(count, coming); done += most)
    {
      const std::size_t going = std::min(most, count - std::min(count, done));
      const std::size_t arriving = std::min(most, coming - std::min(coming, done));
      const std::size_t first = firstOf_[partner] + done;
      const bool isInOrder = places_.empty() && arriving > 0;
      Byte* const end = isInOrder ? static_cast<Byte*>(to) + first * width : in.data();
      Byte* const packed = partner == block_ ? end : out.data();
      unlessStopped(going, status, ticker,
        [&](std::size_t k, std::size_t last)
        { pack(tuples.data() + done + k, last - k, packed + k * width); });
      if (partner != block_)
      {
        transport_.swap(partner, packed, going * width, end, arriving * width);
      }
      unlessStopped(isInOrder ? 0 : arriving, status, ticker,
        [&](std::size_t k, std::size_t last)
        { scatter(end + k * width, places_.data() + first + k, last - k, width, to); });
    }
  }
  return transport_.agree(status);
}

Status BlockRoute::move(const void* from, std::size_t width, void* to)
{
  return carry(width, to,
    [from, width](const Index* tuples, std::size_t some, Byte* bytes)
    { ahd::pack(from, tuples, some, width, bytes); });
}

} // namespace ahd
