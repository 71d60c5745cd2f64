// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkAHDArrayMemory.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <new>

/// What lies before the memory of an array.
struct vtkAHDArrayMemory::Block
{
  std::shared_ptr<Waiting> Owner;
  std::size_t Room;  ///< for an array
  std::size_t Bytes; ///< of the largest array that it was for: what is behind was never touched
  Block* Next;       ///< of those that wait
};

/// The blocks that wait, by any thread. Nothing here allocates: arrays are freed where nothing may
/// be thrown.
class vtkAHDArrayMemory::Waiting
{
public:
  /// Takes a block, or returns false.
  bool Take(Block* block)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->IsOpen)
    {
      block->Next = this->First;
      this->First = block;
      this->Bytes += block->Bytes;
    }
    return this->IsOpen;
  }

  /// The least block that `bytes` fit into; null if there is none of about that size.
  Block* Find(std::size_t bytes)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    Block** best = nullptr;
    for (Block** at = &this->First; *at; at = &(*at)->Next)
    {
      const std::size_t room = (*at)->Room;
      if (room >= bytes && room - bytes <= bytes / 8 && (!best || room < (*best)->Room))
      {
        best = at;
      }
    }
    return best ? this->Remove(best) : nullptr;
  }

  /// If there are more than `most` bytes, the least block without which there are not, or else the
  /// largest; null if there are no more.
  Block* FindBeyond(std::size_t most)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    Block** best = &this->First;
    const std::size_t excess = this->Bytes - std::min(this->Bytes, most);
    for (Block** at = &this->First; *at; at = &(*at)->Next)
    {
      const std::size_t has = (*at)->Bytes, before = (*best)->Bytes;
      if (before < excess ? has > before : has >= excess && has < before)
      {
        best = at;
      }
    }
    return excess > 0 ? this->Remove(best) : nullptr;
  }

  void SetOpen(bool open)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsOpen = open;
  }

  std::size_t GetBytes()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->Bytes;
  }

private:
  Block* Remove(Block** at)
  {
    Block* const block = *at;
    *at = block->Next;
    this->Bytes -= block->Bytes;
    return block;
  }

  std::mutex Mutex;
  Block* First = nullptr;
  std::size_t Bytes = 0;
  bool IsOpen = false;
};

namespace
{
constexpr std::size_t kHeader = 64;                 // a cache line
constexpr std::size_t kUnit = std::size_t(1) << 16; // of what is allocated
}

vtkAHDArrayMemory::vtkAHDArrayMemory()
  : Blocks(std::make_shared<Waiting>())
{
}

vtkAHDArrayMemory::~vtkAHDArrayMemory()
{
  this->Close();
}

void vtkAHDArrayMemory::Open()
{
  this->Blocks->SetOpen(true);
}

void vtkAHDArrayMemory::Close()
{
  this->Blocks->SetOpen(false);
  this->Shrink(0);
}

void vtkAHDArrayMemory::Shrink(std::size_t most)
{
  while (Block* const block = this->Blocks->FindBeyond(most))
  {
    block->~Block();
    std::free(block);
  }
}

std::size_t vtkAHDArrayMemory::GetBytes() const
{
  return this->Blocks->GetBytes();
}

void* vtkAHDArrayMemory::Allocate(std::size_t bytes)
{
  static_assert(sizeof(Block) <= kHeader, "a block's beginning has to fit before the array");
  Block* block = this->Blocks->Find(bytes);
  if (!block)
  {
    const std::size_t waiting = this->GetBytes();
    this->Shrink(waiting - std::min(waiting, bytes));
    // The next time there may be a few triangles more. What is beyond the end is never touched.
    const std::size_t room = (bytes + kHeader + kUnit - 1) / kUnit * kUnit;
    void* const memory = room > bytes ? std::malloc(room) : nullptr;
    if (!memory)
    {
      throw std::bad_alloc();
    }
    block = ::new (memory) Block{ this->Blocks, room - kHeader, bytes, nullptr };
  }
  block->Bytes = std::max(block->Bytes, bytes);
  return reinterpret_cast<unsigned char*>(block) + kHeader;
}

void vtkAHDArrayMemory::Free(void* memory)
{
  auto* const block = reinterpret_cast<Block*>(static_cast<unsigned char*>(memory) - kHeader);
  // held here, as the block may be the last that holds it
  const std::shared_ptr<Waiting> owner = block->Owner;
  if (!owner->Take(block))
  {
    block->~Block();
    std::free(block);
  }
}
