// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
#include "vtkAdaptiveHilbertInterpolationAlgorithm.h"

#include "Engine/Job/ReportRows.h"
#include "Pipeline/vtkAHDAttributes.h"
#include "Pipeline/vtkAHDMeasuresText.h"
#include "Pipeline/vtkAHDSetters.h"
#include "Pipeline/vtkAHDSettingsOfRanks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

vtkAdaptiveHilbertInterpolationAlgorithm::vtkAdaptiveHilbertInterpolationAlgorithm() = default;
vtkAdaptiveHilbertInterpolationAlgorithm::~vtkAdaptiveHilbertInterpolationAlgorithm() = default;

void vtkAdaptiveHilbertInterpolationAlgorithm::SetDimensions(int value0, int value1)
{
  const std::array<int, 2> values = { std::max<int>(0, value0), std::max<int>(0, value1) };
  if (!std::equal(values.begin(), values.end(), this->Dimensions))
  {
    std::copy(values.begin(), values.end(), this->Dimensions);
    this->Modified();
  }
}

void vtkAdaptiveHilbertInterpolationAlgorithm::SetDimensions(const int values[2])
{
  this->SetDimensions(values[0], values[1]);
}

void vtkAdaptiveHilbertInterpolationAlgorithm::SetNoValue(double value)
{
  vtkAHDSetAny(this, this->NoValue, value);
}

void vtkAdaptiveHilbertInterpolationAlgorithm::SetHeightArrayName(const std::string& name)
{
  vtkAHDSetAny(this, this->HeightArrayName, name);
}

void vtkAdaptiveHilbertInterpolationAlgorithm::SetValidPointMaskArrayName(const std::string& name)
{
  vtkAHDSetAny(this, this->ValidPointMaskArrayName, name);
}

void vtkAdaptiveHilbertInterpolationAlgorithm::ClearMeasures()
{
  this->NumberOfPlaces = 0;
  this->NumberOfValidPlaces = 0;
  this->NumberOfPlacesOutside = 0;
  this->NumberOfNotFinitePlaces = 0;
  this->NumberOfPlacesWithoutValue = 0;
  this->NumberOfPlacesWithNeighborsLeftOut = 0;
  this->SampleSeconds = 0.0;
  this->MemoryEstimate = 0;
}

void vtkAdaptiveHilbertInterpolationAlgorithm::AddMeasures(const ahd::SampleReport& report)
{
  const auto count = [&report](const char* name)
  { return ahd::findRow(ahd::kSampleRows, name)->get(report); };
  this->NumberOfPlaces += static_cast<vtkIdType>(count("sampled_places"));
  this->NumberOfValidPlaces += static_cast<vtkIdType>(count("sampled_valued"));
  this->NumberOfPlacesOutside += static_cast<vtkIdType>(count("sampled_outside"));
  this->NumberOfNotFinitePlaces += static_cast<vtkIdType>(count("sampled_not_finite"));
  this->NumberOfPlacesWithoutValue += static_cast<vtkIdType>(count("sampled_without_value"));
  this->NumberOfPlacesWithNeighborsLeftOut += static_cast<vtkIdType>(count("sampled_left_out"));
}

void vtkAdaptiveHilbertInterpolationAlgorithm::AddCounts(
  const ahd::SampleReport& report, vtkFieldData* data)
{
  const auto count = [&report](const char* name)
  { return ahd::findRow(ahd::kSampleRows, name)->get(report); };
  const std::pair<const char*, std::size_t> counts[] = {
    { "NumberOfPlaces", count("sampled_places") },
    { "NumberOfValidPlaces", count("sampled_valued") },
    { "NumberOfPlacesOutside", count("sampled_outside") },
    { "NumberOfNotFinitePlaces", count("sampled_not_finite") },
    { "NumberOfPlacesWithoutValue", count("sampled_without_value") },
    { "NumberOfPlacesWithNeighborsLeftOut", count("sampled_left_out") },
  };
  for (const auto& one : counts)
  {
    vtkAHDAddCount(one.first, static_cast<vtkIdType>(one.second), data);
  }
}

void vtkAdaptiveHilbertInterpolationAlgorithm::GetSettingsOfRanks(
  vtkAHDSettingsOfRanks& settings) const
{
  settings.Numbers = {
    { "Method", double(this->Method) },
    { "RasterSize", double(this->RasterSize) },
    { "Dimensions", double(this->Dimensions[0]) },
    { "Dimensions", double(this->Dimensions[1]) },
    { "CellSize", double(this->CellSize[0]) },
    { "CellSize", double(this->CellSize[1]) },
    { "AlignToCellSize", double(this->AlignToCellSize) },
    { "UseBounds", double(this->UseBounds) },
    { "Bounds", double(this->Bounds[0]) },
    { "Bounds", double(this->Bounds[1]) },
    { "Bounds", double(this->Bounds[2]) },
    { "Bounds", double(this->Bounds[3]) },
    { "OutputType", double(this->OutputType) },
    { "Outside", double(this->Outside) },
    { "NoValue", double(this->NoValue) },
    { "GenerateGradients", double(this->GenerateGradients) },
  };
  settings.Texts = {
    this->HeightArrayName,
    this->ValidPointMaskArrayName,
  };
}

std::string vtkAdaptiveHilbertInterpolationAlgorithm::GetMeasures()
{
  return vtkAHDMeasuresText({
    { "places", double(this->NumberOfPlaces), 0, false },
    { "on the surface", double(this->NumberOfValidPlaces), 0, false },
    { "outside", double(this->NumberOfPlacesOutside), 0, false },
    { "NaN or infinite", double(this->NumberOfNotFinitePlaces), 0, false },
    { "values missing (NaN around them)", double(this->NumberOfPlacesWithoutValue), 0, false },
    { "values lacking neighbours", double(this->NumberOfPlacesWithNeighborsLeftOut), 0, false },
  });
}

std::string vtkAdaptiveHilbertInterpolationAlgorithm::GetResources()
{
  return vtkAHDMeasuresText({
    { "s to interpolate", double(this->SampleSeconds), 0, true },
    { "triangulations so far", double(this->NumberOfTriangulations), 0, false },
    { "KiB of memory at most", double(this->MemoryEstimate), 0, false },
  });
}

void vtkAdaptiveHilbertInterpolationAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "RasterSize: " << this->RasterSize << "\n";
  os << indent << "Dimensions: " << this->Dimensions[0] << ", " << this->Dimensions[1] << "\n";
  os << indent << "CellSize: " << this->CellSize[0] << ", " << this->CellSize[1] << "\n";
  os << indent << "AlignToCellSize: " << (this->AlignToCellSize ? "On\n" : "Off\n");
  os << indent << "UseBounds: " << (this->UseBounds ? "On\n" : "Off\n");
  os << indent << "Bounds: " << this->Bounds[0] << ", " << this->Bounds[1] << ", "
     << this->Bounds[2] << ", " << this->Bounds[3] << "\n";
  os << indent << "OutputType: " << this->OutputType << "\n";
  os << indent << "Outside: " << this->Outside << "\n";
  os << indent << "NoValue: " << this->NoValue << "\n";
  os << indent << "GenerateGradients: " << (this->GenerateGradients ? "On\n" : "Off\n");
  os << indent << "HeightArrayName: " << this->HeightArrayName << "\n";
  os << indent << "ValidPointMaskArrayName: " << this->ValidPointMaskArrayName << "\n";
  os << indent << "NumberOfPlaces: " << this->NumberOfPlaces << "\n";
  os << indent << "NumberOfValidPlaces: " << this->NumberOfValidPlaces << "\n";
  os << indent << "NumberOfPlacesOutside: " << this->NumberOfPlacesOutside << "\n";
  os << indent << "NumberOfNotFinitePlaces: " << this->NumberOfNotFinitePlaces << "\n";
  os << indent << "NumberOfPlacesWithoutValue: " << this->NumberOfPlacesWithoutValue << "\n";
  os << indent << "NumberOfPlacesWithNeighborsLeftOut: " << this->NumberOfPlacesWithNeighborsLeftOut
     << "\n";
  os << indent << "SampleSeconds: " << this->SampleSeconds << "\n";
  os << indent << "NumberOfTriangulations: " << this->NumberOfTriangulations << "\n";
  os << indent << "MemoryEstimate: " << this->MemoryEstimate << "\n";
}
