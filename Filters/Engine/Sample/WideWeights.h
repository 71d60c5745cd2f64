// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_WideWeights_h
#define ahd_WideWeights_h

#include "../Arithmetic/WideFloat.h"
#include "Cavity.h"

#include <vector>

namespace ahd
{

/// What NaturalWeights does, in numbers of as many digits as a place asks for: its weights are
/// right to 2^-40 for all finite coordinates.
///
/// Of digits there are four at first, then as many as the bound of the errors asks for. A centre
/// is computed again where the way around the cavity comes back to it, so that nothing but the
/// weights, with their exponents, and the way back is kept of each vertex.
class WideWeights
{
public:
  /// Puts weights that sum to 1 into `weights`, one for each vertex of the cavity. Returns false if
  /// cancelled; throws std::bad_alloc.
  bool compute(const SampledSurface& surface, const Cavity& cavity, const Point& place,
    bool isLaplace, Ticker& ticker, std::vector<double>& weights);

private:
  struct Vector
  {
    WideFloat x, y;
  };

  /// Numbers at work: too large for a stack.
  struct Work
  {
    WideArithmetic with;
    Vector corner[3];          ///< of the triangle at work
    WideFloat square;          ///< a squared length
    int lengths[3];            ///< bits of those of the corners
    Vector centre;             ///< of the triangle that the way around is in
    Vector other;              ///< of the one that it goes to
    Vector rim, before, first; ///< centres of triangles of the place: this, the last, the first
    WideFloat area;            ///< of the part of a vertex so far, twice
    WideFloat ofFirst;         ///< what that of the first vertex begins with
    WideFloat side;            ///< what the side at work gives
    WideFloat left, right, divisor;
  };

  bool goAround(const Cavity& cavity, Ticker& ticker, std::vector<double>& weights);
  void go(const Cavity& cavity, const Cavity::Step& step, std::vector<double>& weights);
  void passBorder(const Cavity& cavity, HalfEdge h, std::vector<double>& weights);
  void enter(std::size_t triangle);
  void leave();
  void finish(std::size_t k, Index vertex, std::vector<double>& weights);
  bool divide(std::vector<double>& weights, Ticker& ticker);

  void see(Index vertex, Vector& seen);
  void cross(const Vector& a, const Vector& b, WideFloat& result);
  void square(const Vector& a, WideFloat& result);
  void centreOf(std::size_t triangle, Vector& centre);
  void centreOfCorners(bool hasPlace, Vector& centre);
  void note(bool hasPlace, const Vector& centre, int divisor);
  int missingDigits(std::size_t steps) const;

  const SampledSurface* surface_ = nullptr;
  Point place_{ 0.0, 0.0 };
  bool isLaplace_ = false;
  int digits_ = 0;
  std::size_t triangle_ = 0;   ///< that the way around is in
  std::size_t count_ = 0;      ///< of the edges of the border that were passed
  bool isFlat_ = false;        ///< a triangle has no area, as far as these digits tell
  int flatness_ = 0;           ///< the most that sides are over their product, squared: its bits
  int size_ = 0;               ///< bits of the largest squared length, of vertices and centres
  int nearest_ = 0;            ///< bits of the least one of a vertex
  int sum_ = 0;                ///< bits of what weights were divided by
  std::vector<Work> work_;     ///< one, once it is asked for
  std::vector<int> exponents_; ///< of the weights, before they are divided
  std::vector<Index> way_;     ///< back: triangles that were entered from and not gone back to
};

} // namespace ahd

#endif
