// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDSampleMessages.h"

#include "Engine/Points/JoinedBounds.h"
#include "Pipeline/vtkAHDMemoryWords.h"

#include "vtkAlgorithm.h"
#include "vtkDataSetAttributes.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace
{
/// A number as short as it can be and still be told from its neighbours at 9 digits.
std::string InWords(double number)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", number);
  return text;
}

std::string InWords(const ahd::Bounds& box)
{
  if (ahd::isEmpty(box))
  {
    return "nowhere";
  }
  return "x " + InWords(box.xmin) + " to " + InWords(box.xmax) + ", y " + InWords(box.ymin) +
    " to " + InWords(box.ymax);
}

/// "a, b and 3 more".
std::string InWords(const std::vector<std::string>& names)
{
  constexpr std::size_t kMost = 5;
  std::string words;
  for (std::size_t k = 0; k < std::min(names.size(), kMost); ++k)
  {
    words += (k == 0 ? "" : ", ") + names[k];
  }
  return names.size() <= kMost ? words
                               : words + " and " + std::to_string(names.size() - kMost) + " more";
}

void WarnOfPlaces(vtkAlgorithm* filter, const vtkAHDSampleResult& result)
{
  const ahd::SampleReport& counts = result.Counts;
  if (counts.notFinite > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "" << counts.notFinite << " of " << result.Places
         << " places have no value, since their x or y is NaN or infinite.");
  }
  if (counts.outside > 0 && counts.valued == 0)
  {
    vtkWarningWithObjectMacro(filter,
      "None of " << result.Places << " places is on the surface"
                 << (result.Triangles > 0 ? " of " + std::to_string(result.Triangles) + " triangles"
                                          : std::string())
                 << ". Places: " << InWords(result.Wanted)
                 << "; points: " << InWords(result.Surface) << ".");
  }
}

/// The names of those that are counted by `isOne`, with `begin` before them and a full stop behind;
/// empty without any.
template <typename IsOne>
std::string ListOf(
  const vtkAHDSampleResult& result, const std::string& begin, const IsOne& isOne, bool hasCounts)
{
  std::vector<std::string> names;
  for (const vtkAHDMissingValues& missing : result.Missing)
  {
    if (isOne(missing))
    {
      const std::string count = hasCounts ? std::to_string(missing.Places) : std::string();
      const std::string heights = missing.Places == 1 && hasCounts ? "height" : "heights";
      names.push_back(missing.Name.empty() ? count + (hasCounts ? " " : "") + heights
                                           : count + (hasCounts ? " of " : "") + missing.Name);
    }
  }
  return names.empty() ? std::string() : begin + InWords(names) + ".";
}

void WarnOfValues(vtkAlgorithm* filter, const vtkAHDSampleResult& result)
{
  const ahd::SampleReport& counts = result.Counts;
  const std::string lack = " Points that were added (of the source, for example) lack ";
  if (counts.withoutValue > 0)
  {
    const bool areHeights = !result.Missing.empty() && result.Missing.front().Name.empty() &&
      result.Missing.front().Places > 0;
    vtkWarningWithObjectMacro(filter,
      "" << counts.withoutValue
         << " values at places on the surface are none, since values of points are NaN"
         << ListOf(
              result, ": ", [](const vtkAHDMissingValues& missing) { return missing.Places > 0; },
              true)
         << (areHeights ? "" : " No height is missing.")
         << ListOf(
              result, lack,
              [](const vtkAHDMissingValues& missing)
              { return missing.OfAdded && missing.Places > 0; },
              false));
  }
  if (counts.leftOut > 0)
  {
    vtkWarningWithObjectMacro(filter,
      "" << counts.leftOut
         << " values at places are interpolated without some of their natural neighbours, whose "
            "values are NaN"
         << ListOf(
              result, ": ", [](const vtkAHDMissingValues& missing) { return missing.OfPoints; },
              false)
         << ListOf(
              result, lack, [](const vtkAHDMissingValues& missing) { return missing.OfAdded; },
              false));
  }
}
}

void vtkAHDSayNoRaster(
  vtkAlgorithm* filter, const vtkAHDSampleSettings& settings, const vtkAHDRaster& raster)
{
  const std::string size = InWords(settings.Raster.CellSize[0]) + ", " +
    InWords(settings.Raster.CellSize[1]);
  switch (raster.Fault)
  {
    case vtkAHDRasterFault::None:
    case vtkAHDRasterFault::NoArea:
      return;
    case vtkAHDRasterFault::CellSize:
      vtkErrorWithObjectMacro(filter,
        "CellSize is " << size
                       << ", but both numbers must be greater than 0 and finite. Nothing was "
                          "computed.");
      return;
    case vtkAHDRasterFault::Bounds:
      vtkErrorWithObjectMacro(filter,
        "Bounds are x " << InWords(settings.Bounds[0]) << " to " << InWords(settings.Bounds[1])
                        << ", y " << InWords(settings.Bounds[2]) << " to "
                        << InWords(settings.Bounds[3])
                        << ", but they must be finite, the first of each two below the second. "
                           "Nothing was computed.");
      return;
    case vtkAHDRasterFault::TooMany:
      vtkErrorWithObjectMacro(filter,
        "With a CellSize of " << size << " the raster would have " << InWords(raster.Wished[0])
                              << " x " << InWords(raster.Wished[1])
                              << " cells, but 2147483647 along x and y are the most. Nothing was "
                                 "computed.");
      return;
    case vtkAHDRasterFault::TooWide:
      vtkErrorWithObjectMacro(filter,
        "The raster would be wider or higher than the largest number of double precision, "
        "1.8e+308. "
        "Nothing was computed.");
      return;
    case vtkAHDRasterFault::OutOfNumbers:
      vtkErrorWithObjectMacro(filter,
        "A raster of " << InWords(raster.Wished[0]) << " x " << InWords(raster.Wished[1])
                       << " cells has coordinates that double precision cannot tell apart. Nothing "
                          "was computed.");
  }
}

bool vtkAHDAreNamesFit(vtkAlgorithm* filter, const vtkAHDSampleSettings& settings)
{
  const std::string ghosts = vtkDataSetAttributes::GhostArrayName();
  const bool areHeights = settings.Heights == ghosts;
  if (areHeights || settings.Mask == ghosts)
  {
    vtkErrorWithObjectMacro(filter,
      "" << (areHeights ? "HeightArrayName" : "ValidPointMaskArrayName") << " is \"" << ghosts
         << "\", the name of the marks by which VTK hides points. Nothing was computed.");
    return false;
  }
  if (!settings.Mask.empty() && settings.Mask == settings.Heights)
  {
    vtkErrorWithObjectMacro(filter,
      "HeightArrayName and ValidPointMaskArrayName are both \""
        << settings.Mask << "\", but two arrays cannot have one name. Nothing was computed.");
    return false;
  }
  if (settings.MakesGradients() && !settings.Heights.empty() &&
    settings.Mask == settings.Heights + vtkAHDSampleColumns::kGradient)
  {
    vtkErrorWithObjectMacro(filter,
      "ValidPointMaskArrayName is \""
        << settings.Mask << "\", the name of the gradients of the heights. Nothing was computed.");
    return false;
  }
  return true;
}

void vtkAHDSayMemory(vtkAlgorithm* filter, const vtkAHDSampleMemory& memory, bool isRefused)
{
  const std::string places = memory.Places < 0.0 ? "the places of a raster"
                                                 : InWords(memory.Places) + " places";
  if (isRefused)
  {
    vtkErrorWithObjectMacro(filter,
      "Interpolating at " << places << " from " << memory.Points << " points may take "
                          << vtkAHDNeeded(memory.Estimate) << " of memory, but "
                          << vtkAHDButAllowed(memory.Limit, memory.IsLimited, "of Triangulation ")
                          << ". Nothing was computed. Take a larger CellSize, smaller Dimensions, "
                             "fewer places or points, "
                          << vtkAHDOrSetLimit(memory.Estimate));
    return;
  }
  vtkErrorWithObjectMacro(filter,
    "Out of memory while interpolating at " << places << " from " << memory.Points
                                            << " points; about " << vtkAHDNeeded(memory.Estimate)
                                            << " are needed. Take a larger CellSize, smaller "
                                               "Dimensions, fewer places or points.");
}

void vtkAHDSayArrayWarnings(
  vtkAlgorithm* filter, const vtkAHDSampleSettings& settings, const vtkAHDSampleColumns& columns)
{
  if (!columns.GetUnfit().empty())
  {
    vtkWarningWithObjectMacro(filter,
      "Point arrays that are no numbers, have no name or not one tuple for each point are not "
      "interpolated: "
        << InWords(columns.GetUnfit()) << ".");
  }
  if (!columns.GetReplaced().empty())
  {
    vtkWarningWithObjectMacro(filter,
      "Point arrays of the input whose names are those of arrays that are made are not "
      "interpolated: "
        << InWords(columns.GetReplaced()) << ". See HeightArrayName and ValidPointMaskArrayName.");
  }
  if (settings.Gradients && !settings.MakesGradients())
  {
    vtkWarningWithObjectMacro(filter, "There are no gradients: only the Method Linear has them.");
  }
}

void vtkAHDSayFolded(vtkAlgorithm* filter, std::size_t triangles, std::size_t missing)
{
  vtkErrorWithObjectMacro(filter,
    ""
      << missing << " of the " << triangles
      << " triangles of the surface cross others in the plane of Triangulation, or are turned over "
         "there. Nothing was computed. Set its ProjectionPlaneMode to that of the surface, or take "
         "the points without the triangles.");
}

void vtkAHDSampleResult::Add(const vtkAHDSampleResult& more)
{
  this->Counts.valued += more.Counts.valued;
  this->Counts.outside += more.Counts.outside;
  this->Counts.notFinite += more.Counts.notFinite;
  this->Counts.withoutValue += more.Counts.withoutValue;
  this->Counts.leftOut += more.Counts.leftOut;
  this->Places += more.Places;
  this->AddMissing(more.Missing);
  this->Triangles = more.Triangles;
  this->Surface = ahd::isEmpty(this->Surface) ? more.Surface : this->Surface;
  this->Wanted = ahd::joined(this->Wanted, more.Wanted);
}

void vtkAHDSampleResult::AddMissing(const std::vector<vtkAHDMissingValues>& more)
{
  for (const vtkAHDMissingValues& one : more)
  {
    const auto found = std::find_if(this->Missing.begin(), this->Missing.end(),
      [&one](const vtkAHDMissingValues& other) { return other.Name == one.Name; });
    if (found == this->Missing.end())
    {
      this->Missing.push_back(one);
      continue;
    }
    found->Places += one.Places;
    found->OfPoints = found->OfPoints || one.OfPoints;
    found->OfAdded = found->OfAdded || one.OfAdded;
  }
}

void vtkAHDSayPlaceWarnings(vtkAlgorithm* filter, const vtkAHDSampleResult& result)
{
  WarnOfPlaces(filter, result);
  WarnOfValues(filter, result);
}
