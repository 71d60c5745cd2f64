// SPDX-License-Identifier: BSD-3-Clause
#include "LivingMesh.h"

#include "../Predicates/Filters.h"
#include "../Predicates/Predicates.h"

#include <algorithm>

namespace ahd
{

void LivingMesh::clear()
{
  places_.assign(1, Point{ 0.0, 0.0 });
  slotOfVertex_.assign(1, kNoIndex);
  starAt_.assign(1, kNoIndex);
  data_.clear();
  freeSlots_.clear();
  freeVertices_.clear();
  suspects_.clear();
}

void LivingMesh::reserve(std::size_t vertexCount)
{
  places_.reserve(vertexCount + 1);
  slotOfVertex_.reserve(vertexCount + 1);
  starAt_.reserve(vertexCount + 1);
  data_.reserve(Mesh::bytesFor(vertexCount + 2) / sizeof(std::uint32_t));
}

void LivingMesh::begin(const Point& a, const Point& b, const Point& c)
{
  const bool isCcw = orient2d(a, b, c) > 0;
  for (const Point& p : { a, isCcw ? b : c, isCcw ? c : b })
  {
    newVertex(p);
  }
  const Slot t = newSlot();
  set(t, 1, 2, 3);
  const Slot ghosts[] = { newSlot(), newSlot(), newSlot() };
  set(ghosts[0], kGhost, 3, 2);
  set(ghosts[1], kGhost, 1, 3);
  set(ghosts[2], kGhost, 2, 1);
  for (Slot e = 0; e < 3; ++e)
  {
    link(t + e, ghosts[e]);
    link(ghosts[e] + 1, ghosts[(e + 2) % 3] + 2);
  }
}

LivingMesh::Vertex LivingMesh::newVertex(const Point& p)
{
  if (!freeVertices_.empty())
  {
    const Vertex v = freeVertices_.back();
    freeVertices_.pop_back();
    places_[v] = p;
    return v;
  }
  places_.push_back(p);
  slotOfVertex_.push_back(kNoIndex);
  starAt_.push_back(kNoIndex);
  return static_cast<Vertex>(places_.size() - 1);
}

LivingMesh::Slot LivingMesh::newSlot()
{
  if (!freeSlots_.empty())
  {
    const Slot s = freeSlots_.back();
    freeSlots_.pop_back();
    return s;
  }
  const Slot s = end();
  data_.resize(data_.size() + Mesh::kSlotSize);
  return s;
}

/// The triangle, without constraints; its neighbours remain to be linked.
void LivingMesh::set(Slot s, Vertex a, Vertex b, Vertex c)
{
  data_[s] = a;
  data_[s + 1] = b;
  data_[s + 2] = c;
  data_[s + kFlags] = 0;
  slotOfVertex_[a] = slotOfVertex_[b] = slotOfVertex_[c] = s;
}

void LivingMesh::free(Slot s)
{
  data_[s] = kNoIndex;
  freeSlots_.push_back(s);
}

/// Of one side.
void LivingMesh::setConstraint(Halfedge h, bool is)
{
  std::uint32_t& flags = data_[Mesh::slotOf(h) + kFlags];
  const std::uint32_t bit = 1u << (h & 3);
  flags = is ? flags | bit : flags & ~bit;
}

LivingMesh::Halfedge LivingMesh::leaving(Vertex v) const
{
  const Slot s = slotOfVertex_[v];
  return s == kNoIndex  ? kNoIndex
    : data_[s] == v     ? s + 2 // the edge before the corner's own leaves it
    : data_[s + 1] == v ? s
                        : s + 1;
}

LivingMesh::Halfedge LivingMesh::edge(Vertex a, Vertex b) const
{
  const Halfedge ofA = leaving(a), ofB = leaving(b);
  if (ofA == kNoIndex || ofB == kNoIndex)
  {
    return kNoIndex;
  }
  Halfedge h = ofA, g = ofB; // around both, as one of them may have many neighbours
  do
  {
    if (target(h) == b)
    {
      return h;
    }
    if (target(g) == a)
    {
      return twin(g);
    }
    h = around(h);
    g = around(g);
  } while (h != ofA && g != ofB);
  return kNoIndex;
}

int LivingMesh::side(Vertex a, Vertex b, const Point& p) const
{
  return orient2d(places_[a], places_[b], p);
}

namespace
{

/// Where a walk looks first: a walk that always tries the same edge first may go round in circles
/// in a constrained triangulation; one that draws it ends with certainty.
class Draws
{
public:
  std::uint32_t edge()
  {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_ % 3;
  }

private:
  std::uint32_t state_ = 2463534242u;
};

} // namespace

/// On which side of the edge opposite to each corner the place lies: the sign of orient2d.
class LivingMesh::Sides
{
public:
  Sides(const LivingMesh& mesh, Slot s, const Point& p)
    : mesh_(mesh)
    , slot_(s)
    , p_(p)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point& corner = mesh.places_[mesh.data_[s + k]];
      x_[k] = corner.x - p.x;
      y_[k] = corner.y - p.y;
      squared_[k] = squaredLength(x_[k], y_[k]);
    }
  }

  int operator()(Halfedge h) const
  {
    const std::size_t a = Mesh::next(h) & 3, b = Mesh::previous(h) & 3;
    const double turn = x_[a] * y_[b] - y_[a] * x_[b];
    return orientIsCertain(turn, squared_[a], squared_[b])
      ? (turn > 0.0 ? 1 : -1)
      : mesh_.side(mesh_.data_[slot_ + a], mesh_.data_[slot_ + b], p_);
  }

private:
  const LivingMesh& mesh_;
  Slot slot_;
  const Point& p_;
  double x_[3], y_[3], squared_[3]; ///< of the corners, from the place; their distances
};

LivingMesh::Spot LivingMesh::locate(const Point& p, Slot hint) const
{
  Draws draws;
  Slot s = hint;
  for (Halfedge e = 0; isGhost(s) && e < 3; ++e)
  {
    s = data_[hint + e] == kGhost ? Mesh::slotOf(twin(hint + e)) : s;
  }
  Halfedge from = kNoIndex;
  for (;;)
  {
    const Sides sideOf(*this, s, p);
    Halfedge zero = kNoIndex, out = kNoIndex, h = s + draws.edge();
    for (int k = 0; k < 3 && out == kNoIndex; ++k, h = Mesh::next(h))
    {
      const int sign = h == from ? 1 : sideOf(h);
      out = sign < 0 ? h : kNoIndex;
      if (sign == 0 && zero != kNoIndex) // on two edges: their common end
      {
        return { Kind::AtVertex, Mesh::next(zero) == h ? Mesh::previous(zero) : Mesh::next(zero) };
      }
      zero = sign == 0 ? h : zero;
    }
    if (out == kNoIndex)
    {
      return zero == kNoIndex ? Spot{ Kind::Inside, s } : Spot{ Kind::OnEdge, zero };
    }
    from = twin(out);
    s = Mesh::slotOf(from);
    if (isGhost(s))
    {
      return { Kind::Outside, s };
    }
  }
}

/// May the edge be replaced by the other diagonal of the quadrilateral around it?
bool LivingMesh::canFlip(Halfedge h) const
{
  const Vertex a = apex(h), b = origin(h), c = target(h), d = apex(twin(h));
  return a != kGhost && b != kGhost && c != kGhost && d != kGhost && side(a, b, places_[d]) > 0 &&
    side(a, d, places_[c]) > 0;
}

/// (a, b, c) and (d, c, b) become (a, b, d) and (d, c, a). Returns the half-edge d to a of the
/// first, opposite to b.
LivingMesh::Halfedge LivingMesh::flip(Halfedge h)
{
  const Halfedge g = twin(h);
  const Slot t = Mesh::slotOf(h), u = Mesh::slotOf(g);
  const Vertex a = apex(h), b = origin(h), c = target(h), d = apex(g);
  const Halfedge ab = twin(Mesh::previous(h)), ca = twin(Mesh::next(h));
  const Halfedge dc = twin(Mesh::previous(g)), bd = twin(Mesh::next(g));
  const bool isAb = isConstraint(Mesh::previous(h)), isCa = isConstraint(Mesh::next(h));
  const bool isDc = isConstraint(Mesh::previous(g)), isBd = isConstraint(Mesh::next(g));
  set(t, a, b, d);
  set(u, d, c, a);
  join(t + 2, ab, isAb);
  join(t, bd, isBd);
  join(u + 2, dc, isDc);
  join(u, ca, isCa);
  link(t + 1, u + 1);
  return t + 1;
}

/// Flips what is not Delaunay, among the suspects and whatever that makes suspect. `flipped` gets
/// the slots.
void LivingMesh::makeDelaunay(std::vector<Edge>& suspects, std::vector<Slot>* flipped)
{
  while (!suspects.empty())
  {
    const Edge suspect = suspects.back();
    suspects.pop_back();
    const Halfedge h = edge(suspect.first, suspect.second);
    if (h == kNoIndex || isConstraint(h))
    {
      continue;
    }
    const Vertex a = apex(h), b = origin(h), c = target(h), d = apex(twin(h));
    if (a != kGhost && d != kGhost && b != kGhost && c != kGhost &&
      inConflict(places_[a], places_[b], places_[c], places_[d]))
    {
      if (flipped)
      {
        flipped->insert(flipped->end(), { Mesh::slotOf(h), Mesh::slotOf(twin(h)) });
      }
      flip(h);
      suspects.insert(suspects.end(), { { a, b }, { c, a }, { b, d }, { d, c } });
    }
  }
}

} // namespace ahd
