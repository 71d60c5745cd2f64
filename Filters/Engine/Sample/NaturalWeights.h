// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_NaturalWeights_h
#define ahd_NaturalWeights_h

#include "../Arithmetic/DoubleDouble.h"
#include "Cavity.h"
#include "Methods.h"
#include "WideWeights.h"

#include <vector>

namespace ahd
{

/// The weights of the vertices around a cavity, in doubles or in doubles of 106 bits.
///
/// Each vertex v of the border gives the part of its Voronoi cell that is nearer to the place p.
/// Its corners are the centres of the triangles of the cavity that have v, and, at both ends, those
/// of p with the edges of the border at v. All of its corners turn left: so it is convex, and its
/// area is not negative. The sum of the areas is that of the cell of p. Everything is seen from p.
template <typename Number>
class NaturalWeights
{
public:
  /// Puts weights that sum to 1 into `weights`, one for each vertex of the cavity. `scale`: a power
  /// of two. Returns false if cancelled; throws std::bad_alloc.
  bool compute(const SampledSurface& surface, const Cavity& cavity, const Point& place,
    double scale, bool isLaplace, Ticker& ticker, std::vector<double>& weights);

  /// If not, the last weights may be wrong by more than some 2^-40, and are not to be used.
  bool areGood() const;

private:
  struct Vector
  {
    Number x, y;
  };

  Vector seen(Index vertex) const;
  Vector centreOf(std::size_t triangle);
  Vector centreOf(const Vector& a, const Vector& b);
  Vector noted(const Vector& numerators, const Number& divisor, double size, double sides);
  void go(const Cavity::Step& step);
  bool goAround(const Cavity& cavity, Ticker& ticker);
  double length(std::size_t k) const;
  bool finish(std::vector<double>& weights, Ticker& ticker);

  const SampledSurface* surface_ = nullptr;
  Point place_{ 0.0, 0.0 };
  double scale_ = 1.0;
  bool isLaplace_ = false;
  double flatness_ = 0.0;       ///< the most that sides are over their product, squared
  double size_ = 0.0;           ///< the largest squared length, of vertices and centres
  double nearest_ = 0.0;        ///< the least one of a vertex
  double sum_ = 0.0;            ///< that weights had before they were divided by it
  std::vector<Number> areas_;   ///< of each vertex, twice; and of the first once more
  std::vector<Vector> rim_;     ///< centres of the triangles of p with the edges of the border
  std::vector<Vector> centres_; ///< of the triangles that were entered and not left
  std::vector<Number> crossed_; ///< what the ends of the edges give and take
  std::vector<double> lengths_; ///< Laplace: squared, of the vertices
};

/// SampleMethod::NaturalNeighbor and Laplace in triangles.
class NaturalMethod
{
public:
  /// @pre triangles.
  NaturalMethod(const SampledSurface& surface, const RimTree& rim, bool isLaplace)
    : surface_(surface)
    , rimTree_(&rim)
    , isLaplace_(isLaplace)
    , finder_(surface)
    , rim_(surface)
  {
  }

  bool weightsAt(const Point& place, Ticker& ticker, Weights& found);

private:
  bool weightsInside(const Spot& spot, const Point& place, Ticker& ticker, Weights& found);
  bool weightsWithCare(const Point& place, Ticker& ticker);
  bool findScale(const Point& place, Ticker& ticker, double& scale) const;

  SampledSurface surface_;
  const RimTree* rimTree_;
  bool isLaplace_;
  SpotFinder finder_;
  RimWeights rim_;
  Cavity cavity_;
  NaturalWeights<double> quick_;
  NaturalWeights<DoubleDouble> careful_;
  WideWeights wide_;
  std::vector<double> weights_;
};

} // namespace ahd

#endif
