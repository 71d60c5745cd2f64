// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Sample_h
#define ahd_Sample_h

#include "../Core/Buffer.h"
#include "../Core/Context.h"
#include "../Core/Fields.h"
#include "../Points/Points.h"
#include "../Result.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <tuple>

namespace ahd
{

class Triangulation;

/// The vertices that determine the value at a place, and their weights.
enum class SampleMethod
{
  Linear = 0,          ///< the corners of its triangle, by areas
  NaturalNeighbor = 1, ///< those it would be joined to, by the area taken from their Voronoi cells
  Laplace = 2,         ///< the same vertices, by the length of their cells' borders over distances
  Nearest = 3          ///< the nearest vertex; of several the lexicographically smallest (x, y)
};

/// What places outside of the surface have.
enum class OutsideValues
{
  None,
  NearestVertex, ///< the value by SampleMethod::Nearest
  Boundary       ///< the value at the nearest place of the surface
};

/// Places in rows: number row * columns + column is origin + (firstColumn + column, firstRow + row)
/// * spacing, products and sums rounded. So the places of a piece of a raster are those of the
/// whole one.
///
/// @pre column and row numbers are less than 2^53
struct SampleRaster
{
  Point at(std::size_t column, std::size_t row) const
  {
    return { origin.x + double(firstColumn + column) * spacing.x,
      origin.y + double(firstRow + row) * spacing.y };
  }

  auto fields() { return std::tie(origin, spacing, columns, rows, firstColumn, firstRow); }

  Point origin{ 0.0, 0.0 };
  Point spacing{ 1.0, 1.0 };
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::size_t firstColumn = 0;
  std::size_t firstRow = 0;
};

/// The places to interpolate at: points (borrowed) or a raster.
class SamplePlaces
{
public:
  explicit SamplePlaces(const PointView& points)
    : points_(points)
  {
  }
  /// @pre columns * rows fits into a std::size_t
  explicit SamplePlaces(const SampleRaster& raster)
    : raster_(raster)
    , isRaster_(true)
  {
  }

  bool isRaster() const { return isRaster_; }
  const SampleRaster& raster() const { return raster_; }
  const PointView& points() const { return points_; }
  std::size_t count() const { return isRaster_ ? raster_.columns * raster_.rows : points_.count; }
  Point operator[](std::size_t k) const
  {
    return isRaster_ ? raster_.at(k % raster_.columns, k / raster_.columns) : points_[k];
  }

private:
  PointView points_;
  SampleRaster raster_;
  bool isRaster_ = false;
};

/// Values to interpolate: `components` doubles for each point of the triangulation, and as many to
/// write for each place.
struct SampleArray
{
  const double* values = nullptr; ///< by the caller's ids
  std::size_t components = 1;
  double* out = nullptr;
  /// Null, or with Linear the slopes: x and y of each component for each place.
  double* gradients = nullptr;
};

/// The outcome for the places.
struct SampleReport
{
  std::size_t valued = 0;    ///< on the surface, or any with Nearest
  std::size_t outside = 0;   ///< outside of the hull, in a hole or a dropped triangle
  std::size_t notFinite = 0; ///< with a NaN or infinite x or y
  /// Components of valued places that are NaN because of NaN values (with NaturalNeighbor and
  /// Laplace, where all weighted ones are NaN).
  std::size_t withoutValue = 0;
  /// Components of valued places without some neighbours, whose values are NaN.
  std::size_t leftOut = 0;

  std::size_t places() const { return valued + outside + notFinite; }

  auto fields() { return std::tie(valued, outside, notFinite, withoutValue, leftOut); }
};
static_assert(listsAll<SampleReport>());

/// The points and weights of the value at each place, for callers that interpolate themselves.
struct SampleWeights
{
  Buffer<std::uint64_t> offsets; ///< place k has the entries offsets[k] .. offsets[k + 1] - 1
  Buffer<std::int32_t> points;   ///< ids; of a place each once
  Buffer<double> weights;        ///< not negative; those of a place sum to 1, up to rounding
};

/// Values at any places of a triangulation, from those at its points.
///
/// - Exact place: the triangle, edge or vertex of a place is decided exactly. A vertex has its own
///   value (of several points, that of the representing one), an edge that of its two ends, the
///   same from either side.
/// - Values are sums of weights * values, never beyond the values at the vertices but for rounding.
/// - A place outside by no more than rounding (Predicates/Distances.h, roundingAt()) has the value
///   at the nearest place of the surface: decided exactly, for each of its edges.
/// - Farther outside of the kept triangles there is no value: the mask is 0, values are NaN.
/// - A function of points, constraints, `kept` and place alone: independent of threads, of other
///   places, and of raster or points.
///
/// *Linear*: weights are right to some 1e-12, whatever the triangle's shape. A NaN at a corner
/// makes all of the triangle NaN, and its edges and vertices at that corner.
///
/// *NaturalNeighbor*, *Laplace*: Sibson's and Laplace's coordinates, both linear where the values
/// are. The cavity ends at constraint edges and dropped triangles as at the hull; on such edges the
/// value is linear between the ends, the limit from either side. Neighbours with a NaN are left out
/// and the other weights grow in proportion; so close to such a neighbour that no other has a
/// weight there is no value. Weights are right to some 1e-12 for all finite coordinates, before any
/// are left out. A place that needs more bits than a double takes longer: mostly some microseconds,
/// milliseconds if exponents are hundreds of powers of two apart.
///
/// *Nearest*: everywhere, of the vertices that can be reached in a straight line which does not
/// leave the surface through a wall, a constraint edge with a kept triangle on one side and one
/// that is not kept on the other. From a place outside the line may enter the surface. Vertices all
/// of whose triangles loops or trim() dropped do not count.
///
/// Collinear vertices: Linear, NaturalNeighbor and Laplace are linear between neighbours on the
/// line, without a value elsewhere; one vertex has a value at its place alone.
///
/// Example:
///
///     ahd::Sampler sampler;
///     ahd::SampleReport report;
///     ahd::SampleArray heights{ z, 1, out };
///     ahd::Status s = sampler.prepare(made, nullptr, ahd::SampleMethod::Linear, context);
///     if (s == ahd::Status::Ok) s = sampler.values(places, &heights, 1, mask, report, context);
class Sampler
{
public:
  Sampler();
  ~Sampler();
  Sampler(Sampler&&) noexcept;
  Sampler& operator=(Sampler&&) noexcept;

  /// Begins with a surface and makes the tables needed.
  ///
  /// @pre `surface` outlives this, and nothing else makes tables of it or writes it from now on
  ///   (its memory for the vertices' places may be reused)
  /// @param kept one byte per triangle, as in a Selection (borrowed); null: see isKept()
  /// @return Ok, Cancelled or OutOfMemory; unless Ok, there is no surface
  Status prepare(
    Triangulation& surface, const unsigned char* kept, SampleMethod method, const Context& context);

  /// Is it prepared for SampleMethod::Nearest?
  bool isNearest() const;

  // For several threads at once, each with its own results. Return Ok, Cancelled or OutOfMemory;
  // unless Ok, the outputs are undefined. Without a surface all places are outside.

  /// Interpolates `count` arrays. Time: the logarithm of their number for each place, to sort them,
  /// and some steps of a walk; for Linear on a raster, a few steps per triangle and a part of one
  /// per place.
  ///
  /// @param mask null, or a byte for each place, 1 where it has a value
  Status values(const SamplePlaces& places, const SampleArray* arrays, std::size_t count,
    unsigned char* mask, SampleReport& report, const Context& context) const;

  /// The same for places outside, which have the values at the nearest place of the surface; of
  /// several the one on the edge whose ends come first. Nothing else counts them as outside.
  ///
  /// @pre prepared for another method than Nearest
  Status valuesAtRim(const SamplePlaces& places, const SampleArray* arrays, std::size_t count,
    SampleReport& report, const Context& context) const;

  /// The weights alone. `report` counts places only.
  Status weights(const SamplePlaces& places, SampleWeights& out, SampleReport& report,
    const Context& context) const;

private:
  struct State;
  template <typename Visit>
  Status visit(const SamplePlaces& places, const SampleArray* arrays, std::size_t count,
    unsigned char* mask, const Context& context, const Visit& work) const;

  std::unique_ptr<State> state_;
};

/// Upper bound of the bytes that a Sampler takes beside the tables of the triangulation
/// (tableMemoryEstimate) and the outputs: prepare() for this many points and values() for these
/// places, `components` of all arrays together, at least one of each.
///
/// Not counted: 1024 bytes per thread; and with NaturalNeighbor and Laplace 64 KiB more where a
/// place needs more bits than two doubles have, and at most 450 bytes for each neighbour of a
/// place, for the largest number of neighbours on each thread. Mostly that is negligible: a place
/// has some six neighbours, and many only amidst points on a circle.
std::size_t sampleMemoryEstimate(
  std::size_t pointCount, const SamplePlaces& places, std::size_t components);

} // namespace ahd

#endif
