// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
#include "vtkAdaptiveHilbertQualityMeshAlgorithm.h"

#include "Pipeline/vtkAHDAttributes.h"
#include "Pipeline/vtkAHDMeasuresText.h"
#include "Pipeline/vtkAHDSetters.h"

#include <utility>

vtkAdaptiveHilbertQualityMeshAlgorithm::vtkAdaptiveHilbertQualityMeshAlgorithm() = default;
vtkAdaptiveHilbertQualityMeshAlgorithm::~vtkAdaptiveHilbertQualityMeshAlgorithm() = default;

void vtkAdaptiveHilbertQualityMeshAlgorithm::SetMinimumAngle(double value)
{
  vtkAHDSetClamped(this, this->MinimumAngle, value, 0.0, 34.0);
}

void vtkAdaptiveHilbertQualityMeshAlgorithm::SetMaximumArea(double value)
{
  vtkAHDSetClamped(this, this->MaximumArea, value, 0.0, VTK_DOUBLE_MAX);
}

void vtkAdaptiveHilbertQualityMeshAlgorithm::SetMaximumLength(double value)
{
  vtkAHDSetClamped(this, this->MaximumLength, value, 0.0, VTK_DOUBLE_MAX);
}

void vtkAdaptiveHilbertQualityMeshAlgorithm::SetSizeArrayName(const std::string& name)
{
  vtkAHDSetAny(this, this->SizeArrayName, name);
}

void vtkAdaptiveHilbertQualityMeshAlgorithm::ClearMeasures()
{
  this->NumberOfTriangles = 0;
  this->NumberOfAddedPoints = 0;
  this->NumberOfPointsAddedToSegments = 0;
  this->NumberOfBadTriangles = 0;
  this->NumberOfEncroachedPieces = 0;
  this->LeastAngle = 0.0;
  this->MemoryEstimate = 0;
}

void vtkAdaptiveHilbertQualityMeshAlgorithm::AddCounts(vtkFieldData* data) const
{
  const std::pair<const char*, vtkIdType> counts[] = {
    { "NumberOfTriangles", this->NumberOfTriangles },
    { "NumberOfAddedPoints", this->NumberOfAddedPoints },
    { "NumberOfPointsAddedToSegments", this->NumberOfPointsAddedToSegments },
    { "NumberOfBadTriangles", this->NumberOfBadTriangles },
    { "NumberOfEncroachedPieces", this->NumberOfEncroachedPieces },
  };
  for (const auto& count : counts)
  {
    vtkAHDAddCount(count.first, count.second, data);
  }
}

std::string vtkAdaptiveHilbertQualityMeshAlgorithm::GetMeasures()
{
  return vtkAHDMeasuresText({
    { "triangles", double(this->NumberOfTriangles), 0, false },
    { "points added", double(this->NumberOfAddedPoints), 0, false },
    { "of these on segments", double(this->NumberOfPointsAddedToSegments), 0, false },
    { "triangles not as wished", double(this->NumberOfBadTriangles), 0, false },
    { "pieces of segments not split", double(this->NumberOfEncroachedPieces), 0, false },
    { "degrees in the least angle", double(this->LeastAngle), 0, true },
  });
}

std::string vtkAdaptiveHilbertQualityMeshAlgorithm::GetResources()
{
  return vtkAHDMeasuresText({
    { "KiB of memory at most", double(this->MemoryEstimate), 0, false },
  });
}

void vtkAdaptiveHilbertQualityMeshAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MinimumAngle: " << this->MinimumAngle << "\n";
  os << indent << "MaximumArea: " << this->MaximumArea << "\n";
  os << indent << "MaximumLength: " << this->MaximumLength << "\n";
  os << indent << "SizeArrayName: " << this->SizeArrayName << "\n";
  os << indent << "MaximumNumberOfAddedPoints: " << this->MaximumNumberOfAddedPoints << "\n";
  os << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
  os << indent << "NumberOfAddedPoints: " << this->NumberOfAddedPoints << "\n";
  os << indent << "NumberOfPointsAddedToSegments: " << this->NumberOfPointsAddedToSegments << "\n";
  os << indent << "NumberOfBadTriangles: " << this->NumberOfBadTriangles << "\n";
  os << indent << "NumberOfEncroachedPieces: " << this->NumberOfEncroachedPieces << "\n";
  os << indent << "LeastAngle: " << this->LeastAngle << "\n";
  os << indent << "MemoryEstimate: " << this->MemoryEstimate << "\n";
}
