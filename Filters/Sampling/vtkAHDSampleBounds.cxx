// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDSampleBounds.h"

#include "Engine/Prepare/Prepare.h"
#include "Input/vtkAHDInput.h"

#include <algorithm>
#include <limits>
#include <mutex>

namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Contains nothing, and grows.
ahd::Bounds Nothing()
{
  ahd::Bounds none;
  none.xmin = none.ymin = kInfinity;
  none.xmax = none.ymax = -kInfinity;
  return none;
}

void Grow(ahd::Bounds& box, double x0, double x1, double y0, double y1)
{
  box.xmin = std::min(box.xmin, x0);
  box.xmax = std::max(box.xmax, x1);
  box.ymin = std::min(box.ymin, y0);
  box.ymax = std::max(box.ymax, y1);
}

/// Only the settings that determine the points' positions.
ahd::InputRequest OnlyPlaces(ahd::InputRequest request)
{
  request.lines = ahd::CellsView();
  request.polygons = ahd::CellsView();
  request.tolerance = 0.0;
  request.split = false;
  request.heights = ahd::SourceHeights::Own;
  return request;
}
}

std::size_t vtkAHDEstimateBounds(const vtkAHDSettings& settings, const vtkAHDSampleSettings& wishes,
  vtkPointSet* input, vtkPolyData* source)
{
  if (wishes.UseBounds)
  {
    return 0;
  }
  const vtkAHDInput view(settings, input, source);
  return view.EstimateBytes() + ahd::preparationMemoryEstimate(OnlyPlaces(view.GetRequest()));
}

ahd::Bounds vtkAHDBoundsOf(const ahd::PointView& points, const vtkAHDContext& context)
{
  const vtkAHDProgress::Silence whileTheyAreRead(context.GetProgress());
  context.StopIfAborted();
  ahd::Bounds all = Nothing();
  std::mutex mutex;
  context.ForRange(points.count,
    [&](std::size_t begin, std::size_t end)
    {
      ahd::Bounds piece = Nothing();
      for (std::size_t i = begin; i < end; ++i)
      {
        const ahd::Point p = points[i];
        if (ahd::isFinite(p) && !points.skipped(i))
        {
          Grow(piece, p.x, p.x, p.y, p.y);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      Grow(all, piece.xmin, piece.xmax, piece.ymin, piece.ymax);
    });
  if (all.xmin > all.xmax)
  {
    return ahd::Bounds();
  }
  // Of zeros of both signs it is chance which one comes first.
  for (double* bound : { &all.xmin, &all.xmax, &all.ymin, &all.ymax })
  {
    *bound += 0.0;
  }
  return all;
}

ahd::Bounds vtkAHDFindBounds(const vtkAHDSettings& settings, vtkPointSet* input,
  vtkPolyData* source, const vtkAHDContext& context)
{
  vtkAHDInput view(settings, input, source);
  view.Open(context);
  const ahd::InputRequest request = OnlyPlaces(view.GetRequest());
  if (!settings.isProjected() && !settings.addsBounding() && request.sourcePoints.count == 0)
  {
    return vtkAHDBoundsOf(request.points, context);
  }
  ahd::PreparedInput points;
  context.Check(ahd::prepare(request, context, points));
  return vtkAHDBoundsOf(points.points(), context);
}

vtkAHDRaster vtkAHDFindRaster(const vtkAHDSettings& settings, const vtkAHDSampleSettings& wishes,
  vtkPointSet* input, vtkPolyData* source, const vtkAHDContext& context)
{
  const auto points = static_cast<std::size_t>(input->GetNumberOfPoints());
  return wishes.UseBounds
    ? vtkAHDMakeRasterWithin(wishes.Raster, wishes.Bounds, points)
    : vtkAHDMakeRaster(wishes.Raster, vtkAHDFindBounds(settings, input, source, context), points);
}
