// SPDX-License-Identifier: BSD-3-Clause
#include "Edit.h"

#include "../Core/Border.h"
#include "../Order/CurveOrder.h"
#include "../Predicates/Predicates.h"
#include "../Triangulate.h"

#include <algorithm>

namespace ahd
{

void Edit::forgetMesh()
{
  mesh_.clear();
  stacks_.clear();
  uses_.clear();
  line_.clear();
  hints_.clear();
  last_ = LivingMesh::kGhost;
}

/// After a change that ended in the middle, or left that to build().
Status Edit::makeReady(const Context& context)
{
  return isReady_ ? Status::Ok : build(context);
}

/// Makes the mesh, or the line, of the points and segments. Throws std::bad_alloc.
Status Edit::build(const Context& context)
{
  isReady_ = isOver_ = false;
  forgetMesh();
  PointView view(places_.empty() ? nullptr : &places_[0].x, places_.size(), 2);
  view.skip = gone_.data();
  Workspace workspace;
  Triangulation made;
  Status status = triangulate(view, Options(), workspace, context, made);
  const bool isLine = status == Status::Ok && made.report().triangles == 0;
  if (status == Status::Ok && !isLine)
  {
    status = made.makeNeighbors(context);
    status = status == Status::Ok ? made.makePointMap(context) : status;
  }
  if (status != Status::Ok)
  {
    return status;
  }
  isLine ? fillLine() : nameVertices(made);
  for (const Segment& segment : ends_)
  {
    if (!isLine && segment.first < segment.second)
    {
      mesh_.constrain(vertexOf_[segment.first], vertexOf_[segment.second]);
      usePieces(vertexOf_[segment.first], vertexOf_[segment.second]);
    }
  }
  isReady_ = true;
  return Status::Ok;
}

void Edit::nameVertices(const Triangulation& made)
{
  mesh_.begin(made, [] { return true; });
  idOf_.assign(made.vertexCount() + 1, kNoIndex);
  for (Index v = 0; v < made.vertexCount(); ++v)
  {
    idOf_[v + 1] = made.pointOf(v);
  }
  for (Index id = 0; id < places_.size(); ++id)
  {
    const Index v = made.vertexOf(id);
    vertexOf_[id] = v == kNoIndex ? LivingMesh::kGhost : v + 1;
    if (v != kNoIndex && made.pointOf(v) != id)
    {
      stacks_[v + 1].insert({ made.pointOf(v), id });
    }
  }
  renewHints();
}

void Edit::fillLine()
{
  for (Index id = 0; id < places_.size(); ++id)
  {
    vertexOf_[id] = LivingMesh::kGhost;
    if (gone_[id] == 0 && isFinite(places_[id]))
    {
      line_[places_[id]].insert(id);
    }
  }
}

/// Makes a triangle with two points of the line?
bool Edit::isOffLine(const Point& p) const
{
  return line_.size() > 1 && orient2d(line_.begin()->first, line_.rbegin()->first, p) != 0;
}

void Edit::renewHints()
{
  const Point& any = mesh_.place(1);
  Bounds bounds{ any.x, any.x, any.y, any.y };
  for (Vertex v = 1; v < idOf_.size(); ++v)
  {
    const Point& p = mesh_.place(v);
    bounds.xmin = std::min(bounds.xmin, p.x);
    bounds.xmax = std::max(bounds.xmax, p.x);
    bounds.ymin = std::min(bounds.ymin, p.y);
    bounds.ymax = std::max(bounds.ymax, p.y);
  }
  hints_.build(bounds, mesh_.vertexCount());
  for (Vertex v = 1; v < idOf_.size(); ++v)
  {
    if (mesh_.leaving(v) != kNoIndex)
    {
      hints_.put(mesh_.place(v), v);
    }
  }
}

/// A triangle to start from.
LivingMesh::Slot Edit::hint(const Point& p) const
{
  const auto isThere = [&](Vertex v) { return mesh_.leaving(v) != kNoIndex; };
  const Vertex v = hints_.near(p, isThere);
  return Mesh::slotOf(mesh_.leaving(v != kNoIndex ? v
      : isThere(last_)                            ? last_
                                                  : LivingMesh::kGhost));
}

/// The point has this vertex, too.
void Edit::join(Index id, Vertex v)
{
  std::set<Index>& stack = stacks_[v];
  stack.insert({ idOf_[v], id });
  idOf_[v] = *stack.begin();
  vertexOf_[id] = v;
}

/// Gives the point a vertex, or a place on the line, or leaves that to build().
void Edit::attach(Index id)
{
  const Point p = places_[id];
  if (!isFinite(p))
  {
    return;
  }
  if (mesh_.vertexCount() == 0)
  {
    isOver_ = isOver_ || isOffLine(p);
    line_[p].insert(id);
    return;
  }
  const LivingMesh::Spot spot = mesh_.locate(p, hint(p));
  if (spot.kind == LivingMesh::Kind::AtVertex)
  {
    join(id, mesh_.apex(spot.at));
    return;
  }
  const bool splits = spot.kind == LivingMesh::Kind::OnEdge && mesh_.isConstraint(spot.at);
  const Vertex a = mesh_.origin(spot.at), b = mesh_.target(spot.at);
  const Vertex v = mesh_.insert(p, spot);
  if (splits)
  {
    splitPiece(a, b, v);
  }
  idOf_.resize(std::max<std::size_t>(idOf_.size(), v + 1), kNoIndex);
  idOf_[v] = id;
  vertexOf_[id] = v;
  hints_.put(p, v);
  last_ = v;
  if (hints_.isDue(mesh_.vertexCount()))
  {
    renewHints();
  }
}

/// Removes the vertex of one point. The mesh goes with it where the others are on a line.
Edit::Outcome Edit::removeVertex(Vertex v)
{
  const std::vector<Vertex> ends = uses_.empty() ? std::vector<Vertex>() : constraintsAt(v);
  if (ends.size() > 2)
  {
    return Outcome::SegmentsMeet;
  }
  Index uses = 0;
  for (const Vertex end : ends)
  {
    uses = uses_[key(v, end)];
    uses_.erase(key(v, end));
    mesh_.release(v, end);
  }
  if (!mesh_.remove(v))
  {
    forgetMesh(); // the others are collinear
    isOver_ = true;
    return Outcome::Done;
  }
  if (!ends.empty())
  {
    mesh_.constrain(ends[0], ends[1]);
    uses_[key(ends[0], ends[1])] = uses;
  }
  return Outcome::Done;
}

/// Takes the point from its vertex or place on the line, and its id from it.
Edit::Outcome Edit::detach(Index id)
{
  if (isEnd(id))
  {
    return Outcome::EndOfSegment;
  }
  Outcome outcome = Outcome::Done;
  const Vertex v = vertexOf_[id];
  const auto stack = stacks_.find(v);
  if (mesh_.vertexCount() == 0)
  {
    const auto at = isFinite(places_[id]) ? line_.find(places_[id]) : line_.end();
    if (at != line_.end() && at->second.erase(id) > 0 && at->second.empty())
    {
      line_.erase(at);
    }
  }
  else if (stack != stacks_.end())
  {
    stack->second.erase(id);
    idOf_[v] = *stack->second.begin();
    if (stack->second.size() == 1)
    {
      stacks_.erase(stack);
    }
  }
  else if (v != LivingMesh::kGhost)
  {
    outcome = removeVertex(v);
  }
  if (outcome == Outcome::Done)
  {
    gone_[id] = 1;
    vertexOf_[id] = LivingMesh::kGhost;
    --present_;
  }
  return outcome;
}

/// All of them or none. Throws std::bad_alloc.
void Edit::append(const PointView& points)
{
  const std::size_t count = places_.size() + points.count;
  for (std::size_t k = 0; k < points.count; ++k)
  {
    places_.push_back(points[k]);
  }
  vertexOf_.resize(count, LivingMesh::kGhost);
  gone_.resize(count, 0);
  present_ += points.count;
}

/// As if the points from this one on had not come.
void Edit::takeBack(std::size_t first)
{
  isReady_ = false;
  places_.resize(first);
  vertexOf_.resize(first);
  gone_.resize(first);
  present_ = static_cast<std::size_t>(std::count(gone_.begin(), gone_.end(), 0));
}

Status Edit::insertEach(std::size_t first, const Context& context)
{
  Ticker ticker(context.progress, Phase::Insert, places_.size() - first, context.executor);
  const PointView view(&places_[0].x, places_.size(), 2);
  CurveOrder order;
  const bool isOne = view.count - first == 1;
  if (!isOne && !order.build(view, first, places_.size(), ticker))
  {
    return Status::Cancelled;
  }
  isReady_ = isOver_ = false;
  for (std::size_t k = 0; k < view.count - first; ++k)
  {
    const Index id = static_cast<Index>(isOne ? first : order[k]);
    attach(id);
    if (isOver_)
    {
      return build(context); // with all that follow, too
    }
    ticker.finished(1);
    if (!ticker.step())
    {
      return Status::Cancelled;
    }
  }
  isReady_ = true;
  return Status::Ok;
}

} // namespace ahd
