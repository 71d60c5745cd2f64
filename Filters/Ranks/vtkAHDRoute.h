// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRoute_h
#define vtkAHDRoute_h

#include "Engine/Points/Points.h"
#include "Ranks/vtkAHDRanks.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkAbstractArray;

/**
 * Which tuples of this rank go to which rank, and at which places those are put that come from
 * others. Any number of arrays can be moved along it. What is said to be collective throws
 * vtkAHDStop on all ranks if one of them cannot go on.
 */
class vtkAHDRoute
{
public:
  /// Borrows both.
  vtkAHDRoute(vtkAHDRanks& ranks, const vtkAHDContext& context)
    : Ranks(ranks)
    , Context(context)
  {
  }

  /// Tuple i goes to rank owner(i); those that come are put rank after rank. Collective.
  template <typename Owner>
  void ToOwners(std::size_t count, const Owner& owner)
  {
    this->Ranks.Together(this->Context,
      [&]
      {
        this->Out.assign(this->Ranks.GetCount(), Tuples());
        for (std::size_t i = 0; i < count; ++i)
        {
          this->Out[owner(i)].push_back(static_cast<ahd::Index>(i));
          if (i % kAsk == 0)
          {
            this->Context.StopIfAborted();
          }
        }
      });
    this->TellCounts();
  }

  /// Asks ranks for tuples: those that are called wanted[k] on rank owners[k] come to place k.
  /// `names`: what this rank's tuples are called, ascending. Collective. REQUIRES: all are there.
  void Ask(const std::vector<std::int64_t>& wanted, const std::vector<std::size_t>& owners,
    const std::vector<std::int64_t>& names);

  /// How many tuples come.
  std::size_t GetCount() const { return this->Arrivals; }

  /// Tuple k of those that come, in the order of the ranks, is to be put at places[k]: all of them
  /// once.
  void SetPlaces(std::vector<ahd::Index>&& places) { this->Places = std::move(places); }

  /// Moves tuples of `width` bytes each, that of place 0 to `to`. Both may be null where there are
  /// none. Collective.
  void Move(const void* from, std::size_t width, void* to);

  /// Moves the tuples of an array behind the first `first` ones of `to`, which has the same type
  /// and is large enough. `from` may be `to`. Collective; all ranks have arrays of the same type.
  void Move(vtkAbstractArray* from, vtkAbstractArray* to, std::size_t first);

  /// Can arrays of this type be moved?
  static bool CanMove(vtkAbstractArray* array);

private:
  using Tuples = std::vector<ahd::Index>;
  using Messages = std::vector<ahd::BlockMessage>;
  static constexpr std::size_t kAsk = std::size_t(1) << 14; // tuples between two askings

  void TellCounts();
  void Send(Messages& out, Messages& in);
  void MoveStrings(vtkAbstractArray* from, vtkAbstractArray* to, std::size_t first);
  template <typename Work>
  void ForArrivals(const Messages& in, const Work& work) const;

  vtkAHDRanks& Ranks;
  const vtkAHDContext& Context;
  std::vector<Tuples> Out;          // of each rank, ascending
  std::vector<std::size_t> FirstOf; // of each rank, the first of its arrivals
  std::vector<ahd::Index> Places;   // of arrivals; empty: k is put at k
  std::size_t Arrivals = 0;
};

#endif
