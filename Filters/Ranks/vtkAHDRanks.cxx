// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRanks.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>

namespace
{
constexpr int kTag = 87931; // of messages between two ranks
/// The most bytes in one gathering on each rank: MPI counts with int.
constexpr std::size_t kPiece = std::size_t(1) << 28;
}

vtkAHDRanks::vtkAHDRanks(vtkMultiProcessController* controller)
  : Controller(controller)
  , Own(static_cast<std::size_t>(controller->GetLocalProcessId()))
  , Count(static_cast<std::size_t>(controller->GetNumberOfProcesses()))
{
}

/// The largest of all. Statuses are twice their number, so that who asks IsAny() hears of them.
int vtkAHDRanks::Reduce(int own)
{
  int all = own;
  this->Controller->AllReduce(&own, &all, 1, vtkCommunicator::MAX_OP);
  this->Agreed = static_cast<ahd::Status>(all / 2);
  return all;
}

ahd::Status vtkAHDRanks::agree(ahd::Status own)
{
  this->Reduce(2 * static_cast<int>(own));
  return this->Agreed;
}

bool vtkAHDRanks::IsAny(bool own)
{
  const bool isAny = this->Reduce(own ? 1 : 0) == 1;
  if (this->Agreed != ahd::Status::Ok)
  {
    throw vtkAHDStop{ this->Agreed };
  }
  return isAny;
}

int vtkAHDRanks::FindMost(int own)
{
  this->IsAny(false); // may all go on?
  int most = own;
  this->Controller->AllReduce(&own, &most, 1, vtkCommunicator::MAX_OP);
  return most;
}

ahd::Status vtkAHDRanks::gather(const ahd::BlockBytes& own, std::vector<ahd::BlockBytes>& all)
{
  std::vector<vtkIdType> sizes, lengths, offsets;
  ahd::BlockBytes piece;
  const vtkIdType size = static_cast<vtkIdType>(own.size());
  const std::size_t most = std::max<std::size_t>(1, kPiece / this->Count);
  ahd::Status status = this->agree(ahd::withoutThrowing(
    [&]
    {
      sizes.resize(this->Count);
      lengths.resize(this->Count);
      offsets.resize(this->Count);
      all.assign(this->Count, ahd::BlockBytes());
      return ahd::Status::Ok;
    }));
  if (status != ahd::Status::Ok)
  {
    return status;
  }
  this->Controller->AllGather(&size, sizes.data(), 1);
  const auto longest = static_cast<std::size_t>(*std::max_element(sizes.begin(), sizes.end()));
  status = this->agree(ahd::withoutThrowing(
    [&]
    {
      piece.resize(std::min(most, longest) * this->Count + 1);
      for (std::size_t k = 0; k < this->Count; ++k)
      {
        all[k].reserve(static_cast<std::size_t>(sizes[k]));
      }
      return ahd::Status::Ok;
    }));
  for (std::size_t begin = 0; status == ahd::Status::Ok && begin < longest; begin += most)
  {
    vtkIdType offset = 0;
    for (std::size_t k = 0; k < this->Count; ++k)
    {
      const std::size_t of = static_cast<std::size_t>(sizes[k]);
      lengths[k] = static_cast<vtkIdType>(std::min(most, of - std::min(of, begin)));
      offsets[k] = offset;
      offset += lengths[k];
    }
    this->Controller->AllGatherV(own.data() + std::min(own.size(), begin), piece.data(),
      lengths[this->Own], lengths.data(), offsets.data());
    for (std::size_t k = 0; k < this->Count; ++k)
    {
      all[k].insert(
        all[k].end(), piece.data() + offsets[k], piece.data() + offsets[k] + lengths[k]);
    }
  }
  return status;
}

/// Calls work(partner) for all other ranks, in an order in which none waits in a ring.
template <typename Work>
void vtkAHDRanks::ForPartners(const Work& work)
{
  for (std::size_t round = 0; round < this->Count; ++round)
  {
    const std::size_t partner = ahd::partnerOf(this->Own, this->Count, round);
    if (partner != this->Own)
    {
      work(partner);
    }
  }
}

/// The lower rank of two sends first, and each has one partner at a time: so none waits in a ring.
/// VTK divides what is longer than MPI can count with int.
void vtkAHDRanks::swap(
  std::size_t partner, const void* out, std::size_t outBytes, void* in, std::size_t inBytes)
{
  const int rank = static_cast<int>(partner);
  const bool isFirst = this->Own < partner;
  for (const bool sends : { isFirst, !isFirst })
  {
    if (sends && outBytes > 0)
    {
      this->Controller->Send(
        static_cast<const unsigned char*>(out), static_cast<vtkIdType>(outBytes), rank, kTag);
    }
    if (!sends && inBytes > 0)
    {
      this->Controller->Receive(
        static_cast<unsigned char*>(in), static_cast<vtkIdType>(inBytes), rank, kTag);
    }
  }
}

ahd::Status vtkAHDRanks::exchange(
  std::vector<ahd::BlockMessage>& out, std::vector<ahd::BlockMessage>& in)
{
  std::vector<const ahd::BlockBytes*> to;
  std::vector<ahd::BlockBytes*> from;
  std::vector<vtkTypeUInt64> own, sizes;
  const ahd::BlockBytes nothing;
  ahd::BlockBytes none;
  ahd::Status status = this->agree(ahd::withoutThrowing(
    [&]
    {
      to.assign(this->Count, &nothing);
      from.assign(this->Count, &none);
      own.resize(this->Count);
      sizes.resize(this->Count);
      in.clear();
      in.reserve(this->Count);
      return ahd::Status::Ok;
    }));
  if (status != ahd::Status::Ok)
  {
    return status;
  }
  for (const ahd::BlockMessage& message : out)
  {
    to[message.block] = &message.bytes;
  }
  for (std::size_t k = 0; k < this->Count; ++k)
  {
    own[k] = to[k]->size();
  }
  sizes[this->Own] = own[this->Own];
  this->ForPartners([&](std::size_t partner)
    { this->swap(partner, &own[partner], sizeof(own[0]), &sizes[partner], sizeof(sizes[0])); });
  status = this->agree(ahd::withoutThrowing(
    [&]
    {
      for (std::size_t k = 0; k < this->Count; ++k)
      {
        if (sizes[k] > 0)
        {
          in.emplace_back();
          in.back().block = k;
          from[k] = &in.back().bytes;
          in.back().bytes.resize(k == this->Own ? 0 : static_cast<std::size_t>(sizes[k]));
        }
      }
      return ahd::Status::Ok;
    }));
  if (status == ahd::Status::Ok)
  {
    this->ForPartners(
      [&](std::size_t partner)
      {
        this->swap(partner, to[partner]->data(), to[partner]->size(), from[partner]->data(),
          from[partner]->size());
      });
  }
  for (ahd::BlockMessage& message : out)
  {
    if (status == ahd::Status::Ok && message.block == this->Own && sizes[this->Own] > 0)
    {
      from[this->Own]->swap(message.bytes);
    }
  }
  out.clear();
  return status;
}
