// SPDX-License-Identifier: BSD-3-Clause
#include "Methods.h"

namespace ahd
{

Weights RimWeights::onEdge(HalfEdge h, const Point& place)
{
  const Tables& tables = *surface_.tables;
  vertices_[0] = tables.origin(h);
  vertices_[1] = tables.target(h);
  edgeWeights(surface_.at(vertices_[0]), surface_.at(vertices_[1]), place, weights_);
  return { vertices_, weights_, 2, h };
}

Weights RimWeights::onVertex(HalfEdge h)
{
  vertices_[0] = surface_.tables->origin(h);
  weights_[0] = 1.0;
  return { vertices_, weights_, 1, h };
}

bool RimWeights::at(
  const Spot& spot, const Point& place, const RimTree& rim, Ticker& ticker, Weights& found)
{
  if (spot.kind == Spot::Outside)
  {
    RimPlace nearest;
    return rim.findWithinRounding(place, ticker, nearest) &&
      nearestTo(place, nearest, ticker, found);
  }
  found = spot.kind == Spot::OnEdge ? onEdge(spot.halfEdge, place) : onVertex(spot.halfEdge);
  return true;
}

bool RimWeights::nearestTo(const Point& place, const RimPlace& rim, Ticker& ticker, Weights& found)
{
  found = Weights();
  if (!rim.is)
  {
    return true;
  }
  vertices_[0] = surface_.tables->origin(rim.edge);
  vertices_[1] = surface_.tables->target(rim.edge);
  const Point a = surface_.at(vertices_[0]), b = surface_.at(vertices_[1]);
  if (rim.part == NearestPart::Inside)
  {
    footWeights(a, b, place, weights_);
    found = { vertices_, weights_, 2, rim.edge };
    return true;
  }
  const bool isFirst = a == (rim.part == NearestPart::Left ? rim.segment.left : rim.segment.right);
  Spot spot;
  const bool isDone = SpotOwner(surface_).ofVertex(vertices_[isFirst ? 0 : 1], ticker, spot);
  found = isDone ? onVertex(spot.halfEdge) : found;
  return isDone;
}

bool LinearMethod::weightsAt(const Point& place, Ticker& ticker, Weights& found)
{
  Spot spot;
  if (!finder_.find(place, ticker, spot))
  {
    return false;
  }
  if (spot.kind != Spot::InTriangle)
  {
    return rim_.at(spot, place, *rimTree_, ticker, found);
  }
  triangleWeights(surface_, spot.halfEdge, place, weights_);
  found = { surface_.tables->corners.data() + spot.halfEdge, weights_, 3, spot.halfEdge };
  return true;
}

bool LineMethod::weightsAt(const Point& place, Ticker& ticker, Weights& found)
{
  found = Weights();
  found.count = line_->neighborsOf(place, vertices_);
  if (found.count == 0)
  {
    RimPlace nearest;
    const bool isDone = rimTree_->findWithinRounding(place, ticker, nearest);
    nearestTo(place, nearest, found);
    return isDone;
  }
  found.vertices = vertices_;
  found.weights = weights_;
  weights_[0] = 1.0;
  if (found.count == 2)
  {
    edgeWeights(line_->at(vertices_[0]), line_->at(vertices_[1]), place, weights_);
  }
  findEnds(found);
  constexpr std::size_t kStepsOfSearch = 32;
  return ticker.step(kStepsOfSearch);
}

void LineMethod::nearestTo(const Point& place, const RimPlace& rim, Weights& found)
{
  found = Weights();
  if (!rim.is)
  {
    return;
  }
  vertices_[0] = line_->beginOf(rim.edge);
  vertices_[1] = line_->endOf(rim.edge);
  found.vertices = vertices_;
  found.weights = weights_;
  found.count = rim.part == NearestPart::Inside ? 2 : 1;
  weights_[0] = 1.0;
  if (rim.part == NearestPart::Inside)
  {
    footWeights(line_->at(vertices_[0]), line_->at(vertices_[1]), place, weights_);
  }
  else if (rim.part == NearestPart::Right)
  {
    vertices_[0] = vertices_[1];
  }
  findEnds(found);
}

/// At a vertex, the piece behind it; in front of the last one.
void LineMethod::findEnds(Weights& found) const
{
  if (found.count == 2)
  {
    found.ends[0] = vertices_[0];
    found.ends[1] = vertices_[1];
  }
  else if (found.count == 1)
  {
    line_->pieceAt(vertices_[0], found.ends);
  }
}

bool NearestMethod::weightsAt(const Point& place, Ticker& ticker, Weights& found)
{
  if (!tree_->findNearest(place, *walls_, last_, ticker, last_))
  {
    return false;
  }
  vertex_ = tree_->vertex(last_);
  found = { &vertex_, &weight_, 1 };
  return true;
}

bool BoundaryMethod::weightsAt(const Point& place, Ticker& ticker, Weights& found)
{
  RimPlace nearest;
  if (!rimTree_->findNearest(place, last_, ticker, nearest))
  {
    return false;
  }
  if (isLine_)
  {
    line_.nearestTo(place, nearest, found);
    return true;
  }
  return rim_.nearestTo(place, nearest, ticker, found);
}

} // namespace ahd
