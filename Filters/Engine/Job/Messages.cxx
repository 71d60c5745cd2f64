// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "../Core/SizeInWords.h"
#include "../Points/Points.h"
#include "Catalogue.h"
#include "ReportRows.h"

#include <algorithm>
#include <iterator>
#include <locale>
#include <sstream>

namespace ahd
{
namespace
{

// --- Facts derived from others -----------------------------------------------------------------

void addOfRefusal(Wording wording, Facts& f)
{
  // In the order of Reason.
  const char* const reasons[] = { "", "", "points", "boxes", "memory", "limit", "crossings", "", "",
    "cells", "" };
  const auto reason = static_cast<std::size_t>(f["reason"]);
  f.add({ "refused", reason < std::size(reasons) ? reasons[reason] : "" });
  f.add({ "most_points", kMaximumPoints });
  f.add({ "is_limited", f["memory_limit"] > 0 });
  f.add({ "places_are_unknown", f.of("places").real < 0.0 });
  const auto inUnits = [&](const char* of)
  { return wording == Wording::Class && f["is_in_kib"] == 0 ? f[of] / 1024 : f[of]; };
  const auto addSize = [&](const char* name, const char* of, Rounded rounded)
  {
    constexpr std::int64_t kMost = std::int64_t(1) << 53; // KiB that can be counted as bytes
    const std::int64_t units = inUnits(of);
    f.add({ name,
      sizeInWords(wording == Wording::Class ? 1024 * std::uint64_t(std::min(units, kMost))
                                            : std::uint64_t(units),
        rounded) });
  };
  addSize("needed", "memory_estimate", Rounded::Up);
  addSize("needed_besides", "memory_needed", Rounded::Up);
  addSize("allowed", "memory_allowed", Rounded::Down);
  f.add({ "units_needed", inUnits("memory_estimate") });
  f.add({ "limit_is_less",
    f["memory_limit"] > 0 && inUnits("memory_estimate") > inUnits("memory_allowed") });
  const std::string mask = f.of("mask_name").text;
  f.add({ "is_of_heights", !mask.empty() && mask == f.of("heights_name").text });
  f.add({ "is_of_gradients", !mask.empty() && mask == f.of("gradients_name").text });
}

void addOfTriangulation(Facts& f)
{
  const bool isEmptied = f["may_be_emptied_by_loops"] != 0;
  const bool hasPoints = f["inserted"] + f["not_finite"] > 0;
  f.addNonzero("has_no_triangle", !isEmptied && f["delaunay_triangles"] == 0 && hasPoints);
  f.addNonzero("distinct", f["inserted"] + f["beyond_limit"]);
  f.addNonzero("are_few", f["inserted"] < 3);
  // Points that were not projected were tested for lying on one line.
  f.addNonzero("is_wall", f["inserted"] > 0 && f["is_projected"] + f["on_one_line"] == 0);
  f.addNonzero("is_steep", f["steep_plane"] + f["plane_was_chosen"]);
  f.addNonzero("is_empty", f["kept_triangles"] == 0);
  f.addNonzero("untrimmed", f["kept_triangles"] + f["trimmed_triangles"]);
  const double trimmed = f.of("trimmed_area").real; // NaN where areas are beyond all doubles
  f.addNonzero("is_much_trimmed", f["bare_vertices"] > 0 || trimmed > 0.1); // no slivers at the rim
  f.addNonzero("trimmed_percent", int(100.0 * std::min(1.0, std::max(0.0, trimmed)) + 0.5));
  f.addNonzero("are_unsaid", f["segments_crossing"] == 0); // loops that bound nothing
  const bool hasSource = f["source_points"] + f["source_strips"] > 0;
  f.addNonzero("constrains_nothing", hasSource && f["segments"] == 0);
  f.addNonzero("may_be_line", f["source_points"] > 1 && f["source_strips"] == 0);
  const auto addContent = [&f](const char* what, const char* one, const char* many)
  {
    if (const std::int64_t count = f[what])
    {
      f.add({ "source_content", std::to_string(count) + (count == 1 ? one : many) });
    }
  };
  addContent("source_points", " point", " points");
  addContent("source_vertices", " vertex", " vertices");
  addContent("source_strips", " triangle strip", " triangle strips");
}

/// "missing": of each array its name, empty for the heights, and its number of missing values; with
/// it "of_points", whether it has NaN at vertices, and "of_added", whether at added ones.
void addOfPlaces(Facts& f)
{
  const auto arrays = f.all("missing"), ofPoints = f.all("of_points"), ofAdded = f.all("of_added");
  bool areHeights = false;
  for (std::size_t k = 0; k < arrays.size(); ++k)
  {
    const std::int64_t count = arrays[k].number;
    const bool isOfHeights = arrays[k].text.empty();
    const std::string name = isOfHeights ? "heights" : arrays[k].text;
    const auto addIf = [&](bool is, const char* what, const std::string& text)
    {
      if (is)
      {
        f.add({ what, text });
      }
    };
    areHeights = areHeights || (isOfHeights && count > 0);
    const std::string of = isOfHeights ? count == 1 ? " height" : " heights" : " of " + name;
    addIf(count > 0, "valueless", std::to_string(count) + of);
    addIf(count > 0 && ofAdded.at(k).number != 0, "valueless_added", name);
    addIf(ofPoints.at(k).number != 0, "incomplete", name);
    addIf(ofAdded.at(k).number != 0, "incomplete_added", name);
  }
  f.add({ "heights_are_whole", !areHeights });
}

// --- Texts ---------------------------------------------------------------------------------------

/// Is the fact there, and not 0?
bool isThere(const Facts& facts, std::string_view name)
{
  const Fact& fact = facts.of(name);
  return fact.number != 0 || !fact.text.empty();
}

/// Row::when
bool holds(const Facts& facts, std::string_view when)
{
  while (!when.empty())
  {
    std::string_view part = when.substr(0, when.find(' '));
    when.remove_prefix(std::min(part.size() + 1, when.size()));
    const bool isNot = part[0] == '!';
    part.remove_prefix(isNot ? 1 : 0);
    const std::size_t equals = part.find('=');
    const bool is = equals == part.npos
      ? isThere(facts, part)
      : facts.of(part.substr(0, equals)).text == part.substr(equals + 1);
    if (is == isNot)
    {
      return false;
    }
  }
  return true;
}

/// Where the first `mark` is that is in no braces; the end if none is.
std::size_t findOutside(std::string_view text, char mark)
{
  std::size_t depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    if (depth == 0 && text[i] == mark)
    {
      return i;
    }
    depth += text[i] == '{';
    depth -= text[i] == '}';
  }
  return text.size();
}

/// As short as it can be with 9 digits at most, whatever the locale is.
std::string digits(const Fact& fact)
{
  if (fact.real == static_cast<double>(fact.number))
  {
    return std::to_string(fact.number);
  }
  std::ostringstream made;
  made.exceptions(std::ios::badbit); // bad_alloc, which a stream swallows
  made.imbue(std::locale::classic());
  made.precision(9);
  made << fact.real;
  return made.str();
}

std::string inWords(const Fact& fact)
{
  return fact.text.empty() ? digits(fact) : fact.text;
}

/// Of four numbers a box; else "a, b and 3 more".
std::string listed(const std::vector<Fact>& facts)
{
  if (facts.size() == 4 && facts[0].text.empty())
  {
    return "x " + digits(facts[0]) + " to " + digits(facts[1]) + ", y " + digits(facts[2]) +
      " to " + digits(facts[3]);
  }
  constexpr std::size_t kMost = 5;
  std::string words = inWords(facts[0]);
  for (std::size_t k = 1; k < std::min(facts.size(), kMost); ++k)
  {
    words += ", " + inWords(facts[k]);
  }
  return facts.size() <= kMost ? words
                               : words + " and " + std::to_string(facts.size() - kMost) + " more";
}

/// Fills in what Row::text has in braces.
class Sentence
{
public:
  Sentence(const Facts& facts, Wording wording)
    : facts_(facts)
    , wording_(wording)
  {
  }

  std::string operator()(std::string_view text) const
  {
    std::string made;
    for (std::size_t end = 0; !text.empty(); text.remove_prefix(std::min(end + 1, text.size())))
    {
      end = std::min(text.find('{'), text.size());
      made += text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      end = findOutside(text, '}');
      made += text.empty() ? std::string() : place(text.substr(0, end));
    }
    return made;
  }

private:
  std::string place(std::string_view inside) const
  {
    const std::size_t end = std::min(inside.find_first_of("?+"), inside.size());
    const std::string_view name = inside.substr(0, end);
    if (end == inside.size())
    {
      return value(name);
    }
    std::string_view rest = inside.substr(end + 1);
    if (inside[end] == '+')
    {
      return isThere(facts_, name) ? (*this)(rest) : std::string();
    }
    const std::size_t bar = findOutside(rest, '|');
    return (*this)(facts_[name] == 1 ? rest.substr(0, bar) : rest.substr(bar + 1));
  }

  std::string value(std::string_view name) const
  {
    const Phrase* const phrase = std::find_if(std::begin(kPhrases), std::end(kPhrases),
      [name](const Phrase& one) { return name == one.name; });
    if (phrase != std::end(kPhrases))
    {
      const char* const own = phrase->in[std::size_t(wording_)];
      return (*this)(own ? own : phrase->in[0]);
    }
    const auto facts = facts_.all(name);
    return facts.size() > 1 ? listed(facts) : inWords(facts_.of(name));
  }

  const Facts& facts_;
  Wording wording_;
};

} // namespace

const Fact& Facts::of(std::string_view name) const
{
  static const Fact kNone("", 0);
  const auto found = std::find_if(
    facts_.begin(), facts_.end(), [name](const Fact& fact) { return fact.name == name; });
  return found == facts_.end() ? kNone : *found;
}

std::vector<Fact> Facts::all(std::string_view name) const
{
  std::vector<Fact> found;
  std::copy_if(facts_.begin(), facts_.end(), std::back_inserter(found),
    [name](const Fact& fact) { return fact.name == name; });
  return found;
}

bool Facts::isAmong(std::string_view name, std::size_t first) const
{
  return std::any_of(facts_.begin(), facts_.begin() + std::ptrdiff_t(first),
    [name](const Fact& one) { return one.name == name; });
}

Reason reasonOf(Status status, bool isRefused)
{
  // In the order of Status.
  constexpr Reason reasons[] = { Reason(), Reason::Cancelled, Reason::TooManyPoints,
    Reason::TooManyBoxes, Reason::TooManyCrossings, Reason::OutOfMemory, Reason::BadArray,
    Reason::BadArray, Reason::BadValue };
  return isRefused && status == Status::OutOfMemory ? Reason::MemoryLimit
                                                    : reasons[std::size_t(status)];
}

namespace
{

/// Boxes in the plane, and the heights of the input.
void addBounds(const SourceBounds& bounds, Facts& facts)
{
  for (std::size_t k = 0; k < 2; ++k)
  {
    for (const auto end : { &SpaceBox::low, &SpaceBox::high })
    {
      facts.add({ "source_box", (bounds.source.*end)[k] });
      facts.add({ "input_box", (bounds.input.*end)[k] });
    }
  }
  facts.add({ "lowest_z", bounds.input.low[2] });
  facts.add({ "highest_z", bounds.input.high[2] });
}

} // namespace

Facts factsOf(const RunReport& report, Facts known)
{
  const std::size_t given = known.count();
  known.reserve(given + std::size(kCountRows)); // mostly enough for those derived from them, too
  for (const auto& row : kCountRows)
  {
    if (!row.isOfResult || report.status == Status::Ok)
    {
      known.addNonzero(row.name, row.get(report), given);
    }
  }
  // where there are too many crossings, points are those with them
  known.addNonzero("own_points", report.points - report.crossings, given);
  const char* const polygonFaults[] = { "", "has a coordinate that is not a finite number",
    "has no area", "is not convex" }; // in the order of PolygonFault
  if (report.status == Status::BadPolygon)
  {
    known.add({ "polygon_fault", polygonFaults[std::size_t(report.polygonFault)] });
  }
  const char* const conflicts[] = { "", "conflict_with_limit", "conflict_with_alpha",
    "conflict_with_mean" }; // in the order of Conflict
  if (report.status == Status::BadSettings)
  {
    known.add({ "conflict", 1 });
    known.add({ conflicts[std::size_t(report.conflict)], 1 });
  }
  known.addNonzero("memory_limit", report.isLimited, given);
  known.addNonzero("trimmed_area", report.counts.trimmedArea, given);
  known.addNonzero("largest_error", report.largestError, given);
  const SourceBounds& bounds = report.sourceBounds;
  if (bounds.source.low[0] <= bounds.source.high[0])
  {
    addBounds(bounds, known);
  }
  return known;
}

Facts factsOf(const SampleReport& report, Facts known)
{
  const std::size_t given = known.count();
  for (const SampleRow& row : kSampleRows)
  {
    known.addNonzero(row.name, row.get(report), given);
  }
  return known;
}

std::vector<Message> messages(Topic topic, Wording wording, Facts facts)
{
  topic == Topic::Refusal           ? addOfRefusal(wording, facts)
    : topic == Topic::Places        ? addOfPlaces(facts)
    : topic == Topic::Triangulation ? addOfTriangulation(facts)
                                    : void();
  std::vector<Message> made;
  for (const Row& row : kRows)
  {
    const bool isFirst = made.empty() || topic != Topic::Refusal;
    if (row.topic == topic && isFirst && holds(facts, row.when))
    {
      made.push_back({ row.name, Sentence(facts, wording)(row.text) });
    }
  }
  return made;
}

} // namespace ahd
