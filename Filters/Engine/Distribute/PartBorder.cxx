// SPDX-License-Identifier: BSD-3-Clause
#include "Part.h"

#include "../Core/SortAsking.h"
#include "../Extract/Extractor.h"
#include "../Order/Quantise.h"
#include "../Order/Rank.h"

#include <algorithm>

namespace ahd
{

BorderPoint Part::describe(Index vertex) const
{
  const TriangulationAccess::State& all = state();
  const Index point = all.ranked.id[vertex];
  if (ids_ == nullptr)
  {
    return given_[point];
  }
  const auto isAmong = [vertex](const std::vector<Index>& vertices)
  { return std::binary_search(vertices.begin(), vertices.end(), vertex); };
  const std::uint32_t end = isAmong(ends_) ? BorderPoint::kEndOfSegment : 0u;
  const std::uint32_t crowd = isAmong(crowd_) ? BorderPoint::kOfCrowd : 0u;
  return { all.ranked.xy[vertex], ids_[point], block_, end | crowd };
}

/// Those that the part above needs, ascending.
bool Part::listVertices(std::vector<Index>& vertices, Ticker& ticker) const
{
  const TriangulationAccess::State& all = state();
  const std::size_t count = all.ranked.count;
  vertices = ends_;
  vertices.reserve(ends_.size() + (hasTriangles() ? 3 * open_.size() + 2 * ghosts_.size() : count));
  for (const std::vector<Mesh::Slot>* const slots : { &open_, &ghosts_ })
  {
    for (const Mesh::Slot slot : *slots)
    {
      for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
      {
        if (data_[h] != ghost_)
        {
          vertices.push_back(data_[h]);
        }
      }
      if (!ticker.step())
      {
        return false;
      }
    }
  }
  const auto add = [&](std::size_t v)
  {
    if (!hasTriangles() || given_[all.ranked.id[v]].marks != 0)
    {
      vertices.push_back(static_cast<Index>(v));
    }
  };
  if ((!ids_ || !hasTriangles()) && !inSteps(0, count, ticker, add))
  {
    return false;
  }
  return sortOnce(vertices, ticker);
}

/// Vertices of one cell follow each other.
bool Part::addCrowds(std::vector<Index>& vertices, Ticker& ticker)
{
  const RankedPoints& ranked = state().ranked;
  const Grid grid(ranked.whole);
  const auto areTogether = [&](Index v, Index w)
  {
    const Point p = ranked.xy[v], q = ranked.xy[w];
    return grid.column(p.x) == grid.column(q.x) && grid.row(p.y) == grid.row(q.y);
  };
  Index begin = 0, end = 0; // of the last cell
  for (const Index vertex : vertices)
  {
    if (!ticker.step())
    {
      return false;
    }
    if (vertex < end)
    {
      continue;
    }
    for (begin = vertex; begin != 0 && areTogether(begin - 1, vertex) && ticker.step(); --begin)
    {
    }
    for (end = vertex + 1; end != ranked.count && areTogether(end, vertex) && ticker.step(); ++end)
    {
    }
    for (Index v = begin; end - begin > kTiedByCoordinates && v != end; ++v)
    {
      crowd_.push_back(v);
    }
  }
  vertices.insert(vertices.end(), crowd_.begin(), crowd_.end());
  return ticker.ask() && sortOnce(vertices, ticker);
}

bool Part::makeBorder(PartBorder& border, Ticker& ticker)
{
  border = PartBorder();
  std::vector<Index> vertices;
  if (!listVertices(vertices, ticker) || (keepsCrowds_ && !addCrowds(vertices, ticker)))
  {
    return false;
  }
  border.points.reserve(vertices.size());
  const auto add = [&](std::size_t i) { border.points.push_back(describe(vertices[i])); };
  return inSteps(0, vertices.size(), ticker, add) && listEdges(border, vertices, ticker);
}

/// The edges of final triangles, here or below, with nothing final on the other side.
bool Part::listEdges(PartBorder& border, const std::vector<Index>& vertices, Ticker& ticker)
{
  borderEdges_.clear();
  const auto placeOf = [&](Index vertex)
  {
    return static_cast<Index>(
      std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin());
  };
  for (const std::vector<Mesh::Slot>* const slots : { &open_, &ghosts_ })
  {
    for (const Mesh::Slot slot : *slots)
    {
      for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
      {
        const Mesh::Halfedge inner = twin(h);
        if (isSettled(inner))
        {
          borderEdges_.push_back(inner);
          border.edges.push_back({ placeOf(origin(inner)), placeOf(destination(inner)) });
        }
      }
      if (!ticker.step())
      {
        return false;
      }
    }
  }
  return true;
}

// ---------------------------------------------------------------------------- what loops keep

bool Part::takeKept(const Kept& kept, Ticker& ticker)
{
  if (kept.isAll)
  {
    return true;
  }
  isAnyDropped_ = true;
  const auto mayEnter = [&](Mesh::Halfedge, Mesh::Slot next)
  { return isSettled(next) && (label(next) & kSeen) == 0; };
  for (std::size_t i = 0; i != borderEdges_.size(); ++i)
  {
    const std::uint8_t found = kept.edges[i] != 0 ? kSeen : kSeen | kGone;
    if ((label(borderEdges_[i]) & kSeen) == 0 &&
      !flood(Mesh::slotOf(borderEdges_[i]), found, mayEnter, ticker))
    {
      return false;
    }
  }
  return countFinal(ticker);
}

bool Part::findPieces(Ticker& ticker)
{
  pieces_.assign(slots_, kNoIndex);
  std::vector<Mesh::Slot> open;
  for (const Mesh::Halfedge edge : borderEdges_)
  {
    if (pieces_[edge / Mesh::kSlotSize] == kNoIndex)
    {
      pieces_[edge / Mesh::kSlotSize] = static_cast<Index>(pieceCount_);
      open.push_back(Mesh::slotOf(edge));
    }
    while (!open.empty())
    {
      const Mesh::Slot slot = open.back();
      open.pop_back();
      for (Mesh::Halfedge h = slot; h != slot + 3; ++h)
      {
        Index& piece = pieces_[twin(h) / Mesh::kSlotSize];
        if (isSettled(twin(h)) && piece == kNoIndex)
        {
          piece = static_cast<Index>(pieceCount_);
          open.push_back(Mesh::slotOf(twin(h)));
        }
      }
      if (!ticker.step())
      {
        return false;
      }
    }
    pieceCount_ = std::max<std::size_t>(pieceCount_, pieces_[edge / Mesh::kSlotSize] + 1);
  }
  return ticker.ask();
}

std::vector<Index> Part::piecesOfBorder() const
{
  std::vector<Index> pieces;
  for (const Mesh::Halfedge edge : borderEdges_)
  {
    pieces.push_back(pieces_[edge / Mesh::kSlotSize]);
  }
  return pieces;
}

std::vector<Index> Part::piecesBelow(std::size_t child) const
{
  std::vector<Index> pieces;
  for (std::size_t i = firstEdge_[child]; i != firstEdge_[child + 1]; ++i)
  {
    pieces.push_back(pieces_[halfEdgesBelow_[i] / Mesh::kSlotSize]);
  }
  return pieces;
}

void Part::tellKept(std::size_t child, Kept& kept) const
{
  kept.isAll = !isAnyDropped_ || !hasTriangles();
  kept.edges.clear();
  for (std::size_t i = firstEdge_[child]; !kept.isAll && i != firstEdge_[child + 1]; ++i)
  {
    kept.edges.push_back((label(halfEdgesBelow_[i]) & kGone) == 0 ? 1 : 0);
  }
}

// -------------------------------------------------------------------------------- what goes out

/// Gives a triangle to the blocks of its corners, from its lowest corner on.
void Part::giveOut(Mesh::Slot slot, const BlockRow& row, std::vector<OwnedTriangles>& owned) const
{
  const TriangulationAccess::State& all = state();
  const auto point = [&](Mesh::Halfedge h) -> const BorderPoint&
  { return given_[all.ranked.id[data_[h]]]; };
  Mesh::Halfedge lowest = slot;
  for (Mesh::Halfedge h = slot + 1; h != slot + 3; ++h)
  {
    lowest = lexicographicallyLess(point(h).at, point(lowest).at) ? h : lowest;
  }
  const Mesh::Halfedge second = Mesh::next(lowest), third = Mesh::previous(lowest);
  // The edge that begins at a corner is the one opposite to the corner before it.
  unsigned flags = 0, e = 0;
  for (const Mesh::Halfedge edge : { third, lowest, second })
  {
    flags |= (all.hasMarks && all.constrained.isConstrained(edge) ? 1u : 0u) << e++;
  }
  const std::uint32_t owner = point(lowest).block, other = point(second).block;
  const std::uint32_t last = point(third).block;
  const auto give = [&](std::uint32_t block, unsigned more)
  {
    OwnedTriangles& to = owned[block - row.begin];
    to.corners.insert(to.corners.end(), { data_[lowest], data_[second], data_[third] });
    to.flags.push_back(static_cast<std::uint8_t>(flags | more));
  };
  give(owner, 0);
  if (other != owner)
  {
    give(other, OwnedTriangles::kGhost);
  }
  if (last != owner && last != other)
  {
    give(last, OwnedTriangles::kGhost);
  }
}

bool Part::listOwned(const BlockRow& row, std::vector<OwnedTriangles>& owned, Ticker& ticker) const
{
  owned.assign(row.end - row.begin, OwnedTriangles());
  const auto list = [&](Mesh::Slot slot)
  {
    if (isFinalAndKept(slot))
    {
      giveOut(slot, row, owned);
    }
  };
  if (!eachSlot(ticker, list))
  {
    return false;
  }
  for (OwnedTriangles& some : owned)
  {
    if (!listCorners(some, ticker))
    {
      return false;
    }
  }
  return true;
}

/// Vertices become places among the corners.
bool Part::listCorners(OwnedTriangles& some, Ticker& ticker) const
{
  std::vector<Index> vertices = some.corners;
  if (!sortOnce(vertices, ticker))
  {
    return false;
  }
  some.points.reserve(vertices.size());
  for (const Index vertex : vertices)
  {
    some.points.push_back(given_[state().ranked.id[vertex]]);
  }
  for (Index& corner : some.corners)
  {
    corner = static_cast<Index>(
      std::lower_bound(vertices.begin(), vertices.end(), corner) - vertices.begin());
    if (!ticker.step())
    {
      return false;
    }
  }
  return true;
}

bool Part::listPieces(std::vector<Index>& pieces, Ticker& ticker) const
{
  using Row = std::array<Index, 4>; // vertices from the lowest one, and the piece
  std::vector<Row> rows;
  const auto add = [&](Mesh::Slot slot)
  {
    if (isFinalAndKept(slot))
    {
      Row row{ { data_[slot], data_[slot + 1], data_[slot + 2], pieces_[slot / Mesh::kSlotSize] } };
      std::rotate(row.begin(), std::min_element(row.begin(), row.begin() + 3), row.begin() + 3);
      rows.push_back(row);
    }
  };
  return eachSlot(ticker, add) && sortAsking(rows, ticker, std::less<Row>()) &&
    inSteps(0, rows.size(), ticker, [&](std::size_t i) { pieces.push_back(rows[i][3]); });
}

template <typename Id>
bool Part::writeFinal(Id* triples, Ticker& ticker)
{
  if (!hasTriangles())
  {
    return true;
  }
  TriangulationAccess::State& all = state();
  all.arePlacesGone = true;
  Scratch scratch;
  scratch.view(all.ranked.xy.data(), all.ranked.xy.size() * sizeof(Point));
  return writeCanonical(ExtractedMesh(all.mesh, labels_.data(), kNotHere), all.ranked.id.data(),
    triples, scratch, ticker);
}

template bool Part::writeFinal(int*, Ticker&);
template bool Part::writeFinal(long*, Ticker&);
template bool Part::writeFinal(long long*, Ticker&);

} // namespace ahd
