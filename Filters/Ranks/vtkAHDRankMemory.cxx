// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankMemory.h"

#include "Engine/Core/Memory.h"
#include "Engine/Distribute/BlockBytes.h"
#include "Engine/Job/Messages.h"

#include <cstdint>
#include <vector>

std::string vtkAHDRefuseMemory(const vtkAHDSettings& settings, const vtkAHDAllFacts& facts,
  vtkAHDRanks& ranks, const vtkAHDContext& context, std::size_t bytes, const vtkAHDRankWork& work)
{
  const bool isLimited = settings.MemoryLimit > 0;
  // what is held already is part of the estimate, and of no rank's rest
  const vtkTypeInt64 there = isLimited ? settings.MemoryLimit
                                       : static_cast<vtkTypeInt64>(ahd::availableMemory() / 1024 /
                                           facts.CountOnHostOf(ranks.GetOwn()));
  const std::int64_t figures[] = { static_cast<std::int64_t>(bytes / 1024), there, isLimited };
  ahd::BlockBytes own;
  std::vector<ahd::BlockBytes> all;
  ranks.Together(context, [&] { ahd::BytesWriter(own).write(figures); });
  context.Check(ranks.gather(own, all));
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    ahd::BytesReader reader(all[k]);
    const auto needed = reader.read<std::int64_t>();
    const auto limit = reader.read<std::int64_t>();
    const bool isByUser = reader.read<std::int64_t>() != 0;
    if (needed > limit)
    {
      const ahd::Facts known{ { "reason", ahd::Reason::MemoryLimit }, { "doing", "distributing" },
        { "work", work.Doing }, { "points", work.Points }, { "ranks", all.size() }, { "rank", k },
        { "share", work.Share }, { "of_rank", true }, { "is_in_kib", true },
        { "memory_estimate", needed }, { "memory_allowed", limit }, { "memory_limit", isByUser } };
      return ahd::messages(ahd::Topic::Refusal, ahd::Wording::Class, known).at(0).text;
    }
  }
  return std::string();
}
