// SPDX-License-Identifier: BSD-3-Clause
#include "Rim.h"

#include "../Core/Chunks.h"
#include "../Predicates/Predicates.h"

#include <vector>

namespace ahd
{

namespace
{

/// Twice the signed area of a, b, c, rounded.
double doubledArea(const Point& a, const Point& b, const Point& c)
{
  return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
}

/// One call of trimRim(). Functions that return bool return false if the work is cancelled, unless
/// they are predicates.
class Trimmer
{
public:
  Trimmer(ConstrainedMesh& mesh, Ticker& ticker)
    : mesh_(mesh)
    , ticker_(ticker)
  {
  }

  bool run(TrimmedRim& out);

private:
  bool dropAlongHull();
  bool dropInwards();
  bool countBare(std::size_t& bare);
  void dropAcross(Mesh::Halfedge h);
  bool isFlatAt(Mesh::Halfedge h) const;
  bool mayGo(Mesh::Halfedge h) const;
  bool mayLose(Mesh::Halfedge h) const;
  bool isDropped(Mesh::Halfedge h) const { return (mesh_.marks(h) & kDropped) != 0; }
  bool findGhost(Mesh::Slot& slot);
  bool turnAround(Mesh::Halfedge first, bool& isBare);

  ConstrainedMesh& mesh_;
  Ticker& ticker_;
  std::vector<Mesh::Slot> dropped_;
  double hullArea_ = 0.0; ///< doubled, as the other
  double droppedArea_ = 0.0;
};

bool Trimmer::run(TrimmedRim& out)
{
  if (!dropAlongHull() || !dropInwards())
  {
    return false;
  }
  out.triangles = dropped_.size();
  out.area = dropped_.empty() ? 0.0 : droppedArea_ / hullArea_;
  return dropped_.empty() || countBare(out.bareVertices);
}

/// Is the corner opposite to the half-edge so wide that its triangle is flat? Then this is its
/// longest edge.
bool Trimmer::isFlatAt(Mesh::Halfedge h) const
{
  return isFlat(mesh_.at(mesh_.origin(h)), mesh_.at(mesh_.destination(h)), mesh_.at(mesh_.apex(h)));
}

/// Does the edge remain an edge of the surface without the triangle of h, or is it no constraint?
bool Trimmer::mayLose(Mesh::Halfedge h) const
{
  if (!mesh_.isConstrained(h))
  {
    return true;
  }
  // A triangle that is flat over another edge may be dropped across that.
  const Mesh::Halfedge beyond = mesh_.twin(h);
  return !mesh_.isGhost(Mesh::slotOf(beyond)) && !isDropped(beyond) &&
    !isFlatAt(Mesh::next(beyond)) && !isFlatAt(Mesh::previous(beyond));
}

bool Trimmer::mayGo(Mesh::Halfedge h) const
{
  return isFlatAt(h) && !mesh_.isConstrained(h) && mayLose(Mesh::next(h)) &&
    mayLose(Mesh::previous(h));
}

/// The triangle beyond the half-edge is not part of the surface.
void Trimmer::dropAcross(Mesh::Halfedge h)
{
  const Mesh::Slot slot = Mesh::slotOf(h);
  if (mesh_.isGhost(slot) || isDropped(h) || !mayGo(h))
  {
    return;
  }
  mesh_.marks(slot) |= kDropped;
  dropped_.push_back(slot);
  const std::uint32_t* const v = mesh_.data() + slot;
  droppedArea_ += doubledArea(mesh_.at(v[0]), mesh_.at(v[1]), mesh_.at(v[2]));
}

/// The last one.
bool Trimmer::findGhost(Mesh::Slot& slot)
{
  for (slot = Mesh::slotOfTriangle(mesh_.triangles() - 1); !mesh_.isGhost(slot);
       slot -= Mesh::kSlotSize)
  {
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

bool Trimmer::dropAlongHull()
{
  Mesh::Slot slot = 0;
  if (!findGhost(slot))
  {
    return false;
  }
  const Mesh::Halfedge first = mesh_.outgoing(slot, mesh_.ghost());
  const Point& corner = mesh_.at(mesh_.destination(first));
  Mesh::Halfedge spoke = first;
  do
  {
    const Mesh::Halfedge inner = mesh_.twin(Mesh::next(spoke));
    hullArea_ += doubledArea(
      mesh_.at(mesh_.origin(inner)), mesh_.at(mesh_.destination(inner)), corner);
    dropAcross(inner);
    spoke = mesh_.nextAround(spoke);
    if (!ticker_.step())
    {
      return false;
    }
  } while (spoke != first);
  return true;
}

bool Trimmer::dropInwards()
{
  for (std::size_t i = 0; i < dropped_.size(); ++i)
  {
    const Mesh::Slot slot = dropped_[i];
    for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
    {
      dropAcross(mesh_.twin(h));
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

bool Trimmer::countBare(std::size_t& bare)
{
  Buffer<std::uint8_t> seen;
  seen.allocate(std::size_t(mesh_.ghost()) + 1);
  if (!fillAll(seen, std::uint8_t(0), ticker_))
  {
    return false;
  }
  for (const Mesh::Slot slot : dropped_)
  {
    for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
    {
      const Index vertex = mesh_.apex(h);
      bool isBare = false;
      if (seen[vertex] == 0 && !turnAround(Mesh::previous(h), isBare))
      {
        return false;
      }
      seen[vertex] = 1;
      bare += isBare ? 1 : 0;
    }
  }
  return true;
}

/// Around the vertex from which the half-edge runs: is none of its triangles left?
bool Trimmer::turnAround(Mesh::Halfedge first, bool& isBare)
{
  Mesh::Halfedge h = first;
  do
  {
    if (!ticker_.step())
    {
      return false;
    }
    if (!isDropped(h) && !mesh_.isGhost(Mesh::slotOf(h)))
    {
      return true;
    }
    h = mesh_.nextAround(h);
  } while (h != first);
  isBare = true;
  return true;
}

} // namespace

bool trimRim(ConstrainedMesh& mesh, Ticker& ticker, TrimmedRim& out)
{
  return Trimmer(mesh, ticker).run(out);
}

} // namespace ahd
