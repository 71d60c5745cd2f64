// SPDX-License-Identifier: BSD-3-Clause
#include "Regions.h"

#include "../Core/Chunks.h"

#include <vector>

namespace ahd
{

namespace
{

/// Visits the triangles region by region.
class Flood
{
public:
  Flood(ConstrainedMesh& mesh, const EdgeTable& edges, Ticker& ticker)
    : mesh_(mesh)
    , edges_(edges)
    , ticker_(ticker)
  {
  }

  bool dropWrongSides(std::size_t& dropped);
  bool dropEvenOnes(std::size_t& dropped);

private:
  /// How the loops use the edge: by balance, as seen from the half-edge's triangle.
  std::int64_t balance(Mesh::Halfedge h) const
  {
    const Index from = mesh_.origin(h), to = mesh_.destination(h);
    const EdgeTable::Edge& edge = *edges_.find(from, to);
    return from < to ? edge.balance : -edge.balance;
  }
  bool isOdd(Mesh::Halfedge h) const
  {
    return mesh_.isConstrained(h) &&
      edges_.find(mesh_.origin(h), mesh_.destination(h))->uses % 2 != 0;
  }

  bool isVisited(Mesh::Halfedge h) const { return (mesh_.marks(h) & kVisited) != 0; }
  void visit(Mesh::Slot slot)
  {
    mesh_.marks(slot) |= kVisited;
    region_.push_back(slot);
  }
  bool visitRegion(Mesh::Slot start, bool& isLeft);
  bool clearVisited(std::size_t& dropped);

  ConstrainedMesh& mesh_;
  const EdgeTable& edges_;
  Ticker& ticker_;
  std::vector<Mesh::Slot> region_;
};

/// One region of finite triangles, and whether it lies on the left of all its loop edges.
bool Flood::visitRegion(Mesh::Slot start, bool& isLeft)
{
  isLeft = true;
  region_.clear();
  visit(start);
  for (std::size_t i = 0; i < region_.size(); ++i)
  {
    for (Mesh::Halfedge h = region_[i]; h != region_[i] + 3; ++h)
    {
      const std::int64_t side = mesh_.isConstrained(h) ? balance(h) : 0;
      isLeft = isLeft && side >= 0;
      const Mesh::Slot neighbour = Mesh::slotOf(mesh_.twin(h));
      if (side == 0 && !isVisited(neighbour) && !mesh_.isGhost(neighbour))
      {
        visit(neighbour);
      }
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

bool Flood::dropWrongSides(std::size_t& dropped)
{
  for (std::size_t k = 0; k < mesh_.triangles(); ++k)
  {
    const Mesh::Slot slot = Mesh::slotOfTriangle(k);
    bool isLeft = true;
    if (!ticker_.step())
    {
      return false;
    }
    if (isVisited(slot) || mesh_.isGhost(slot))
    {
      continue;
    }
    if (!visitRegion(slot, isLeft))
    {
      return false;
    }
    for (const Mesh::Slot own : region_)
    {
      mesh_.marks(own) |= isLeft ? kInside : 0;
    }
  }
  return clearVisited(dropped);
}

/// From infinity inwards: each triangle is reached across edges whose loops are counted on the way.
/// All ways agree, as loops are closed.
bool Flood::dropEvenOnes(std::size_t& dropped)
{
  Mesh::Slot outside = 0;
  while (!mesh_.isGhost(outside))
  {
    outside += Mesh::kSlotSize;
    if (!ticker_.step())
    {
      return false;
    }
  }
  region_.clear();
  visit(outside);
  while (!region_.empty())
  {
    const Mesh::Slot slot = region_.back();
    region_.pop_back();
    for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
    {
      const Mesh::Slot neighbour = Mesh::slotOf(mesh_.twin(h));
      if (!isVisited(neighbour))
      {
        const bool isInside = ((mesh_.marks(slot) & kInside) != 0) != isOdd(h);
        mesh_.marks(neighbour) |= isInside ? kInside : 0;
        visit(neighbour);
      }
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  return clearVisited(dropped);
}

/// What is finite and not inside is dropped.
bool Flood::clearVisited(std::size_t& dropped)
{
  return inChunks(0, mesh_.triangles(), ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t k = a; k != b; ++k)
      {
        const Mesh::Slot slot = Mesh::slotOfTriangle(k);
        std::uint8_t& marks = mesh_.marks(slot);
        const bool goes = (marks & kInside) == 0 && !mesh_.isGhost(slot);
        marks = static_cast<std::uint8_t>((marks & kConstrainedEdges) | (goes ? kDropped : 0));
        dropped += goes ? 1 : 0;
      }
    });
}

} // namespace

bool dropOutside(ConstrainedMesh& mesh, const EdgeTable& edges, FillRule rule, Ticker& ticker,
  std::size_t& dropped)
{
  Flood flood(mesh, edges, ticker);
  return rule == FillRule::EvenOdd ? flood.dropEvenOnes(dropped) : flood.dropWrongSides(dropped);
}

} // namespace ahd
