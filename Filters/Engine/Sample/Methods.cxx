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

Weights RimWeights::at(const Spot& spot, const Point& place)
{
  return spot.kind == Spot::OnEdge ? onEdge(spot.halfEdge, place)
    : spot.kind == Spot::OnVertex  ? onVertex(spot.halfEdge)
                                   : Weights();
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
    found = rim_.at(spot, place);
    return true;
  }
  triangleWeights(surface_, spot.halfEdge, place, weights_);
  found = { surface_.tables->corners.data() + spot.halfEdge, weights_, 3, spot.halfEdge };
  return true;
}

bool LineMethod::weightsAt(const Point& place, Ticker& ticker, Weights& found)
{
  found = Weights();
  found.count = line_->neighborsOf(place, vertices_);
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
  if (!tree_->findNearest(place, last_, ticker, last_))
  {
    return false;
  }
  vertex_ = tree_->vertex(last_);
  found = { &vertex_, &weight_, 1 };
  return true;
}

} // namespace ahd
