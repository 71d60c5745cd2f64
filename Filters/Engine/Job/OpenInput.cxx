// SPDX-License-Identifier: BSD-3-Clause
//
// Input arrays as views; the implementation of OpenInput and of InputArrays::copiedBytes.
#include "../Core/Loops.h"
#include "InputArrays.h"
#include "Refusal.h"

#include <cstring>
#include <string>

namespace ahd
{
namespace
{

std::size_t sizeOf(std::int32_t type)
{
  return type == kUint8 ? 1 : type == kFloat32 || type == kInt32 ? 4 : 8;
}

bool isAligned(const GivenArray& array)
{
  return reinterpret_cast<std::uintptr_t>(array.data) % sizeOf(array.type) == 0;
}

/// Can points be read in place?
bool areViewable(const GivenArray& array)
{
  const auto size = static_cast<std::int64_t>(sizeOf(array.type));
  return array.rows == 0 ||
    (isAligned(array) && array.columnStride == size && array.rowStride > 0 &&
      array.rowStride % size == 0);
}

/// Are the numbers contiguous?
bool isContiguous(const GivenArray& array)
{
  const auto size = static_cast<std::int64_t>(sizeOf(array.type));
  return array.rows == 0 ||
    (isAligned(array) && (array.columns == 1 || array.columnStride == size) &&
      array.rowStride == size * array.columns);
}

const unsigned char* at(const GivenArray& array, std::size_t row, std::size_t column)
{
  return static_cast<const unsigned char*>(array.data) +
    static_cast<std::int64_t>(row) * array.rowStride +
    static_cast<std::int64_t>(column) * array.columnStride;
}

template <typename Number>
Number read(const GivenArray& array, std::size_t row, std::size_t column)
{
  Number number;
  std::memcpy(&number, at(array, row, column), sizeof(Number));
  return number;
}

std::int64_t readInteger(const GivenArray& array, std::size_t row, std::size_t column)
{
  return array.type == kInt32 ? read<std::int32_t>(array, row, column)
                              : read<std::int64_t>(array, row, column);
}

/// Calls work(begin, end) for chunks of the rows.
template <typename Work>
void forRows(std::size_t rows, const Context& context, const Work& work)
{
  Ticker ticker(context.progress, Phase::Merge, 0, context.executor);
  check(inChunksOf(rows, ticker, work) ? Status::Ok : Status::Cancelled);
}

/// All numbers, contiguous, each as numberAt(row, column) reads it.
template <typename Number, typename NumberAt>
const Number* copyNumbers(const GivenArray& array, std::vector<Number>& to, const Context& context,
  const NumberAt& numberAt)
{
  const std::size_t rows = static_cast<std::size_t>(array.rows);
  const std::size_t columns = static_cast<std::size_t>(array.columns);
  to.resize(rows * columns);
  forRows(rows, context,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        for (std::size_t k = 0; k < columns; ++k)
        {
          to[columns * i + k] = numberAt(i, k);
        }
      }
    });
  return to.data();
}

template <typename Number>
const Number* copyPoints(const GivenArray& array, std::vector<Number>& to, const Context& context)
{
  return copyNumbers(array, to, context,
    [&](std::size_t row, std::size_t column) { return read<Number>(array, row, column); });
}

template <typename Id>
const Id* copyIds(const GivenArray& array, std::vector<Id>& to, const Context& context)
{
  return copyNumbers(array, to, context,
    [&](std::size_t row, std::size_t column)
    { return static_cast<Id>(readInteger(array, row, column)); });
}

/// The array itself, or a copy.
template <typename Id>
const Id* idsOf(const GivenArray& array, std::vector<Id>& copy, const Context& context)
{
  const bool isOfType = sizeOf(array.type) == sizeof(Id);
  return isOfType && isContiguous(array) ? static_cast<const Id*>(array.data)
                                         : copyIds(array, copy, context);
}

/// The same of marks.
const unsigned char* bytesOf(
  const GivenArray& array, std::vector<unsigned char>& copy, const Context& context)
{
  return isContiguous(array)
    ? static_cast<const unsigned char*>(array.data)
    : copyNumbers(array, copy, context,
        [&](std::size_t row, std::size_t column) { return *at(array, row, column); });
}

/// Offsets of so many cells of the same size.
template <typename Id>
const Id* evenOffsets(
  std::size_t cells, std::size_t size, std::vector<Id>& to, const Context& context)
{
  to.resize(cells + 1);
  forRows(cells + 1, context,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        to[i] = static_cast<Id>(i * size);
      }
    });
  return to.data();
}

/// Refuses cells with invalid offsets.
void checkCells(const CellsView& cells, InputArray offsetArray, const Context& context)
{
  BadCell bad;
  const Status status = findBadCell(cells, context, bad);
  if (status == Status::BadCells)
  {
    refuse(Reason::BadArray,
      "\"" + std::string(InputArrays::name(std::size_t(offsetArray))) + "\" has " +
        std::to_string(bad.begin) + " and " + std::to_string(bad.end) + " for chain " +
        std::to_string(bad.cell) + ": they must ascend from 0 to the " + std::to_string(bad.ids) +
        " ids.");
  }
  check(status);
}

/// Ids and offsets have one type: 32 bits if both are so.
bool areShort(const GivenArray& ids, const GivenArray& offsets)
{
  constexpr std::int64_t kMost = 0x7FFFFFFF;
  const bool fit = offsets.type == kInt32 || (offsets.type == 0 && ids.rows <= kMost / ids.columns);
  return ids.type == kInt32 && fit;
}

template <typename Id>
void openCells(const InputArrays& arrays, InputArray idArray, InputArray offsetArray,
  std::vector<Id>& offsetCopy, std::vector<Id>& idCopy, CellsView& cells, const Context& context,
  const Id*& offsets, const Id*& ids)
{
  ids = idsOf(arrays[idArray], idCopy, context);
  if (!arrays.has(offsetArray))
  {
    offsets = evenOffsets<Id>(cells.cells, cells.ids / cells.cells, offsetCopy, context);
    return;
  }
  offsets = idsOf(arrays[offsetArray], offsetCopy, context);
}

std::size_t copiedBytesOf(const GivenArray& ids, const GivenArray& offsets)
{
  if (ids.type == 0 || ids.rows == 0)
  {
    return 0;
  }
  const std::size_t size = areShort(ids, offsets) ? 4 : 8;
  const auto bytesOf = [size](const GivenArray& array)
  {
    const bool isThere = sizeOf(array.type) == size && isContiguous(array);
    return isThere
      ? 0
      : size * static_cast<std::size_t>(array.rows) * static_cast<std::size_t>(array.columns);
  };
  const std::size_t made = ids.columns > 1 ? static_cast<std::size_t>(ids.rows) + 1 : 2;
  return bytesOf(ids) + (offsets.type == 0 ? size * made : bytesOf(offsets));
}

} // namespace

std::size_t InputArrays::copiedBytes() const
{
  const InputArrays& own = *this;
  std::size_t bytes = copiedBytesOf(own[InputArray::LineIds], own[InputArray::LineOffsets]) +
    copiedBytesOf(own[InputArray::LoopIds], own[InputArray::LoopOffsets]) +
    copiedBytesOf(own[InputArray::Cells], own[InputArray::CellOffsets]);
  for (const InputArray points : { InputArray::Points, InputArray::SourcePoints })
  {
    const GivenArray& array = own[points];
    bytes += has(points) && !areViewable(array)
      ? static_cast<std::size_t>(array.rows * array.columns) * sizeOf(array.type)
      : 0;
  }
  for (const InputArray numbers : { InputArray::Values, InputArray::Weights })
  {
    const GivenArray& array = own[numbers];
    bytes += has(numbers) && !areViewable(array)
      ? static_cast<std::size_t>(array.rows) * sizeOf(array.type)
      : 0;
  }
  for (const InputArray marks : { InputArray::Skip, InputArray::SurfaceEdges, InputArray::Keep })
  {
    bytes += isContiguous(own[marks]) ? 0 : static_cast<std::size_t>(own[marks].rows);
  }
  const GivenArray& groups = own[InputArray::CellGroups];
  bytes += isContiguous(groups) ? 0 : sizeof(double) * static_cast<std::size_t>(groups.rows);
  const GivenArray& surface = own[InputArray::Surface];
  return bytes +
    (isContiguous(surface) ? 0 : 3 * sizeOf(surface.type) * static_cast<std::size_t>(surface.rows));
}

PointView OpenInput::open(const GivenArray& array, Copies& copies, const Context& context)
{
  PointView view;
  view.count = static_cast<std::size_t>(array.rows);
  view.isFlat = array.columns != 3;
  view.stride = static_cast<std::size_t>(array.columns == 3 ? 3 : 2);
  const bool isDouble = array.type != kFloat32;
  if (areViewable(array))
  {
    view.stride = array.rows == 0 ? view.stride
                                  : static_cast<std::size_t>(array.rowStride) / sizeOf(array.type);
    view.doubles = isDouble ? static_cast<const double*>(array.data) : nullptr;
    view.floats = isDouble ? nullptr : static_cast<const float*>(array.data);
    return view;
  }
  view.doubles = isDouble ? copyPoints(array, copies.doubles, context) : nullptr;
  view.floats = isDouble ? nullptr : copyPoints(array, copies.floats, context);
  return view;
}

NumbersView OpenInput::openNumbers(const GivenArray& array, Copies& copies, const Context& context)
{
  const PointView view = open(array, copies, context);
  NumbersView numbers;
  numbers.doubles = array.type == 0 ? nullptr : view.doubles;
  numbers.floats = view.floats;
  numbers.stride = areViewable(array) ? view.stride : 1;
  return numbers;
}

void OpenInput::openPoints(const InputArrays& arrays, const Context& context)
{
  points = open(arrays[InputArray::Points], pointCopies_, context);
  sourcePoints = open(arrays[InputArray::SourcePoints], sourceCopies_, context);
  if (points.count == 0)
  {
    return;
  }
  points.skip = arrays.has(InputArray::Skip) ? bytesOf(arrays[InputArray::Skip], marks_, context)
                                             : nullptr;
  numbers.values = openNumbers(arrays[InputArray::Values], valueCopies_, context);
  numbers.valued = static_cast<std::size_t>(arrays[InputArray::Values].rows);
  numbers.weights = openNumbers(arrays[InputArray::Weights], weightCopies_, context);
  numbers.keep = arrays.has(InputArray::Keep)
    ? bytesOf(arrays[InputArray::Keep], keptMarks_, context)
    : nullptr;
}

void OpenInput::openSurface(const InputArrays& arrays, const Context& context)
{
  const GivenArray& given = arrays[InputArray::Surface];
  surface = GivenTriangles();
  if (given.rows == 0)
  {
    return;
  }
  surface.count = static_cast<std::size_t>(given.rows);
  surface.ids32 = given.type == kInt32 ? idsOf(given, surfaceCopies_.ids32, context) : nullptr;
  surface.ids64 = given.type == kInt64 ? idsOf(given, surfaceCopies_.ids64, context) : nullptr;
  surface.edges = arrays.has(InputArray::SurfaceEdges)
    ? bytesOf(arrays[InputArray::SurfaceEdges], edges_, context)
    : nullptr;
  others_.resize(points.count);
  check(markOthers(surface, points.count, 1, others_.data(), context));
  points.skip = others_.data();
  points.skipMask = 1;
}

void OpenInput::openCells(const InputArrays& arrays, const Context& context)
{
  lines = open(arrays, InputArray::LineIds, InputArray::LineOffsets, lineCopies_, context);
  loops = open(arrays, InputArray::LoopIds, InputArray::LoopOffsets, loopCopies_, context);
}

void OpenInput::openPolygons(const InputArrays& arrays, const Context& context)
{
  polygons = open(arrays, InputArray::Cells, InputArray::CellOffsets, polygonCopies_, context);
  const GivenArray& given = arrays[InputArray::CellGroups];
  groups = nullptr;
  if (arrays.has(InputArray::CellGroups) && given.rows > 0)
  {
    groups = isContiguous(given) ? static_cast<const double*>(given.data)
                                 : copyPoints(given, groupCopies_, context);
  }
}

CellsView OpenInput::open(const InputArrays& arrays, InputArray ids, InputArray offsets,
  CellCopies& copies, const Context& context)
{
  CellsView cells = arrays.countCells(ids, offsets);
  if (cells.ids == 0)
  {
    return cells;
  }
  areShort(arrays[ids], arrays[offsets])
    ? ahd::openCells(arrays, ids, offsets, copies.offsets32, copies.ids32, cells, context,
        cells.offsets32, cells.ids32)
    : ahd::openCells(arrays, ids, offsets, copies.offsets64, copies.ids64, cells, context,
        cells.offsets64, cells.ids64);
  checkCells(cells, offsets, context);
  return cells;
}

} // namespace ahd
