// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankPart.h"

#include "Engine/Points/JoinedBounds.h"

#include <algorithm>

namespace
{
constexpr std::size_t kAsk = std::size_t(1) << 14; // steps between two askings
}

void vtkAHDRankPart::SortOnce(std::vector<ahd::Index>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Those that are triangulated.
void vtkAHDRankPart::ReadOwn()
{
  const ahd::PointView view = this->Points.GetView();
  for (std::size_t i = 0; i < view.count; ++i)
  {
    if (i % kAsk == 0)
    {
      this->Context.StopIfAborted();
    }
    const ahd::Point p = view[i];
    if (ahd::isFinite(p) && !view.skipped(i))
    {
      this->Places.push_back(p.x);
      this->Places.push_back(p.y);
      this->Numbers.push_back(static_cast<ahd::Index>(i));
      this->Ids.push_back(this->Points.GetIds()[i]);
      this->OwnBounds = ahd::joined(this->OwnBounds, p);
    }
  }
  this->Own = this->Ids.size();
}

/// In the triangulation; -1 if it has none.
std::int64_t vtkAHDRankPart::NumberOf(std::int64_t id) const
{
  const auto others = this->Ids.begin() + static_cast<std::ptrdiff_t>(this->Own);
  for (const auto& part :
    { std::make_pair(this->Ids.begin(), others), std::make_pair(others, this->Ids.end()) })
  {
    const auto found = std::lower_bound(part.first, part.second, id);
    if (found != part.second && *found == id)
    {
      return found - this->Ids.begin();
    }
  }
  return -1;
}

void vtkAHDRankPart::ListShared(
  const vtkAHDRankChains& chains, bool allOfHull, std::vector<vtkAHDRankPlace>& shared)
{
  this->ReadOwn();
  const ahd::PointView view(this->Places.data(), this->Own, 2);
  ahd::Triangulation own;
  this->Context.Check(ahd::triangulate(view, ahd::Options(), this->Workspace, this->Context, own));
  this->Context.Check(ahd::findExtremes(own, allOfHull, this->Context, this->Shared));
  const ahd::ConstraintView given = chains.GetView();
  const std::int64_t* const end = given.ids + chains.GetIdCount();
  for (const std::int64_t* id = given.ids; id != end; ++id)
  {
    const std::int64_t number = this->NumberOf(*id);
    if (number >= 0)
    {
      this->Shared.push_back(static_cast<ahd::Index>(number));
    }
  }
  SortOnce(this->Shared);
  for (const ahd::Index number : this->Shared)
  {
    shared.push_back({ this->Ids[number], view[number] });
  }
}

void vtkAHDRankPart::Make(const vtkAHDSettings& settings, const vtkAHDRankChains& chains,
  const std::vector<vtkAHDRankPlace>& shared, bool asksForNearest)
{
  for (const vtkAHDRankPlace& place : shared)
  {
    if (this->NumberOf(place.Id) < 0)
    {
      this->Places.push_back(place.At.x);
      this->Places.push_back(place.At.y);
    }
  }
  std::vector<std::int64_t> others;
  for (const vtkAHDRankPlace& place : shared)
  {
    if (this->NumberOf(place.Id) < 0)
    {
      others.push_back(place.Id);
    }
  }
  this->Ids.insert(this->Ids.end(), others.begin(), others.end());
  const ahd::PointView view(this->Places.data(), this->Ids.size(), 2);
  const bool isConstrained = chains.GetIdCount() > 0;
  if (isConstrained && asksForNearest)
  {
    this->Context.Check(
      ahd::triangulate(view, ahd::Options(), this->Workspace, this->Context, this->Plain));
  }
  this->Context.Check(
    ahd::triangulate(view, ahd::Options(), this->Workspace, this->Context, this->Made));
  if (isConstrained)
  {
    this->Constrain(settings, chains);
  }
  this->ListCoincident();
}

void vtkAHDRankPart::Constrain(const vtkAHDSettings& settings, const vtkAHDRankChains& chains)
{
  ahd::ConstraintView given = chains.GetView();
  std::vector<std::int64_t> numbers(chains.GetIdCount());
  std::transform(given.ids, given.ids + numbers.size(), numbers.begin(),
    [this](std::int64_t id) { return this->NumberOf(id); });
  given.ids = numbers.data();
  this->Context.Check(
    ahd::constrain(std::move(this->Made), given, settings.fillRule, this->Context, this->Made));
}

/// Own points at the places of others.
void vtkAHDRankPart::ListCoincident()
{
  this->Context.Check(this->Made.makePointMap(this->Context));
  for (std::size_t i = 0; i < this->Own; ++i)
  {
    if (i % kAsk == 0)
    {
      this->Context.StopIfAborted();
    }
    const ahd::Index vertex = this->Made.vertexOf(i);
    const ahd::Index first = vertex == ahd::kNoIndex ? vertex : this->Made.pointOf(vertex);
    if (first != ahd::kNoIndex && first != i)
    {
      this->Coincident.emplace_back(first, static_cast<ahd::Index>(i));
    }
  }
  std::sort(this->Coincident.begin(), this->Coincident.end());
}

/// Of points that stand for vertices, all at the same places; others' are left out.
void vtkAHDRankPart::AddCoincident(std::vector<ahd::Index>& numbers) const
{
  const std::size_t count = numbers.size();
  for (std::size_t k = 0; k < count; ++k)
  {
    auto more = std::lower_bound(
      this->Coincident.begin(), this->Coincident.end(), Pair(numbers[k], 0));
    for (; more != this->Coincident.end() && more->first == numbers[k]; ++more)
    {
      numbers.push_back(more->second);
    }
  }
  SortOnce(numbers);
  while (!numbers.empty() && numbers.back() >= this->Own)
  {
    numbers.pop_back();
  }
  for (ahd::Index& number : numbers)
  {
    number = this->Numbers[number];
  }
}

std::size_t vtkAHDRankPart::FindCrowd()
{
  std::size_t most = 0;
  this->Context.Check(ahd::findCrowd(this->Made, this->Context, most));
  return most;
}

void vtkAHDRankPart::List(const std::vector<ahd::Bounds>& boxes, std::vector<ahd::Index>& numbers)
{
  if (boxes.empty())
  {
    return;
  }
  std::vector<ahd::Index> hidden;
  this->Context.Check(ahd::findBoxNeighbors(this->Made, boxes, this->Context, numbers));
  this->Context.Check(ahd::findBoxNeighbors(this->Plain, boxes, this->Context, hidden));
  numbers.insert(numbers.end(), hidden.begin(), hidden.end());
  for (const ahd::Index own : this->Shared)
  {
    const ahd::Index vertex = this->Made.vertexOf(own);
    numbers.push_back(vertex == ahd::kNoIndex ? own : this->Made.pointOf(vertex));
  }
  SortOnce(numbers);
  this->AddCoincident(numbers);
}

void vtkAHDRankPart::ListAll(std::vector<ahd::Index>& numbers)
{
  numbers = this->Numbers;
}

std::size_t vtkAHDRankPart::EstimateBytes(std::size_t points, std::size_t ids, bool asksForNearest)
{
  const std::size_t one = ahd::triangulationMemoryEstimate(points, ahd::Options());
  if (one == std::size_t(-1))
  {
    return one; // too many points
  }
  // a place, a number and an id, which may have room for as many more; pairs of coincident points
  constexpr std::size_t kPerPoint = 2 * (2 * sizeof(double) + sizeof(ahd::Index) + 8) + 16 + 8;
  const std::size_t constrained = ids == 0 ? 0 : ahd::constraintMemoryEstimate(points, ids);
  return points * kPerPoint + constrained + 8 * ids +
    (one + ahd::tableMemoryEstimate(points)) * (ids > 0 && asksForNearest ? 2 : 1);
}
