// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_InputArrays_h
#define ahd_InputArrays_h

#include "../Core/Context.h"
#include "../Options.h"
#include "Run.h"
#include "Words.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

/// The caller's numbers in rows and columns; strides in bytes. Type 0: no array.
struct GivenArray
{
  const void* data;
  std::int32_t type; ///< NumberType
  std::int32_t columns;
  std::int64_t rows, rowStride, columnStride;
};

/// In the order of the table in InputArrays.cxx.
enum class InputArray : std::size_t
{
  Points,
  Skip,
  SourcePoints,
  LineIds,
  LoopIds,
  LineOffsets,
  LoopOffsets,
  Matrix,
  VoronoiPolygon,
  Surface,
  SurfaceEdges,
  RankBounds,
  Cells,
  CellOffsets,
  CellGroups,
  Values,
  Weights,
  Keep
};
constexpr std::size_t kInputArrays = std::size_t(InputArray::Keep) + 1;

/// The arrays given to a job, read in place. Invalid ones are refused.
class InputArrays
{
public:
  /// A null array removes it.
  void set(const char* name, const GivenArray* array);

  /// Null past the last.
  static const char* name(std::size_t number);

  const GivenArray& operator[](InputArray array) const { return arrays_[std::size_t(array)]; }
  bool has(InputArray array) const { return (*this)[array].type != 0; }

  /// Sets the counts of points, cells, ids and triangles, without reading numbers. Refuses
  /// inconsistent arrays.
  void count(InputRequest& request) const;
  /// The same of chains or cells.
  CellsView countCells(InputArray ids, InputArray offsets) const;

  /// Bytes of the copies that OpenInput makes.
  std::size_t copiedBytes() const;

  /// Row by row. @pre has(InputArray::Matrix).
  std::array<double, 16> matrix() const;
  /// The corners; none if there is no such array.
  std::vector<Point> voronoiPolygon() const;
  /// Empty if there is no such array.
  RankBounds rankBounds() const;

  /// Refuses what cannot be the array "points".
  static void checkPoints(const GivenArray& array);

private:
  void countSurface(GivenTriangles& surface) const;
  void checkNumbers() const;

  std::array<GivenArray, kInputArrays> arrays_ = {};
};

/// The arrays as the engine reads them, with copies of those that it cannot read in place. Its
/// views stay valid when it is moved.
class OpenInput
{
public:
  /// Opens points, source points, marks and numbers; throws std::bad_alloc, and refuses if
  /// cancelled.
  void openPoints(const InputArrays& arrays, const Context& context);
  /// Opens lines and loops, and refuses offsets that do not ascend within the ids.
  void openCells(const InputArrays& arrays, const Context& context);
  /// Opens the triangles of a surface, if there are any, and marks the points that are no corner in
  /// place of those that were marked.
  void openSurface(const InputArrays& arrays, const Context& context);
  /// Opens cells and their groups, and refuses offsets as above.
  void openPolygons(const InputArrays& arrays, const Context& context);

  PointView points;
  PointView sourcePoints;
  PointNumbers numbers;
  CellsView lines;
  CellsView loops;
  GivenTriangles surface;
  CellsView polygons;
  const double* groups = nullptr; ///< of these, or null

private:
  struct Copies
  {
    std::vector<double> doubles;
    std::vector<float> floats;
  };
  struct CellCopies
  {
    std::vector<std::int32_t> offsets32, ids32;
    std::vector<std::int64_t> offsets64, ids64;
  };
  static PointView open(const GivenArray& array, Copies& copies, const Context& context);
  static NumbersView openNumbers(const GivenArray& array, Copies& copies, const Context& context);
  static CellsView open(const InputArrays& arrays, InputArray ids, InputArray offsets,
    CellCopies& copies, const Context& context);

  friend class OpenPoints;

  Copies pointCopies_, sourceCopies_, valueCopies_, weightCopies_;
  std::vector<unsigned char> marks_, keptMarks_;
  CellCopies lineCopies_, loopCopies_, surfaceCopies_, polygonCopies_;
  std::vector<double> groupCopies_;
  std::vector<unsigned char> edges_, others_;
};

/// Points that are no input of the job: a view of them. Further columns than z are left out.
/// Refuses what is no array of points.
class OpenPoints
{
public:
  OpenPoints(GivenArray array, const Context& context)
  {
    array.columns = array.columns > 3 ? 3 : array.columns;
    InputArrays::checkPoints(array);
    view = OpenInput::open(array, copies_, context);
  }

  PointView view;

private:
  OpenInput::Copies copies_;
};

} // namespace ahd

#endif
