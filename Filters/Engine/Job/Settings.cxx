// SPDX-License-Identifier: BSD-3-Clause
#include "Settings.h"

#include "Refusal.h"

#include <cstring>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

namespace ahd
{
namespace
{

template <typename Number>
struct Row
{
  const char* name;
  Number preset, least, most;
};

template <typename Word>
constexpr std::int64_t numberOf(Word word)
{
  return static_cast<std::int64_t>(word);
}

constexpr std::int64_t kHuge = std::int64_t(1) << 62;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// in the order of IntSetting
constexpr Row<std::int64_t> kInts[] = {
  { "insertion_order", numberOf(InsertionOrder::AdaptiveHilbert), 0,
    numberOf(InsertionOrder::AsGiven) },
  { "nmax", 50, 1, std::numeric_limits<std::int32_t>::max() },
  { "control_points", numberOf(ControlPoints::EveryLevel), 0, numberOf(ControlPoints::EveryLevel) },
  { "gene_rotation", 1, 0, 1 },
  { "count_work", 0, 0, 1 },
  { "insertion_limit", 0, 0, kHuge },
  { "duplicates", numberOf(Duplicates::First), 0, numberOf(Duplicates::MeanZ) },
  { "skip_mask", 255, 1, 255 },
  { "cell_ids", numberOf(CellIds::OfInput), 0, numberOf(CellIds::OfSource) },
  { "first_cell", 0, 0, kHuge },
  { "closed_lines", 0, 0, 1 },
  { "split_crossings", 0, 0, 1 },
  { "source_heights", numberOf(SourceHeights::Own), 0, numberOf(SourceHeights::FromSurface) },
  { "fill_rule", numberOf(FillRule::Orientation), 0, numberOf(FillRule::EvenOdd) },
  { "plane", numberOf(PlaneKind::Xy), 0, numberOf(PlaneKind::Callback) },
  { "rim", numberOf(RimKind::Automatic), 0, numberOf(RimKind::Trimmed) },
  { "bounding", 0, 0, 1 },
  { "alpha_triangles", 1, 0, 1 },
  { "alpha_lines", 1, 0, 1 },
  { "alpha_vertices", 1, 0, 1 },
  { "voronoi_clip", numberOf(VoronoiClip::Hull), 0, numberOf(VoronoiClip::Bounds) },
  { "want_voronoi", 0, 0, 1 },
  { "want_order", 0, 0, 1 },
  { "want_boxes", 0, 0, 1 },
  { "want_curve", 0, 0, 1 },
  { "want_point_status", 0, 0, 1 },
  { "want_insertion_ranks", 0, 0, 1 },
  { "want_constraint_edges", 0, 0, 1 },
  { "want_regions", 0, 0, 1 },
  { "want_neighbors", 0, 0, 1 },
  { "want_samples", 0, 0, 1 },
  { "sample_method", numberOf(SampleMethod::Linear), 0, numberOf(SampleMethod::Nearest) },
  { "sample_outside", numberOf(OutsideValues::None), 0, numberOf(OutsideValues::NearestVertex) },
  { "threads", 0, 0, 1024 },
  { "memory_limit", 0, 0, kHuge },
  { "other_memory", 0, 0, kHuge },
  { "other_memory_per_point", 0, 0, std::numeric_limits<std::int32_t>::max() },
};

// in the order of DoubleSetting
constexpr Row<double> kDoubles[] = {
  { "tolerance", 0.0, 0.0, 1.0 },
  { "offset", 1.0, 0.75, std::numeric_limits<double>::max() },
  { "alpha", 0.0, 0.0, kInfinity },
  { "maximum_edge_length", 0.0, 0.0, kInfinity },
};

static_assert(sizeof(kInts) / sizeof(kInts[0]) == kIntSettings, "a row for each");
static_assert(sizeof(kDoubles) / sizeof(kDoubles[0]) == kDoubleSettings, "a row for each");

template <typename Number, std::size_t count>
std::size_t find(const Row<Number> (&rows)[count], const char* name)
{
  for (std::size_t i = 0; name && i < count; ++i)
  {
    if (std::strcmp(rows[i].name, name) == 0)
    {
      return i;
    }
  }
  return count;
}

template <typename Number, std::size_t count>
std::size_t mustFind(const Row<Number> (&rows)[count], const char* name)
{
  const std::size_t i = find(rows, name);
  if (i < count)
  {
    return i;
  }
  const char* const kind = sizeof(rows) == sizeof(kInts) ? "int" : "double";
  const bool isOther = find(kInts, name) < kIntSettings || find(kDoubles, name) < kDoubleSettings;
  refuse(Reason::UnknownName,
    "There is no setting \"" + std::string(name ? name : "(null)") + "\" of type " + kind +
      (isOther ? ": it is of the other type." : "."));
}

template <typename Number, std::size_t count>
void put(const Row<Number> (&rows)[count], const char* name, Number value, Number* values)
{
  const std::size_t i = mustFind(rows, name);
  if (!(value >= rows[i].least && value <= rows[i].most))
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << "\"" << name << "\" may be " << rows[i].least << " to " << rows[i].most << ", not "
         << value << ".";
    refuse(Reason::BadValue, text.str());
  }
  values[i] = value;
}

} // namespace

JobSettings::JobSettings()
{
  for (std::size_t i = 0; i < kIntSettings; ++i)
  {
    ints_[i] = kInts[i].preset;
  }
  for (std::size_t i = 0; i < kDoubleSettings; ++i)
  {
    doubles_[i] = kDoubles[i].preset;
  }
}

void JobSettings::set(const char* name, std::int64_t value)
{
  put(kInts, name, value, ints_.data());
}

void JobSettings::set(const char* name, double value)
{
  put(kDoubles, name, value, doubles_.data());
}

void JobSettings::get(const char* name, std::int64_t& value) const
{
  value = ints_[mustFind(kInts, name)];
}

void JobSettings::get(const char* name, double& value) const
{
  value = doubles_[mustFind(kDoubles, name)];
}

const char* JobSettings::intName(std::size_t number)
{
  return number < kIntSettings ? kInts[number].name : nullptr;
}

const char* JobSettings::doubleName(std::size_t number)
{
  return number < kDoubleSettings ? kDoubles[number].name : nullptr;
}

Options JobSettings::options() const
{
  const JobSettings& own = *this;
  Options options;
  options.order = ahd::InsertionOrder(own[IntSetting::InsertionOrder]);
  options.controlPoints = ahd::ControlPoints(own[IntSetting::ControlPoints]);
  options.geneRotation = is(IntSetting::GeneRotation);
  options.nmax = static_cast<int>(own[IntSetting::Nmax]);
  options.countWork = is(IntSetting::CountWork);
  options.insertionLimit = static_cast<std::size_t>(own[IntSetting::InsertionLimit]);
  options.keepOrder = is(IntSetting::WantOrder) || is(IntSetting::WantInsertionRanks) ||
    is(IntSetting::WantCurve);
  options.keepBoxes = is(IntSetting::WantBoxes);
  options.representative = duplicates() == Duplicates::LowestZ ? Representative::LowestZ
    : duplicates() == Duplicates::HighestZ                     ? Representative::HighestZ
                                                               : Representative::FirstId;
  return options;
}

SizeLimits JobSettings::limits() const
{
  return { (*this)[DoubleSetting::Alpha], (*this)[DoubleSetting::MaximumEdgeLength],
    is(IntSetting::AlphaTriangles), is(IntSetting::AlphaLines), is(IntSetting::AlphaVertices) };
}

bool JobSettings::limitsSize() const
{
  return (*this)[DoubleSetting::Alpha] > 0.0 || (*this)[DoubleSetting::MaximumEdgeLength] > 0.0;
}

bool JobSettings::mayTrimRim() const
{
  return (rim() == RimKind::Trimmed || (rim() == RimKind::Automatic && isProjected())) &&
    !limitsSize() && !addsBounding();
}

bool JobSettings::trimsRim(const Plane& fitted) const
{
  const bool isRounded = plane() != PlaneKind::BestFit || !fitted.isOfCoordinates();
  return mayTrimRim() && (isRounded || rim() == RimKind::Trimmed);
}

} // namespace ahd
