// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDSampling.h"

#include "Engine/Core/Uninitialised.h"
#include "Engine/Triangulation/Triangulation.h"
#include "Pipeline/vtkAHDArray.h"

#include "vtkCharArray.h"

#include <algorithm>

namespace
{
/// Places outside that are looked up at a time, so that they take little memory.
constexpr std::size_t kBatch = std::size_t(1) << 18;

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
  if (this->Settings.NearestOutside && this->Report.outside > 0)
  {
    this->FillOutside(places, columns);
  }
  columns.Finish(this->Context);
}

void vtkAHDSampling::FindNearest(
  const ahd::SamplePlaces& places, const double* heights, vtkAHDSampleColumns& columns)
{
  ahd::Sampler sampler;
  this->Context.Check(
    sampler.prepare(this->Surface, nullptr, ahd::SampleMethod::Nearest, this->Context));
  const auto numbers = NumbersOf(this->Surface.points().count, this->Context);
  ahd::UninitialisedVector<double> ids;
  ids.resize(places.count());
  const ahd::SampleArray array{ numbers.data(), 1, ids.data(), nullptr };
  this->Context.Check(
    sampler.values(places, &array, 1, BytesOf(this->Mask), this->Report, this->Context));
  this->Report.withoutValue = columns.Gather(heights, ids.data(), places.count(), this->Context);
}

/// Batch by batch, in the order of the places.
void vtkAHDSampling::FillOutside(const ahd::SamplePlaces& places, vtkAHDSampleColumns& columns)
{
  ahd::Sampler sampler;
  this->Context.Check(
    sampler.prepare(this->Surface, nullptr, ahd::SampleMethod::Nearest, this->Context));
  const auto numbers = NumbersOf(this->Surface.points().count, this->Context);
  const unsigned char* const mask = BytesOf(this->Mask);
  std::vector<std::size_t> at;
  std::vector<double> xy, ids;
  const auto fill = [&]
  {
    ids.resize(at.size());
    const ahd::SamplePlaces batch(ahd::PointView(xy.data(), at.size(), 2));
    const ahd::SampleArray array{ numbers.data(), 1, ids.data(), nullptr };
    ahd::SampleReport report;
    this->Context.Check(sampler.values(batch, &array, 1, nullptr, report, this->Context));
    if (report.valued == at.size()) // else there are no vertices
    {
      columns.Copy(at, ids);
    }
    at.clear();
    xy.clear();
  };
  for (std::size_t k = 0; k < places.count(); ++k)
  {
    if (k % (std::size_t(1) << 14) == 0)
    {
      this->Context.StopIfAborted();
    }
    const ahd::Point p = places[k];
    if (mask[k] != 0 || !ahd::isFinite(p))
    {
      continue;
    }
    at.push_back(k);
    xy.push_back(p.x);
    xy.push_back(p.y);
    if (at.size() == kBatch)
    {
      fill();
    }
  }
  fill();
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
  if (settings.NearestOutside && !settings.IsNearest())
  {
    // a second Sampler, the numbers of the points, and a batch as vectors grow
    const ahd::SamplePlaces batch(ahd::PointView(static_cast<const double*>(nullptr), kBatch, 2));
    bytes += double(ahd::sampleMemoryEstimate(points, batch, 1)) + 8.0 * double(points) +
      double(kBatch) * 2 * 32;
  }
  return bytes;
}
