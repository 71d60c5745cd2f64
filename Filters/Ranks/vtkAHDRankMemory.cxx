// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankMemory.h"

#include "Engine/Core/Memory.h"
#include "Engine/Job/Messages.h"

#include <cstdint>
#include <tuple>
#include <vector>

std::string vtkAHDRefuseMemory(const vtkAHDSettings& settings, const vtkAHDAllFacts& facts,
  vtkAHDRanks& ranks, const vtkAHDContext& context, std::size_t bytes, const vtkAHDRankWork& work)
{
  const bool isLimited = settings.MemoryLimit > 0;
  // memory held already is part of the estimate, and not of what a rank has left
  const vtkTypeInt64 there = isLimited ? settings.MemoryLimit
                                       : static_cast<vtkTypeInt64>(ahd::availableMemory() / 1024 /
                                           facts.CountOnHostOf(ranks.GetOwn()));
  struct Figures
  {
    std::int64_t Needed, Limit;
    bool IsByUser;

    auto fields() { return std::tie(this->Needed, this->Limit, this->IsByUser); }
  };
  const auto all = ranks.Share(context,
    [&] {
      return Figures{ static_cast<std::int64_t>(bytes / 1024), there, isLimited };
    });
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    const Figures& of = all[k];
    if (of.Needed > of.Limit)
    {
      const ahd::Facts known{ { "reason", ahd::Reason::MemoryLimit }, { "doing", "distributing" },
        { "work", work.Doing }, { "points", work.Points }, { "ranks", all.size() }, { "rank", k },
        { "share", work.Share }, { "of_rank", true }, { "is_in_kib", true },
        { "memory_estimate", of.Needed }, { "memory_allowed", of.Limit },
        { "memory_limit", of.IsByUser } };
      return ahd::messages(ahd::Topic::Refusal, ahd::Wording::Class, known).at(0).text;
    }
  }
  return std::string();
}
