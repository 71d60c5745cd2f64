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
  Open,
  Closed,
  Polygon,
  Kinds
};

/// Chains of one kind.
struct Chains
{
  std::vector<std::int64_t> ids;
  std::vector<std::int64_t> sizes; ///< of the chains
  std::vector<std::int64_t> cells; ///< of the chains, from 0 for lines and for polygons

  auto fields() { return std::tie(ids, sizes, cells); }
};

} // namespace

/// The constraints of one block.
struct BlockChains::Own
{
  Chains of[Kinds];
  std::int64_t lineCells = 0, polygonCells = 0;
  UnfitIds unfit;

  bool read(const InputRequest& request, const PreparedInput& prepared, const BlockIds& blockIds,
    Ticker& ticker);

  auto fields()
  {
    return std::tie(of[Open], of[Closed], of[Polygon], lineCells, polygonCells, unfit);
  }
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
    const std::int64_t cell = prepared.cellOf(chain) - request.firstCell;
    const bool isLine = cell < lineCells;
    Chains& to = of[chain < chains.lines ? Open : isLine ? Closed : Polygon];
    const std::int64_t begin = chains.offsets[chain], end = chains.offsets[chain + 1];
    to.cells.push_back(isLine ? cell : cell - lineCells);
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
  offsets_.push_back(0);
  for (std::size_t kind = 0; kind != Kinds; ++kind)
  {
    for (std::size_t block = 0; block != all.size(); ++block)
    {
      const Chains& some = all[block].of[kind];
      const std::int64_t first = (kind == Polygon ? firstPolygon : firstLine)[block];
      ids_.insert(ids_.end(), some.ids.begin(), some.ids.end());
      for (std::size_t k = 0; k != some.sizes.size(); ++k)
      {
        offsets_.push_back(offsets_.back() + some.sizes[k]);
        cells_.push_back(some.cells[k] + first);
        if (!ticker.step())
        {
          return false;
        }
      }
    }
    lines_ = kind == Open ? cells_.size() : lines_;
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

Status BlockChains::join(const InputRequest& request, const PreparedInput& prepared,
  const BlockIds& ids, std::int64_t vertices, BlockTransport& transport, const Context& context)
{
  std::vector<Own> all;
  Steps steps(transport, context);
  steps.share(
    all, [&](Own& own, Ticker& ticker) { return own.read(request, prepared, ids, ticker); });
  steps.each([&](Ticker& ticker) { return append(all, vertices, ticker); });
  return steps.status();
}

ConstraintView BlockChains::view() const
{
  ConstraintView view;
  view.ids = ids_.data();
  view.offsets = offsets_.data();
  view.chains = cells_.size();
  view.lines = lines_;
  return view;
}

} // namespace ahd
