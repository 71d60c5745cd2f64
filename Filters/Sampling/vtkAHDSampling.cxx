// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDSampling.h"

#include "Engine/Core/Uninitialised.h"
#include "Engine/Sample/Outside.h"
#include "Engine/Triangulation/Triangulation.h"
#include "Pipeline/vtkAHDArray.h"

#include "vtkCharArray.h"

namespace
{
/// Each point's number, as a value to interpolate.
ahd::UninitialisedVector<double> NumbersOf(std::size_t count, const vtkAHDContext& context)
{
  ahd::UninitialisedVector<double> numbers;
  numbers.resize(count);
  context.ForRange(count,
    [&numbers](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        numbers[i] = double(i);
      }
    });
  return numbers;
}

unsigned char* BytesOf(vtkCharArray* mask)
{
  return reinterpret_cast<unsigned char*>(mask->GetPointer(0));
}
}

void vtkAHDSampling::Run(
  const ahd::SamplePlaces& places, const double* heights, vtkAHDSampleColumns& columns)
{
  this->Mask = vtkAHDNewArray<vtkCharArray>(static_cast<vtkIdType>(places.count()));
  this->Settings.IsNearest() ? this->FindNearest(places, heights, columns)
                             : this->Interpolate(places, heights, columns);
}

void vtkAHDSampling::Interpolate(
  const ahd::SamplePlaces& places, const double* heights, vtkAHDSampleColumns& columns)
{
  columns.Open(heights, places.count(), this->Context);
  ahd::Sampler sampler;
  this->Context.Check(
    sampler.prepare(this->Surface, this->Kept, this->Settings.Method, this->Context));
  const std::vector<ahd::SampleArray>& arrays = columns.GetArrays();
  this->Context.Check(sampler.values(
    places, arrays.data(), arrays.size(), BytesOf(this->Mask), this->Report, this->Context));
  if (this->Report.withoutValue > 0)
  {
    columns.CountMissing(this->Mask->GetPointer(0), this->Context);
  }
  if (this->Settings.FillsOutside() && this->Report.outside > 0)
  {
    this->FillOutside(sampler, places, arrays);
  }
  columns.Finish(this->Context);
}

void vtkAHDSampling::FindNearest(
  const ahd::SamplePlaces& places, const double* heights, vtkAHDSampleColumns& columns)
{
  ahd::Sampler sampler;
  this->Context.Check(
    sampler.prepare(this->Surface, this->Kept, ahd::SampleMethod::Nearest, this->Context));
  const auto numbers = NumbersOf(this->Surface.points().count, this->Context);
  ahd::UninitialisedVector<double> ids;
  ids.resize(places.count());
  const ahd::SampleArray array{ numbers.data(), 1, ids.data(), nullptr };
  this->Context.Check(
    sampler.values(places, &array, 1, BytesOf(this->Mask), this->Report, this->Context));
  this->Report.withoutValue = columns.Gather(heights, ids.data(), places.count(), this->Context);
}

void vtkAHDSampling::FillOutside(const ahd::Sampler& inside, const ahd::SamplePlaces& places,
  const std::vector<ahd::SampleArray>& arrays)
{
  const bool isBoundary = this->Settings.Outside == ahd::OutsideValues::Boundary;
  ahd::Sampler nearest;
  if (!isBoundary)
  {
    this->Context.Check(
      nearest.prepare(this->Surface, this->Kept, ahd::SampleMethod::Nearest, this->Context));
  }
  this->Context.Check(ahd::fillOutside(isBoundary ? inside : nearest, places, arrays.data(),
    arrays.size(), BytesOf(this->Mask), this->Context));
}

double vtkAHDSampling::EstimateBytes(const vtkAHDSampleSettings& settings,
  const vtkAHDSampleColumns& columns, std::size_t points, const ahd::SamplePlaces& places)
{
  const double count = places.isRaster()
    ? double(places.raster().columns) * double(places.raster().rows)
    : double(places.count());
  const std::size_t components = settings.IsNearest() ? 1 : columns.GetNumberOfComponents();
  double bytes = columns.EstimateBytes(points, count) +
    double(ahd::sampleMemoryEstimate(points, places, components));
  if (settings.FillsOutside())
  {
    bytes += double(ahd::fillOutsideMemoryEstimate(points, places, components));
  }
  return bytes;
}
