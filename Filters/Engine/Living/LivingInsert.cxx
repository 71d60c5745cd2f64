// SPDX-License-Identifier: BSD-3-Clause
#include "LivingMesh.h"

#include "../Predicates/Predicates.h"

namespace ahd
{

/// Must the triangle go when p comes? A ghost must if p lies beyond its hull edge, or on it.
bool LivingMesh::conflicts(Slot s, const Point& p) const
{
  const Vertex* const v = &data_[s];
  for (std::uint32_t e = 0; e < 3; ++e)
  {
    if (v[e] == kGhost)
    {
      const Point &a = places_[v[(e + 1) % 3]], &b = places_[v[(e + 2) % 3]];
      const int sign = orient2d(a, b, p);
      return sign > 0 || (sign == 0 && lexicographicallyLess(a, p) == lexicographicallyLess(p, b));
    }
  }
  return inConflict(places_[v[0]], places_[v[1]], places_[v[2]], p);
}

void LivingMesh::mark(Slot s)
{
  data_[s + kFlags] |= kMarked;
  cavity_.push_back(s);
}

/// The triangles in conflict with p that p sees, marked: no constraint lies between.
void LivingMesh::findCavity(const Point& p, const Spot& spot)
{
  cavity_.clear();
  mark(Mesh::slotOf(spot.at));
  if (spot.kind == Kind::OnEdge)
  {
    mark(Mesh::slotOf(twin(spot.at)));
  }
  for (std::size_t k = 0; k < cavity_.size(); ++k)
  {
    const Slot s = cavity_[k];
    for (std::uint32_t e = 0; e < 3; ++e)
    {
      const Slot beyond = Mesh::slotOf(twin(s + e));
      if ((data_[beyond + kFlags] & kMarked) == 0 && !isConstraint(s + e) && conflicts(beyond, p))
      {
        mark(beyond);
      }
    }
  }
}

/// The cavity's border; constraints inside of it are part of it, from both sides, but for the one
/// that is split.
void LivingMesh::findRim(const Spot& spot)
{
  rim_.clear();
  const Halfedge split = spot.kind == Kind::OnEdge ? spot.at : kNoIndex;
  for (const Slot s : cavity_)
  {
    for (Halfedge h = s; h < s + 3; ++h)
    {
      const bool isSplit = split != kNoIndex && (h == split || h == twin(split));
      const bool isBorder = (data_[Mesh::slotOf(twin(h)) + kFlags] & kMarked) == 0;
      if (isBorder || (isConstraint(h) && !isSplit))
      {
        rim_.push_back({ origin(h), target(h), twin(h), isConstraint(h) });
      }
    }
  }
}

/// Fills the cavity with triangles around v. `split`: the ends of a constraint that it splits.
void LivingMesh::makeStar(Vertex v, const Edge& split)
{
  star_.clear();
  for (std::size_t k = 0; k < rim_.size(); ++k)
  {
    const RimEdge& edge = rim_[k];
    const Slot s = k < cavity_.size() ? cavity_[k] : newSlot();
    set(s, v, edge.from, edge.to);
    join(s, edge.outside, edge.isConstraint);
    star_.push_back(s);
    starAt_[edge.from] = s;
  }
  for (const Slot s : star_)
  {
    const Vertex to = data_[s + 2];
    const Slot after = starAt_[to];
    link(s + 1, after + 2);
    if (to == split.first || to == split.second)
    {
      setConstraint(s + 1, true);
      setConstraint(after + 2, true);
    }
  }
}

LivingMesh::Vertex LivingMesh::insert(const Point& p, const Spot& spot)
{
  findCavity(p, spot);
  findRim(spot);
  return insertSeen(p, spot);
}

void LivingMesh::look(const Point& p, const Spot& spot)
{
  findCavity(p, spot);
  findRim(spot);
  for (const Slot s : cavity_)
  {
    data_[s + kFlags] &= ~kMarked;
  }
}

LivingMesh::Vertex LivingMesh::insertSeen(const Point& p, const Spot& spot)
{
  const bool splits = spot.kind == Kind::OnEdge && isConstraint(spot.at);
  const Edge ends = splits ? Edge{ origin(spot.at), target(spot.at) } : Edge{ kNoIndex, kNoIndex };
  const Vertex v = newVertex(p);
  makeStar(v, ends);
  return v;
}

/// Four triangles for two, whatever side of the edge the vertex is on; flips do the rest. They flip
/// the new edges across h, too: the vertex is only nearly on it, so the old triangle may remain.
LivingMesh::Vertex LivingMesh::split(Halfedge h, const Point& p)
{
  const Halfedge g = twin(h);
  const Vertex a = origin(h), b = target(h), c = apex(h), d = apex(g);
  const bool is = isConstraint(h);
  const Halfedge sides[] = { Mesh::previous(h), Mesh::next(h), Mesh::next(g), Mesh::previous(g) };
  RimEdge rim[4]; // c to a, b to c, a to d, d to b
  for (int k = 0; k < 4; ++k)
  {
    rim[k] = { origin(sides[k]), target(sides[k]), twin(sides[k]), isConstraint(sides[k]) };
  }
  const Slot t = Mesh::slotOf(h), u = Mesh::slotOf(g), left = newSlot(), right = newSlot();
  const Vertex v = newVertex(p);
  star_ = { t, left, u, right };
  for (int k = 0; k < 4; ++k)
  {
    set(star_[std::size_t(k)], v, rim[k].from, rim[k].to);
    join(star_[std::size_t(k)], rim[k].outside, rim[k].isConstraint);
  }
  link(t + 2, left + 1);  // v to c
  link(t + 1, u + 2);     // a to v
  link(u + 1, right + 2); // d to v
  link(left + 2, right + 1);
  for (const Halfedge e : { t + 1, u + 2, left + 2, right + 1 })
  {
    setConstraint(e, is);
  }
  std::vector<Edge> suspects{ { c, a }, { b, c }, { a, d }, { d, b }, { v, c }, { v, d } };
  makeDelaunay(suspects, &star_);
  return v;
}

} // namespace ahd
