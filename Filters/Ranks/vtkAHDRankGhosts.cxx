// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankGhosts.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace
{
bool IsSame(const vtkAHDRankGhosts::Corner& p, const vtkAHDRankGhosts::Corner& q)
{
  return p.Id == q.Id;
}
}

void vtkAHDRankTriangles::Keep(const unsigned char* kept)
{
  const std::size_t count = this->GetCount();
  std::size_t next = 0, inside = 0;
  for (std::size_t t = 0; t < count; ++t)
  {
    if (kept[t] != 0)
    {
      std::copy_n(this->At(t), 3, this->At(next));
      inside += t < this->Inside ? 1 : 0;
      if (!this->Edges.empty())
      {
        this->Edges[next] = this->Edges[t];
      }
      ++next;
    }
  }
  this->Resize(next);
  this->Inside = inside;
  this->Edges.resize(this->Edges.empty() ? 0 : next);
}

vtkAHDRankGhosts::vtkAHDRankGhosts(vtkAHDRanks& ranks, const vtkAHDContext& context,
  const vtkAHDRankPoints& points, const ahd::BlockTriangulation& triangulation,
  const vtkAHDRankTriangles& own, const vtkAHDRankTriangles& around)
  : Ranks(ranks)
  , Context(context)
  , Points(points)
  , Foreign(triangulation.foreignPoints())
  , Own(own)
  , Around(around)
  , OwnPoints(points.GetCount())
{
}

void vtkAHDRankGhosts::StopIfAborted(std::size_t step) const
{
  constexpr std::size_t kAsk = std::size_t(1) << 14;
  if (step % kAsk == 0)
  {
    this->Context.StopIfAborted();
  }
}

/// Sorts, and leaves each out that is there already.
template <typename Item, typename Less, typename Same>
void vtkAHDRankGhosts::SortOnce(
  std::vector<Item>& items, const Less& isLess, const Same& isSame) const
{
  this->Context.StopIfAborted();
  std::sort(items.begin(), items.end(), isLess);
  items.erase(std::unique(items.begin(), items.end(), isSame), items.end());
}

vtkAHDRankGhosts::Corner vtkAHDRankGhosts::CornerOf(vtkTypeInt32 number) const
{
  const auto place = static_cast<std::size_t>(number);
  if (place < this->OwnPoints)
  {
    return { this->Points.GetIds()[place], this->Ranks.GetOwn() };
  }
  const ahd::ForeignPoint& point = this->Foreign[place - this->OwnPoints];
  return { point.id, point.block };
}

/// Own triangles, and behind them those around.
const vtkTypeInt32* vtkAHDRankGhosts::CornersOf(std::size_t place) const
{
  const std::size_t own = this->Own.GetCount();
  return place < own ? this->Own.At(place) : this->Around.At(place - own);
}

vtkAHDRankGhosts::Cell vtkAHDRankGhosts::CellOf(std::size_t place) const
{
  const std::size_t own = this->Own.GetCount();
  const std::vector<std::uint8_t>& edges = place < own ? this->Own.Edges : this->Around.Edges;
  const vtkTypeInt32* corners = this->CornersOf(place);
  Cell cell;
  for (std::size_t k = 0; k < 3; ++k)
  {
    cell.Corners[k] = this->CornerOf(corners[k]);
  }
  cell.Id = place < own ? this->FirstCell + static_cast<std::int64_t>(place)
                        : this->AroundIds[place - own];
  cell.Edges = edges.empty() ? 0 : edges[place < own ? place : place - own];
  return cell;
}

/// Sends numbers to ranks; `from` gets those of each.
void vtkAHDRankGhosts::Exchange(std::vector<Numbers>& to, std::vector<Numbers>& from)
{
  Messages out, in;
  this->Ranks.Together(this->Context,
    [&]
    {
      for (std::size_t rank = 0; rank < to.size(); ++rank)
      {
        if (!to[rank].empty())
        {
          out.emplace_back();
          out.back().block = rank;
          ahd::BytesWriter(out.back().bytes).writeAll(to[rank]);
          to[rank] = Numbers();
        }
      }
    });
  this->Context.Check(this->Ranks.exchange(out, in));
  this->Ranks.Together(this->Context,
    [&]
    {
      from.assign(this->Ranks.GetCount(), Numbers());
      for (const ahd::BlockMessage& message : in)
      {
        ahd::BytesReader(message.bytes).readAll(from[message.block]);
      }
    });
}

/// The ids of own triangles, for each rank that has them around it.
void vtkAHDRankGhosts::ListIds(std::vector<Numbers>& to) const
{
  to.assign(this->Ranks.GetCount(), Numbers());
  for (std::size_t t = this->Own.Inside; t < this->Own.GetCount(); ++t)
  {
    this->StopIfAborted(t);
    const vtkTypeInt32* corners = this->CornersOf(t); // the lowest is own
    const std::size_t own = this->Ranks.GetOwn();
    const std::size_t second = this->CornerOf(corners[1]).Rank;
    const std::size_t third = this->CornerOf(corners[2]).Rank;
    const std::int64_t id = this->FirstCell + static_cast<std::int64_t>(t);
    if (second != own)
    {
      to[second].push_back(id);
    }
    if (third != own && third != second)
    {
      to[third].push_back(id);
    }
  }
}

/// The triangles around come from their owner in its order: so do their ids.
void vtkAHDRankGhosts::Begin(std::size_t firstCell)
{
  std::vector<Numbers> to, from;
  this->FirstCell = static_cast<std::int64_t>(firstCell);
  this->Ranks.Together(this->Context, [&] { this->ListIds(to); });
  this->Exchange(to, from);
  this->Ranks.Together(this->Context,
    [&]
    {
      std::vector<std::size_t> next(this->Ranks.GetCount(), 0);
      const std::size_t own = this->Own.GetCount(), around = this->Around.GetCount();
      this->AroundIds.resize(around);
      this->Cells.resize(around);
      for (std::size_t t = 0; t < around; ++t)
      {
        this->StopIfAborted(t);
        const std::size_t owner = this->CornerOf(this->CornersOf(own + t)[0]).Rank;
        this->AroundIds[t] = from[owner][next[owner]++];
        this->Cells[t] = this->CellOf(own + t);
      }
    });
}

/// The points of others at the inside of the next layer that were not at that of one before.
void vtkAHDRankGhosts::ListNew(std::vector<Corner>& corners) const
{
  if (!this->HasLayer)
  {
    for (std::size_t i = 3 * this->Own.Inside; i < 3 * this->Own.GetCount(); ++i)
    {
      this->StopIfAborted(i);
      const vtkTypeInt32 corner = *(this->Own.At(0) + i);
      if (static_cast<std::size_t>(corner) >= this->OwnPoints)
      {
        corners.push_back(this->CornerOf(corner));
      }
    }
  }
  if (this->HasLayer)
  {
    this->AddForeign(corners);
  }
  this->SortOnce(corners, IsBefore, IsSame);
  const auto isKnown = [this](const Corner& corner)
  { return std::binary_search(this->Known.begin(), this->Known.end(), corner, IsBefore); };
  corners.erase(std::remove_if(corners.begin(), corners.end(), isKnown), corners.end());
}

void vtkAHDRankGhosts::AddForeign(std::vector<Corner>& points) const
{
  for (std::size_t t = 0; t < this->Cells.size(); ++t)
  {
    this->StopIfAborted(t);
    for (const Corner& corner : this->Cells[t].Corners)
    {
      if (corner.Rank != this->Ranks.GetOwn())
      {
        points.push_back(corner);
      }
    }
  }
  this->SortOnce(points, IsBefore, IsSame);
}

/// Finds the triangles around the points that other ranks ask for, but for those that have a point
/// of these ranks: they know them.
void vtkAHDRankGhosts::FindAnswers(const std::vector<Numbers>& asked)
{
  const Numbers& ids = this->Points.GetIds();
  std::vector<unsigned char> isAsked(this->OwnPoints, 0);
  std::vector<std::vector<std::size_t>> places(asked.size());
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
  {
    for (const std::int64_t id : asked[rank])
    {
      const auto found = std::lower_bound(ids.begin(), ids.end(), id);
      places[rank].push_back(static_cast<std::size_t>(found - ids.begin()));
      isAsked[places[rank].back()] = 1;
    }
  }
  std::vector<std::pair<std::size_t, std::size_t>> around; // points and triangles
  for (std::size_t t = 0; t < this->Own.GetCount() + this->Around.GetCount(); ++t)
  {
    this->StopIfAborted(t);
    const vtkTypeInt32* corners = this->CornersOf(t);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto corner = static_cast<std::size_t>(corners[k]);
      if (corner < this->OwnPoints && isAsked[corner] != 0)
      {
        around.emplace_back(corner, t);
      }
    }
  }
  const auto isLess = [](const auto& a, const auto& b) { return a < b; };
  const auto isSame = [](const auto& a, const auto& b) { return a == b; };
  this->SortOnce(around, isLess, isSame);
  this->Answers.assign(asked.size(), std::vector<std::size_t>());
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
  {
    std::vector<std::size_t>& answer = this->Answers[rank];
    for (const std::size_t place : places[rank])
    {
      auto next = std::lower_bound(
        around.begin(), around.end(), std::make_pair(place, std::size_t(0)));
      for (; next != around.end() && next->first == place; ++next)
      {
        if (!this->HasPointOf(rank, next->second))
        {
          answer.push_back(next->second);
        }
      }
    }
    this->SortOnce(answer, isLess, isSame);
  }
}

bool vtkAHDRankGhosts::HasPointOf(std::size_t rank, std::size_t place) const
{
  const vtkTypeInt32* corners = this->CornersOf(place);
  return std::any_of(corners, corners + 3,
    [this, rank](vtkTypeInt32 corner) { return this->CornerOf(corner).Rank == rank; });
}

void vtkAHDRankGhosts::Ask()
{
  std::vector<Numbers> to, from;
  this->Ranks.Together(this->Context,
    [&]
    {
      std::vector<Corner> corners;
      this->ListNew(corners);
      to.assign(this->Ranks.GetCount(), Numbers());
      for (const Corner& corner : corners)
      {
        to[corner.Rank].push_back(corner.Id);
      }
      this->Known.insert(this->Known.end(), corners.begin(), corners.end());
      this->SortOnce(this->Known, IsBefore, IsSame);
      this->HasLayer = true;
    });
  this->Exchange(to, from);
  this->Ranks.Together(this->Context,
    [&]
    {
      this->FindAnswers(from);
      this->Going = 0;
      to.assign(this->Ranks.GetCount(), Numbers());
      for (std::size_t rank = 0; rank < to.size(); ++rank)
      {
        const std::size_t count = this->Answers[rank].size();
        this->Going += count;
        if (count > 0)
        {
          to[rank].push_back(static_cast<std::int64_t>(count));
        }
      }
    });
  this->Exchange(to, from);
  this->Coming = 0;
  for (const Numbers& count : from)
  {
    this->Coming += count.empty() ? 0 : static_cast<std::size_t>(count[0]);
  }
}

void vtkAHDRankGhosts::Take()
{
  Messages out, in;
  this->Ranks.Together(this->Context,
    [&]
    {
      for (std::size_t rank = 0; rank < this->Answers.size(); ++rank)
      {
        if (this->Answers[rank].empty())
        {
          continue;
        }
        out.emplace_back();
        out.back().block = rank;
        out.back().bytes.reserve(this->Answers[rank].size() * sizeof(Cell));
        ahd::BytesWriter writer(out.back().bytes);
        for (std::size_t k = 0; k < this->Answers[rank].size(); ++k)
        {
          this->StopIfAborted(k);
          writer.write(this->CellOf(this->Answers[rank][k]));
        }
      }
      this->Answers.clear();
    });
  this->Context.Check(this->Ranks.exchange(out, in));
  this->Ranks.Together(this->Context,
    [&]
    {
      this->Cells.reserve(this->Cells.size() + this->Coming);
      for (const ahd::BlockMessage& message : in)
      {
        ahd::BytesReader reader(message.bytes);
        for (std::size_t k = 0; k < message.bytes.size() / sizeof(Cell); ++k)
        {
          this->StopIfAborted(k);
          this->Cells.push_back(reader.read<Cell>());
        }
      }
      this->SortOnce(
        this->Cells, [](const Cell& a, const Cell& b) { return a.Id < b.Id; },
        [](const Cell& a, const Cell& b) { return a.Id == b.Id; });
      this->Coming = 0;
      this->Going = 0;
    });
}
