// SPDX-License-Identifier: BSD-3-Clause
#include "Extractor.h"

#include "../SortInSteps.h"

#include <algorithm>
#include <array>

namespace ahd
{

namespace
{

/// The corners of a triangle, from its lowest on, counterclockwise.
struct FromLowest
{
  std::uint32_t v0, v1, v2;
};

FromLowest fromLowest(const std::uint32_t* corners)
{
  const std::uint32_t a = corners[0], b = corners[1], c = corners[2];
  if (a < b && a < c)
  {
    return { a, b, c };
  }
  return b < c ? FromLowest{ b, c, a } : FromLowest{ c, a, b };
}

bool hasCorner(const std::uint32_t* corners, std::uint32_t vertex)
{
  return corners[0] == vertex || corners[1] == vertex || corners[2] == vertex;
}

/// Calls visit(v0, v1, v2) for every finite triangle, its lowest vertex first.
template <typename Visit>
bool forEachFinite(const Mesh& mesh, Ticker& ticker, Visit visit)
{
  for (Mesh::Slot slot = 0; slot != mesh.end(); slot += Mesh::kSlotSize)
  {
    const std::uint32_t* corners = mesh.data() + slot;
    if (!hasCorner(corners, mesh.ghost()))
    {
      visit(fromLowest(corners));
    }
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

/// From how many triangles have each vertex as their lowest to where the first of them is written.
bool sumUp(Buffer<std::uint32_t>& counts, Ticker& ticker)
{
  std::uint32_t sum = 0;
  for (std::uint32_t& count : counts)
  {
    const std::uint32_t n = count;
    count = sum;
    sum += n;
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

template <typename Id>
using Triple = std::array<Id, 3>;

/// Sorts the triangles around each lowest vertex and turns vertices into ids.
template <typename Id>
bool finishFans(
  const Buffer<std::uint32_t>& ends, const std::uint32_t* ids, Triple<Id>* triples, Ticker& ticker)
{
  // Around one lowest vertex the second corner alone tells two triangles apart.
  const auto bySecond = [](const Triple<Id>& a, const Triple<Id>& b) { return a[1] < b[1]; };
  Triple<Id>* fan = triples;
  for (const std::uint32_t end : ends)
  {
    Triple<Id>* const fanEnd = triples + end;
    if (!sortInSteps(fan, fanEnd, bySecond, ticker))
    {
      return false;
    }
    for (; fan != fanEnd; ++fan)
    {
      for (Id& corner : *fan)
      {
        corner = Id(ids[std::size_t(corner)]);
      }
      if (!ticker.step())
      {
        return false;
      }
    }
    ticker.finished(1);
  }
  return true;
}

} // namespace

std::size_t countHullVertices(const Mesh& mesh, Ticker& ticker)
{
  const std::uint32_t* data = mesh.data();
  Mesh::Halfedge start = 0;
  while (data[start] != mesh.ghost())
  {
    // Corner after corner, over the unused fourth to eighth number of a slot.
    start += (start & 3u) == 2 ? Mesh::kSlotSize - 2 : 1;
    if (!ticker.step())
    {
      return 0;
    }
  }
  std::size_t count = 0;
  Mesh::Halfedge h = start;
  do
  {
    // h's apex is the ghost; turn around it into the next ghost triangle.
    h = Mesh::next(data[Mesh::next(h) + Mesh::kTwin]);
    ++count;
    if (!ticker.step())
    {
      return 0;
    }
  } while (h != start);
  return count;
}

template <typename Id>
bool writeCanonical(const Mesh& mesh, const std::uint32_t* ids, Id* triples, Ticker& ticker)
{
  Buffer<std::uint32_t> places;
  places.allocate(mesh.ghost());
  std::fill(places.begin(), places.end(), 0u);
  const auto countLowest = [&places](const FromLowest& t) { ++places[t.v0]; };
  // After this, the places have moved to the ends of the fans.
  const auto put = [&places, triples](const FromLowest& t)
  {
    Id* out = triples + 3 * std::size_t(places[t.v0]++);
    out[0] = Id(t.v0);
    out[1] = Id(t.v1);
    out[2] = Id(t.v2);
  };
  return forEachFinite(mesh, ticker, countLowest) && sumUp(places, ticker) &&
    forEachFinite(mesh, ticker, put) &&
    finishFans(places, ids, reinterpret_cast<Triple<Id>*>(triples), ticker);
}

template bool writeCanonical(const Mesh&, const std::uint32_t*, std::int32_t*, Ticker&);
template bool writeCanonical(const Mesh&, const std::uint32_t*, std::int64_t*, Ticker&);

} // namespace ahd
