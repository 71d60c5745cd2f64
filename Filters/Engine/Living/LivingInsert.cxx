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
  const bool splits = spot.kind == Kind::OnEdge && isConstraint(spot.at);
  const Edge split = splits ? Edge{ origin(spot.at), target(spot.at) } : Edge{ kNoIndex, kNoIndex };
  findCavity(p, spot);
  findRim(spot);
  const Vertex v = newVertex(p);
  makeStar(v, split);
  return v;
}

} // namespace ahd
