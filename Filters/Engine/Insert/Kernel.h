// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Kernel_h
#define ahd_Kernel_h

#include "Inserter.h"

#include "../Predicates/Filters.h"
#include "../Predicates/Predicates.h"

#include <array>

namespace ahd
{

/// A vertex as the new point sees it. For the ghost all its numbers are NaN, which no
/// floating-point filter accepts: that is how ghosts leave the fast path without a test of their
/// own.
struct Corner : Lifted
{
  Index vertex;
};

inline Corner seenFrom(const Point& p, const Point* xy, Index v)
{
  return Corner{ liftedFrom(p, xy[v]), v };
}

/// Inserts one point after the other: locate, carve the cavity, fill it with the star.
/// This is the hot loop of the engine; see Algorithm.md for what was measured.
template <bool kCount>
class Kernel
{
public:
  Kernel(const RankedPoints& points, Mesh& mesh, Ticker& ticker)
    : xy_(points.xy.data())
    , guard_(guardFor(points.bounds))
    , data_(mesh.data())
    , ghost_(mesh.ghost())
    , mesh_(mesh)
    , ticker_(ticker)
  {
  }

  /// Inserts vertex p. `hint` is a slot to start locating from, and becomes the slot from which to
  /// locate `next`. Returns false if the caller wants to cancel; the mesh is then unusable.
  bool insert(Index p, Index next, Mesh::Slot& hint)
  {
    if (!spend())
    {
      return false;
    }
    ++insertedSinceAsking_;
    const Mesh::Slot root = locate(p, hint);
    return root != kNoIndex && carve(p, next, root, hint);
  }

  const InsertionWork& work() const { return work_; }

private:
  /// An edge of the cavity found so far whose outer side is still to be looked at: it runs from the
  /// end of the edge handled before it to `end`.
  struct PendingEdge
  {
    double x, y, z; ///< its end, as a Corner
    Index end;
    Mesh::Halfedge twin; ///< the edge in the triangle on its outer side
    double crossed;      ///< cross(start, end): twice the area of the star's triangle on this edge
    Mesh::Slot slot;     ///< a free slot: the cavity has as many as open edges
  };

  static PendingEdge pendingTo(Corner end, double crossed, Mesh::Halfedge twin, Mesh::Slot slot)
  {
    return PendingEdge{ end.x, end.y, end.z, end.vertex, twin, crossed, slot };
  }

  static constexpr std::size_t kStepsPerRefill = kStepsPerAsking / 4;

  //--- locate -------------------------------------------------------------------------------------

  /// A slot whose triangle is in conflict with p.
  /// The hint is nearly always in conflict itself, so that there is nothing to walk.
  Mesh::Slot locate(Index p, Mesh::Slot hint)
  {
    const Point& at = xy_[p];
    const Corner a = seenFrom(at, xy_, data_[hint]);
    const Corner b = seenFrom(at, xy_, data_[hint + 1]);
    const Corner c = seenFrom(at, xy_, data_[hint + 2]);
    if (kCount)
    {
      ++work_.trianglesWalked;
    }
    const double det = inCircleDeterminant(a, b, c, cross(a, b));
    if (inCircleIsCertain(det, a.z, b.z, c.z, guard_) ? det > 0
                                                      : conflicts(a.vertex, b.vertex, c.vertex, p))
    {
      return hint;
    }
    return walk(p,
      data_[hint] == ghost_ || data_[hint + 1] == ghost_ || data_[hint + 2] == ghost_
        ? finiteNeighbour(hint)
        : hint);
  }

  /// The finite triangle on the inner side of a ghost's hull edge.
  Mesh::Slot finiteNeighbour(Mesh::Slot ghost) const
  {
    Mesh::Halfedge h = ghost;
    while (data_[h] != ghost_)
    {
      ++h;
    }
    return Mesh::slotOf(data_[h + Mesh::kTwin]);
  }

  /// Is p strictly on the right of the line from a to b?
  bool isRightOf(const Corner& a, const Corner& b, Index p)
  {
    const double area = cross(a, b);
    return orientIsCertain(area, a.z, b.z) ? area < 0 : orientation(a.vertex, b.vertex, p) < 0;
  }

  /// Visibility walk: leave a triangle by an edge that has p strictly behind it, never back by the
  /// edge one came in by. It ends, as the triangulation is regular (Edelsbrunner 1990), in the
  /// triangle p lies in or on, or in a ghost that sees p: both are in conflict with p.
  Mesh::Slot walk(Index p, Mesh::Slot start)
  {
    const Point& at = xy_[p];
    Corner a = seenFrom(at, xy_, data_[start]);
    Corner b = seenFrom(at, xy_, data_[start + 1]);
    const Corner c = seenFrom(at, xy_, data_[start + 2]);
    // Cross edge a-b, in the direction from a to b as the triangle left behind has it.
    Mesh::Halfedge h;
    if (isRightOf(a, b, p))
    {
      h = start + 2;
    }
    else if (isRightOf(b, c, p))
    {
      h = start;
      a = b;
      b = c;
    }
    else if (isRightOf(c, a, p))
    {
      h = start + 1;
      b = a;
      a = c;
    }
    else
    {
      return start;
    }
    return walkAcross(p, data_[h + Mesh::kTwin], a, b);
  }

  /// The walk goes on: p lies strictly behind half-edge h, which runs from b to a.
  Mesh::Slot walkAcross(Index p, Mesh::Halfedge h, Corner a, Corner b)
  {
    for (;;)
    {
      if (!spend())
      {
        return kNoIndex;
      }
      if (kCount)
      {
        ++work_.trianglesWalked;
      }
      //      apex          h runs from b to a; the edges to test are a to apex and apex to b
      //     /    \                                                                          .
      //    b ---> a
      const Corner apex = seenFrom(xy_[p], xy_, data_[h]);
      if (apex.vertex == ghost_)
      {
        return Mesh::slotOf(h);
      }
      if (isRightOf(a, apex, p))
      {
        h = data_[Mesh::next(h) + Mesh::kTwin];
        b = apex;
      }
      else if (isRightOf(apex, b, p))
      {
        h = data_[Mesh::previous(h) + Mesh::kTwin];
        a = apex;
      }
      else
      {
        return Mesh::slotOf(h);
      }
    }
  }

  //--- cavity and star ----------------------------------------------------------------------------

  bool carve(Index p, Index next, Mesh::Slot root, Mesh::Slot& hint);
  const PendingEdge* pendingEnd() const { return pending_.data() + pending_.size(); }
  PendingEdge* spillPending();

  void countRemoved()
  {
    if (kCount)
    {
      ++work_.trianglesRemoved;
    }
  }

  //--- predicates where the filter does not decide ------------------------------------------------

  /// Is p in conflict with the triangle a, b, c? One of them may be the ghost. The slow path.
  bool conflicts(Index a, Index b, Index c, Index p);
  bool conflictsWithGhost(Index from, Index to, Index p);
  int orientation(Index a, Index b, Index p);

  //--- steps --------------------------------------------------------------------------------------

  /// One bounded step is about to be taken. False: the caller wants to cancel.
  bool spend() { return --budget_ != 0 || refill(); }
  bool refill();

  static double guardFor(const Bounds& bounds)
  {
    const double diagonal = squaredLength(bounds.xmax - bounds.xmin, bounds.ymax - bounds.ymin);
    return inCircleGuard(4 * diagonal);
  }

  const Point* xy_;
  double guard_; ///< what underflow may cost an in-circle determinant (see Filters.h)
  std::uint32_t* data_;
  Index ghost_;
  Mesh& mesh_;
  Ticker& ticker_;
  std::array<PendingEdge, 64> pending_; ///< the topmost open edges
  Mesh::Slot spilled_ = kNoIndex; ///< slot of the topmost of those below them, if there are any
  std::size_t budget_ = kStepsPerRefill;
  std::size_t insertedSinceAsking_ = 0;
  InsertionWork work_;
};

} // namespace ahd

#endif
