// SPDX-License-Identifier: BSD-3-Clause
#include "BlockChains.h"

#include "../Core/Chunks.h"
#include "Steps.h"

#include <tuple>

namespace ahd
{

namespace
{

enum Kind : std::size_t
{
  Line,
  Polygon,
  Kinds
};

/// Chains of one kind.
struct OwnChains
{
  std::vector<std::int64_t> ids;
  std::vector<std::int64_t> sizes; ///< of the chains

  auto fields() { return std::tie(ids, sizes); }
};

} // namespace

/// The constraints of one block.
struct BlockChains::Own
{
  OwnChains of[Kinds];
  std::int64_t lineCells = 0, polygonCells = 0;
  std::vector<LineEnds> ends; ///< of lines, where closed ones are loops
  UnfitIds unfit;

  bool read(const InputRequest& request, const PreparedInput& prepared, const BlockIds& blockIds,
    Ticker& ticker);

  auto fields() { return std::tie(of[Line], of[Polygon], lineCells, polygonCells, ends, unfit); }
};

bool BlockChains::Own::read(const InputRequest& request, const PreparedInput& prepared,
  const BlockIds& blockIds, Ticker& ticker)
{
  lineCells = static_cast<std::int64_t>(request.lines.cells);
  polygonCells = static_cast<std::int64_t>(request.polygons.cells);
  if (!prepared.hasConstraints())
  {
    return true;
  }
  unfit = prepared.unfitIds();
  unfit.firstCell -= unfit.count > 0 ? request.firstCell : 0;
  const ConstraintView chains = prepared.constraints();
  for (std::size_t chain = 0; chain != chains.chains; ++chain)
  {
    const bool isLine = chain < chains.lines;
    OwnChains& to = of[isLine ? Line : Polygon];
    const std::int64_t begin = chains.offsets[chain], end = chains.offsets[chain + 1];
    if (isLine && request.closedLinesAreLoops)
    {
      ends.push_back(prepared.endsOf(chain));
    }
    to.sizes.push_back(end - begin);
    const auto add = [&](std::size_t i) { to.ids.push_back(blockIds.of(chains.ids[i])); };
    if (!inSteps(std::size_t(begin), std::size_t(end), ticker, add) || !ticker.step())
    {
      return false;
    }
  }
  return true;
}

/// In the appended source, vertices come before lines, and these before polygons.
bool BlockChains::append(const std::vector<Own>& all, std::int64_t vertices, Ticker& ticker)
{
  std::vector<std::int64_t> firstLine, firstPolygon;
  for (const Own& own : all)
  {
    firstLine.push_back(vertices);
    vertices += own.lineCells;
  }
  for (const Own& own : all)
  {
    firstPolygon.push_back(vertices);
    vertices += own.polygonCells;
  }
  chains_.offsets.push_back(0);
  for (std::size_t kind = 0; kind != Kinds; ++kind)
  {
    for (std::size_t block = 0; block != all.size(); ++block)
    {
      const OwnChains& some = all[block].of[kind];
      std::int64_t cell = (kind == Polygon ? firstPolygon : firstLine)[block];
      chains_.ids.insert(chains_.ids.end(), some.ids.begin(), some.ids.end());
      for (const std::int64_t size : some.sizes)
      {
        chains_.offsets.push_back(chains_.offsets.back() + size);
        chains_.cells.push_back(cell++);
        if (!ticker.step())
        {
          return false;
        }
      }
    }
    chains_.lines = kind == Line ? chains_.cells.size() : chains_.lines;
  }
  for (std::size_t block = 0; block != all.size(); ++block)
  {
    addUnfit(all[block], firstLine[block], firstPolygon[block]);
  }
  return true;
}

void BlockChains::addUnfit(const Own& own, std::int64_t firstLine, std::int64_t firstPolygon)
{
  const UnfitIds& more = own.unfit;
  const bool isLine = more.firstCell < own.lineCells;
  const std::int64_t cell = more.firstCell + (isLine ? firstLine : firstPolygon - own.lineCells);
  if (more.count > 0 && (unfit_.count == 0 || cell < unfit_.firstCell))
  {
    unfit_.firstId = more.firstId;
    unfit_.firstCell = cell;
  }
  unfit_.count += more.count;
}

/// Of the appended source.
bool BlockChains::close(const std::vector<Own>& all, Ticker& ticker)
{
  std::vector<LineEnds> ends;
  for (const Own& own : all)
  {
    ends.insert(ends.end(), own.ends.begin(), own.ends.end());
  }
  bool found = false;
  const bool done = closeLines(ends, chains_, ticker, found);
  areLinesUnclosed_ = !found && chains_.haveSegments();
  return done;
}

Status BlockChains::join(const InputRequest& request, const PreparedInput& prepared,
  const BlockIds& ids, std::int64_t vertices, BlockTransport& transport, const Context& context)
{
  std::vector<Own> all;
  Steps steps(transport, context);
  steps.share(
    all, [&](Own& own, Ticker& ticker) { return own.read(request, prepared, ids, ticker); });
  steps.each(
    [&](Ticker& ticker) {
      return append(all, vertices, ticker) && (!request.closedLinesAreLoops || close(all, ticker));
    });
  return steps.status();
}

ConstraintView BlockChains::view() const
{
  ConstraintView view;
  view.ids = chains_.ids.data();
  view.offsets = chains_.offsets.data();
  view.chains = chains_.cells.size();
  view.lines = chains_.lines;
  return view;
}

} // namespace ahd
