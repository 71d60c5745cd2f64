// SPDX-License-Identifier: BSD-3-Clause
#include "Cavity.h"

#include "../Predicates/Filters.h"
#include "../Predicates/Predicates.h"

namespace ahd
{

namespace
{

/// Is p inside of the circle of a, b, c, which turn counterclockwise? Exact.
bool isInCircle(const Point& a, const Point& b, const Point& c, const Point& p)
{
  const Lifted A = liftedFrom(p, a), B = liftedFrom(p, b), C = liftedFrom(p, c);
  const double determinant = inCircleDeterminant(A, B, C, cross(A, B));
  if (inCircleIsCertain(determinant, A.z, B.z, C.z, inCircleGuard(A.z + B.z + C.z)))
  {
    return determinant > 0.0;
  }
  return inCircleExact(a, b, c, p) > 0;
}

/// What an edge counts: an in-circle test, which may be an exact one.
constexpr std::size_t kStepsOfEdge = 4;

} // namespace

bool Cavity::find(
  const SampledSurface& surface, std::size_t triangle, const Point& place, Ticker& ticker)
{
  const Tables& tables = *surface.tables;
  triangle_ = triangle;
  steps_.clear();
  vertices_.clear();
  const HalfEdge first = static_cast<HalfEdge>(3 * triangle);
  stack_.assign({ first + 2, first + 1, first });
  while (!stack_.empty())
  {
    const HalfEdge h = stack_.back();
    stack_.pop_back();
    if (h == kNoHalfEdge)
    {
      steps_.push_back({ Step::Leave, h });
      continue;
    }
    if (!ticker.step(kStepsOfEdge))
    {
      return false;
    }
    if (isCrossable(surface, h))
    {
      const HalfEdge twin = tables.twins[h];
      const Index* const v = tables.corners.data() + twin / 3 * 3;
      if (isInCircle(surface.at(v[0]), surface.at(v[1]), surface.at(v[2]), place))
      {
        steps_.push_back({ Step::Enter, h });
        stack_.insert(
          stack_.end(), { kNoHalfEdge, previousInTriangle(twin), nextInTriangle(twin) });
        continue;
      }
    }
    steps_.push_back({ Step::Border, h });
    vertices_.push_back(tables.origin(h));
  }
  return true;
}

} // namespace ahd
