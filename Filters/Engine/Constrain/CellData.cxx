// SPDX-License-Identifier: BSD-3-Clause
#include "CellData.h"

#include "../Core/Chunks.h"
#include "../Core/SortAsking.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace ahd
{

namespace
{

/// An edge from a vertex, by its other end.
using Spoke = std::pair<Index, Mesh::Halfedge>;

/// The edges with which the triangles begin that have the vertex as their lowest corner and are not
/// dropped, by the corner that follows.
bool findSpokes(
  const ConstrainedMesh& mesh, Index vertex, Ticker& ticker, std::vector<Spoke>& spokes)
{
  spokes.clear();
  const Mesh::Halfedge start = mesh.outgoing(vertex);
  Mesh::Halfedge h = start;
  do
  {
    const Index next = mesh.destination(h), third = mesh.apex(h);
    if (vertex < next && vertex < third && std::max(next, third) != mesh.ghost() &&
      (mesh.marks(h) & kDropped) == 0)
    {
      spokes.emplace_back(next, h);
    }
    h = mesh.nextAround(h);
    if (!ticker.step())
    {
      return false;
    }
  } while (h != start);
  return sortAsking(spokes, ticker, std::less<>());
}

} // namespace

/// The order of the output is that of the lowest corner, then of the next one counterclockwise: so
/// the triangles are met vertex after vertex, and few have to be sorted at each.
bool CellData::begin(const ConstrainedMesh& mesh, std::size_t triangles, Ticker& ticker)
{
  first_.allocate(triangles);
  number_.allocate(mesh.triangles());
  if (!fillAll(number_, kNoIndex, ticker))
  {
    return false;
  }
  std::vector<Spoke> spokes;
  std::uint32_t count = 0;
  for (Index vertex = 0; vertex != mesh.ghost(); ++vertex)
  {
    if (!ticker.step() || (mesh.isInMesh(vertex) && !findSpokes(mesh, vertex, ticker, spokes)))
    {
      return false;
    }
    for (const Spoke& spoke : spokes)
    {
      number_[spoke.second / Mesh::kSlotSize] = count;
      first_[count++] = spoke.second;
    }
    spokes.clear();
  }
  return true;
}

template <typename Visit>
bool CellData::eachTriangle(Ticker& ticker, Visit visit) const
{
  return inChunks(0, first_.size(), ticker,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        const Mesh::Halfedge h = first_[i];
        visit(i, 0, h);
        visit(i, 1, Mesh::next(h));
        visit(i, 2, Mesh::previous(h));
      }
      ticker.finished(b - a);
    });
}

bool CellData::writeNeighbors(const ConstrainedMesh& mesh, std::int64_t* out, Ticker& ticker) const
{
  return eachTriangle(ticker,
    [&](std::size_t i, unsigned e, Mesh::Halfedge h)
    {
      const std::uint32_t neighbour = number_[mesh.twin(h) / Mesh::kSlotSize];
      out[3 * i + e] = neighbour == kNoIndex ? -1 : std::int64_t(neighbour);
    });
}

bool CellData::writeConstraintEdges(
  const ConstrainedMesh& mesh, std::uint8_t* out, Ticker& ticker) const
{
  return eachTriangle(ticker,
    [&](std::size_t i, unsigned e, Mesh::Halfedge h)
    {
      const unsigned before = e == 0 ? 0u : out[i];
      out[i] = static_cast<std::uint8_t>(before | (mesh.isConstrained(h) ? 1u << e : 0u));
    });
}

bool CellData::writeRegions(const ConstrainedMesh& mesh, std::int64_t* out, Ticker& ticker) const
{
  constexpr std::int64_t kNone = -1;
  const auto clear = [=](std::size_t a, std::size_t b) { std::fill(out + a, out + b, kNone); };
  if (!inChunks(0, first_.size(), ticker, clear))
  {
    return false;
  }
  std::vector<std::uint32_t> region;
  std::int64_t regions = 0;
  for (std::size_t start = 0; start < first_.size(); ++start)
  {
    if (out[start] != kNone)
    {
      continue;
    }
    region.assign(1, static_cast<std::uint32_t>(start));
    out[start] = regions;
    while (!region.empty())
    {
      const Mesh::Slot slot = Mesh::slotOf(first_[region.back()]);
      region.pop_back();
      for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
      {
        const std::uint32_t neighbour = number_[mesh.twin(h) / Mesh::kSlotSize];
        if (neighbour != kNoIndex && out[neighbour] == kNone && !mesh.isConstrained(h))
        {
          out[neighbour] = regions;
          region.push_back(neighbour);
        }
      }
      if (!ticker.step())
      {
        return false;
      }
      ticker.finished(1);
    }
    ++regions;
  }
  return true;
}

} // namespace ahd
