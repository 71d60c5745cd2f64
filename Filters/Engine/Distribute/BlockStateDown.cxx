// SPDX-License-Identifier: BSD-3-Clause
#include "BlockState.h"

#include "../Core/SortAsking.h"

#include <algorithm>
#include <utility>

namespace ahd
{

bool BlockTriangulation::State::giveDown(std::vector<BlockMessage>& out, Ticker& ticker)
{
  const auto found = parts.find(level);
  if (found == parts.end())
  {
    return true;
  }
  const BlockFront& front = fronts[level];
  const BlockFront& below = fronts[level - 1];
  const BlockRow row = front.row(front.rowHostedBy(input.block));
  std::vector<OwnedTriangles> owned;
  if (!found->second.listOwned(row, owned, ticker))
  {
    return false;
  }
  const std::size_t firstChild = below.rowOf(row.begin);
  for (std::size_t block = row.begin; block != row.end; ++block)
  {
    const std::size_t child = below.rowOf(block);
    Part::Kept kept;
    if (below.hostOf(child) == block)
    {
      found->second.tellKept(child - firstChild, kept);
    }
    OwnedTriangles& some = owned[block - row.begin];
    if (kept.isAll && some.corners.empty())
    {
      continue;
    }
    out.emplace_back();
    out.back().block = block;
    BytesWriter{ out.back().bytes }(kept, some);
    some = OwnedTriangles();
    if (!ticker.step())
    {
      return false;
    }
  }
  parts.erase(found);
  return true;
}

bool BlockTriangulation::State::takeDown(const std::vector<BlockMessage>& in, Ticker& ticker)
{
  --level;
  for (const BlockMessage& message : in)
  {
    Part::Kept kept;
    OwnedTriangles some;
    BytesReader{ message.bytes }(kept, some);
    const auto part = parts.find(level);
    if (!kept.isAll && part != parts.end() && !part->second.takeKept(kept, ticker))
    {
      return false;
    }
    const auto first = static_cast<Index>(sharedPoints.size());
    sharedPoints.insert(sharedPoints.end(), some.points.begin(), some.points.end());
    for (std::size_t t = 0; t != some.flags.size(); ++t)
    {
      const Index* const c = some.corners.data() + 3 * t;
      shared.push_back({ { { c[0] + first, c[1] + first, c[2] + first } }, some.flags[t] });
      if (!ticker.step())
      {
        return false;
      }
    }
  }
  if (level > 0)
  {
    return true;
  }
  if (!numberShared(ticker))
  {
    return false;
  }
  sayTotals();
  return true;
}

/// Sorts shared triangles, and numbers their corners.
bool BlockTriangulation::State::numberShared(Ticker& ticker)
{
  const auto isGhost = [](const SharedTriangle& s)
  { return (s.flags & OwnedTriangles::kGhost) != 0; };
  const auto isBefore = [&](const SharedTriangle& s, const SharedTriangle& t)
  {
    if (isGhost(s) != isGhost(t))
    {
      return isGhost(t);
    }
    for (std::size_t e = 0; e != 3; ++e)
    {
      const Point& p = sharedPoints[s.corners[e]].at;
      const Point& q = sharedPoints[t.corners[e]].at;
      if (!(p == q))
      {
        return lexicographicallyLess(p, q);
      }
    }
    return false;
  };
  if (!sortAsking(shared, ticker, isBefore))
  {
    return false;
  }
  sharedOwn = static_cast<std::size_t>(std::partition_point(shared.begin(), shared.end(),
                                         [&](const SharedTriangle& s) { return !isGhost(s); }) -
    shared.begin());
  const auto addForeign = [&](std::size_t i)
  {
    const BorderPoint& p = sharedPoints[i];
    if (p.block != input.block)
    {
      foreign.push_back({ p.id, p.block, p.at });
    }
  };
  if (!inSteps(0, sharedPoints.size(), ticker, addForeign) || !sortOnce(foreign, ticker))
  {
    return false;
  }
  const auto number = [&](std::size_t i)
  {
    for (Index& corner : shared[i].corners)
    {
      const BorderPoint& p = sharedPoints[corner];
      const std::int64_t* const ids = input.ids;
      corner = static_cast<Index>(p.block == input.block
          ? static_cast<std::size_t>(std::lower_bound(ids, ids + input.points.count, p.id) - ids)
          : input.points.count +
            static_cast<std::size_t>(
              std::lower_bound(foreign.begin(), foreign.end(), ForeignPoint{ p.id, 0, p.at }) -
              foreign.begin()));
    }
  };
  if (!inSteps(0, shared.size(), ticker, number))
  {
    return false;
  }
  sharedPoints = std::vector<BorderPoint>();
  return true;
}

void BlockTriangulation::State::sayTotals()
{
  step = Step::Totals;
  toAll.clear();
  const BlockTotals totals{ own().finalTriangles(), sharedOwn, isHostOfAll,
    isHostOfAll ? report.constraints : ConstraintReport() };
  BytesWriter{ toAll }(totals);
}

void BlockTriangulation::State::takeTotals(const std::vector<BlockBytes>& all)
{
  report.counts.triangles = 0; // for those of each block by itself
  for (const BlockBytes& bytes : all)
  {
    BlockTotals totals;
    BytesReader{ bytes }(totals);
    report.ownTriangles += totals.own;
    report.counts.triangles += totals.own + totals.shared;
    if (totals.isHostOfAll)
    {
      report.constraints = std::move(totals.constraints);
    }
  }
  step = Step::Done;
}

} // namespace ahd
