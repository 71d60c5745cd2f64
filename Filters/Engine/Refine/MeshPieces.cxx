// SPDX-License-Identifier: BSD-3-Clause
#include "RefinedMesh.h"

#include "../Core/AskedMemory.h"
#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "../Predicates/Predicates.h"
#include "SortTaking.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ahd
{
namespace
{

constexpr std::int64_t kNoCell = std::numeric_limits<std::int64_t>::max();

/// An edge, by its vertices.
using Key = std::pair<Index, Index>;

Key keyOf(Index a, Index b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// Calls visit(h, neighbour) for each edge of a vertex: a half-edge of it, and its other end.
template <typename Visit>
void visitAround(const Triangulation& made, Index vertex, Visit visit)
{
  const HalfEdge first = made.start(vertex);
  for (HalfEdge h = first; h != kNoHalfEdge;)
  {
    visit(h, made.target(h));
    const HalfEdge last = previousInTriangle(h), next = made.twin(last);
    if (next == kNoHalfEdge)
    {
      visit(last, made.origin(last));
    }
    h = next == first ? kNoHalfEdge : next;
  }
}

/// The cells of the source along the edges that pieces lie on.
class EdgeCells
{
public:
  EdgeCells(const Triangulation& made, const MeshConstraints& constraints, Ticker& ticker)
    : made_(made)
    , constraints_(constraints)
    , ticker_(ticker)
    , memory_(ticker)
  {
  }

  bool find(const std::vector<MeshPiece>& pieces)
  {
    memory_.atLeast(pieces.size() * (sizeof(Key) + sizeof(std::int64_t)));
    edges_.reserve(pieces.size());
    for (const MeshPiece& piece : pieces)
    {
      edges_.push_back(keyOf(made_.vertexOf(piece.edge[0]), made_.vertexOf(piece.edge[1])));
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    cells_.assign(edges_.size(), kNoCell);
    for (std::size_t k = 0; goesOn_ && k < constraints_.chains.chains; ++k)
    {
      follow(k);
    }
    return goesOn_ && ticker_.ask();
  }

  std::int64_t of(const std::array<Index, 2>& edge) const
  {
    const std::size_t k = rowOf(made_.vertexOf(edge[0]), made_.vertexOf(edge[1]));
    return k < cells_.size() && cells_[k] != kNoCell ? cells_[k] : -1;
  }

private:
  /// The number of edges if it is none of them.
  std::size_t rowOf(Index a, Index b) const
  {
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), keyOf(a, b));
    return found != edges_.end() && *found == keyOf(a, b)
      ? static_cast<std::size_t>(found - edges_.begin())
      : edges_.size();
  }
  void take(std::size_t row, std::int64_t cell) { cells_[row] = std::min(cells_[row], cell); }
  Index vertexOf(std::int64_t id) const
  {
    return id < 0 ? kNoIndex : made_.vertexOf(static_cast<std::size_t>(id));
  }

  void follow(std::size_t chain)
  {
    const ConstraintView& chains = constraints_.chains;
    const std::int64_t begin = chains.offsets[chain], end = chains.offsets[chain + 1];
    const std::int64_t last = chain < chains.lines ? end - 1 : end; // loops are closed
    for (std::int64_t i = begin; goesOn_ && i < last; ++i)
    {
      const Index a = vertexOf(chains.ids[i]);
      const Index b = vertexOf(chains.ids[i + 1 < end ? i + 1 : begin]);
      if (a != kNoIndex && b != kNoIndex && a != b)
      {
        mark(a, b, constraints_.cellOf(chain));
      }
      goesOn_ = goesOn_ && ticker_.step();
    }
  }

  /// A segment is an edge, or edges one after the other where it passes vertices; one that was left
  /// out is neither.
  void mark(Index a, Index b, std::int64_t cell)
  {
    const std::size_t row = rowOf(a, b);
    if (row < edges_.size())
    {
      take(row, cell);
      return;
    }
    passed_.clear();
    for (Index at = a; at != b;)
    {
      const Index next = nextTowards(a, b, at);
      if (next == kNoIndex || !goesOn_)
      {
        return;
      }
      passed_.push_back(rowOf(at, next));
      at = next;
    }
    for (const std::size_t one : passed_)
    {
      if (one < edges_.size())
      {
        take(one, cell);
      }
    }
  }

  /// The other end of the constraint edge that leads from a vertex on a segment towards its end b.
  Index nextTowards(Index a, Index b, Index at)
  {
    const Point from = made_.at(a), to = made_.at(b), here = made_.at(at);
    const bool isForth = lexicographicallyLess(from, to);
    Index found = kNoIndex;
    visitAround(made_, at,
      [&](HalfEdge h, Index neighbour)
      {
        const Point p = made_.at(neighbour);
        goesOn_ = goesOn_ && ticker_.step();
        if (made_.isConstrained(h) && lexicographicallyLess(here, p) == isForth &&
          orient2d(from, to, p) == 0)
        {
          found = neighbour;
        }
      });
    return found;
  }

  const Triangulation& made_;
  const MeshConstraints& constraints_;
  Ticker& ticker_;
  TakenMemory memory_;
  bool goesOn_ = true; ///< it is not cancelled
  std::vector<Key> edges_;
  std::vector<std::int64_t> cells_;
  std::vector<std::size_t> passed_;
};

/// Finds the pieces of chains.
class PieceFinder
{
public:
  PieceFinder(const Triangulation& made, RefinedMesh& mesh, Ticker& ticker)
    : made_(made)
    , given_(made.points().count)
    , mesh_(mesh)
    , ticker_(ticker)
    , growing_(ticker)
  {
  }

  bool find()
  {
    const ConstraintView chains = mesh_.found.constraints();
    const auto one = [&](std::size_t chain)
    {
      mesh_.innerPieces = chain == chains.lines ? mesh_.pieces.size() : mesh_.innerPieces;
      const auto begin = static_cast<std::size_t>(chains.offsets[chain]);
      const auto end = static_cast<std::size_t>(chains.offsets[chain + 1]);
      chain < chains.lines ? addLine(begin, end) : addLoop(begin, end);
    };
    return findInner() && inSteps(0, chains.chains, ticker_, one);
  }

private:
  Index idAt(std::size_t i) const { return static_cast<Index>(mesh_.found.ids[i]); }

  void add(Index a, Index b, const std::array<Index, 2>& edge)
  {
    growing_.add(mesh_.pieces, MeshPiece{ { { a, b } }, edge, -1 });
  }

  /// A segment, from one end to the other.
  void addLine(std::size_t begin, std::size_t end)
  {
    const std::array<Index, 2> edge = { { idAt(begin), idAt(end - 1) } };
    for (std::size_t i = begin; isKept(edge) && i + 1 < end; ++i)
    {
      add(idAt(i), idAt(i + 1), edge);
    }
  }

  /// Border edges, the first from a point that was given.
  void addLoop(std::size_t begin, std::size_t end)
  {
    for (std::size_t first = begin; first < end;)
    {
      std::size_t last = first + 1;
      while (last < end && idAt(last) >= given_)
      {
        ++last;
      }
      const auto at = [&](std::size_t i) { return idAt(i < end ? i : begin); };
      for (std::size_t i = first; i < last; ++i)
      {
        add(idAt(i), at(i + 1), { { idAt(first), at(last) } });
      }
      first = last;
    }
  }

  /// The constraint edges of kept triangles.
  bool findInner()
  {
    return inSteps(0, made_.triangleCount(), ticker_,
             [this](std::size_t triangle)
             {
               for (std::size_t e = 0; made_.isKept(triangle) && e < 3; ++e)
               {
                 const auto h = static_cast<HalfEdge>(3 * triangle + e);
                 if (made_.isConstrained(h))
                 {
                   growing_.add(inner_, keyOf(made_.origin(h), made_.target(h)));
                 }
               }
             }) &&
      sortTaking(inner_, ticker_, std::less<Key>());
  }

  /// Is there a kept triangle beside the segment?
  bool isKept(const std::array<Index, 2>& edge) const
  {
    return std::binary_search(
      inner_.begin(), inner_.end(), keyOf(made_.vertexOf(edge[0]), made_.vertexOf(edge[1])));
  }

  const Triangulation& made_;
  const std::size_t given_;
  RefinedMesh& mesh_;
  Ticker& ticker_;
  GrowingMemory growing_;
  std::vector<Key> inner_;
};

} // namespace

Status findPieces(Triangulation& made, const MeshConstraints& constraints, const Context& context,
  RefinedMesh& mesh)
{
  if (mesh.found.ids.empty())
  {
    return Status::Ok;
  }
  const Status status = made.makePointMap(context);
  if (status != Status::Ok)
  {
    return status;
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      EdgeCells cells(made, constraints, ticker);
      if (!PieceFinder(made, mesh, ticker).find() || !cells.find(mesh.pieces))
      {
        return false;
      }
      for (MeshPiece& piece : mesh.pieces)
      {
        piece.cell = cells.of(piece.edge);
      }
      return true;
    });
}

} // namespace ahd
