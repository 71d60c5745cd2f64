// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Sample_h
#define ahd_Sample_h

#include "../Core/Buffer.h"
#include "../Core/Context.h"
#include "../Points/Points.h"
#include "../Result.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

namespace ahd
{

class Triangulation;

/// Which vertices have a say in the value at a place, and how much.
enum class SampleMethod
{
  Linear = 0,          ///< the corners of its triangle, by areas
  NaturalNeighbor = 1, ///< those it would be joined to, by the area it takes of their Voronoi cells
  Laplace = 2,         ///< the same vertices, by the length of their cells' borders over distances
  Nearest = 3          ///< the nearest vertex; of several the lexicographically smallest (x, y)
};

/// Places in rows: number row * columns + column is origin + (firstColumn + column, firstRow + row)
/// * spacing, the products and the sums rounded. So the places of a piece of a raster are those of
/// the whole one. REQUIRES: column and row numbers are less than 2^53.
struct SampleRaster
{
  Point at(std::size_t column, std::size_t row) const
  {
    return { origin.x + double(firstColumn + column) * spacing.x,
      origin.y + double(firstRow + row) * spacing.y };
  }

  Point origin{ 0.0, 0.0 };
  Point spacing{ 1.0, 1.0 };
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::size_t firstColumn = 0;
  std::size_t firstRow = 0;
};

/// Where values are wanted: at points, or on a raster. Borrows the points.
class SamplePlaces
{
public:
  explicit SamplePlaces(const PointView& points)
    : points_(points)
  {
  }
  /// REQUIRES: columns * rows is a std::size_t.
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

/// Values to interpolate: `components` doubles for each point of the triangulation, and as many
/// for each place, to be written.
struct SampleArray
{
  const double* values = nullptr; ///< by the caller's ids
  std::size_t components = 1;
  double* out = nullptr;
  /// Null, or with Linear the slopes: x and y of each component for each place.
  double* gradients = nullptr;
};

/// What became of the places. valued + outside + notFinite = their number.
struct SampleReport
{
  std::size_t valued = 0;    ///< on the surface, or any with Nearest
  std::size_t outside = 0;   ///< outside of the hull, in a hole or a dropped triangle
  std::size_t notFinite = 0; ///< with a NaN or infinite x or y
  /// Components of valued places that are NaN, as values there are (with NaturalNeighbor and
  /// Laplace, all that have a weight).
  std::size_t withoutValue = 0;
  /// Components of valued places that some neighbours, whose values are NaN, were left out of.
  std::size_t leftOut = 0;
};

/// Which points make up the value at each place, for who interpolates himself.
struct SampleWeights
{
  Buffer<std::uint64_t> offsets; ///< place k has the entries offsets[k] .. offsets[k + 1] - 1
  Buffer<std::int32_t> points;   ///< ids; of a place each once
  Buffer<double> weights;        ///< not negative; those of a place sum to 1, up to rounding
};

/// Values at any places of a triangulation, from those at its points.
///
/// Contract. Which triangle, edge or vertex a place lies on is decided exactly: on a vertex the
/// value is that of the vertex (of several points there, that of the one that stands for it), on an
/// edge it depends on its two ends alone and is the same from either side. Values are those of
/// `out` = sum of weights * values, never beyond the values at the vertices but for rounding.
/// Outside of the kept triangles there is no value: the mask is 0, values are NaN.
///
/// *Linear*: weights are right to some 1e-12, whatever the triangle's shape. A NaN at a corner is
/// one in all of the triangle, and on the edges and vertices that have it.
/// *NaturalNeighbor*, *Laplace*: Sibson's and Laplace's coordinates. Both are linear where the
/// values are. The cavity ends at constraint edges and at dropped triangles as at the hull; on such
/// edges the value is linear between the ends, which is the limit from either side. Neighbours with
/// a NaN are left out and the other weights grow in proportion; so close to such a neighbour that
/// no other has a weight there is no value. Weights are right to some 1e-12 for all finite
/// coordinates, before any are left out. Where that takes more bits than a double has a place takes
/// longer: mostly some microseconds, milliseconds where exponents are hundreds of powers of two
/// apart.
/// *Nearest*: of all vertices, whatever the triangles; everywhere.
///
/// All vertices collinear: Linear, NaturalNeighbor and Laplace are linear between neighbours on
/// their line, and have no value elsewhere; one vertex: at its place alone.
///
/// Results are a function of points, constraints, `kept` and place alone: not of the threads, of
/// the other places or of whether these are a raster.
class Sampler
{
public:
  Sampler();
  ~Sampler();
  Sampler(Sampler&&) noexcept;
  Sampler& operator=(Sampler&&) noexcept;

  /// Begins with a surface, which is to outlive this, and of which nothing is to be made or written
  /// from now on (it may use the memory of the vertices' places). Makes the tables that are needed.
  /// `kept`: one byte per triangle, as in a Selection (borrowed); null: see isKept(). Returns Ok,
  /// Cancelled or OutOfMemory; unless Ok, there is no surface.
  Status prepare(
    Triangulation& surface, const unsigned char* kept, SampleMethod method, const Context& context);

  // By several threads at once, each with its own results. Return Ok, Cancelled or OutOfMemory;
  // unless Ok, what was to be written is not to be used. Without a surface all places are outside.

  /// Interpolates `count` arrays. `mask`: null, or a byte for each place, 1 where it has a value.
  /// Time: the logarithm of their number for each place, to put them in order, and some steps of a
  /// walk; for Linear on a raster, a few steps for each triangle and a part of one for each place.
  Status values(const SamplePlaces& places, const SampleArray* arrays, std::size_t count,
    unsigned char* mask, SampleReport& report, const Context& context) const;

  /// The weights alone. `report` counts places only.
  Status weights(const SamplePlaces& places, SampleWeights& out, SampleReport& report,
    const Context& context) const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Upper estimate of the bytes that a Sampler takes besides the tables of the triangulation
/// (tableMemoryEstimate) and what it is given to write to: prepare() for so many points and
/// values() for so many places, `components` of all arrays together, at least one of each.
///
/// Not counted: for each thread 1024 bytes; and with NaturalNeighbor and Laplace 64 KiB more where
/// a place asks for more bits than two doubles have, and at most 450 bytes for each neighbour of a
/// place, the most that a place has on each thread. Mostly that is nothing: a place has some six
/// neighbours, and many only amidst points on a circle.
std::size_t sampleMemoryEstimate(
  std::size_t pointCount, const SamplePlaces& places, std::size_t components);

} // namespace ahd

#endif
