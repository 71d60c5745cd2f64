// SPDX-License-Identifier: BSD-3-Clause
#include "Edit.h"

#include <algorithm>

namespace ahd
{

bool Edit::isEnd(Index id) const
{
  const auto at = ends_.lower_bound({ id, 0 });
  return at != ends_.end() && at->first == id;
}

/// Reads the ends of a segment.
Edit::Outcome Edit::ends(const std::int64_t* given, Segment& segment) const
{
  if (!has(given[0]) || !has(given[1]))
  {
    return Outcome::NoPoint;
  }
  segment = { Index(given[0]), Index(given[1]) };
  const Point &a = places_[segment.first], &b = places_[segment.second];
  return !isFinite(a) || !isFinite(b) ? Outcome::NotFinite
    : a == b                          ? Outcome::NoLength
                                      : Outcome::Done;
}

void Edit::usePieces(Vertex a, Vertex b)
{
  mesh_.findPieces(a, b, pieces_);
  for (const LivingMesh::Edge& piece : pieces_)
  {
    ++uses_[key(piece.first, piece.second)];
  }
}

Edit::Outcome Edit::constrainOne(const std::int64_t* given)
{
  Segment segment;
  const Outcome outcome = ends(given, segment);
  if (outcome != Outcome::Done || ends_.count(segment) > 0)
  {
    return outcome;
  }
  if (mesh_.vertexCount() > 0)
  {
    const Vertex a = vertexOf_[segment.first], b = vertexOf_[segment.second];
    if (!mesh_.constrain(a, b))
    {
      return Outcome::Crosses;
    }
    usePieces(a, b);
  }
  const auto added = ends_.insert(segment).first;
  try
  {
    ends_.insert({ segment.second, segment.first });
  }
  catch (...)
  {
    ends_.erase(added);
    throw;
  }
  return Outcome::Done;
}

Edit::Outcome Edit::releaseOne(const std::int64_t* given)
{
  Segment segment;
  const Outcome outcome = ends(given, segment);
  if (outcome == Outcome::NoPoint)
  {
    return outcome;
  }
  if (ends_.count(segment) == 0)
  {
    return Outcome::NoSegment;
  }
  if (mesh_.vertexCount() > 0)
  {
    mesh_.findPieces(vertexOf_[segment.first], vertexOf_[segment.second], pieces_);
    for (const LivingMesh::Edge& piece : pieces_)
    {
      const auto uses = uses_.find(key(piece.first, piece.second));
      if (--uses->second == 0)
      {
        uses_.erase(uses);
        mesh_.release(piece.first, piece.second);
      }
    }
  }
  ends_.erase(segment);
  ends_.erase({ segment.second, segment.first });
  return Outcome::Done;
}

/// The other ends of the constraint edges at the vertex.
std::vector<Edit::Vertex> Edit::constraintsAt(Vertex v) const
{
  std::vector<Vertex> found;
  const LivingMesh::Halfedge first = mesh_.leaving(v);
  LivingMesh::Halfedge h = first;
  do
  {
    if (mesh_.isConstraint(h))
    {
      found.push_back(mesh_.target(h));
    }
    h = mesh_.around(h);
  } while (h != first);
  return found;
}

/// The constraint edge from a to b has become two, at v.
void Edit::splitPiece(Vertex a, Vertex b, Vertex v)
{
  const Index uses = uses_[key(a, b)];
  uses_.erase(key(a, b));
  uses_[key(a, v)] = uses_[key(v, b)] = uses;
}

EditPlace Edit::locateOne(const Point& p) const
{
  EditPlace place;
  if (!isFinite(p) || mesh_.vertexCount() == 0)
  {
    return place;
  }
  const LivingMesh::Spot spot = mesh_.locate(p, hint(p));
  const auto idOf = [&](Vertex v) { return std::int64_t(idOf_[v]); };
  switch (spot.kind)
  {
    case LivingMesh::Kind::Inside:
      place.kind = Location::InTriangle;
      place.ids = { { idOf(mesh_.apex(spot.at)), idOf(mesh_.origin(spot.at)),
        idOf(mesh_.target(spot.at)) } };
      std::rotate(
        place.ids.begin(), std::min_element(place.ids.begin(), place.ids.end()), place.ids.end());
      break;
    case LivingMesh::Kind::OnEdge:
    {
      const std::int64_t a = idOf(mesh_.origin(spot.at)), b = idOf(mesh_.target(spot.at));
      place.kind = Location::OnEdge;
      place.ids = { { std::min(a, b), std::max(a, b), -1 } };
      break;
    }
    case LivingMesh::Kind::AtVertex:
      place.kind = Location::OnVertex;
      place.ids[0] = idOf(mesh_.apex(spot.at));
      break;
    case LivingMesh::Kind::Outside:
      place.kind = Location::Outside;
      break;
  }
  return place;
}

} // namespace ahd
