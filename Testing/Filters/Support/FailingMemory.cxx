// SPDX-License-Identifier: BSD-3-Clause
#include "FailingMemory.h"

#include "OwnNew.h"

#include <atomic>
#include <cstdint>
#include <cstring>

#include <dlfcn.h>
#include <link.h>
#include <unwind.h>

extern "C" void* __libc_malloc(std::size_t);

namespace
{

std::atomic<bool> watching{ false };
std::atomic<std::size_t> asked{ 0 };
std::atomic<std::size_t> failAt{ 0 };
std::atomic<bool> andLater{ false };
std::atomic<bool> countsVtk{ false };
std::atomic<std::ptrdiff_t> inUse{ 0 };

/// The address range of the filter's library.
struct Code
{
  std::uintptr_t begin = 0;
  std::uintptr_t end = 0;
};
Code filterCode;

bool isFilters(const void* address)
{
  const auto place = reinterpret_cast<std::uintptr_t>(address);
  return place >= filterCode.begin && place < filterCode.end;
}

int findCode(dl_phdr_info* info, std::size_t, void*)
{
  if (std::strstr(info->dlpi_name, "AdaptiveHilbertDelaunayFilters"))
  {
    for (int i = 0; i < info->dlpi_phnum; ++i)
    {
      const auto& part = info->dlpi_phdr[i];
      if (part.p_type == PT_LOAD && (part.p_flags & PF_X) != 0)
      {
        filterCode.begin = info->dlpi_addr + part.p_vaddr;
        filterCode.end = filterCode.begin + part.p_memsz;
      }
    }
  }
  return 0;
}

enum class Owner : unsigned char
{
  Unknown, ///< not looked up yet
  Filter,
  Vtk,
  Other ///< the standard library, whose templates may be any library's copy, and this program
};

Owner findOwner(void* address)
{
  Dl_info info;
  const bool known = dladdr(address, &info) != 0;
  const char* name = known && info.dli_sname ? info.dli_sname : "";
  if (std::strncmp(name, "_ZNSt", 5) == 0 || std::strncmp(name, "_ZNKSt", 6) == 0)
  {
    return Owner::Other;
  }
  if (isFilters(address))
  {
    return Owner::Filter;
  }
  return known && info.dli_fname && std::strstr(info.dli_fname, "libvtk") ? Owner::Vtk
                                                                          : Owner::Other;
}

/// The same from a table, as looking it up takes long.
Owner ownerOf(void* address)
{
  struct Known
  {
    void* address = nullptr;
    Owner owner = Owner::Unknown;
  };
  static thread_local Known table[1024];
  Known& known = table[reinterpret_cast<std::uintptr_t>(address) / 2 % 1024];
  if (known.address != address)
  {
    known = { address, findOwner(address) };
  }
  return known.owner;
}

_Unwind_Reason_Code visitCaller(_Unwind_Context* context, void* found)
{
  const Owner owner = ownerOf(reinterpret_cast<void*>(_Unwind_GetIP(context)));
  if (owner == Owner::Other)
  {
    return _URC_NO_REASON;
  }
  *static_cast<Owner*>(found) = owner;
  return _URC_END_OF_STACK;
}

bool mustFail()
{
  static thread_local bool isLooking = false; // and that may take memory
  if (!watching || isLooking)
  {
    return false;
  }
  isLooking = true;
  Owner nearest = Owner::Unknown;
  _Unwind_Backtrace(visitCaller, &nearest);
  isLooking = false;
  if (nearest != Owner::Filter && !(countsVtk && nearest == Owner::Vtk))
  {
    return false;
  }
  const std::size_t number = ++asked;
  return failAt != 0 && (number == failAt || (andLater && number > failAt));
}

} // namespace

extern "C" void* malloc(std::size_t size)
{
  return isFilters(__builtin_return_address(0)) && mustFail() ? nullptr : __libc_malloc(size);
}

void* ahd::test::ownAllocate(std::size_t size, std::size_t alignment)
{
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  void* block = mustFail() ? nullptr : std::aligned_alloc(alignment, rounded);
  if (!block)
  {
    throw std::bad_alloc();
  }
  ++inUse;
  return block;
}

void ahd::test::ownRelease(void* block)
{
  inUse -= block != nullptr;
  std::free(block);
}

void ahdtest::memory::begin(std::size_t number, bool andAllLater, bool ofVtk)
{
  if (filterCode.end == 0)
  {
    dl_iterate_phdr(findCode, nullptr);
  }
  failAt = number;
  andLater = andAllLater;
  countsVtk = ofVtk;
  asked = 0;
  watching = true;
}

std::size_t ahdtest::memory::count()
{
  return asked;
}

std::size_t ahdtest::memory::end()
{
  watching = false;
  return asked;
}

std::ptrdiff_t ahdtest::memory::blocks()
{
  return inUse;
}
