// SPDX-License-Identifier: BSD-3-Clause
#include "BlockState.h"

#include "../Core/Border.h"
#include "../Core/Fields.h"
#include "../Core/SortAsking.h"

#include <algorithm>
#include <utility>

namespace ahd
{

// -------------------------------------------------------------------------------- the beginning

bool BlockTriangulation::State::beginFacts(Ticker& ticker)
{
  const TriangulationAccess::State& made = *TriangulationAccess::stateOf(own().triangulation());
  const BlockFacts facts{ made.ranked.count == 0 ? Bounds() : made.ranked.bounds, made.report };
  std::vector<Index> vertices;
  std::vector<ChainEnd> found;
  if (!findOwnEnds(vertices, found, ticker) ||
    !sortAsking(vertices, ticker, [](Index a, Index b) { return a < b; }))
  {
    return false;
  }
  BytesWriter{ toAll }(facts, found);
  own().setEnds(std::move(vertices));
  fronts.push_back(BlockFront::ofBlocks(input.blocks));
  step = Step::Facts;
  return true;
}

bool BlockTriangulation::State::takeFacts(const std::vector<BlockBytes>& all, Ticker& ticker)
{
  std::vector<Bounds> bounds;
  bounds.reserve(all.size());
  ends.assign(constraintIds(input.constraints), { 0, { 0.0, 0.0 }, -1 });
  for (const BlockBytes& bytes : all)
  {
    BlockFacts facts;
    std::vector<ChainEnd> more;
    BytesReader{ bytes }(facts, more);
    bounds.push_back(facts.bounds);
    addCounts(facts.counts, report.counts);
    for (const ChainEnd& end : more)
    {
      ends[end.place] = end;
      if (!ticker.step())
      {
        return false;
      }
    }
  }
  around.boxes.set(std::move(bounds));
  return settle(0, ticker);
}

// ------------------------------------------------------------------------------------ up the tree

/// Finds the final triangles in the part of this level, if it is here, and the border set to send
/// up.
bool BlockTriangulation::State::settle(std::size_t atLevel, Ticker& ticker)
{
  toAll.clear();
  level = atLevel;
  step = Step::Counts;
  const BlockFront& front = fronts[level];
  const std::size_t k = front.rowHostedBy(input.block);
  if (k == front.rows())
  {
    return true;
  }
  PartBorder& border = pending[level];
  const std::size_t points = level == 0 ? input.points.count : parts[level].given().size();
  if (!joinSegments(front.row(k), points, ticker) ||
    !parts[level].findFinal(front.row(k), around, ticker) ||
    !parts[level].makeBorder(border, ticker))
  {
    return false;
  }
  BytesWriter{ toAll }(border.points.size(), border.edges.size());
  return true;
}

void BlockTriangulation::State::takeCounts(const std::vector<BlockBytes>& all)
{
  const BlockFront& front = fronts[level];
  borders.clear();
  for (std::size_t k = 0; k != front.rows(); ++k)
  {
    BorderCount count{ front.hostOf(k) };
    BytesReader{ all[count.host] }(count.points, count.edges);
    borders.push_back(count);
    report.borderPoints += level == 0 ? count.points : 0;
  }
  std::size_t halvings = 1;
  while ((std::size_t(2) << halvings) <= input.blocksPerNode)
  {
    ++halvings;
  }
  const BlockFront above = front.rows() == 1 ? front.gatheredTo(0) : front.above(halvings);
  for (std::size_t k = 0; k != front.rows(); ++k)
  {
    borders[k].to = above.hostOf(above.rowOf(front.row(k).begin));
  }
  fronts.push_back(above);
  step = Step::Up;
}

void BlockTriangulation::State::giveBorder(std::vector<BlockMessage>& out)
{
  const auto found = pending.find(level);
  if (found != pending.end())
  {
    const BlockFront& above = fronts[level + 1];
    const BlockFront& front = fronts[level];
    const BlockRow row = front.row(front.rowHostedBy(input.block));
    out.emplace_back();
    out.back().block = above.hostOf(above.rowOf(row.begin));
    BytesWriter{ out.back().bytes }(found->second);
    pending.erase(found);
  }
  borders.clear();
}

Status BlockTriangulation::State::takeBorders(
  const std::vector<BlockMessage>& in, const Context& context)
{
  const BlockFront below = fronts[level];
  const BlockFront& front = fronts[++level];
  const bool isTop = front.rows() == 1;
  const std::size_t k = front.rowHostedBy(input.block);
  if (k != front.rows())
  {
    std::vector<PartBorder> borderOf;
    for (std::size_t child = below.rowOf(front.row(k).begin);
         child != below.rows() && below.row(child).begin < front.row(k).end; ++child)
    {
      borderOf.emplace_back();
      for (const BlockMessage& message : in)
      {
        if (message.block == below.hostOf(child))
        {
          BytesReader{ message.bytes }(borderOf.back());
        }
      }
    }
    Status status = parts[level].makeOf(borderOf, context);
    status = status == Status::Ok && isTop ? constrainAll(context) : status;
    if (status != Status::Ok)
    {
      return status;
    }
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0);
      const bool isHere = k != front.rows();
      if (isHere && !parts[level].findBelow(ticker))
      {
        return false;
      }
      if (!isTop)
      {
        return settle(level, ticker);
      }
      step = Step::Down;
      return !isHere || parts[level].finishAll(ticker);
    });
}

} // namespace ahd
