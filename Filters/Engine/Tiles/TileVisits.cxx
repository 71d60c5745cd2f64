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
  , segments_(plan_.facts().lines)
{
  std::vector<Bounds> reaches;
  for (std::size_t k = 0; k != plan_.leaves(); ++k)
  {
    reaches.push_back(plan_.reach(k));
  }
  boxes_.set(std::move(reaches), plan_.overlap());
  dealCorners();
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

/// Triangles are written where they stay: these are most of what a visit keeps.
bool writeOwn(const TilePlan& plan, std::size_t leaf, Part& part, Ticker& ticker, BlockBytes& own)
{
  std::vector<Index> pieces;
  if (part.pieceCount() > 1 && !part.listPieces(pieces, ticker))
  {
    return false;
  }
  beginBytes(TileKind::Own, plan, leaf, own);
  const std::uint64_t numbers = 3 * std::uint64_t(part.finalTriangles());
  BytesWriter{ own }(numbers);
  const std::size_t begin = own.size(); // a multiple of 8
  own.reserve(begin + (numbers + pieces.size()) * sizeof(Index) + sizeof(std::uint64_t));
  own.resize(begin + numbers * sizeof(Index));
  const bool goesOn = part.writeFinal(reinterpret_cast<std::int32_t*>(own.data() + begin), ticker);
  BytesWriter{ own }(pieces);
  endBytes(own);
  return goesOn;
}

/// What a part that is not the root hands up, once its final triangles are known.
bool makeBorder(const TilePlan& plan, Part& part, TileBorder& border, Ticker& ticker)
{
  if (!part.makeBorder(border.border, ticker) || (plan.hasLoops() && !part.findPieces(ticker)))
  {
    return false;
  }
  border.pieces = plan.hasLoops() ? part.piecesOfBorder() : border.pieces;
  return true;
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
      Surroundings around{ boxes_, {} };
      TileBorder border;
      if (!findEnds(given.leaf, part, ticker) ||
        !joinSegments(given.leaf, given.points.count, around, ticker) ||
        !part.findFinal(plan_.rowOf(given.leaf), around, ticker) ||
        !makeBorder(plan_, part, border, ticker))
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
      const bool isRoot = node == plan_.root();
      Part part;
      Status status = part.makeOf(below, context);
      status = status == Status::Ok && isRoot ? constrain(part, context) : status;
      if (status != Status::Ok)
      {
        return status;
      }
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      Surroundings around{ boxes_, {} };
      TileBorder border;
      const bool goesOn = part.findBelow(ticker) &&
        (isRoot ? part.finishAll(ticker)
                : joinSegments(node, part.given().size(), around, ticker) &&
              part.findFinal(plan_.rowOf(node), around, ticker) &&
              makeBorder(plan_, part, border, ticker));
      if (!goesOn || !writeShare(plan_, node, part, borders, ticker, out.share))
      {
        return Status::Cancelled;
      }
      if (isRoot)
      {
        out.constraints = tellConstraints(constraintsOf(part.triangulation().constraints()));
      }
      else
      {
        writeBorder(plan_, node, border, out.border);
      }
      return Status::Ok;
    });
}

std::vector<std::int64_t> TileVisits::tellConstraints(const TileConstraints& counts) const
{
  return plan_.hasLines() ? std::vector<std::int64_t>(counts.begin(), counts.end())
                          : std::vector<std::int64_t>();
}

bool TileVisits::readSections(
  std::size_t leaf, const std::vector<TileView>& shares, TileKept& kept) const
{
  std::size_t node = leaf;
  for (const TileView& share : shares)
  {
    node = node == plan_.root() ? plan_.root() : plan_.parents()[node];
    kept.sections.emplace_back();
    if (!readSection(plan_, node, leaf, share, kept.sections.back()))
    {
      return false;
    }
  }
  TileConstraints counts;
  if (node != plan_.root() || !readConstraints(plan_, node, shares.back(), counts))
  {
    return false;
  }
  kept.constraints = tellConstraints(counts);
  return true;
}

/// From the root down: which pieces of the parts below are kept.
bool TileVisits::followPieces(TileKept& kept) const
{
  const std::size_t count = kept.sections.size();
  kept.flags.assign(plan_.hasLoops() ? count : 0, {});
  for (std::size_t k = kept.flags.size(); k-- > 0;)
  {
    const TileSection& section = kept.sections[k];
    const bool isRoot = k + 1 == count;
    for (const Index piece : section.pieces)
    {
      if (!isRoot && piece >= kept.flags[k + 1].size())
      {
        return false;
      }
      kept.flags[k].push_back(isRoot ? std::uint8_t(piece != 0) : kept.flags[k + 1][piece]);
    }
    const auto isIn = [&](Index piece) { return piece < kept.flags[k + 1].size(); };
    if (section.pieceOf.size() != (isRoot ? 0 : section.corners.size()) ||
      !std::all_of(section.pieceOf.begin(), section.pieceOf.end(), isIn))
    {
      return false;
    }
  }
  const auto isOwn = [&](Index piece) { return piece < kept.flags[0].size(); };
  return kept.flags.empty() || kept.own.count == 0 ||
    (!kept.flags[0].empty() && std::all_of(kept.own.pieces.begin(), kept.own.pieces.end(), isOwn));
}

bool TileVisits::readKept(
  std::size_t leaf, const TileView* own, const std::vector<TileView>& shares, TileKept& kept) const
{
  kept = TileKept();
  return (!own || readOwn(plan_, leaf, *own, kept.own)) && readSections(leaf, shares, kept) &&
    followPieces(kept);
}

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

Status TileVisits::findFits(
  const TilePoints& given, const TileKept& kept, const Context& context, bool& fits) const
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      fits = std::all_of(kept.sections.begin(), kept.sections.end(),
        [&](const TileSection& section) { return areOf(given, section); });
      return inSteps(0, kept.own.count, ticker,
        [&](std::size_t t)
        {
          const std::array<Index, 3> c = kept.own[t];
          fits = fits && std::max({ c[0], c[1], c[2] }) < given.points.count;
        });
    });
}

Status TileVisits::findFault(
  const TilePoints& given, const Context& context, const char*& fault) const
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      const PointView& points = given.points;
      const Bounds& box = plan_.box(given.leaf);
      bool areIn = true, ascend = true;
      const auto look = [&](std::size_t i)
      {
        const Point p = points[i];
        areIn &= box.xmin <= p.x && p.x <= box.xmax && box.ymin <= p.y && p.y <= box.ymax;
        ascend &= !given.ids || given.ids[i] > (i == 0 ? -1 : given.ids[i - 1]);
      };
      const bool areAll = points.count == plan_.leaf(given.leaf).count;
      const bool goesOn = !areAll || inSteps(0, points.count, ticker, look);
      fault = !areAll ? "There are more or fewer points than were counted in the leaf."
        : !areIn      ? "A point is not in the leaf."
        : !ascend     ? "The ids do not ascend."
                      : nullptr;
      return goesOn && ticker.ask();
    });
}

} // namespace ahd
