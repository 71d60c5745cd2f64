// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRoute.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <type_traits>

namespace
{
/// The array, tuple after tuple in memory, converted if it must be; bits become bytes.
vtkSmartPointer<vtkDataArray> InMemory(vtkAbstractArray* array)
{
  vtkSmartPointer<vtkDataArray> data = vtkArrayDownCast<vtkDataArray>(array);
  const bool areBits = data->GetDataType() == VTK_BIT;
  if (data->HasStandardMemoryLayout() && !areBits)
  {
    return data;
  }
  vtkSmartPointer<vtkDataArray> copy;
  copy.TakeReference(
    vtkDataArray::CreateDataArray(areBits ? VTK_UNSIGNED_CHAR : data->GetDataType()));
  copy->DeepCopy(data);
  return copy;
}

std::size_t WidthOf(vtkDataArray* array)
{
  return static_cast<std::size_t>(array->GetNumberOfComponents()) *
    static_cast<std::size_t>(array->GetDataTypeSize());
}

unsigned char* BytesOf(vtkDataArray* array, std::size_t tuple)
{
  return static_cast<unsigned char*>(array->GetVoidPointer(0)) + tuple * WidthOf(array);
}

using Index = ahd::Index;
using Bytes = unsigned char;

/// Calls work(width), for usual widths with a constant, so that a tuple is copied by one or two
/// instructions.
template <typename Work>
void WithWidth(std::size_t width, const Work& work)
{
  using std::integral_constant;
  switch (width)
  {
    case 1:
      return work(integral_constant<std::size_t, 1>());
    case 2:
      return work(integral_constant<std::size_t, 2>());
    case 4:
      return work(integral_constant<std::size_t, 4>());
    case 8:
      return work(integral_constant<std::size_t, 8>());
    case 12:
      return work(integral_constant<std::size_t, 12>());
    case 16:
      return work(integral_constant<std::size_t, 16>());
    case 24:
      return work(integral_constant<std::size_t, 24>());
    default:
      return work(width);
  }
}

/// Tuple numbers[k] of `from` becomes tuple k of `to`.
void Gather(const void* from, const Index* numbers, std::size_t count, std::size_t width, Bytes* to)
{
  const auto* const tuples = static_cast<const Bytes*>(from);
  const auto isGap = [](Index a, Index b) { return b != a + 1; };
  if (count > 0 && std::adjacent_find(numbers, numbers + count, isGap) == numbers + count)
  {
    std::memcpy(to, tuples + numbers[0] * width, count * width);
    return;
  }
  WithWidth(width,
    [&](auto known)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        std::memcpy(to + k * known, tuples + numbers[k] * known, known);
      }
    });
}

/// Tuple k of `from` becomes tuple numbers[k] of `to`.
void Scatter(
  const Bytes* from, const Index* numbers, std::size_t count, std::size_t width, void* to)
{
  auto* const tuples = static_cast<Bytes*>(to);
  WithWidth(width,
    [&](auto known)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        std::memcpy(tuples + numbers[k] * known, from + k * known, known);
      }
    });
}
}

/// Lists the tuples of each owner.
void vtkAHDRoute::List(const ahd::Buffer<std::uint32_t>& owners)
{
  std::vector<std::size_t> counts(this->Ranks.GetCount());
  this->Out.assign(this->Ranks.GetCount(), Tuples());
  const auto forAll = [&](const auto& work)
  {
    for (std::size_t i = 0; i < owners.size(); ++i)
    {
      if (i % kAsk == 0)
      {
        this->Context.StopIfAborted();
      }
      work(i);
    }
  };
  forAll([&](std::size_t i) { ++counts[owners[i]]; });
  for (std::size_t rank = 0; rank < counts.size(); ++rank)
  {
    this->Out[rank].reserve(counts[rank]);
  }
  forAll([&](std::size_t i) { this->Out[owners[i]].push_back(static_cast<ahd::Index>(i)); });
}

/// Tells each rank how many tuples it gets from this one.
void vtkAHDRoute::TellCounts()
{
  Messages out, in;
  this->Ranks.Together(this->Context,
    [&]
    {
      for (std::size_t rank = 0; rank < this->Out.size(); ++rank)
      {
        if (!this->Out[rank].empty())
        {
          out.emplace_back();
          out.back().block = rank;
          ahd::BytesWriter(out.back().bytes).write(std::uint64_t(this->Out[rank].size()));
        }
      }
    });
  this->Send(out, in);
  this->Ranks.Together(this->Context,
    [&]
    {
      std::vector<std::size_t> counts(this->Ranks.GetCount(), 0);
      for (const ahd::BlockMessage& message : in)
      {
        ahd::BytesReader reader(message.bytes);
        counts[message.block] = static_cast<std::size_t>(reader.read<std::uint64_t>());
      }
      this->FirstOf.clear();
      this->Arrivals = 0;
      for (const std::size_t count : counts)
      {
        this->FirstOf.push_back(this->Arrivals);
        this->Arrivals += count;
      }
    });
}

void vtkAHDRoute::Send(Messages& out, Messages& in)
{
  this->Context.Check(this->Ranks.exchange(out, in));
}

void vtkAHDRoute::Ask(const std::vector<std::int64_t>& wanted,
  const std::vector<std::size_t>& owners, const std::vector<std::int64_t>& names)
{
  Messages out, in;
  this->Ranks.Together(this->Context,
    [&]
    {
      std::vector<std::vector<std::int64_t>> of(this->Ranks.GetCount());
      std::vector<Tuples> places(this->Ranks.GetCount());
      for (std::size_t k = 0; k < wanted.size(); ++k)
      {
        of[owners[k]].push_back(wanted[k]);
        places[owners[k]].push_back(static_cast<ahd::Index>(k));
      }
      this->Places.clear();
      this->Places.reserve(wanted.size());
      for (std::size_t rank = 0; rank < of.size(); ++rank)
      {
        this->Places.insert(this->Places.end(), places[rank].begin(), places[rank].end());
        if (!of[rank].empty())
        {
          out.emplace_back();
          out.back().block = rank;
          ahd::BytesWriter(out.back().bytes).writeAll(of[rank]);
        }
      }
    });
  this->Send(out, in);
  this->Ranks.Together(this->Context,
    [&]
    {
      this->Out.assign(this->Ranks.GetCount(), Tuples());
      for (const ahd::BlockMessage& message : in)
      {
        std::vector<std::int64_t> ids;
        ahd::BytesReader(message.bytes).readAll(ids);
        for (const std::int64_t id : ids)
        {
          const auto found = std::lower_bound(names.begin(), names.end(), id);
          this->Out[message.block].push_back(static_cast<ahd::Index>(found - names.begin()));
        }
      }
    });
  this->TellCounts();
}

/// Calls work(message, k, place): tuple k of a message is to be put at the place.
template <typename Work>
void vtkAHDRoute::ForArrivals(const Messages& in, const Work& work) const
{
  for (const ahd::BlockMessage& message : in)
  {
    const std::size_t first = this->FirstOf[message.block];
    const std::size_t count = this->CountFrom(message.block);
    for (std::size_t k = 0; k < count; ++k)
    {
      if (k % kAsk == 0)
      {
        this->Context.StopIfAborted();
      }
      work(message, k, this->Places.empty() ? first + k : std::size_t(this->Places[first + k]));
    }
  }
}

/// How many tuples come from a rank.
std::size_t vtkAHDRoute::CountFrom(std::size_t rank) const
{
  const std::size_t end = rank + 1 < this->FirstOf.size() ? this->FirstOf[rank + 1]
                                                          : this->Arrivals;
  return end - this->FirstOf[rank];
}

/// Calls work(begin, end) for stretches of [0, count), and asks between them whether to abort;
/// where that is so, or observers run out of memory, the rest is left out. Nothing is done unless
/// `status` is Ok. Throws nothing.
template <typename Work>
void vtkAHDRoute::Try(std::size_t count, ahd::Status& status, const Work& work) const
{
  try
  {
    for (std::size_t begin = 0; begin < count && status == ahd::Status::Ok; begin += kAsk)
    {
      this->Context.StopIfAborted();
      work(begin, std::min(count, begin + kAsk));
    }
  }
  catch (const vtkAHDStop& stop)
  {
    status = stop.Reason;
  }
  catch (const std::bad_alloc&)
  {
    status = ahd::Status::OutOfMemory;
  }
}

/// Moves tuples, packed by pack(), to `to`. Ranks go on sending where one cannot go on, as others
/// wait for it: they agree on it in the end.
void vtkAHDRoute::Carry(std::size_t width, void* to, const Pack& pack)
{
  ahd::Buffer<unsigned char> out, in;
  const std::size_t most = std::max<std::size_t>(1, kPiece / width);
  ahd::Status status = ahd::Status::Ok;
  this->Ranks.Together(this->Context,
    [&]
    {
      out.allocate(most * width);
      in.allocate(most * width);
    });
  for (std::size_t round = 0; round < this->Ranks.GetCount(); ++round)
  {
    const std::size_t partner = this->Ranks.GetPartner(round);
    const bool isOwn = partner == this->Ranks.GetOwn();
    const Tuples& tuples = this->Out[partner];
    const std::size_t count = tuples.size(), coming = this->CountFrom(partner);
    for (std::size_t done = 0; done < std::max(count, coming); done += most)
    {
      const std::size_t going = std::min(most, count - std::min(count, done));
      const std::size_t arriving = std::min(most, coming - std::min(coming, done));
      const std::size_t first = this->FirstOf[partner] + done;
      const bool isInOrder = this->Places.empty() && arriving > 0;
      unsigned char* const end = isInOrder ? static_cast<unsigned char*>(to) + first * width
                                           : in.data();
      unsigned char* const packed = isOwn ? end : out.data();
      this->Try(going, status,
        [&](std::size_t k, std::size_t last)
        { pack(tuples.data() + done + k, last - k, packed + k * width); });
      if (!isOwn)
      {
        this->Ranks.Swap(partner, packed, going * width, end, arriving * width);
      }
      this->Try(isInOrder ? 0 : arriving, status,
        [&](std::size_t k, std::size_t last)
        { Scatter(end + k * width, this->Places.data() + first + k, last - k, width, to); });
    }
  }
  this->Context.Check(this->Ranks.agree(status));
}

void vtkAHDRoute::Move(const void* from, std::size_t width, void* to)
{
  this->Carry(width, to,
    [from, width](const ahd::Index* tuples, std::size_t count, unsigned char* bytes)
    { Gather(from, tuples, count, width, bytes); });
}

bool vtkAHDRoute::CanMove(vtkAbstractArray* array)
{
  return vtkArrayDownCast<vtkDataArray>(array) || vtkArrayDownCast<vtkStringArray>(array);
}

void vtkAHDRoute::Move(vtkAbstractArray* from, vtkAbstractArray* to, std::size_t first)
{
  if (vtkArrayDownCast<vtkStringArray>(to))
  {
    this->MoveStrings(from, to, first);
    return;
  }
  vtkSmartPointer<vtkDataArray> source, target;
  this->Ranks.Together(this->Context,
    [&]
    {
      source = InMemory(from);
      target = InMemory(to);
    });
  this->Move(BytesOf(source, 0), WidthOf(source), BytesOf(target, first));
  if (target != to) // bits
  {
    auto* bits = vtkArrayDownCast<vtkDataArray>(to);
    const auto end = static_cast<vtkIdType>(first + this->Arrivals);
    for (auto i = static_cast<vtkIdType>(first); i < end; ++i)
    {
      for (int c = 0; c < to->GetNumberOfComponents(); ++c)
      {
        bits->SetComponent(i, c, target->GetComponent(i, c));
      }
    }
  }
}

void vtkAHDRoute::MoveStrings(vtkAbstractArray* from, vtkAbstractArray* to, std::size_t first)
{
  Messages out, in;
  auto* strings = vtkArrayDownCast<vtkStringArray>(from);
  auto* moved = vtkArrayDownCast<vtkStringArray>(to);
  const auto width = static_cast<vtkIdType>(to->GetNumberOfComponents());
  this->Ranks.Together(this->Context,
    [&]
    {
      for (std::size_t rank = 0; rank < this->Out.size(); ++rank)
      {
        if (this->Out[rank].empty())
        {
          continue;
        }
        out.emplace_back();
        out.back().block = rank;
        ahd::BytesWriter writer(out.back().bytes);
        for (const ahd::Index tuple : this->Out[rank])
        {
          for (vtkIdType c = 0; c < width; ++c)
          {
            const std::string text = strings->GetValue(vtkIdType(tuple) * width + c);
            writer.write(std::uint64_t(text.size()));
            writer.write(text.data(), text.size());
          }
        }
      }
    });
  this->Send(out, in);
  this->Ranks.Together(this->Context,
    [&]
    {
      std::size_t at = 0;
      this->ForArrivals(in,
        [&](const ahd::BlockMessage& message, std::size_t k, std::size_t place)
        {
          at = k == 0 ? 0 : at;
          for (vtkIdType c = 0; c < width; ++c)
          {
            std::uint64_t size = 0;
            std::memcpy(&size, message.bytes.data() + at, sizeof(size));
            at += sizeof(size);
            const auto* text = reinterpret_cast<const char*>(message.bytes.data() + at);
            moved->SetValue(vtkIdType(first + place) * width + c,
              std::string(text, static_cast<std::size_t>(size)));
            at += static_cast<std::size_t>(size);
          }
        });
    });
}
