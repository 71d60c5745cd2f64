// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Selected_h
#define ahd_Selected_h

#include "../Core/Loops.h"
#include "../Triangulation/MeshOrder.h"
#include "../Triangulation/State.h"
#include "Selection.h"

#include <algorithm>

namespace ahd
{

/// Arrays (see inMeshOrder) that are written at the places of triangles, where some have none.
template <typename Arrays>
struct PlacedArrays
{
  void prepare(std::uint32_t number) const { prefetchForRead(places + triangleOf(number)); }
  void fetch(std::uint32_t number) const
  {
    const std::uint32_t place = number == kNotExtracted ? kNoIndex : places[triangleOf(number)];
    if (place != kNoIndex)
    {
      arrays.fetch(place << 2);
    }
  }
  Arrays arrays;
  const std::uint32_t* places; ///< of each triangle; kNoIndex: none
};

/// The triangles that are written, and their places in the output.
class Selected
{
public:
  using State = TriangulationAccess::State;

  /// Borrows both.
  Selected(const State& state, const Selection& selection)
    : state_(state)
    , kept_(selection.kept.empty() ? nullptr : selection.kept.data())
  {
  }

  /// @pre State::makeNumbers(). `count`: of the triangles written. Returns false if cancelled,
  /// as all below; throws std::bad_alloc.
  bool number(std::size_t count, Ticker& ticker)
  {
    const std::size_t all = state_.allTriangles;
    if (count == all)
    {
      return true;
    }
    places_.allocate(all);
    return (kept_ ? markSelected(ticker) : markKept(ticker)) && countUp(ticker);
  }

  /// kNoIndex for one that is not written. @pre number().
  std::uint32_t placeOf(std::size_t triangle) const
  {
    return places_.empty() ? static_cast<std::uint32_t>(triangle) : places_[triangle];
  }
  /// The same of the triangle in a slot; kNoIndex for ghosts as well.
  std::uint32_t placeOfSlot(std::size_t slot) const
  {
    const std::uint32_t number = state_.numbers[slot];
    return number == kNotExtracted ? kNoIndex : placeOf(triangleOf(number));
  }

  /// Calls visit(its place, its slot, OrderedTriangle) for each, on all threads lent. It writes to
  /// `array`, see inMeshOrder(). @pre number().
  template <typename Arrays, typename Visit>
  bool each(const Arrays& array, Ticker& ticker, const Visit& visit) const
  {
    const auto visitPlace = [&](std::size_t t, std::size_t slot, const OrderedTriangle& triangle)
    {
      if (const std::uint32_t place = placeOf(t); place != kNoIndex)
      {
        visit(std::size_t(place), slot, triangle);
      }
    };
    return places_.empty() ? inMeshOrder(state_.mesh, state_.numbers, array, ticker, visitPlace)
                           : inMeshOrder(state_.mesh, state_.numbers,
                               PlacedArrays<Arrays>{ array, places_.data() }, ticker, visitPlace);
  }

private:
  bool markSelected(Ticker& ticker)
  {
    return inChunksOf(places_.size(), ticker,
      [this](std::size_t a, std::size_t b)
      {
        for (std::size_t t = a; t != b; ++t)
        {
          places_[t] = kept_[t] != 0 ? 0 : kNoIndex;
        }
      });
  }

  bool markKept(Ticker& ticker)
  {
    return inMeshOrder(state_.mesh, state_.numbers, TriangleArray(places_.data(), 1), ticker,
      [this](std::size_t t, std::size_t slot, const OrderedTriangle&)
      { places_[t] = (state_.marksOf(slot) & kDropped) == 0 ? 0 : kNoIndex; });
  }

  /// Numbers the marked triangles.
  bool countUp(Ticker& ticker)
  {
    return countAndWrite(
      places_.size(), ticker,
      [this](std::size_t a, std::size_t b)
      { return std::size_t(std::count(places_.data() + a, places_.data() + b, 0u)); },
      [](std::size_t) {},
      [this](std::size_t a, std::size_t b, std::size_t next)
      {
        for (std::size_t t = a; t != b; ++t)
        {
          places_[t] = places_[t] == kNoIndex ? kNoIndex : static_cast<std::uint32_t>(next++);
        }
        return next;
      });
  }

  const State& state_;
  const unsigned char* kept_;
  Buffer<std::uint32_t> places_; ///< empty if all are written
};

} // namespace ahd

#endif
