// SPDX-License-Identifier: BSD-3-Clause
#include "BlockTriangulation.h"

#include "../Constrain/EdgeTable.h"
#include "../Core/Border.h"
#include "BlockState.h"

namespace ahd
{

BlockTriangulation::BlockTriangulation() = default;
BlockTriangulation::~BlockTriangulation() = default;
BlockTriangulation::BlockTriangulation(BlockTriangulation&&) noexcept = default;
BlockTriangulation& BlockTriangulation::operator=(BlockTriangulation&&) noexcept = default;

Status BlockTriangulation::begin(const BlockInput& input, const Context& context)
{
  const Status status = withoutThrowing(
    [&]
    {
      state_.reset(new State);
      state_->input = input;
      return state_->own().makeOwn(
        input.points, input.ids, static_cast<std::uint32_t>(input.block), input.options, context);
    });
  return status != Status::Ok ? status
                              : unlessCancelled(
                                  [&]
                                  {
                                    Ticker ticker(context.progress, Phase::Outputs, 0);
                                    return state_->beginFacts(ticker);
                                  });
}

BlockTriangulation::Waiting BlockTriangulation::waiting() const
{
  switch (state_->step)
  {
    case State::Step::Facts:
    case State::Step::Counts:
    case State::Step::Totals:
      return Waiting::ForAll;
    case State::Step::Up:
    case State::Step::Down:
      return Waiting::ForSome;
    default:
      return Waiting::ForNothing;
  }
}

const BlockBytes& BlockTriangulation::toAll() const
{
  return state_->toAll;
}

Status BlockTriangulation::takeAll(const std::vector<BlockBytes>& all, const Context& context)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      switch (state_->step)
      {
        case State::Step::Facts:
          return state_->takeFacts(all, ticker) && ticker.ask();
        case State::Step::Counts:
          state_->takeCounts(all);
          return ticker.ask();
        default:
          state_->takeTotals(all);
          return ticker.ask();
      }
    });
}

Status BlockTriangulation::giveSome(std::vector<BlockMessage>& out, const Context& context)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      out.clear();
      if (state_->step == State::Step::Up)
      {
        state_->giveBorder(out);
        return ticker.ask();
      }
      return state_->giveDown(out, ticker) && ticker.ask();
    });
}

Status BlockTriangulation::takeSome(const std::vector<BlockMessage>& in, const Context& context)
{
  if (state_->step == State::Step::Up)
  {
    return withoutThrowing([&] { return state_->takeBorders(in, context); });
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      return state_->takeDown(in, ticker) && ticker.ask();
    });
}

const std::vector<BorderCount>& BlockTriangulation::borders() const
{
  return state_->borders;
}

void BlockTriangulation::gatherTo(std::size_t block)
{
  state_->fronts.back() = state_->fronts.back().gatheredTo(block);
}

// ------------------------------------------------------------------------------------- the result

const BlocksReport& BlockTriangulation::report() const
{
  return state_->report;
}

std::size_t BlockTriangulation::triangles() const
{
  return state_->own().finalTriangles() + state_->shared.size();
}

const std::vector<ForeignPoint>& BlockTriangulation::foreignPoints() const
{
  return state_->foreign;
}

template <typename Id>
Status BlockTriangulation::writeTriangles(Id* triples, const Context& context)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Extract, triangles(), context.executor);
      Id* to = triples + 3 * state_->own().finalTriangles();
      const auto write = [&](std::size_t a, std::size_t b)
      {
        for (std::size_t t = a; t != b; ++t)
        {
          for (const Index corner : state_->shared[t].corners)
          {
            *to++ = static_cast<Id>(corner);
          }
        }
      };
      return state_->own().writeFinal(triples, ticker) &&
        inChunks(0, state_->shared.size(), ticker, write) && ticker.ask();
    });
}

template Status BlockTriangulation::writeTriangles(int*, const Context&);
template Status BlockTriangulation::writeTriangles(long*, const Context&);
template Status BlockTriangulation::writeTriangles(long long*, const Context&);

Status BlockTriangulation::writeConstraintEdges(std::uint8_t* edges, const Context& context) const
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      const std::size_t own = triangles() - state_->shared.size();
      return inChunks(0, triangles(), ticker,
               [&](std::size_t a, std::size_t b)
               {
                 for (std::size_t t = a; t != b; ++t)
                 {
                   edges[t] = t < own ? std::uint8_t(0) : state_->shared[t - own].flags;
                 }
               }) &&
        ticker.ask();
    });
}

Status BlockTriangulation::writePointStatus(std::int64_t* status, const Context& context)
{
  Triangulation& own = state_->own().triangulation();
  const Status written = own.writePointStatus(status, context);
  return written != Status::Ok
    ? written
    : unlessCancelled(
        [&]
        {
          Ticker ticker(context.progress, Phase::Outputs, 0);
          return inChunks(0, state_->input.points.count, ticker,
            [&](std::size_t a, std::size_t b)
            {
              for (std::size_t i = a; i != b; ++i)
              {
                status[i] = status[i] < 0 ? status[i] : state_->input.ids[status[i]];
              }
            });
        });
}

// -------------------------------------------------------------------------------- over a transport

Status distribute(const BlockInput& input, BlockTransport& transport, const Context& context,
  BlockTriangulation& out)
{
  using Waiting = BlockTriangulation::Waiting;
  Status status = transport.agree(out.begin(input, context));
  while (status == Status::Ok && out.waiting() != Waiting::ForNothing)
  {
    if (out.waiting() == Waiting::ForAll)
    {
      std::vector<BlockBytes> all;
      status = transport.gather(out.toAll(), all);
      status = status == Status::Ok ? transport.agree(out.takeAll(all, context)) : status;
    }
    else
    {
      std::vector<BlockMessage> some, got;
      status = transport.agree(out.giveSome(some, context));
      status = status == Status::Ok ? transport.exchange(some, got) : status;
      status = status == Status::Ok ? transport.agree(out.takeSome(got, context)) : status;
    }
  }
  if (status != Status::Ok)
  {
    out = BlockTriangulation();
  }
  return status;
}

std::size_t blockMemoryEstimate(
  std::size_t pointCount, std::size_t constraintIds, const Options& options)
{
  const std::size_t own = triangulationMemoryEstimate(pointCount, options);
  if (own == std::size_t(-1))
  {
    return own;
  }
  // Per point: two labels; with constraints its vertex, and a quarter of a part of a segment,
  // sorted, as lists grow, and boxes. Per id of the constraints: an end, of its own and of all;
  // three parts.
  constexpr std::size_t kPart = 3 * 2 * 40 + 8;
  const std::size_t perPoint = 2 + (constraintIds == 0 ? 0 : sizeof(Index) + kPart / 4);
  constexpr std::size_t kPerId = 4 * sizeof(ChainEnd) + 4 * sizeof(EndPair) + 3 * sizeof(Index) +
    3 * kPart;
  return own + pointCount * perPoint + constraintIds * kPerId + (std::size_t(1) << 17);
}

std::size_t borderMemoryEstimate(
  std::size_t pointCount, std::size_t edgeCount, std::size_t constraintIds)
{
  const std::size_t own = triangulationMemoryEstimate(pointCount, Options());
  if (own == std::size_t(-1))
  {
    return own;
  }
  // Per point: itself, as it comes and as it is kept; its vertex, two labels and walls, a flag;
  // what goes up again; two triangles that go down, their corners sorted, as lists grow, and the
  // message.
  constexpr std::size_t kPerPoint = 2 * sizeof(BorderPoint) + 4 + 2 + 2 + 1 + sizeof(BorderPoint) +
    4 + 2 * (3 * 13 + 2 * 12) + 3 * sizeof(BorderPoint) + 2 * (3 * sizeof(BorderPoint) + 13);
  // Per edge: itself, as it comes and as it is kept, its half-edge, a place in a table; what goes
  // up again, and half-edges of that.
  constexpr std::size_t kPerEdge = 2 * sizeof(BorderEdge) + 4 +
    6 * sizeof(EdgeTable<std::uint64_t>::Edge) + 3 * sizeof(BorderEdge) + 3 * 4;
  return own + pointCount * kPerPoint + edgeCount * kPerEdge +
    (constraintIds == 0 ? 0 : constraintMemoryEstimate(pointCount, constraintIds)) +
    constraintIds * 16;
}

} // namespace ahd
