// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRoute.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstring>
#include <string>

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
}

/// Tells each rank how many tuples it gets from this one.
void vtkAHDRoute::TellCounts()
{
  ahd::BlockBytes own;
  std::vector<ahd::BlockBytes> all;
  this->Ranks.Together(this->Context,
    [&]
    {
      ahd::BytesWriter writer(own);
      for (const Tuples& tuples : this->Out)
      {
        writer.write(std::uint64_t(tuples.size()));
      }
    });
  this->Context.Check(this->Ranks.gather(own, all));
  this->Ranks.Together(this->Context,
    [&]
    {
      this->FirstOf.clear();
      this->Arrivals = 0;
      for (const ahd::BlockBytes& bytes : all)
      {
        ahd::BytesReader reader(bytes);
        std::uint64_t count = 0;
        for (std::size_t k = 0; k <= this->Ranks.GetOwn(); ++k)
        {
          count = reader.read<std::uint64_t>();
        }
        this->FirstOf.push_back(this->Arrivals);
        this->Arrivals += static_cast<std::size_t>(count);
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
    const std::size_t end = message.block + 1 < this->FirstOf.size()
      ? this->FirstOf[message.block + 1]
      : this->Arrivals;
    for (std::size_t k = 0; k < end - first; ++k)
    {
      if (k % kAsk == 0)
      {
        this->Context.StopIfAborted();
      }
      work(message, k, this->Places.empty() ? first + k : std::size_t(this->Places[first + k]));
    }
  }
}

void vtkAHDRoute::Move(const void* from, std::size_t width, void* to)
{
  Messages out, in;
  this->Ranks.Together(this->Context,
    [&]
    {
      for (std::size_t rank = 0; rank < this->Out.size(); ++rank)
      {
        const Tuples& tuples = this->Out[rank];
        if (tuples.empty())
        {
          continue;
        }
        out.emplace_back();
        out.back().block = rank;
        out.back().bytes.resize(tuples.size() * width);
        unsigned char* bytes = out.back().bytes.data();
        const auto* tuple = static_cast<const unsigned char*>(from);
        this->Context.ForRange(tuples.size(),
          [&tuples, bytes, tuple, width](std::size_t begin, std::size_t end)
          {
            for (std::size_t k = begin; k < end; ++k)
            {
              std::memcpy(bytes + k * width, tuple + tuples[k] * width, width);
            }
          });
      }
    });
  this->Send(out, in);
  this->Ranks.Together(this->Context,
    [&]
    {
      this->ForArrivals(in,
        [to, width](const ahd::BlockMessage& message, std::size_t k, std::size_t place)
        {
          std::memcpy(static_cast<unsigned char*>(to) + place * width,
            message.bytes.data() + k * width, width);
        });
    });
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
