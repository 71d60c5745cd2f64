// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Kernel_h
#define ahd_Kernel_h

#include "Frame.h"
#include "Insert.h"

#include "../Core/Chunks.h"
#include "../Predicates/FilterPairs.h"
#include "../Predicates/Predicates.h"
#include "../Predicates/TighterFilterPairs.h"
#include "../Predicates/TighterFilters.h"

#include <algorithm>
#include <array>

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

/// The outcome of one insertion.
enum class Insertion
{
  Done,
  Strayed,  ///< the walk left the territory: nothing was changed; another hint may do
  Deferred, ///< the cavity leaves the territory: all changes were undone
  Cancelled ///< the mesh is unusable
};

/// Alone: the mesh belongs to this kernel. Shared: others insert at the same time, each in a
/// territory of its own (Insert/Insert.h says why that is safe). Then a cavity is carved only as
/// far as all its finite vertices are owned. Nearly all of them are, so the star grows in the mesh
/// as ever, and is taken back where it meets a vertex that is not.
enum class Access
{
  Alone,
  Shared
};

/// Inserts one point after the other: locate, carve the cavity, fill it with the star.
/// This is the hot loop of the engine; README.md has the measurements. kExact: for frames on a
/// grid. Ties are broken there without a branch; elsewhere that would take the registers.
template <bool kCount, Access kAccess, bool kExact>
class Kernel
{
public:
  Kernel(const Frame& frame, Mesh& mesh, Ticker& ticker, Territory territory = Territory())
    : xy_(frame.points.xy.data())
    , guard_(frame.guard)
    , squaredGuard_(frame.squaredGuard)
    , exactly_{ frame.exactBelow, frame.perturbation }
    , data_(mesh.data())
    , ghost_(mesh.ghost())
    , territory_(territory)
    , ticker_(ticker)
  {
  }

  /// Inserts vertex p with two more triangles, in the slots `fresh` and the one after it. `hint` is
  /// a slot to start locating from, and becomes the slot from which to locate `next`.
  /// @pre if Shared, the hint's triangle has an owned vertex.
  Insertion insert(Index p, Index next, Mesh::Slot fresh, Mesh::Slot& hint)
  {
    ++insertedSinceAsking_;
    prefetchForWrite(data_ + fresh + kSlotsAhead * Mesh::kSlotSize);
    prefetchForRead(xy_ + p + kVerticesAhead);
    const Cavity cavity{ p, next, fresh };
    return kShared && !isOutside_ ? carve<kShared>(cavity, hint) : carve<false>(cavity, hint);
  }

  const InsertionWork& work() const { return work_; }
  /// Triangles walked through and removed, exact answers counted several times.
  std::size_t steps() const { return refills_ * kStepsPerRefill + (kStepsPerRefill - budget_); }

  /// From now on long walks jump to triangles that are noted. False: to be cancelled.
  /// @pre Alone, the first triangle is there; one kernel of a mesh takes notes.
  bool beginToNote();
  /// Notes a triangle of this vertex or near it.
  void note(Index vertex, Mesh::Slot slot) { data_[placeOfNote(vertex / kRanksPerNote)] = slot; }

private:
  /// What carve() is to do.
  struct Cavity
  {
    Index p, next;
    Mesh::Slot fresh;
  };

  /// A triangle a, b, c that the insertion begins with: its edges a-b and b-c, and c-a.
  struct Root
  {
    Index a, b, c;
    EdgePair edges;
    EdgePair closing; ///< c-a, and a-b once more
  };

  /// The triangles beyond two edges: the edges' names there, and the apices.
  struct Beyond
  {
    Mesh::Halfedge first, second;
    Index firstApex, secondApex;
  };

  /// A triangle in conflict with p, met across the edge of the star's triangle at `place`. Its
  /// other edges, which meet in its apex, take the place of that edge.
  struct Removed
  {
    Mesh::Slot place;
    Mesh::Halfedge entry; ///< that edge, as its own
    Index apex;
    bool apexIsRight; ///< of the way from p to the next point
    EdgePair edges;
    Beyond beyond;
  };

  static constexpr bool kShared = kAccess == Access::Shared;
  static constexpr std::size_t kStepsPerRefill = kStepsPerAsking / 4;
  /// An exact answer counts as so many steps. At the ends of the exponent range it may take 500
  /// times as long as one; where it takes as long as two, as on lattices, asking costs nothing yet.
  static constexpr std::size_t kStepsOfExact = 16;
  static constexpr std::size_t kSlotsAhead = 8;     ///< fetched, those of four points
  static constexpr std::size_t kVerticesAhead = 16; ///< fetched: their coordinates
  static constexpr std::size_t kMostSplits = 126;   ///< that can be taken back
  static constexpr Index kRanksPerNote = 32;        ///< 16 to 128 are alike
  static constexpr Index kNotesTried = 3;           ///< from the next one after p
  static constexpr unsigned kStepsToJump = 6;       ///< 4 to 8 are alike
  static constexpr Index kStepsOnHull = 16;         ///< where there are no jumps

  // Not slots, as they are not multiples of eight.
  static constexpr Mesh::Slot kCancelled = kNoIndex;
  static constexpr Mesh::Slot kStrayed = kNoIndex - 1;

  bool owns(Index vertex) const { return territory_.owns(vertex) || vertex == ghost_; }
  /// May carve<kInside>() remove triangles with this vertex?
  template <bool kInside>
  bool mayRemove(Index vertex) const
  {
    return kInside ? territory_.owns(vertex) : owns(vertex);
  }

  //--- locate -------------------------------------------------------------------------------------

  /// The triangle of a slot as it is seen from p, which is `at`.
  AHD_ALWAYS_INLINE Root rootAt(Pair at, Mesh::Slot slot) const
  {
    const std::uint32_t* const corners = data_ + slot;
    const Pair a = coordinates(xy_[corners[1]]) - at;
    const Pair b = coordinates(xy_[corners[2]]) - at;
    const Pair c = coordinates(xy_[corners[0]]) - at;
    const LiftedPair ab = lifted(a, b), bc = lifted(b, c), ca = lifted(c, a);
    return { corners[1], corners[2], corners[0], { ab, bc, cross(ab, bc) },
      { ca, ab, cross(ca, ab) } };
  }

  AHD_ALWAYS_INLINE bool isInConflict(const Root& root, Index p)
  {
    const Lifted a = lowOf(root.edges.a), b = highOf(root.edges.a), c = lowOf(root.closing.a);
    const double axb = low(root.edges.crossed);
    const double bxc = high(root.edges.crossed);
    const double cxa = low(root.closing.crossed);
    const double det = inCircleDeterminant(a, b, c, axb, bxc, cxa);
    const double bound = inCircleErrorBound(a.z, b.z, c.z, guard_);
    if (kExact && bound < exactly_.below)
    {
      return perturbedDeterminant(det, a, b, c, axb, bxc, cxa, exactly_.perturbation) > 0;
    }
    return std::fabs(det) > bound ? det > 0 : conflicts(root.a, root.b, root.c, p);
  }

  /// From a hint to a slot that is in conflict with p. After `untilJump` steps, if that is not 0,
  /// it continues from a note near p, once.
  Mesh::Slot walkFrom(Index p, Mesh::Slot hint, unsigned untilJump)
  {
    return isGhost(hint) ? walkAlongHull(p, hint, untilJump) : walk(p, hint, untilJump);
  }

  bool isGhost(Mesh::Slot slot) const
  {
    return data_[slot] == ghost_ || data_[slot + 1] == ghost_ || data_[slot + 2] == ghost_;
  }
  /// Of a finite triangle.
  bool isHullEdge(Mesh::Halfedge h) const { return data_[data_[h + Mesh::kTwin]] == ghost_; }

  AHD_NEVER_INLINE Mesh::Slot walkAlongHull(Index p, Mesh::Slot ghost, unsigned untilJump);

  /// Is p strictly on the right of the line from a to b?
  bool isRightOf(const Corner& a, const Corner& b, Index p)
  {
    const double area = cross(a, b);
    return orientIsCertain(area, a.z, b.z) ? area < 0 : orientation(a.vertex, b.vertex, p) < 0;
  }

  /// Visibility walk: leave a triangle by an edge that has p strictly behind it, never back by the
  /// edge one came in by. It ends, as the triangulation is regular (Edelsbrunner 1990), in the
  /// triangle p lies in or on, or in a ghost that sees p: both are in conflict with p.
  Mesh::Slot walk(Index p, Mesh::Slot start, unsigned untilJump)
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
    return walkAcross(p, h, a, b, untilJump);
  }

  /// The walk goes on: p lies strictly behind half-edge `crossed`, which runs from a to b.
  Mesh::Slot walkAcross(Index p, Mesh::Halfedge crossed, Corner a, Corner b, unsigned untilJump)
  {
    for (;;)
    {
      if (!spend())
      {
        return kCancelled;
      }
      if (!kShared && --untilJump == 0)
      {
        const Mesh::Slot start = noted(p, std::min(a.z, b.z));
        if (start != kNoIndex)
        {
          return walkFrom(p, start, 0);
        }
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

  //--- jumps --------------------------------------------------------------------------------------
  //
  // A walk is long where successive points of the order are far from each other: the curve left a
  // region with points and came into another one. The ranks before that of p lie in the former,
  // those after it in the latter. So triangles at control points are noted by rank, and a walk that
  // turns out long continues from notes for the ranks after p (jump and walk: Mücke, Saias,
  // Zhu 1996).

  /// Where the k-th note stands: in a number of a slot that is not used.
  static std::size_t placeOfNote(std::size_t k) { return Mesh::slotOfTriangle(k) + 7; }
  AHD_NEVER_INLINE Mesh::Slot noted(Index p, double squaredDistance) const;
  bool isWithin(double squaredRadius, Index p, Mesh::Slot slot) const;

  //--- cavity and star ----------------------------------------------------------------------------

  template <bool kInside>
  Insertion carve(const Cavity& cavity, Mesh::Slot& hint);
  bool closingInConflict(const Root& root, Mesh::Halfedge twin, const VectorPair& at, Index p);
  template <bool kInside>
  Removed waitingAt(Mesh::Slot place, Pair at, const VectorPair& towards) const;
  /// Which of two triangles are in conflict with p, by the filter or, on a grid, exactly.
  AHD_ALWAYS_INLINE InCirclePair test(const EdgePair& edges, const LiftedPair& apices) const
  {
    return kExact ? perturbedInCircle(edges, apices, both(guard_), exactly_)
                  : inCircle(edges, apices, both(squaredGuard_));
  }
  AHD_NEVER_INLINE unsigned decide(InCirclePair seen, Mesh::Slot place, Index apex, Beyond beyond);
  void takeBack(std::size_t splits);
  Mesh::Slot hintOutside(Index next, Mesh::Slot ghost) const;
  AHD_NEVER_INLINE Mesh::Slot hintOnHull(Index next, Mesh::Slot hint) const;

  /// What lies beyond the edges after and before h of its triangle. Of a ghost with an apex that is
  /// not owned one of these may belong to others whole: nothing is read there, and carve() ends.
  template <bool kInside>
  AHD_ALWAYS_INLINE Beyond beyond(Mesh::Halfedge h) const
  {
    if (kShared && !kInside && !owns(data_[h]))
    {
      return {};
    }
    const Mesh::Halfedge first = (data_ + Mesh::next(h))[Mesh::kTwin];
    const Mesh::Halfedge second = (data_ + Mesh::previous(h))[Mesh::kTwin];
    return { first, second, data_[first], data_[second] };
  }

  /// Of the star's triangles on the edges of a root.
  struct RootPlaces
  {
    Mesh::Slot ab, bc, ca;
  };
  static Mesh::Slot firstHint(
    const RootPlaces& places, unsigned behind, unsigned ofAB, unsigned ofBC);
  void openStar(const Cavity& cavity, const Root& root, Mesh::Halfedge closingTwin);
  Mesh::Slot split(const Removed& removed, Index p);

  void link(Mesh::Halfedge a, Mesh::Halfedge b)
  {
    (data_ + a)[Mesh::kTwin] = b;
    (data_ + b)[Mesh::kTwin] = a;
  }

  void countRemoved()
  {
    if (kCount)
    {
      ++work_.trianglesRemoved;
    }
  }

  //--- predicates where the filter does not decide ------------------------------------------------

  /// Is p in conflict with the triangle a, b, c? One of them may be the ghost. The slow path.
  AHD_NEVER_INLINE bool conflicts(Index a, Index b, Index c, Index p);
  /// The same without the tighter filter.
  AHD_NEVER_INLINE bool conflictsExactly(Index a, Index b, Index c, Index p);
  bool conflictsWithGhost(Index from, Index to, Index p);
  AHD_NEVER_INLINE int orientation(Index a, Index b, Index p);

  //--- steps --------------------------------------------------------------------------------------

  /// One bounded step is about to be taken. False: the caller wants to cancel.
  bool spend() { return --budget_ != 0 || refill(); }
  /// So many were taken.
  bool spend(std::size_t steps)
  {
    budget_ -= std::min(budget_, steps);
    return budget_ != 0 || refill();
  }
  bool refill();
  /// An exact answer is about to be asked for, within a step.
  void spendOnExact() { budget_ -= budget_ > kStepsOfExact ? kStepsOfExact : budget_ - 1; }

  const Point* xy_;
  double guard_;        ///< what underflow may cost an in-circle determinant (see Filters.h)
  double squaredGuard_; ///< the same of its square (see FilterPairs.h)
  Exactly exactly_;
  std::uint32_t* data_;
  Index ghost_;
  Territory territory_;
  Ticker& ticker_;
  /// Of the star in work: the edges across which the split ones were met.
  std::array<Mesh::Halfedge, kShared ? kMostSplits : 1> splits_;
  bool isOutside_ = false; ///< the last hint was a ghost, or a walk ended in one
  bool takesNotes_ = false;
  std::size_t budget_ = kStepsPerRefill;
  std::size_t refills_ = 0;
  std::size_t insertedSinceAsking_ = 0;
  InsertionWork work_;
};

} // namespace AHD_TARGET
} // namespace ahd

#endif
