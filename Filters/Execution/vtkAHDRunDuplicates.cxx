// SPDX-License-Identifier: BSD-3-Clause
//
// The steps of an execution that say what is shown where several points have the same place.
#include "Execution/vtkAHDRun.h"

#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDLoop.h"
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <memory>

namespace
{
/// A copy of the points with means in the places of some. Null if the filter is to abort.
template <typename Array>
vtkSmartPointer<vtkDataArray> CopyWithMeans(const vtkAHDWorkingPoints& points,
  const std::vector<vtkAHDMean>& means, ahd::Executor& executor, vtkAHDProgress& progress)
{
  using Number = typename Array::ValueType;
  auto copy = vtkAHDNewArray<Array>(3 * points.GetCount());
  copy->SetNumberOfComponents(3);
  Number* numbers = copy->GetPointer(0);
  const bool all = vtkAHDLoop(static_cast<std::size_t>(points.GetCount()), executor, progress,
    [&points, numbers](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::array<double, 3> p = points.GetPoint(i);
        for (std::size_t k = 0; k < 3; ++k)
        {
          numbers[3 * i + k] = static_cast<Number>(p[k]);
        }
      }
    });
  for (const vtkAHDMean& mean : means)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      numbers[3 * std::size_t(mean.Id) + k] = static_cast<Number>(mean.Position[k]);
    }
  }
  return all ? copy : nullptr;
}
}

/// Bytes that the policy on duplicates takes, most of them only if there are any.
std::size_t vtkAHDRun::EstimateDuplicateBytes(std::size_t count) const
{
  constexpr std::size_t kFate = sizeof(std::int64_t);
  switch (this->Filter->DuplicatePolicy)
  {
    case vtkAdaptiveHilbertDelaunay2D::FIRST:
      return this->Crossings.empty() ? 0 : count * kFate;
    case vtkAdaptiveHilbertDelaunay2D::MEAN_Z:
      // a pair of ids for each duplicate, as a vector grows, a mean, and the copy of the points
      return count *
        (kFate + 4 * sizeof(std::size_t) + 2 * sizeof(vtkAHDMean) + 3 * sizeof(double));
    default:
      return count * (kFate + sizeof(std::int32_t));
  }
}

/// Null if no point is a duplicate, or if there is no use for them.
ahd::Status vtkAHDRun::WriteFates(std::unique_ptr<std::int64_t[]>& fates)
{
  const bool areFirst = this->Filter->DuplicatePolicy == vtkAdaptiveHilbertDelaunay2D::FIRST;
  if ((areFirst && this->Crossings.empty()) || this->Triangulator.report().duplicates == 0)
  {
    return ahd::Status::Ok;
  }
  fates.reset(new std::int64_t[static_cast<std::size_t>(this->Points.GetCount())]);
  const ahd::Status status = this->Triangulator.writeFates(
    fates.get(), &this->Progress, &this->Executor);
  this->Progress.Finish();
  return status;
}

ahd::Status vtkAHDRun::ChooseShown()
{
  const int policy = this->Filter->DuplicatePolicy;
  const bool highest = policy == vtkAdaptiveHilbertDelaunay2D::HIGHEST_Z;
  const bool chooses = highest || policy == vtkAdaptiveHilbertDelaunay2D::LOWEST_Z;
  if (!chooses && this->Crossings.empty())
  {
    return ahd::Status::Ok;
  }
  std::unique_ptr<std::int64_t[]> fates;
  const ahd::Status status = this->WriteFates(fates);
  if (status != ahd::Status::Ok || !fates)
  {
    return status;
  }
  const auto choose = [&](const ahd::PointView& points)
  { return !chooses || this->Shown.Choose(fates.get(), points, highest, this->Progress); };
  if (!this->Crossings.empty())
  {
    // The heights of crossings depend on which of the others are shown.
    if (!choose(this->GetAllButCrossings()))
    {
      return ahd::Status::Cancelled;
    }
    this->EndCrossingsAtShown(fates.get());
  }
  return choose(this->Points.View()) ? ahd::Status::Ok : ahd::Status::Cancelled;
}

/// The places of the points before the first crossing.
ahd::PointView vtkAHDRun::GetAllButCrossings() const
{
  ahd::PointView points = this->Points.View();
  points.count = static_cast<std::size_t>(this->GetFirstCrossing());
  return points;
}

/// Crossings lie between the points that are shown where their segments end.
void vtkAHDRun::EndCrossingsAtShown(const std::int64_t* fates)
{
  for (vtkAHDCrossing& crossing : this->Crossings)
  {
    for (vtkIdType& end : crossing.Ends)
    {
      const std::int64_t vertex = fates[end];
      end = vertex < 0 ? end : static_cast<vtkIdType>(this->Shown.Get(vertex));
    }
  }
  this->FindCrossingHeights();
}

/// Puts the crossings between the means at the ends of their segments. REQUIRES: the points of
/// Surface are doubles of its own, as they are where points were added.
ahd::Status vtkAHDRun::ShowMeansAtCrossings(const std::int64_t* fates)
{
  if (this->Crossings.empty())
  {
    return ahd::Status::Ok;
  }
  vtkAHDWorkingPoints positions(this->Surface);
  std::vector<vtkAHDMean> means;
  if (!positions.Open(this->Executor, this->Progress) ||
    !vtkAHDFindMeans(fates, this->GetAllButCrossings(), positions.View(), this->Progress, means))
  {
    return ahd::Status::Cancelled;
  }
  const auto meanOrPosition = [&](vtkIdType id, std::size_t k)
  {
    const auto mean = std::lower_bound(means.begin(), means.end(), id,
      [](const vtkAHDMean& m, vtkIdType wanted) { return m.Id < wanted; });
    return mean != means.end() && mean->Id == id
      ? mean->Position[k]
      : positions.GetPoint(static_cast<std::size_t>(id))[k];
  };
  auto* array = vtkDoubleArray::SafeDownCast(this->Surface->GetPoints()->GetData());
  double* xyz = array->GetPointer(3 * this->GetFirstCrossing());
  for (const vtkAHDCrossing& crossing : this->Crossings)
  {
    for (std::size_t k = this->IsProjected() ? 0 : 2; k < 3; ++k)
    {
      xyz[k] = vtkAHDInterpolate(crossing, [&](vtkIdType id) { return meanOrPosition(id, k); });
    }
    xyz += 3;
  }
  return ahd::Status::Ok;
}

ahd::Status vtkAHDRun::ShowMeans()
{
  if (this->Filter->DuplicatePolicy != vtkAdaptiveHilbertDelaunay2D::MEAN_Z)
  {
    return ahd::Status::Ok;
  }
  std::unique_ptr<std::int64_t[]> fates;
  ahd::Status status = this->WriteFates(fates);
  if (status == ahd::Status::Ok && fates)
  {
    status = this->ShowMeansAtCrossings(fates.get());
  }
  if (status != ahd::Status::Ok || !fates)
  {
    return status;
  }
  vtkAHDWorkingPoints positions(this->Surface);
  std::vector<vtkAHDMean> means;
  if (!positions.Open(this->Executor, this->Progress) ||
    !vtkAHDFindMeans(fates.get(), this->Points.View(), positions.View(), this->Progress, means))
  {
    return ahd::Status::Cancelled;
  }
  if (means.empty())
  {
    return ahd::Status::Ok;
  }
  vtkNew<vtkPoints> points;
  const auto copy = this->Surface->GetPoints()->GetDataType() == VTK_FLOAT
    ? CopyWithMeans<vtkFloatArray>(positions, means, this->Executor, this->Progress)
    : CopyWithMeans<vtkDoubleArray>(positions, means, this->Executor, this->Progress);
  if (!copy)
  {
    return ahd::Status::Cancelled;
  }
  points->SetData(copy);
  this->Surface->SetPoints(points);
  return ahd::Status::Ok;
}

ahd::Status vtkAHDRun::ShowInTriangles()
{
  return this->Shown.Apply(this->Surface->GetPolys(), this->Executor, this->Progress)
    ? ahd::Status::Ok
    : ahd::Status::Cancelled;
}

ahd::Status vtkAHDRun::ShowInArrays()
{
  vtkPointData* data = this->Surface->GetPointData();
  const auto numbers = [data](bool wanted, const char* name)
  {
    auto* array = vtkIdTypeArray::SafeDownCast(wanted ? data->GetArray(name) : nullptr);
    return array ? array->GetPointer(0) : nullptr;
  };
  vtkIdType* fates = numbers(this->Filter->GeneratePointStatus, "Fate");
  if (fates)
  {
    const std::size_t count = static_cast<std::size_t>(this->Surface->GetNumberOfPoints());
    if (!this->Shown.Apply(fates, count, this->Executor, this->Progress))
    {
      return ahd::Status::Cancelled;
    }
    this->Shown.Swap(fates);
  }
  if (vtkIdType* ranks = numbers(this->Filter->GenerateInsertionRank, "InsertionRank"))
  {
    this->Shown.Swap(ranks);
  }
  return ahd::Status::Ok;
}
