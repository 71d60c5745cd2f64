// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRoute_h
#define vtkAHDRoute_h

#include "Engine/Core/Buffer.h"
#include "Engine/Points/Points.h"
#include "Ranks/vtkAHDRanks.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <utility>
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
  /// `owner` throws nothing, and is called by several threads.
  template <typename Owner>
  void ToOwners(std::size_t count, const Owner& owner)
  {
    this->Ranks.Together(this->Context,
      [&]
      {
        ahd::Buffer<std::uint32_t> owners;
        owners.allocate(count);
        this->Context.ForRange(count,
          [&owners, &owner](std::size_t begin, std::size_t end)
          {
            for (std::size_t i = begin; i < end; ++i)
            {
              owners[i] = static_cast<std::uint32_t>(owner(i));
            }
          });
        this->List(owners);
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
  /// none. Collective, as all below.
  void Move(const void* from, std::size_t width, void* to);

  /// Puts valueOf(i) of each tuple i where it goes; throws nothing.
  template <typename Value, typename ValueOf>
  void MoveValues(const ValueOf& valueOf, Value* to)
  {
    this->Carry(sizeof(Value), to,
      [&valueOf](const ahd::Index* tuples, std::size_t count, unsigned char* bytes)
      {
        for (std::size_t k = 0; k < count; ++k)
        {
          const Value value = valueOf(tuples[k]);
          std::memcpy(bytes + k * sizeof(Value), &value, sizeof(Value));
        }
      });
  }

  /// Moves the tuples of an array behind the first `first` ones of `to`, which has the same type
  /// and is large enough. `from` may be `to`. All ranks have arrays of the same type.
  void Move(vtkAbstractArray* from, vtkAbstractArray* to, std::size_t first);

  /// Upper estimate of the bytes that the way of so many tuples takes, and moving others than
  /// strings along it.
  static std::size_t EstimateBytes(std::size_t count)
  {
    return 2 * kPiece + (sizeof(ahd::Index) + sizeof(std::uint32_t)) * count;
  }

  /// Can arrays of this type be moved?
  static bool CanMove(vtkAbstractArray* array);

private:
  using Tuples = std::vector<ahd::Index>;
  using Messages = std::vector<ahd::BlockMessage>;
  /// Writes the tuples of these numbers, one after the other.
  using Pack = std::function<void(const ahd::Index*, std::size_t, unsigned char*)>;
  static constexpr std::size_t kAsk = std::size_t(1) << 14; // tuples between two askings
  /// Tuples move in pieces of so many bytes: they stay in the cache between packing and sending,
  /// and a rank holds two of them.
  static constexpr std::size_t kPiece = std::size_t(1) << 21;

  void List(const ahd::Buffer<std::uint32_t>& owners);
  void TellCounts();
  std::size_t CountFrom(std::size_t rank) const;
  template <typename Work>
  void Try(std::size_t count, ahd::Status& status, const Work& work) const;
  void Carry(std::size_t width, void* to, const Pack& pack);
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
