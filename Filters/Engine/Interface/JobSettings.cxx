// SPDX-License-Identifier: BSD-3-Clause
#include "JobSettings.h"

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

constexpr std::int64_t kHuge = std::int64_t(1) << 62;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// in the order of IntSetting
constexpr Row<std::int64_t> kInts[] = {
  { "insertion_order", AHD_ORDER_ADAPTIVE_HILBERT, 0, AHD_ORDER_AS_GIVEN },
  { "nmax", 50, 1, std::numeric_limits<std::int32_t>::max() },
  { "control_points", AHD_CONTROL_EVERY_LEVEL, 0, AHD_CONTROL_EVERY_LEVEL },
  { "gene_rotation", 1, 0, 1 },
  { "count_work", 0, 0, 1 },
  { "insertion_limit", 0, 0, kHuge },
  { "duplicates", AHD_DUPLICATES_FIRST, 0, AHD_DUPLICATES_MEAN_Z },
  { "skip_mask", 255, 1, 255 },
  { "cell_ids", AHD_IDS_OF_INPUT, 0, AHD_IDS_OF_SOURCE },
  { "first_cell", 0, 0, kHuge },
  { "closed_lines", 0, 0, 1 },
  { "split_crossings", 0, 0, 1 },
  { "source_heights", AHD_HEIGHTS_OWN, 0, AHD_HEIGHTS_FROM_SURFACE },
  { "fill_rule", AHD_FILL_ORIENTATION, 0, AHD_FILL_EVEN_ODD },
  { "plane", AHD_PLANE_XY, 0, AHD_PLANE_CALLBACK },
  { "rim", AHD_RIM_AUTOMATIC, 0, AHD_RIM_TRIMMED },
  { "bounding", 0, 0, 1 },
  { "alpha_triangles", 1, 0, 1 },
  { "alpha_lines", 1, 0, 1 },
  { "alpha_vertices", 1, 0, 1 },
  { "voronoi_clip", AHD_CLIP_HULL, 0, AHD_CLIP_BOUNDS },
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
  { "sample_method", AHD_SAMPLE_LINEAR, 0, AHD_SAMPLE_NEAREST },
  { "sample_outside", AHD_OUTSIDE_NO_VALUE, 0, AHD_OUTSIDE_NEAREST_VERTEX },
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
  refuse(AHD_UNKNOWN_NAME,
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
    refuse(AHD_BAD_VALUE, text.str());
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
  const std::int64_t duplicates = own[IntSetting::Duplicates];
  options.representative = duplicates == AHD_DUPLICATES_LOWEST_Z ? Representative::LowestZ
    : duplicates == AHD_DUPLICATES_HIGHEST_Z                     ? Representative::HighestZ
                                                                 : Representative::FirstId;
  return options;
}

SizeLimits JobSettings::limits() const
{
  return { (*this)[DoubleSetting::Alpha], (*this)[DoubleSetting::MaximumEdgeLength],
    is(IntSetting::AlphaTriangles), is(IntSetting::AlphaLines), is(IntSetting::AlphaVertices) };
}

bool JobSettings::showsMeans() const
{
  return (*this)[IntSetting::Duplicates] == AHD_DUPLICATES_MEAN_Z;
}

bool JobSettings::limitsSize() const
{
  return (*this)[DoubleSetting::Alpha] > 0.0 || (*this)[DoubleSetting::MaximumEdgeLength] > 0.0;
}

bool JobSettings::mayTrimRim() const
{
  const std::int64_t rim = (*this)[IntSetting::Rim];
  return (rim == AHD_RIM_TRIMMED || (rim == AHD_RIM_AUTOMATIC && isProjected())) && !limitsSize() &&
    !addsBounding();
}

bool JobSettings::trimsRim(const Plane& plane) const
{
  const bool isRounded = (*this)[IntSetting::Plane] != AHD_PLANE_BEST_FIT ||
    !plane.isOfCoordinates();
  return mayTrimRim() && (isRounded || (*this)[IntSetting::Rim] == AHD_RIM_TRIMMED);
}

} // namespace ahd
