// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankRim.h"

#include "Engine/Predicates/Predicates.h"

#include <algorithm>
#include <numeric>
#include <utility>

vtkAHDRankRim::vtkAHDRankRim(vtkAHDRanks& ranks, const vtkAHDContext& context,
  const vtkAHDRankPoints& points, const ahd::BlockTriangulation& triangulation,
  const std::vector<ahd::Point>& places)
  : Ranks(ranks)
  , Context(context)
  , Points(points)
  , Foreign(triangulation.foreignPoints())
  , Places(places)
{
}

void vtkAHDRankRim::StopIfAborted(std::size_t step) const
{
  if (step % kPiece == 0)
  {
    this->Context.StopIfAborted();
  }
}

/// Own triangles, and behind them those around.
const vtkTypeInt32* vtkAHDRankRim::CornersOf(std::size_t triangle) const
{
  const std::size_t own = this->Own->GetCount();
  return triangle < own ? this->Own->At(triangle) : this->Around->At(triangle - own);
}

bool vtkAHDRankRim::IsOwn(vtkTypeInt32 number) const
{
  return static_cast<std::size_t>(number) < this->Points.GetCount();
}

std::int64_t vtkAHDRankRim::IdOf(vtkTypeInt32 number) const
{
  const auto place = static_cast<std::size_t>(number);
  return this->IsOwn(number) ? this->Points.GetIds()[place]
                             : this->Foreign[place - this->Points.GetCount()].id;
}

/// Twice the area of a triangle, rounded.
double vtkAHDRankRim::DoubledArea(std::size_t triangle) const
{
  const vtkTypeInt32* corners = this->CornersOf(triangle);
  const ahd::Point& a = this->Places[static_cast<std::size_t>(corners[0])];
  const ahd::Point& b = this->Places[static_cast<std::size_t>(corners[1])];
  const ahd::Point& c = this->Places[static_cast<std::size_t>(corners[2])];
  return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
}

/// The edge over which a triangle is flat, by the number of the corner that it begins at; -1 if
/// there is none.
int vtkAHDRankRim::FlatEdgeOf(std::size_t triangle) const
{
  const auto place = [this](vtkTypeInt32 corner) -> const ahd::Point&
  { return this->Places[static_cast<std::size_t>(corner)]; };
  const vtkTypeInt32* c = this->CornersOf(triangle);
  for (int k = 0; k < 3; ++k)
  {
    if (ahd::isFlat(place(c[k]), place(c[(k + 1) % 3]), place(c[(k + 2) % 3])))
    {
      return k;
    }
  }
  return -1;
}

/// On all threads; finds out the area on the way.
void vtkAHDRankRim::FindFlat()
{
  const std::size_t own = this->Own->GetCount(), all = own + this->Around->GetCount();
  std::vector<signed char> edges(all);
  std::vector<double> areas(
    all / kPiece + 1, 0.0); // by ForRange()'s pieces: the same with any threads
  this->Context.ForRange(all,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        edges[t] = static_cast<signed char>(this->FlatEdgeOf(t));
        areas[t / kPiece] += t < own ? this->DoubledArea(t) : 0.0;
      }
    });
  const auto isFlat = [](signed char edge) { return edge >= 0; };
  this->Flats.reserve(static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), isFlat)));
  this->Whole = std::accumulate(areas.begin(), areas.end(), 0.0);
  for (std::size_t t = 0; t < all; ++t)
  {
    this->StopIfAborted(t);
    if (isFlat(edges[t]))
    {
      const vtkTypeInt32* c = this->CornersOf(t);
      this->Flats.push_back(
        { static_cast<ahd::Index>(t), c[edges[t]], c[(edges[t] + 1) % 3], None, Unknown, 0 });
    }
  }
}

/// Calls visit(triangle, from, to) for the half-edges of the first triangles that begin at one of
/// the points that are marked.
template <typename Visit>
void vtkAHDRankRim::ForHalfEdges(
  std::size_t triangles, const std::vector<unsigned char>& isFrom, const Visit& visit) const
{
  for (std::size_t t = 0; t < triangles; ++t)
  {
    this->StopIfAborted(t);
    const vtkTypeInt32* c = this->CornersOf(t);
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (isFrom[static_cast<std::size_t>(c[k])] != 0)
      {
        visit(t, c[k], c[(k + 1) % 3]);
      }
    }
  }
}

/// Of the triangles beyond those that are here.
void vtkAHDRankRim::FindBeyond()
{
  using Numbers = std::pair<vtkTypeInt32, vtkTypeInt32>;
  std::vector<std::pair<Numbers, ahd::Index>> wanted; // half-edges and flat triangles
  std::vector<unsigned char> isFrom(this->Places.size(), 0);
  wanted.reserve(this->Flats.size());
  for (std::size_t i = 0; i < this->Flats.size(); ++i)
  {
    wanted.emplace_back(
      Numbers(this->Flats[i].To, this->Flats[i].From), static_cast<ahd::Index>(i));
    isFrom[static_cast<std::size_t>(this->Flats[i].To)] = 1;
  }
  std::sort(wanted.begin(), wanted.end());
  this->ForHalfEdges(this->Own->GetCount() + this->Around->GetCount(), isFrom,
    [&](std::size_t t, vtkTypeInt32 from, vtkTypeInt32 to)
    {
      const auto found = std::lower_bound(
        wanted.begin(), wanted.end(), std::make_pair(Numbers(from, to), ahd::Index(0)));
      if (found != wanted.end() && found->first == Numbers(from, to))
      {
        this->Flats[found->second].Beyond = static_cast<ahd::Index>(t);
      }
    });
}

/// Null for one that is not flat.
vtkAHDRankRim::Flat* vtkAHDRankRim::FlatOf(ahd::Index triangle)
{
  const auto found = std::lower_bound(this->Flats.begin(), this->Flats.end(), triangle,
    [](const Flat& flat, ahd::Index t) { return flat.Triangle < t; });
  return found != this->Flats.end() && found->Triangle == triangle ? &*found : nullptr;
}

/// Follows flat triangles until it is known what becomes of them, or who knows. All triangles
/// around an own point are here: beyond an edge of it there is one that is here, or none.
void vtkAHDRankRim::Follow()
{
  std::vector<Flat*> way;
  for (std::size_t i = 0; i < this->Flats.size(); ++i)
  {
    this->StopIfAborted(i);
    vtkTypeInt32 fate = Unknown;
    Flat* flat = &this->Flats[i];
    while (flat && flat->Fate == Unknown)
    {
      way.push_back(flat);
      if (flat->Beyond == None)
      {
        const bool isHull = this->IsOwn(flat->From) || this->IsOwn(flat->To);
        fate = isHull ? vtkTypeInt32(Dropped)
                      : static_cast<vtkTypeInt32>(flat - this->Flats.data());
        flat->Fate = fate;
        break;
      }
      flat = this->FlatOf(flat->Beyond);
    }
    fate = flat ? flat->Fate : vtkTypeInt32(Kept);
    for (Flat* one : way)
    {
      one->Fate = fate;
    }
    way.clear();
  }
}

/// All ranks hear of which half-edges one of them has to know more.
void vtkAHDRankRim::ShareAsked()
{
  ahd::BlockBytes own;
  std::vector<ahd::BlockBytes> all;
  this->Ranks.Together(this->Context,
    [&]
    {
      std::vector<HalfEdge> asked;
      for (std::size_t i = 0; i < this->Flats.size(); ++i)
      {
        const Flat& flat = this->Flats[i];
        if (flat.Fate == static_cast<vtkTypeInt32>(i))
        {
          asked.push_back({ { this->IdOf(flat.To), this->IdOf(flat.From) } });
        }
      }
      ahd::BytesWriter(own).writeAll(asked);
    });
  this->Context.Check(this->Ranks.gather(own, all));
  this->Ranks.Together(this->Context,
    [&]
    {
      for (const ahd::BlockBytes& bytes : all)
      {
        ahd::BytesReader(bytes).readAll(this->Asked);
      }
      std::sort(this->Asked.begin(), this->Asked.end());
      this->Asked.erase(std::unique(this->Asked.begin(), this->Asked.end()), this->Asked.end());
      // where nothing is, nothing holds what comes before
      this->Fates.assign(this->Asked.size(), Dropped);
      for (Flat& flat : this->Flats)
      {
        if (flat.Fate >= 0)
        {
          const Flat& last = this->Flats[static_cast<std::size_t>(flat.Fate)];
          const HalfEdge edge = { { this->IdOf(last.To), this->IdOf(last.From) } };
          flat.Root = static_cast<vtkTypeInt32>(
            std::lower_bound(this->Asked.begin(), this->Asked.end(), edge) - this->Asked.begin());
        }
      }
    });
}

/// What becomes of own triangles at the half-edges that were asked for.
void vtkAHDRankRim::Answer(ahd::BlockBytes& bytes)
{
  std::vector<unsigned char> isFrom(this->Places.size(), 0);
  const auto isAsked = [this](std::int64_t id)
  {
    const HalfEdge first = { { id, 0 } };
    const auto found = std::lower_bound(this->Asked.begin(), this->Asked.end(), first);
    return found != this->Asked.end() && (*found)[0] == id;
  };
  for (std::size_t i = 0; i < isFrom.size() && !this->Asked.empty(); ++i)
  {
    this->StopIfAborted(i);
    isFrom[i] = isAsked(this->IdOf(static_cast<vtkTypeInt32>(i))) ? 1 : 0;
  }
  std::vector<std::array<std::int64_t, 2>> answers; // the half-edge's place, what becomes of it
  this->ForHalfEdges(this->Asked.empty() ? 0 : this->Own->GetCount(), isFrom,
    [&](std::size_t t, vtkTypeInt32 from, vtkTypeInt32 to)
    {
      const HalfEdge edge = { { this->IdOf(from), this->IdOf(to) } };
      const auto found = std::lower_bound(this->Asked.begin(), this->Asked.end(), edge);
      if (found != this->Asked.end() && *found == edge)
      {
        const Flat* flat = this->FlatOf(static_cast<ahd::Index>(t));
        answers.push_back({ { found - this->Asked.begin(),
          !flat               ? std::int64_t(Kept)
            : flat->Fate >= 0 ? flat->Root
                              : flat->Fate } });
      }
    });
  ahd::BytesWriter(bytes).writeAll(answers);
}

/// Who answers with another half-edge has asked for that himself.
void vtkAHDRankRim::HearAnswers(const std::vector<ahd::BlockBytes>& all)
{
  for (const ahd::BlockBytes& bytes : all)
  {
    std::vector<std::array<std::int64_t, 2>> answers;
    ahd::BytesReader(bytes).readAll(answers);
    for (const auto& answer : answers)
    {
      this->Fates[static_cast<std::size_t>(answer[0])] = static_cast<vtkTypeInt32>(answer[1]);
    }
  }
  std::vector<std::size_t> way;
  for (std::size_t i = 0; i < this->Fates.size(); ++i)
  {
    this->StopIfAborted(i);
    std::size_t last = i;
    for (; this->Fates[last] >= 0; last = static_cast<std::size_t>(this->Fates[last]))
    {
      way.push_back(last);
    }
    for (const std::size_t one : way)
    {
      this->Fates[one] = this->Fates[last];
    }
    way.clear();
  }
  for (Flat& flat : this->Flats)
  {
    flat.Fate = flat.Fate >= 0 ? this->Fates[static_cast<std::size_t>(flat.Root)] : flat.Fate;
  }
}

/// What this rank has of the counts. `kept`: of own triangles, and behind them those around.
void vtkAHDRankRim::Count(const std::vector<unsigned char>& kept, ahd::BlockBytes& bytes) const
{
  std::vector<unsigned char> isBare(this->Places.size(), 0);
  double lost = 0.0;
  std::uint64_t triangles = 0, bare = 0;
  for (const Flat& flat : this->Flats)
  {
    const bool isOwn = flat.Triangle < this->Own->GetCount();
    if (flat.Fate != Kept)
    {
      const vtkTypeInt32* c = this->CornersOf(flat.Triangle);
      std::for_each(
        c, c + 3, [&isBare](vtkTypeInt32 corner) { isBare[static_cast<std::size_t>(corner)] = 1; });
      lost += isOwn ? this->DoubledArea(flat.Triangle) : 0.0;
      triangles += isOwn ? 1 : 0;
    }
  }
  for (std::size_t t = 0; t < kept.size(); ++t)
  {
    this->StopIfAborted(t);
    const vtkTypeInt32* c = this->CornersOf(t);
    for (std::size_t k = 0; k < 3 && kept[t] != 0; ++k)
    {
      isBare[static_cast<std::size_t>(c[k])] = 0;
    }
  }
  bare = static_cast<std::uint64_t>(std::count(
    isBare.begin(), isBare.begin() + static_cast<std::ptrdiff_t>(this->Points.GetCount()), 1));
  ahd::BytesWriter writer(bytes);
  writer.write(triangles);
  writer.write(bare);
  writer.write(lost);
  writer.write(this->Whole);
}

void vtkAHDRankRim::Trim(vtkAHDRankTriangles& own, vtkAHDRankTriangles& around)
{
  this->Own = &own;
  this->Around = &around;
  ahd::BlockBytes answers, counts;
  std::vector<ahd::BlockBytes> all;
  this->Ranks.Together(this->Context,
    [this]
    {
      this->FindFlat();
      this->FindBeyond();
      this->Follow();
    });
  this->ShareAsked();
  this->Ranks.Together(this->Context, [&] { this->Answer(answers); });
  this->Context.Check(this->Ranks.gather(answers, all));
  this->Ranks.Together(this->Context,
    [&]
    {
      this->HearAnswers(all);
      std::vector<unsigned char> kept(own.GetCount() + around.GetCount(), 1);
      for (const Flat& flat : this->Flats)
      {
        kept[flat.Triangle] = flat.Fate == Kept ? 1 : 0;
      }
      this->Count(kept, counts);
      const unsigned char* aroundKept = kept.data() + own.GetCount();
      own.Keep(kept.data());
      around.Keep(aroundKept);
    });
  this->Context.Check(this->Ranks.gather(counts, all));
  double lost = 0.0, whole = 0.0;
  for (const ahd::BlockBytes& bytes : all)
  {
    ahd::BytesReader reader(bytes);
    this->Triangles += static_cast<std::size_t>(reader.read<std::uint64_t>());
    this->BareVertices += static_cast<std::size_t>(reader.read<std::uint64_t>());
    lost += reader.read<double>();
    whole += reader.read<double>();
  }
  this->Area = this->Triangles == 0 ? 0.0 : lost / whole;
}
