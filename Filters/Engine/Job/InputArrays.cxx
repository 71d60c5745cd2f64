// SPDX-License-Identifier: BSD-3-Clause
#include "InputArrays.h"

#include "Refusal.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace ahd
{
namespace
{

constexpr std::int32_t kManyColumns = std::numeric_limits<std::int32_t>::max();

struct InputRow
{
  const char* name;
  unsigned types;
  std::int32_t leastColumns, mostColumns;
  const char* wanted;
  std::int64_t rows = 0; ///< 0: any number
};

// in the order of InputArray
constexpr InputRow kInputRows[] = {
  { "points", kRealTypes, 2, 3, "AHD_FLOAT32 or AHD_FLOAT64, of 2 or 3 columns" },
  { "skip", bitOf(kUint8), 1, 1, "AHD_UINT8, of one column" },
  { "source_points", kRealTypes, 2, 3, "AHD_FLOAT32 or AHD_FLOAT64, of 2 or 3 columns" },
  { "line_ids", kIntegerTypes, 1, kManyColumns, "AHD_INT32 or AHD_INT64" },
  { "loop_ids", kIntegerTypes, 1, kManyColumns, "AHD_INT32 or AHD_INT64" },
  { "line_offsets", kIntegerTypes, 1, 1, "AHD_INT32 or AHD_INT64, of one column" },
  { "loop_offsets", kIntegerTypes, 1, 1, "AHD_INT32 or AHD_INT64, of one column" },
  { "matrix", bitOf(kFloat64), 4, 4, "AHD_FLOAT64, of 4 rows and columns", 4 },
  { "voronoi_polygon", bitOf(kFloat64), 2, 2, "AHD_FLOAT64, of 2 columns" },
  { "surface", kIntegerTypes, 3, 3, "AHD_INT32 or AHD_INT64, of 3 columns" },
  { "surface_edges", bitOf(kUint8), 1, 1, "AHD_UINT8, of one column" },
  { "rank_bounds", bitOf(kFloat64), 2, 2, "AHD_FLOAT64, of 2 rows and columns", 2 },
  { "cells", kIntegerTypes, 1, kManyColumns, "AHD_INT32 or AHD_INT64" },
  { "cell_offsets", kIntegerTypes, 1, 1, "AHD_INT32 or AHD_INT64, of one column" },
  { "cell_groups", bitOf(kFloat64), 1, 1, "AHD_FLOAT64, of one column" },
  { "values", kRealTypes, 1, 1, "AHD_FLOAT32 or AHD_FLOAT64, of one column" },
  { "weights", kRealTypes, 1, 1, "AHD_FLOAT32 or AHD_FLOAT64, of one column" },
  { "keep", bitOf(kUint8), 1, 1, "AHD_UINT8, of one column" },
};
static_assert(sizeof(kInputRows) / sizeof(kInputRows[0]) == kInputArrays, "a row for each");

std::string quoted(InputArray array)
{
  return "\"" + std::string(kInputRows[std::size_t(array)].name) + "\"";
}

/// Would the distance of its first number from its last be no number of bytes?
bool isTooLarge(const GivenArray& array)
{
  constexpr double kMost = 0x1p62;
  const auto span = [](std::int64_t count, std::int64_t stride)
  { return double(count) * (stride < 0 ? -double(stride) : double(stride)); };
  return double(array.rows) * double(array.columns) > double(kMostNumbers) ||
    span(array.rows, array.rowStride) + span(array.columns, array.columnStride) > kMost;
}

/// Its error; empty if there is none.
std::string faultOf(const InputRow& row, const GivenArray& array)
{
  if ((bitOf(array.type) & row.types) == 0 || array.columns < row.leastColumns ||
    array.columns > row.mostColumns)
  {
    return "must be " + std::string(row.wanted) + ", not of type " + std::to_string(array.type) +
      " with " + std::to_string(array.columns) + " columns.";
  }
  if (array.rows < 0 || isTooLarge(array))
  {
    return "has " + std::to_string(array.rows) + " rows, or strides that fit in no memory.";
  }
  if (row.rows != 0 && array.rows != row.rows)
  {
    return "must have " + std::to_string(row.rows) + " rows, not " + std::to_string(array.rows) +
      ".";
  }
  return array.rows > 0 && !array.data ? "has rows, but its data is null." : std::string();
}

double realAt(const GivenArray& array, std::size_t row, std::size_t column)
{
  double number;
  std::memcpy(&number,
    static_cast<const unsigned char*>(array.data) +
      static_cast<std::int64_t>(row) * array.rowStride +
      static_cast<std::int64_t>(column) * array.columnStride,
    sizeof number);
  return number;
}

} // namespace

void InputArrays::set(const char* name, const GivenArray* array)
{
  const InputRow* const row = std::find_if(std::begin(kInputRows), std::end(kInputRows),
    [name](const InputRow& r) { return name && std::strcmp(r.name, name) == 0; });
  if (row == std::end(kInputRows))
  {
    refuse(Reason::UnknownName,
      "There is no input array \"" + std::string(name ? name : "(null)") + "\".");
  }
  const std::string fault = array ? faultOf(*row, *array) : std::string();
  if (!fault.empty())
  {
    refuse(Reason::BadArray, "\"" + std::string(name) + "\" " + fault);
  }
  arrays_[std::size_t(row - kInputRows)] = array ? *array : GivenArray();
}

void InputArrays::checkPoints(const GivenArray& array)
{
  const std::string fault = faultOf(kInputRows[std::size_t(InputArray::Points)], array);
  if (!fault.empty())
  {
    refuse(Reason::BadArray, "The array of points " + fault);
  }
}

const char* InputArrays::name(std::size_t number)
{
  return number < kInputArrays ? kInputRows[number].name : nullptr;
}

void InputArrays::count(InputRequest& request) const
{
  request.points.count = static_cast<std::size_t>((*this)[InputArray::Points].rows);
  request.sourcePoints.count = static_cast<std::size_t>((*this)[InputArray::SourcePoints].rows);
  checkNumbers();
  request.lines = countCells(InputArray::LineIds, InputArray::LineOffsets);
  request.polygons = countCells(InputArray::LoopIds, InputArray::LoopOffsets);
  countSurface(request.surface);
}

/// Refuses numbers of the points that are more or fewer than these; values may be those of the
/// source's, too.
void InputArrays::checkNumbers() const
{
  const std::int64_t points = (*this)[InputArray::Points].rows;
  for (const InputArray array :
    { InputArray::Skip, InputArray::Values, InputArray::Weights, InputArray::Keep })
  {
    const std::int64_t rows = (*this)[array].rows;
    const bool areOfAll = array == InputArray::Values &&
      rows == points + (*this)[InputArray::SourcePoints].rows;
    if (has(array) && rows != points && !areOfAll)
    {
      refuse(Reason::BadArray,
        quoted(array) + " has " + std::to_string(rows) + " rows, and \"points\" " +
          std::to_string(points) + ".");
    }
  }
}

/// It is what points, constraints and limits have made already.
void InputArrays::countSurface(GivenTriangles& surface) const
{
  surface = GivenTriangles();
  surface.count = static_cast<std::size_t>((*this)[InputArray::Surface].rows);
  const auto edges = static_cast<std::size_t>((*this)[InputArray::SurfaceEdges].rows);
  if (has(InputArray::SurfaceEdges) && edges != surface.count)
  {
    refuse(Reason::BadArray,
      quoted(InputArray::SurfaceEdges) + " has " + std::to_string(edges) + " rows, and " +
        quoted(InputArray::Surface) + " " + std::to_string(surface.count) + ".");
  }
  const bool isAlone = (*this)[InputArray::SourcePoints].rows == 0 &&
    (*this)[InputArray::LineIds].rows == 0 && (*this)[InputArray::LoopIds].rows == 0;
  if (surface.count > 0 && !isAlone)
  {
    refuse(Reason::BadArray,
      quoted(InputArray::Surface) + " goes with no source points, lines or loops.");
  }
}

CellsView InputArrays::countCells(InputArray idArray, InputArray offsetArray) const
{
  const GivenArray& ids = (*this)[idArray];
  const GivenArray& offsets = (*this)[offsetArray];
  CellsView cells;
  cells.ids = static_cast<std::size_t>(ids.rows) * static_cast<std::size_t>(ids.columns);
  if (has(offsetArray))
  {
    if (!has(idArray) || ids.columns != 1 || (offsets.rows == 0 && ids.rows > 0))
    {
      refuse(Reason::BadArray,
        quoted(offsetArray) + " is for " + quoted(idArray) + " of one column, and has a row more " +
          "than there are chains.");
    }
    cells.cells = static_cast<std::size_t>(std::max<std::int64_t>(1, offsets.rows) - 1);
  }
  else
  {
    cells.cells = ids.columns > 1 ? static_cast<std::size_t>(ids.rows) : cells.ids > 0 ? 1 : 0;
  }
  cells.cells = cells.ids > 0 ? cells.cells : 0;
  return cells;
}

std::array<double, 16> InputArrays::matrix() const
{
  std::array<double, 16> numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = realAt((*this)[InputArray::Matrix], i / 4, i % 4);
  }
  return numbers;
}

RankBounds InputArrays::rankBounds() const
{
  if (!has(InputArray::RankBounds))
  {
    return {};
  }
  const GivenArray& array = (*this)[InputArray::RankBounds];
  const RankBounds bounds{ realAt(array, 0, 0), realAt(array, 0, 1), realAt(array, 1, 0),
    realAt(array, 1, 1) };
  const bool isBox = std::isfinite(bounds.xmin) && std::isfinite(bounds.xmax) &&
    std::isfinite(bounds.ymin) && std::isfinite(bounds.ymax) && bounds.xmin <= bounds.xmax &&
    bounds.ymin <= bounds.ymax;
  if (!isBox)
  {
    refuse(Reason::BadValue, quoted(InputArray::RankBounds) + " are not xmin, xmax, ymin, ymax.");
  }
  return bounds;
}

std::vector<Point> InputArrays::voronoiPolygon() const
{
  const GivenArray& array = (*this)[InputArray::VoronoiPolygon];
  std::vector<Point> corners(static_cast<std::size_t>(array.rows));
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = { realAt(array, i, 0), realAt(array, i, 1) };
  }
  return corners;
}

} // namespace ahd
