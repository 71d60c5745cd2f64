// SPDX-License-Identifier: BSD-3-Clause
#include "TileVisits.h"

#include "../Core/Border.h"
#include "../Core/Chunks.h"

#include <algorithm>
#include <cstring>

namespace ahd
{

TileVisits::TileVisits(TileFacts facts)
  : plan_(std::move(facts))
{
  std::vector<Bounds> reaches;
  for (std::size_t k = 0; k != plan_.leaves(); ++k)
  {
    reaches.push_back(plan_.reach(k));
  }
  around_.boxes.set(std::move(reaches), plan_.overlap());
}

namespace
{

/// The ids of a leaf's points.
std::vector<std::int64_t> numbersOf(const TilePlan& plan, const TilePoints& given)
{
  std::vector<std::int64_t> ids;
  for (std::size_t i = 0; !given.ids && i != given.points.count; ++i)
  {
    ids.push_back(static_cast<std::int64_t>(plan.firstPoint(given.leaf) + i));
  }
  return ids;
}

bool writeOwn(const TilePlan& plan, std::size_t leaf, Part& part, Ticker& ticker, BlockBytes& own)
{
  beginBytes(TileKind::Own, plan, leaf, own);
  std::vector<std::int32_t> triples(3 * part.finalTriangles());
  const bool goesOn = part.writeFinal(triples.data(), ticker);
  BytesWriter{ own }(triples);
  endBytes(own);
  return goesOn;
}

void writeBorder(const TilePlan& plan, std::size_t part, const TileBorder& border, BlockBytes& out)
{
  beginBytes(TileKind::Border, plan, part, out);
  BytesWriter{ out }(border);
  endBytes(out);
}

} // namespace

Status TileVisits::visit(const TilePoints& given, Representative representative,
  const Context& context, TileOutput& out) const
{
  out = TileOutput();
  return withoutThrowing(
    [&]
    {
      const Bounds& all = plan_.facts().bounds;
      const std::vector<std::int64_t> numbers = numbersOf(plan_, given);
      Options options;
      options.representative = representative;
      options.rankBounds = { all.xmin, all.xmax, all.ymin, all.ymax };
      Part part;
      const Status status = part.makeOwn(given.points, given.ids ? given.ids : numbers.data(),
        static_cast<std::uint32_t>(given.leaf), options, context);
      if (status != Status::Ok)
      {
        return status;
      }
      part.keepCrowds();
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      TileBorder border;
      if (!part.findFinal(plan_.rowOf(given.leaf), around_, ticker) ||
        !part.makeBorder(border.border, ticker))
      {
        return Status::Cancelled;
      }
      writeBorder(plan_, given.leaf, border, out.border);
      return writeOwn(plan_, given.leaf, part, ticker, out.own) ? Status::Ok : Status::Cancelled;
    });
}

bool TileVisits::readBorders(
  std::size_t node, const std::vector<TileView>& given, std::vector<TileBorder>& borders) const
{
  const std::vector<std::size_t>& parts = plan_.joinedBy(node);
  borders.clear();
  for (std::size_t k = 0; k != parts.size() && parts.size() == given.size(); ++k)
  {
    const TileView content = contentOf(TileKind::Border, plan_, parts[k], given[k]);
    if (!content.data)
    {
      return false;
    }
    borders.emplace_back();
    BytesReader{ content.data, content.size }(borders.back());
    const PartBorder& border = borders.back().border;
    const auto isIn = [&border](const BorderEdge& edge)
    { return std::max(edge.from, edge.to) < border.points.size(); };
    if (!std::all_of(border.edges.begin(), border.edges.end(), isIn))
    {
      return false;
    }
  }
  return parts.size() == given.size();
}

Status TileVisits::merge(
  std::size_t node, std::vector<TileBorder>& borders, const Context& context, TileOutput& out) const
{
  out = TileOutput();
  return withoutThrowing(
    [&]
    {
      std::vector<PartBorder> below;
      for (TileBorder& border : borders)
      {
        below.push_back(std::move(border.border));
      }
      Part part;
      const Status status = part.makeOf(below, context);
      if (status != Status::Ok)
      {
        return status;
      }
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      const bool isRoot = node == plan_.root();
      TileBorder border;
      const bool goesOn = part.findBelow(ticker) &&
        (isRoot ? part.finishAll(ticker)
                : part.findFinal(plan_.rowOf(node), around_, ticker) &&
              part.makeBorder(border.border, ticker));
      if (!goesOn || !writeShare(plan_, node, part, ticker, out.share))
      {
        return Status::Cancelled;
      }
      if (!isRoot)
      {
        writeBorder(plan_, node, border, out.border);
      }
      return Status::Ok;
    });
}

bool TileVisits::readSections(
  std::size_t leaf, const std::vector<TileView>& shares, std::vector<TileSection>& sections) const
{
  sections.clear();
  std::size_t node = leaf;
  for (const TileView& share : shares)
  {
    node = node == plan_.root() ? plan_.root() : plan_.parents()[node];
    sections.emplace_back();
    if (!readSection(plan_, node, leaf, share, sections.back()))
    {
      return false;
    }
  }
  return node == plan_.root();
}

namespace
{

constexpr const char* kOthers = "This is not what was kept of a visit of these points.";

/// Are all points in the box?
bool areWithin(const PointView& points, const Bounds& box, Ticker& ticker, bool& answer)
{
  answer = true;
  return inSteps(0, points.count, ticker,
    [&](std::size_t i)
    {
      const Point p = points[i];
      answer &= box.xmin <= p.x && p.x <= box.xmax && box.ymin <= p.y && p.y <= box.ymax;
    });
}

bool doAscend(const TilePoints& given, Ticker& ticker, bool& answer)
{
  answer = true;
  return inSteps(0, given.ids ? given.points.count : 0, ticker,
    [&](std::size_t i) { answer &= given.ids[i] > (i == 0 ? -1 : given.ids[i - 1]); });
}

/// Do they name points of the leaf only?
bool isOwn(const TileView& triples, std::size_t points, Ticker& ticker, bool& answer)
{
  std::uint64_t count = 0;
  answer = triples.data != nullptr && triples.size >= sizeof count;
  if (answer)
  {
    std::memcpy(&count, triples.data, sizeof count);
    answer = count % 3 == 0 && triples.size == sizeof count + count * sizeof(Index);
  }
  return inSteps(0, answer ? static_cast<std::size_t>(count) : 0, ticker,
    [&](std::size_t k)
    {
      Index number;
      std::memcpy(&number, triples.data + sizeof count + k * sizeof number, sizeof number);
      answer &= number < points;
    });
}

} // namespace

bool TileVisits::areOf(const TilePoints& given, const TileSection& section) const
{
  const auto first = static_cast<std::int64_t>(plan_.firstPoint(given.leaf));
  const auto count = static_cast<std::int64_t>(given.points.count);
  return std::all_of(section.points.begin(), section.points.end(),
    [&](const BorderPoint& point)
    {
      return point.block != given.leaf ||
        (given.ids ? std::binary_search(given.ids, given.ids + count, point.id)
                   : first <= point.id && point.id < first + count);
    });
}

Status TileVisits::findFault(
  const TilePoints& given, const TileKept& kept, const Context& context, const char*& fault) const
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      fault = nullptr;
      if (given.points.count != plan_.leaf(given.leaf).count)
      {
        fault = "There are more or fewer points than were counted in the leaf.";
        return ticker.ask();
      }
      bool areIn = false, ascend = false, fits = true;
      if (!areWithin(given.points, plan_.box(given.leaf), ticker, areIn) ||
        !doAscend(given, ticker, ascend))
      {
        return false;
      }
      const bool goesOn = !kept.own ||
        isOwn(
          contentOf(TileKind::Own, plan_, given.leaf, *kept.own), given.points.count, ticker, fits);
      for (std::size_t k = 0; kept.sections && fits && k != kept.sections->size(); ++k)
      {
        fits = areOf(given, (*kept.sections)[k]);
      }
      fault = !areIn ? "A point is not in the leaf."
        : !ascend    ? "The ids do not ascend."
        : !fits      ? kOthers
                     : nullptr;
      return goesOn && ticker.ask();
    });
}

} // namespace ahd
