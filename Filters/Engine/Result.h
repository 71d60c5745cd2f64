// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Result_h
#define ahd_Result_h

#include <cstddef>
#include <cstdint>
#include <tuple>

namespace ahd
{

/// How a run ended. Anything but Ok leaves no triangulation behind.
enum class Status
{
  Ok,            ///< done; fewer than three distinct points or all collinear is Ok with no triangle
  Cancelled,     ///< by the caller's Progress
  TooManyPoints, ///< more than kMaximumPoints
  TooManyBoxes,  ///< more than Options::mostBoxes
  TooManyCrossings, ///< more than InputRequest::mostCrossings
  OutOfMemory,      ///< an allocation failed
  BadCells,         ///< offsets of cells do not ascend within their ids (findBadCell())
  BadPolygon,       ///< the one to clip Voronoi cells at has a PolygonFault
  BadSettings       ///< two settings of a run exclude each other
};

/// The status of a point, as Triangulation::writePointStatus writes it: its own id if it stands for
/// a vertex, the id of the point that does (Options::representative) if it is a duplicate, or one
/// of these.
enum : std::int64_t
{
  kStatusNotFinite = -1, ///< x or y is NaN or infinite
  /// left out at the caller's request (PointView::skip), beyond the limit, or a duplicate of a
  /// point beyond it
  kStatusNotInserted = -2,
  /// left out of a simplified surface, or a duplicate of a point that was; written by Run only
  kStatusWithinError = -3
};

/// Written by Triangulation::writeInsertionRanks for a point that is not in the order.
enum : std::int64_t
{
  kRankNone = -1
};

/// A box of the grid that was not divided, as the insertion order visits it. A point on the border
/// of two boxes belongs to the one of larger x (or y).
struct GridBox
{
  double xmin, xmax, ymin, ymax;
  int level;         ///< divisions that made it: 0 for the box of all points, if it is not divided
  std::size_t count; ///< distinct points in it, control points and those beyond the limit included
};

/// Counts of one run. inserted + beyondLimit + duplicates + notFinite + skipped = number of points
/// given.
struct Report
{
  std::size_t inserted = 0;    ///< points that are vertices
  std::size_t beyondLimit = 0; ///< distinct points that Options::insertionLimit left out
  std::size_t duplicates = 0; ///< points with the same x, y as the point that represents the vertex
  std::size_t notFinite = 0;  ///< points with a NaN or infinite x or y
  std::size_t skipped = 0;    ///< points left out at the caller's request
  std::size_t triangles = 0;  ///< triangles of the result

  // Removed by trim().
  std::size_t trimmed = 0;      ///< triangles
  std::size_t bareVertices = 0; ///< vertices left in no triangle
  double trimmedArea = 0.0;     ///< of those triangles, as a part of the convex hull's; rounded

  // Work, counted if Options::countWork is set, else 0.
  std::uint64_t trianglesWalked = 0;  ///< triangles tested while locating, the start included
  std::uint64_t trianglesRemoved = 0; ///< triangles removed by cavities, ghosts included
  std::uint64_t exactInCircle = 0;    ///< in-circle tests the floating-point filter left open
  std::uint64_t exactOrient = 0;      ///< orientation tests the floating-point filter left open

  // How the insertion was shared by threads; always counted. Insertions tried: a point that one
  // part defers, because its cavity reaches into others, is tried again by a larger part.
  std::uint64_t insertionAttempts = 0; ///< of all threads; `inserted` if there was one thread
  std::uint64_t deferredPoints = 0;    ///< attempts that ended in deferring the point
  /// Attempts one after the other: in each pass of each round, those of the busiest thread, tasks
  /// going to the first free thread.
  std::uint64_t criticalPath = 0;

  /// The paper's NP: triangles tested to locate a point, per inserted point.
  double np() const { return perPoint(trianglesWalked); }
  /// The paper's NR: triangles removed, per inserted point.
  double nr() const { return perPoint(trianglesRemoved); }

  auto fields()
  {
    return std::tie(inserted, beyondLimit, duplicates, notFinite, skipped, triangles, trimmed,
      bareVertices, trimmedArea, trianglesWalked, trianglesRemoved, exactInCircle, exactOrient,
      insertionAttempts, deferredPoints, criticalPath);
  }

private:
  double perPoint(std::uint64_t n) const
  {
    return inserted == 0 ? 0.0 : double(n) / double(inserted);
  }
};

} // namespace ahd

#endif
