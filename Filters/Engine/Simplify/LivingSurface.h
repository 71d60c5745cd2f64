// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_LivingSurface_h
#define ahd_LivingSurface_h

#include "../Core/AskedMemory.h"
#include "../Living/LivingMesh.h"
#include "Candidates.h"

#include <cstddef>
#include <vector>

namespace ahd
{

/// The surface of the points kept, and the other points in lists of the triangles that they lie in.
///
/// A point on an edge belongs to the triangle on the left of the edge, from its lexicographically
/// smaller end to the larger one; on the hull, to the one that there is. So where a point is listed
/// is a function of the mesh.
class LivingSurface
{
public:
  using Slot = LivingMesh::Slot;
  using Vertex = LivingMesh::Vertex;

  /// Bytes a point: its vertex, the list, and room to move it.
  static constexpr std::size_t kBytes = 4 + 4 + 8;
  /// Bytes for so many vertices.
  static constexpr std::size_t bytesFor(std::size_t vertices)
  {
    return LivingMesh::bytesFor(vertices) +
      (vertices + 2) *
      (2 * (sizeof(Worst) + 2 * sizeof(Index) + 1) + sizeof(Index) + sizeof(double));
  }

  /// Of a triangle: its point of the largest error, of several the lexicographically smallest. Of
  /// infinite errors, the nearest to a corner without a value: few such points, once kept, take all
  /// others out of triangles with that corner.
  struct Worst
  {
    double error;
    Index rank; ///< kNoIndex if it has no point
  };

  LivingSurface(const Candidates& candidates, double bound, Ticker& ticker);

  /// The surface of the points that stay, with their constraints. Functions that return a bool
  /// return false if cancelled, and may throw std::bad_alloc. @pre there is a triangle
  bool begin();
  /// The surface as it was when so many points were kept, or is; nothing is listed.
  bool goBackTo(std::size_t kept);
  /// The segments that begin() or goBackTo() left out, as they cross earlier ones: where they do so
  /// at a point that is kept later, they do not cross them any more.
  const std::vector<std::size_t>& crossing() const { return crossing_; }
  /// Adds the points whose rank is, or is not, a multiple of the step to the lists.
  bool list(Index step, bool isMultiple);

  const LivingMesh& mesh() const { return mesh_; }
  const Candidates& candidates() const { return candidates_; }
  bool isKept(Index rank) const { return vertexOf_[rank] != kNoIndex; }
  std::size_t kept() const { return candidates_.staying().size() + order_.size(); }
  /// Those kept beside the ones that stay, in the order in which they were.
  const std::vector<Index>& order() const { return order_; }
  const Worst& worst(Slot s) const { return worst_[s / Mesh::kSlotSize]; }
  bool isTouched(Slot s) const { return isTouched_[s / Mesh::kSlotSize] != 0; }

  void touchAll();
  /// Measures with 100 bits from now on, where doubles are not certain to be within the bound.
  /// All triangles become touched.
  void measureWide(double bound);

  /// Makes room for so many more points to be kept.
  void expect(std::size_t more);
  /// Keeps a point; its triangle was or is near the hint. Those around it, and their points, wait
  /// for settle().
  void keep(Index rank, Slot hint);
  /// Lists the points that wait, and measures the triangles that were touched.
  bool settle();
  /// The triangles touched since the last clearTouched().
  const std::vector<Slot>& touched() const { return touched_; }
  void clearTouched();

  /// Takes points out again if all around them, and they, stay within the bound; the one kept last
  /// first.
  bool dropWhatMayGo();

private:
  struct Waiting
  {
    Index rank;
    Slot slot; ///< near to it, then the one that has it
  };

  Index firstOf(Slot s) const { return first_[s / Mesh::kSlotSize]; }
  Interpolant interpolantOf(Slot s) const;
  double measure(const Interpolant& interpolant, Index rank) const;
  Slot ownerOf(const LivingMesh::Spot& spot) const;
  bool begin(const std::vector<Index>& ranks);
  bool addSome(const std::vector<Index>& ranks, std::size_t step);
  void setVertex(Index rank, Vertex v);
  bool constrain();
  void growLists();
  void touch(Slot s);
  void takeList(Slot s);
  bool findOwners();
  bool measureTouched();
  double squaredDistanceFromUnknown(Slot s, const Point& p) const;
  bool isWorse(Slot s, const Worst& a, const Worst& b) const;
  bool measureTriangle(Slot s, Ticker& ticker);
  void add(Index rank, Slot s);
  void takeStar(Vertex v);
  bool isStillWithin(Slot hint) const;
  bool tryToDrop(Index rank, bool& isDropped);

  const Candidates& candidates_;
  double bound_;
  bool isWide_ = false;
  Ticker& ticker_;
  GrowingMemory memory_;
  std::size_t room_ = 0; ///< for vertices

  LivingMesh mesh_;
  std::vector<Index> order_;
  std::vector<std::size_t> crossing_;
  std::vector<double> valueOf_; ///< by vertex
  Buffer<Index> vertexOf_;      ///< by rank; kNoIndex: not kept
  Buffer<Index> next_;          ///< by rank: the next one of its triangle
  std::vector<Index> first_;    ///< by slot
  std::vector<Worst> worst_;    ///< by slot
  std::vector<unsigned char> isTouched_;
  std::vector<Slot> touched_;
  std::vector<Waiting> waiting_;
};

} // namespace ahd

#endif
