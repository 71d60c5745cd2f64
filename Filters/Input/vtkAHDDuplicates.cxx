// SPDX-License-Identifier: BSD-3-Clause
#include "Input/vtkAHDDuplicates.h"

#include "vtkCellArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
double Coordinate(const ahd::PointView& points, std::size_t i, std::size_t k)
{
  return points.doubles ? points.doubles[3 * i + k] : double(points.floats[3 * i + k]);
}

/// Calls visit(id, first) for each duplicate, by increasing id; `first` is the vertex there.
/// Returns false if the filter is to abort.
template <typename Visit>
bool ForDuplicates(
  const std::int64_t* fates, std::size_t count, vtkAHDProgress& progress, const Visit& visit)
{
  constexpr std::size_t kPiece = std::size_t(1) << 14;
  for (std::size_t begin = 0; begin < count; begin += kPiece)
  {
    if (progress.MustAbort())
    {
      return false;
    }
    const std::size_t end = std::min(count, begin + kPiece);
    for (std::size_t i = begin; i < end; ++i)
    {
      if (fates[i] >= 0 && fates[i] != std::int64_t(i))
      {
        visit(i, static_cast<std::size_t>(fates[i]));
      }
    }
  }
  return true;
}

bool IsBetter(double z, double than, bool highest)
{
  if (!std::isfinite(z) || !std::isfinite(than))
  {
    return std::isfinite(z) && !std::isfinite(than);
  }
  return highest ? z > than : z < than;
}

/// Of equal numbers that number itself. Sorts, so that their order has no say.
double MeanOf(std::vector<double>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  if (numbers.front() == numbers.back())
  {
    return numbers.front();
  }
  const double count = double(numbers.size());
  double sum = 0.0;
  for (double number : numbers)
  {
    sum += number;
  }
  if (std::isfinite(sum))
  {
    return sum / count;
  }
  double mean = 0.0;
  for (double number : numbers)
  {
    mean += number / count;
  }
  return mean;
}

/// The mean of the points with a finite z; false if there is none.
bool FindMean(const std::vector<std::size_t>& ids, const ahd::PointView& places,
  const ahd::PointView& positions, vtkAHDVector& mean)
{
  std::vector<double> numbers;
  for (std::size_t k = 0; k < 3; ++k)
  {
    numbers.clear();
    for (std::size_t id : ids)
    {
      if (std::isfinite(Coordinate(places, id, 2)))
      {
        numbers.push_back(Coordinate(positions, id, k));
      }
    }
    if (numbers.empty())
    {
      return false;
    }
    mean[k] = MeanOf(numbers);
  }
  return true;
}
}

bool vtkAHDDuplicates::Choose(
  const std::int64_t* fates, const ahd::PointView& places, bool highest, vtkAHDProgress& progress)
{
  this->Shown.clear();
  const auto visit = [&](std::size_t id, std::size_t first)
  {
    const std::size_t shown = static_cast<std::size_t>(this->Get(std::int64_t(first)));
    if (IsBetter(Coordinate(places, id, 2), Coordinate(places, shown, 2), highest))
    {
      if (this->Shown.empty())
      {
        this->Shown.resize(places.count);
        for (std::size_t i = 0; i < places.count; ++i)
        {
          this->Shown[i] = static_cast<std::int32_t>(i);
        }
      }
      this->Shown[first] = static_cast<std::int32_t>(id);
    }
  };
  return ForDuplicates(fates, places.count, progress, visit);
}

bool vtkAHDDuplicates::Apply(
  vtkCellArray* cells, ahd::Executor& executor, vtkAHDProgress& progress) const
{
  if (this->Shown.empty() || !cells || cells->GetNumberOfConnectivityIds() == 0)
  {
    return true;
  }
  const std::size_t count = static_cast<std::size_t>(cells->GetNumberOfConnectivityIds());
  return cells->IsStorage64Bit()
    ? this->Apply(cells->GetConnectivityArray64()->GetPointer(0), count, executor, progress)
    : this->Apply(cells->GetConnectivityArray32()->GetPointer(0), count, executor, progress);
}

bool vtkAHDFindMeans(const std::int64_t* fates, const ahd::PointView& places,
  const ahd::PointView& positions, vtkAHDProgress& progress, std::vector<vtkAHDMean>& means)
{
  means.clear();
  std::vector<std::pair<std::size_t, std::size_t>> members; // the vertex, one of its duplicates
  const auto visit = [&](std::size_t id, std::size_t first) { members.emplace_back(first, id); };
  if (!ForDuplicates(fates, places.count, progress, visit))
  {
    return false;
  }
  std::sort(members.begin(), members.end());
  std::vector<std::size_t> ids;
  for (std::size_t i = 0; i < members.size();)
  {
    const std::size_t first = members[i].first;
    ids.assign(1, first);
    for (; i < members.size() && members[i].first == first; ++i)
    {
      ids.push_back(members[i].second);
    }
    vtkAHDMean mean;
    if (FindMean(ids, places, positions, mean.Position))
    {
      mean.Id = static_cast<std::int64_t>(first);
      means.push_back(mean);
    }
    if (progress.MustAbort())
    {
      return false;
    }
  }
  return true;
}
