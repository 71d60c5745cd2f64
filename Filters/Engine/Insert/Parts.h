// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Parts_h
#define ahd_Parts_h

#include "Insert.h"

#include "../Order/Rounds.h"
#include "Kernel.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ahd
{
inline namespace AHD_TARGET
{

/// A round of these, known by its stride.
struct Round
{
  const Rounds& rounds;
  std::size_t stride;
};

/// One round of an insertion, in parts (Insert.h). What a part could not insert waits, and is
/// tried again by the part that joins it with its neighbours, until one part owns everything.
class Parts
{
public:
  /// @pre all points of the rounds before are in the mesh; 2 <= count, and each part gets at
  /// least kControlStride points of the round. Throws std::bad_alloc.
  Parts(const Frame& frame, Mesh& mesh, Ticker& ticker, const Round& round, std::size_t count);

  /// Inserts the round; the last that wait by `alone`. Returns false if cancelled. `isBetterAlone`:
  /// cavities here are so large (points on a parabola, or hundreds of orders of magnitude apart),
  /// or it takes so many steps to insert points that waited (nearly collinear ones), that one
  /// thread alone is faster.
  template <typename KernelAlone>
  bool insert(KernelAlone& alone, SharedWork& work, bool& isBetterAlone)
  {
    const std::uint64_t deferred = work.deferred;
    if (!findStarts() || !insertOwn(work))
    {
      return false;
    }
    isBetterAlone = waiting() > rounds_.size(stride_) / 2;
    // Steps for those that waited, by points of the round: on a circle at most 2.8, 8.1, 11.2 with
    // 2, 5, 12 parts, where threads pay; nearly collinear at least 3.1, 17, 17. By tries:
    // uniform 10.
    const std::size_t perPoint = std::min<std::size_t>(12, 2 * parts_.size() - 1);
    while (!isBetterAlone && parts_.size() > 1 && waiting() > kFew)
    {
      join();
      if (parts_.size() > 1 && !insertWaiting(work))
      {
        return false;
      }
    }
    const std::uint64_t tries = work.deferred - deferred;
    const std::uint64_t mostSteps = std::max<std::uint64_t>(
      perPoint * rounds_.size(stride_), 24 * tries);
    const std::size_t before = alone.steps();
    const bool done = insertLast(alone, work);
    waitingSteps_ += alone.steps() - before;
    isBetterAlone = isBetterAlone || waitingSteps_ > mostSteps;
    return done;
  }

private:
  template <bool kExact>
  using SharedKernel = Kernel<false, Access::Shared, kExact>;

  struct Part
  {
    Territory territory;
    std::size_t begin = 0;   ///< the points that wait: this place in waiting_
    std::size_t waiting = 0; ///< and so many
    std::uint64_t attempts = 0;
    std::size_t steps = 0; ///< taken for those that waited
  };

  static constexpr std::size_t kFew = 256; ///< points that are not worth another pass
  static constexpr std::size_t kJoined = 4;
  static constexpr std::size_t kMostKnown = 8;        ///< vertices for one start
  static constexpr std::size_t kLeastBlocks = 1024;   ///< in a territory, before they get larger
  static constexpr std::size_t kLeastNoted = 1 << 15; ///< triangles that are worth a task

  bool findStarts();
  bool noteStarts(std::size_t every);
  void noteStart(Mesh::Slot slot);
  bool fillStarts();
  bool insertOwn(SharedWork& work);
  template <bool kExact>
  bool insertOwnOf(Part& part, Ticker& ticker);
  bool insertWaiting(SharedWork& work);
  template <bool kExact>
  bool insertWaitingOf(Part& part, Ticker& ticker);
  void join();
  std::size_t waiting() const;
  void account(SharedWork& work);

  /// A triangle to start from when locating vertex v: it had, when the round began, a vertex of the
  /// rounds before that is in the same block as v, or in one near it in the same territory. Since
  /// then, whatever fills its slot has a vertex of that territory.
  Mesh::Slot startFor(std::size_t v) const
  {
    return starts_[v / block_].load(std::memory_order_relaxed);
  }

  /// Vertex p waits. Where it was last looked for is noted in a number that nothing else uses, of
  /// the slots that are there for it.
  void wait(Index p, Mesh::Slot fresh, std::size_t place, Mesh::Slot hint)
  {
    waiting_[place] = p;
    mesh_.data()[fresh + 3] = hint;
  }
  Mesh::Slot startOf(Index p) const { return mesh_.data()[freshSlots(p) + 3]; }

  Mesh::Slot freshSlots(std::size_t v) const
  {
    return Mesh::freshSlots(rounds_.before(stride_) + rounds_.index(stride_, v));
  }

  template <typename KernelAlone>
  bool insertLast(KernelAlone& alone, SharedWork& work)
  {
    for (const Part& part : parts_)
    {
      for (std::size_t i = part.begin; i < part.begin + part.waiting; ++i)
      {
        const Index p = waiting_[i];
        Mesh::Slot hint = startOf(p);
        if (alone.insert(p, p, freshSlots(p), hint) != Insertion::Done)
        {
          return false;
        }
      }
      work.attempts += part.waiting;
      work.criticalPath += part.waiting;
    }
    return true;
  }

  const Frame& frame_;
  const RankedPoints& points_;
  Mesh& mesh_;
  Ticker& ticker_;
  const Rounds& rounds_;
  std::size_t stride_;
  std::size_t known_; ///< the vertices of the rounds before: one of so many successive ones
  std::size_t block_; ///< so many successive vertices, which have one start
  std::vector<Part> parts_;
  Buffer<Index> waiting_;        ///< a part's points that wait stand where its own would, if listed
  std::size_t waitingSteps_ = 0; ///< taken for points that waited
  std::unique_ptr<std::atomic<Mesh::Slot>[]> starts_;
};

} // namespace AHD_TARGET
} // namespace ahd

#endif
