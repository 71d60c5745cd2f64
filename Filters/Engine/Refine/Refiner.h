// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Refiner_h
#define ahd_Refiner_h

#include "../Core/AskedMemory.h"
#include "Criteria.h"
#include "Domain.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// Inserts vertices until no piece is encroached and no triangle bad, or nothing can be done about
/// those that are.
///
/// What comes next depends on the mesh and the queues only, and those on places only: the sequence
/// is canonical.
class Refiner
{
public:
  using Vertex = Domain::Vertex;
  using Halfedge = Domain::Halfedge;
  using Slot = Domain::Slot;

  /// @pre domain.load()
  Refiner(Domain& domain, const RefineRequest& request, std::size_t most, Ticker& ticker);

  /// Returns false if cancelled. Throws std::bad_alloc.
  bool run();

  /// Does the triangle meet the request? If not, why? @pre inside
  bool isGood(Slot s, RefineReason& reason) const;
  /// Must the piece be split? @pre a constraint edge
  bool isEncroached(Halfedge h) const;

private:
  /// An edge (twice its second end) or a triangle, corners in lexicographic order.
  struct Item
  {
    double length; ///< of the edge or the shortest one
    Vertex corners[3];
    /// Where it was: the edge, or the triangle's slot, plus which of `corners` is opposite to its
    /// shortest edge.
    Halfedge at;
  };
  struct Triangle
  {
    Item item;
    Measured measured;
  };

  bool isFull() const;
  void lookAt(Slot s);
  void lookAtStar();
  Item itemOf(Halfedge piece) const;
  Triangle measure(Slot s) const;
  bool isAcrossInputAngle(Vertex p, Vertex q) const;
  bool isHidden(const Triangle& t) const;
  Halfedge pieceOf(const Item& item) const;
  bool isThere(const Item& item) const;
  bool isOpenTo(Halfedge h, const Point& p) const;
  bool isTooLong(Halfedge h) const;
  double splitFraction(Index segment, double from, double to) const;
  bool findSplit(Halfedge h, Point& place, double& fraction) const;
  bool hasRoom(Halfedge h, const Point& place) const;
  bool split(Halfedge h);
  bool splitAll(const std::vector<Halfedge>& pieces);
  bool isBefore(const Item& a, const Item& b) const;
  void findSharp();
  void findSharpAt(Vertex v);
  void improve(const Item& item);
  std::vector<Halfedge> piecesAgainst(const Point& centre, Slot s, LivingMesh::Spot& spot);
  Halfedge walk(Slot& s, const Point& to) const;
  LivingMesh::Spot spotIn(Slot s, const Point& p) const;
  void push(std::vector<Item>& queue, const Item& item);
  Item pop(std::vector<Item>& queue);

  Domain& domain_;
  const LivingMesh& mesh_;
  Criteria criteria_;
  Ticker& ticker_;
  GrowingMemory growing_;
  std::size_t most_;
  std::vector<Item> pieces_, bad_;   ///< heaps: the shortest first, then by places
  std::vector<unsigned char> sharp_; ///< by vertex of the input: segments meet there sharply
};

} // namespace ahd

#endif
