// SPDX-License-Identifier: BSD-3-Clause
#include "Locate.h"

#include "../Predicates/Predicates.h"
#include "State.h"

#include <algorithm>
#include <utility>

namespace ahd
{

namespace
{

/// The cost of a triangle on the way: two or three orientations, which may be exact ones.
constexpr std::size_t kStepsOfTriangle = 8;

/// A bit that looks random.
bool coin(std::size_t step)
{
  std::uint64_t bits = (step + 1) * 0x9E3779B97F4A7C15u;
  bits = (bits ^ bits >> 31) * 0xD6E8FEB86659FD93u;
  return bits >> 63 != 0;
}

} // namespace

int Locator::side(HalfEdge h, const Point& place) const
{
  return orient2d(places_[tables_.origin(h)], places_[tables_.target(h)], place);
}

/// One of the other two edges of the triangle that was entered across `entered`; kNoHalfEdge if the
/// place lies beyond neither.
HalfEdge Locator::edgeToCross(HalfEdge entered, const Point& place, std::size_t step) const
{
  HalfEdge first = nextInTriangle(entered), second = previousInTriangle(entered);
  if (coin(step))
  {
    std::swap(first, second);
  }
  return side(first, place) < 0 ? first : side(second, place) < 0 ? second : kNoHalfEdge;
}

/// @pre the place lies in the triangle or on its border.
Location Locator::inTriangle(std::size_t triangle, const Point& place) const
{
  const HalfEdge first = static_cast<HalfEdge>(3 * triangle);
  for (HalfEdge h = first; h != first + 3; ++h)
  {
    if (places_[tables_.origin(h)] == place)
    {
      return { Location::OnVertex, tables_.starts[tables_.origin(h)] };
    }
  }
  for (HalfEdge h = first; h != first + 3; ++h)
  {
    if (side(h, place) == 0)
    {
      return { Location::OnEdge, std::min(h, tables_.twins[h]) };
    }
  }
  return { Location::InTriangle, first };
}

Location Locator::locate(
  const Point& place, std::size_t from, std::size_t mostSteps, Ticker& ticker) const
{
  HalfEdge entered = static_cast<HalfEdge>(3 * from);
  if (side(entered, place) < 0)
  {
    // As if it came from the first triangle's other side.
    if (tables_.twins[entered] == kNoHalfEdge)
    {
      return { Location::Outside, entered };
    }
    entered = tables_.twins[entered];
  }
  for (std::size_t step = 0; step < mostSteps; ++step)
  {
    if (!ticker.step(kStepsOfTriangle))
    {
      return {};
    }
    const HalfEdge crossed = edgeToCross(entered, place, step);
    if (crossed == kNoHalfEdge)
    {
      return inTriangle(entered / 3, place);
    }
    if (tables_.twins[crossed] == kNoHalfEdge)
    {
      return { Location::Outside, crossed };
    }
    entered = tables_.twins[crossed];
  }
  return lookEverywhere(place, ticker);
}

Location Locator::lookEverywhere(const Point& place, Ticker& ticker) const
{
  for (std::size_t t = 0; t < tables_.triangles(); ++t)
  {
    if (!ticker.step(kStepsOfTriangle))
    {
      return {};
    }
    const HalfEdge h = static_cast<HalfEdge>(3 * t);
    if (side(h, place) >= 0 && side(h + 1, place) >= 0 && side(h + 2, place) >= 0)
    {
      return inTriangle(t, place);
    }
  }
  HalfEdge hull = 0;
  while (tables_.twins[hull] != kNoHalfEdge || side(hull, place) >= 0)
  {
    if (!ticker.step(kStepsOfTriangle))
    {
      return {};
    }
    ++hull;
  }
  return { Location::Outside, hull };
}

Location Triangulation::locate(const Point& place, std::size_t hint) const
{
  Ticker nobody(nullptr, Phase::Outputs, 0);
  return locate(place, hint, nobody);
}

Location Triangulation::locate(const Point& place, std::size_t hint, Ticker& ticker) const
{
  const std::size_t triangles = triangleCount();
  if (triangles == 0 || !isFinite(place))
  {
    return {};
  }
  const Locator locator(state_->tables, state_->ranked.xy.data());
  return locator.locate(place, hint < triangles ? hint : 0, triangles, ticker);
}

} // namespace ahd
