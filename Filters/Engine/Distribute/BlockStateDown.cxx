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
    BytesWriter writer(out.back().bytes);
    writer.write(std::uint64_t(kept.isAll ? 1 : 0));
    writer.writeAll(kept.edges);
    writer.writeAll(some.points);
    writer.writeAll(some.corners);
    writer.writeAll(some.flags);
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
    BytesReader reader(message.bytes);
    Part::Kept kept;
    OwnedTriangles some;
    kept.isAll = reader.read<std::uint64_t>() != 0;
    reader.readAll(kept.edges);
    reader.readAll(some.points);
    reader.readAll(some.corners);
    reader.readAll(some.flags);
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

/// Sorts what is shared, and gives its corners their numbers.
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
  for (const BorderPoint& p : sharedPoints)
  {
    if (p.block != input.block)
    {
      foreign.push_back({ p.id, p.block, p.at });
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  const auto isLess = [](const ForeignPoint& p, const ForeignPoint& q) { return p.id < q.id; };
  if (!sortAsking(foreign, ticker, isLess))
  {
    return false;
  }
  const auto isSame = [](const ForeignPoint& p, const ForeignPoint& q) { return p.id == q.id; };
  foreign.erase(std::unique(foreign.begin(), foreign.end(), isSame), foreign.end());
  for (SharedTriangle& triangle : shared)
  {
    for (Index& corner : triangle.corners)
    {
      const BorderPoint& p = sharedPoints[corner];
      const std::int64_t* const ids = input.ids;
      const std::size_t number = p.block == input.block
        ? static_cast<std::size_t>(std::lower_bound(ids, ids + input.points.count, p.id) - ids)
        : input.points.count +
          static_cast<std::size_t>(std::lower_bound(foreign.begin(), foreign.end(),
                                     ForeignPoint{ p.id, 0, p.at }, isLess) -
            foreign.begin());
      corner = static_cast<Index>(number);
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  sharedPoints = std::vector<BorderPoint>();
  return true;
}

void BlockTriangulation::State::sayTotals()
{
  step = Step::Totals;
  toAll.clear();
  BytesWriter writer(toAll);
  writer.write(std::uint64_t(own().finalTriangles()));
  writer.write(std::uint64_t(sharedOwn));
  writer.write(std::uint64_t(isHostOfAll ? 1 : 0));
  if (isHostOfAll)
  {
    const ConstraintReport& c = report.constraints;
    for (const std::size_t count :
      { c.segments, c.points, c.withoutVertex, c.crossing, c.unfilledLoops, c.edges })
    {
      writer.write(std::uint64_t(count));
    }
    writer.writeAll(c.leftOut);
  }
}

void BlockTriangulation::State::takeTotals(const std::vector<BlockBytes>& all)
{
  for (const BlockBytes& bytes : all)
  {
    BytesReader reader(bytes);
    const auto own = static_cast<std::size_t>(reader.read<std::uint64_t>());
    report.ownTriangles += own;
    report.triangles += own + static_cast<std::size_t>(reader.read<std::uint64_t>());
    if (reader.read<std::uint64_t>() != 0)
    {
      ConstraintReport c;
      for (std::size_t* const count :
        { &c.segments, &c.points, &c.withoutVertex, &c.crossing, &c.unfilledLoops, &c.edges })
      {
        *count = static_cast<std::size_t>(reader.read<std::uint64_t>());
      }
      reader.readAll(c.leftOut);
      report.constraints = std::move(c);
    }
  }
  step = Step::Done;
}

} // namespace ahd
