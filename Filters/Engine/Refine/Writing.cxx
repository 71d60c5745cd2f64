// SPDX-License-Identifier: BSD-3-Clause
#include "Writing.h"

#include "../Core/Chunks.h"
#include "SortTaking.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace ahd
{
namespace
{

using Vertex = Domain::Vertex;

/// Fills a Refinement.
class Writer
{
public:
  Writer(const Domain& domain, const Refiner& refiner, Ticker& ticker, Refinement& out)
    : domain_(domain)
    , refiner_(refiner)
    , ticker_(ticker)
    , growing_(ticker)
    , out_(out)
  {
  }

  bool write()
  {
    return writePoints() && sortOnSegments() && writeLines() && writeLoops() && writeBad();
  }

private:
  const std::vector<Domain::Segment>& segments() const { return domain_.segments(); }
  /// The border edge has what is inside on its left.
  Vertex startOf(Index s) const
  {
    return segments()[s].isLeftInside ? segments()[s].a : segments()[s].b;
  }
  Vertex endOf(Index s) const
  {
    return segments()[s].isLeftInside ? segments()[s].b : segments()[s].a;
  }
  Index idOf(Vertex v) const
  {
    return domain_.isSteiner(v)
      ? static_cast<Index>(domain_.made().points().count + (v - domain_.firstSteiner()))
      : domain_.made().pointOf(v - Domain::kFirst);
  }
  void add(Vertex v) { growing_.add(out_.ids, static_cast<std::int64_t>(idOf(v))); }
  void endChain() { growing_.add(out_.offsets, static_cast<std::int64_t>(out_.ids.size())); }

  bool writePoints();
  bool sortOnSegments();
  void addInside(Index segment, bool isBackwards);
  bool writeLines();
  bool writeLoops();
  Index nextFrom(Vertex v);
  bool writeBad();

  const Domain& domain_;
  const Refiner& refiner_;
  Ticker& ticker_;
  GrowingMemory growing_;
  Refinement& out_;
  std::vector<Vertex> onSegments_; ///< Steiner points, by segment, then fraction
  std::vector<Index> border_;      ///< segments, by startOf
  std::vector<Index> used_;        ///< of those that begin where this one, the first, begins
};

bool Writer::writePoints()
{
  const auto one = [this](std::size_t k)
  {
    const Domain::Origin& from = domain_.origins()[k];
    const Vertex v = domain_.firstSteiner() + static_cast<Vertex>(k);
    const Point& p = domain_.place(v);
    if (from.segment == kNoIndex)
    {
      growing_.add(out_.points, domain_.weighted(p, from.triangle));
      return;
    }
    const Domain::Segment& s = segments()[from.segment];
    growing_.add(out_.points,
      SteinerPoint{ p.x, p.y, { { idOf(s.a), idOf(s.b), kNoIndex } },
        { { 1.0 - from.fraction, from.fraction, 0.0 } } });
    growing_.add(onSegments_, v);
  };
  const bool all = inSteps(0, domain_.origins().size(), ticker_, one);
  out_.onSegments = onSegments_.size();
  return all;
}

bool Writer::sortOnSegments()
{
  return sortTaking(onSegments_, ticker_,
    [this](Vertex v, Vertex w)
    {
      const Domain::Origin &a = domain_.originOf(v), &b = domain_.originOf(w);
      return std::tie(a.segment, a.fraction) < std::tie(b.segment, b.fraction);
    });
}

/// The points between the ends of a segment.
void Writer::addInside(Index segment, bool isBackwards)
{
  const auto isOf = [this](Vertex v, Index s) { return domain_.originOf(v).segment < s; };
  const auto begin = std::lower_bound(onSegments_.begin(), onSegments_.end(), segment, isOf);
  const auto end = std::lower_bound(begin, onSegments_.end(), segment + 1, isOf);
  for (std::ptrdiff_t k = 0, n = end - begin; k < n; ++k)
  {
    add(begin[isBackwards ? n - 1 - k : k]);
  }
}

bool Writer::writeLines()
{
  endChain();
  return inSteps(0, segments().size(), ticker_,
    [this](std::size_t k)
    {
      const Domain::Segment& s = segments()[k];
      if (s.isBorder())
      {
        growing_.add(border_, static_cast<Index>(k));
        return;
      }
      add(s.a);
      addInside(static_cast<Index>(k), false);
      add(s.b);
      endChain();
      ++out_.lines;
    });
}

/// The next border edge from there that is in no loop yet. @pre there is one
Index Writer::nextFrom(Vertex v)
{
  const auto first = std::lower_bound(
    border_.begin(), border_.end(), v, [this](Index s, Vertex w) { return startOf(s) < w; });
  const auto k = static_cast<std::size_t>(first - border_.begin());
  return border_[k + used_[k]++];
}

/// As many border edges end at a vertex as begin there, so each way leads back to its start.
bool Writer::writeLoops()
{
  const bool isSorted = sortTaking(border_, ticker_,
    [this](Index s, Index t)
    { return std::make_pair(startOf(s), s) < std::make_pair(startOf(t), t); });
  TakenMemory memory(ticker_);
  memory.atLeast(border_.size() * sizeof(Index));
  used_.assign(border_.size(), 0);
  std::size_t group = 0; // where those of a start begin
  const auto from = [&](std::size_t k)
  {
    group = k > 0 && startOf(border_[k]) == startOf(border_[k - 1]) ? group : k;
    if (k - group < used_[group])
    {
      return;
    }
    const Vertex start = startOf(border_[k]);
    Vertex at = start;
    do
    {
      const Index s = nextFrom(at);
      add(at);
      addInside(s, !segments()[s].isLeftInside);
      at = endOf(s);
    } while (at != start);
    endChain();
  };
  return isSorted && inSteps(0, border_.size(), ticker_, from);
}

bool Writer::writeBad()
{
  const LivingMesh& mesh = domain_.mesh();
  using Found = std::pair<std::array<Vertex, 3>, RefineReason>;
  std::vector<Found> found;
  const auto look = [&](std::size_t k)
  {
    const auto s = static_cast<Domain::Slot>(k * Mesh::kSlotSize);
    RefineReason reason;
    if (!domain_.isInside(s))
    {
      return;
    }
    ++out_.triangles;
    for (Domain::Halfedge h = s; h < s + 3; ++h)
    {
      const Domain::Halfedge g = mesh.twin(h);
      const bool isCounted = g < h && domain_.isInside(Mesh::slotOf(g)); // from its other side
      if (mesh.isConstraint(h) && !isCounted && refiner_.isEncroached(h))
      {
        ++out_.encroachedPieces;
      }
    }
    if (!refiner_.isGood(s, reason))
    {
      std::array<Vertex, 3> v = { { mesh.apex(s), mesh.apex(s + 1), mesh.apex(s + 2) } };
      const auto isLess = [this](Vertex a, Vertex b) { return domain_.isLess(a, b); };
      std::rotate(v.begin(), std::min_element(v.begin(), v.end(), isLess), v.end());
      growing_.add(found, Found{ v, reason });
    }
  };
  const auto isBefore = [this](const Found& a, const Found& b)
  {
    return std::lexicographical_compare(a.first.begin(), a.first.end(), b.first.begin(),
      b.first.end(), [this](Vertex v, Vertex w) { return domain_.isLess(v, w); });
  };
  const auto write = [&](std::size_t k)
  {
    const std::array<Vertex, 3>& v = found[k].first;
    growing_.add(
      out_.bad, BadTriangle{ { { idOf(v[0]), idOf(v[1]), idOf(v[2]) } }, found[k].second });
  };
  return inSteps(0, mesh.end() / Mesh::kSlotSize, ticker_, look) &&
    sortTaking(found, ticker_, isBefore) && inSteps(0, found.size(), ticker_, write);
}

} // namespace

bool writeRefinement(const Domain& domain, const Refiner& refiner, Ticker& ticker, Refinement& out)
{
  return Writer(domain, refiner, ticker, out).write();
}

} // namespace ahd
