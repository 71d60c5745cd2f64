// SPDX-License-Identifier: BSD-3-Clause
#include "Regions.h"

#include "../Core/Chunks.h"

namespace ahd
{

namespace
{

/// Visits the triangles region by region.
class Flood
{
public:
  Flood(ConstrainedMesh& mesh, const LoopEdges& edges, Ticker& ticker)
    : mesh_(mesh)
    , edges_(edges)
    , ticker_(ticker)
  {
    queue_.allocate(mesh.triangles());
  }

  bool dropWrongSides(std::size_t& dropped);
  bool dropEvenOnes(std::size_t& dropped);

private:
  /// How the loops use the edge: by balance, as seen from the half-edge's triangle.
  std::int64_t balance(Mesh::Halfedge h) const
  {
    if (!mesh_.isConstrained(h))
    {
      return 0;
    }
    const Index from = mesh_.origin(h), to = mesh_.destination(h);
    const std::int64_t* const value = edges_.find(from, to);
    return value == nullptr ? 0 : from < to ? *value : -*value;
  }
  bool isOdd(Mesh::Halfedge h) const { return balance(h) % 2 != 0; }

  bool isVisited(Mesh::Halfedge h) const { return (mesh_.marks(h) & kVisited) != 0; }
  /// Prefetch: it is read much later, after the others in the queue.
  void visit(Mesh::Slot slot)
  {
    mesh_.marks(slot) |= kVisited;
    prefetchForRead(mesh_.data() + slot);
    queue_[end_++] = slot;
  }
  bool visitRegion(Mesh::Slot start, bool& isLeft);
  bool markInside();
  bool clearVisited(std::size_t& dropped);

  ConstrainedMesh& mesh_;
  const LoopEdges& edges_;
  Ticker& ticker_;
  Buffer<Mesh::Slot> queue_; ///< triangles visited, one after the other
  std::size_t end_ = 0;      ///< of those
};

/// One region of finite triangles, and whether it lies on the left of all its loop edges. Ghosts
/// at its rim are visited with it.
bool Flood::visitRegion(Mesh::Slot start, bool& isLeft)
{
  isLeft = true;
  end_ = 0;
  visit(start);
  for (std::size_t i = 0; i < end_; ++i)
  {
    const Mesh::Slot slot = queue_[i];
    if (!ticker_.step())
    {
      return false;
    }
    if (mesh_.isGhost(slot))
    {
      continue;
    }
    for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
    {
      const std::int64_t side = balance(h);
      isLeft = isLeft && side >= 0;
      const Mesh::Slot neighbour = Mesh::slotOf(mesh_.twin(h));
      if (side == 0 && !isVisited(neighbour))
      {
        visit(neighbour);
      }
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
    if (isLeft && !markInside())
    {
      return false;
    }
  }
  return clearVisited(dropped);
}

/// All triangles in the queue.
bool Flood::markInside()
{
  return inChunks(0, end_, ticker_,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t i = a; i != b; ++i)
      {
        mesh_.marks(queue_[i]) |= kInside;
      }
    });
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
  visit(outside);
  for (std::size_t i = 0; i < end_; ++i)
  {
    const Mesh::Slot slot = queue_[i];
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

/// Drops finite triangles that are not inside.
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

bool dropOutside(ConstrainedMesh& mesh, const LoopEdges& edges, FillRule rule, Ticker& ticker,
  std::size_t& dropped)
{
  Flood flood(mesh, edges, ticker);
  return rule == FillRule::EvenOdd ? flood.dropEvenOnes(dropped) : flood.dropWrongSides(dropped);
}

} // namespace ahd
