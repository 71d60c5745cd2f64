// SPDX-License-Identifier: BSD-3-Clause
#include "Refiner.h"

#include "../Arithmetic/Length.h"
#include "../Core/Chunks.h"
#include "../Predicates/Predicates.h"
#include "Functions.h"

#include <algorithm>
#include <utility>

namespace ahd
{

Refiner::Refiner(Domain& domain, const RefineRequest& request, std::size_t most, Ticker& ticker)
  : domain_(domain)
  , mesh_(domain.mesh())
  , criteria_(request, domain.width())
  , ticker_(ticker)
  , growing_(ticker)
  , most_(most)
{
}

bool Refiner::isFull() const
{
  return domain_.origins().size() >= most_;
}

// --- Queues ---

/// By length, then places: a total order of edges, or triangles, whatever their vertices' numbers.
bool Refiner::isBefore(const Item& a, const Item& b) const
{
  if (a.length != b.length)
  {
    return a.length < b.length;
  }
  int k = 0;
  while (k < 2 && a.corners[k] == b.corners[k])
  {
    ++k;
  }
  return domain_.isLess(a.corners[k], b.corners[k]);
}

void Refiner::push(std::vector<Item>& queue, const Item& item)
{
  growing_.add(queue, item);
  std::push_heap(
    queue.begin(), queue.end(), [this](const Item& a, const Item& b) { return isBefore(b, a); });
}

Refiner::Item Refiner::pop(std::vector<Item>& queue)
{
  std::pop_heap(
    queue.begin(), queue.end(), [this](const Item& a, const Item& b) { return isBefore(b, a); });
  const Item item = queue.back();
  queue.pop_back();
  return item;
}

/// The half-edge of a piece that may be gone; kNoIndex if it is.
Refiner::Halfedge Refiner::pieceOf(const Item& item) const
{
  const Vertex a = item.corners[0], b = item.corners[1];
  const Vertex from = mesh_.origin(item.at), to = mesh_.target(item.at);
  const bool isSame = (from == a && to == b) || (from == b && to == a);
  const Halfedge h = isSame ? item.at : mesh_.edge(a, b);
  return h != kNoIndex && mesh_.isConstraint(h) ? h : kNoIndex;
}

/// Is the triangle where it was? One that is made anew comes anew.
bool Refiner::isThere(const Item& item) const
{
  const Slot s = Mesh::slotOf(item.at);
  const auto isCorner = [&](Vertex v)
  { return mesh_.apex(s) == v || mesh_.apex(s + 1) == v || mesh_.apex(s + 2) == v; };
  return isCorner(item.corners[0]) && isCorner(item.corners[1]) && isCorner(item.corners[2]);
}

Refiner::Item Refiner::itemOf(Halfedge piece) const
{
  Vertex a = mesh_.origin(piece), b = mesh_.target(piece);
  if (domain_.isLess(b, a))
  {
    std::swap(a, b);
  }
  return { criteria_.length(domain_.place(a), domain_.place(b)), { a, b, b }, piece };
}

/// A triangle that has changed, and its edges.
void Refiner::lookAt(Slot s)
{
  if (!domain_.isInside(s))
  {
    return;
  }
  for (Halfedge h = s; h < s + 3; ++h)
  {
    if (mesh_.isConstraint(h) && isEncroached(h))
    {
      push(pieces_, itemOf(h));
    }
  }
  const Triangle t = measure(s);
  if (t.measured.isLarge || (t.measured.isThin && !isHidden(t)))
  {
    push(bad_, t.item);
  }
}

void Refiner::lookAtStar()
{
  for (const Slot s : mesh_.star())
  {
    lookAt(s);
  }
}

// --- What is wrong ---

bool Refiner::isOpenTo(Halfedge h, const Point& p) const
{
  return criteria_.encroaches(domain_.place(mesh_.origin(h)), domain_.place(mesh_.target(h)), p);
}

bool Refiner::isTooLong(Halfedge h) const
{
  const Vertex a = mesh_.origin(h), b = mesh_.target(h);
  const double size = domain_.hasSizes() ? (domain_.sizeOf(a) + domain_.sizeOf(b)) / 2.0 : 0.0;
  return criteria_.isTooLong(domain_.place(a), domain_.place(b), size);
}

bool Refiner::isEncroached(Halfedge h) const
{
  const Halfedge g = mesh_.twin(h);
  const bool isLeft = domain_.isInside(Mesh::slotOf(h)),
             isRight = domain_.isInside(Mesh::slotOf(g));
  return (isLeft && isOpenTo(h, domain_.place(mesh_.apex(h)))) ||
    (isRight && isOpenTo(h, domain_.place(mesh_.apex(g)))) || ((isLeft || isRight) && isTooLong(h));
}

Refiner::Triangle Refiner::measure(Slot s) const
{
  Vertex v[3] = { mesh_.apex(s), mesh_.apex(s + 1), mesh_.apex(s + 2) };
  const auto order = [this](Vertex& a, Vertex& b)
  {
    if (domain_.isLess(b, a))
    {
      std::swap(a, b);
    }
  };
  order(v[0], v[1]);
  order(v[1], v[2]);
  order(v[0], v[1]);
  const Point places[3] = { domain_.place(v[0]), domain_.place(v[1]), domain_.place(v[2]) };
  const double sizes[3] = { domain_.sizeOf(v[0]), domain_.sizeOf(v[1]), domain_.sizeOf(v[2]) };
  const Measured m = criteria_.measure(places, domain_.hasSizes() ? sizes : nullptr);
  return { { m.shortest, { v[0], v[1], v[2] }, s + static_cast<Halfedge>(m.apex) }, m };
}

/// Is the edge one between two segments that meet in a sharp angle, its ends equally far from
/// there? Then splitting it would make another one.
bool Refiner::isAcrossInputAngle(Vertex p, Vertex q) const
{
  if (!domain_.isSteiner(p) || !domain_.isSteiner(q))
  {
    return false;
  }
  const Index i = domain_.originOf(p).segment, j = domain_.originOf(q).segment;
  if (i == kNoIndex || j == kNoIndex || i == j)
  {
    return false;
  }
  const Domain::Segment &s = domain_.segments()[i], &t = domain_.segments()[j];
  const bool isAtA = s.a == t.a || s.a == t.b;
  const Vertex corner = isAtA ? s.a : s.b, end = isAtA ? s.b : s.a;
  if (corner != t.a && corner != t.b)
  {
    return false;
  }
  const Point& c = domain_.place(corner);
  const Point& other = domain_.place(corner == t.a ? t.b : t.a);
  if (!criteria_.isSharp(domain_.place(end), c, other))
  {
    return false;
  }
  const double ofP = criteria_.length(domain_.place(p), c);
  const double ofQ = criteria_.length(domain_.place(q), c);
  return ofP > 0.999 * ofQ && ofP < 1.001 * ofQ;
}

/// Is it thin for such an edge?
bool Refiner::isHidden(const Triangle& t) const
{
  const int apex = t.measured.apex;
  return isAcrossInputAngle(t.item.corners[(apex + 1) % 3], t.item.corners[(apex + 2) % 3]);
}

bool Refiner::isGood(Slot s, RefineReason& reason) const
{
  const Triangle t = measure(s);
  const bool isAngle = t.measured.isThin && !t.measured.isLarge && isHidden(t);
  reason = isAngle ? RefineReason::InputAngle
    : isFull()     ? RefineReason::Budget
                   : RefineReason::Resolution;
  return !t.measured.isThin && !t.measured.isLarge;
}

// --- Splitting pieces ---

/// Marks the vertices where two segments meet inside in less than 60 degrees.
void Refiner::findSharp()
{
  for (const Domain::Segment& s : domain_.segments())
  {
    for (const Vertex v : { s.a, s.b })
    {
      if (sharp_[v] == 0)
      {
        findSharpAt(v);
      }
    }
  }
}

void Refiner::findSharpAt(Vertex v)
{
  const auto next = [this](Halfedge h)
  {
    do
    {
      h = mesh_.around(h);
    } while (!mesh_.isConstraint(h));
    return h;
  };
  const Point& c = domain_.place(v);
  const Halfedge first = next(mesh_.leaving(v));
  unsigned char isSharp = 1; // 1: looked at
  Halfedge h = first;
  do
  {
    const Halfedge after = next(h);
    const Point &a = domain_.place(mesh_.target(h)), &b = domain_.place(mesh_.target(after));
    const bool isInside = domain_.isInside(Mesh::slotOf(h));
    isSharp = isInside && orient2d(c, a, b) > 0 && criteria_.isSharp(a, c, b) ? 2 : isSharp;
    h = after;
  } while (h != first);
  sharp_[v] = isSharp;
}

/// Half-way, or, where the piece begins at a sharp corner, at a distance from it that is a power of
/// two, as on all segments there ("shells": Ruppert 1995).
double Refiner::splitFraction(Index segment, double from, double to) const
{
  const Domain::Segment& s = domain_.segments()[segment];
  const bool isAtA = from == 0.0 && sharp_[s.a] == 2, isAtB = to == 1.0 && sharp_[s.b] == 2;
  if (isAtA == isAtB)
  {
    return from + (to - from) / 2.0;
  }
  const Point &a = domain_.place(s.a), &b = domain_.place(s.b);
  const double length = lengthOf(b.x - a.x, b.y - a.y), part = to - from;
  double fraction = nearestPowerOfTwo(length * part / 2.0) / length;
  fraction /= fraction > part * (2.0 / 3.0) ? 2.0 : 1.0;
  fraction *= fraction < part / 3.0 ? 2.0 : 1.0;
  return isAtA ? fraction : 1.0 - fraction;
}

/// Are the four triangles around the new vertex counterclockwise? Then no vertex changes sides.
bool Refiner::hasRoom(Halfedge h, const Point& place) const
{
  const Halfedge g = mesh_.twin(h);
  const Point &a = domain_.place(mesh_.origin(h)), &b = domain_.place(mesh_.target(h));
  const Point &c = domain_.place(mesh_.apex(h)), &d = domain_.place(mesh_.apex(g));
  return !(place == a) && !(place == b) && orient2d(b, c, place) > 0 && orient2d(c, a, place) > 0 &&
    orient2d(a, d, place) > 0 && orient2d(d, b, place) > 0;
}

/// Where to split a piece: a fraction of the segment of the input, and the place there.
bool Refiner::findSplit(Halfedge h, Point& place, double& fraction) const
{
  const Vertex p = mesh_.origin(h), q = mesh_.target(h);
  if (criteria_.areClose(domain_.place(p), domain_.place(q)))
  {
    return false;
  }
  const Index k = domain_.segmentOf(p, q);
  const Domain::Segment& s = domain_.segments()[k];
  const double ofP = domain_.fractionOf(p, k), ofQ = domain_.fractionOf(q, k);
  fraction = splitFraction(k, std::min(ofP, ofQ), std::max(ofP, ofQ));
  const Point &a = domain_.place(s.a), &b = domain_.place(s.b);
  place = { between(a.x, b.x, fraction), between(a.y, b.y, fraction) };
  return hasRoom(h, place);
}

/// Returns false if there is no room for a vertex.
bool Refiner::split(Halfedge h)
{
  Point place;
  double fraction;
  if (isFull() || !findSplit(h, place, fraction))
  {
    return false;
  }
  domain_.split(h, place, fraction);
  lookAtStar();
  return true;
}

/// The shortest first. Returns whether any was split.
bool Refiner::splitAll(const std::vector<Halfedge>& pieces)
{
  std::vector<Item> items;
  for (const Halfedge h : pieces)
  {
    items.push_back(itemOf(h));
  }
  std::sort(
    items.begin(), items.end(), [this](const Item& a, const Item& b) { return isBefore(a, b); });
  bool any = false;
  for (const Item& item : items)
  {
    const Halfedge h = pieceOf(item);
    any = (h != kNoIndex && split(h)) || any;
  }
  return any;
}

// --- Triangles ---

/// Goes on to the triangle that has the place. Returns the piece in the way, kNoIndex for none.
/// Among the edges that have the place behind them, the one with the least apex is crossed: the way
/// is canonical. It ends, as each triangle's circle has the place deeper inside than the last
/// one's: only edges that are no constraints are crossed.
Refiner::Halfedge Refiner::walk(Slot& s, const Point& to) const
{
  for (;;)
  {
    Halfedge out = kNoIndex;
    for (Halfedge h = s; h < s + 3; ++h)
    {
      const bool isBehind = orient2d(domain_.place(mesh_.origin(h)), domain_.place(mesh_.target(h)),
                              to) < 0;
      const bool isFirst = isBehind &&
        (out == kNoIndex || domain_.isLess(mesh_.apex(h), mesh_.apex(out)));
      out = isFirst ? h : out;
    }
    if (out == kNoIndex || mesh_.isConstraint(out))
    {
      return out;
    }
    s = Mesh::slotOf(mesh_.twin(out));
  }
}

/// @pre it is in the triangle
LivingMesh::Spot Refiner::spotIn(Slot s, const Point& p) const
{
  LivingMesh::Spot spot = { LivingMesh::Kind::Inside, s };
  for (Halfedge h = s; h < s + 3; ++h)
  {
    if (domain_.place(mesh_.apex(h)) == p)
    {
      return { LivingMesh::Kind::AtVertex, h };
    }
    if (orient2d(domain_.place(mesh_.origin(h)), domain_.place(mesh_.target(h)), p) == 0)
    {
      spot = { LivingMesh::Kind::OnEdge, h };
    }
  }
  return spot;
}

/// The pieces that a vertex there would encroach, or lies behind or on; `s` becomes the triangle
/// that it lies in. With none and a spot that is no vertex, it can be inserted.
std::vector<Refiner::Halfedge> Refiner::piecesAgainst(
  const Point& centre, Slot s, LivingMesh::Spot& spot)
{
  const Halfedge inTheWay = walk(s, centre);
  if (inTheWay != kNoIndex)
  {
    return { inTheWay };
  }
  spot = spotIn(s, centre);
  std::vector<Halfedge> pieces;
  if (spot.kind == LivingMesh::Kind::OnEdge && mesh_.isConstraint(spot.at))
  {
    pieces.push_back(spot.at);
  }
  else if (spot.kind != LivingMesh::Kind::AtVertex)
  {
    domain_.look(centre, spot);
    mesh_.eachOfRim(
      [&](Halfedge h)
      {
        if (mesh_.isConstraint(h) && isOpenTo(h, centre))
        {
          pieces.push_back(h);
        }
      });
  }
  return pieces;
}

/// Inserts the centre, or splits the pieces against it; then the triangle may still be bad, and
/// comes again. One for which neither is possible stays as it is.
void Refiner::improve(const Item& item)
{
  const Vertex* const v = item.corners;
  const Point corners[3] = { domain_.place(v[0]), domain_.place(v[1]), domain_.place(v[2]) };
  const int apex = static_cast<int>(item.at - Mesh::slotOf(item.at));
  const Point centre = criteria_.centre(corners, apex);
  if (criteria_.areClose(corners[(apex + 1) % 3], corners[(apex + 2) % 3]) || !isFinite(centre))
  {
    return;
  }
  LivingMesh::Spot spot{ LivingMesh::Kind::AtVertex, item.at };
  const std::vector<Halfedge> pieces = piecesAgainst(centre, Mesh::slotOf(item.at), spot);
  if (!pieces.empty())
  {
    if (splitAll(pieces))
    {
      push(bad_, item);
    }
  }
  else if (spot.kind != LivingMesh::Kind::AtVertex)
  {
    domain_.insertSeen(centre, spot, v[apex]);
    lookAtStar();
  }
}

bool Refiner::run()
{
  growing_.take(domain_.firstSteiner());
  sharp_.assign(domain_.firstSteiner(), 0);
  findSharp();
  const auto look = [this](std::size_t k) { lookAt(static_cast<Slot>(k * Mesh::kSlotSize)); };
  bool goesOn = inSteps(0, mesh_.end() / Mesh::kSlotSize, ticker_, look);
  while (goesOn && !isFull() && !(pieces_.empty() && bad_.empty()))
  {
    const bool isPiece = !pieces_.empty();
    const Item item = pop(isPiece ? pieces_ : bad_);
    const Halfedge piece = isPiece ? pieceOf(item) : kNoIndex;
    if (piece != kNoIndex && isEncroached(piece))
    {
      split(piece);
    }
    else if (!isPiece && isThere(item))
    {
      improve(item);
    }
    goesOn = ticker_.step(1 + std::min(mesh_.star().size(), kChunk));
  }
  return goesOn;
}

} // namespace ahd
