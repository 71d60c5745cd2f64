// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPlanarPointSource.h"

#include "Distributions/PlanarPoints.h"
#include "Engine/Core/FloatingPoint.h"
#include "Engine/Core/Memory.h"
#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDProgress.h"
#include "Pipeline/vtkAHDSay.h"
#include "Pipeline/vtkAHDSetters.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>

vtkStandardNewMacro(vtkPlanarPointSource);

static_assert(int(vtkPlanarPointSource::UNIFORM) == int(ahd::PlanarDistribution::Uniform) &&
    int(vtkPlanarPointSource::MIXED) == int(ahd::PlanarDistribution::Mixed) &&
    int(vtkPlanarPointSource::LATTICE) == int(ahd::PlanarDistribution::Lattice),
  "the same numbers here and there");

namespace
{
/// Points made between two askings whether to abort.
constexpr vtkIdType kPiece = vtkIdType(1) << 14;

/// The destination of the points.
template <typename Number>
struct Arrays
{
  Number* Xyz;       // three for each point
  vtkTypeInt32* Ids; // of the vertex cell
  vtkIdType Count;   // of points
  double Scale, HillHeight;
};

/// Makes all points; false on an abort.
template <typename Number>
bool Fill(const Arrays<Number>& to, ahd::PlanarPoints& points, vtkAlgorithm* source)
{
  vtkAHDProgress progress(source);
  progress.beginPhase(ahd::Phase::Insert); // the one that is the whole
  for (vtkIdType begin = 0; begin < to.Count; begin += kPiece)
  {
    if (!progress.advance(ahd::Phase::Insert, double(begin) / double(to.Count)))
    {
      return false;
    }
    const vtkIdType end = std::min(to.Count, begin + kPiece);
    for (vtkIdType i = begin; i < end; ++i)
    {
      const ahd::Place p = points.next();
      const double z = to.HillHeight > 0.0 ? to.HillHeight * points.hillAt(p) : 0.0;
      to.Xyz[3 * i] = static_cast<Number>(to.Scale * p.x);
      to.Xyz[3 * i + 1] = static_cast<Number>(to.Scale * p.y);
      to.Xyz[3 * i + 2] = static_cast<Number>(to.Scale * z);
      to.Ids[i] = static_cast<vtkTypeInt32>(i);
    }
  }
  return true;
}

/// One VTK_POLY_VERTEX. 32 bits hold every id and every offset.
vtkSmartPointer<vtkCellArray> PolyVertex(vtkTypeInt32Array* ids)
{
  auto offsets = vtkAHDNewArray<vtkTypeInt32Array>(2);
  offsets->SetValue(0, 0);
  offsets->SetValue(1, static_cast<vtkTypeInt32>(ids->GetNumberOfValues()));
  auto vertices = vtkSmartPointer<vtkCellArray>::New();
  vertices->SetData(offsets, ids);
  return vertices;
}
}

vtkPlanarPointSource::vtkPlanarPointSource()
{
  this->SetNumberOfInputPorts(0);
}

void vtkPlanarPointSource::SetHillHeight(double height)
{
  vtkAHDSetClamped(
    this, this->HillHeight, height, this->GetHillHeightMinValue(), this->GetHillHeightMaxValue());
}

void vtkPlanarPointSource::SetScale(double scale)
{
  vtkAHDSetClamped(this, this->Scale, scale, this->GetScaleMinValue(), this->GetScaleMaxValue());
}

int vtkPlanarPointSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const ahd::ScopedFloatingPoint asTheEngine;
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  // Errors return 1 as well, as they were told: 0 would have the pipeline tell them once more.
  try
  {
    if (!this->FitsInMemory())
    {
      return 1;
    }
    const bool all = this->OutputPointsPrecision == SINGLE_PRECISION
      ? this->MakePoints<vtkFloatArray>(output)
      : this->MakePoints<vtkDoubleArray>(output);
    if (!all)
    {
      output->Initialize();
    }
  }
  catch (const std::bad_alloc&)
  {
    output->Initialize();
    vtkAHDSayOutOfMemory("vtkPlanarPointSource",
      [this]
      {
        vtkAHDSay(this, ahd::Topic::Refusal,
          { { "reason", ahd::Reason::OutOfMemory }, { "doing", "making" },
            { "points", this->NumberOfPoints } });
      });
  }
  return 1;
}

bool vtkPlanarPointSource::FitsInMemory()
{
  const bool isSingle = this->OutputPointsPrecision == SINGLE_PRECISION;
  const vtkTypeInt64 perPoint = 3 * (isSingle ? sizeof(float) : sizeof(double)) +
    sizeof(vtkTypeInt32);
  const vtkTypeInt64 needed = static_cast<vtkTypeInt64>(this->NumberOfPoints) * perPoint / 1024;
  const vtkTypeInt64 available = static_cast<vtkTypeInt64>(ahd::availableMemory() / 1024);
  if (needed > available)
  {
    vtkAHDSay(this, ahd::Topic::Refusal,
      { { "reason", ahd::Reason::MemoryLimit }, { "doing", "making" },
        { "points", this->NumberOfPoints }, { "memory_estimate", needed }, { "is_in_kib", true },
        { "memory_allowed", available } });
  }
  return needed <= available;
}

/// False if aborted: then the output is not complete.
template <typename Array>
bool vtkPlanarPointSource::MakePoints(vtkPolyData* output)
{
  const vtkIdType count = this->NumberOfPoints;
  auto coordinates = vtkAHDNewArray<Array>(3 * count);
  auto ids = vtkAHDNewArray<vtkTypeInt32Array>(count);
  ahd::PlanarPoints made(static_cast<ahd::PlanarDistribution>(this->Distribution),
    static_cast<std::size_t>(count), static_cast<std::uint64_t>(this->Seed));
  const Arrays<typename Array::ValueType> arrays{ coordinates->GetPointer(0), ids->GetPointer(0),
    count, this->Scale, this->HillHeight };
  if (!Fill(arrays, made, this))
  {
    return false;
  }
  coordinates->SetNumberOfComponents(3);
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  output->SetPoints(points);
  if (count > 0)
  {
    output->SetVerts(PolyVertex(ids));
  }
  return true;
}

void vtkPlanarPointSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Distribution: " << this->Distribution << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "HillHeight: " << this->HillHeight << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
