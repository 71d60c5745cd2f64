// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CertifiedMesh_h
#define ahd_CertifiedMesh_h

#include "Certifier.h"
#include "PlaceTable.h"
#include "Points/Points.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// Faults by kind: the first few in words, the others counted.
class FaultList
{
public:
  template <typename MakeText>
  void add(const char* kind, MakeText makeText)
  {
    if (++counts_[kind] <= kNamedFaults)
    {
      texts_.push_back(std::string(kind) + ": " + makeText());
    }
  }

  bool empty() const { return texts_.empty(); }

  Complaints all() const
  {
    Complaints result = texts_;
    for (const auto& kind : counts_)
    {
      if (kind.second > kNamedFaults)
      {
        result.push_back(
          kind.first + ": " + std::to_string(kind.second - kNamedFaults) + " more of this kind");
      }
    }
    return result;
  }

private:
  static constexpr std::size_t kNamedFaults = 5;
  std::map<std::string, std::size_t> counts_;
  Complaints texts_;
};

/// Triangles that are checked and linked on the way: the core of the certifiers. Borrows its
/// arguments.
class CertifiedMesh
{
public:
  static constexpr std::int32_t kNone = -1;

  /// A half-edge, 3 * triangle + place of its origin in it, found by its origin.
  struct Edge
  {
    std::int32_t target;
    std::int32_t halfEdge;
  };

  CertifiedMesh(const PointView& points, const std::vector<std::int32_t>& triples,
    const std::vector<std::int64_t>& pointStatus)
    : points_(points)
    , triples_(triples)
    , pointStatus_(pointStatus)
  {
  }

  /// Points 1 to 4 and 6 of certify(). False if pointStatus or corners are too wrong to use the
  /// rest.
  bool check();

  /// Point 5. `fixed`: by half-edge, those that need not be Delaunay; empty if all must be.
  void checkDelaunay(const std::vector<char>& fixed);

  FaultList& faults() { return faults_; }

  Point at(std::int32_t id) const { return points_[std::size_t(id)]; }
  bool isVertex(std::int32_t id) const { return pointStatus_[std::size_t(id)] == id; }
  std::size_t triangleCount() const { return triples_.size() / 3; }
  std::size_t halfEdgeCount() const { return triples_.size(); }
  std::int32_t origin(std::int32_t h) const { return triples_[std::size_t(h)]; }
  static std::int32_t next(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::int32_t previous(std::int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::int32_t target(std::int32_t h) const { return origin(next(h)); }
  std::int32_t apex(std::int32_t h) const { return origin(previous(h)); }
  /// The same edge seen from the other side; kNone on the hull.
  std::int32_t twin(std::int32_t h) const { return twin_[std::size_t(h)]; }
  std::int32_t findHalfEdge(std::int32_t from, std::int32_t to) const;

  /// The half-edges that leave a vertex, by target.
  const Edge* edgesBegin(std::int32_t v) const
  {
    return edges_.data() + firstEdge_[std::size_t(v)];
  }
  const Edge* edgesEnd(std::int32_t v) const
  {
    return edges_.data() + firstEdge_[std::size_t(v) + 1];
  }

  std::string name(std::int32_t id) const;
  std::string name(std::int32_t a, std::int32_t b) const;
  std::string triangleName(std::size_t t) const;

private:
  void checkPointStatus();
  std::int64_t rightStatus(PlaceTable& places, std::size_t i) const;
  void checkTriangles();
  void checkFlat();
  void collectEdges();
  void linkTriangles();
  void checkHull();
  std::vector<std::int32_t> hullSuccessors();
  void checkHullCorner(std::int32_t before, std::int32_t at, std::int32_t after);
  void checkUse();
  void checkConnected();

  const PointView& points_;
  const std::vector<std::int32_t>& triples_;
  const std::vector<std::int64_t>& pointStatus_;
  FaultList faults_;
  std::size_t vertexCount_ = 0;
  std::size_t hullSize_ = 0;
  std::int32_t hullStart_ = kNone;
  std::vector<std::int32_t> firstEdge_; ///< by vertex: its first place in edges_
  std::vector<Edge> edges_;             ///< by origin, then target
  std::vector<std::int32_t> twin_;      ///< by half-edge; kNone on the hull
};

} // namespace test
} // namespace ahd

#endif
