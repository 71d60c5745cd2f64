// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Translate_h
#define ahd_Translate_h

#include "../Job/InputArrays.h"
#include "../Job/Job.h"
#include "../Job/Messages.h"
#include "../Job/Refusal.h"
#include "../Job/Sampling.h"
#include "../Job/Settings.h"
#include "ahd.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// The words of ahd.h as those of Job/: numbers are the same, structs are copied.

namespace ahd
{

constexpr struct
{
  std::int64_t ours, jobs;
} kSameWords[] = {
  { AHD_CANCELLED, std::int64_t(Reason::Cancelled) },
  { AHD_TOO_MANY_POINTS, std::int64_t(Reason::TooManyPoints) },
  { AHD_TOO_MANY_BOXES, std::int64_t(Reason::TooManyBoxes) },
  { AHD_OUT_OF_MEMORY, std::int64_t(Reason::OutOfMemory) },
  { AHD_MEMORY_LIMIT, std::int64_t(Reason::MemoryLimit) },
  { AHD_TOO_MANY_CROSSINGS, std::int64_t(Reason::TooManyCrossings) },
  { AHD_UNKNOWN_NAME, std::int64_t(Reason::UnknownName) },
  { AHD_BAD_VALUE, std::int64_t(Reason::BadValue) },
  { AHD_BAD_ARRAY, std::int64_t(Reason::BadArray) },
  { AHD_NOT_AVAILABLE, std::int64_t(Reason::NotAvailable) },
  { AHD_PHASE_MERGE, std::int64_t(Phase::Merge) },
  { AHD_PHASE_SPLIT, std::int64_t(Phase::Split) },
  { AHD_PHASE_READ, std::int64_t(Phase::Read) },
  { AHD_PHASE_SORT, std::int64_t(Phase::Sort) },
  { AHD_PHASE_INSERT, std::int64_t(Phase::Insert) },
  { AHD_PHASE_CONSTRAIN, std::int64_t(Phase::Constrain) },
  { AHD_PHASE_EXTRACT, std::int64_t(Phase::Extract) },
  { AHD_PHASE_OUTPUTS, std::int64_t(Phase::Outputs) },
  { AHD_ORDER_ADAPTIVE_HILBERT, std::int64_t(InsertionOrder::AdaptiveHilbert) },
  { AHD_ORDER_MULTI_GRID, std::int64_t(InsertionOrder::MultiGrid) },
  { AHD_ORDER_REGULAR_GRID, std::int64_t(InsertionOrder::RegularGrid) },
  { AHD_ORDER_AS_GIVEN, std::int64_t(InsertionOrder::AsGiven) },
  { AHD_CONTROL_OFF, std::int64_t(ControlPoints::Off) },
  { AHD_CONTROL_SINGLE_LEVEL, std::int64_t(ControlPoints::SingleLevel) },
  { AHD_CONTROL_EVERY_LEVEL, std::int64_t(ControlPoints::EveryLevel) },
  { AHD_DUPLICATES_FIRST, std::int64_t(Duplicates::First) },
  { AHD_DUPLICATES_LOWEST_Z, std::int64_t(Duplicates::LowestZ) },
  { AHD_DUPLICATES_HIGHEST_Z, std::int64_t(Duplicates::HighestZ) },
  { AHD_DUPLICATES_MEAN_Z, std::int64_t(Duplicates::MeanZ) },
  { AHD_IDS_OF_INPUT, std::int64_t(CellIds::OfInput) },
  { AHD_IDS_OF_SOURCE, std::int64_t(CellIds::OfSource) },
  { AHD_HEIGHTS_OWN, std::int64_t(SourceHeights::Own) },
  { AHD_HEIGHTS_FROM_SURFACE, std::int64_t(SourceHeights::FromSurface) },
  { AHD_HEIGHTS_MIXED, std::int64_t(SourceHeights::Mixed) },
  { AHD_FILL_ORIENTATION, std::int64_t(FillRule::Orientation) },
  { AHD_FILL_EVEN_ODD, std::int64_t(FillRule::EvenOdd) },
  { AHD_CLIP_HULL, std::int64_t(VoronoiClip::Hull) },
  { AHD_CLIP_BOUNDS, std::int64_t(VoronoiClip::Bounds) },
  { AHD_CLIP_POLYGON, std::int64_t(VoronoiClip::Polygon) },
  { AHD_PLANE_XY, std::int64_t(PlaneKind::Xy) },
  { AHD_PLANE_BEST_FIT, std::int64_t(PlaneKind::BestFit) },
  { AHD_PLANE_MATRIX, std::int64_t(PlaneKind::Matrix) },
  { AHD_PLANE_CALLBACK, std::int64_t(PlaneKind::Callback) },
  { AHD_RIM_AUTOMATIC, std::int64_t(RimKind::Automatic) },
  { AHD_RIM_CONVEX_HULL, std::int64_t(RimKind::ConvexHull) },
  { AHD_RIM_TRIMMED, std::int64_t(RimKind::Trimmed) },
  { AHD_SAMPLE_LINEAR, std::int64_t(SampleMethod::Linear) },
  { AHD_SAMPLE_NATURAL_NEIGHBOR, std::int64_t(SampleMethod::NaturalNeighbor) },
  { AHD_SAMPLE_LAPLACE, std::int64_t(SampleMethod::Laplace) },
  { AHD_SAMPLE_NEAREST, std::int64_t(SampleMethod::Nearest) },
  { AHD_OUTSIDE_NO_VALUE, std::int64_t(OutsideValues::None) },
  { AHD_OUTSIDE_NEAREST_VERTEX, std::int64_t(OutsideValues::NearestVertex) },
  { AHD_OUTSIDE_BOUNDARY, std::int64_t(OutsideValues::Boundary) },
  { AHD_IN_TRIANGLE, std::int64_t(PlaceKind::InTriangle) },
  { AHD_ON_EDGE, std::int64_t(PlaceKind::OnEdge) },
  { AHD_ON_VERTEX, std::int64_t(PlaceKind::OnVertex) },
  { AHD_OUTSIDE, std::int64_t(PlaceKind::Outside) },
  { AHD_NOWHERE, std::int64_t(PlaceKind::Nowhere) },
  { AHD_FLOAT32, std::int64_t(kFloat32) },
  { AHD_FLOAT64, std::int64_t(kFloat64) },
  { AHD_INT32, std::int64_t(kInt32) },
  { AHD_INT64, std::int64_t(kInt64) },
  { AHD_UINT8, std::int64_t(kUint8) },
  { AHD_EDIT_DONE, std::int64_t(EditOutcome::Done) },
  { AHD_EDIT_NOT_TRIED, std::int64_t(EditOutcome::NotTried) },
  { AHD_EDIT_NO_POINT, std::int64_t(EditOutcome::NoPoint) },
  { AHD_EDIT_END_OF_SEGMENT, std::int64_t(EditOutcome::EndOfSegment) },
  { AHD_EDIT_SEGMENTS_MEET, std::int64_t(EditOutcome::SegmentsMeet) },
  { AHD_EDIT_NOT_FINITE, std::int64_t(EditOutcome::NotFinite) },
  { AHD_EDIT_NO_LENGTH, std::int64_t(EditOutcome::NoLength) },
  { AHD_EDIT_CROSSES, std::int64_t(EditOutcome::Crosses) },
  { AHD_EDIT_NO_SEGMENT, std::int64_t(EditOutcome::NoSegment) },
  { AHD_AT_SURFACE, std::int64_t(kAtSurface) },
  { AHD_AT_CROSSINGS, std::int64_t(kAtCrossings) },
};

constexpr bool areSameWords()
{
  for (const auto& word : kSameWords)
  {
    if (word.ours != word.jobs)
    {
      return false;
    }
  }
  return true;
}
static_assert(areSameWords(), "a number of ahd.h is another one in the engine");

inline void mustHave(const void* pointer, const char* what)
{
  if (!pointer)
  {
    refuse(Reason::BadArray, "The pointer to the " + std::string(what) + " is null.");
  }
}

inline GivenArray arrayOf(const ahd_array& array)
{
  return { array.data, array.type, array.columns, array.rows, array.row_stride,
    array.column_stride };
}

inline GivenPlaces placesOf(const ahd_places& places)
{
  return { places.xy, places.count, { places.origin[0], places.origin[1] },
    { places.spacing[0], places.spacing[1] }, places.columns, places.rows };
}

inline std::vector<GivenSamples> samplesOf(const ahd_sampled* given, std::uint64_t count)
{
  if (count > 0 && !given)
  {
    refuse(Reason::BadArray, "The arrays to interpolate are null.");
  }
  checkColumns(count, "arrays");
  std::vector<GivenSamples> samples(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    samples[k] = { given[k].values, given[k].columns, given[k].out, given[k].gradients };
  }
  return samples;
}

inline Wording wordingOf(std::int32_t words)
{
  if (words < AHD_WORDS_OF_C || words > AHD_WORDS_OF_NUMPY)
  {
    refuse(Reason::BadValue, "There are no such words.");
  }
  return Wording(words);
}

inline Facts factsOf(const ahd_fact* given, std::uint64_t count)
{
  checkCount(count, "facts");
  Facts facts;
  for (std::uint64_t k = 0; k < count; ++k)
  {
    mustHave(given, "facts");
    mustHave(given[k].name, "name of a fact");
    Fact fact(given[k].name, given[k].text ? given[k].text : "", given[k].number);
    fact.real = given[k].real != 0.0 ? given[k].real : fact.real;
    facts.add(std::move(fact));
  }
  return facts;
}

} // namespace ahd

#endif
