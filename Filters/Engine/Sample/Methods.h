// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Methods_h
#define ahd_Methods_h

#include "RimTree.h"
#include "Spots.h"
#include "VertexLine.h"
#include "VertexTree.h"
#include "Weights.h"

namespace ahd
{

// Each finds the weights at one place after the other, from where the last one was. Weights are
// those of the last call until the next one. weightsAt() returns false if cancelled; the natural
// neighbours' throws std::bad_alloc. @pre finite places.

/// The weights of a place on an edge or vertex, by any method that is linear along edges.
class RimWeights
{
public:
  explicit RimWeights(const SampledSurface& surface)
    : surface_(surface)
  {
  }

  Weights onEdge(HalfEdge h, const Point& place);
  Weights onVertex(HalfEdge h);
  /// Of a spot that is in no triangle: on an edge or a vertex, or outside by no more than rounding.
  /// Returns false if cancelled, as all below.
  bool at(const Spot& spot, const Point& place, const RimTree& rim, Ticker& ticker, Weights& found);
  /// Of the place of the rim that is nearest to this one.
  bool nearestTo(const Point& place, const RimPlace& rim, Ticker& ticker, Weights& found);

private:
  SampledSurface surface_;
  Index vertices_[2];
  double weights_[2];
};

/// SampleMethod::Linear in triangles.
class LinearMethod
{
public:
  /// @pre triangles.
  LinearMethod(const SampledSurface& surface, const RimTree& rim)
    : surface_(surface)
    , rimTree_(&rim)
    , finder_(surface)
    , rim_(surface)
  {
  }

  bool weightsAt(const Point& place, Ticker& ticker, Weights& found);

private:
  SampledSurface surface_;
  const RimTree* rimTree_;
  SpotFinder finder_;
  RimWeights rim_;
  double weights_[3];
};

/// The weights of the corners of a triangle at a place in it.
inline void triangleWeights(
  const SampledSurface& surface, HalfEdge first, const Point& place, double (&weights)[3])
{
  const Index* const v = surface.tables->corners.data() + first;
  const Point a = surface.at(v[0]), b = surface.at(v[1]), c = surface.at(v[2]);
  isEasy(a, b, c) ? easyWeights(a, b, c, place, weights) : hardWeights(a, b, c, place, weights);
}

/// All methods but Nearest where all vertices are collinear.
class LineMethod
{
public:
  LineMethod(const VertexLine& line, const RimTree& rim)
    : line_(&line)
    , rimTree_(&rim)
  {
  }

  bool weightsAt(const Point& place, Ticker& ticker, Weights& found);
  /// Of the place of the line that is nearest to this one.
  void nearestTo(const Point& place, const RimPlace& rim, Weights& found);

private:
  void findEnds(Weights& found) const;

  const VertexLine* line_;
  const RimTree* rimTree_;
  Index vertices_[2];
  double weights_[2];
};

/// SampleMethod::Nearest.
class NearestMethod
{
public:
  /// @pre the tree is not empty.
  NearestMethod(const VertexTree& tree, const RimTree& walls)
    : tree_(&tree)
    , walls_(&walls)
  {
  }

  bool weightsAt(const Point& place, Ticker& ticker, Weights& found);

private:
  const VertexTree* tree_;
  const RimTree* walls_;
  std::size_t last_ = 0;
  Index vertex_;
  double weight_ = 1.0;
};

/// At places outside the surface, the values of the place of it that is nearest.
class BoundaryMethod
{
public:
  /// @pre triangles, or a line.
  BoundaryMethod(const SampledSurface& surface, const VertexLine& line, const RimTree& rim)
    : rimTree_(&rim)
    , isLine_(surface.tables->triangles() == 0)
    , rim_(surface)
    , line_(line, rim)
  {
  }

  bool weightsAt(const Point& place, Ticker& ticker, Weights& found);

private:
  const RimTree* rimTree_;
  bool isLine_;
  std::size_t last_ = 0;
  RimWeights rim_;
  LineMethod line_;
};

/// No method: there are no vertices.
class NoMethod
{
public:
  bool weightsAt(const Point&, Ticker& ticker, Weights& found)
  {
    found = Weights();
    return ticker.step();
  }
};

} // namespace ahd

#endif
