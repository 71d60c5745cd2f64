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
  return state_->own().finalTriangles() + state_->sharedOwn;
}

std::size_t BlockTriangulation::insideTriangles() const
{
  return state_->own().finalTriangles();
}

std::size_t BlockTriangulation::ghostTriangles() const
{
  return state_->shared.size() - state_->sharedOwn;
}

const std::vector<ForeignPoint>& BlockTriangulation::foreignPoints() const
{
  return state_->foreign;
}

/// Writes triangles [begin, end) of those that others took part in.
template <typename Id>
bool BlockTriangulation::State::writeShared(
  std::size_t begin, std::size_t end, Id* triples, Ticker& ticker) const
{
  return inChunks(begin, end, ticker,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t t = a; t != b; ++t)
      {
        for (const Index corner : shared[t].corners)
        {
          *triples++ = static_cast<Id>(corner);
        }
      }
    });
}

template <typename Id>
Status BlockTriangulation::writeTriangles(Id* triples, const Context& context)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Extract, triangles(), context.executor);
      Part& own = state_->own();
      return own.writeFinal(triples, ticker) &&
        state_->writeShared(0, state_->sharedOwn, triples + 3 * own.finalTriangles(), ticker) &&
        ticker.ask();
    });
}

template <typename Id>
Status BlockTriangulation::writeGhostTriangles(Id* triples, const Context& context) const
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Extract, ghostTriangles());
      return state_->writeShared(state_->sharedOwn, state_->shared.size(), triples, ticker) &&
        ticker.ask();
    });
}

#define AHD_WRITES(Id)                                                                             \
  template Status BlockTriangulation::writeTriangles(Id*, const Context&);                         \
  template Status BlockTriangulation::writeGhostTriangles(Id*, const Context&) const

AHD_WRITES(int);
AHD_WRITES(long);
AHD_WRITES(long long);

#undef AHD_WRITES

Status BlockTriangulation::writeConstraintEdges(std::uint8_t* edges, const Context& context) const
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      const std::size_t own = state_->own().finalTriangles();
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

Status BlockTriangulation::writeGhostConstraintEdges(
  std::uint8_t* edges, const Context& context) const
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      return inChunks(state_->sharedOwn, state_->shared.size(), ticker,
               [&](std::size_t a, std::size_t b)
               {
                 for (std::size_t t = a; t != b; ++t)
                 {
                   *edges++ = static_cast<std::uint8_t>(
                     state_->shared[t].flags & ~OwnedTriangles::kGhost);
                 }
               }) &&
        ticker.ask();
    });
}

Triangulation& BlockTriangulation::ownPoints()
{
  return state_->own().triangulation();
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

Status takeStep(BlockTriangulation& block, BlockTransport& transport, const Context& context)
{
  if (block.waiting() == BlockTriangulation::Waiting::ForAll)
  {
    std::vector<BlockBytes> all;
    const Status status = transport.gather(block.toAll(), all);
    return status == Status::Ok ? transport.agree(block.takeAll(all, context)) : status;
  }
  std::vector<BlockMessage> some, got;
  Status status = transport.agree(block.giveSome(some, context));
  status = status == Status::Ok ? transport.exchange(some, got) : status;
  return status == Status::Ok ? transport.agree(block.takeSome(got, context)) : status;
}

Status distribute(const BlockInput& input, BlockTransport& transport, const Context& context,
  BlockTriangulation& out)
{
  Status status = transport.agree(out.begin(input, context));
  while (status == Status::Ok && out.waiting() != BlockTriangulation::Waiting::ForNothing)
  {
    status = takeStep(out, transport, context);
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
  // Per point: itself, as it comes and as it is kept; its vertex, two labels and walls; what goes
  // up again. Two triangles that go down to three blocks each, at most, as lists grow, sorted, and
  // as messages; the point itself to seven blocks, as it has six neighbours.
  constexpr std::size_t kTriangle = 3 * 13 + 2 * 12 + 2 * 13;
  constexpr std::size_t kPerPoint = 2 * sizeof(BorderPoint) + 4 + 2 + 2 + sizeof(BorderPoint) + 4 +
    2 * 3 * kTriangle + 7 * 3 * sizeof(BorderPoint);
  // Per edge: itself, as it comes and as it is kept, its half-edge, a place in a table; what goes
  // up again, and half-edges of that.
  constexpr std::size_t kPerEdge = 2 * sizeof(BorderEdge) + 4 +
    6 * sizeof(EdgeTable<std::uint64_t>::Edge) + 3 * sizeof(BorderEdge) + 3 * 4;
  return own + pointCount * kPerPoint + edgeCount * kPerEdge +
    (constraintIds == 0 ? 0 : constraintMemoryEstimate(pointCount, constraintIds)) +
    constraintIds * 16;
}

} // namespace ahd
