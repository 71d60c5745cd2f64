// SPDX-License-Identifier: BSD-3-Clause
#include "LivingSurface.h"

#include "../Core/Loops.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ahd
{
namespace
{

/// The fewest points, or triangles, of a task.
constexpr std::size_t kLeastPoints = std::size_t(1) << 12;
constexpr std::size_t kLeastTriangles = std::size_t(1) << 7;
constexpr std::size_t kTasksPerThread = 8;

} // namespace

LivingSurface::LivingSurface(const Candidates& candidates, double bound, Ticker& ticker)
  : candidates_(candidates)
  , bound_(bound)
  , ticker_(ticker)
  , memory_(ticker)
{
}

// ------------------------------------------------------------------------------------- the start

bool LivingSurface::begin()
{
  vertexOf_.allocate(candidates_.count());
  next_.allocate(candidates_.count());
  return begin(candidates_.staying());
}

/// The surface of these, which include those that stay; without lists.
bool LivingSurface::begin(const std::vector<Index>& ranks)
{
  if (!fillAll(vertexOf_, kNoIndex, ticker_))
  {
    return false;
  }
  mesh_.clear();
  first_.clear();
  clearTouched();
  isTouched_.clear();
  expect(ranks.size());
  const std::array<Index, 3>& f = candidates_.first();
  mesh_.begin(candidates_.place(f[0]), candidates_.place(f[1]), candidates_.place(f[2]));
  valueOf_.assign(1, 0.0);
  for (std::size_t k = 0; k < f.size(); ++k) // counterclockwise, as corners of the hull are
  {
    setVertex(f[k], static_cast<Vertex>(k + 1));
  }
  // A few of them, then some in between, and so on: neighbours in rank are near, and no triangle
  // is large for long.
  constexpr std::size_t kFiner = 8;
  std::size_t step = 1;
  while (step * kFiner < ranks.size())
  {
    step *= kFiner;
  }
  for (; step > 0; step /= kFiner)
  {
    if (!addSome(ranks, step))
    {
      return false;
    }
  }
  growLists();
  return constrain();
}

bool LivingSurface::addSome(const std::vector<Index>& ranks, std::size_t step)
{
  Slot hint = 0;
  for (std::size_t k = 0; k < ranks.size(); k += step)
  {
    const Index rank = ranks[k];
    if (!isKept(rank))
    {
      const Point& p = candidates_.place(rank);
      setVertex(rank, mesh_.insert(p, mesh_.locate(p, hint)));
      hint = mesh_.star().front();
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  return true;
}

void LivingSurface::setVertex(Index rank, Vertex v)
{
  vertexOf_[rank] = v;
  valueOf_.resize(std::max<std::size_t>(valueOf_.size(), v + 1));
  valueOf_[v] = candidates_.sample(rank).value;
}

bool LivingSurface::goBackTo(std::size_t kept)
{
  std::vector<Index> ranks = candidates_.staying();
  order_.resize(kept - ranks.size());
  ranks.insert(ranks.end(), order_.begin(), order_.end());
  std::sort(ranks.begin(), ranks.end());
  return begin(ranks);
}

bool LivingSurface::constrain()
{
  crossing_.clear();
  const std::vector<std::array<Index, 2>>& segments = candidates_.segments();
  for (std::size_t k = 0; k < segments.size(); ++k)
  {
    const Vertex from = vertexOf_[segments[k][0]], to = vertexOf_[segments[k][1]];
    if (from != to && !mesh_.constrain(from, to))
    {
      crossing_.push_back(k);
    }
    if (!ticker_.step())
    {
      return false;
    }
  }
  touchAll();
  return true;
}

bool LivingSurface::list(Index step, bool isMultiple)
{
  const std::size_t n = candidates_.count();
  constexpr std::size_t kBlock = std::size_t(1) << 20; // of points that wait
  Slot hint = 0;
  for (std::size_t begin = 0; begin < n; begin += kBlock)
  {
    for (std::size_t rank = begin; rank < std::min(n, begin + kBlock); ++rank)
    {
      if ((rank % step == 0) == isMultiple && !isKept(static_cast<Index>(rank)))
      {
        waiting_.push_back({ static_cast<Index>(rank), hint });
      }
    }
    if (!findOwners())
    {
      return false;
    }
  }
  return measureTouched();
}

// ------------------------------------------------------------------------------------- the lists

void LivingSurface::expect(std::size_t more)
{
  const std::size_t needed = mesh_.vertexCount() + more;
  if (needed > room_)
  {
    const std::size_t most = candidates_.count();
    const std::size_t next = std::min(most, std::max(needed, 2 * room_));
    memory_.take(bytesFor(next));
    room_ = next;
    mesh_.reserve(next);
    valueOf_.reserve(next + 1);
    first_.reserve(2 * next + 4);
    worst_.reserve(2 * next + 4);
    isTouched_.reserve(2 * next + 4);
    touched_.reserve(2 * next + 4);
  }
}

void LivingSurface::growLists()
{
  const std::size_t slots = mesh_.end() / Mesh::kSlotSize;
  first_.resize(slots, kNoIndex);
  worst_.resize(slots, Worst{ 0.0, kNoIndex });
  isTouched_.resize(slots, 0);
}

void LivingSurface::touch(Slot s)
{
  unsigned char& is = isTouched_[s / Mesh::kSlotSize];
  if (is == 0)
  {
    is = 1;
    touched_.push_back(s);
  }
}

void LivingSurface::clearTouched()
{
  for (const Slot s : touched_)
  {
    isTouched_[s / Mesh::kSlotSize] = 0;
  }
  touched_.clear();
}

void LivingSurface::add(Index rank, Slot s)
{
  Index& first = first_[s / Mesh::kSlotSize];
  next_[rank] = first;
  first = rank;
  touch(s);
}

/// Its points wait.
void LivingSurface::takeList(Slot s)
{
  Index& first = first_[s / Mesh::kSlotSize];
  for (Index rank = first; rank != kNoIndex; rank = next_[rank])
  {
    waiting_.push_back({ rank, s });
  }
  first = kNoIndex;
}

void LivingSurface::keep(Index rank, Slot hint)
{
  const Point& p = candidates_.place(rank);
  setVertex(rank, mesh_.insert(p, mesh_.locate(p, hint)));
  order_.push_back(rank);
  growLists();
  for (const Slot s : mesh_.replaced())
  {
    takeList(s);
  }
  for (const Slot s : mesh_.star())
  {
    touch(s);
  }
}

LivingSurface::Slot LivingSurface::ownerOf(const LivingMesh::Spot& spot) const
{
  const Slot own = Mesh::slotOf(spot.at);
  if (spot.kind != LivingMesh::Kind::OnEdge)
  {
    return own;
  }
  const Slot other = Mesh::slotOf(mesh_.twin(spot.at));
  const Point &from = mesh_.place(mesh_.origin(spot.at)), &to = mesh_.place(mesh_.target(spot.at));
  return lexicographicallyLess(from, to) || mesh_.isGhost(other) ? own : other;
}

/// Lists the points that wait.
bool LivingSurface::findOwners()
{
  const std::size_t n = waiting_.size();
  const std::size_t tasks = tasksFor(threadsOf(ticker_), n, kTasksPerThread, kLeastPoints);
  const bool goesOn = inParallel(ticker_, tasks,
    [&](std::size_t task, Ticker& own)
    {
      const Share share(n, task, tasks);
      Slot last = 0, lastHint = kNoIndex;
      return inSteps(share.begin, share.end, own,
        [&](std::size_t k)
        {
          Waiting& waiting = waiting_[k];
          // neighbours of a list lie near to each other
          const Slot hint = waiting.slot == lastHint ? last : waiting.slot;
          lastHint = waiting.slot;
          waiting.slot = last = ownerOf(mesh_.locate(candidates_.place(waiting.rank), hint));
        });
    });
  if (goesOn)
  {
    for (const Waiting& waiting : waiting_)
    {
      if (!isKept(waiting.rank))
      {
        add(waiting.rank, waiting.slot);
      }
    }
  }
  waiting_.clear();
  return goesOn;
}

bool LivingSurface::settle()
{
  return findOwners() && measureTouched();
}

// ------------------------------------------------------------------------------------ the errors

void LivingSurface::touchAll()
{
  for (Slot s = 0; s < mesh_.end(); s += Mesh::kSlotSize)
  {
    touch(s);
  }
}

void LivingSurface::measureWide(double bound)
{
  isWide_ = true;
  bound_ = bound;
  touchAll();
}

Interpolant LivingSurface::interpolantOf(Slot s) const
{
  const auto corner = [&](Slot h)
  {
    const Vertex v = mesh_.apex(h);
    return Sample{ mesh_.place(v), valueOf_[v] };
  };
  return Interpolant(std::array<Sample, 3>{ { corner(s), corner(s + 1), corner(s + 2) } });
}

double LivingSurface::measure(const Interpolant& interpolant, Index rank) const
{
  const double weight = candidates_.weight(rank);
  if (weight == 0.0)
  {
    return 0.0;
  }
  const Sample sample = candidates_.sample(rank);
  return isWide_ ? interpolant.measure(sample, weight, bound_) : weight * interpolant.error(sample);
}

/// The square of the distance from the nearest corner without a value.
double LivingSurface::squaredDistanceFromUnknown(Slot s, const Point& p) const
{
  double least = std::numeric_limits<double>::infinity();
  for (Slot corner = s; corner < s + 3; ++corner)
  {
    const Vertex v = mesh_.apex(corner);
    const double x = mesh_.place(v).x - p.x, y = mesh_.place(v).y - p.y;
    least = std::isfinite(valueOf_[v]) ? least : std::min(least, x * x + y * y);
  }
  return least;
}

/// Of two points in one triangle.
bool LivingSurface::isWorse(Slot s, const Worst& a, const Worst& b) const
{
  const Point &p = candidates_.place(a.rank), &q = candidates_.place(b.rank);
  if (a.error != b.error || std::isfinite(a.error))
  {
    return a.error != b.error ? a.error > b.error : lexicographicallyLess(p, q);
  }
  const double ofP = squaredDistanceFromUnknown(s, p), ofQ = squaredDistanceFromUnknown(s, q);
  return ofP != ofQ ? ofP < ofQ : lexicographicallyLess(p, q);
}

bool LivingSurface::measureTriangle(Slot s, Ticker& ticker)
{
  Worst worst = { 0.0, kNoIndex };
  Index rank = firstOf(s);
  if (rank != kNoIndex)
  {
    const Interpolant interpolant = interpolantOf(s);
    for (; rank != kNoIndex; rank = next_[rank])
    {
      const Worst found = { measure(interpolant, rank), rank };
      worst = worst.rank == kNoIndex || isWorse(s, found, worst) ? found : worst;
      if (!ticker.step())
      {
        return false;
      }
    }
  }
  worst_[s / Mesh::kSlotSize] = worst;
  return ticker.step();
}

bool LivingSurface::measureTouched()
{
  const std::size_t n = touched_.size();
  const std::size_t tasks = tasksFor(threadsOf(ticker_), n, kTasksPerThread, kLeastTriangles);
  return inParallel(ticker_, tasks,
    [&](std::size_t task, Ticker& own)
    {
      const Share share(n, task, tasks);
      bool goesOn = true;
      for (std::size_t k = share.begin; goesOn && k != share.end; ++k)
      {
        goesOn = measureTriangle(touched_[k], own);
      }
      return goesOn;
    });
}

// ----------------------------------------------------------------------------------- second pass

/// The points of the triangles around v wait.
void LivingSurface::takeStar(Vertex v)
{
  const LivingMesh::Halfedge first = mesh_.leaving(v);
  LivingMesh::Halfedge h = first;
  do
  {
    takeList(Mesh::slotOf(h));
    h = mesh_.around(h);
  } while (h != first);
}

/// Are the points that wait within the bound in the triangles that have them?
bool LivingSurface::isStillWithin(Slot hint) const
{
  bool is = true;
  for (std::size_t k = 0; is && k < waiting_.size(); ++k)
  {
    const Index rank = waiting_[k].rank;
    hint = ownerOf(mesh_.locate(candidates_.place(rank), hint));
    is = measure(interpolantOf(hint), rank) <= bound_;
  }
  return is;
}

bool LivingSurface::tryToDrop(Index rank, bool& isDropped)
{
  const Vertex v = vertexOf_[rank];
  isDropped = false;
  if (!mesh_.isRemovable(v))
  {
    return true;
  }
  const Vertex neighbour = mesh_.target(mesh_.leaving(v));
  const auto hint = [&] { return Mesh::slotOf(mesh_.leaving(neighbour)); };
  takeStar(v);
  if (mesh_.remove(v))
  {
    waiting_.push_back({ rank, kNoIndex });
    isDropped = isStillWithin(hint());
    if (!isDropped)
    {
      const Point& p = candidates_.place(rank);
      mesh_.insert(p, mesh_.locate(p, hint())); // it has the same number
      waiting_.pop_back();
    }
  }
  for (Waiting& waiting : waiting_)
  {
    waiting.slot = hint();
  }
  vertexOf_[rank] = isDropped ? kNoIndex : v;
  return findOwners();
}

bool LivingSurface::dropWhatMayGo()
{
  std::vector<Index> stays;
  for (std::size_t k = order_.size(); k-- > 0;)
  {
    bool isDropped = false;
    if (!tryToDrop(order_[k], isDropped) || !ticker_.step())
    {
      return false;
    }
    if (!isDropped)
    {
      stays.push_back(order_[k]);
    }
  }
  order_.assign(stays.rbegin(), stays.rend());
  return true;
}

} // namespace ahd
