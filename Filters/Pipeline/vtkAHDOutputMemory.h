// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDOutputMemory_h
#define vtkAHDOutputMemory_h

#include "Engine/Core/Buffer.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <memory>

/**
 * Memory of large output arrays: when the last owner releases such an array, its memory is kept for
 * an array of the next execution, which then need not get pages from the system.
 *
 * Arrays may outlive this object and be released by any thread. All else is for one thread at a
 * time. Functions that allocate throw std::bad_alloc, after they have freed the kept memory.
 */
class vtkAHDOutputMemory
{
public:
  /// Keeps nothing until KeepAtMost() sets a limit.
  vtkAHDOutputMemory();
  ~vtkAHDOutputMemory();
  vtkAHDOutputMemory(const vtkAHDOutputMemory&) = delete;
  vtkAHDOutputMemory& operator=(const vtkAHDOutputMemory&) = delete;

  /// The bytes allocated for so many, at most a sixteenth more: the next array may be a little
  /// larger. Unwritten pages take no memory.
  static std::size_t GetCapacity(std::size_t bytes);

  /// A VTK array of `count` numbers, one component, not initialised.
  template <typename Array>
  vtkSmartPointer<Array> NewArray(vtkIdType count)
  {
    auto memory = this->Take<typename Array::ValueType>(static_cast<std::size_t>(count));
    return this->MakeArray<Array>(memory, count);
  }

  /// Memory for `count` elements or more, to fill and pass to MakeArray().
  template <typename Element>
  ahd::Buffer<Element> Take(std::size_t count)
  {
    ahd::Scratch taken = this->TakeBytes(count, sizeof(Element));
    const std::size_t bytes = taken.bytes();
    return ahd::Buffer<Element>::owner(taken.release(), bytes);
  }

  /// The buffer's memory, which has `count` numbers, as a VTK array of one component. The buffer is
  /// empty then.
  template <typename Array, typename Element>
  vtkSmartPointer<Array> MakeArray(ahd::Buffer<Element>& from, vtkIdType count)
  {
    using Value = typename Array::ValueType;
    auto array = vtkSmartPointer<Array>::New();
    this->Expect(from.data(), from.bytes());
    array->SetArray(
      reinterpret_cast<Value*>(from.release()), count, 0, Array::VTK_DATA_ARRAY_USER_DEFINED);
    array->SetArrayFreeFunction(Free);
    return array;
  }

  /// Limits the bytes that are kept. Frees the memory kept so far, which the execution that ends
  /// with this call did not use.
  void KeepAtMost(std::size_t bytes);

  /// Bytes that are kept, without those of arrays.
  std::size_t GetBytes() const;

  /// Frees all kept memory.
  void Release();

private:
  struct Store;
  struct Origins;

  ahd::Scratch TakeBytes(std::size_t count, std::size_t size);
  void Expect(void* memory, std::size_t bytes);
  static void Free(void* memory);

  const std::shared_ptr<Store> Kept;
};

#endif
