// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDSampleMessages.h"

#include "Engine/Points/JoinedBounds.h"
#include "Pipeline/vtkAHDSay.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{
void AddBox(ahd::Facts& facts, const char* name, const ahd::Bounds& box)
{
  if (ahd::isEmpty(box))
  {
    facts.add({ name, "nowhere" });
    return;
  }
  for (const double end : { box.xmin, box.xmax, box.ymin, box.ymax })
  {
    facts.add({ name, end });
  }
}

void AddNames(ahd::Facts& facts, const char* name, const std::vector<std::string>& names)
{
  for (const std::string& one : names)
  {
    facts.add({ name, one });
  }
}
}

void vtkAHDSayNoRaster(
  vtkAlgorithm* filter, const vtkAHDSampleSettings& settings, const vtkAHDRaster& raster)
{
  // In the order of vtkAHDRasterFault.
  const char* const names[] = { "", "", "cell_size", "bounds", "too_many", "too_wide",
    "out_of_numbers" };
  ahd::Facts facts{ { "raster", names[std::size_t(raster.Fault)] },
    { "cell_width", settings.Raster.CellSize[0] }, { "cell_height", settings.Raster.CellSize[1] },
    { "columns", raster.Wished[0] }, { "rows", raster.Wished[1] } };
  for (const double bound : settings.Bounds)
  {
    facts.add({ "bounds", bound });
  }
  vtkAHDSay(filter, ahd::Topic::Refusal, facts);
}

bool vtkAHDAreNamesFit(vtkAlgorithm* filter, const vtkAHDSampleSettings& settings)
{
  ahd::Facts facts{ { "heights_name", settings.Heights }, { "mask_name", settings.Mask } };
  if (settings.MakesGradients() && !settings.Heights.empty())
  {
    facts.add({ "gradients_name", settings.Heights + vtkAHDSampleColumns::kGradient });
  }
  return !vtkAHDSay(filter, ahd::Topic::Refusal, facts);
}

void vtkAHDSayMemory(vtkAlgorithm* filter, const vtkAHDSampleMemory& memory, bool isRefused)
{
  vtkAHDSay(filter, ahd::Topic::Refusal,
    { { "reason", isRefused ? ahd::Reason::MemoryLimit : ahd::Reason::OutOfMemory },
      { "doing", "interpolating" }, { "places", memory.Places }, { "points", memory.Points },
      { "memory_estimate", memory.Estimate }, { "is_in_kib", true },
      { "memory_allowed", memory.Limit }, { "memory_limit", memory.IsLimited },
      { "of_triangulation", true } });
}

void vtkAHDSayArrayWarnings(
  vtkAlgorithm* filter, const vtkAHDSampleSettings& settings, const vtkAHDSampleColumns& columns)
{
  ahd::Facts facts{ { "gradients_are_missing", settings.Gradients && !settings.MakesGradients() } };
  AddNames(facts, "unfit_array", columns.GetUnfit());
  AddNames(facts, "replaced_array", columns.GetReplaced());
  vtkAHDSay(filter, ahd::Topic::Columns, facts);
}

void vtkAHDSayFolded(vtkAlgorithm* filter, std::size_t triangles, std::size_t missing)
{
  vtkAHDSay(
    filter, ahd::Topic::Refusal, { { "folded_triangles", missing }, { "triangles", triangles } });
}

void vtkAHDSampleResult::Add(const vtkAHDSampleResult& more)
{
  ahd::addCounts(more.Counts, this->Counts);
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
  ahd::Facts facts = ahd::factsOf(result.Counts, { { "triangles", result.Triangles } });
  AddBox(facts, "wanted", result.Wanted);
  AddBox(facts, "surface", result.Surface);
  for (const vtkAHDMissingValues& missing : result.Missing)
  {
    facts.add({ "missing", missing.Name, static_cast<std::int64_t>(missing.Places) });
    facts.add({ "of_points", missing.OfPoints });
    facts.add({ "of_added", missing.OfAdded });
  }
  vtkAHDSay(filter, ahd::Topic::Places, facts);
}
