// SPDX-License-Identifier: BSD-3-Clause
#include "ConstraintFill.h"

#include <algorithm>

namespace ahd
{
namespace test
{
namespace
{

constexpr std::int32_t kNone = CertifiedMesh::kNone;

std::vector<char> keptByOrientation(const CertifiedMesh& mesh, const std::vector<LoopUses>& uses)
{
  std::vector<char> kept(mesh.triangleCount(), 1);
  std::vector<char> border(uses.size());
  std::transform(uses.begin(), uses.end(), border.begin(),
    [](const LoopUses& u) { return char(u.along != u.against); });
  const std::vector<std::int64_t> region = regionsOf(mesh, kept, border);
  std::vector<char> dropped(mesh.triangleCount(), 0);
  for (std::size_t h = 0; h < uses.size(); ++h)
  {
    if (uses[h].against > uses[h].along) // the triangle is on the right of the loop
    {
      dropped[std::size_t(region[h / 3])] = 1;
    }
  }
  for (std::size_t t = 0; t < kept.size(); ++t)
  {
    kept[t] = !dropped[std::size_t(region[t])];
  }
  return kept;
}

/// From the outside inwards, each edge that loops pass an odd number of times changing the side.
class EvenOdd
{
public:
  EvenOdd(CertifiedMesh& mesh, const std::vector<LoopUses>& uses)
    : mesh_(mesh)
    , uses_(uses)
    , kept_(mesh.triangleCount(), kUnknown)
  {
  }

  std::vector<char> run()
  {
    for (std::int32_t h = 0; std::size_t(h) < uses_.size(); ++h)
    {
      if (mesh_.twin(h) == kNone)
      {
        reach(h, 0);
      }
    }
    while (!open_.empty())
    {
      const std::int32_t t = open_.back();
      open_.pop_back();
      for (std::int32_t h = 3 * t; h < 3 * t + 3; ++h)
      {
        if (mesh_.twin(h) != kNone)
        {
          reach(mesh_.twin(h), kept_[std::size_t(t)]);
        }
      }
    }
    return kept_;
  }

private:
  static constexpr char kUnknown = 2;

  void reach(std::int32_t h, char outside)
  {
    const LoopUses& uses = uses_[std::size_t(h)];
    const char inside = char((outside + uses.along + uses.against) % 2);
    char& kept = kept_[std::size_t(h / 3)];
    if (kept == kUnknown)
    {
      kept = inside;
      open_.push_back(h / 3);
    }
    else if (kept != inside)
    {
      mesh_.faults().add("loops do not close", [&] { return "at " + mesh_.name(mesh_.origin(h)); });
    }
  }

  CertifiedMesh& mesh_;
  const std::vector<LoopUses>& uses_;
  std::vector<char> kept_;
  std::vector<std::int32_t> open_;
};

} // namespace

std::vector<char> keptByRule(CertifiedMesh& mesh, FillRule rule, const std::vector<LoopUses>& uses)
{
  const bool hasLoops = std::any_of(
    uses.begin(), uses.end(), [](const LoopUses& u) { return u.along + u.against > 0; });
  return !hasLoops                  ? std::vector<char>(mesh.triangleCount(), 1)
    : rule == FillRule::Orientation ? keptByOrientation(mesh, uses)
                                    : EvenOdd(mesh, uses).run();
}

std::vector<std::int64_t> regionsOf(
  const CertifiedMesh& mesh, const std::vector<char>& kept, const std::vector<char>& border)
{
  std::vector<std::int64_t> result(mesh.triangleCount(), -1);
  std::int64_t number = -1;
  std::vector<std::int32_t> open;
  const auto enter = [&](std::int32_t t)
  {
    if (kept[std::size_t(t)] && result[std::size_t(t)] < 0)
    {
      result[std::size_t(t)] = number;
      open.push_back(t);
    }
  };
  for (std::int32_t first = 0; std::size_t(first) < mesh.triangleCount(); ++first)
  {
    const bool isNew = kept[std::size_t(first)] && result[std::size_t(first)] < 0;
    number += isNew ? 1 : 0;
    enter(first);
    while (!open.empty())
    {
      const std::int32_t t = open.back();
      open.pop_back();
      for (std::int32_t h = 3 * t; h < 3 * t + 3; ++h)
      {
        if (mesh.twin(h) != kNone && !border[std::size_t(h)])
        {
          enter(mesh.twin(h) / 3);
        }
      }
    }
  }
  return result;
}

} // namespace test
} // namespace ahd
