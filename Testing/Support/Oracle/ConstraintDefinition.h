// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_ConstraintDefinition_h
#define ahd_ConstraintDefinition_h

#include "ConstraintOracle.h"
#include "ExactSigns.h"
#include "ExactVectors.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ahd
{
namespace test
{

/// A segment between two vertices, as given.
struct Accepted
{
  std::int32_t from, to;
  std::size_t chain, segment;
  bool ofLoop;
};

/// The parts of constrainedByDefinition(), for its own source files.
class Definition
{
public:
  Definition(const PointView& points, const ConstraintView& constraints)
    : points_(points)
    , constraints_(constraints)
    , vertexOf_(verticesOf(points))
  {
    for (std::int32_t id = 0; std::size_t(id) < points.count; ++id)
    {
      if (vertexOf_[std::size_t(id)] == id)
      {
        vertices_.push_back(id);
      }
    }
  }

  ConstrainedByDefinition make(FillRule rule)
  {
    if (isFlat())
    {
      refuse();
      return result_;
    }
    accept();
    triangulate();
    collectEdges();
    fill(rule);
    number();
    return result_;
  }

private:
  using Corners = std::array<std::int32_t, 3>;

  bool isFlat() const;
  void refuse();
  void accept();
  bool cross(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) const;
  const Accepted* firstCrossed(std::int32_t from, std::int32_t to) const;
  void triangulate();
  bool isTriangle(const Corners& t);
  bool isPassedThrough(const Corners& t) const;
  bool canSee(std::int32_t v, const Corners& t);
  const std::vector<Vector>& directions(std::int32_t v);
  bool seesAlong(std::int32_t v, const Vector& d, const Corners& t) const;
  bool lies(std::int32_t v, std::int32_t from, std::int32_t to) const;
  void collectEdges();
  void fill(FillRule rule);
  void fillByOrientation(const std::vector<Accepted>& loops);
  void fillEvenOdd(const std::vector<Accepted>& loops);
  std::vector<Accepted> withoutRepeated(const std::vector<Accepted>& loops) const;
  bool isInsideOdd(const std::vector<Accepted>& loops, const Triple& t) const;
  void number();
  std::map<Triple, int> regionsOf(
    const std::set<Triple>& triples, const std::set<EdgeIds>& borders) const;

  Point at(std::int32_t v) const { return points_[std::size_t(v)]; }
  int orient(std::int32_t a, std::int32_t b, std::int32_t c) const
  {
    return orientSign(at(a), at(b), at(c));
  }

  const PointView& points_;
  const ConstraintView& constraints_;
  std::vector<std::int32_t> vertexOf_;
  std::vector<std::int32_t> vertices_;
  std::vector<Accepted> accepted_;
  std::set<std::size_t> brokenLoops_;
  std::map<std::int32_t, std::vector<Vector>> directions_;
  ConstrainedByDefinition result_;
};

} // namespace test
} // namespace ahd

#endif
