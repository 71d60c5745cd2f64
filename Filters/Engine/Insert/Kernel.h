// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Kernel_h
#define ahd_Kernel_h

#include "Frame.h"
#include "Insert.h"

#include "../Core/Chunks.h"
#include "../Predicates/Filters.h"
#include "../Predicates/Predicates.h"

#include <array>

/// For what the hot loop keeps in registers.
#if defined(__GNUC__) || defined(__clang__)
#define AHD_ALWAYS_INLINE inline __attribute__((always_inline))
#else
#define AHD_ALWAYS_INLINE inline
#endif

namespace ahd
{
inline namespace AHD_TARGET
{

/// A vertex as the new point sees it. The ghost is a point far away, for which the in-circle filter
/// answers as it should; where there is no place for it, all its numbers are NaN, which no filter
/// accepts (Frame.h). So ghosts need no test of their own on the fast path.
struct Corner : Lifted
{
  Index vertex;
};

inline Corner seenFrom(const Point& p, const Point* xy, Index v)
{
  return Corner{ liftedFrom(p, xy[v]), v };
}

/// The vertices a part of a parallel insertion owns: a range of ranks.
struct Territory
{
  Index begin = 0;
  Index size = kNoIndex;

  bool owns(Index vertex) const { return vertex - begin < size; }
};

/// What became of one insertion.
enum class Insertion
{
  Done,
  Strayed,  ///< the walk left the territory: nothing was changed; another hint may do
  Deferred, ///< the cavity reaches out of the territory: nothing was changed
  Cancelled ///< the caller wants to cancel: the mesh is unusable
};

/// Alone: the mesh belongs to this kernel. Shared: others insert at the same time, each in a
/// territory of its own (Insert/Insert.h says why that is safe). Then a cavity is carved only if
/// all its finite vertices are owned, and nothing is written before that is known.
enum class Access
{
  Alone,
  Shared
};

/// Inserts one point after the other: locate, carve the cavity, fill it with the star.
/// This is the hot loop of the engine; see Algorithm.md for what was measured. kExact: for frames
/// on a grid. Ties are broken there without a branch; elsewhere that would take the registers.
template <bool kCount, Access kAccess, bool kExact>
class Kernel
{
public:
  Kernel(const Frame& frame, Mesh& mesh, Ticker& ticker, Territory territory = Territory())
    : xy_(frame.points.xy.data())
    , guard_(frame.guard)
    , perturbation_(frame.perturbation)
    , exactBelow_(frame.exactBelow)
    , data_(mesh.data())
    , ghost_(mesh.ghost())
    , territory_(territory)
    , ticker_(ticker)
  {
  }

  /// Inserts vertex p with two more triangles, in the slots `fresh` and the one after it. `hint` is
  /// a slot to start locating from, and becomes the slot from which to locate `next`.
  /// REQUIRES, if Shared: the hint's triangle has an owned vertex.
  Insertion insert(Index p, Index next, Mesh::Slot fresh, Mesh::Slot& hint)
  {
    if (!spend())
    {
      return Insertion::Cancelled;
    }
    ++insertedSinceAsking_;
    prefetchForWrite(data_ + fresh + kPointsAhead * 2 * Mesh::kSlotSize);
    const Insertion result = carve({ p, next, fresh }, hint);
    if (hint == kNoIndex)
    {
      hint = hintOutside(next, fresh);
    }
    return result;
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

  /// A triangle of the star, not yet written.
  struct StarTriangle
  {
    Mesh::Slot slot;
    Index a, b;
    Mesh::Halfedge twin;
  };

  /// What carve() is to do.
  struct Cavity
  {
    Index p, next;
    Mesh::Slot fresh;
  };

  /// A triangle as the new point sees it, and its edges: what locating and carving both look at.
  struct Root
  {
    Corner a, b, c;
    double ab, bc, ca; ///< cross(a, b), and so on
  };

  static constexpr bool kShared = kAccess == Access::Shared;
  static constexpr std::size_t kStepsPerRefill = kStepsPerAsking / 4;
  /// An exact answer counts as so many steps. At the ends of the exponent range it may take 500
  /// times as long as one; where it takes as long as two, as on lattices, asking costs nothing yet.
  static constexpr std::size_t kStepsOfExact = 16;
  static constexpr std::size_t kMostOpenEdges = 64;
  static constexpr std::size_t kPointsAhead = 4; ///< whose fresh slots are fetched
  static constexpr std::size_t kMostDeferredWrites = kShared ? 2 * kMostOpenEdges : 1;

  // Not slots, as they are not multiples of eight.
  static constexpr Mesh::Slot kCancelled = kNoIndex;
  static constexpr Mesh::Slot kStrayed = kNoIndex - 1;

  bool owns(Index vertex) const { return territory_.owns(vertex) || vertex == ghost_; }

  //--- locate -------------------------------------------------------------------------------------

  /// The triangle of a slot, from its second corner on.
  AHD_ALWAYS_INLINE Root rootAt(const Point& at, Mesh::Slot slot) const
  {
    const Corner a = seenFrom(at, xy_, data_[slot + 1]);
    const Corner b = seenFrom(at, xy_, data_[slot + 2]);
    const Corner c = seenFrom(at, xy_, data_[slot]);
    return { a, b, c, cross(a, b), cross(b, c), cross(c, a) };
  }

  AHD_ALWAYS_INLINE bool isInConflict(const Root& root, Index p)
  {
    const double det = inCircleDeterminant(root.a, root.b, root.c, root.ab, root.bc, root.ca);
    const double bound = inCircleErrorBound(root.a.z, root.b.z, root.c.z, guard_);
    if (kExact && bound < exactBelow_)
    {
      return perturbedDeterminant(
               det, root.a, root.b, root.c, root.ab, root.bc, root.ca, perturbation_) > 0;
    }
    return std::fabs(det) > bound ? det > 0
                                  : conflicts(root.a.vertex, root.b.vertex, root.c.vertex, p);
  }

  /// From a hint that is not in conflict with p to a slot that is.
  Mesh::Slot walkFrom(Index p, Mesh::Slot hint)
  {
    const bool isGhost = data_[hint] == ghost_ || data_[hint + 1] == ghost_ ||
      data_[hint + 2] == ghost_;
    return walk(p, isGhost ? finiteNeighbour(hint) : hint);
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
    return walkAcross(p, h, a, b);
  }

  /// The walk goes on: p lies strictly behind half-edge `crossed`, which runs from a to b.
  Mesh::Slot walkAcross(Index p, Mesh::Halfedge crossed, Corner a, Corner b)
  {
    for (;;)
    {
      if (!spend())
      {
        return kCancelled;
      }
      if (kShared && !territory_.owns(a.vertex) && !territory_.owns(b.vertex))
      {
        return kStrayed;
      }
      const Mesh::Halfedge h = data_[crossed + Mesh::kTwin];
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
        crossed = Mesh::next(h);
        b = apex;
      }
      else if (isRightOf(apex, b, p))
      {
        crossed = Mesh::previous(h);
        a = apex;
      }
      else
      {
        return Mesh::slotOf(h);
      }
    }
  }

  //--- cavity and star ----------------------------------------------------------------------------

  Insertion carve(const Cavity& cavity, Mesh::Slot& hint);
  void writeStar(Index p, std::size_t triangles);
  Mesh::Slot hintOutside(Index next, Mesh::Slot star);
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
  /// An exact answer is about to be asked for, within a step.
  void spendOnExact() { budget_ -= budget_ > kStepsOfExact ? kStepsOfExact : budget_ - 1; }

  const Point* xy_;
  double guard_; ///< what underflow may cost an in-circle determinant (see Filters.h)
  double perturbation_;
  double exactBelow_; ///< with bounds below this they are exact (see Filters.h)
  std::uint32_t* data_;
  Index ghost_;
  Territory territory_;
  Ticker& ticker_;
  std::array<PendingEdge, kMostOpenEdges> pending_;    ///< the topmost open edges
  std::array<StarTriangle, kMostDeferredWrites> star_; ///< if Shared: what is to be written
  Mesh::Slot spilled_ = kNoIndex; ///< slot of the topmost of those below them, if there are any
  std::size_t budget_ = kStepsPerRefill;
  std::size_t insertedSinceAsking_ = 0;
  InsertionWork work_;
};

} // namespace AHD_TARGET
} // namespace ahd

#endif
