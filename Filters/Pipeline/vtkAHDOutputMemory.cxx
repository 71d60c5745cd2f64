// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkAHDOutputMemory.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <new>
#include <unordered_map>
#include <utility>

namespace
{
constexpr std::size_t kLeast = std::size_t(1) << 16; ///< smaller arrays are not worth keeping
}

/// The kept memory. Shared with the arrays whose memory comes back.
struct vtkAHDOutputMemory::Store
{
  std::mutex Mutex;                                // of all below
  std::multimap<std::size_t, ahd::Scratch> Memory; ///< by its bytes
  std::size_t Bytes = 0;
  std::size_t Limit = 0;

  void Put(ahd::Scratch memory)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const std::size_t bytes = memory.bytes();
    if (bytes <= this->Limit - std::min(this->Limit, this->Bytes))
    {
      this->Memory.emplace(bytes, std::move(memory));
      this->Bytes += bytes;
    }
  }

  /// The least that is enough and not much too large; empty if there is none.
  ahd::Scratch Take(std::size_t bytes)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto found = this->Memory.lower_bound(bytes);
    if (found == this->Memory.end() || found->first - bytes > bytes / 2)
    {
      return {};
    }
    ahd::Scratch taken = std::move(found->second);
    this->Memory.erase(found);
    this->Bytes -= taken.bytes();
    return taken;
  }

  void Drop()
  {
    this->Memory.clear();
    this->Bytes = 0;
  }
};

/// Whose memory the arrays have: VTK tells a free function the address only. One for the process,
/// and never gone, as arrays may be freed at its very end.
struct vtkAHDOutputMemory::Origins
{
  struct Origin
  {
    std::weak_ptr<Store> Kept;
    std::size_t Bytes = 0;
  };

  std::mutex Mutex; // of the members below
  std::unordered_map<void*, Origin> Of;

  static Origins& Get()
  {
    static auto* const origins = new Origins;
    return *origins;
  }

  Origin Remove(void* memory)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto found = this->Of.find(memory);
    Origin origin;
    if (found != this->Of.end())
    {
      origin = std::move(found->second);
      this->Of.erase(found);
    }
    return origin;
  }
};

vtkAHDOutputMemory::vtkAHDOutputMemory()
  : Kept(std::make_shared<Store>())
{
}

vtkAHDOutputMemory::~vtkAHDOutputMemory() = default;

std::size_t vtkAHDOutputMemory::GetCapacity(std::size_t bytes)
{
  std::size_t step = 64; // a cache line
  while (bytes / 32 >= step)
  {
    step *= 2;
  }
  return std::max<std::size_t>(1, (bytes + step - 1) / step) * step;
}

ahd::Scratch vtkAHDOutputMemory::TakeBytes(std::size_t count, std::size_t size)
{
  if (count > (std::size_t(-1) / 2) / size)
  {
    throw std::bad_alloc();
  }
  const std::size_t bytes = GetCapacity(count * size);
  ahd::Scratch taken = this->Kept->Take(count * size);
  if (taken.empty())
  {
    try
    {
      taken.allocate(bytes);
    }
    catch (const std::bad_alloc&)
    {
      this->Release();
      taken.allocate(bytes);
    }
  }
  return taken;
}

void vtkAHDOutputMemory::Expect(void* memory, std::size_t bytes)
{
  if (bytes >= kLeast)
  {
    Origins& origins = Origins::Get();
    const std::lock_guard<std::mutex> lock(origins.Mutex);
    origins.Of[memory] = { this->Kept, bytes };
  }
}

void vtkAHDOutputMemory::Free(void* memory)
{
  const Origins::Origin origin = Origins::Get().Remove(memory);
  const std::shared_ptr<Store> kept = origin.Kept.lock();
  if (!kept)
  {
    ahd::Scratch::free(memory);
    return;
  }
  try
  {
    kept->Put(ahd::Scratch::owner(memory, origin.Bytes));
  }
  catch (const std::bad_alloc&)
  {
    // it was freed
  }
}

void vtkAHDOutputMemory::KeepAtMost(std::size_t bytes)
{
  const std::lock_guard<std::mutex> lock(this->Kept->Mutex);
  this->Kept->Limit = bytes;
  this->Kept->Drop();
}

std::size_t vtkAHDOutputMemory::GetBytes() const
{
  const std::lock_guard<std::mutex> lock(this->Kept->Mutex);
  return this->Kept->Bytes;
}

void vtkAHDOutputMemory::Release()
{
  const std::lock_guard<std::mutex> lock(this->Kept->Mutex);
  this->Kept->Drop();
}
