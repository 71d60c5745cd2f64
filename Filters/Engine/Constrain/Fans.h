// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Fans_h
#define ahd_Fans_h

#include "ConstrainedMesh.h"

#include <array>
#include <map>
#include <set>

namespace ahd
{

/// Some neighbours of vertices that have very many, by their directions: starting points for
/// turning around such a vertex. A remembered edge may no longer exist.
class Fans
{
public:
  explicit Fans(const ConstrainedMesh& mesh)
    : mesh_(mesh)
  {
  }

  /// Remembers an edge from the vertex `hub`. Throws std::bad_alloc.
  void remember(Index hub, Index neighbour);

  /// Edges from `hub` to the neighbours that are remembered next to the direction of `to`, on
  /// either side; kNoIndex where there is none, or none any more.
  std::array<Mesh::Halfedge, 2> find(Index hub, Index to);

private:
  /// Counterclockwise around the hub, from straight down on.
  struct ComesBefore
  {
    const ConstrainedMesh* mesh;
    Index hub;
    bool operator()(Index u, Index v) const;
  };
  using Fan = std::set<Index, ComesBefore>;

  Mesh::Halfedge edgeTo(Index hub, Index neighbour) const;

  const ConstrainedMesh& mesh_;
  std::map<Index, Fan> fans_;
};

} // namespace ahd

#endif
