// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobArrays_h
#define ahd_JobArrays_h

#include "Job.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ahd
{

struct ArrayShape
{
  std::size_t rows = 0;
  std::size_t columns = 1;
};

// Output arrays of a job by name. Unknown names, wrong types, too little room and missing arrays
// are refused.
ArrayShape shapeOf(Job& job, const char* name);
void writeArray(Job& job, const char* name, std::int32_t type, void* out, std::uint64_t capacity);

/// Null past the last.
const char* outputArrayName(std::size_t number);

// Those of an outline, ids of any type: null if there is none of this name, or number.
const std::vector<Index>* outlineList(const Job& job, const char* name);
const char* outlineArrayName(std::size_t number);
constexpr std::size_t kOutlineArrays = 4;

// Those of visits of tiles.
/// Null data, and no columns, if there is none of this name.
struct TileArray
{
  NumberType type;
  std::size_t rows, columns;
  const void* data;
};
TileArray tileArray(Job& job, const char* name);
const char* tileArrayName(std::size_t number);

/// Where to write the order as it is drawn; see ahd_drawing.
struct GivenDrawing
{
  double* xyz;
  void* ranks;
  void* ids;
  std::int32_t* levels;
  void* counts;
};
void drawOrder(Job& job, std::int32_t type, const GivenDrawing& drawing);
void interpolate(Job& job, std::int32_t where, double* values, std::int32_t columns);

/// The outputs of locate(): one number, three and one for each place.
struct Places
{
  std::int32_t* kinds; ///< PlaceKind
  std::int64_t* ids;
  std::int64_t* cells; ///< may be null
};
void locate(Job& job, const double* xy, std::uint64_t given, const Places& out);
PlaceKind kindOf(Location::Kind kind);

} // namespace ahd

#endif
