// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_JobWords_h
#define ahd_JobWords_h

#include <cstdint>

// The words of a job whose numbers its callers know. They stay as they are:
// Interface/Translate.h compares them with those of ahd.h.

namespace ahd
{

/// Why something cannot be done.
enum class Reason : std::int32_t
{
  Cancelled = 1,
  TooManyPoints,
  TooManyBoxes,
  OutOfMemory,
  MemoryLimit, ///< the estimate is above the limit
  TooManyCrossings,
  UnknownName,
  BadValue,
  BadArray,
  NotAvailable ///< there is no result, or this was not asked for before the run
};

/// Types of the numbers in arrays. Callers give any number.
enum NumberType : std::int32_t
{
  kFloat32 = 1,
  kFloat64,
  kInt32,
  kInt64,
  kUint8
};
/// A set of them, one bit each; none for a number that is no type.
constexpr unsigned bitOf(std::int32_t type)
{
  return type >= kFloat32 && type <= kUint8 ? 1u << type : 0u;
}
constexpr unsigned kRealTypes = bitOf(kFloat32) | bitOf(kFloat64);
constexpr unsigned kIntegerTypes = bitOf(kInt32) | bitOf(kInt64);

enum class Duplicates
{
  First,
  LowestZ,
  HighestZ,
  MeanZ ///< the first, moved to the mean of all
};

/// Whose points the ids of lines and loops name.
enum class CellIds
{
  OfInput,
  OfSource
};

enum class PlaneKind
{
  Xy,
  BestFit,
  Matrix,
  Callback
};

enum class RimKind
{
  Automatic,
  ConvexHull,
  Trimmed
};

/// What a place lies on.
enum class PlaceKind : std::int32_t
{
  InTriangle,
  OnEdge,
  OnVertex,
  Outside,
  Nowhere
};

/// Where values are interpolated: one of them or their sum.
enum InterpolatedAt : std::int32_t
{
  kAtSurface = 1,
  kAtCrossings = 2
};

} // namespace ahd

#endif
